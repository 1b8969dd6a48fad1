// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/study/require.hpp"

namespace strainwave {

/// Each requirement with its answer, and the answer of all together.
[[nodiscard]] std::string requirements_text(const RequirementReport& report);

}  // namespace strainwave
