// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// Stress of the assembly on the plane of a crack in the flexspline's wall, at its surface [Pa].
struct AssemblyStress {
  double normal = 0.0;  ///< on the crack plane, where the hoop stress is tension
  double shear = 0.0;   ///< along the crack, of the same moment; sign as in CrackPlaneStress
};

/// Implements theory manual eq. (FA-12): the hoop stress sigma_b of (ST-17) in a wall of this
/// radius and thickness, nu sigma_b along the axis, turned into the crack's frame,
///
///     normal = sigma_b (cos^2(beta) + nu sin^2(beta)),
///     shear  = -(1 - nu) sigma_b sin(beta) cos(beta).
///
/// Amplitude of w_0 cos(U theta) at the crack; in a cup it falls along the axis: an upper bound in
/// the barrel, but not on the rim, nor for a flattened cam.
///
/// @param gear         drive with a flexspline
/// @param mean_radius  r of the cracked wall [m]; > 0
/// @param thickness    t of the cracked wall [m]; > 0
/// @param angle        beta of the crack [rad]
[[nodiscard]] AssemblyStress assembly_stress(const GearSet& gear, double mean_radius,
                                             double thickness, double angle);

/// Strength of every crack of a drive at the given load: K against toughness, net section against
/// yield, failure assessment with reserve and critical sizes; eqs. (FA-4), (FA-5), (FA-13).
///
/// A crack beyond critical is answered like any other.  Cracks that act in the coupled drive only
/// are answered with `cannot_tell`.
///
/// @param gear     drive, cracks, load; checked by `check`
/// @param reports  of torsional_stiffness for this drive: the race cracks' stress is taken from it
/// @return         one per crack: wave generator, flexspline, mesh, circular spline, output shaft
/// @throws InputError  if the gear breaks a rule
[[nodiscard]] std::vector<CrackStrength> crack_strength(const GearSet& gear,
                                                        std::span<const CrackReport> reports);

/// The same, with the reports of the corrected method.
[[nodiscard]] std::vector<CrackStrength> crack_strength(const GearSet& gear);

}  // namespace strainwave
