// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/servo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "strainwave/core/error.hpp"

namespace strainwave {

Servo::At Servo::at(double angle_error, double speed_error, double integral, double holding,
                    double speed) const {
  const double error = speed_error + (position_time ? angle_error / *position_time : 0.0);
  At made{.torque = holding + speed_gain * error};
  if (!integral_time) return made;
  made.torque += speed_gain * integral / *integral_time;
  made.rate = error + (limited(made.torque, speed) - made.torque) / speed_gain;  // (MO-21)
  return made;
}

double Servo::asked(double torque) const {
  return torque_limit ? std::clamp(torque, -*torque_limit, *torque_limit) : torque;  // (MO-21)
}

Servo::Line Servo::line(double speed) const {
  if (!stall_torque || !no_load_speed)
    return {.least = -std::numeric_limits<double>::infinity(),
            .most = std::numeric_limits<double>::infinity()};
  const double of_no_load = speed / *no_load_speed;
  return {.least = -*stall_torque * (1 + of_no_load),
          .most = *stall_torque * (1 - of_no_load)};  // (MO-57)
}

double Servo::limited(double torque, double speed) const {
  const Line of = line(speed);
  return std::clamp(asked(torque), of.least, of.most);  // (MO-57)
}

void require_constants(const Servo& servo, double input_inertia, const FieldPath& at) {
  const auto positive = [&](std::string_view field, std::optional<double> value,
                            std::string_view unit) {
    if (value)
      require(*value > 0 && std::isfinite(*value), (at / field).text(), *value, unit, "> 0");
  };
  positive("speed_gain", servo.speed_gain, "N*m*s/rad");
  positive("position_time", servo.position_time, "s");
  positive("integral_time", servo.integral_time, "s");
  positive("torque_limit", servo.torque_limit, "N*m");
  positive("stall_torque", servo.stall_torque, "N*m");
  positive("no_load_speed", servo.no_load_speed, "rad/s");
  if (servo.stall_torque.has_value() != servo.no_load_speed.has_value())
    throw InputError((at / (servo.stall_torque ? "stall_torque" : "no_load_speed")).text(),
                     servo.stall_torque
                         ? "needs no_load_speed, the other end of the motor's line; give both, or "
                           "leave out both"
                         : "needs stall_torque, the other end of the motor's line; give both, or "
                           "leave out both");
  positive("sample_time", servo.sample_time, "s");
  if (!servo.sample_time) return;
  const auto faster = [&](const std::optional<double>& time, const char* rule) {
    if (time)
      require(*servo.sample_time < *time, (at / "sample_time").text(), *servo.sample_time, "s",
              rule);
  };
  faster(servo.position_time, "below position_time");
  faster(servo.integral_time, "below integral_time");
  // With k*T_s = 2 J the speed of a free input swings from sample to sample without end.
  require(servo.speed_gain * *servo.sample_time < 2 * input_inertia, (at / "sample_time").text(),
          *servo.sample_time, "s", "below 2*(inertia of the input)/speed_gain");
}

}  // namespace strainwave
