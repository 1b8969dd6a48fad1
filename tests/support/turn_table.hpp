// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "strainwave/model/input/turn_table.hpp"

/// @file
/// Tables of K over a turn from closed forms.

namespace strainwave::test {

/// Where a table runs.
struct TurnGrid {
  std::vector<double> sizes;
  std::vector<double> aspect_ratios = {};
  std::vector<double> torques;
  std::vector<double> stations;
  int angles = 24;     ///< in a wave
  double first = 0.0;  ///< first angle [rad]
  double span = std::numbers::pi;
};

/// A table whose K is `factor(size, aspect ratio, torque, number of the station, angle)`.
template <class Factor>
TurnTable turn_table_of(const TurnGrid& grid, const char* size_name, const Factor& factor) {
  TurnTable table;
  table.file = "turn.csv";
  table.size_name = size_name;
  table.sizes = grid.sizes;
  table.aspect_ratios = grid.aspect_ratios;
  table.torques = grid.torques;
  table.stations = grid.stations;
  for (int k = 0; k <= grid.angles; ++k)
    table.angles.push_back(grid.first + grid.span * k / grid.angles);
  const std::vector<double> shapes =
      grid.aspect_ratios.empty() ? std::vector<double>{1.0} : grid.aspect_ratios;
  for (const double a : grid.sizes)
    for (const double shape : shapes)
      for (const double T : grid.torques)
        for (std::size_t s = 0; s < grid.stations.size(); ++s)
          for (int k = 0; k <= grid.angles; ++k) {
            // The last angle is the first one again, to the last digit.
            const int same = k == grid.angles ? 0 : k;
            table.K.push_back(factor(a, shape, T, s, grid.first + grid.span * same / grid.angles));
          }
  return table;
}

/// Gives the first crack of the flexspline a table.
template <class Crack>
void give_turn_table(GearSet& gear, TurnTable table) {
  std::get<Crack>(gear.flexspline->crack.at(0)).turn_table = table.file;
  gear.turn_tables["turn.csv"] = std::make_shared<const TurnTable>(std::move(table));
}

}  // namespace strainwave::test
