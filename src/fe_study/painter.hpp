// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Tools for pictures of fields: colour scales, filled bands, text.  Lengths are in px of the SVG's
// own coordinates, with y downward.

namespace strainwave::fe_study {

struct PaperPoint {
  double x = 0.0;
  double y = 0.0;
};

enum class ColourMap {
  rising,     ///< dark to light, even steps for the eye
  diverging,  ///< blue below, white at, red above the middle
};

/// Maps values to colours in `bands` equal steps from `lower` to `upper`; the first and last step
/// also cover values beyond.
struct ValueScale {
  ColourMap map = ColourMap::rising;
  double lower = 0.0;
  double upper = 1.0;
  std::size_t bands = 20;

  [[nodiscard]] std::size_t band(double value) const;
  [[nodiscard]] double level(std::size_t band) const;  ///< lower end of a band
  [[nodiscard]] std::string colour(std::size_t band) const;
};

/// A length in mm, with its unit.
/// @param metres  [m]
[[nodiscard]] std::string in_mm(double metres);

/// The least of 1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of ten that is not below the value.
[[nodiscard]] double round_up(double value);

/// The largest of 1, 2 or 5 times a power of ten that is not above the value.
[[nodiscard]] double round_down(double value);

/// A field on a grid of (n+1)^2 points with places on paper; the first index runs fastest.
struct PaperPatch {
  std::size_t divisions = 0;
  std::vector<PaperPoint> points;
  std::vector<double> values;

  [[nodiscard]] std::vector<PaperPoint> outline() const;
};

/// Patches that do not hide each other, filled in bands with straight borders within triangles.
class BandPainter {
 public:
  explicit BandPainter(const ValueScale& scale) : scale_(scale), paths_(scale.bands) {}

  void patch(const PaperPatch& patch);
  [[nodiscard]] std::string svg() const;

 private:
  void quadrilateral(const PaperPatch& patch, std::size_t first);
  void triangle(const PaperPoint* const (&corner)[3], const double (&value)[3]);
  void polygon(std::size_t band, std::span<const PaperPoint> points);

  ValueScale scale_;
  std::vector<std::string> paths_;  ///< paths of each band
};

/// Polygons that may hide each other, painted from the farthest to the nearest.
class DepthPainter {
 public:
  /// @param depth  depth; a larger value is nearer
  /// @param fill   fill colour
  /// @param edge   a class of the sheet; empty: no edge
  void polygon(double depth, std::vector<PaperPoint> points, std::string fill,
               std::string_view edge = {});
  /// Adds a finished SVG fragment.
  void finished(double depth, std::string svg);
  [[nodiscard]] std::string svg() const;

 private:
  struct Face {
    double depth = 0.0;
    std::vector<PaperPoint> points;
    std::string fill;
    std::string edge;
    std::string svg;  ///< finished fragment that replaces the members above
  };
  std::vector<Face> faces_;
};

/// An SVG path such as "M1 2l.5 -3 4 0z", rounded to a tenth of a px; empty for a closed path
/// smaller than that.
[[nodiscard]] std::string path_of(std::span<const PaperPoint> points, bool closed);

/// A number for people with three digits: "0.0123", "9 470", "1.20·10⁻⁵".
[[nodiscard]] std::string shown_number(double value);

/// One picture as an SVG sheet.
class PictureSheet {
 public:
  PictureSheet(double width, double height) : width_(width), height_(height) {}

  void title(std::string_view title, std::span<const std::string> lines);
  void words(PaperPoint at, std::string_view style, std::string_view text);
  void line(std::span<const PaperPoint> points, std::string_view style);
  void arrow(PaperPoint from, PaperPoint to);
  void raw(std::string_view svg) { body_ += svg; }
  /// Draws a vertical colour bar with its unit.
  /// @param beyond  description of places with values beyond the scale
  void colour_bar(PaperPoint corner, double height, const ValueScale& scale,
                  std::string_view quantity, std::string_view beyond);
  /// Draws a length to scale, at most `longest` px long.
  void scale_bar(PaperPoint at, double px_per_metre, double longest);
  /// Clips everything drawn until `end_clip` to a rectangle.
  void begin_clip(std::string_view id, PaperPoint corner, double width, double height);
  void end_clip();

  /// Draws a horizontal colour bar with numbers below it.
  void level_bar(PaperPoint corner, double width, const ValueScale& scale);

  [[nodiscard]] const std::string& body() const { return body_; }  ///< what was drawn
  [[nodiscard]] std::string svg(std::string_view description) const;

 private:
  double width_;
  double height_;
  std::string title_;
  std::string body_;
};

}  // namespace strainwave::fe_study
