// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// Torsional stiffness of a drive by the article's models with their plain errors corrected.
///
/// Implements theory manual eqs. (AR-1) to (AR-9).  Corrected here, compared with the method as
/// printed: the compliance of the race crack does not depend on the load (AR-2) and acts in series
/// (AR-3); the mean radius is (d_1 - delta)/2 (AR-5); the factor of a cup counts once (AR-6); the
/// equivalent shaft has the polar moment of the hollow one (AR-7); the compliance of the shaft
/// crack follows from the handbook's K_III by integration over the annulus (AR-8).  Kept from the
/// article: the shear beta/2 sigma_max as the tension of the race, the area t_i da, the rotation of
/// the cam, 0.1 for pi/32, K_u K_d, no crack closure, no shell effect.
///
/// The accuracy cannot be stated: this method exists to show how much of the article's result is
/// due to misprints.  It takes one crack per member, of the kinds that the method as printed takes.
/// `[article]` is not read.
///
/// @param gear         the drive
/// @return             compliances, stiffness, cracks, notes
/// @throws InputError  if `check(gear)` refuses the drive, or the article's method cannot treat it
[[nodiscard]] StiffnessResult torsional_stiffness_repaired(const GearSet& gear);

}  // namespace strainwave
