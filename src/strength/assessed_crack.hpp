// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"

// Input of the assessment; crack_assessment.cpp assembles it, and assessment.cpp computes the
// answer.

namespace strainwave {

struct AssessedCrack {
  const DriveCrack& crack;
  const Material& material;
  Load load;
  std::optional<double> relative_uncertainty;  ///< relative uncertainty of K under the load [-]
  bool with_sizes = true;  ///< whether critical sizes are sought, which takes most of the time
  bool with_words = true;  ///< whether the verdict is put into words
};

/// Assesses a crack under the given sense of torque, and under the other sense if the result
/// differs; eqs. (FR-19), (FR-20), (FA-3) to (FA-5), (FA-13).
///
/// @param asked   the crack, its material and load
/// @param report  path, kind, material, size, ligament, notes and equations of the crack
/// @return        the report with its states and verdict
[[nodiscard]] CrackStrength assess(const AssessedCrack& asked, CrackStrength report);

}  // namespace strainwave
