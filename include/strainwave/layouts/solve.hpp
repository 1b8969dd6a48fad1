// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/study/solve.hpp"

namespace strainwave {

/// The result as text, at most 100 columns wide.
[[nodiscard]] std::string solve_text(const SolveResult& result);

}  // namespace strainwave
