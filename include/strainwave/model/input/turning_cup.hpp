// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/cam_curve.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// What every model of a turn of the wave generator reads from a drive: a cup that is bent oval,
/// and the cam in it.

namespace strainwave {

/// Whether the oval is computed with large rotations.
enum class LargeRotations {
  automatic,  ///< if the second-order stress E (w_0/R)^2 exceeds 2 % of the rim's bending stress
  on,
  off  ///< small rotations
};
template <>
struct EnumNames<LargeRotations> {
  static constexpr std::array<std::string_view, 3> names = {"auto", "on", "off"};
};

/// The cam of a drive; without a wave generator, a cosine of the drive's w_0 on the whole rim.
[[nodiscard]] CamFit cam_fit(const GearSet& gear);

/// Whether the perimeter of the cam is taken to be that of the bore, because the file gives none.
[[nodiscard]] bool perimeter_is_assumed(const GearSet& gear);

/// Whether the rim's wall covers the barrel's wall inside and outside.
[[nodiscard]] bool rim_covers(const TubeSection& rim, const TubeSection& barrel);

/// Refuses a drive whose flexspline is not a cup, or a cylinder, that two lobes bend oval.
///
/// @param gear  has passed `check`
/// @throws InputError  if the flexspline is missing, is a hat, or has no sections; if the rim is
///                     missing or does not cover the barrel; for another wave number than 2; if
///                     the cam does not fit the bore, or stretches the rim beyond its yield
///                     strength
void require_turning_cup(const GearSet& gear);

}  // namespace strainwave
