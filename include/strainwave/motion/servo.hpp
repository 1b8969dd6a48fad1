// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// A motor with a cascade of controllers for position and speed (MO-21):
///
///     e = w* + (theta* - theta_m)/T_p - w_m,   T = T_0 + k (e + q/T_i),   q' = e + (T_m - T)/k,
///
/// where T_m is T cut at the limits of the motor.  The last term keeps the integral from growing
/// while the torque is cut.  The limits are a largest torque, by the largest current, and the line
/// of a DC motor at its supply voltage, by its back-EMF (MO-57).
struct Servo {
  double speed_gain = 0.0;  ///< k, torque over an error of the speed [N*m*s/rad]; > 0
  /// T_p, time in which an error of the angle decays [s]; > 0; absent: the speed is controlled only
  std::optional<double> position_time = {};
  std::optional<double> integral_time = {};  ///< T_i [s]; > 0; absent: no integral
  std::optional<double> torque_limit = {};   ///< of the motor [N*m]; > 0
  /// T_s of the standing motor at its supply voltage [N*m]; > 0; with `no_load_speed` or absent
  std::optional<double> stall_torque = {};
  /// w_0 of the motor at its supply voltage without torque [rad/s]; > 0; likewise
  std::optional<double> no_load_speed = {};
  /// time between two samples; the torque stays in between [s]; > 0; absent: continuous
  std::optional<double> sample_time = {};

  /// What the controller computes from its errors.
  struct At {
    double torque = 0.0;  ///< T, before the limit [N*m]
    double rate = 0.0;    ///< q' [rad/s]; 0 without an integral
  };
  /// @param angle_error  theta* - theta_m [rad]
  /// @param speed_error  w* - w_m [rad/s]
  /// @param integral     q [rad]
  /// @param holding      T_0 [N*m]
  /// @param speed        of the motor [rad/s]
  [[nodiscard]] At at(double angle_error, double speed_error, double integral, double holding,
                      double speed) const;
  /// The torque within the limit of the current [N*m].
  [[nodiscard]] double asked(double torque) const;
  /// Least and largest torque that the supply voltage allows.
  struct Line {
    double least = 0.0;  ///< [N*m]
    double most = 0.0;   ///< [N*m]
  };
  /// @param speed  of the motor [rad/s]
  /// @returns infinite torques without a line
  [[nodiscard]] Line line(double speed) const;
  /// The torque within both limits, T_m [N*m].
  [[nodiscard]] double limited(double torque, double speed) const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "speed_gain",
                .unit = "N*m*s/rad",
                .doc = "k: torque of the motor over an error of its speed",
                .range = kPositive,
                .example = R"("0.1 N*m*s/rad")"},
          &Servo::speed_gain);
    const auto time = [&](std::string_view name, std::string_view doc, std::string_view example,
                          auto member) {
      field(Field{.name = name,
                  .unit = "s",
                  .doc = doc,
                  .range = kPositive,
                  .example = example,
                  .in_template = InTemplate::commented},
            member);
    };
    time("position_time",
         "T_p: time in which an error of the angle decays; if left out, only the speed is "
         "controlled",
         R"("20 ms")", &Servo::position_time);
    time("integral_time", "T_i: time of the integral of the speed's error; none if left out",
         R"("10 ms")", &Servo::integral_time);
    field(Field{.name = "torque_limit",
                .unit = "N*m",
                .doc = "largest torque of the motor; none if left out",
                .range = kPositive,
                .example = R"("2 N*m")",
                .in_template = InTemplate::commented},
          &Servo::torque_limit);
    field(Field{.name = "stall_torque",
                .unit = "N*m",
                .doc = "T_s: torque of the standing DC motor at its supply voltage; with "
                       "no_load_speed, or no limit by the voltage if left out",
                .range = kPositive,
                .example = R"("4 N*m")",
                .in_template = InTemplate::commented},
          &Servo::stall_torque);
    field(Field{.name = "no_load_speed",
                .unit = "rad/s",
                .doc = "w_0: speed of the DC motor at its supply voltage without torque",
                .range = kPositive,
                .example = R"("3000 rpm")",
                .in_template = InTemplate::commented},
          &Servo::no_load_speed);
    time("sample_time", "time between two samples of the controller; continuous if left out",
         R"("1 ms")", &Servo::sample_time);
  }
};

/// Throws InputError, which names the constant, unless each constant is in its range.  A controller
/// that takes samples must sample faster than its own times, and faster than it can brake the
/// input within one sample.
/// @param servo          controller and motor
/// @param input_inertia  J_m [kg*m^2]; > 0
/// @param at             path of the controller in messages
void require_constants(const Servo& servo, double input_inertia,
                       const FieldPath& at = FieldPath("servo"));

}  // namespace strainwave
