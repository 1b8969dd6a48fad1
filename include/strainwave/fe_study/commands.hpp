// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "strainwave/command/command.hpp"

namespace strainwave::fe_study {

/// All commands of strainwave-fe, in the order of its help.  They run on all ranks of their host.
[[nodiscard]] std::span<const Command> fe_commands();

}  // namespace strainwave::fe_study
