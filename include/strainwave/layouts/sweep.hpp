// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/sweep.hpp"

namespace strainwave {

/// The table as CSV: a column for each varied number, each output, `usable` and `reason`; the head
/// names path and SI unit, `intact.stiffness [N*m/rad]`.  Numbers have all their digits; what is
/// absent is empty.  Uncertainties and notes are in the JSON form only.
[[nodiscard]] std::string sweep_csv(const SweepResult& result);

/// The picture of a sweep.
///
/// Over one number: stiffness sound and cracked for both senses of torque, and below it, if there
/// are cracks, the loss of stiffness -Delta K/K and what the cracks of each member contribute to
/// it, on a log axis if all of it is positive.  Over two: the change of stiffness, a line for each
/// value of the second number, at most seven of them; a second panel for negative torque where it
/// differs.  Points that were refused or may not be used are gaps, and the subtitle counts them.
[[nodiscard]] std::string sweep_plot(const SweepResult& result, const GearSet& gear);

}  // namespace strainwave
