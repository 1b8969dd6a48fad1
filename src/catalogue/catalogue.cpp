// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/catalogue/torque_limits.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

// Sources of the rows.  Rows name these letters; the ratings come from C.
const std::map<std::string, std::string> kSources = {
    {"A", "CSF/CSG catalogue of Harmonic Drive LLC, p. 50; ratcheting, buckling and lives p. 14"},
    {"B", "engineering data 1018854 of Harmonic Drive AG, tables 54.3 and 54.4"},
    {"C", "Harmonic Drive SE, by harmonic-drive-selector (Apache-2.0)"},
    {"D", "manual of the FHA mini actuators, p. 16, and manual of the RSF-B actuators, p. 12"},
    {"E", "manual of the FHA-C actuators, p. 16; the size of the gear follows from T1 and T2"}};

}  // namespace

RatioClass ratio_class_of(double ratio) {
  if (ratio * ratio < 30.0 * 50.0) return RatioClass::thirty;
  return ratio * ratio < 50.0 * 80.0 ? RatioClass::fifty : RatioClass::eighty_up;
}

std::vector<int> catalogue_sizes() {
  std::vector<int> sizes;
  for (const StiffnessRow& row : stiffness_rows()) sizes.push_back(static_cast<int>(row.size));
  std::ranges::sort(sizes);
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

double pitch_diameter_of(double size) { return 2.54 * units::mm * size; }

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

const StiffnessRow* nearest_stiffness(double pitch_diameter, double ratio, FlexsplineForm form,
                                      FlexsplineLength length) {
  require(pitch_diameter > 0, "pitch_diameter", pitch_diameter, "m", "> 0");
  require(ratio > 0, "ratio", ratio, "1", "> 0");
  const StiffnessRow* nearest = nullptr;
  const auto distance = [&](const StiffnessRow& row) {
    return std::abs(std::log(pitch_diameter_of(row.size) / pitch_diameter));
  };
  for (const StiffnessRow& row : stiffness_rows())
    if (row.ratio_class == ratio_class_of(ratio) && row.form == form && row.length == length &&
        (nearest == nullptr || distance(row) < distance(*nearest)))
      nearest = &row;
  return nearest;
}

void require_catalogue_size(int size) {
  const std::vector<int> known = catalogue_sizes();
  if (std::ranges::find(known, size) == known.end())
    throw InputError("size", fmt::format("{} is not a size of the catalogue; known sizes are {}",
                                         size, fmt::join(known, ", ")));
}

CatalogueRows catalogue_rows(const CatalogueFilter& filter) {
  if (filter.size) require_catalogue_size(*filter.size);
  if (filter.ratio) require(*filter.ratio > 0, "ratio", *filter.ratio, "1", "> 0");
  CatalogueRows rows{
      .stiffness = {}, .ratings = {}, .limits = {}, .lives = {}, .sources = kSources};
  for (const StiffnessRow& row : stiffness_rows())
    if ((!filter.size || row.size == *filter.size) &&
        (!filter.ratio || row.ratio_class == ratio_class_of(*filter.ratio)))
      rows.stiffness.push_back(row);
  for (const StiffnessRow& row : other_series_rows())
    if ((!filter.size || row.size == *filter.size) &&
        (!filter.ratio || row.ratios.front() == *filter.ratio))
      rows.stiffness.push_back(row);
  for (const RatingRow& row : rating_rows())
    if ((!filter.size || row.size == *filter.size) && (!filter.ratio || row.ratio == *filter.ratio))
      rows.ratings.push_back(row);
  for (const TorqueLimitRow& row : torque_limit_rows())
    if ((!filter.size || row.size == *filter.size) && (!filter.ratio || row.ratio == *filter.ratio))
      rows.limits.push_back(row);
  rows.lives.assign(rated_lives().begin(), rated_lives().end());
  if (rows.stiffness.empty() && rows.ratings.empty() && rows.limits.empty())
    throw InputError("ratio", fmt::format("{} has no row for size {}", filter.ratio.value_or(0.0),
                                          filter.size.value_or(0)));
  return rows;
}

}  // namespace strainwave
