// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

// Paper for technical drawings.  A real length times the scale is its length on paper.

namespace strainwave::report {

/// A point of the drive [m] or of the paper [mm], as stated by the function.
struct Point {
  double x = 0.0;
  double y = 0.0;
};
using Polygon = std::vector<Point>;

[[nodiscard]] Polygon rectangle(double x1, double y1, double x2, double y2);

/// The largest scale of ISO 5455 (and 1:2.5) at which a length fits on paper [-]: 2 is 2:1.
///
/// @param real   [m]; > 0
/// @param paper  [mm]; > 0
[[nodiscard]] double drawing_scale(double real, double paper);

/// A scale as text: "2:1", "1:2.5".
[[nodiscard]] std::string scale_text(double scale);

/// Hatching of a cut part.
struct Hatch {
  double angle = 45.0;   ///< angle of the lines [deg]
  double spacing = 1.6;  ///< spacing on paper [mm]; 0: no hatching
};

/// Width of every drawing on paper [mm].
inline constexpr double kPaperWidth = 180;

/// One drawing: SVG whose user unit is a millimetre of paper.
///
/// Colours are CSS variables with fallbacks, so a page can set them for a dark screen and the file
/// is also usable alone.
class Sheet {
 public:
  /// @param scale   paper per real length [-]
  /// @param origin  where the real origin lies on paper [mm]; y grows upward in the drive
  Sheet(double scale, Point origin) : scale_(scale), origin_(origin) {}

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] Point paper(Point real) const;
  /// A real length on paper [mm].
  [[nodiscard]] double paper(double real) const;

  /// Draws a cut part; thin parts are filled, as ISO 128 allows.
  /// @param outline  [m]
  /// @param thin     its least thickness [m]
  void part(std::string_view id, const Polygon& outline, const Hatch& hatch, double thin);
  /// Draws only the outline of a visible or sketched part [m].
  void outline(std::string_view id, const Polygon& outline, std::string_view style);
  /// Draws a straight line between points of the drive [m].
  void line(Point from, Point to, std::string_view style);
  void curve(const Polygon& points, std::string_view style);
  void circle(std::string_view id, Point centre, double radius, std::string_view style);
  /// Draws the shape of a crack to scale [m].
  void crack(std::string_view path, const Polygon& shape, bool closed);

  // The functions below use millimetres of paper.
  void paper_line(Point from, Point to, std::string_view style);
  void words(Point at, std::string_view text, std::string_view style);
  void balloon(Point at, std::string_view text, std::string_view style);
  void scale_bar(Point at, double longest);
  void raw(std::string_view svg) { body_ += svg; }
  void hatch_on_paper(const Polygon& outline, const Hatch& hatch);

  /// The document.
  /// @param size  size of the paper [mm]
  [[nodiscard]] std::string svg(std::string_view id, Point size, std::string_view title,
                                std::string_view description) const;

 private:
  double scale_;
  Point origin_;
  std::string body_;
};

/// A mark in a row or column outside the drawing that points at a target in the drawing.
struct Balloon {
  std::string text;
  Point target;  ///< [mm] on paper
  std::string style;
};

/// Places for marks along an axis, in the order of their targets, `spacing` apart, close to them
/// and between `from` and `to` if there is room.
[[nodiscard]] std::vector<double> spread(std::span<const double> wanted, double spacing,
                                         double from, double to);

}  // namespace strainwave::report
