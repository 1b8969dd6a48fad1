// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

/// @file
/// Words that several tables use for results.

namespace strainwave {

/// The title of a document on a drive.
[[nodiscard]] inline std::string name_of(const GearSet& gear) {
  return gear.name.empty() ? "Strain wave gear" : gear.name;
}

/// The senses of torque that open a crack in words, such as "T > 0" or "either sense".
[[nodiscard]] std::string_view words_of(OpensUnder opens);
[[nodiscard]] std::string_view words_of(TorqueSense sense);
[[nodiscard]] std::string_view words_of(StrengthVerdict verdict);
/// A state of strength in words, such as "T > 0, with the assembly".
[[nodiscard]] std::string words_of(const StrengthState& state);
/// The name of an output in words, such as "stiffness, T > 0" for "cracked.positive.stiffness".
[[nodiscard]] std::string output_words(std::string_view output);

/// The critical size from the failure assessment or, if absent, from K alone.
[[nodiscard]] const std::optional<CriticalSize>& critical_size(const StrengthState& state);

}  // namespace strainwave
