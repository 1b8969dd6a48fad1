// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace strainwave {

/// Heading of an equation in the theory manual.
struct EquationTitle {
  std::string_view tag;    ///< "FR-2"
  std::string_view title;  ///< "Added compliance"
};

/// All equations of the manual; the build makes them from docs/theory.
[[nodiscard]] std::span<const EquationTitle> equation_titles();

}  // namespace strainwave
