// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/io/gear_reader.hpp"

namespace strainwave::test {

/// A cracked shaft and flexspline between motor and load, by the sum of the members.
/// @param more  lines after the inertias of [drivetrain], and tables
inline GearSet summed_joint(const std::string& more) {
  return read_gear_set(R"(
format = "strainwave-drive/1"
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
[drive]
ratio = 100
pitch_diameter = "160 mm"
radial_displacement = "0.8 mm"
[load]
torque = "100 N*m"
[flexspline]
material = "steel"
shape = "cup"
wall_thickness = "2.24 mm"
length = "160 mm"
crack_free = "factor"
[[flexspline.crack]]
kind = "through"
half_length = "10 mm"
angle = "45 deg"
[output_shaft]
material = "steel"
outer_diameter = "60 mm"
length = "100 mm"
[[output_shaft.crack]]
kind = "annular"
depth = "5 mm"
[drivetrain]
motor_inertia = "1e-4 kg*m^2"
load_inertia = "1 kg*m^2"
)" + more,
                       "joint.toml");
}

}  // namespace strainwave::test
