// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/catalogue/calibration.hpp"

namespace strainwave {

/// Values before and after, factors, and which combinations of them the values identify.
[[nodiscard]] std::string calibration_text(const Calibration& calibration);

/// The calibrated drive as an input file that says how it came about.
[[nodiscard]] std::string calibrated_drive(const Calibration& calibration);

}  // namespace strainwave
