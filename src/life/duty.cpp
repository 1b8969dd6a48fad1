// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/duty.hpp"

#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {

double input_turns(double ratio, FixedMember fixed) {
  require(ratio > 0 && std::isfinite(ratio), "ratio", ratio, "1", "> 0");
  return fixed == FixedMember::circular_spline ? ratio : ratio + 1;
}

DutyAverage duty_average(std::span<const DutyBlock> blocks, double ratio, FixedMember fixed) {
  double time = 0.0;
  double turned = 0.0;
  double cubes = 0.0;
  for (const DutyBlock& block : blocks) {
    require(block.duration > 0 && std::isfinite(block.duration), "duration", block.duration, "s",
            "> 0");
    require(std::isfinite(block.output_speed), "output_speed", block.output_speed, "rad/s",
            "a finite number");
    require(std::isfinite(block.torque), "torque", block.torque, "N*m", "a finite number");
    const double angle = std::abs(block.output_speed) * block.duration;
    time += block.duration;
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
