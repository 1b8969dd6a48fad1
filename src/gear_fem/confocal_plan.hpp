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
/// About the crack, the cells lie between confocal ellipses and hyperbolas, s + iy = a cosh(xi + i
/// eta) turned to the direction of the crack (FE-46).  The root of the distance from a tip is then
/// smooth in (xi, eta), and the cells grow with the distance.  Outside of these cells, a grid runs
/// along the tube.
struct ConfocalPlan {
  double half_length{};    ///< a [m]
  double sized_for{};      ///< length a, within 1 %, that determines the numbers of cells [m]
  double direction{};      ///< direction of tip 0, from s toward y [rad]
  double half_round{};     ///< the wall reaches from s = -half_round to half_round [m]
  double below{};          ///< it reaches from y = -below [m]
  double above{};          ///< to y = above [m]
  double longest_round{};  ///< longest cell of the grid round the tube [m]
  double longest_along{};  ///< longest cell of the grid along the tube [m]
  std::string_view end = "end of the tube";  ///< name of this boundary in messages
  int sectors = 16;                          ///< sectors between hyperbolas; a multiple of 8
  int rings = 3;       ///< circular rings about each tip; one more ring leads to the grid
  double stretch = 1;  ///< growth of the ellipses' steps in xi from one to the next
};

struct ConfocalCells {
  std::vector<PlanCell> cells;
  std::vector<double> round;  ///< lines of the grid at both ends of the tube, ascending in s [m]
};

/// @throws InputError  if the crack is too long for the wall, or too close to an end
[[nodiscard]] ConfocalCells confocal_plan(const ConfocalPlan& plan);

/// Radius of the outermost circle about a tip [m].
[[nodiscard]] double outermost_ring(double half_length, int sectors);

/// Coordinates along and across the crack of a point of the wall [m].
[[nodiscard]] PlanPoint on_crack_axes(const ConfocalPlan& plan, const PlanPoint& point);

}  // namespace strainwave::gear_fem
