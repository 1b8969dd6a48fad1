// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace strainwave {

/// The known word nearest to a misspelt word by edit distance; empty if even the nearest differs in
/// more than two letters and in more than a third of them.
[[nodiscard]] std::string nearest_word(std::string_view word, std::span<const std::string> known);

/// The known words that begin with `word`; case is ignored.
[[nodiscard]] std::vector<std::string> words_beginning(std::string_view word,
                                                       std::span<const std::string> known);

}  // namespace strainwave
