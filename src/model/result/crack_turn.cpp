// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/crack_turn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "strainwave/core/units.hpp"

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

const StationTurn* governing_station(std::span<const SizedTurn> sizes) {
  const StationTurn* governing = nullptr;
  for (const SizedTurn& size : sizes)
    for (const LoadedTurn& torque : size.torques) {
      const StationTurn* const here = governing_station(torque.stations);
      if (here != nullptr && (governing == nullptr || here->mode_I.range > governing->mode_I.range))
        governing = here;
    }
  return governing;
}

std::string TurnSize::name() const {
  return depth ? fmt::format("depth {:.6g} mm", *depth / units::mm)
               : fmt::format("half length {:.6g} mm", half_length / units::mm);
}

}  // namespace strainwave
