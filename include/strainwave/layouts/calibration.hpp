// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/catalogue/calibration.hpp"

namespace strainwave {

/// Stiffnesses before and after, factors, and the combinations of factors that the stiffnesses
/// determine.
[[nodiscard]] std::string calibration_text(const Calibration& calibration);

/// The calibrated drive as an input file with comments on its calibration.
[[nodiscard]] std::string calibrated_drive(const Calibration& calibration);

}  // namespace strainwave
