// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "strainwave/motion/joint.hpp"

namespace strainwave {

/// Values of a joint at one time, in the order of `LargestValues`.
using MotionValues = std::array<double, 5>;

/// The values of a state.  The lag is 0 without a controller.
/// @param joint   with its constants
/// @param time    [s]
/// @param state   of the joint
/// @param forces  of this state
[[nodiscard]] MotionValues motion_values(const Joint& joint, double time, const JointState& state,
                                         const JointForces& forces);

/// Largest magnitudes of a motion, over all its steps (MO-13).  They do not depend on the samples.
struct LargestValues {
  /// even parts of a step; the values between two of them are those of a parabola
  static constexpr std::size_t kParts = 4;
  using Step = std::array<MotionValues, kParts + 1>;  ///< values of one step, its ends included

  double torque = 0.0;         ///< of the drive on the load [N*m]
  double error = 0.0;          ///< of the output, against an ideal stiff gear [rad]
  double input_torque = 0.0;   ///< torque that drives the input [N*m]
  double lag = 0.0;            ///< angle of the input behind the given one [rad]
  double output_torque = 0.0;  ///< external torque on the output [N*m]

  /// Raises the magnitudes to those of one time.
  void take(const MotionValues& values);
  /// Raises the magnitudes to those within a step.
  /// @param step  values at the ends of its parts, in the order of time
  void take(const Step& step);

  friend bool operator==(const LargestValues&, const LargestValues&) = default;
};

}  // namespace strainwave
