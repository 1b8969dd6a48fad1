// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/catalogue/calibration.hpp"

namespace strainwave {

/// Stiffnesses before and after, factors, and the combinations of factors that the stiffnesses
/// determine.
[[nodiscard]] std::string calibration_text(const Calibration& calibration);

/// The calibrated drive as an input file: the text of the drive with the calibrated numbers, under
/// comments on the calibration.
/// @param before  the drive before the calibration
/// @param text    the text of this drive; if empty, the drive is written anew
/// @throws InputError  as `with_numbers_of`
[[nodiscard]] std::string calibrated_drive(const Calibration& calibration, const GearSet& before,
                                           const std::string& text);

}  // namespace strainwave
