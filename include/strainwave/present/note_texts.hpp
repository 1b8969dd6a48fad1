// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace strainwave {

/// A note as the sources have it.
struct NoteText {
  std::string_view code;  ///< "crack.closed"
  std::string_view
      text;  ///< text with {} in place of values; empty if the text depends on the drive
};

/// The notes of all sources, a code as often as it is made; made when the library is built.
[[nodiscard]] std::span<const NoteText> note_texts();

}  // namespace strainwave
