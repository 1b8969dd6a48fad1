// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

// Where the rows come from; the rows name these letters, and C has the ratings too.
const std::map<std::string, std::string> kSources = {
    {"A", "CSF/CSG catalogue of Harmonic Drive LLC, p. 50"},
    {"B", "engineering data 1018854 of Harmonic Drive AG, tables 54.3 and 54.4"},
    {"C", "Harmonic Drive SE, by harmonic-drive-selector (Apache-2.0)"}};

}  // namespace

RatioClass ratio_class_of(double ratio) {
  if (ratio * ratio < 30.0 * 50.0) return RatioClass::thirty;
  return ratio * ratio < 50.0 * 80.0 ? RatioClass::fifty : RatioClass::eighty_up;
}

double representative_ratio(RatioClass ratio_class) {
  static constexpr std::array<double, kRatioClasses> kRatios = {30, 50, 100};
  return kRatios[static_cast<std::size_t>(ratio_class)];
}

std::vector<int> catalogue_sizes() {
  std::vector<int> sizes;
  for (const StiffnessRow& row : stiffness_rows()) sizes.push_back(row.size);
  std::ranges::sort(sizes);
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

double pitch_diameter_of(int size) { return 2.54 * units::mm * size; }

const StiffnessRow* find_stiffness(int size, double ratio) {
  const auto rows = stiffness_rows();
  const auto found = std::ranges::find_if(rows, [&](const StiffnessRow& row) {
    return row.size == size && row.ratio_class == ratio_class_of(ratio);
  });
  return found == rows.end() ? nullptr : &*found;
}

const RatingRow* find_rating(int size, double ratio) {
  const auto rows = rating_rows();
  const auto found = std::ranges::find_if(
      rows, [&](const RatingRow& row) { return row.size == size && row.ratio == ratio; });
  return found == rows.end() ? nullptr : &*found;
}

const StiffnessRow& nearest_stiffness(double pitch_diameter, double ratio) {
  require(pitch_diameter > 0, "pitch_diameter", pitch_diameter, "m", "> 0");
  require(ratio > 0, "ratio", ratio, "1", "> 0");
  const RatioClass wanted = ratio_class_of(ratio);
  const auto distance = [&](const StiffnessRow& row) {
    return row.ratio_class == wanted
               ? std::abs(std::log(pitch_diameter_of(row.size) / pitch_diameter))
               : std::numeric_limits<double>::infinity();
  };
  return *std::ranges::min_element(stiffness_rows(), {}, distance);
}

void require_catalogue_size(int size) {
  const std::vector<int> known = catalogue_sizes();
  if (std::ranges::find(known, size) == known.end())
    throw InputError("size", fmt::format("{} is not a size of the catalogue; known are {}", size,
                                         fmt::join(known, ", ")));
}

CatalogueRows catalogue_rows(const CatalogueFilter& filter) {
  if (filter.size) require_catalogue_size(*filter.size);
  if (filter.ratio) require(*filter.ratio > 0, "ratio", *filter.ratio, "1", "> 0");
  CatalogueRows rows{.stiffness = {}, .ratings = {}, .sources = kSources};
  for (const StiffnessRow& row : stiffness_rows())
    if ((!filter.size || row.size == *filter.size) &&
        (!filter.ratio || row.ratio_class == ratio_class_of(*filter.ratio)))
      rows.stiffness.push_back(row);
  for (const RatingRow& row : rating_rows())
    if ((!filter.size || row.size == *filter.size) && (!filter.ratio || row.ratio == *filter.ratio))
      rows.ratings.push_back(row);
  if (rows.stiffness.empty() && rows.ratings.empty())
    throw InputError("ratio", fmt::format("{} has no row for size {}", filter.ratio.value_or(0.0),
                                          filter.size.value_or(0)));
  return rows;
}

std::string catalogue_text(const CatalogueRows& rows) {
  std::string text = "Torsional stiffness, input locked: torque in N*m, K in 1e4 N*m/rad\n";
  text += fmt::format("{:>6}{:>8}{:>9}{:>9}{:>11}{:>11}{:>11}  {}\n", "size", "ratio", "T1", "T2",
                      "K1", "K2", "K3", "sources");
  for (const StiffnessRow& row : rows.stiffness)
    text += fmt::format(
        "{:>6}{:>8}{:>9}{:>9}{:>11}{:>11}{:>11}  {}\n", row.size, enum_name(row.ratio_class),
        fmt::format("{:g}", row.T1), fmt::format("{:g}", row.T2), fmt::format("{:g}", row.K1 / 1e4),
        fmt::format("{:g}", row.K2 / 1e4),
        row.K3 ? fmt::format("{:g}", *row.K3 / 1e4) : std::string("-"), row.sources);
  if (rows.stiffness.empty()) text += "  no row\n";
  text += "\nRatings: torque in N*m, speed of the input with grease in rpm, inertia in kg*m^2\n";
  text += fmt::format("{:>6}{:>6}{:>7}{:>9}{:>9}{:>9}{:>11}{:>11}{:>9}{:>11}\n", "series", "size",
                      "ratio", "rated", "average", "peak", "momentary", "max speed", "average",
                      "inertia");
  for (const RatingRow& row : rows.ratings)
    text += fmt::format("{:>6}{:>6}{:>7}{:>9g}{:>9g}{:>9g}{:>11g}{:>11.0f}{:>9.0f}{:>11.3g}\n",
                        row.series, row.size, row.ratio, row.rated, row.average, row.repeated_peak,
                        row.momentary_peak, row.max_input_speed / units::rpm,
                        row.average_input_speed / units::rpm, row.input_inertia);
  if (rows.ratings.empty()) text += "  no row\n";
  return text +
         "\nSources.  A: CSF/CSG catalogue of Harmonic Drive LLC, page 50.  B: engineering data "
         "1018854 of\n  Harmonic Drive AG, tables 54.3 and 54.4.  C and the ratings: data of "
         "Harmonic Drive SE, from\n  harmonic-drive-selector (Apache-2.0).\n";
}

std::string catalogue_csv(const CatalogueRows& rows) {
  std::string csv =
      "size,ratio_class,T1 [N*m],T2 [N*m],K1 [N*m/rad],K2 [N*m/rad],K3 [N*m/rad],sources\n";
  for (const StiffnessRow& row : rows.stiffness)
    csv +=
        fmt::format("{},{},{},{},{},{},{},{}\n", row.size, enum_name(row.ratio_class), row.T1,
                    row.T2, row.K1, row.K2, row.K3 ? fmt::format("{}", *row.K3) : "", row.sources);
  return csv;
}

}  // namespace strainwave
