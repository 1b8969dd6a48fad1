// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/sweep.hpp"

namespace strainwave {

/// The table as CSV, with a column for each varied number and each output, then `usable` and
/// `reason`.  The heads name path and SI unit, such as `intact.stiffness [N*m/rad]`.  Numbers have
/// all their digits; absent values are empty.  Only the JSON document has uncertainties and notes.
[[nodiscard]] std::string sweep_csv(const SweepResult& result);

/// The plot of a sweep.
///
/// Over one number: K1, K2, K3 of the coupled drive, where it is solved, and what cracks change in
/// them; stiffness of the sum of the members, sound and cracked for both senses of torque, and
/// below it, if there are cracks, the loss of stiffness -Delta K/K and what the cracks of each
/// member contribute to it, on a log axis if all of it is positive.  Over two: contour lines of K1,
/// K2, K3 and of the change of the sum, under negative torque too where it differs.  Points that
/// were refused or may not be used are gaps, and the subtitle counts them.
[[nodiscard]] std::string sweep_plot(const SweepResult& result, const GearSet& gear);

}  // namespace strainwave
