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
class KinematicError {
 public:
  KinematicError() = default;
  /// A braced list of lines is a kinematic error.
  /// @param orders  lines in any order
  KinematicError(std::vector<ErrorOrder> orders);  // NOLINT(google-explicit-constructor)

  /// The lines as they were given.
  [[nodiscard]] const std::vector<ErrorOrder>& orders() const { return orders_; }

  /// The error at one angle of the input.
  struct At {
    double value = 0.0;  ///< theta_k [rad]
    double slope = 0.0;  ///< d theta_k/d theta_m [-]
  };
  /// @param input_angle  theta_m [rad]
  [[nodiscard]] At at(double input_angle) const;
  /// The highest order; 0: no order [-].
  [[nodiscard]] double highest_order() const;

 private:
  /// A cos p and A sin p of a line; 0: there is no line of this multiple [rad].
  struct Line {
    double sine = 0.0;    ///< of sin(o theta_m)
    double cosine = 0.0;  ///< of cos(o theta_m)
  };
  /// Lines whose orders are multiples of the first one: they share one sine and one cosine.
  struct Family {
    double order = 0.0;  ///< of the first line [-]
    std::vector<Line> lines = {};
  };

  std::vector<ErrorOrder> orders_ = {};
  std::vector<Family> families_ = {};
};

/// The lines of a kinematic error that is given at even angles (MO-56).
struct ErrorLines {
  std::vector<ErrorOrder> orders = {};  ///< by falling amplitude
  double range = 0.0;                   ///< of the given values, from peak to valley [rad]
  double left_out = 0.0;                ///< largest difference to the given values [rad]
};

/// Number of lines that a table keeps at most.
inline constexpr std::size_t kMostErrorLines = 100;
/// Sum of the amplitudes of the lines that a table may leave out, over its range [-].
inline constexpr double kErrorLeftOut = 1e-3;

/// Implements theory manual eq. (MO-56).
///
/// The mean is left out, because it only turns the output.  The smallest lines are left out as long
/// as the sum of their amplitudes is at most kErrorLeftOut of the range, and so are all lines
/// beyond kMostErrorLines or kLargestOrder.
/// @param values  of the error at n even angles of the input, from 0 to before the period [rad];
///                3 or more
/// @param turns   of the input in the period [-]; > 0
[[nodiscard]] ErrorLines error_lines(const std::vector<double>& values, double turns);

/// A kinematic error as read from its file.
struct ErrorTable {
  std::vector<double> values = {};  ///< at even angles of the input [rad]
  double turns = 0.0;               ///< of the input in the period [-]
  ErrorLines lines = {};            ///< of the values
};

/// Throws InputError, which names the number, unless each number is in its range.  Amplitudes are
/// below kLargestError.
void require_constants(const KinematicError& error);

}  // namespace strainwave
