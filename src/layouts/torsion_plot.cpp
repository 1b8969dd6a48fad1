// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "strainwave/core/units.hpp"
#include "strainwave/layouts/torsion.hpp"

namespace strainwave {

std::vector<PlotPanel> torsion_panels(const TorsionReport& report, const GearSet& gear) {
  const auto in_arcmin = [](std::vector<double> values) {
    for (double& value : values) value /= units::arcmin;
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
    add(curve, p->torque, p->twist / units::arcmin);
  add(curve, 0.0, 0.0);
  for (const CurvePoint& p : report.curve.points) {
    add(curve, p.torque, p.twist / units::arcmin);
    add(tangent, p.torque, units::arcmin / p.tangent_compliance);
  }
  for (const CurvePoint& p : report.sound.points) {
    add(sound, p.torque, p.twist / units::arcmin);
    add(tangent_sound, p.torque, units::arcmin / p.tangent_compliance);
  }
  const PlotSeries lines{
      .label = "K1, K2, K3",
      .x = {0.0, at.T1, at.T2, at.T3},
      .y = in_arcmin({0.0, report.positive.phi1, report.positive.phi2, report.positive.phi3})};
  const PlotSeries loop{
      .label = "loop, friction", .x = report.loop.torque, .y = in_arcmin(report.loop.twist)};
  std::vector<PlotPanel> panels;
  panels.push_back(
      {.title = gear.name.empty() ? "Torsion curve" : gear.name,
       .subtitle = fmt::format("K1 = {:.3g}, K2 = {:.3g}, K3 = {:.3g} N·m/rad", report.positive.K1,
                               report.positive.K2, report.positive.K3),
       .x_label = "torque T at the output [N·m]",
       .y_label = "twist φ, input locked [arcmin]",
       .series = {curve, lines, loop}});
  if (report.comparison) panels.back().series.insert(panels.back().series.begin() + 1, sound);
  panels.push_back({.title = "Tangent stiffness",
                    .x_label = "torque T at the output [N·m]",
                    .y_label = "dT/dφ [N·m/arcmin]",
                    .series = {tangent}});
  if (report.comparison) {
    panels.back().series.push_back(tangent_sound);
    PlotPanel turn{.title = "Change of stiffness over a turn of the wave generator",
                   .subtitle = "T > 0",
                   .x_label = "wave generator turned by [deg]",
                   .y_label = "cracked/sound − 1 [%]"};
    const auto series = [&](const char* label, double LineChanges::*line) {
      PlotSeries s{.label = label};
      for (std::size_t i = 0; i < report.comparison->angles.size(); ++i)
        add(s, report.comparison->angles[i] / units::deg,
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
