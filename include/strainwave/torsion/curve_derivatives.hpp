// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "strainwave/core/dual.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

/// @file
/// Exact derivatives of K1, K2, K3 to the numbers of a drive.

namespace strainwave {

/// The maker's stiffnesses in the scalar of a lift [N*m/rad].
template <class Real>
struct LineValues {
  Real K1{};
  Real K2{};
  Real K3{};
};

/// Of the sound drive, and with the cracks under both senses of torque.
struct CurveDerivatives {
  LineValues<DualReal> intact;
  LineValues<DualReal> positive;
  LineValues<DualReal> negative;
};

/// Derivatives of K1, K2, K3 by those of the equilibrium.
///
/// Implements theory manual eqs. (TC-27), (SN-3): the forces of the contacts solve a system whose
/// derivative is linear; its adjoint is solved once for each torque, and then the derivative to any
/// number is that of the closings at fixed forces, in dual numbers.  Exact but for rounding.
///
/// A contact that opens or closes does no harm: its stiffness grows from zero, and the secants K1,
/// K2, K3 keep a continuous first derivative.  Without coning (`mesh.coning` = 0) a flank has its
/// whole stiffness at once, and the derivative is that of the flanks which touch.
///
/// Not differentiated: `curve_steps`.
class CurveDifferentiator {
 public:
  /// Solves the states and their adjoints.
  /// @throws SolverError  if the curve is not usable
  explicit CurveDifferentiator(const AssembledDrive& drive);

  /// @param gear    that of the drive, at the addresses that the lift knows
  /// @param series  of the same gear and lift
  [[nodiscard]] CurveDerivatives of(const GearSet& gear, const Lift<DualReal>& lift,
                                    const SeriesCompliance<DualReal>& series) const;

 private:
  struct Contents;
  std::shared_ptr<const Contents> contents_;
};

/// A number that the coupled drive reads and that has no derivative.
struct CurveStep {
  std::string path;
  std::string reason;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "field of the input"}, &CurveStep::path);
    field({"reason", "", "the reason why there is no derivative"}, &CurveStep::reason);
  }
};

/// Numbers to which K1, K2, K3 are not differentiated: the ratio, which sets the number of teeth,
/// and positions that choose the nearest tooth or ball.
[[nodiscard]] std::vector<CurveStep> curve_steps(const GearSet& gear);

}  // namespace strainwave
