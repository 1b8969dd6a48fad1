// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/fe_study/member_run.hpp"

namespace strainwave::fe_study {

/// A result as text, at most 100 columns wide; for a dry run, its plan.
[[nodiscard]] std::string run_text(const RunResult& result, const GearSet& gear);

/// "usable", or the reason why a result is not.
[[nodiscard]] std::string verdict(bool usable, const std::string& reason);

/// The plan of a dry run.
[[nodiscard]] std::string plan_text(const std::vector<RunSize>& sizes);

}  // namespace strainwave::fe_study
