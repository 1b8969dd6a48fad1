// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "coupled_drive.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

namespace strainwave {

/// The members in series with the ring.
struct SeriesMembers {
  double barrel = 0.0;
  double diaphragm = 0.0;
  double rim = 0.0;
  double boss_and_flange = 0.0;
  double output_shaft = 0.0;
  double cracks_positive = 0.0;
  double cracks_negative = 0.0;

  [[nodiscard]] double cracks(double torque) const {
    return torque < 0 ? cracks_negative : cracks_positive;
  }
  [[nodiscard]] double sound() const {
    return barrel + diaphragm + rim + boss_and_flange + output_shaft;
  }
};

struct AssembledDrive::Contents {
  GearSet gear;
  CoupledOptions options;
  CoupledGeometry geometry;
  CoupledDrive sound;  // the sound drive on its cam
  ContactCracks cracks;
  CoupledDrive drive;  // the drive with its cracks, on the cam of the sound drive
  SeriesMembers series;
  std::vector<Note> notes;
  std::vector<std::string> equations;
  std::string sound_fails_because;  // reason; empty if the sound drive assembles
  std::string fails_because;        // reason; empty if the drive with its cracks assembles
  std::string series_unusable;      // reason; empty if the members in series may be used

  /// Twist of the output at a state of the rings (TC-14) [rad].
  [[nodiscard]] double twist(const Equilibrium& state) const {
    return (state.rotation - drive.assembled().rotation) / geometry.ring_radius +
           (series.sound() + series.cracks(state.torque)) * state.torque;
  }
};

}  // namespace strainwave
