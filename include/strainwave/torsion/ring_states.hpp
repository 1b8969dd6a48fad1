// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/torsion/assembled_drive.hpp"

/// @file
/// Moment, hoop force and hoop stress of the rings that bend beside the rim.

namespace strainwave {

/// The rings of the coupled drive apart from the rim, whose states are those of `rim_states`.
enum class BendingRing {
  outer_ring,      ///< of the wave generator's bearing
  circular_spline  ///< as far as its housing lets it bend
};

/// Internal forces of a ring at one place, and the hoop stresses of its surfaces.
struct RingState {
  double position = 0.0;  ///< angle from the major axis, toward +theta [rad]
  /// M, positive where the ring bends more, with tension outside [N*m]
  double bending_moment = 0.0;
  double hoop_force = 0.0;  ///< EA times the strain of the centre line, N + M/R, tension > 0 [N]
  double outside_stress = 0.0;  ///< hoop stress at the outer surface [Pa]
  double inside_stress = 0.0;   ///< hoop stress at the inner surface: raceway or tooth roots [Pa]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"position", "rad", "angle from the major axis"}, &RingState::position);
    field({"bending_moment", "N*m", "M, positive where the ring bends more"},
          &RingState::bending_moment);
    field({"hoop_force", "N", "EA times the strain of the centre line, N + M/R, tension > 0"},
          &RingState::hoop_force);
    field({"outside_stress", "Pa", "hoop stress at the outer surface"}, &RingState::outside_stress);
    field({"inside_stress", "Pa", "hoop stress at the inner surface"}, &RingState::inside_stress);
  }
};

/// States of a ring over a turn of the wave generator, in which each point of the ring passes all
/// positions: the outer ring with the flexspline, the circular spline on its own (TC-28).
///
/// Implements theory manual eqs. (TC-38) for the outer ring and (TC-39) for the circular spline,
/// with the curvature and the forces of the coupled drive.  The outer ring slides in the rim and
/// carries no hoop force.  The circular spline carries the share of the load that its housing
/// leaves to it, without the harmonics 0 and 1.  Both are thin rings of constant section: the
/// equations leave out the groove, the fit, the stress of the contacts, and the concentration at
/// tooth roots. The stress of a thick circular spline is up to 10 % larger at its inner surface.
///
/// @param drive      the assembled drive, with its cracks and deviations
/// @param ring       a ring that bends (`bends`)
/// @param torque     torque T at the output [N*m], finite
/// @param positions  number of positions, evenly over a turn; > 0
/// @throws InputError   if the ring is a circular spline that the file does not give or that does
///                      not bend, if the torque is not finite, or if `positions` is not > 0
/// @throws SolverError  if there is no equilibrium
[[nodiscard]] std::vector<RingState> ring_states(const AssembledDrive& drive, BendingRing ring,
                                                 double torque, int positions);

/// Whether a ring bends in the coupled drive: the circular spline only if it has a support above 0.
[[nodiscard]] bool bends(const GearSet& gear, BendingRing ring);

}  // namespace strainwave
