// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "crack_plan.hpp"

namespace strainwave::gear_fem {

/// A straight crack in the unrolled wall of a tube, of coordinates s (round it) and y (along it),
/// both from the crack's middle.
///
/// About the crack the cells lie between confocal ellipses and hyperbolas, s + iy = a cosh(xi + i
/// eta) turned to the crack's direction (FE-46): the root of the distance from a tip is smooth in
/// (xi, eta), and the cells grow with the distance.  Outside of them is a grid along the tube.
struct ConfocalPlan {
  double half_length{};    ///< a [m]
  double sized_for{};      ///< a that the numbers of cells are chosen for, within 1 % [m]
  double direction{};      ///< of tip 0, from s toward y [rad]
  double half_round{};     ///< the wall reaches from s = -half_round to half_round [m]
  double below{};          ///< it reaches from y = -below [m]
  double above{};          ///< to y = above [m]
  double longest_round{};  ///< longest cell of the grid round the tube [m]
  double longest_along{};  ///< longest cell of the grid along the tube [m]
  std::string_view end = "end of the tube";  ///< what bounds it there, for messages
  int sectors = 16;                          ///< between hyperbolas; a multiple of 8
  int rings = 3;       ///< circular ones about each tip; one more leads to the grid
  double stretch = 1;  ///< of the ellipses' steps in xi, each to the next one
};

struct ConfocalCells {
  std::vector<PlanCell> cells;
  std::vector<double> round;  ///< lines of the grid at both ends of the tube, ascending in s [m]
};

/// @throws InputError  the crack is too long for the wall, or too close to an end
[[nodiscard]] ConfocalCells confocal_plan(const ConfocalPlan& plan);

/// Radius of the outermost circle about a tip [m].
[[nodiscard]] double outermost_ring(double half_length, int sectors);

/// Coordinates along and across the crack of a point of the wall [m].
[[nodiscard]] PlanPoint on_crack_axes(const ConfocalPlan& plan, const PlanPoint& point);

}  // namespace strainwave::gear_fem
