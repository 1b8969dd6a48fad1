// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/fe_study/member_run.hpp"

namespace strainwave::fe_study {

/// A result as text, at most 100 columns wide; for a dry run, its plan.
[[nodiscard]] std::string run_text(const RunResult& result, const GearSet& gear);

}  // namespace strainwave::fe_study
