// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace strainwave {

/// One line of the kinematic error.
struct ErrorOrder {
  double order = 0.0;      ///< o, periods in a turn of the wave generator [-]; > 0
  double amplitude = 0.0;  ///< A, of the angle at the output [rad]; >= 0
  double phase = 0.0;      ///< p [rad]
};

/// Kinematic error theta_k = sum of A sin(o theta_m + p), angle of the output beyond that of an
/// ideal gear (MO-4).
struct KinematicError {
  std::vector<ErrorOrder> orders = {};

  struct At {
    double value = 0.0;  ///< theta_k [rad]
    double slope = 0.0;  ///< d theta_k/d theta_m [-]
  };
  /// @param input_angle  theta_m [rad]
  [[nodiscard]] At at(double input_angle) const;
};

/// Throws InputError, which names the number, unless each number is in its range.  Amplitudes are
/// below 0.1 rad.
void require_constants(const KinematicError& error);

}  // namespace strainwave
