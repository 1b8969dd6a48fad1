// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave {

/// True if a < b by more than the rounding of a unit conversion; a and b must be positive.  A
/// length given in millimetres at the end of a range thus counts as inside the range, and a length
/// that differs from a solid limit by rounding only counts as beyond it.
[[nodiscard]] constexpr bool clearly_less(double a, double b) { return a < b * (1 - 1e-12); }

}  // namespace strainwave
