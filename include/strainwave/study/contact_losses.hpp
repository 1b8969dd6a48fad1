// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/motion/losses.hpp"
#include "strainwave/motion/twist_loops.hpp"

/// @file
/// Friction in the contacts of a drive, by its coupled model, for motions.

namespace strainwave {

/// What a motion takes from the contacts of the coupled drive.
struct ContactLosses {
  double width_at_rest = 0.0;     ///< w without torque, at the output [rad]
  double width_at_rated = 0.0;    ///< w at the rated torque, mean of both senses [rad]
  double teeth_in_contact = 0.0;  ///< at the rated torque, mean of both senses [-]
  double memory_angle = 0.0;      ///< Theta, angle of the input over which the loops fade [rad]
  /// Friction of the turning input; absent: the file gives its own.
  std::optional<double> coulomb = {};       ///< F_c [N*m]
  std::optional<double> load_coulomb = {};  ///< kappa_c [-]
  /// largest deviation of F_c + kappa_c L from the computed torque at T1, T2, T3 and the rated
  /// torque, over the latter [-]
  std::optional<double> worst_deviation = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"width_at_rest", "rad", "width of the loops without torque, at the output"},
          &ContactLosses::width_at_rest);
    field({"width_at_rated", "rad", "width of the loops at the rated torque, mean of both senses"},
          &ContactLosses::width_at_rated);
    field({"teeth_in_contact", "1", "teeth in contact at the rated torque, mean of both senses"},
          &ContactLosses::teeth_in_contact);
    field({"memory_angle", "rad", "angle of the input over which the loops fade to 1/e"},
          &ContactLosses::memory_angle);
    field({"coulomb", "N*m",
           "friction of the turning input without load; absent: the file gives its own"},
          &ContactLosses::coulomb);
    field({"load_coulomb", "1", "share of the torque on the load, over the ratio, that adds to it"},
          &ContactLosses::load_coulomb);
    field({"worst_deviation", "1",
           "largest deviation of this straight line from the computed torques, over them"},
          &ContactLosses::worst_deviation);
  }
};

/// Friction in the contacts for a motion.
struct DriveContacts {
  std::shared_ptr<const TwistLoops> loops;  ///< loops of the twist by slip in the contacts
  std::optional<LuGre> friction = {};       ///< absent: the file gives its own
  ContactLosses losses;                     ///< the numbers of loops and friction, for a report
};

/// Implements theory manual eqs. (MO-52) to (MO-54), from (TC-16), (TC-33) and (TC-34).
///
/// The drive is sound: its cracks change the loops by less than the model knows them.
/// @param gear      with a drivetrain that asks for `contact_friction`
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if the file lacks an input of the coupled drive
/// @throws SolverError  if the coupled drive does not bear the largest torque of the loops
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] DriveContacts drive_contacts(const GearSet& gear, const Progress& progress = {});

}  // namespace strainwave
