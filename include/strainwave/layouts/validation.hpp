// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/catalogue/validation.hpp"

namespace strainwave {

/// The report for people.
[[nodiscard]] std::string validation_text(const Validation& validation);
/// CSV with one line for each K of each row at each ratio: predicted/stated, and bands if drawn.
[[nodiscard]] std::string validation_csv(const Validation& validation);
/// Tables for a manual.
[[nodiscard]] std::string validation_markdown(const Validation& validation);

/// Predicted over stated stiffness of the catalogue as SVG, with K1, K2, K3: against size, with one
/// panel for each class of ratio, and against the ratio for the sizes 25 and 40.  With drawn
/// proportions, the panels also show the band of K2.
[[nodiscard]] std::string validation_plot(const Validation& validation);

}  // namespace strainwave
