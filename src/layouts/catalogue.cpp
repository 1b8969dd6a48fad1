// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/catalogue.hpp"

#include <fmt/format.h>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {

std::string catalogue_text(const CatalogueRows& rows) {
  const auto number = [](double value) { return fmt::format("{:g}", value); };
  const auto section = [](const std::string& title, const Table& table) {
    return title + (table.rows.empty() ? std::string("  no rows\n") : text_table(table));
  };
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit of_stiffness = display_unit({}, "N*m/rad", {"1e4 N*m/rad", 1e4});
  const DisplayUnit speed = display_unit({}, "rad/s", {"rpm", units::rpm});
  const DisplayUnit inertia = display_unit({}, "kg*m^2");
  const auto stated = [&](const std::optional<double>& K) {
    return K ? number(*K / of_stiffness.in_si) : std::string("-");
  };
  Table stiffness{
      .head = {"size", "ratio", "T1", "T2", "K1", "K2", "K3", "sources", "series", "form"},
      .align = "rrrrrrrlll"};
  for (const StiffnessRow& row : rows.stiffness)
    stiffness.rows.push_back(cells(
        row.size, row.origin == RowOrigin::catalogue ? cell(row.ratio_class) : cell(row.ratios[0]),
        number(row.T1 / torque.in_si), number(row.T2 / torque.in_si), stated(row.K1),
        stated(row.K2), stated(row.K3), row.sources, row.series,
        fmt::format("{} {}", enum_name(row.length), enum_name(row.form))));
  Table ratings{.head = {"series", "size", "ratio", "rated", "average", "peak", "momentary",
                         "max speed", "average", "inertia"},
                .align = "r"};
  for (const RatingRow& row : rows.ratings)
    ratings.rows.push_back(cells(row.series, row.size, row.ratio, number(row.rated / torque.in_si),
                                 number(row.average / torque.in_si),
                                 number(row.repeated_peak / torque.in_si),
                                 number(row.momentary_peak / torque.in_si),
                                 fmt::format("{:.0f}", row.max_input_speed / speed.in_si),
                                 fmt::format("{:.0f}", row.average_input_speed / speed.in_si),
                                 fmt::format("{:.3g}", row.input_inertia / inertia.in_si)));
  Table limits{.head = {"series", "size", "ratio", "ratcheting", "buckling"}, .align = "r"};
  for (const TorqueLimitRow& row : rows.limits)
    limits.rows.push_back(cells(row.series, row.size, row.ratio,
                                number(row.ratcheting / torque.in_si),
                                number(row.buckling / torque.in_si)));
  const DisplayUnit time = display_unit("life", "s", {"h", 3600});
  Table lives{.head = {"series", "L10", "L50"}, .align = "r"};
  for (const RatedLife& row : rows.lives)
    lives.rows.push_back(cells(row.series, number(row.ten_percent / time.in_si),
                               number(row.fifty_percent / time.in_si)));
  std::string sources =
      "\nSources.  The ratings are from C.  Rows from D and E are of other series: they judge "
      "only, "
      "and no fit\nuses them.\n";
  for (const auto& [letter, source] : rows.sources)
    sources += fmt::format("  {}: {}\n", letter, source);
  return section(fmt::format("Torsional stiffness, input locked: torque in {}, K in {}\n",
                             torque.text, of_stiffness.text),
                 stiffness) +
         section(fmt::format("\nRatings: torque in {}, speed of the input with grease in {}, "
                             "inertia in {}\n",
                             torque.text, speed.text, inertia.text),
                 ratings) +
         section(fmt::format("\nRatcheting and buckling torque in {} (A)\n", torque.text), limits) +
         section(
             fmt::format("\nRated life of the wave generator's bearing at rated torque and 2000 "
                         "rpm, in {}\n",
                         time.text),
             lives) +
         sources;
}

std::string catalogue_csv(const CatalogueRows& rows) {
  Table table{.head = {"size", "ratio_class", "T1 [N*m]", "T2 [N*m]", "K1 [N*m/rad]",
                       "K2 [N*m/rad]", "K3 [N*m/rad]", "sources", "series", "form", "length",
                       "origin", "ratios"}};
  for (const StiffnessRow& row : rows.stiffness)
    table.rows.push_back(cells(row.size, row.ratio_class, row.T1, row.T2, row.K1, row.K2, row.K3,
                               row.sources, row.series, row.form, row.length, row.origin,
                               fmt::format("{}", fmt::join(row.ratios, " "))));
  return csv_table(table);
}

}  // namespace strainwave
