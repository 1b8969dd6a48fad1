// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave {

/// a < b by more than the rounding of a unit conversion: a length in millimetres at the very end of
/// a range is inside it, one a hair from a solid limit is not.  For positive numbers.
[[nodiscard]] constexpr bool clearly_less(double a, double b) { return a < b * (1 - 1e-12); }

}  // namespace strainwave
