// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The member of the drive that does not turn.
enum class FixedMember {
  circular_spline,  ///< the flexspline is the output and turns against the input, by 1/i
  flexspline,       ///< the circular spline is the output and turns with the input, by 1/(i + 1)
};
template <>
struct EnumNames<FixedMember> {
  static constexpr std::array<std::string_view, 2> names = {"circular_spline", "flexspline"};
};

/// Turns of the wave generator per turn of the output [-]; without sign.
/// @param ratio  i_h, that of the fixed circular spline [-]; > 0
[[nodiscard]] double input_turns(double ratio, FixedMember fixed);

/// A part of a duty cycle with constant torque and speed.
struct DutyBlock {
  double duration = 0.0;      ///< t [s]; > 0
  double output_speed = 0.0;  ///< n, without sign or with it [rad/s]; 0: a pause
  double torque = 0.0;        ///< T at the output [N*m]
};

/// The constant load that the maker's rules put in place of a duty cycle.
struct DutyAverage {
  double torque = 0.0;        ///< T_av [N*m]
  double output_speed = 0.0;  ///< n_out,av, over the whole time with pauses [rad/s]
  double input_speed = 0.0;   ///< n_in,av [rad/s]
};

/// Implements theory manual eq. (LI-1).
/// @param ratio        i_h [-]; > 0
/// @throws InputError  if a block has no duration, a number is not finite, or nothing moves
[[nodiscard]] DutyAverage duty_average(std::span<const DutyBlock> blocks, double ratio,
                                       FixedMember fixed = FixedMember::circular_spline);

/// Number of momentary peak torques that the maker allows, N_k (LI-2) [-].
/// @param input_speed  at the peak [rad/s]; > 0
/// @param duration     of one peak [s]; > 0
[[nodiscard]] double allowed_momentary_peaks(double input_speed, double duration);

}  // namespace strainwave
