// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/ring_energy.hpp"

#include <string>

#include "assembled_drive_contents.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {

std::vector<RingEnergy> ring_energies(const AssembledDrive& assembled,
                                      std::span<const double> torques, const Progress& progress) {
  const AssembledDrive::Contents& contents = assembled.contents();
  std::vector<RingEnergy> made;
  const std::string unusable_because =
      walk(contents, torques, progress, [&](const Equilibrium& state) {
        made.push_back({.torque = state.torque,
                        .rotation = state.rotation / contents.geometry.ring_radius,
                        .energy = contents.drive.complementary_energy(state)});
      });
  if (!unusable_because.empty()) throw SolverError(unusable_because);
  return made;
}

double sound_series_compliance(const AssembledDrive& drive) {
  return drive.contents().series.sound();
}

}  // namespace strainwave
