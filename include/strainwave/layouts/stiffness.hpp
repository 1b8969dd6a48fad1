// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/provenance.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// The result as tables for a terminal, with at most two digits more than the accuracy warrants.
[[nodiscard]] std::string stiffness_text(const StiffnessResult& result, const GearSet& gear,
                                         const Provenance& provenance);

}  // namespace strainwave
