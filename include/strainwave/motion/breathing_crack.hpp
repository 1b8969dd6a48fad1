// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/motion/profile.hpp"

/// @file
/// Cracks that open and close, or grow, while the drive turns.

namespace strainwave {

/// The sense of the torque that opens a crack.
enum class OpeningSense { positive, negative };
template <>
struct EnumNames<OpeningSense> {
  static constexpr std::array<std::string_view, 2> names = {"positive", "negative"};
};

/// The shaft whose angle opens and closes a crack.
enum class BreathingShaft { input, output };
template <>
struct EnumNames<BreathingShaft> {
  static constexpr std::array<std::string_view, 2> names = {"input", "output"};
};

/// Opening b(theta) = sum_k c_k cos(k (o theta - p)) of a crack over the angle of a shaft (MO-6).
struct AngleOpening {
  BreathingShaft shaft = BreathingShaft::input;  ///< whose angle is theta
  double order = 0.0;                            ///< o, openings in a turn of the shaft [-]; > 0
  double phase = 0.0;                            ///< p; the crack is open at o theta = p [rad]
  /// c_k, with b between 0 and 1 at all angles; Mayes' law if left [-]
  std::vector<double> coefficients = {0.5, 0.5};

  /// The opening at one angle.
  struct At {
    double value = 0.0;  ///< b [-]
    double slope = 0.0;  ///< db/dtheta of the shaft [-]
  };
  /// @param angle  theta of the shaft [rad]
  [[nodiscard]] At at(double angle) const;
};

/// Coefficients of Mayes' law, b = (1 + cos)/2 (MO-6).
[[nodiscard]] std::vector<double> mayes_opening();
/// Coefficients of Gasch's hinge, open in half of the turn, as a series of cosines with Fejér's
/// factors, which keep b between 0 and 1 (MO-7).
/// @param terms  number of odd cosines [-]; >= 1
[[nodiscard]] std::vector<double> gasch_opening(int terms = 9);

/// A crack that adds a compliance while it is open (MO-5).
struct BreathingCrack {
  std::string path = {};    ///< path of the crack in the drive's file
  double compliance = 0.0;  ///< Delta lambda of the open crack, at the output [rad/(N*m)]; >= 0
  /// sense of the elastic torque that opens the crack; empty: both senses
  std::optional<OpeningSense> sense = {};
  /// opening over the angle of a shaft; empty: the same at all angles.  Without `sense` and
  /// `opening` the crack does not breathe, as an annular crack in torsion
  std::optional<AngleOpening> opening = {};
  /// Delta lambda over time of a crack that grows (MO-50), which a motion takes in place of
  /// `compliance` and a periodic motion does not read [rad/(N*m)]; >= 0, never falling
  std::optional<Profile> growth = {};
};

/// Compliance of all open cracks at an angle and a time, and its derivatives (MO-5, MO-50).
struct OpenCompliance {
  double value = 0.0;      ///< Lambda [rad/(N*m)]
  double by_input = 0.0;   ///< dLambda/dtheta_m [1/(N*m)]
  double by_output = 0.0;  ///< dLambda/dtheta_L [1/(N*m)]
  double by_time = 0.0;    ///< dLambda/dt at constant angles, behind the time [rad/(N*m*s)]
};
/// @param cracks        all cracks; with numbers in their range (require_constants)
/// @param torque_sign   sign of the elastic torque: +1 or -1
/// @param input_angle   theta_m [rad]
/// @param output_angle  theta_L [rad]
/// @param time          of the cracks that grow [s]
[[nodiscard]] OpenCompliance open_compliance(const std::vector<BreathingCrack>& cracks,
                                             double torque_sign, double input_angle,
                                             double output_angle, double time = 0.0);

/// Throws InputError, which names the number, unless each number is in its range.
void require_constants(const std::vector<BreathingCrack>& cracks);

}  // namespace strainwave
