// SPDX-License-Identifier: Apache-2.0
#include "layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "markup.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave::report {
namespace {

// Proportions of sketched parts; they only serve recognition.
constexpr double kSketchedFace = 0.16;        // face width per pitch diameter
constexpr double kSketchedSpline = 1.34;      // outer diameter of the circular spline, as above
constexpr double kSketchedToothRoot = 1.021;  // its inner diameter, as above
constexpr double kSketchedTooth = 1.35;       // height per module

void place_flexspline(const GearSet& gear, Layout& at) {
  const Flexspline& fs = *gear.flexspline;
  const double tip = gear.drive.pitch_diameter / 2;
  if (fs.crack_free == CrackFree::factor) {
    const double length = fs.tube_length();
    const double wall = fs.ring_thickness();
    at.barrel = Ring{0, length, tip - wall, tip};
    at.teeth_width = std::min(kSketchedFace * gear.drive.pitch_diameter, 0.4 * length);
    if (fs.shape == FlexsplineShape::cup) {
      at.bottom = Ring{length - wall, length, 0.45 * tip, at.barrel->inner, false};
      at.bottom_outline = at.bottom->polygon();
    }
    at.end = length;
    return;
  }
  const auto tube = [](const TubeSection& section, double from) {
    const double outer = section.outer_diameter / 2;
    return Ring{from, from + section.length, outer - section.wall_thickness, outer};
  };
  if (fs.rim) at.rim = tube(*fs.rim, 0);
  at.teeth_width =
      at.rim ? at.rim->z2
             : std::min(kSketchedFace * gear.drive.pitch_diameter, 0.4 * fs.tube_length());
  at.barrel = tube(*fs.barrel, at.rim ? at.rim->z2 : 0);
  at.end = at.barrel->z2;
  if (fs.diaphragm) {
    // The outer side is flat; the thickness extends inward.
    const Diaphragm& plate = *fs.diaphragm;
    const double inner = plate.inner_diameter / 2;
    const double outer = plate.outer_diameter / 2;
    std::vector<double> radii = {inner};
    for (const DiaphragmStation& station : plate.profile)
      if (station.radius > inner && station.radius < outer) radii.push_back(station.radius);
    radii.push_back(outer);
    at.bottom = Ring{at.end, at.end, inner, outer};
    at.bottom_outline = {{at.end, inner}, {at.end, outer}};
    for (auto r = radii.rbegin(); r != radii.rend(); ++r) {
      const double z = at.end - diaphragm_thickness(plate, *r);
      at.bottom_outline.push_back({z, *r});
      at.bottom->z1 = std::min(at.bottom->z1, z);
    }
  }
  if (fs.boss) {
    at.boss = tube(*fs.boss, at.bottom ? at.bottom->z1 : at.end);
    at.end = std::max(at.end, at.boss->z2);
  }
}

void place_wave_generator(const GearSet& gear, Layout& at) {
  const WaveGenerator& wg = *gear.wave_generator;
  const double middle = at.teeth_middle();
  const auto across = [&](double width, double inner, double outer, bool given) {
    return Ring{middle - width / 2, middle + width / 2, inner, outer, given};
  };
  const double bore = at.rim      ? at.rim->inner
                      : at.barrel ? at.barrel->inner
                                  : gear.drive.pitch_diameter / 2;
  const double width = wg.bearing && wg.bearing->outer_ring
                           ? wg.bearing->outer_ring->width
                           : wg.inner_ring_width.value_or(0.96 * at.teeth_width);
  const bool width_given = wg.inner_ring_width || (wg.bearing && wg.bearing->outer_ring);
  const double thickness = wg.inner_ring_thickness.value_or(0.025 * gear.drive.pitch_diameter);
  double outer_inside = 0.0;  // radius of the outer raceway
  double race = 0.0;          // radius of the inner raceway
  if (wg.bearing) {
    const Bearing& bearing = *wg.bearing;
    race = bearing.inner_raceway_diameter / 2;
    outer_inside = bearing.outer_raceway_diameter / 2;
    at.ball_diameter = bearing.ball_diameter;
    at.ball_given = true;
    if (bearing.outer_ring)
      at.outer_ring =
          across(width, bearing.outer_ring->mean_radius - bearing.outer_ring->thickness / 2,
                 bearing.outer_ring->mean_radius + bearing.outer_ring->thickness / 2, true);
    else
      at.outer_ring = across(width, outer_inside, std::max(bore, outer_inside * 1.02), false);
  } else {
    at.ball_diameter = std::min(1.2 * thickness, 0.12 * bore);
    const double ring = std::min(0.6 * thickness, 0.06 * bore);
    outer_inside = bore - ring;
    race = outer_inside - at.ball_diameter;
    at.outer_ring = across(width, outer_inside, bore, false);
  }
  at.ball_radius = (race + outer_inside) / 2;
  const double mean = wg.inner_ring_mean_radius.value_or(race - thickness / 2);
  const double inner_width = wg.inner_ring_width.value_or(width);
  at.inner_ring =
      across(inner_width, mean - thickness / 2, mean + thickness / 2,
             wg.inner_ring_thickness.has_value() && width_given && wg.bearing.has_value());
  at.cam = across(inner_width, 0.3 * at.inner_ring->inner, at.inner_ring->inner, false);
  at.end = std::max({at.end, at.outer_ring->z2, at.inner_ring->z2});
}

}  // namespace

Layout layout_of(const GearSet& gear) {
  Layout at;
  const double pitch = gear.drive.pitch_diameter;
  at.teeth_width = kSketchedFace * pitch;
  if (gear.circular_spline) at.teeth_width = gear.circular_spline->width;
  if (gear.flexspline) place_flexspline(gear, at);
  if (gear.wave_generator) place_wave_generator(gear, at);
  at.tooth_height = kSketchedTooth * pitch / (gear.drive.wave_number * gear.drive.ratio);
  at.tooth_root = at.rim ? at.rim->outer : at.barrel ? at.barrel->outer : pitch / 2;
  const double middle = at.teeth_middle();
  if (gear.circular_spline) {
    const CircularSpline& cs = *gear.circular_spline;
    at.circular_spline = Ring{middle - cs.width / 2, middle + cs.width / 2, cs.inner_diameter / 2,
                              cs.outer_diameter / 2};
  } else if (gear.flexspline) {
    at.circular_spline =
        Ring{0, at.teeth_width, kSketchedToothRoot * pitch / 2, kSketchedSpline * pitch / 2, false};
  }
  if (gear.output_shaft) {
    const OutputShaft& shaft = *gear.output_shaft;
    at.shaft =
        Ring{at.end, at.end + shaft.length, shaft.inner_diameter / 2, shaft.outer_diameter / 2};
    at.end = at.shaft->z2;
  }
  for (const auto& ring :
       {at.outer_ring, at.rim, at.barrel, at.circular_spline, at.shaft, at.boss}) {
    if (!ring) continue;
    at.top = std::max(at.top, ring->outer);
    at.end = std::max(at.end, ring->z2);
  }
  return at;
}

const Ring& ring_of(const Layout& layout, CrackedPart part) {
  switch (part) {
    case CrackedPart::inner_ring:
      return *layout.inner_ring;
    case CrackedPart::outer_ring:
      return *layout.outer_ring;
    case CrackedPart::circular_spline:
      return *layout.circular_spline;
    case CrackedPart::output_shaft:
      return *layout.shaft;
    default:
      return part == CrackedPart::rim && layout.rim ? *layout.rim : *layout.barrel;
  }
}

Polygon semi_ellipse(Point at, double half, double depth, Point into) {
  constexpr int kSteps = 32;
  Polygon points;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = std::numbers::pi * i / kSteps;
    const double along = half * std::cos(t);
    const double down = depth * std::sin(t);
    // The surface runs perpendicular to the direction into the material.
    points.push_back(
        {at.x + along * into.y + down * into.x, at.y - along * into.x + down * into.y});
  }
  return points;
}

void draw_detail(Sheet& sheet, const Detail& detail, Point corner) {
  constexpr double kTop = 8.5;      // space for the title above
  constexpr double kSide = 3;       // free space on each side
  constexpr double kDepth = 12;     // largest depth of the crack
  constexpr double kWallMost = 19;  // largest thickness of the visible wall
  double scale = drawing_scale(detail.depth, kDepth);
  if (detail.shape == Detail::Shape::ellipse)
    scale = std::min(scale, drawing_scale(2 * detail.half, kDetailWidth - 4 * kSide));
  const auto on_paper = [&](double real) { return real / units::mm * scale; };
  sheet.raw(fmt::format("<g data-detail=\"{}\" data-scale=\"{}\">\n", detail.path, scale));
  sheet.raw(fmt::format("<rect class=\"inset\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                        coordinate(corner.x), coordinate(corner.y), coordinate(kDetailWidth),
                        coordinate(kDetailHeight)));
  sheet.balloon({corner.x + 4, corner.y + 4}, std::to_string(detail.number), "crack-mark");
  sheet.words({corner.x + 8.2, corner.y + 3.6}, fmt::format("enlarged, {}", scale_text(scale)), "");
  sheet.words({corner.x + 8.2, corner.y + 7.0}, "a = " + in_mm(detail.depth), "small");
  const double left = corner.x + kSide;
  const double right = corner.x + kDetailWidth - kSide;
  const double surface = corner.y + kTop + 1.5;
  const double wall = std::min(on_paper(detail.wall), kWallMost);
  const bool whole = on_paper(detail.wall) <= kWallMost;
  const Polygon piece = rectangle(left, surface, right, surface + wall);
  sheet.hatch_on_paper(piece, {.angle = 45, .spacing = 2});
  sheet.paper_line({left, surface}, {right, surface}, "seen");
  if (whole) sheet.paper_line({left, surface + wall}, {right, surface + wall}, "seen");
  const Point middle{(left + right) / 2, surface};
  const double depth = on_paper(detail.depth);
  const double most = (right - left) / 2;
  Polygon shape;
  switch (detail.shape) {
    case Detail::Shape::ellipse:
      shape = semi_ellipse(middle, on_paper(detail.half), depth, {0, 1});
      break;
    case Detail::Shape::rectangle: {
      const double half = std::min(on_paper(detail.half), most);
      shape = rectangle(middle.x - half, surface, middle.x + half, surface + depth);
      break;
    }
    case Detail::Shape::line:
      shape = {middle, {middle.x, surface + depth}};
      break;
  }
  std::string d;
  for (const Point& p : shape)
    d += fmt::format("{}{} {}", d.empty() ? "M" : "L", coordinate(p.x), coordinate(p.y));
  sheet.raw(fmt::format("<path data-enlarged=\"{}\" class=\"crack{}\" d=\"{}{}\"/>\n</g>\n",
                        detail.path, detail.shape == Detail::Shape::line ? " open" : "", d,
                        detail.shape == Detail::Shape::line ? "" : "Z"));
}

}  // namespace strainwave::report

namespace strainwave {
namespace {

using report::in_mm;

std::string degrees(double angle) {
  const std::string text = fmt::format("{:.4g}°", std::abs(angle) / units::deg);
  return angle < 0 ? "−" + text : text;
}
std::string size_of(const CrackPlace& at) {
  const std::string depth = "a = " + in_mm(at.depth);
  switch (at.shape) {
    case CrackShape::semi_ellipse:
      return depth + ", 2c = " + in_mm(2 * at.half_length);
    case CrackShape::over_width:
      return depth + ", over the width";
    case CrackShape::all_round:
      return depth + ", all round";
    case CrackShape::through:
      return "2a = " + in_mm(2 * at.half_length);
    case CrackShape::groove:
      return in_mm(at.depth) + " deep, " + in_mm(2 * at.half_length) + " wide";
    case CrackShape::whole:
      break;
  }
  return fmt::format("{:.3g} % of the pair's stiffness lost", 100 * at.stiffness_loss);
}

std::string size_and_place(const CrackPlace& at) {
  std::string text = size_of(at);
  if (at.count > 1) text = fmt::format("{} cracks, each {}", at.count, text);
  if (at.angle)
    text += ", β = " + degrees(*at.angle) + (at.part == CrackedPart::rim ? ", rim" : ", barrel");
  if (at.part == CrackedPart::diaphragm)
    text += at.radius ? " at radius " + in_mm(*at.radius) : " round the boss";
  if (at.position) text += " at " + degrees(*at.position) + " from the major axis";
  return text;
}

}  // namespace

std::vector<NumberedCrack> numbered_cracks(const GearSet& gear) {
  std::vector<NumberedCrack> cracks;
  for_each_crack(gear, [&]<class Crack>(const std::string& path, const Crack& crack) {
    cracks.push_back({.number = static_cast<int>(cracks.size()) + 1,
                      .path = path,
                      .kind = std::string(Crack::kKind),
                      .place = crack.place(),
                      .size = size_and_place(crack.place())});
  });
  return cracks;
}

}  // namespace strainwave
