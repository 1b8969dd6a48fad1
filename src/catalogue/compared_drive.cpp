// SPDX-License-Identifier: Apache-2.0
#include "compared_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "strainwave/torsion/compare.hpp"

namespace strainwave {

GearSet component_set(const GearSet& gear) {
  GearSet set = without_cracks(gear);
  set.output_shaft.reset();
  if (set.flexspline) set.flexspline->flange_compliance = 0.0;
  drop_lost_paths(set, gear);
  return set;
}

std::optional<DriveType> type_of(const GearSet& gear) {
  if (!gear.flexspline || gear.flexspline->shape == FlexsplineShape::cylinder) return std::nullopt;
  const ProportionValues typical;
  const std::array<std::pair<FlexsplineLength, double>, 3> lengths = {
      {{FlexsplineLength::standard, typical.standard_length},
       {FlexsplineLength::short_length, typical.short_length},
       {FlexsplineLength::flat, typical.flat_length}}};
  const double own = gear.flexspline->tube_length() / gear.drive.pitch_diameter;
  return DriveType{.form = gear.flexspline->shape == FlexsplineShape::hat ? FlexsplineForm::hat
                                                                          : FlexsplineForm::cup,
                   .length = std::ranges::min_element(lengths, {}, [&](const auto& length) {
                               return std::abs(std::log(own / length.second));
                             })->first};
}

bool has_size(double pitch_diameter, double size) {
  constexpr double kSame = 1e-3;  // largest relative difference
  return std::abs(pitch_diameter / pitch_diameter_of(size) - 1) <= kSame;
}

bool is_short_cup(const DriveType& type) {
  return type.form == FlexsplineForm::cup && type.length == FlexsplineLength::short_length;
}

std::string words_of(const DriveType& type) {
  return fmt::format("{} {}", enum_name(type.length), enum_name(type.form));
}

}  // namespace strainwave
