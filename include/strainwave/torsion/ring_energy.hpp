// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

/// @file
/// Energy of the contacts and rings of a coupled drive, for motions.

namespace strainwave {

/// Contacts and rings in equilibrium at one torque.
struct RingEnergy {
  double torque = 0.0;    ///< T at the flexspline [N*m]
  double rotation = 0.0;  ///< c_0/R, from the nominal position against the wave [rad]
  double energy = 0.0;    ///< complementary energy W = T c_0/R - V, with dW/dT = c_0/R [J]
};

/// Rotation and complementary energy of contacts and rings at each torque (MO-27).
///
/// The members in series with the ring, and their cracks, are not contained.  The rotation has its
/// origin in the wave, not in the assembled state, so it can be compared between positions of the
/// wave generator.
/// @param drive     the assembled drive, with its cracks and deviations
/// @param torques   T [N*m], finite; each is solved starting from the state before it, the first
///                  from the assembly
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if a torque is not finite
/// @throws SolverError  if the curve is not usable; the message states the reason
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] std::vector<RingEnergy> ring_energies(const AssembledDrive& drive,
                                                    std::span<const double> torques,
                                                    const Progress& progress = {});

/// Compliance of the sound members in series with the ring (TC-13) [rad/(N*m)].
[[nodiscard]] double sound_series_compliance(const AssembledDrive& drive);

}  // namespace strainwave
