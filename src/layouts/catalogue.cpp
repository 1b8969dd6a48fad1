// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/catalogue.hpp"

#include <fmt/format.h>

#include "strainwave/core/units.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {

std::string catalogue_text(const CatalogueRows& rows) {
  const auto number = [](double value) { return fmt::format("{:g}", value); };
  const auto section = [](const char* title, const Table& table) {
    return title + (table.rows.empty() ? std::string("  no rows\n") : text_table(table));
  };
  Table stiffness{.head = {"size", "ratio", "T1", "T2", "K1", "K2", "K3", "sources"},
                  .align = "rrrrrrrl"};
  for (const StiffnessRow& row : rows.stiffness)
    stiffness.rows.push_back(cells(row.size, row.ratio_class, number(row.T1), number(row.T2),
                                   number(row.K1 / 1e4), number(row.K2 / 1e4),
                                   row.K3 ? number(*row.K3 / 1e4) : "-", row.sources));
  Table ratings{.head = {"series", "size", "ratio", "rated", "average", "peak", "momentary",
                         "max speed", "average", "inertia"},
                .align = "r"};
  for (const RatingRow& row : rows.ratings)
    ratings.rows.push_back(cells(row.series, row.size, row.ratio, number(row.rated),
                                 number(row.average), number(row.repeated_peak),
                                 number(row.momentary_peak),
                                 fmt::format("{:.0f}", row.max_input_speed / units::rpm),
                                 fmt::format("{:.0f}", row.average_input_speed / units::rpm),
                                 fmt::format("{:.3g}", row.input_inertia)));
  return section("Torsional stiffness, input locked: torque in N*m, K in 1e4 N*m/rad\n",
                 stiffness) +
         section(
             "\nRatings: torque in N*m, speed of the input with grease in rpm, inertia in "
             "kg*m^2\n",
             ratings) +
         "\nSources.  A: CSF/CSG catalogue of Harmonic Drive LLC, page 50.  B: engineering data "
         "1018854 of\n  Harmonic Drive AG, tables 54.3 and 54.4.  C and the ratings: data of "
         "Harmonic Drive SE, from\n  harmonic-drive-selector (Apache-2.0).\n";
}

std::string catalogue_csv(const CatalogueRows& rows) {
  Table table{.head = {"size", "ratio_class", "T1 [N*m]", "T2 [N*m]", "K1 [N*m/rad]",
                       "K2 [N*m/rad]", "K3 [N*m/rad]", "sources"}};
  for (const StiffnessRow& row : rows.stiffness)
    table.rows.push_back(
        cells(row.size, row.ratio_class, row.T1, row.T2, row.K1, row.K2, row.K3, row.sources));
  return csv_table(table);
}

}  // namespace strainwave
