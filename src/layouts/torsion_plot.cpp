// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "strainwave/core/units.hpp"
#include "strainwave/layouts/torsion.hpp"
#include "strainwave/layouts/words.hpp"

namespace strainwave {

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
  return panels;
}

std::string torsion_plot(const TorsionReport& report, const GearSet& gear) {
  return svg_plot(torsion_panels(report, gear));
}

}  // namespace strainwave
