// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "fields_at_load.hpp"
#include "painter.hpp"
#include "strainwave/chart/chart.hpp"
#include "strainwave/fe_study/output_files.hpp"
#include "wall_pictures.hpp"

namespace strainwave::fe_study {
namespace {

using fem::FieldPoint;
using std::numbers::pi;

std::string signed_text(double value) {
  return fmt::format("{}{}", value < 0 ? "" : "+", shown_number(value));
}

// --- sections

using Value = std::function<double(const FieldPoint&)>;

/// Part of a meridian section and its place on paper, with z to the right and r upward.
struct SectionView {
  double z0{}, z1{}, r0{}, r1{};  ///< [m]
  PaperPoint corner{};            ///< upper left [px]
  double scale{};                 ///< px per metre

  [[nodiscard]] double width() const { return scale * (z1 - z0); }
  [[nodiscard]] double height() const { return scale * (r1 - r0); }
  [[nodiscard]] PaperPoint paper(double r, double z) const {
    return {corner.x + scale * (z - z0), corner.y + scale * (r1 - r)};
  }
};

/// The view of a range, as large as the given place on paper allows, at the upper edge of the
/// place.
SectionView fitted(double z0, double z1, double r0, double r1, PaperPoint corner, double width,
                   double height) {
  SectionView view{.z0 = z0, .z1 = z1, .r0 = r0, .r1 = r1};
  view.scale = std::min(width / (z1 - z0), height / (r1 - r0));
  view.corner = {corner.x + (width - view.width()) / 2, corner.y};
  return view;
}

std::string painted(const fem::SampledFields& fields, const SectionView& view,
                    const ValueScale& scale, const Value& value) {
  BandPainter painter(scale);
  for (const fem::FieldCell& cell : fields.cells) {
    PaperPatch patch{
        .divisions = static_cast<std::size_t>(fields.divisions), .points = {}, .values = {}};
    PaperPoint low{1e30, 1e30};
    PaperPoint high{-1e30, -1e30};
    for (const FieldPoint& p : cell.points) {
      const PaperPoint at = view.paper(p.place[0], p.place[2]);
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
      patch.points.push_back(at);
      patch.values.push_back(value(p));
    }
    if (low.x < view.corner.x + view.width() && high.x > view.corner.x &&
        low.y < view.corner.y + view.height() && high.y > view.corner.y)
      painter.patch(patch);
  }
  return painter.svg();
}

std::string frame(const SectionView& view) {
  return fmt::format(
      "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
      view.corner.x, view.corner.y, view.width(), view.height());
}

/// Draws the axes, with z to the right and r upward.
void axes(PictureSheet& sheet, PaperPoint corner) {
  sheet.arrow(corner, {corner.x + 46, corner.y});
  sheet.words({corner.x + 52, corner.y + 4}, "tick", "z");
  sheet.arrow(corner, {corner.x, corner.y - 34});
  sheet.words({corner.x + 6, corner.y - 26}, "tick", "r");
}

/// Radii of a crack from its mouth to its tip.
std::array<double, 2> crack_radii(const gear_fem::ShaftSection& shaft) {
  const gear_fem::ShaftCrack& crack = *shaft.crack;
  return crack.surface == gear_fem::ShaftCrack::Surface::outer
             ? std::array{shaft.outer_diameter / 2, shaft.outer_diameter / 2 - crack.depth}
             : std::array{shaft.inner_diameter / 2, shaft.inner_diameter / 2 + crack.depth};
}

struct ShaftPicture {
  const ShaftCrackRun& run;
  const fem::SampledFields& fields;
  std::vector<std::string> captions;
};

std::string shaft_picture(const ShaftPicture& picture, const ValueScale& scale,
                          const std::string& what, const std::string& quantity,
                          const Value& value) {
  const gear_fem::ShaftSection& shaft = picture.run.section;
  const double outer = shaft.outer_diameter / 2;
  const double inner = shaft.inner_diameter / 2;
  const double z = shaft.crack->position;
  const std::array<double, 2> radii = crack_radii(shaft);
  const double mouth = radii[0];
  const double tip = radii[1];
  const SectionView whole = fitted(0, shaft.length, 0, outer, {24, 110}, 700, 150);
  const double room = std::min(2.2 * shaft.crack->depth, 0.5 * shaft.length);
  const SectionView part =
      fitted(z - room, z + room, std::max(inner, std::min(mouth, tip) - 1.3 * shaft.crack->depth),
             std::min(outer, std::max(mouth, tip) + 1.3 * shaft.crack->depth),
             {24, whole.corner.y + whole.height() + 56}, 700, 300);
  PictureSheet sheet(900, part.corner.y + part.height() + 64);
  sheet.title(picture.run.path + ": " + what, picture.captions);
  const auto crack_line = [&](const SectionView& view, bool halo) {
    const std::array line = {view.paper(mouth, z), view.paper(tip, z)};
    if (halo) sheet.line(line, "halo");
    sheet.line(line, "crack");
  };
  sheet.raw(painted(picture.fields, whole, scale, value));
  const PaperPoint top = whole.paper(outer, 0);
  sheet.raw(fmt::format(
      "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
      top.x, top.y, whole.width(), whole.scale * (outer - inner)));
  crack_line(whole, false);
  const std::array axis = {PaperPoint{whole.corner.x - 10, whole.paper(0, 0).y},
                           PaperPoint{whole.corner.x + whole.width() + 10, whole.paper(0, 0).y}};
  sheet.line(axis, "centre");
  // Frame of the enlarged part.
  const PaperPoint high = whole.paper(part.r1, part.z0);
  const PaperPoint low = whole.paper(part.r0, part.z1);
  sheet.raw(fmt::format(
      "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
      high.x, high.y, low.x - high.x, low.y - high.y));
  sheet.scale_bar({whole.corner.x, whole.corner.y + whole.height() + 16}, whole.scale, 120);
  sheet.begin_clip("window", part.corner, part.width(), part.height());
  sheet.raw(painted(picture.fields, part, scale, value));
  crack_line(part, true);
  sheet.end_clip();
  sheet.raw(frame(part));
  const double below = part.corner.y + part.height();
  sheet.scale_bar({part.corner.x, below + 14}, part.scale, 150);
  sheet.words({part.corner.x, below + 44}, "small",
              "Meridian section above the axis, and enlarged about the crack (black line)");
  axes(sheet, {part.corner.x + part.width() - 66, below + 52});
  sheet.colour_bar({770, 166}, 316, scale, quantity, "singular at the tip");
  return sheet.svg(what + " in the meridian section of a shaft, in colours");
}

/// Plot of K = Y sqrt(pi a), with Y a polynomial through the solved sizes.
std::string over_depth(const ShaftCrackRun& run, const GearSet& gear,
                       const std::vector<std::string>& captions) {
  constexpr int kPoints = 60;
  constexpr double kMPa = 1e6;
  const double depth = run.section.crack->depth;
  PlotPanel panel{.title = fmt::format("{}: stress intensity over depth{}", run.path,
                                       captions.size() > 2 ? "; NOT usable" : ""),
                  .subtitle = captions.front(),
                  .x_label = "depth a [mm]",
                  .y_label = "stress intensity factor K [MPa·√m]"};
  const auto add = [&](const char* name, const std::vector<gear_fem::ShaftCrackSize>& sizes,
                       double fem::TipResult::*K, double load) {
    PlotSeries series{.label = name, .discs = Discs::at_end};
    for (int i = 0; i <= kPoints; ++i) {
      const double share = static_cast<double>(i) / kPoints;
      const double a = depth * share * share;
      double Y = 0.0;
      for (const gear_fem::ShaftCrackSize& one : sizes) {
        double weight = one.tip.*K / std::sqrt(pi * one.depth);
        for (const gear_fem::ShaftCrackSize& other : sizes)
          if (&other != &one) weight *= (a - other.depth) / (one.depth - other.depth);
        Y += weight;
      }
      series.x.push_back(a * 1e3);
      series.y.push_back(load * Y * std::sqrt(pi * a) / kMPa);
    }
    panel.series.push_back(std::move(series));
  };
  add("K_III from the torque", run.result.torsion.sizes, &fem::TipResult::K_III, gear.load.torque);
  if (gear.load.axial_force > 0)
    add("K_I from the force", run.result.tension.sizes, &fem::TipResult::K_I,
        gear.load.axial_force);
  return svg_plot(std::array{panel});
}

void add_shaft(std::vector<OutputFile>& files, const ShaftCrackRun& run, const GearSet& gear) {
  const fem::SampledFields fields = fields_at_load(run, gear);
  const gear_fem::ShaftSection& shaft = run.section;
  double sound = 0.0;
  for (const fem::FieldCell& cell : fields.cells)
    for (const FieldPoint& p : cell.points) sound = std::max(sound, p.energy_density_without_crack);
  std::string load = fmt::format("T = {} N·m", signed_text(gear.load.torque));
  if (gear.load.axial_force != 0)
    load += fmt::format(", P = {} kN{}", signed_text(gear.load.axial_force / 1e3),
                        gear.load.axial_force < 0 ? ", which closes the crack" : "");
  std::vector<std::string> captions = {
      fmt::format("annular crack {} deep in a shaft ∅{}{}; {}", in_mm(shaft.crack->depth),
                  in_mm(shaft.outer_diameter),
                  shaft.inner_diameter > 0 ? fmt::format("/{}", in_mm(shaft.inner_diameter)) : "",
                  load),
      fmt::format("Sound shaft, at its surface: {} J/m³", shown_number(sound))};
  for (const auto* const one : run.result.loads())
    if (!one->usable) captions.push_back("NOT usable: " + one->reason);
  const ShaftPicture picture{run, fields, captions};
  const std::string stem = file_stem(run.path);
  files.push_back(
      {stem + "_energy.svg",
       shaft_picture(picture,
                     {.map = ColourMap::rising, .lower = 0, .upper = round_up(2.4 * sound)},
                     "strain energy density", "w [J/m³]",
                     [](const FieldPoint& p) { return p.energy_density; })});
  const double most = round_up(sound);
  files.push_back(
      {stem + "_added_energy.svg",
       shaft_picture(
           picture, {.map = ColourMap::diverging, .lower = -most, .upper = most, .bands = 21},
           "strain energy density, cracked minus sound", "w − w₀ [J/m³]",
           [](const FieldPoint& p) { return p.energy_density - p.energy_density_without_crack; })});
  files.push_back({stem + "_stress_intensity.svg", over_depth(run, gear, captions)});
}

void add_cup(std::vector<OutputFile>& files, const gear_fem::CupResult& cup, const GearSet& gear) {
  const fem::SampledFields fields = fields_at_load(cup, gear);
  double z0 = 1e30;
  double z1 = -1e30;
  double r1 = 0.0;
  for (const fem::FieldCell& cell : fields.cells)
    for (const FieldPoint& p : cell.points) {
      z0 = std::min(z0, p.place[2]);
      z1 = std::max(z1, p.place[2]);
      r1 = std::max(r1, p.place[0]);
    }
  const SectionView view = fitted(z0, z1, 0, r1, {34, 90}, 680, 420);
  const Value value = [](const FieldPoint& p) { return p.energy_density; };
  // Corners are singular, so the scale covers nine tenths of the points.
  std::vector<double> values;
  for (const fem::FieldCell& cell : fields.cells)
    for (const FieldPoint& p : cell.points) values.push_back(p.energy_density);
  const auto tenth = static_cast<std::ptrdiff_t>(values.size() / 10);
  std::ranges::nth_element(values, values.end() - tenth - 1);
  const ValueScale scale{
      .map = ColourMap::rising, .lower = 0, .upper = round_up(*(values.end() - tenth - 1))};
  std::string parts;
  for (const gear_fem::CupPart& part : cup.parts)
    parts += fmt::format("{}{} {:.1f} %", parts.empty() ? "" : ", ", part.name, 100 * part.share);
  std::vector<std::string> captions = {fmt::format("T = {} N·m; shares of the compliance: {}",
                                                   signed_text(gear.load.torque), parts)};
  if (!cup.usable) captions.push_back("NOT usable: " + cup.reason);
  PictureSheet sheet(900, view.corner.y + view.height() + 64);
  sheet.title("flexspline: strain energy density of the sound cup", captions);
  sheet.raw(painted(fields, view, scale, value));
  const double axis = view.paper(0, 0).y;
  sheet.line(std::array{PaperPoint{view.corner.x - 10, axis},
                        PaperPoint{view.corner.x + view.width() + 10, axis}},
             "centre");
  sheet.scale_bar({view.corner.x, axis + 14}, view.scale, 150);
  sheet.words({view.corner.x, axis + 44}, "small", "Meridian section above the axis");
  axes(sheet, {view.corner.x + view.width() - 66, axis + 52});
  sheet.colour_bar({770, 150}, 316, scale, "w [J/m³]", "higher at sharp corners");
  files.push_back(
      {.name = "flexspline_energy.svg",
       .text = sheet.svg("Strain energy density in the meridian section of a cup, in colours")});
}

double in_degrees(double angle) { return std::round(1e6 * angle * 180 / pi) / 1e6; }

DrawnTube drawn(const TubeSection& tube, double from) {
  const double outer = tube.outer_diameter / 2;
  return {.inner_radius = outer - tube.wall_thickness,
          .outer_radius = outer,
          .from = from,
          .to = from + tube.length};
}

void describe(CrackedWall& wall, const gear_fem::TubeWithThroughCrack& tube) {
  const gear_fem::BarrelEnds& ends = tube.ends;
  if (ends.any()) wall.body = "cup's barrel";
  if (ends.diaphragm) wall.outline.front().from = -ends.diaphragm->thickness;
  if (ends.rim) wall.outline.push_back(drawn(*ends.rim, tube.length));
  wall.description = fmt::format("through crack 2a = {} at {}° from the generator, wall {}",
                                 in_mm(2 * tube.half_length), shown_number(in_degrees(tube.angle)),
                                 in_mm(tube.wall_thickness));
  wall.front_names = {"upper tip", "lower tip"};
  wall.along = "through the wall, from the inner face";
}

void describe(CrackedWall& wall, const gear_fem::TubeWithSurfaceCrack& tube) {
  wall.inside = tube.surface == gear_fem::TubeWithSurfaceCrack::Surface::inner;
  wall.description = fmt::format(
      "surface crack a = {}, 2c = {} at {}° from the generator, {} face, wall {}",
      in_mm(tube.depth), in_mm(2 * tube.half_length), shown_number(in_degrees(tube.angle)),
      wall.inside ? "inner" : "outer", in_mm(tube.wall_thickness));
  wall.front_names = {"front"};
  wall.along = "along the front, from its upper end";
  wall.corners = true;
}

/// Pictures for the sense of torque that releases more energy.
template <class Run>
void add_wall(std::vector<OutputFile>& files, const Run& run) {
  const auto& tube = run.tube;
  const bool positive = run.positive.energy_release_rate >= run.negative.energy_release_rate;
  const auto& shown = positive ? run.positive : run.negative;
  CrackedWall wall{.path = run.path,
                   .description = {},
                   .mean_radius = tube.mean_radius,
                   .wall_thickness = tube.wall_thickness,
                   .length = tube.length,
                   .body = "tube",
                   .outline = {{.inner_radius = tube.mean_radius - tube.wall_thickness / 2,
                                .outer_radius = tube.mean_radius + tube.wall_thickness / 2,
                                .from = 0,
                                .to = tube.length}},
                   .place = tube.place == 0 ? tube.length / 2 : tube.place,
                   .half_length = tube.half_length,
                   .angle = tube.angle,
                   .torque = positive ? tube.torque : -tube.torque,
                   .state = std::string(shown.faces()),
                   .closed = shown.closed,
                   .fault = shown.reason,
                   .solid = &shown.solid,
                   .front_names = {},
                   .along = {}};
  describe(wall, tube);
  const std::vector<OutputFile> pictures = wall_pictures(wall);
  files.insert(files.end(), pictures.begin(), pictures.end());
}

}  // namespace

std::vector<OutputFile> pictures(const RunResult& result, const GearSet& gear) {
  std::vector<OutputFile> files;
  for (const ShaftCrackRun& crack : result.output_shaft.cracks) add_shaft(files, crack, gear);
  if (result.flexspline.sound) add_cup(files, *result.flexspline.sound, gear);
  for (const WallCrackRun& crack : result.flexspline.cracks)
    std::visit([&](const auto& one) { add_wall(files, one); }, crack);
  return files;
}

}  // namespace strainwave::fe_study
