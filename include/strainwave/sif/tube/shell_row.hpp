// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/core/crack_real.hpp"
#include "strainwave/sif/tube/shell_factors.hpp"

/// @file
/// A row of equal through cracks round a tube: what the curvature between the cracks changes.

namespace strainwave::sif {

/// Largest lambda of the table of rows.
inline constexpr double kShellRowTableEnd = 4.0;

/// Largest share 2 a/p of the table of rows at an angle [-].
/// @param angle  beta from the generator toward -theta [rad]
[[nodiscard]] double largest_tabulated_share(double angle);

/// What the curvature between the cracks of a row adds to their factors; eq. (CG-8).  The table is
/// summed over the angle once, for many sizes.
///
/// The factors of the row are those of a crack alone (SU-2) under the stress of the row in a flat
/// sheet (CG-7), plus these.  A place beyond the table has the values of its end.
///
/// Accuracy: with these, the compliance of a row is within 2 % of solid elements of tubes with r/t
/// = 30 and nu = 0.3, up to a shell parameter of 4.
template <class Real>
class BasicShellRowAtAngle {
 public:
  /// @param angle  beta from the generator toward -theta [rad]; in [-pi/2, pi/2]
  explicit BasicShellRowAtAngle(const Real& angle);

  /// @param lambda  shell parameter [-]; >= 0
  /// @param share   2 a/p, length of a crack over the pitch of the row [-]; >= 0
  [[nodiscard]] BasicShellFactors<Real> at(const Real& lambda, const Real& share) const;

 private:
  Real angle_;
  std::vector<Real> table_;  ///< coefficients over lambda, share and columns
};

extern template class BasicShellRowAtAngle<double>;
extern template class BasicShellRowAtAngle<CrackReal>;

}  // namespace strainwave::sif
