// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {

/// Every amplitude is below this bound, which is far above that of a drive in order [rad].
inline constexpr double kLargestError = 0.5 * units::deg;

/// Every order is up to this bound, above that of all teeth and balls [-].
inline constexpr double kLargestOrder = 1000;

/// One line of the kinematic error.
struct ErrorOrder {
  double order = 0.0;      ///< o, periods in a turn of the wave generator [-]; > 0
  double amplitude = 0.0;  ///< A, of the angle at the output [rad]; >= 0
  double phase = 0.0;      ///< p [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "order",
                .unit = "1",
                .doc = "periods in a turn of the input",
                .range = {.lower = 0.0, .upper = kLargestOrder, .upper_open = false},
                .example = "2"},
          &ErrorOrder::order);
    field(Field{.name = "amplitude",
                .unit = "rad",
                .doc = "amplitude of the output's angle; half of the range from peak to valley",
                .range = {.lower = 0.0, .lower_open = false, .upper = kLargestError},
                .example = R"("0.5 arcmin")"},
          &ErrorOrder::amplitude);
    field(Field{.name = "phase",
                .unit = "rad",
                .doc = "phase of the sine at the angle 0 of the input",
                .example = R"("0 deg")",
                .fallback = R"("0 deg")",
                .in_template = InTemplate::commented},
          &ErrorOrder::phase);
  }
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
/// below kLargestError.
void require_constants(const KinematicError& error);

}  // namespace strainwave
