// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// Strength of every crack of a drive at the given load; eqs. (FA-4), (FA-5), (FA-13).  It compares
/// K with toughness and the net section with yield, and gives the failure assessment with reserve
/// and critical sizes.
///
/// A crack beyond its critical size gets the same kind of answer as any other.  Cracks that act in
/// the coupled drive only get the answer `cannot_tell`.
///
/// @param gear     drive, cracks, load; checked by `check`
/// @param reports  reports of torsional_stiffness for this drive; they give the uncertainty of K
/// @return         one per crack, in the order wave generator, flexspline, mesh, circular spline,
///                 output shaft
/// @throws InputError  if the gear breaks a rule
[[nodiscard]] std::vector<CrackStrength> crack_strength(const GearSet& gear,
                                                        std::span<const CrackReport> reports);

/// Strength of every crack; this overload computes the reports by the corrected method.
[[nodiscard]] std::vector<CrackStrength> crack_strength(const GearSet& gear);

/// Largest share of crack or ligament at which a plastic zone counts as small [-].
inline constexpr double kSmallScaleYielding = 0.1;

/// Notes on the answers: `strength.breaks` (critical) for each crack that fractures or collapses,
/// `strength.cannot_tell` with the next step for each crack without an assessment,
/// `crack.plastic_zone` where linear elasticity ends, and `strength.scope` for effects that the
/// answers leave out.
/// @param cracks  answers of `crack_strength`
[[nodiscard]] std::vector<Note> strength_notes(std::span<const CrackStrength> cracks);

}  // namespace strainwave
