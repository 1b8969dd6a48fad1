// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "strainwave/core/units.hpp"
#include "strainwave/layouts/torsion.hpp"
#include "strainwave/layouts/words.hpp"

namespace strainwave {
namespace {

/// Forces over the angle from the nearest lobe.  Neighbours are joined by a line; the contacts of
/// each lobe have a line of their own.
/// @param pitch  angle between neighbours [rad]
PlotSeries forces_of(std::string label, std::span<const ContactForce> contacts, double pitch,
                     int lobes) {
  const double spacing = 2 * std::numbers::pi / lobes;
  std::vector<std::tuple<long, double, double>> sorted;  // lobe, angle from it, force
  for (const ContactForce& contact : contacts) {
    const long lobe = std::lround(contact.position / spacing);
    sorted.emplace_back(lobe % lobes, contact.position - static_cast<double>(lobe) * spacing,
                        contact.force);
  }
  std::ranges::sort(sorted);
  const DisplayUnit angle = display_unit({}, "rad");
  const DisplayUnit newton = display_unit({}, "N");
  PlotSeries series{.label = std::move(label)};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto& [lobe, at, force] = sorted[i];
    const bool neighbours = i > 0 && std::get<0>(sorted[i - 1]) == lobe &&
                            at - std::get<1>(sorted[i - 1]) < 1.5 * pitch;
    if (i > 0 && !neighbours) {
      series.x.push_back(std::numeric_limits<double>::quiet_NaN());
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    series.x.push_back(at / angle.in_si);
    series.y.push_back(force / newton.in_si);
  }
  return series;
}

/// Forces of balls and of flanks, each at the least torque of the curve, at T1 and at T2.
std::vector<PlotPanel> force_panels(const TorsionReport& report, const GearSet& gear) {
  const std::string angle =
      axis_label("angle from the nearest lobe, toward +θ", display_unit({}, "rad"));
  const std::string force = axis_label("force", display_unit({}, "N"));
  PlotPanel balls{
      .title = "Forces of the balls", .subtitle = "T > 0", .x_label = angle, .y_label = force};
  PlotPanel flanks{
      .title = "Forces of the flanks", .subtitle = "T > 0", .x_label = angle, .y_label = force};
  const DisplayUnit shown = display_unit({}, "N*m");
  const double turn = 2 * std::numbers::pi;
  for (const double torque : {0.0, report.torques.T1, report.torques.T2}) {
    const CurvePoint& p = *std::ranges::min_element(
        report.curve.points, {},
        [&](const CurvePoint& of) { return std::abs(of.torque - torque); });
    const std::string at =
        fmt::format("T = {:.3g} {}", p.torque / shown.in_si, typeset_unit(shown.text));
    balls.series.push_back(
        forces_of(at, p.balls, turn / static_cast<double>(p.balls.size()), gear.drive.wave_number));
    const double pitch = turn / report.curve.teeth;
    flanks.series.push_back(forces_of(at, p.drive_flanks, pitch, gear.drive.wave_number));
    if (!p.coast_flanks.empty())
      flanks.series.push_back(
          forces_of(at + ", coast flanks", p.coast_flanks, pitch, gear.drive.wave_number));
  }
  return {std::move(balls), std::move(flanks)};
}

}  // namespace

std::vector<PlotPanel> torsion_panels(const TorsionReport& report, const GearSet& gear) {
  const DisplayUnit torque = display_unit({}, "N*m");
  const DisplayUnit angle = angle_unit();
  const DisplayUnit stiffness = plotted_stiffness_unit();
  const DisplayUnit makers = stiffness_unit();
  const DisplayUnit turned = display_unit({}, "rad");
  const auto in = [](const DisplayUnit& unit, std::vector<double> values) {
    for (double& value : values) value /= unit.in_si;
    return values;
  };
  const MakersTorques& at = report.torques;
  PlotSeries curve{.label = report.comparison ? "with cracks" : "predicted"};
  PlotSeries sound{.label = "sound"};
  PlotSeries tangent{.label = curve.label};
  PlotSeries tangent_sound{.label = "sound"};
  const auto add = [](PlotSeries& series, double x, double y) {
    series.x.push_back(x);
    series.y.push_back(y);
  };
  for (auto p = report.curve_negative.points.rbegin(); p != report.curve_negative.points.rend();
       ++p)
    add(curve, p->torque / torque.in_si, p->twist / angle.in_si);
  add(curve, 0.0, 0.0);
  const auto add_points = [&](PlotSeries& twist, PlotSeries& tangents, const TorsionCurve& of) {
    for (const CurvePoint& p : of.points) {
      add(twist, p.torque / torque.in_si, p.twist / angle.in_si);
      add(tangents, p.torque / torque.in_si, p.tangent_stiffness() / stiffness.in_si);
    }
  };
  add_points(curve, tangent, report.curve);
  add_points(sound, tangent_sound, report.sound);
  const PlotSeries lines{
      .label = "K1, K2, K3",
      .x = in(torque, {0.0, at.T1, at.T2, at.T3}),
      .y = in(angle, {0.0, report.positive.phi1, report.positive.phi2, report.positive.phi3})};
  const PlotSeries loop{.label = "loop, friction",
                        .x = in(torque, report.loop.torque),
                        .y = in(angle, report.loop.twist)};
  std::vector<PlotPanel> panels;
  panels.push_back(
      {.title = gear.name.empty() ? "Torsion curve" : gear.name,
       .subtitle = fmt::format("K1 = {:.3g}, K2 = {:.3g}, K3 = {:.3g} {}",
                               report.positive.K1 / makers.in_si, report.positive.K2 / makers.in_si,
                               report.positive.K3 / makers.in_si, typeset_unit(makers.text)),
       .x_label = axis_label("torque T at the output", torque),
       .y_label = axis_label("twist φ, input locked", angle),
       .series = {curve, lines, loop}});
  if (report.comparison) panels.back().series.insert(panels.back().series.begin() + 1, sound);
  panels.push_back({.title = "Tangent stiffness",
                    .x_label = axis_label("torque T at the output", torque),
                    .y_label = axis_label("dT/dφ", stiffness),
                    .series = {tangent}});
  if (report.comparison) {
    panels.back().series.push_back(tangent_sound);
    PlotPanel turn{.title = "Change of stiffness over a turn of the wave generator",
                   .subtitle = "T > 0",
                   .x_label = axis_label("wave generator turned by", turned),
                   .y_label = "cracked/sound − 1 [%]"};
    const auto series = [&](const char* label, double LineChanges::*line) {
      PlotSeries s{.label = label};
      for (std::size_t i = 0; i < report.comparison->angles.size(); ++i)
        add(s, report.comparison->angles[i] / turned.in_si,
            100 * report.comparison->positive.at_angle[i].*line);
      return s;
    };
    turn.series = {series("K1", &LineChanges::K1), series("K2", &LineChanges::K2),
                   series("K3", &LineChanges::K3)};
    panels.push_back(std::move(turn));
  }
  for (PlotPanel& panel : force_panels(report, gear)) panels.push_back(std::move(panel));
  return panels;
}

std::string torsion_plot(const TorsionReport& report, const GearSet& gear) {
  return svg_plot(torsion_panels(report, gear));
}

}  // namespace strainwave
