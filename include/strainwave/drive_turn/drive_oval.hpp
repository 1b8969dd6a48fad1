// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/oval_stress.hpp"
#include "strainwave/oval_shell/oval_shell.hpp"

/// @file
/// Stress of the sound flexspline over a turn of the wave generator, without finite elements.

namespace strainwave {

struct OvalRequest {
  std::vector<double> torques = {};  ///< T at the output [N*m]; empty: that of the file
  LargeRotations large_rotations = LargeRotations::automatic;
};

/// Pressure of the cam on the bore.
struct BandPressure {
  static constexpr bool kTableRow = true;
  double angle{};     ///< from a lobe [rad]
  double pressure{};  ///< [Pa]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"angle", "rad", "from a lobe"}, &BandPressure::angle);
    field({"pressure", "Pa", "on the bore of the rim, even over the width of the band"},
          &BandPressure::pressure);
  }
};

/// Stress over a turn, with its evidence.
struct DriveOval {
  ShellContact contact;      ///< of the wave generator
  double coning_angle{};     ///< turn of the rim's meridian outward at a lobe [rad]
  bool large_rotations{};    ///< whether large rotations of the oval were computed
  double rotation_stress{};  ///< largest change of a stress by large rotations [Pa]
  std::vector<BandPressure> pressure;
  std::vector<LoadedOval> torques;
  std::vector<Note> notes;
  std::vector<std::string> equations;

  /// The station with the largest von Mises stress.
  [[nodiscard]] const OvalStation& governing() const { return governing_station(torques); }
  [[nodiscard]] double largest() const { return governing().equivalent.largest; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = DriveOval;
    field({.name = "largest",
           .unit = "Pa",
           .doc = "largest von Mises stress of the wall over a turn",
           .headline = true},
          &R::largest);
    field({"wave_generator", "", "contact of the wave generator with the bore"}, &R::contact);
    field({"coning_angle", "rad", "turn of the rim's meridian outward at a lobe"},
          &R::coning_angle);
    field({"large_rotations", "", "whether large rotations of the oval were computed"},
          &R::large_rotations);
    field(
        {"rotation_stress", "Pa", "largest change of a stress by large rotations; 0 without them"},
        &R::rotation_stress);
    field({"pressure", "", "of the wave generator on the bore"}, &R::pressure);
    field({"torques", "", "the stress under each torque"}, &R::torques);
  }
};

/// Computes the stress of a sound flexspline over a turn.
///
/// Implements theory manual eqs. (CU-1) to (CU-4).  The flexspline is a thin shell without cracks
/// and without teeth, under the wave generator and a torque that acts evenly round the rim.
///
/// Range: as oval_shell.
/// Accuracy: the table of (CU-4).  Where two walls meet, the stress is that of the shell; fillets
/// and notches are not in it.
///
/// @throws InputError   as `check` and require_turning_cup; if the cam does not touch the bore
/// @throws SolverError  if the contact or the large rotations do not converge
[[nodiscard]] DriveOval drive_oval(const GearSet& gear, const OvalRequest& request = {});

}  // namespace strainwave
