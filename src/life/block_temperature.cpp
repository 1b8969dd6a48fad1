// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/block_temperature.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "strainwave/core/shown_text.hpp"

namespace strainwave {

std::optional<UnstatedTemperature> unstated_temperature(
    const Duty& duty, std::string_view constants,
    const std::optional<std::array<double, 2>>& stated) {
  const auto outside = [&](double T) { return !stated || T < (*stated)[0] || T > (*stated)[1]; };
  // The block farthest from the middle of the range is named.
  const double middle = stated ? ((*stated)[0] + (*stated)[1]) / 2 : 0.0;
  std::size_t count = 0;
  std::size_t farthest = 0;
  double distance = -1.0;
  for (std::size_t i = 0; i < duty.block.size(); ++i) {
    const std::optional<double>& T = duty.block[i].temperature;
    if (!T || !outside(*T)) continue;
    ++count;
    if (std::abs(*T - middle) <= distance) continue;
    distance = std::abs(*T - middle);
    farthest = i;
  }
  if (count == 0) return std::nullopt;
  std::string text = fmt::format("the block is at {}, ",
                                 shown_quantity(*duty.block[farthest].temperature, "K", 5));
  text += stated ? fmt::format("but {} are stated for {} to {}", constants,
                               shown_quantity((*stated)[0], "K", 5),
                               shown_quantity((*stated)[1], "K", 5))
                 : fmt::format("but {} state no temperature", constants);
  if (count > 1)
    text += fmt::format("; the same holds for {} other block{}", count - 1, count == 2 ? "" : "s");
  return UnstatedTemperature{.path = fmt::format("duty.block[{}].temperature", farthest),
                             .text = text};
}

}  // namespace strainwave
