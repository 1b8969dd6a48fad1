// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "layout.hpp"
#include "markup.hpp"
#include "sheet.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

using namespace report;

constexpr double kLength = 120;  // largest length of the wall on paper [mm]
constexpr double kLeast = 26;    // least height of the drawn wall [mm]

/// The ends of a straight crack; -theta is upward, as y is.
Polygon ends(Point middle, double half_length, double angle) {
  const double dz = half_length * std::cos(angle);
  const double dy = half_length * std::sin(angle);
  return {{middle.x - dz, middle.y - dy}, {middle.x + dz, middle.y + dy}};
}

void arrow(Sheet& sheet, Point from, Point to) {
  sheet.paper_line(from, to, "arrow");
  const double angle = std::atan2(to.y - from.y, to.x - from.x);
  for (const double side : {-0.45, 0.45})
    sheet.paper_line(to, {to.x - 2 * std::cos(angle + side), to.y - 2 * std::sin(angle + side)},
                     "arrow");
}

/// Draws a crack that is too short to be visible, in its own box.
void enlarged(Sheet& sheet, const NumberedCrack& crack, Point corner) {
  const double half_length = crack.place.half_length;
  const double angle = *crack.place.angle;
  constexpr double kMost = 16;
  const double scale = drawing_scale(2 * half_length, kMost);
  sheet.raw(
      fmt::format("<g data-detail=\"{}\" data-scale=\"{}\">\n<rect class=\"inset\" x=\"{}\" "
                  "y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                  crack.path, scale, coordinate(corner.x), coordinate(corner.y),
                  coordinate(kDetailWidth), coordinate(kDetailHeight)));
  sheet.balloon({corner.x + 4, corner.y + 4}, std::to_string(crack.number), "crack-mark");
  sheet.words({corner.x + 8.2, corner.y + 3.6}, fmt::format("enlarged, {}", scale_text(scale)), "");
  sheet.words({corner.x + 8.2, corner.y + 7.0}, "2a = " + in_mm(2 * half_length), "small");
  const Point middle{corner.x + kDetailWidth / 2, corner.y + 20};
  sheet.paper_line({corner.x + 3, middle.y}, {corner.x + kDetailWidth - 3, middle.y}, "axis");
  const double half = half_length / units::mm * scale;
  sheet.raw(fmt::format(
      "<path data-enlarged=\"{}\" class=\"crack open\" d=\"M{} {}L{} {}\"/>\n</g>\n", crack.path,
      coordinate(middle.x - half * std::cos(angle)), coordinate(middle.y + half * std::sin(angle)),
      coordinate(middle.x + half * std::cos(angle)),
      coordinate(middle.y - half * std::sin(angle))));
}

}  // namespace

std::string wall_drawing(const GearSet& gear) {
  std::vector<NumberedCrack> cracks = numbered_cracks(gear);
  std::erase_if(cracks, [](const NumberedCrack& crack) { return !crack.place.angle; });
  if (cracks.empty()) return {};
  const Layout at = layout_of(gear);
  const double length = at.barrel->z2;
  // Make room for every crack beside the others, round the circumference.
  const auto room_of = [&](const NumberedCrack& c) {
    return std::max(2 * c.place.half_length * std::abs(std::sin(*c.place.angle)), 0.16 * length);
  };
  double height = 0.0;
  for (const NumberedCrack& c : cracks) height += room_of(c);
  height *= 1.25;
  const double scale = std::min(drawing_scale(length, kLength), drawing_scale(height, 110));
  const double spare = std::max(0.0, kLeast * units::mm / scale - height);
  height += spare;
  constexpr double kLeft = 18;
  constexpr double kTop = 12;
  Sheet sheet(scale, {kLeft, kTop + height / units::mm * scale});
  const double width_on_paper = sheet.paper(length);
  const double height_on_paper = sheet.paper(height);
  sheet.outline("wall", rectangle(0, 0, length, height), "seen");
  if (at.rim) sheet.line({at.rim->z2, 0}, {at.rim->z2, height}, "seen");
  const double bottom = kTop + height_on_paper;
  if (at.rim) sheet.words({kLeft + 1, bottom - 1.2}, "rim", "small");
  sheet.words({kLeft + sheet.paper(at.barrel->z1) + 1, bottom - 1.2}, at.rim ? "barrel" : "wall",
              "small");
  double y = height - spare / 2;
  std::vector<const NumberedCrack*> small;
  for (const NumberedCrack& c : cracks) {
    const double room = 1.25 * room_of(c);
    const Point middle{ring_of(at, c.place.part).middle(), y - room / 2};
    y -= room;
    sheet.line({middle.x - 0.16 * length, middle.y}, {middle.x + 0.16 * length, middle.y}, "axis");
    sheet.crack(c.path, ends(middle, c.place.half_length, *c.place.angle), false);
    const Point target = sheet.paper(middle);
    const Point mark{kLeft + width_on_paper + 7, target.y};
    sheet.paper_line({mark.x - 2.5, mark.y}, target, "crack-leader");
    sheet.balloon(mark, std::to_string(c.number), "crack-mark");
    if (sheet.paper(2 * c.place.half_length) < kVisible) small.push_back(&c);
  }
  // The sense of T > 0 is +theta on the output's end, which is downward here.
  const double middle_y = kTop + height_on_paper / 2;
  const double half = std::min(8.0, height_on_paper / 2);
  arrow(sheet, {kLeft - 5, middle_y + half}, {kLeft - 5, middle_y - half});
  arrow(sheet, {kLeft + width_on_paper + 2.5, middle_y - half},
        {kLeft + width_on_paper + 2.5, middle_y + half});
  sheet.words({kLeft - 13, middle_y + 1}, "T>0", "small");
  arrow(sheet, {kLeft, 6}, {kLeft + 14, 6});
  sheet.words({kLeft + 16, 7}, "+z, output", "small");
  arrow(sheet, {kLeft - 5, 10}, {kLeft - 5, 3});
  sheet.words({kLeft - 14, 6.5}, "−θ", "small");
  const double x = kLeft + width_on_paper + 14;
  double line = kTop + 3;
  const auto say = [&](const std::string& text) {
    if (x < kPaperWidth - 40) {
      sheet.words({x, line}, text, "small");
      line += 4.2;
    }
  };
  for (const NumberedCrack& c : cracks)
    say(fmt::format("{}: {}2a = {}, β = {:.4g}°", c.number,
                    c.place.count > 1 ? fmt::format("{} cracks, ", c.place.count) : std::string(),
                    in_mm(2 * c.place.half_length), *c.place.angle / units::deg));
  double end = std::max(bottom + 4, line + 2);
  for (std::size_t i = 0; i < small.size(); ++i)
    enlarged(sheet, *small[i], {2 + static_cast<double>(i) * (kDetailWidth + 4), end});
  if (!small.empty()) end += kDetailHeight + 4;
  sheet.scale_bar({4, end}, 40);
  sheet.words({kPaperWidth - 2, end + 1.2},
              fmt::format("wall of the flexspline seen from outside, unrolled; scale {}",
                          scale_text(scale)),
              "small end");
  sheet.words(
      {kPaperWidth - 2, end + 4.8},
      "the file does not give the place of a crack on the wall; length and angle β are to scale",
      "small end");
  return sheet.svg(
      "wall", {kPaperWidth, end + 8}, "Developed wall of the flexspline with its cracks",
      fmt::format("Scale {}; the angle beta is counter-clockwise from +z.", scale_text(scale)));
}

}  // namespace strainwave
