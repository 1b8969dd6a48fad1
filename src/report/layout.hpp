// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sheet.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/report/section_drawing.hpp"

// Positions of the parts of a drive: z from the open end of the flexspline toward the output, radii
// before assembly.

namespace strainwave::report {

/// A ring or tube in half section [m].
struct Ring {
  double z1 = 0.0;
  double z2 = 0.0;
  double inner = 0.0;
  double outer = 0.0;
  /// True if the file gives all dimensions; else some are sketched.
  bool given = true;

  [[nodiscard]] double middle() const { return (z1 + z2) / 2; }
  [[nodiscard]] double thickness() const { return outer - inner; }
  [[nodiscard]] Polygon polygon() const { return rectangle(z1, inner, z2, outer); }
};

/// All parts of a drive that the drawings show.
struct Layout {
  std::optional<Ring> cam;
  std::optional<Ring> inner_ring;
  std::optional<Ring> outer_ring;
  double ball_diameter = 0.0;  ///< 0: no wave generator
  double ball_radius = 0.0;    ///< radius of the balls' pitch circle
  bool ball_given = false;
  std::optional<Ring> rim;     ///< the wall under the teeth; with a factor, a sketched part of it
  std::optional<Ring> barrel;  ///< with a factor, the whole wall
  std::optional<Ring> bottom;  ///< bottom of a cup; its polygon is `bottom_outline`
  Polygon bottom_outline;
  std::optional<Ring> boss;
  std::optional<Ring> circular_spline;
  std::optional<Ring> shaft;
  double teeth_width = 0.0;   ///< axial width of the teeth
  double tooth_root = 0.0;    ///< radius of the roots of the flexspline's teeth
  double tooth_height = 0.0;  ///< sketched
  double end = 0.0;           ///< largest z
  double top = 0.0;           ///< largest radius

  [[nodiscard]] double teeth_middle() const { return teeth_width / 2; }
};

[[nodiscard]] Layout layout_of(const GearSet& gear);

/// The ring or tube that contains a crack; not defined for a tooth or the diaphragm.
[[nodiscard]] const Ring& ring_of(const Layout& layout, CrackedPart part);

/// A semi-ellipse over `half` on each side of a point of a surface, into the direction `into`.
[[nodiscard]] Polygon semi_ellipse(Point at, double half, double depth, Point into);

/// Cracks smaller than this on paper [mm] are enlarged.
inline constexpr double kVisible = 0.7;

/// The enlarged view of a small crack: its wall, cut through the crack, with the surface up.
struct Detail {
  int number = 0;
  std::string path = {};
  double wall = 0.0;   ///< thickness under the surface [m]
  double depth = 0.0;  ///< [m]
  double half = 0.0;   ///< along the surface [m]; 0: a line
  enum class Shape { ellipse, rectangle, line } shape = Shape::rectangle;
};

/// Draws the detail in a box of 40 x 30 mm with its upper left corner at a point of the paper.
void draw_detail(Sheet& sheet, const Detail& detail, Point corner);
inline constexpr double kDetailWidth = 40;
inline constexpr double kDetailHeight = 32;

}  // namespace strainwave::report
