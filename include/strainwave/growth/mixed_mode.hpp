// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Stress intensity factors, or their ranges, of the three modes [Pa*m^0.5].
struct ModeFactors {
  double I = 0.0;    ///< opening; < 0 presses the faces together
  double II = 0.0;   ///< sliding, in the plane
  double III = 0.0;  ///< tearing, out of the plane
};

/// One stress intensity factor for three modes.
enum class MixedMode {
  energy,                     ///< that of the same energy release rate in plane strain (GR-13)
  tanaka,                     ///< (GR-14)
  richard,                    ///< (GR-15); pressed faces, K_I < 0, count as K_I = 0
  largest_tangential_stress,  ///< modes I and II (GR-16); a crack that turns to its new direction
};
template <>
struct EnumNames<MixedMode> {
  static constexpr std::array<std::string_view, 4> names = {"energy", "tanaka", "richard",
                                                            "largest_tangential_stress"};
};

/// Equivalent stress intensity factor [Pa*m^0.5]; >= 0.
/// @param rule            which of the equations (GR-13) to (GR-16)
/// @param K               a crack with K_I < 0 is pressed together and counts as K_I = 0
/// @param poissons_ratio  nu [-]; -1 < nu < 0.5 is checked for each rule; energy and tanaka use it
/// @throws InputError     if a number is not finite, if nu is not in (-1, 0.5), and for the largest
///                        tangential stress, if K_III is not 0
[[nodiscard]] double equivalent_factor(MixedMode rule, const ModeFactors& K, double poissons_ratio);

/// Angle by which a crack under modes I and II turns, by the largest tangential stress (GR-16)
/// [rad].
///
/// Positive angles turn toward the side that K_II > 0 presses in; the range is -70.53 to 70.53
/// degrees.  0 for K_II = 0.
/// @throws InputError  if a number is not finite or K_III is not 0
[[nodiscard]] double kink_angle(const ModeFactors& K);

}  // namespace strainwave
