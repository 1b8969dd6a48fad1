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
/// For one varied number, the panels show K1, K2, K3 of the coupled drive with their changes by
/// cracks, if the coupled drive is solved.  The next panel shows the stiffness of the sum of the
/// members, sound and cracked, for both senses of torque.  If there are cracks, a lower panel shows
/// the loss of stiffness -Delta K/K and the part that the cracks of each member contribute, on a
/// log axis if all values are positive.  For two varied numbers, the panels show contour lines of
/// K1, K2, K3 and of the change of the sum, with a panel for negative torque where it differs.
/// Points that were refused or must not be used leave gaps; the subtitle counts them.
[[nodiscard]] std::string sweep_plot(const SweepResult& result, const GearSet& gear);

}  // namespace strainwave
