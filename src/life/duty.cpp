// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/duty.hpp"

#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/dynamics/kinematics.hpp"

namespace strainwave {
namespace {

template <class Moving>
double speed_of(const Moving& of, double ratio, FixedMember fixed) {
  if (of.output_speed.has_value() == of.input_speed.has_value())
    throw InputError("output_speed", of.output_speed ? "must not be given beside input_speed"
                                                     : "must be given, or input_speed");
  if (of.output_speed) {
    require(std::isfinite(*of.output_speed), "output_speed", *of.output_speed, "rad/s",
            "a finite number");
    return *of.output_speed;
  }
  require(std::isfinite(*of.input_speed), "input_speed", *of.input_speed, "rad/s",
          "a finite number");
  return *of.input_speed / signed_ratio(arrangement_of(fixed), ratio);
}

}  // namespace

double output_speed(const DutyBlock& of, double ratio, FixedMember fixed) {
  return speed_of(of, ratio, fixed);
}
double output_speed(const DutyPeak& of, double ratio, FixedMember fixed) {
  return speed_of(of, ratio, fixed);
}

DutyAverage duty_average(std::span<const DutyStep> steps, double ratio, FixedMember fixed) {
  double time = 0.0;
  double turned = 0.0;
  double cubes = 0.0;
  for (const DutyStep& step : steps) {
    require(step.duration >= 0 && std::isfinite(step.duration), "duration", step.duration, "s",
            ">= 0");
    require(std::isfinite(step.output_speed), "output_speed", step.output_speed, "rad/s",
            "a finite number");
    require(std::isfinite(step.torque), "torque", step.torque, "N*m", "a finite number");
    const double angle = std::abs(step.output_speed) * step.duration;
    time += step.duration;
    turned += angle;
    cubes += std::pow(std::abs(step.torque), 3) * angle;
  }
  if (!(turned > 0)) throw InputError("duty", "does not move; give a duty with a speed");
  const double speed = turned / time;
  return {.torque = std::cbrt(cubes / turned),  // (LI-1)
          .output_speed = speed,
          .input_speed = std::abs(signed_ratio(arrangement_of(fixed), ratio)) * speed};
}

double allowed_momentary_peaks(double input_speed, double duration, int wave_number) {
  require(input_speed > 0 && std::isfinite(input_speed), "input_speed", input_speed, "rad/s",
          "> 0");
  require(duration > 0 && std::isfinite(duration), "duration", duration, "s", "> 0");
  require(wave_number >= 1, "wave_number", wave_number, "1", ">= 1");
  constexpr double kReversals = 1e4;
  const double turns = input_speed / (2 * std::numbers::pi) * duration;
  return kReversals / (wave_number * turns);  // (LI-2)
}

}  // namespace strainwave
