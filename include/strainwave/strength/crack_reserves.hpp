// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"

namespace strainwave {

/// Verdicts and reserves of every crack, as of crack_strength, in a fraction of its time: without
/// critical sizes and uncertainties.
/// @param gear         as of crack_strength
/// @return             as of crack_strength
/// @throws InputError  if the gear breaks a rule
[[nodiscard]] std::vector<CrackStrength> crack_reserves(const GearSet& gear);

/// The numbers of crack_reserves alone, for a drive of which only some numbers have changed:
/// without the check of the input, sentences, notes and equations.
/// @param gear  has passed `check`
[[nodiscard]] std::vector<CrackStrength> crack_margins(const GearSet& gear);

/// Whether a material of the drive states a property by which its cracks can be assessed;
/// otherwise a result has no strength.
[[nodiscard]] bool strength_is_known(const GearSet& gear);

}  // namespace strainwave
