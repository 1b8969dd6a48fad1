// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/duty.hpp"

#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

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
  const double sense = fixed == FixedMember::circular_spline ? -1 : 1;
  return sense * *of.input_speed / input_turns(ratio, fixed);
}

}  // namespace

double input_turns(double ratio, FixedMember fixed) {
  require(ratio > 0 && std::isfinite(ratio), "ratio", ratio, "1", "> 0");
  return fixed == FixedMember::circular_spline ? ratio : ratio + 1;
}

double output_speed(const DutyBlock& of, double ratio, FixedMember fixed) {
  return speed_of(of, ratio, fixed);
}
double output_speed(const DutyPeak& of, double ratio, FixedMember fixed) {
  return speed_of(of, ratio, fixed);
}

DutyAverage duty_average(std::span<const DutyBlock> blocks, double ratio, FixedMember fixed) {
  double time = 0.0;
  double turned = 0.0;
  double cubes = 0.0;
  for (const DutyBlock& block : blocks) {
    require(block.duration > 0 && std::isfinite(block.duration), "duration", block.duration, "s",
            "> 0");
    require(block.repetitions >= 1, "repetitions", block.repetitions, "1", ">= 1");
    require(std::isfinite(block.torque), "torque", block.torque, "N*m", "a finite number");
    const double lasts = block.repetitions * block.duration;
    const double angle = std::abs(output_speed(block, ratio, fixed)) * lasts;
    time += lasts;
    turned += angle;
    cubes += std::pow(std::abs(block.torque), 3) * angle;
  }
  if (!(turned > 0))
    throw InputError("duty", "no block moves; give at least one block with a speed");
  const double speed = turned / time;
  return {.torque = std::cbrt(cubes / turned),  // (LI-1)
          .output_speed = speed,
          .input_speed = input_turns(ratio, fixed) * speed};
}

double allowed_momentary_peaks(double input_speed, double duration) {
  require(input_speed > 0 && std::isfinite(input_speed), "input_speed", input_speed, "rad/s",
          "> 0");
  require(duration > 0 && std::isfinite(duration), "duration", duration, "s", "> 0");
  constexpr double kReversals = 1e4;
  return kReversals / (input_speed / std::numbers::pi * duration);  // (LI-2)
}

}  // namespace strainwave
