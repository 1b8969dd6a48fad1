// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Numbers of teeth of a drive.

namespace strainwave {

/// Number z of teeth of the flexspline, N_w i_h [-].  The circular spline has N_w teeth more.
[[nodiscard]] inline int flexspline_teeth(const Transmission& drive) {
  return static_cast<int>(std::lround(drive.wave_number * drive.ratio));
}

}  // namespace strainwave
