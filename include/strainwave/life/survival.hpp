// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "strainwave/life/duty.hpp"

namespace strainwave {

/// Weibull's slope with which half of the bearings reach five times L10, as makers state (LI-4)
/// [-].
[[nodiscard]] double makers_weibull_slope();

/// A part whose life is distributed after Weibull (LI-4).
struct WeibullLife {
  double ten_percent = 0.0;               ///< L10, which 90 % of the parts reach [s]; > 0
  double slope = makers_weibull_slope();  ///< e [-]; > 0

  /// Share of the parts that reach a time [-].
  [[nodiscard]] double survival(double time) const;
  /// Time that a share of the parts reaches [s].
  /// @param share  [-]; in (0, 1)
  [[nodiscard]] double time_of(double share) const;
};

/// Life of the wave generator's bearing by the maker's rule (LI-3) [s].
/// @param rated_life    L_n at rated torque and 2000 rpm; L10 or L50 [s]; > 0
/// @param rated_torque  T_N [N*m]; > 0
/// @param duty          T_av [N*m] and n_in,av [rad/s] of the duty, both > 0
/// @throws InputError   if a number is out of range
[[nodiscard]] double bearing_life(double rated_life, double rated_torque, const DutyAverage& duty);

/// Share of the drives of which every part reaches a time (LI-5) [-].
[[nodiscard]] double survival_of_all(std::span<const WeibullLife> parts, double time);

/// Time that a share of the drives reaches with every part (LI-5) [s].
/// @param parts  at least one
/// @param share  [-]; in (0, 1)
[[nodiscard]] double time_of_all(std::span<const WeibullLife> parts, double share);

}  // namespace strainwave
