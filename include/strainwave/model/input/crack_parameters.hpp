// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/core/lift.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/section_materials.hpp"

/// @file
/// The numbers on which the finite elements of one crack depend: the columns and the fixed numbers
/// of a compliance table.  Another kind of crack needs another overload.

namespace strainwave {

/// Numbers of a through crack of a tube, clamped at one end and twisted at the other; at half
/// length unless its distance is given.
template <class Real>
[[nodiscard]] std::vector<BasicCrackParameter<Real>> crack_parameters(
    const Lift<Real>& lift, const GearSet& gear, const WallThroughCrack& crack) {
  const Flexspline& fs = *gear.flexspline;
  const auto steel = elastic_constants(
      lift, material_of(gear, material_name(fs, crack.section), "flexspline.material"));
  std::vector<BasicCrackParameter<Real>> numbers = {{"half_length", "m", lift(crack.half_length)},
                                                    {"angle", "rad", lift(crack.angle)}};
  if (fs.crack_free == CrackFree::factor) {
    numbers.push_back({"outer_diameter", "m", lift(gear.drive.pitch_diameter)});
    numbers.push_back({"wall_thickness", "m", lift(*fs.wall_thickness)});
    numbers.push_back({"length", "m", lift(*fs.length)});
  } else {
    const TubeSection& wall = crack.section == WallSection::rim ? *fs.rim : *fs.barrel;
    numbers.push_back({"outer_diameter", "m", lift(wall.outer_diameter)});
    numbers.push_back({"wall_thickness", "m", lift(wall.wall_thickness)});
    numbers.push_back({"length", "m", lift(wall.length)});
  }
  if (crack.distance) numbers.push_back({"distance", "m", lift(*crack.distance)});
  numbers.push_back({"youngs_modulus", "Pa", steel.E});
  numbers.push_back({"poissons_ratio", "1", steel.nu});
  return numbers;
}

/// Numbers of an annular crack at half length of the shaft.
template <class Real>
[[nodiscard]] std::vector<BasicCrackParameter<Real>> crack_parameters(const Lift<Real>& lift,
                                                                      const GearSet& gear,
                                                                      const AnnularCrack& crack) {
  const OutputShaft& shaft = *gear.output_shaft;
  const auto steel =
      elastic_constants(lift, material_of(gear, shaft.material, "output_shaft.material"));
  return {{"depth", "m", lift(crack.depth)},
          {"outer_diameter", "m", lift(shaft.outer_diameter)},
          {"inner_diameter", "m", lift(shaft.inner_diameter)},
          {"length", "m", lift(shaft.length)},
          {"youngs_modulus", "Pa", steel.E},
          {"poissons_ratio", "1", steel.nu}};
}

/// Calls `f(path, crack)` for each crack that can have a table.
template <class F>
void for_each_tabulated_kind(const GearSet& gear, const F& f) {
  for_each_crack(gear, [&](const CrackPath& path, const auto& crack) {
    if constexpr (requires { crack.compliance_table; }) f(path, crack);
  });
}

}  // namespace strainwave
