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
/// Exact derivatives of K1, K2, K3 with respect to the numbers of a drive.

namespace strainwave {

/// The maker's stiffnesses in the scalar of a lift [N*m/rad].
template <class Real>
struct LineValues {
  Real K1{};  ///< T1/phi(T1) [N*m/rad]
  Real K2{};  ///< slope from T1 to T2 [N*m/rad]
  Real K3{};  ///< slope from T2 to T3 [N*m/rad]
};

/// The lines of the sound drive, and those with the cracks under both senses of torque.
struct CurveDerivatives {
  LineValues<DualReal> intact;    ///< sound drive, torque about +z
  LineValues<DualReal> positive;  ///< with the cracks, torque about +z
  LineValues<DualReal> negative;  ///< with the cracks, torque about -z
};

/// Derivatives of K1, K2, K3 from the derivatives of the equilibrium.
///
/// Implements theory manual eqs. (TC-27), (SN-3): the forces of the contacts solve a system whose
/// derivative is linear.  The code solves the adjoint once for each torque.  The derivative with
/// respect to any number then follows from the derivatives of the closings at fixed forces, in dual
/// numbers.  Exact except for rounding.
///
/// The derivatives stay valid if a contact opens or closes, because its stiffness grows from zero
/// and the secants K1, K2, K3 keep a continuous first derivative.  Without coning (`mesh.coning` =
/// 0) a flank has its full stiffness as soon as it touches, and the derivative is that of the
/// flanks that touch.
///
/// Not differentiated: `curve_steps`.
class CurveDifferentiator {
 public:
  /// Solves the states and their adjoints.
  /// @throws InputError   if the cage has a phase other than 0, or a part deviates
  /// @throws SolverError  if the curve is not usable
  explicit CurveDifferentiator(const AssembledDrive& drive);

  /// @param gear    the drive whose addresses the lift contains
  /// @param lift    reads the numbers of the drive, and knows which of them are the inputs
  /// @param series  compliances by `series_compliance` for the same gear and lift
  [[nodiscard]] CurveDerivatives of(const GearSet& gear, const Lift<DualReal>& lift,
                                    const SeriesCompliance<DualReal>& series) const;

 private:
  struct Contents;
  std::shared_ptr<const Contents> contents_;
};

/// A number that the coupled drive reads but with respect to which it has no derivative.
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

/// Numbers with respect to which K1, K2, K3 have no derivative: the ratio, which determines the
/// number of teeth, and positions that select the nearest tooth or ball.
[[nodiscard]] std::vector<CurveStep> curve_steps(const GearSet& gear);

}  // namespace strainwave
