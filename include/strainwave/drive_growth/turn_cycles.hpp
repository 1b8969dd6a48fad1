// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/growth/mixed_mode.hpp"
#include "strainwave/growth_laws/tip_cycle.hpp"

/// @file
/// The cycles of K over a turn of the wave generator.

namespace strainwave {

/// The cycle of one wave, or of a change from one load to another one.
///
/// Implements theory manual eq. (GR-31).  The range is the largest equivalent range between two
/// moments of the turns, and K_max is the largest equivalent factor of all moments.  No pair of
/// moments has a larger range or a larger K_max.
///
/// @param rule            makes one K of three modes
/// @param one             K at the angles of a turn under one load [Pa*m^0.5]; not empty
/// @param other           the same under the other load, or `one` again
/// @param poissons_ratio  nu [-]
/// @return                R = 1 if K stands still above 0; K_max = 0 and R = 0 if the crack stays
///                        closed
[[nodiscard]] TipCycle cycle_of_turns(MixedMode rule, std::span<const Modes> one,
                                      std::span<const Modes> other, double poissons_ratio);

/// A smaller cycle within a turn.
struct CycleWithinTurn {
  TipCycle cycle;      ///< K_max and R of the cycle
  double count = 0.0;  ///< per wave [-]; > 0
};

/// The cycles of a turn beside the widest one of each wave.
///
/// Implements theory manual eq. (GR-31): rainflow over the closed turn of K along the direction, in
/// the space of the three modes, of its widest range.
///
/// @param rule            makes one K of three modes
/// @param turn            K at the angles of a turn [Pa*m^0.5]; not empty
/// @param waves           waves of which the turn consists; >= 1
/// @param poissons_ratio  nu [-]
[[nodiscard]] std::vector<CycleWithinTurn> cycles_within_turn(MixedMode rule,
                                                              std::span<const Modes> turn,
                                                              int waves, double poissons_ratio);

/// Estimate of what the angles of a table miss of the widest range, as a share of it [-]: parabolas
/// through both extremes and their neighbours (GR-31).
/// @param rule            makes one K of three modes
/// @param turn            as in cycles_within_turn
/// @param angles          of the turn, with the first one again at the end [rad]
/// @param poissons_ratio  nu [-]; in (-1, 0.5)
[[nodiscard]] double missed_between_angles(MixedMode rule, std::span<const Modes> turn,
                                           std::span<const double> angles, double poissons_ratio);

}  // namespace strainwave
