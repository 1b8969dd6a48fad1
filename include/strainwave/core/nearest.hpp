// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace strainwave {

/// The known word nearest to a misspelt one by edit distance; empty if none is near
/// (more than a third of the letters differ, and more than two).
[[nodiscard]] std::string nearest_word(std::string_view word, std::span<const std::string> known);

/// The known words that begin with `word`, whatever the case.
[[nodiscard]] std::vector<std::string> words_beginning(std::string_view word,
                                                       std::span<const std::string> known);

}  // namespace strainwave
