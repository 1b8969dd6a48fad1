// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "strainwave/chart/chart.hpp"
#include "strainwave/model/result/crack_turn.hpp"

/// @file
/// K over a turn as text and as a picture, for every model of a turn.

namespace strainwave {

/// K_max, K_min, Delta K, R and the open share of each station, with a head; in lines of at most
/// 100 columns.
/// @param through  whether the crack goes through the wall; else the last station is the deepest
[[nodiscard]] std::string turn_rows(std::span<const StationTurn> stations, bool through);

/// K_I over the turn as one SVG document: a panel for each size and torque, a line for each station
/// of the governing tip.
/// @param sizes  one or more
[[nodiscard]] std::string turn_plot(std::span<const SizedTurn> sizes, const std::string& subtitle);

/// One panel of that plot.
/// @param tip  "upper" or "lower", the tip whose stations are drawn
[[nodiscard]] PlotPanel turn_panel(const SizedTurn& size, const LoadedTurn& torque,
                                   std::string_view tip);

}  // namespace strainwave
