// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/dynamics/drivetrain_chain.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/modes_report.hpp"

// The drive of a file as a chain of inertias and springs, sound and cracked.

namespace strainwave {

/// The three springs of a drive.
enum class SpringPlace { mesh, body, shaft };

/// A crack that is a spring of its own.
struct SeriesCrack {
  std::string path;
  SpringPlace spring = SpringPlace::mesh;
  double compliance = 0.0;  ///< at the output, circular spline fixed [rad/(N*m)]; > 0
};

struct VibratingMember {
  std::string name;
  SpringPlace spring = SpringPlace::mesh;
  double compliance = 0.0;  ///< at the output, circular spline fixed [rad/(N*m)]
};

/// The three springs as sums of their members.
[[nodiscard]] DriveSprings springs_of(const std::vector<VibratingMember>& members);

/// The drive with springs, as a chain with its elastic modes.
struct VibratingDrive {
  std::vector<VibratingMember> members;
  std::vector<SeriesCrack> cracks;
  DrivetrainChain made;
  double step = 1.0;  ///< torque of the flexspline over that of the output, with sign [-]

  /// The inertias that do not turn for a condition of the motor.
  [[nodiscard]] std::vector<std::size_t> held(MotorGives motor) const;
  [[nodiscard]] std::vector<ChainMode> modes(MotorGives motor) const;
  /// At the output, with locked input (DY-10) [N*m/rad].
  [[nodiscard]] double stiffness() const;
};

struct VibratingOptions {
  std::optional<double> torque = {};  ///< T at the output [N*m]; absent: that of the load
  bool without_each_crack = false;    ///< whether the drives without one crack are asked too
};

/// A drive sound and with its cracks, about one torque.
struct VibratingStates {
  double torque = 0.0;  ///< T at the output [N*m]
  SpringModel springs = SpringModel::members;
  VibratingDrive intact;
  std::optional<VibratingDrive> with_cracks = {};  ///< absent: no crack
  /// the drive without each of its cracks, by the path of that crack
  std::vector<std::pair<std::string, VibratingDrive>> without_one = {};
  std::vector<Note> notes = {};  ///< of the inertias and of the springs
};

/// The springs are linear about a torque: the tangent of the torsion curve if the file gives enough
/// for it, else the sum of the members (DY-9, DY-10).
/// @param purpose  what needs the drivetrain, for the message: "the modes"
/// @throws InputError   if the drive has no drivetrain, or no compliance
/// @throws SolverError  if the coupled drive has no equilibrium at the torque
[[nodiscard]] VibratingStates vibrating_states(const GearSet& of_file,
                                               const VibratingOptions& options,
                                               std::string_view purpose, const Progress& progress);

/// The drive with the cracks that it has, about a torque; it must have a drivetrain and be checked.
/// @param torque  T at the output [N*m]
/// @throws SolverError  if the coupled drive has no equilibrium at the torque
[[nodiscard]] VibratingDrive vibrating_drive(const GearSet& gear, double torque);

/// The same about each of several torques.  Absent where no flank touches and where the twist is
/// not known, because the drive has no stiffness there.
/// @param torques  at the output [N*m]
/// @throws SolverError  if the coupled drive cannot be assembled
[[nodiscard]] std::vector<std::optional<VibratingDrive>> vibrating_drives(
    const GearSet& gear, std::span<const double> torques);

/// The drive of a file with another torque of its load, under which the contacts of the bearing
/// have another stiffness.  The torque of the file stays if the wave generator has numbers of this
/// torque, and if the other one is 0, under which a bearing has no stiffness.
/// @param torque  T at the output [N*m]
[[nodiscard]] GearSet with_load_torque(GearSet gear, double torque);

/// The drive without one of its cracks.
[[nodiscard]] GearSet without_crack(GearSet gear, const std::string& path);

}  // namespace strainwave
