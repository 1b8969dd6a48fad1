// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "strainwave/torsion/tooth_flanks.hpp"

// The direction of the force of a flank.

namespace strainwave {

/// Shares of a flank in three directions (TC-6): outward, along the pitch circle, and the change of
/// the latter per unit of height above the pitch circle.
template <class Real>
struct BasicFlankShares {
  Real outward{};
  Real along{};
  Real higher{};
};
using FlankShares = BasicFlankShares<double>;

/// @param side  +1 for a drive flank, -1 for a coast flank
template <class Real>
[[nodiscard]] BasicFlankShares<Real> flank_shares(const BasicFlankContact<Real>& contact,
                                                  int side) {
  using std::cos, std::sin;
  const Real along = side * cos(contact.angle);
  return {.outward = sin(contact.angle), .along = along, .higher = along * contact.height};
}

}  // namespace strainwave
