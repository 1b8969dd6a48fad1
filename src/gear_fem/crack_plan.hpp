// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "strainwave/fem/hex_mesh.hpp"

namespace strainwave::gear_fem {

using PlanPoint = std::array<double, 2>;

/// The point that divides the line from a to b by u : 1 - u.
inline PlanPoint blend(const PlanPoint& a, const PlanPoint& b, double u) {
  return {(1 - u) * a[0] + u * b[0], (1 - u) * a[1] + u * b[1]};
}

/// Place of a quadrilateral in the rings about a tip.
struct PlanTipPlace {
  std::size_t tip{};         ///< index of the tip
  int ring = -1;             ///< -1: at the tip (FrontPlace::ring)
  int side = 0;              ///< side of the tip's frame (FrontPlace::side)
  PlanPoint growth{};        ///< unit vector of the tip's growth
  bool square_root = false;  ///< FrontPlace::square_root
};

/// A quadrilateral of a plane mesh about crack tips, with its analytic map of the unit square.
struct PlanCell {
  std::function<PlanPoint(double u, double v)> map;
  int half = 1;  ///< side of the crack's line on which the cell lies, +1 or -1
  std::optional<PlanTipPlace> tip = {};
};

/// A tip at a node of the grid; its rings replace the four cells about the node.
struct PlanTip {
  std::size_t i{};  ///< index of the line across
  std::size_t j{};  ///< index of the line along
  int growth = 1;   ///< +1: grows toward larger first coordinate, -1: smaller
};

/// Grid lines, tips, and the rings about each tip: squares of four cells, a circle inside, then
/// rings in geometric progression down to four cells at the tip.
struct CrackPlan {
  std::vector<double> x;  ///< lines across the crack's direction, ascending [m]
  std::vector<double> y;  ///< lines along the crack's direction, ascending [m]
  std::vector<PlanTip> tips;
  int rings = 6;         ///< circular rings; one more ring leads to the square
  double ratio = 0.5;    ///< ratio of the radii of neighbouring rings
  double circle = 0.65;  ///< radius of the outermost circle over half the square's smallest side
};

[[nodiscard]] std::vector<PlanCell> crack_plan(const CrackPlan& plan);

/// Lines from `from` to `to`, of which either may be larger.  The first gap is `first`; each next
/// gap is at most `growth` times longer, and none is longer than `most`.  `from` is left out; `to`
/// is the last line.
[[nodiscard]] std::vector<double> graded_lines(double from, double to, double first, double growth,
                                               double most);

/// Plan cells swept straight along the third coordinate between the lines; the crack grows in
/// the plane, one front per tip.
[[nodiscard]] std::vector<fem::TemplateCell> extruded(const std::vector<PlanCell>& plan,
                                                      const std::vector<double>& layers);

}  // namespace strainwave::gear_fem
