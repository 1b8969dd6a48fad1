// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/largest_values.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace strainwave {
namespace {

constexpr std::array<double LargestValues::*, 5> kMagnitudes = {
    &LargestValues::torque, &LargestValues::error, &LargestValues::input_torque,
    &LargestValues::lag, &LargestValues::output_torque};

}  // namespace

MotionValues motion_values(const Joint& joint, double time, const JointState& state,
                           const JointForces& forces) {
  const auto* const drive = std::get_if<ServoDrive>(&joint.input);
  return {forces.torque, state.output_angle - state.input_angle / joint.ratio, forces.input_torque,
          drive != nullptr ? drive->speed.integral(time) - state.input_angle : 0.0,
          forces.output_torque};
}

void LargestValues::take(const MotionValues& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    double& most = this->*kMagnitudes[k];
    most = std::max(most, std::abs(values[k]));
  }
}

void LargestValues::take(const Step& step) {
  for (const MotionValues& values : step) take(values);
  for (std::size_t n = 1; n < kParts; ++n) {
    MotionValues peaks{};
    for (std::size_t k = 0; k < peaks.size(); ++k) {
      const double rise = step[n + 1][k] - step[n - 1][k];
      const double bend = step[n + 1][k] - 2 * step[n][k] + step[n - 1][k];
      // The parabola through three values turns back between the first and the last.
      if (bend != 0 && std::abs(rise) <= 2 * std::abs(bend))
        peaks[k] = step[n][k] - rise * rise / (8 * bend);  // (MO-13)
    }
    take(peaks);
  }
}

}  // namespace strainwave
