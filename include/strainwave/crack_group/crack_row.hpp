// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/crack_real.hpp"

/// @file
/// A row of equal, parallel and evenly spaced cracks in an elastic sheet, in the scalar `Real`:
/// double, or CrackReal for the derivatives of everything.

namespace strainwave {

/// Stress intensity factors of a crack of the row over sigma sqrt(pi a), from a normal and from a
/// shear stress of the sheet on the plane of the crack [-].  The signs are those of (FR-6).
template <class Real>
struct BasicRowFactors {
  Real opening_by_normal{};  ///< K_I from the normal stress; 1 for a crack alone
  Real sliding_by_normal{};  ///< K_II from the normal stress; 0 for a crack alone
  Real opening_by_shear{};   ///< K_I from the shear stress; 0 for a crack alone
  Real sliding_by_shear{};   ///< K_II from the shear stress; 1 for a crack alone
};
/// BasicRowFactors without derivatives.
using RowFactors = BasicRowFactors<double>;

/// Factors of a row whose faces are apart; eq. (CG-7).
///
/// The row runs along one direction.  Each crack is inclined by beta from the normal of this
/// direction, so the row round a wall has the angle of (FR-6).  Both tips of a crack have the same
/// factors.
///
/// Accuracy: 1e-9 for gaps of at least kLeastRowGap.  The sheet is infinite and flat.
///
/// @param share  2 a/p, length of a crack over the pitch of the row [-]; >= 0
/// @param angle  beta [rad]
/// @throws InputError  if neighbours touch
/// @{
[[nodiscard]] RowFactors row_factors(double share, double angle);
[[nodiscard]] BasicRowFactors<CrackReal> row_factors(const CrackReal& share,
                                                     const CrackReal& angle);
/// @}

/// K_II over tau sqrt(pi a) of a row whose faces are pressed together and slide without friction
/// [-]; 1 for a crack alone; eq. (CG-7).
/// @param share  2 a/p, length of a crack over the pitch of the row [-]; >= 0
/// @param angle  beta [rad]
/// @throws InputError  if neighbours touch
/// @{
[[nodiscard]] double pressed_row(double share, double angle);
[[nodiscard]] CrackReal pressed_row(const CrackReal& share, const CrackReal& angle);
/// @}

/// Normal stress that the neighbours of a row cause on faces that are pressed together, over the
/// shear stress tau of the sheet on them [-].
struct PullOfRow {
  double least = 0.0;  ///< along the faces; <= most
  double most = 0.0;   ///< along the faces
};

/// The pull of the neighbours on pressed faces; eq. (CG-7).
/// @param share  2 a/p, length of a crack over the pitch of the row [-]; > 0
/// @param angle  beta [rad]
/// @throws InputError  if neighbours touch
[[nodiscard]] PullOfRow pull_of_row(double share, double angle);

/// Smallest distance between neighbours of a row, over the half length of a crack [-]; 0 if they
/// touch.
/// @param share  2 a/p [-]; > 0
/// @param angle  beta [rad]
[[nodiscard]] double row_gap(double share, double angle);

/// Smallest gap of a row, over the half length of a crack, whose factors are exact to 1e-9 [-].
inline constexpr double kLeastRowGap = 0.2;

/// Largest share 2 a/p of a row at which the gap is at least `gap` [-].
/// @param angle  beta [rad]
/// @param gap    over the half length of a crack [-]; > 0
[[nodiscard]] double largest_row_share(double angle, double gap = kLeastRowGap);

}  // namespace strainwave
