// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "strainwave/model/input/duty.hpp"

namespace strainwave {

/// Speed of the output of a block or a peak, with sign [rad/s].
/// @param of           the block or the peak, with exactly one of its two speeds [rad/s]
/// @param ratio        i_h [-]; > 0
/// @param fixed        the member that does not turn
/// @throws InputError  if not exactly one of its two speeds is given, or it is not finite
/// @{
[[nodiscard]] double output_speed(const DutyBlock& of, double ratio, FixedMember fixed);
[[nodiscard]] double output_speed(const DutyPeak& of, double ratio, FixedMember fixed);
/// @}

/// A part of the duty with constant load.
struct DutyStep {
  double duration = 0.0;        ///< how long the load acts [s]; >= 0
  double output_speed = 0.0;    ///< with sign [rad/s]
  double torque = 0.0;          ///< T at the output, with sign [N*m]
  double axial_force = 0.0;     ///< P at the output, tension > 0 [N]
  double radial_force = 0.0;    ///< F_r at the output bearing, fixed in space [N]; >= 0
  double bending_moment = 0.0;  ///< M at output bearing and shaft, fixed in space [N*m]; >= 0
};

/// The constant load that the maker's rules put in place of a duty cycle.
struct DutyAverage {
  double torque = 0.0;        ///< T_av [N*m]
  double output_speed = 0.0;  ///< n_out,av, over the whole time with pauses [rad/s]
  double input_speed = 0.0;   ///< n_in,av [rad/s]
};

/// Implements theory manual eq. (LI-1).
/// @param steps        in any order; at least one moves
/// @param ratio        i_h [-]; > 0
/// @param fixed        the member that does not turn
/// @throws InputError  if a duration is negative, a number is not finite, or nothing moves
[[nodiscard]] DutyAverage duty_average(std::span<const DutyStep> steps, double ratio,
                                       FixedMember fixed = FixedMember::circular_spline);

/// Number of momentary peak torques that the maker allows, N_k (LI-2) [-].
/// @param input_speed  at the peak [rad/s]; > 0
/// @param duration     of one peak [s]; > 0
/// @param wave_number  U, waves that pass in a turn of the input [-]; >= 1; makers' drives have 2
/// @throws InputError  if a rule is broken
[[nodiscard]] double allowed_momentary_peaks(double input_speed, double duration,
                                             int wave_number = 2);

}  // namespace strainwave
