// SPDX-License-Identifier: Apache-2.0
// Describes a drive in code and computes the stiffness that it loses by a crack of its output
// shaft.

#include <exception>
#include <iostream>

#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace {

// snippet: drive
strainwave::GearSet own_drive() {
  strainwave::GearSet gear;
  gear.name = "Cylinder and shaft";
  gear.drive = {.ratio = 100, .pitch_diameter = 0.160, .radial_displacement = 0.8e-3};  // [m]
  gear.load = {.torque = 100};                                                          // [N*m]

  strainwave::Material& steel = gear.material["steel"];
  steel.youngs_modulus = 210e9;  // [Pa]
  steel.poissons_ratio = 0.3;

  strainwave::Flexspline& flexspline = gear.flexspline.emplace();
  flexspline.material = "steel";
  flexspline.shape = strainwave::FlexsplineShape::cylinder;
  flexspline.wall_thickness = 2.24e-3;  // [m]
  flexspline.length = 0.160;

  strainwave::OutputShaft& shaft = gear.output_shaft.emplace();
  shaft.material = "steel";
  shaft.outer_diameter = 0.030;  // [m]
  shaft.length = 0.040;
  return gear;
}
// end

}  // namespace

int main() try {
  // snippet: crack
  strainwave::GearSet gear = own_drive();
  const auto sound = strainwave::torsional_stiffness(gear);
  gear.output_shaft->crack.push_back(strainwave::AnnularCrack{.depth = 2e-3});  // [m]
  const auto cracked = strainwave::torsional_stiffness(gear);
  const strainwave::Quantity change = cracked.positive.stiffness_change;
  std::cout << "sound: " << sound.intact.stiffness.value << " N*m/rad\n"
            << "change by the crack: " << 100 * change.value << " %\n";
  // end
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
