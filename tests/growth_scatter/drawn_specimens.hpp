// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "strainwave/growth_scatter/specimens.hpp"

namespace strainwave::test {

/// The specimens of examples/growth_specimens.csv.
inline std::vector<GrowthSpecimen> drawn_specimens() {
  std::ifstream file(STRAINWAVE_EXAMPLES "/growth_specimens.csv");
  std::vector<double> sizes;
  std::vector<std::vector<double>> cycles;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#') || line.starts_with("crack")) continue;
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    sizes.push_back(std::stod(cell) * 1e-3);
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (k == cycles.size()) cycles.emplace_back();
      cycles[k].push_back(std::stod(cell));
    }
  }
  if (sizes.empty()) throw std::runtime_error("examples/growth_specimens.csv cannot be read");
  std::vector<GrowthSpecimen> specimens;
  for (std::size_t k = 0; k < cycles.size(); ++k)
    specimens.push_back(specimen_of("drawn " + std::to_string(k + 1), sizes, cycles[k],
                                    PlateTest{.stress_range = 60e6, .width = 0.1}));
  return specimens;
}

}  // namespace strainwave::test
