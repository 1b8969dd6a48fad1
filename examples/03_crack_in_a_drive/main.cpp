// SPDX-License-Identifier: Apache-2.0
// Prints K along the front of a crack of a drive while the crack grows.

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/io/gear_reader.hpp"

namespace {

// snippet: growth
void print_growth(const strainwave::GearSet& gear) {
  strainwave::check(gear);  // each computation expects a checked drive
  const strainwave::DriveCrack crack = strainwave::drive_cracks(gear).front();
  const double torque = gear.load.torque;
  for (const double factor : {1.0, 1.5, 2.0}) {
    const strainwave::CrackSize size{.size = factor * crack.size.size,
                                     .aspect_ratio = crack.size.aspect_ratio};
    double largest = 0.0;  // K_I along the front [Pa*m^0.5]
    for (const auto& point : crack.front(size, strainwave::Faces::open))
      largest = std::max(largest, std::abs(point.load.I[strainwave::kTorsion]) * torque);
    std::cout << crack.path << ", " << crack.size_name << ' ' << 1e3 * size.size
              << " mm: K_I = " << largest / 1e6 << " MPa*m^0.5\n";
  }
}
// end

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) {
    std::cerr << "Name one file: example_03 through_crack.toml\n";
    return 2;
  }
  print_growth(strainwave::read_gear_set_file(arguments[1]));
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
