// SPDX-License-Identifier: Apache-2.0
#include "painter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "strainwave/chart/svg_text.hpp"

namespace strainwave::fe_study {
namespace {

struct Rgb {
  double red, green, blue;
};

constexpr Rgb rgb(std::uint32_t hex) {
  return {static_cast<double>(hex >> 16U), static_cast<double>((hex >> 8U) & 0xFFU),
          static_cast<double>(hex & 0xFFU)};
}

// Viridis at every tenth (public domain); its lightness rises evenly, also for colour-blind
// readers.
constexpr std::array<Rgb, 11> kRising = {rgb(0x440154), rgb(0x482475), rgb(0x414487), rgb(0x355f8d),
                                         rgb(0x2a788e), rgb(0x21918c), rgb(0x22a884), rgb(0x44bf70),
                                         rgb(0x7ad151), rgb(0xbddf26), rgb(0xfde725)};
// Blue to red over white; lightness falls equally to both sides.
constexpr std::array<Rgb, 11> kDiverging = {
    rgb(0x053061), rgb(0x2166ac), rgb(0x4393c3), rgb(0x92c5de), rgb(0xd1e5f0), rgb(0xf7f7f7),
    rgb(0xfddbc7), rgb(0xf4a582), rgb(0xd6604d), rgb(0xb2182b), rgb(0x67001f)};

constexpr double kPoint = 1.2;  // patches smaller than this get one colour [px]

struct Extent {
  double x0 = 1e30, x1 = -1e30, y0 = 1e30, y1 = -1e30;
  void include(PaperPoint p) {
    x0 = std::min(x0, p.x);
    x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y);
    y1 = std::max(y1, p.y);
  }
};

/// A number of tenths in as few characters as possible.
std::string tenths(long value) {
  const long size = std::abs(value);
  std::string text = value < 0 ? "-" : "";
  if (size >= 10 || size == 0) text += std::to_string(size / 10);
  if (size % 10 != 0) text += fmt::format(".{}", size % 10);
  return text;
}

}  // namespace

std::size_t ValueScale::band(double value) const {
  const double share = (value - lower) / (upper - lower) * static_cast<double>(bands);
  if (!(share > 0)) return 0;
  return std::min(bands - 1, static_cast<std::size_t>(share));
}

double ValueScale::level(std::size_t band) const {
  return lower + (upper - lower) * static_cast<double>(band) / static_cast<double>(bands);
}

std::string ValueScale::colour(std::size_t band) const {
  const auto& stops = map == ColourMap::rising ? kRising : kDiverging;
  const double at =
      bands < 2 ? 0.0 : 10.0 * static_cast<double>(band) / static_cast<double>(bands - 1);
  const std::size_t i = std::min<std::size_t>(9, static_cast<std::size_t>(at));
  const double share = at - static_cast<double>(i);
  const auto mixed = [&](double Rgb::*part) {
    return static_cast<int>(std::lround(std::lerp(stops[i].*part, stops[i + 1].*part, share)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(&Rgb::red), mixed(&Rgb::green),
                     mixed(&Rgb::blue));
}

std::string in_mm(double metres) { return fmt::format("{:.4g} mm", metres * 1e3); }

double round_up(double value) {
  if (!(value > 0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (digit * decade >= value * (1 - 1e-9)) return digit * decade;
  return 10 * decade;
}

double round_down(double value) {
  if (!(value > 0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  for (const double digit : {5.0, 2.0})
    if (digit * decade <= value * (1 + 1e-9)) return digit * decade;
  return decade;
}

std::vector<PaperPoint> PaperPatch::outline() const {
  const std::size_t n = divisions;
  std::vector<PaperPoint> result;
  for (std::size_t i = 0; i < n; ++i) result.push_back(points[i]);
  for (std::size_t j = 0; j < n; ++j) result.push_back(points[j * (n + 1) + n]);
  for (std::size_t i = n; i > 0; --i) result.push_back(points[n * (n + 1) + i]);
  for (std::size_t j = n; j > 0; --j) result.push_back(points[j * (n + 1)]);
  return result;
}

std::string path_of(std::span<const PaperPoint> points, bool closed) {
  std::string path;
  long x = 0;
  long y = 0;
  std::size_t corners = 0;
  for (const PaperPoint& p : points) {
    const long to_x = std::lround(10 * p.x);
    const long to_y = std::lround(10 * p.y);
    if (corners > 0 && to_x == x && to_y == y) continue;
    // Steps from the last rounded point need fewer characters than absolute places.
    path += corners == 0 ? "M" : corners == 1 ? "l" : " ";
    path += tenths(to_x - x) + " " + tenths(to_y - y);
    x = to_x;
    y = to_y;
    ++corners;
  }
  if (!closed) return path;
  return corners < 3 ? std::string() : path + "z";
}

// --- bands

void BandPainter::polygon(std::size_t band, std::span<const PaperPoint> points) {
  paths_[band] += path_of(points, true);
}

void BandPainter::patch(const PaperPatch& patch) {
  Extent extent;
  for (const PaperPoint& p : patch.points) extent.include(p);
  const auto [least, most] = std::ranges::minmax_element(patch.values);
  const bool small = extent.x1 - extent.x0 < kPoint && extent.y1 - extent.y0 < kPoint;
  if (small) {
    double mean = 0.0;
    for (const double value : patch.values) mean += value;
    const std::size_t n = patch.divisions;
    polygon(scale_.band(mean / static_cast<double>(patch.values.size())),
            std::array{patch.points[0], patch.points[n], patch.points[n * (n + 2)],
                       patch.points[n * (n + 1)]});
    return;
  }
  if (scale_.band(*least) == scale_.band(*most)) {
    polygon(scale_.band(*least), patch.outline());
    return;
  }
  const std::size_t n = patch.divisions;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) quadrilateral(patch, j * (n + 1) + i);
}

void BandPainter::quadrilateral(const PaperPatch& patch, std::size_t first) {
  const std::size_t n = patch.divisions;
  const std::array<std::size_t, 4> corner = {first, first + 1, first + n + 2, first + n + 1};
  PaperPoint middle;
  double mean = 0.0;
  std::size_t least = scale_.bands;
  std::size_t most = 0;
  for (const std::size_t c : corner) {
    middle.x += patch.points[c].x / 4;
    middle.y += patch.points[c].y / 4;
    mean += patch.values[c] / 4;
    least = std::min(least, scale_.band(patch.values[c]));
    most = std::max(most, scale_.band(patch.values[c]));
  }
  if (least == most) {
    polygon(least, std::array{patch.points[corner[0]], patch.points[corner[1]],
                              patch.points[corner[2]], patch.points[corner[3]]});
    return;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t a = corner[k];
    const std::size_t b = corner[(k + 1) % 4];
    triangle({&patch.points[a], &patch.points[b], &middle},
             {patch.values[a], patch.values[b], mean});
  }
}

/// Paints the whole triangle in the colour of its lowest band, then the part above each further
/// level.
void BandPainter::triangle(const PaperPoint* const (&corner)[3], const double (&value)[3]) {
  const auto [least, most] = std::minmax({value[0], value[1], value[2]});
  const std::size_t first = scale_.band(least);
  polygon(first, std::array{*corner[0], *corner[1], *corner[2]});
  for (std::size_t band = first + 1; band <= scale_.band(most); ++band) {
    const double level = scale_.level(band);
    std::vector<PaperPoint> above;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (value[i] >= level) above.push_back(*corner[i]);
      if ((value[i] >= level) == (value[j] >= level)) continue;
      const double share = (level - value[i]) / (value[j] - value[i]);
      above.push_back({std::lerp(corner[i]->x, corner[j]->x, share),
                       std::lerp(corner[i]->y, corner[j]->y, share)});
    }
    if (above.size() >= 3) polygon(band, above);
  }
}

std::string BandPainter::svg() const {
  std::string svg;
  // The stroke covers the seams that anti-aliasing leaves between neighbours.
  for (std::size_t band = 0; band < paths_.size(); ++band)
    if (!paths_[band].empty())
      svg += fmt::format("<path class=\"band\" fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n",
                         scale_.colour(band), paths_[band]);
  return svg;
}

// --- depth

void DepthPainter::polygon(double depth, std::vector<PaperPoint> points, std::string fill,
                           std::string_view edge) {
  // Give all polygons the same orientation, because overlapping polygons of opposite orientation in
  // one path
  // would leave a hole.
  double twice_area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PaperPoint& a = points[i];
    const PaperPoint& b = points[(i + 1) % points.size()];
    twice_area += a.x * b.y - b.x * a.y;
  }
  if (twice_area < 0) std::ranges::reverse(points);
  faces_.push_back({depth, std::move(points), std::move(fill), std::string(edge), {}});
}

void DepthPainter::finished(double depth, std::string svg) {
  faces_.push_back({depth, {}, {}, {}, std::move(svg)});
}

std::string DepthPainter::svg() const {
  std::vector<const Face*> order;
  for (const Face& face : faces_) order.push_back(&face);
  std::ranges::stable_sort(order, {}, [](const Face* face) { return face->depth; });
  std::string svg;
  // Ten thousand polygons without an edge take their style from one group, which halves the text
  // about their places.
  bool grouped = false;
  const auto group = [&](bool on) {
    if (on != grouped) svg += on ? "<g class=\"solid\">\n" : "</g>\n";
    grouped = on;
  };
  for (std::size_t i = 0; i < order.size();) {
    group(order[i]->svg.empty() && order[i]->edge.empty());
    if (!order[i]->svg.empty()) {
      svg += order[i++]->svg;
      continue;
    }
    // Consecutive polygons of the same look share an element.
    std::string path;
    std::size_t j = i;
    for (; j < order.size() && order[j]->svg.empty() && order[j]->fill == order[i]->fill &&
           order[j]->edge == order[i]->edge;
         ++j)
      path += path_of(order[j]->points, true);
    svg += grouped ? fmt::format("<path color=\"{}\" d=\"{}\"/>\n", order[i]->fill, path)
                   : fmt::format("<path class=\"{}\" fill=\"{}\" d=\"{}\"/>\n", order[i]->edge,
                                 order[i]->fill, path);
    i = j;
  }
  group(false);
  return svg;
}

// --- text

std::string shown_number(double value) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  const std::string sign = value < 0 ? "−" : "";
  if (size >= 1e-3 && size < 999.5) return sign + fmt::format("{:.3g}", size);
  if (size >= 1 && size < 1e6) {
    const double unit = std::pow(10.0, std::floor(std::log10(size)) - 2);
    const std::string digits = fmt::format("{:.0f}", std::round(size / unit) * unit);
    const std::size_t last = digits.size() - 3;
    return digits.size() == 4
               ? sign + digits
               : fmt::format("{}{} {}", sign, digits.substr(0, last), digits.substr(last));
  }
  const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
  return sign + fmt::format("{:.3g}·{}", size / std::pow(10.0, exponent), power_of_ten(exponent));
}

// --- the sheet

void PictureSheet::title(std::string_view title, std::span<const std::string> lines) {
  title_ = title;
  words({20, 28}, "title", title);
  double y = 48;
  for (const std::string& line : lines) {
    words({20, y}, "small", line);
    y += 16;
  }
}

void PictureSheet::words(PaperPoint at, std::string_view style, std::string_view text) {
  body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\">{}</text>\n", at.x, at.y,
                       style, svg_text(text));
}

void PictureSheet::line(std::span<const PaperPoint> points, std::string_view style) {
  body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, path_of(points, false));
}

void PictureSheet::arrow(PaperPoint from, PaperPoint to) {
  line(std::array{from, to}, "thin");
  const double angle = std::atan2(to.y - from.y, to.x - from.x);
  for (const double side : {-0.4, 0.4})
    line(std::array{to, PaperPoint{to.x - 8 * std::cos(angle + side),
                                   to.y - 8 * std::sin(angle + side)}},
         "thin");
}

void PictureSheet::colour_bar(PaperPoint corner, double height, const ValueScale& scale,
                              std::string_view quantity, std::string_view beyond) {
  constexpr double kWidth = 18;
  const double step = height / static_cast<double>(scale.bands);
  for (std::size_t band = 0; band < scale.bands; ++band)
    body_ += fmt::format(
        "<rect class=\"band\" x=\"{:.1f}\" y=\"{:.2f}\" width=\"{}\" height=\"{:.2f}\" "
        "fill=\"{}\"/>\n",
        corner.x, corner.y + height - static_cast<double>(band + 1) * step, kWidth, step,
        scale.colour(band));
  body_ += fmt::format(
      "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\"/>\n",
      corner.x, corner.y, kWidth, height);
  const int ticks = scale.map == ColourMap::diverging ? 4 : 5;
  for (int i = 0; i <= ticks; ++i) {
    const double share = static_cast<double>(i) / ticks;
    const double y = corner.y + height * (1 - share);
    const double value = std::lerp(scale.lower, scale.upper, share);
    line(std::array{PaperPoint{corner.x + kWidth, y}, PaperPoint{corner.x + kWidth + 4, y}},
         "thin");
    words({corner.x + kWidth + 8, y + 4}, "tick",
          shown_number(std::abs(value) < 1e-9 * (scale.upper - scale.lower) ? 0.0 : value));
  }
  words({corner.x, corner.y - 26}, "label", quantity);
  words({corner.x, corner.y - 9}, "small", beyond);
}

void PictureSheet::level_bar(PaperPoint corner, double width, const ValueScale& scale) {
  constexpr double kHeight = 14;
  constexpr int kTicks = 5;
  const double step = width / static_cast<double>(scale.bands);
  for (std::size_t band = 0; band < scale.bands; ++band)
    body_ += fmt::format(
        "<rect class=\"band\" x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{}\" "
        "fill=\"{}\"/>\n",
        corner.x + static_cast<double>(band) * step, corner.y, step, kHeight, scale.colour(band));
  body_ += fmt::format(
      "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"/>\n",
      corner.x, corner.y, width, kHeight);
  for (int i = 0; i <= kTicks; ++i) {
    const double share = static_cast<double>(i) / kTicks;
    words({corner.x + width * share, corner.y + kHeight + 15}, "tick middle",
          shown_number(std::lerp(scale.lower, scale.upper, share)));
  }
}

void PictureSheet::scale_bar(PaperPoint at, double px_per_metre, double longest) {
  double length = 1e-7;
  for (double decade = 1e-7; decade < 20; decade *= 10)
    for (const double digit : {1.0, 2.0, 5.0})
      if (digit * decade * px_per_metre <= longest) length = digit * decade;
  const double half = length * px_per_metre / 2;
  body_ += fmt::format(
      "<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"5\"/>\n"
      "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"5\"/>\n",
      at.x, at.y, half, at.x, at.y, 2 * half);
  words({at.x + 2 * half + 8, at.y + 6}, "tick", fmt::format("{:.4g} mm", length * 1e3));
}

void PictureSheet::begin_clip(std::string_view id, PaperPoint corner, double width, double height) {
  body_ += fmt::format(
      "<clipPath id=\"{0}\"><rect x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"{3:.1f}\" "
      "height=\"{4:.1f}\"/></clipPath>\n<g clip-path=\"url(#{0})\">\n",
      id, corner.x, corner.y, width, height);
}

void PictureSheet::end_clip() { body_ += "</g>\n"; }

std::string PictureSheet::svg(std::string_view description) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" role=\"img\">\n<title>{2}</title>\n<desc>{3}</desc>\n"
      "<style>\n"
      "text {{ font-family: 'DejaVu Sans', Arial, sans-serif; fill: #222 }}\n"
      ".title {{ font-size: 15px; font-weight: bold }}\n"
      ".label {{ font-size: 13px }}\n"
      ".tick {{ font-size: 12px }}\n"
      ".small {{ font-size: 11px; fill: #444 }}\n"
      ".middle {{ text-anchor: middle }}\n"
      ".end {{ text-anchor: end }}\n"
      ".band {{ stroke-width: 0.4; stroke-linejoin: round }}\n"
      ".solid {{ stroke-width: 0.8; stroke-linejoin: round }}\n"
      ".solid path {{ fill: currentColor; stroke: currentColor }}\n"
      ".thin {{ fill: none; stroke: #222; stroke-width: 1 }}\n"
      ".mesh {{ stroke: #222; stroke-width: 0.35; stroke-opacity: 0.45; stroke-linejoin: round }}\n"
      ".face {{ stroke: #5b1a0a; stroke-width: 0.5; stroke-linejoin: round }}\n"
      ".crack {{ fill: none; stroke: #000; stroke-width: 2 }}\n"
      ".halo {{ fill: none; stroke: #fff; stroke-width: 4; stroke-opacity: 0.8 }}\n"
      ".dashes {{ fill: none; stroke: #222; stroke-width: 1.2; stroke-dasharray: 6 4 }}\n"
      ".centre {{ fill: none; stroke: #222; stroke-width: 0.8; stroke-dasharray: 14 4 3 4 }}\n"
      ".touch {{ fill: none; stroke: #fff; stroke-width: 1.2 }}\n"
      ".frame {{ fill: none; stroke: #222; stroke-width: 0.8 }}\n"
      ".bar {{ fill: #222 }}\n"
      "</style>\n"
      "<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"white\"/>\n{4}</svg>\n",
      width_, height_, svg_text(title_), svg_text(description), body_);
}

}  // namespace strainwave::fe_study
