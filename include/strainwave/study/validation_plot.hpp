// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/catalogue/validation.hpp"

namespace strainwave {

/// Predicted over catalogue stiffness against size as an SVG, a panel for each class of ratio with
/// K1, K2, K3; with drawn proportions also the band of K2.
[[nodiscard]] std::string validation_plot(const Validation& validation);

}  // namespace strainwave
