// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/crack_turn.hpp"

#include <algorithm>
#include <cstddef>

namespace strainwave {

TurnRange turn_range(std::span<const TurnFactor> factors) {
  TurnRange range;
  range.least = factors.front().K_I;
  std::size_t open = 0;
  // The last angle is the first one again.
  for (std::size_t i = 0; i + 1 < factors.size(); ++i) {
    const TurnFactor& one = factors[i];
    if (one.K_I > range.largest) {
      range.largest = one.K_I;
      range.at_largest = one.angle;
    }
    range.least = std::min(range.least, one.K_I);
    open += one.K_I > 0 ? 1 : 0;
  }
  range.range = range.largest - range.least;
  range.ratio = range.largest > 0 ? range.least / range.largest : 0.0;
  range.open_share = static_cast<double>(open) / static_cast<double>(factors.size() - 1);
  return range;
}

const StationTurn* governing_station(std::span<const StationTurn> stations) {
  const auto largest = std::ranges::max_element(
      stations, {}, [](const StationTurn& station) { return station.mode_I.range; });
  return largest == stations.end() ? nullptr : &*largest;
}

}  // namespace strainwave
