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

/// K_I over the turn, a line for each station of a tip.
[[nodiscard]] PlotPanel turn_panel(std::string title, std::span<const StationTurn> stations,
                                   std::string_view tip, bool through);

}  // namespace strainwave
