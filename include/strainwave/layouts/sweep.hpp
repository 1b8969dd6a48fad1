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
/// For one varied number, the upper panel shows the stiffness, sound and cracked, for both senses
/// of torque.  If there are cracks, a lower panel shows the loss of stiffness -Delta K/K and the
/// part that the cracks of each member contribute, on a log axis if all values are positive.  For
/// two varied numbers, the panel shows the change of stiffness with one line for each value of the
/// second number, at most seven lines.  A second panel shows negative torque where it differs.
/// Points that were refused or must not be used leave gaps; the subtitle counts them.
[[nodiscard]] std::string sweep_plot(const SweepResult& result, const GearSet& gear);

}  // namespace strainwave
