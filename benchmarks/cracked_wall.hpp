// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/io/gear_reader.hpp"

namespace strainwave {

/// A flexspline with a semi-elliptical crack in its wall, under three blocks of torque and a
/// momentary peak.
/// @param tables       of materials that are not those of the library
/// @param material     of the flexspline
/// @param depth        with its unit, likewise `half_length`
inline GearSet cracked_wall(const std::string& tables, const std::string& material,
                            const std::string& depth, const std::string& half_length) {
  return read_gear_set("format = \"strainwave-drive/1\"\n" + tables + R"(
[drive]
ratio = 100
pitch_diameter = "160 mm"
radial_displacement = "0.8 mm"
[load]
torque = "2000 N*m"
[flexspline]
material = ")" + material + R"("
shape = "cylinder"
wall_thickness = "2.24 mm"
length = "160 mm"
[[flexspline.crack]]
kind = "surface"
depth = ")" + depth + R"("
half_length = ")" + half_length +
                           R"("
angle = "45 deg"
[duty]
[[duty.block]]
duration = "60 s"
output_speed = "20 rpm"
torque = "9000 N*m"
[[duty.block]]
duration = "30 s"
output_speed = "-20 rpm"
torque = "-3000 N*m"
[[duty.block]]
duration = "30 s"
output_speed = "10 rpm"
torque = "4000 N*m"
[[duty.peak]]
torque = "16000 N*m"
output_speed = "10 rpm"
duration = "0.1 s"
interval = "3600 s"
)",
                       "wall.toml");
}

}  // namespace strainwave
