// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/fe_study/member_run.hpp"
#include "strainwave/fem/fields.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave::fe_study {

/// Fields of a cracked shaft at the given torque and force, with the energy density of the sound
/// shaft.  A force that presses the faces together passes through them as in the sound shaft.
[[nodiscard]] fem::SampledFields fields_at_load(const ShaftCrackRun& run, const GearSet& gear);

/// Fields of a cup at the given torque.
[[nodiscard]] fem::SampledFields fields_at_load(const gear_fem::CupResult& cup,
                                                const GearSet& gear);

/// The annular front as a polygon, with its stress intensity at the given load.
[[nodiscard]] fem::CrackFront front_at_load(const ShaftCrackRun& run, const GearSet& gear);

}  // namespace strainwave::fe_study
