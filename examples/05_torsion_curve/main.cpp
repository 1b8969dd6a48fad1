// SPDX-License-Identifier: Apache-2.0
// Assembles a drive on its cam once and computes K1, K2 and K3, with and without its cracks.

#include <exception>
#include <iostream>

#include "strainwave/io/gear_reader.hpp"
#include "strainwave/torsion/assembled_drive.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace {

// snippet: lines
void print(const char* what, const strainwave::AssembledDrive& drive) {
  const strainwave::MakersLines lines = strainwave::makers_lines(drive);
  std::cout << what << ": K1 = " << lines.K1 << ", K2 = " << lines.K2 << ", K3 = " << lines.K3
            << " N*m/rad\n";
}

void print_makers_lines(const strainwave::GearSet& gear) {
  const strainwave::AssembledDrive drive(gear);
  print("cracked", drive);
  print("sound", drive.without_cracks());
}
// end

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) {
    std::cerr << "Name one file: example_05 cracked_size25.toml\n";
    return 2;
  }
  print_makers_lines(strainwave::read_gear_set_file(arguments[1]));
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
