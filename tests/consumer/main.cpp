#include <exception>
#include <iostream>

#include "strainwave/io/gear_reader.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

int main(int arguments, char** argument) try {
  if (arguments != 2) {
    std::cerr << "usage: consumer FILE\n";
    return 2;
  }
  const auto gear = strainwave::read_gear_set_file(argument[1]);
  const auto result = strainwave::torsional_stiffness(gear);
  std::cout << result.positive.stiffness.value << ' ' << result.positive.stiffness.unit << '\n';
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
