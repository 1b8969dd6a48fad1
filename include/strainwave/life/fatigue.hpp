// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Sensitivity of steel to the mean stress, M = 0.35e-3 R_m/MPa - 0.1 (LI-6) [-]; at least 0.
/// @param tensile_strength  R_m [Pa]; > 0
[[nodiscard]] double mean_stress_sensitivity(double tensile_strength);

/// Amplitude at R = -1 that damages like a cycle of another mean stress (LI-7) [Pa].
/// @param amplitude    sigma_a [Pa]; >= 0
/// @param mean         sigma_m [Pa]
/// @param sensitivity  M [-]; 0 <= M < 1
[[nodiscard]] double amplitude_without_mean(double amplitude, double mean, double sensitivity);

/// The line of stress amplitude over cycles below its knee.
enum class MinerRule {
  original,    ///< amplitudes below the knee do not damage
  elementary,  ///< the line goes on with its slope
  haibach,     ///< the line goes on with the slope 2 k - 1
};
template <>
struct EnumNames<MinerRule> {
  static constexpr std::array<std::string_view, 3> names = {"original", "elementary", "haibach"};
};

/// A line of stress amplitude over cycles, for R = -1.
struct WoehlerLine {
  double knee_amplitude = 0.0;  ///< amplitude at the knee [Pa]; > 0
  double knee_cycles = 0.0;     ///< cycles at the knee [-]; > 0
  double slope = 5.0;           ///< k [-]; >= 1
};

/// Damage of one cycle, 1/N (LI-8) [-].
/// @param line         its knee and its slope above the knee
/// @param amplitude    at R = -1 [Pa]; >= 0
/// @param rule         the line below the knee
/// @throws InputError  if a number is out of range
[[nodiscard]] double damage_per_cycle(const WoehlerLine& line, double amplitude, MinerRule rule);

}  // namespace strainwave
