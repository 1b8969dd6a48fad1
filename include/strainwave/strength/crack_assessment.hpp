// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// Strength of every crack of a drive at the given load: K against toughness, net section against
/// yield, failure assessment with reserve and critical sizes; eqs. (FA-4), (FA-5), (FA-13).
///
/// A crack beyond critical is answered like any other.  Cracks that act in the coupled drive only
/// are answered with `cannot_tell`.
///
/// @param gear     drive, cracks, load; checked by `check`
/// @param reports  of torsional_stiffness for this drive: the uncertainty of K is taken from them
/// @return         one per crack: wave generator, flexspline, mesh, circular spline, output shaft
/// @throws InputError  if the gear breaks a rule
[[nodiscard]] std::vector<CrackStrength> crack_strength(const GearSet& gear,
                                                        std::span<const CrackReport> reports);

/// The same, with the reports of the corrected method.
[[nodiscard]] std::vector<CrackStrength> crack_strength(const GearSet& gear);

/// Share of crack or ligament up to which a plastic zone counts as small [-].
inline constexpr double kSmallScaleYielding = 0.1;

/// What a reader must know of the answers: `strength.breaks` (critical) for each crack that
/// fractures or collapses, `strength.cannot_tell` with the next step for each that cannot be told,
/// `crack.plastic_zone` where linear elasticity ends, and `strength.scope` for what they leave out.
/// @param cracks  of `crack_strength`
[[nodiscard]] std::vector<Note> strength_notes(std::span<const CrackStrength> cracks);

}  // namespace strainwave
