// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/study/require.hpp"

namespace strainwave {

/// Each requirement with its answer, then the combined answer.
[[nodiscard]] std::string requirements_text(const RequirementReport& report);

}  // namespace strainwave
