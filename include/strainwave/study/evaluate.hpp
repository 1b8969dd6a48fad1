// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// Torsional stiffness of a drive by one of the three methods.
///
/// @throws InputError  if the gear breaks a rule, or the method cannot treat it
[[nodiscard]] StiffnessResult evaluate(const GearSet& gear, Method method);

}  // namespace strainwave
