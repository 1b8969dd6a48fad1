// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// The result as a table for a report, at most 100 columns wide; no more digits than the accuracy
/// warrants plus two.
[[nodiscard]] std::string result_text(const StiffnessResult& result, const GearSet& gear,
                                      const Provenance& provenance);

/// A number with the digits that its relative uncertainty warrants, plus two.
[[nodiscard]] std::string warranted_digits(const Quantity& quantity);

/// Columns of the text that strainwave writes.
inline constexpr std::size_t kTextWidth = 100;

/// Text broken at spaces to `width` columns; lines after the first are indented.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

/// Notes as a list, one item each: field, sentence, equation, what to do next.
[[nodiscard]] std::string notes_text(std::span<const Note> notes);

/// Writes a file whole or not at all: the text goes to a file beside it, which then takes its name.
/// @throws Error  if it cannot be written; nothing is left behind
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace strainwave
