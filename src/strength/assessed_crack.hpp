// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"

// Input of the assessment; crack_assessment.cpp assembles it, and assessment.cpp computes the
// answer.

namespace strainwave {

/// K along the front of one crack at one size, computed once for both senses of torque and for the
/// loads on which K per unit of load does not depend.
struct FrontsAtSize {
  std::optional<std::vector<FrontIntensity>> open;
  std::optional<std::vector<FrontIntensity>> pressed;
};

struct AssessedCrack {
  const DriveCrack& crack;
  const Material& material;
  Load load;
  std::optional<double> relative_uncertainty;  ///< relative uncertainty of K under the load [-]
  bool with_sizes = true;  ///< whether critical sizes are sought, which takes most of the time
  bool with_words = true;  ///< whether the verdict is put into words
  /// K at the size of the crack, to compute no front twice; null: each is computed where it is used
  FrontsAtSize* fronts = nullptr;
};

/// Whether the verdict of `assess` is that the crack fractures or collapses, without the rest of
/// its answer.  The crack has no table of K over a turn.
/// @param asked  the crack with its fronts at its size, its material and load
[[nodiscard]] bool breaks(const AssessedCrack& asked);

/// Assesses a crack under the given sense of torque, and under the other sense if the result
/// differs; eqs. (FR-19), (FR-20), (FA-3) to (FA-5), (FA-13).
///
/// @param asked   the crack, its material and load
/// @param report  path, kind, material, size, ligament, notes and equations of the crack
/// @return        the report with its states and verdict
[[nodiscard]] CrackStrength assess(const AssessedCrack& asked, CrackStrength report);

}  // namespace strainwave
