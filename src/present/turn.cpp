// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/turn.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

constexpr double kMPaRootMetre = 1e6;

std::string place_of(const StationTurn& station, bool through) {
  if (station.station == -1) return "inner face";
  if (station.station == 1) return through ? "outer face" : "deepest";
  return through ? fmt::format("{:+.2f}", station.station) : fmt::format("{:.2f}", station.station);
}

}  // namespace

std::string turn_rows(std::span<const StationTurn> stations, bool through) {
  std::string text =
      "    station               K_max     K_min   Delta K  MPa*m^0.5       R  open [%]  at "
      "[deg]\n";
  for (const StationTurn& station : stations) {
    const TurnRange& K = station.mode_I;
    text += fmt::format(
        "    {:<17} {:>9.4g} {:>9.4g} {:>9.4g}            {:>7.3g}   {:>7.3g}   {:>7.3g}\n",
        fmt::format("{} {}", station.tip, place_of(station, through)), K.largest / kMPaRootMetre,
        K.least / kMPaRootMetre, K.range / kMPaRootMetre, K.ratio, 100 * K.open_share,
        K.at_largest / units::deg);
  }
  return text;
}

PlotPanel turn_panel(const SizedTurn& size, const LoadedTurn& torque, std::string_view tip) {
  PlotPanel panel;
  panel.title = fmt::format("T = {:.6g} N·m, {}, {} tip", torque.torque, size.name(), tip);
  panel.x_label = "angle from a lobe to the crack [deg]";
  panel.y_label = "K_I [MPa·√m]";
  panel.legend_title = "station, open share";
  for (const StationTurn& station : torque.stations) {
    if (station.tip != tip) continue;
    PlotSeries line{.label = fmt::format("{}, {:.0f} %", place_of(station, !size.depth),
                                         100 * station.mode_I.open_share)};
    for (const TurnFactor& K : station.factors) {
      line.x.push_back(K.angle / units::deg);
      line.y.push_back(K.K_I / kMPaRootMetre);
    }
    panel.series.push_back(std::move(line));
  }
  return panel;
}

std::string turn_plot(std::span<const SizedTurn> sizes, const std::string& subtitle) {
  const std::string_view tip = governing_station(sizes)->tip;
  std::vector<PlotPanel> panels;
  for (const SizedTurn& size : sizes)
    for (const LoadedTurn& torque : size.torques) panels.push_back(turn_panel(size, torque, tip));
  panels.front().subtitle = subtitle;
  return svg_plot(panels);
}

}  // namespace strainwave
