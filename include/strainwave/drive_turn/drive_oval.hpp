// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/model/input/oval_request.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/oval_stress.hpp"
#include "strainwave/oval_shell/oval_shell.hpp"

/// @file
/// Stress of the sound flexspline over a turn of the wave generator, without finite elements.

namespace strainwave {

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
struct DriveOval : OvalState {
  ShellContact contact;  ///< of the wave generator
  std::vector<BandPressure> pressure;
  std::vector<Note> notes;             ///< on the validity of the answer
  std::vector<std::string> equations;  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = DriveOval;
    OvalState::describe(field);
    field({"wave_generator", "", "contact of the wave generator with the bore"}, &R::contact);
    field({"pressure", "", "of the wave generator on the bore"}, &R::pressure);
  }
};

/// Computes the stress of a sound flexspline over a turn.
///
/// Implements theory manual eqs. (CU-1) to (CU-4).  The flexspline is a thin shell without cracks
/// and without teeth, under the wave generator and a torque that acts evenly round the rim.
///
/// Range: as oval_shell.
/// Accuracy: the table of (CU-4).  Where two walls meet, the stress is that of the shell; fillets
/// and notches are not in it.  Notes say what a boss and a profile of the diaphragm change.
///
/// @throws InputError   as plan_oval; if the cam does not touch the bore
/// @throws SolverError  if the contact or the large rotations do not converge
[[nodiscard]] DriveOval drive_oval(const GearSet& gear, const OvalRequest& request = {});

}  // namespace strainwave
