// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/life/load_history.hpp"

/// @file
/// Drives with one crack, for the tests of crack growth.

namespace strainwave::test {

/// The example with an annular crack in a solid shaft.
inline GearSet growing_shaft() {
  return read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_shaft.toml");
}

/// Without toughness and strength: no fracture and no assessment.
inline GearSet unbreakable_shaft() {
  GearSet gear = growing_shaft();
  Material& steel = gear.material.at("steel");
  steel.fracture_toughness.reset();
  steel.yield_strength.reset();
  steel.ultimate_strength.reset();
  return gear;
}

/// A flexspline of one wall with one crack; `crack` is the table of the crack.
inline GearSet cracked_wall(const std::string& crack, const std::string& ratio = "100",
                            const std::string& waves = "2") {
  return read_gear_set(R"(
format = "strainwave-drive/1"
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
[[material.steel.growth]]
kind = "paris"
coefficient = "6.9e-12 m"
exponent = 3
[drive]
ratio = )" + ratio + R"(
wave_number = )" + waves +
                           R"(
pitch_diameter = "160 mm"
radial_displacement = "0.8 mm"
[load]
torque = "6000 N*m"
[flexspline]
material = "steel"
shape = "cylinder"
wall_thickness = "2.24 mm"
length = "160 mm"
[[flexspline.crack]]
)" + crack + R"(
[duty]
[[duty.block]]
duration = "4 s"
output_speed = "60 rpm"
torque = "6000 N*m"
[[duty.block]]
duration = "4 s"
output_speed = "60 rpm"
torque = "1000 N*m"
[[duty.block]]
duration = "4 s"
output_speed = "-60 rpm"
torque = "-3000 N*m"
)",
                       "wall.toml");
}

inline GrowthOptions until_size(const std::string& crack, double size) {
  GrowthOptions options;
  options.stop = {.time = {}, .cycles = {}, .crack = crack, .size = size};
  return options;
}

/// The only crack of a drive, ready to grow.
inline GrowingCrack only_crack(const GearSet& gear, const RateChoice& choice = {}) {
  return {gear, drive_cracks(gear).front(), duty_history(gear), choice};
}

}  // namespace strainwave::test
