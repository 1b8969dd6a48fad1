// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace strainwave {

/// A row of the glossary.
struct GlossaryTerm {
  std::string_view term;  ///< "wall"; several in one row stand between commas: "open, pressed"
  std::string_view meaning;
  std::string_view symbol;  ///< in plain letters: "K_HD"; empty: none
  std::string_view unit;    ///< empty: none
};

/// The terms of docs/guide/glossary.md, from which the build makes them.
[[nodiscard]] std::span<const GlossaryTerm> glossary();

}  // namespace strainwave
