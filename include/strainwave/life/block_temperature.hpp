// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "strainwave/model/input/duty.hpp"

namespace strainwave {

/// Blocks of a duty at temperatures for which constants are not stated.
struct UnstatedTemperature {
  std::string path;  ///< of the temperature that is farthest from the stated ones
  std::string text;  ///< what is wrong, with the number of the other blocks
};

/// The blocks at temperatures for which constants are not stated; absent if there are none.
///
/// Nothing else depends on the temperature of a block: the constants hold at their own temperature,
/// and no rule is known that carries them to another one.
///
/// @param duty       its blocks count; a block without a temperature is passed over
/// @param constants  in words, with their origin: "the constants of fatigue of steel"
/// @param stated     temperatures for which the constants are stated [K]; absent: not stated
[[nodiscard]] std::optional<UnstatedTemperature> unstated_temperature(
    const Duty& duty, std::string_view constants,
    const std::optional<std::array<double, 2>>& stated);

}  // namespace strainwave
