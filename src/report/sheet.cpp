// SPDX-License-Identifier: Apache-2.0
#include "sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "markup.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave::report {
namespace {

constexpr std::array<double, 19> kScales = {1000, 500, 200, 100, 50,   20,   10,   5,     2,    1,
                                            0.5,  0.4, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002};

constexpr std::string_view kSheetStyle =
    ".drawing{font-family:'DejaVu Sans',Arial,sans-serif;stroke-linejoin:round}"
    ".drawing text{font-size:2.9px;fill:var(--ink,#1b1f24);stroke:none}"
    ".drawing .small{font-size:2.5px;fill:var(--muted,#57606a)}"
    ".drawing .middle{text-anchor:middle}"
    ".drawing .end{text-anchor:end}"
    ".drawing .part{fill:var(--part,#f1f4f7);stroke:var(--ink,#1b1f24);stroke-width:.35}"
    ".drawing .solid{stroke:none}"
    ".drawing .edge{fill:none;stroke:var(--ink,#1b1f24);stroke-width:.35}"
    ".drawing .thin{fill:var(--thin,#7d8791)}"
    ".drawing .hatch{fill:none;stroke:var(--hatch,#6e7781);stroke-width:.13}"
    ".drawing .seen{fill:none;stroke:var(--ink,#1b1f24);stroke-width:.25}"
    ".drawing .ball{fill:var(--paper,#fff);stroke:var(--ink,#1b1f24);stroke-width:.3}"
    ".drawing .sketched{fill:none;stroke:var(--muted,#57606a);stroke-width:.2;"
    "stroke-dasharray:1.4 .8}"
    ".drawing .axis{fill:none;stroke:var(--muted,#57606a);stroke-width:.18;"
    "stroke-dasharray:6 1 1 1}"
    ".drawing .leader{fill:none;stroke:var(--muted,#57606a);stroke-width:.15}"
    ".drawing .dot{fill:var(--muted,#57606a)}"
    ".drawing .arrow{fill:none;stroke:var(--ink,#1b1f24);stroke-width:.3}"
    ".drawing .bar{fill:var(--ink,#1b1f24)}"
    ".drawing .mark{fill:var(--paper,#fff);stroke:var(--ink,#1b1f24);stroke-width:.2}"
    ".drawing .crack{fill:var(--crack,#d1242f);fill-opacity:.6;"
    "stroke:var(--crack,#d1242f);stroke-width:.25}"
    ".drawing .crack.open{fill:none;stroke-width:.4}"
    ".drawing .crack-leader{fill:none;stroke:var(--crack,#d1242f);stroke-width:.15}"
    ".drawing .crack-mark{fill:var(--paper,#fff);stroke:var(--crack,#d1242f);stroke-width:.3}"
    ".drawing .inset{fill:var(--paper,#fff);stroke:var(--crack,#d1242f);stroke-width:.25}";

std::string path_data(const Polygon& points, bool closed) {
  std::string d;
  for (const Point& p : points)
    d += fmt::format("{}{} {}", d.empty() ? "M" : "L", coordinate(p.x), coordinate(p.y));
  return closed ? d + "Z" : d;
}

/// The parts of lines of one direction, `spacing` apart, that lie inside a polygon.
std::string hatch_data(const Polygon& outline, const Hatch& hatch) {
  const double angle = hatch.angle * units::deg;
  const Point along{std::cos(angle), -std::sin(angle)};
  const Point across{std::sin(angle), std::cos(angle)};
  const auto height = [&](const Point& p) { return p.x * across.x + p.y * across.y; };
  const auto place = [&](const Point& p) { return p.x * along.x + p.y * along.y; };
  double least = height(outline.front());
  double most = least;
  for (const Point& p : outline) {
    least = std::min(least, height(p));
    most = std::max(most, height(p));
  }
  std::string d;
  // Shift by half a spacing, so no line runs along an edge of a part that starts at zero.
  for (double h = (std::floor(least / hatch.spacing) + 0.5) * hatch.spacing; h < most;
       h += hatch.spacing) {
    std::vector<double> cuts;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point& a = outline[i];
      const Point& b = outline[(i + 1) % outline.size()];
      const double ha = height(a) - h;
      const double hb = height(b) - h;
      if ((ha < 0) == (hb < 0)) continue;
      cuts.push_back(std::lerp(place(a), place(b), ha / (ha - hb)));
    }
    std::ranges::sort(cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2)
      d += fmt::format("M{} {}L{} {}", coordinate(cuts[i] * along.x + h * across.x),
                       coordinate(cuts[i] * along.y + h * across.y),
                       coordinate(cuts[i + 1] * along.x + h * across.x),
                       coordinate(cuts[i + 1] * along.y + h * across.y));
  }
  return d;
}

}  // namespace

Polygon rectangle(double x1, double y1, double x2, double y2) {
  return {{x1, y1}, {x2, y1}, {x2, y2}, {x1, y2}};
}

double drawing_scale(double real, double paper) {
  for (const double scale : kScales)
    if (real / units::mm * scale <= paper) return scale;
  return kScales.back();
}

std::string scale_text(double scale) {
  return scale >= 1 ? fmt::format("{:g}:1", scale) : fmt::format("1:{:g}", 1 / scale);
}

Point Sheet::paper(Point real) const {
  return {origin_.x + paper(real.x), origin_.y - paper(real.y)};
}

double Sheet::paper(double real) const { return real / units::mm * scale_; }

void Sheet::part(std::string_view id, const Polygon& outline, const Hatch& hatch, double thin) {
  constexpr double kThin = 0.8;  // [mm] on paper
  Polygon on_paper;
  for (const Point& p : outline) on_paper.push_back(paper(p));
  const bool filled = paper(thin) < kThin;
  // A solid part continues beyond the axis, so do not draw an edge there.
  std::size_t axis = outline.size();
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (outline[i].y == 0 && outline[(i + 1) % outline.size()].y == 0) axis = i;
  body_ += fmt::format("<path data-part=\"{}\" class=\"part{}{}\" d=\"{}\"/>\n", id,
                       filled ? " thin" : "", axis < outline.size() ? " solid" : "",
                       path_data(on_paper, true));
  if (axis < outline.size()) {
    std::rotate(on_paper.begin(), on_paper.begin() + static_cast<std::ptrdiff_t>(axis) + 1,
                on_paper.end());
    body_ += fmt::format("<path class=\"edge\" d=\"{}\"/>\n", path_data(on_paper, false));
  }
  if (!filled && hatch.spacing > 0) hatch_on_paper(on_paper, hatch);
}

void Sheet::hatch_on_paper(const Polygon& outline, const Hatch& hatch) {
  body_ += fmt::format("<path class=\"hatch\" d=\"{}\"/>\n", hatch_data(outline, hatch));
}

void Sheet::outline(std::string_view id, const Polygon& outline, std::string_view style) {
  Polygon on_paper;
  for (const Point& p : outline) on_paper.push_back(paper(p));
  body_ += fmt::format("<path data-part=\"{}\" class=\"{}\" d=\"{}\"/>\n", id, style,
                       path_data(on_paper, true));
}

void Sheet::line(Point from, Point to, std::string_view style) {
  paper_line(paper(from), paper(to), style);
}

void Sheet::curve(const Polygon& points, std::string_view style) {
  Polygon on_paper;
  for (const Point& p : points) on_paper.push_back(paper(p));
  body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, path_data(on_paper, false));
}

void Sheet::circle(std::string_view id, Point centre, double radius, std::string_view style) {
  const Point at = paper(centre);
  body_ += fmt::format("<circle data-part=\"{}\" class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", id,
                       style, coordinate(at.x), coordinate(at.y), coordinate(paper(radius)));
}

void Sheet::crack(std::string_view path, const Polygon& shape, bool closed) {
  Polygon on_paper;
  for (const Point& p : shape) on_paper.push_back(paper(p));
  body_ += fmt::format("<path data-crack=\"{}\" class=\"crack{}\" d=\"{}\"/>\n", path,
                       closed ? "" : " open", path_data(on_paper, closed));
}

void Sheet::paper_line(Point from, Point to, std::string_view style) {
  body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, path_data({from, to}, false));
}

void Sheet::words(Point at, std::string_view text, std::string_view style) {
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\">{}</text>\n", coordinate(at.x),
                       coordinate(at.y), style, escaped(text));
}

void Sheet::balloon(Point at, std::string_view text, std::string_view style) {
  body_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"2.5\"/>\n", style,
                       coordinate(at.x), coordinate(at.y));
  words({at.x, at.y + 1.05}, text, "middle");
}

void Sheet::scale_bar(Point at, double longest) {
  const DisplayUnit unit = display_unit({}, "m");
  const double fits = std::log10(longest / (paper(1.0) * unit.in_si));
  const double decade = std::pow(10.0, std::floor(fits + 1e-9));
  double number = decade;  // [unit]
  for (const double digit : {2.0, 5.0})
    if (paper(decade * digit * unit.in_si) <= longest * (1 + 1e-9)) number = decade * digit;
  const double length = number * unit.in_si;  // [m]
  const double half = paper(length) / 2;
  body_ += fmt::format(
      "<g data-bar-mm=\"{:g}\"><path class=\"bar\" d=\"{}\"/><path class=\"mark\" d=\"{}\"/></g>\n",
      length / units::mm, path_data(rectangle(at.x, at.y, at.x + half, at.y + 1), true),
      path_data(rectangle(at.x + half, at.y, at.x + 2 * half, at.y + 1), true));
  words({at.x, at.y + 4}, "0", "small middle");
  words({at.x + 2 * half, at.y + 4}, fmt::format("{:g} {}", number, unit.text), "small middle");
}

std::string Sheet::svg(std::string_view id, Point size, std::string_view title,
                       std::string_view description) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" id=\"{0}\" class=\"drawing\" viewBox=\"0 0 {1} "
      "{2}\" width=\"{1}mm\" height=\"{2}mm\" role=\"img\" aria-labelledby=\"{0}-title "
      "{0}-desc\" data-scale=\"{3}\">\n<title id=\"{0}-title\">{4}</title>\n<desc "
      "id=\"{0}-desc\">{5}</desc>\n<style>{6}</style>\n{7}</svg>\n",
      id, coordinate(size.x), coordinate(size.y), scale_, escaped(title), escaped(description),
      kSheetStyle, body_);
}

std::vector<double> spread(std::span<const double> wanted, double spacing, double from, double to) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wanted[i]; });
  // Marks that would overlap form a block round the mean of their wanted places.
  struct Block {
    double first = 0.0;  // place of its first mark
    std::size_t n = 0;
  };
  std::vector<Block> blocks;
  const auto end = [&](const Block& block) {
    return block.first + spacing * static_cast<double>(block.n);
  };
  for (const std::size_t i : order) {
    blocks.push_back({wanted[i], 1});
    while (blocks.size() > 1 && end(blocks[blocks.size() - 2]) > blocks.back().first) {
      const Block last = blocks.back();
      blocks.pop_back();
      Block& block = blocks.back();
      const auto n = static_cast<double>(block.n);
      const auto m = static_cast<double>(last.n);
      // The wanted place of each mark, referred to the first place of the joined block.
      block.first = (n * block.first + m * (last.first - n * spacing)) / (n + m);
      block.n += last.n;
    }
  }
  std::vector<double> places;
  for (const Block& block : blocks)
    for (std::size_t k = 0; k < block.n; ++k)
      places.push_back(block.first + spacing * static_cast<double>(k));
  double last = to;
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    *place = std::min(*place, last);
    last = *place - spacing;
  }
  double next = from;
  for (double& place : places) {
    place = std::max(place, next);
    next = place + spacing;
  }
  std::vector<double> result(wanted.size());
  for (std::size_t k = 0; k < order.size(); ++k) result[order[k]] = places[k];
  return result;
}

}  // namespace strainwave::report
