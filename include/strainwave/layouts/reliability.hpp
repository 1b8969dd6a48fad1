// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/reliability_report.hpp"

namespace strainwave {

/// For each requirement its probability by all roads, and the design point.
[[nodiscard]] std::string reliability_text(const ReliabilityReport& report, const GearSet& gear);

}  // namespace strainwave
