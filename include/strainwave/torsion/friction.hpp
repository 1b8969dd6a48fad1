// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// Friction of the coupled drive: width of its hysteresis, running torque and back-driving torque.

namespace strainwave {

/// Distance between the twist under falling and under rising torque, by the contacts that slip.
struct FrictionWidth {
  double flanks = 0.0;      ///< [rad]
  double outer_ring = 0.0;  ///< outer ring of the bearing in the bore of the rim [rad]
  /// Width by all contacts [rad].
  [[nodiscard]] double total() const { return flanks + outer_ring; }
};

/// Twist without friction, and the width that friction gives the curve.
struct SlidingCurve {
  std::vector<double> twist;         ///< at each torque [rad]
  std::vector<FrictionWidth> width;  ///< at each torque
};

/// Twist and friction width with locked input; eqs. (TC-16) and (TC-33).
///
/// Valid to first order in the coefficients of friction: 2 % of the width at 0.1, and up to 30 % if
/// flanks press on each other without torque with a multiple of their load (TC-16).  At zero
/// torque, if no flank is pressed there, the outer ring takes the mean of its widths at +-0.001 T1.
/// @param drive     the assembled drive, with its cracks and deviations
/// @param torques   [N*m], one after the other
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if a torque is not finite, or flanks would lock themselves
/// @throws SolverError  if the curve is not usable
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] SlidingCurve sliding_curve(const AssembledDrive& drive,
                                         std::span<const double> torques,
                                         const Progress& progress = {});

/// Input torque lost in the contacts while the input turns slowly; eq. (TC-34).
struct RunningTorque {
  double balls = 0.0;       ///< rolling friction of the balls [N*m]
  double outer_ring = 0.0;  ///< slip of the outer ring in the bore of the rim [N*m]
  double flanks = 0.0;      ///< slip of the flanks [N*m]
  double output = 0.0;      ///< friction at the output, over the ratio [N*m]
  /// Torque that turns the input slowly, the sum of all parts [N*m].
  [[nodiscard]] double total() const { return balls + outer_ring + flanks + output; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"total", "N*m", "torque that turns the input slowly"}, &RunningTorque::total);
    field({"balls", "N*m", "rolling friction of the balls"}, &RunningTorque::balls);
    field({"outer_ring", "N*m", "slip of the outer ring in the bore of the rim"},
          &RunningTorque::outer_ring);
    field({"flanks", "N*m", "slip of the flanks"}, &RunningTorque::flanks);
    field({"output", "N*m", "rating.friction_torque over the ratio"}, &RunningTorque::output);
  }
};

/// Losses in the contacts while the output carries a torque [N*m].
/// @throws SolverError  if the drive does not reach the torque
[[nodiscard]] RunningTorque running_torque(const AssembledDrive& drive, double torque);

/// Torque that turns the input without load at the output, against the friction of the contacts and
/// `Rating::friction_torque`; eq. (TC-34).  It does not contain the grease.
/// @throws SolverError  if the drive does not reach the friction torque
[[nodiscard]] RunningTorque no_load_torque(const AssembledDrive& drive);

/// Torque at the output that turns a free input [N*m]; eq. (TC-35).
/// @return  absent if it is above the rated torque
/// @throws SolverError  if the drive does not reach a torque below the rated torque, or the torque
///                      does not settle
[[nodiscard]] std::optional<double> back_driving_torque(const AssembledDrive& drive);

}  // namespace strainwave
