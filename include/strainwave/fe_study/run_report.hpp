// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/fe_study/member_run.hpp"
#include "strainwave/model/result/provenance.hpp"

namespace strainwave::fe_study {

/// For people, at most 100 columns wide.
[[nodiscard]] std::string run_text(const RunResult& result, const GearSet& gear);
/// All digits, SI, each quantity with its unit; with the input as it was understood.
[[nodiscard]] std::string run_json(const RunResult& result, const GearSet& gear,
                                   const Provenance& provenance);

[[nodiscard]] std::string plan_text(const std::vector<RunSize>& sizes);
[[nodiscard]] std::string plan_json(const std::vector<RunSize>& sizes);

}  // namespace strainwave::fe_study
