// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "strainwave/core/shown_text.hpp"
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
/// K_I over a turn of the wave generator as a sentence; absent if it is not known.
[[nodiscard]] std::optional<std::string> at_work_sentence(const CrackReport& crack);
/// The name of an output in words, such as "stiffness, T > 0" for "cracked.positive.stiffness" or
/// "K1, sound" for "curve.intact.K1"; any other output keeps its name.
[[nodiscard]] std::string output_words(std::string_view output);

/// The place of the first stress intensity of a crack: "deepest point", or "tip" for a crack that
/// goes through its wall.
[[nodiscard]] std::string_view place_of_intensity(std::string_view kind);
/// A count with its noun, such as "1 range" or "2 ranges".
[[nodiscard]] std::string counted(std::size_t n, std::string_view thing);

/// The units of the tables and plots of drives: the units that were asked for, otherwise N*m/rad,
/// N*m/arcmin and arcmin.
[[nodiscard]] DisplayUnit stiffness_unit();
[[nodiscard]] DisplayUnit plotted_stiffness_unit();
[[nodiscard]] DisplayUnit angle_unit();
/// A label with its unit: "twist [arcmin]".
[[nodiscard]] std::string with_unit(std::string_view label, const DisplayUnit& unit);
/// A value of SI in a unit, such as "48 N*m".
[[nodiscard]] std::string number_and_unit(double value, const DisplayUnit& unit);
/// A label with its unit for the axis of a plot: "K1 [N·m/arcmin]".
[[nodiscard]] std::string axis_label(std::string_view label, const DisplayUnit& unit);

/// The critical size from the failure assessment or, if absent, from K alone.
[[nodiscard]] const std::optional<CriticalSize>& critical_size(const StrengthState& state);

}  // namespace strainwave
