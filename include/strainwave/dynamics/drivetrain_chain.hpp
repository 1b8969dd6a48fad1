// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/dynamics/torsional_chain.hpp"
#include "strainwave/model/input/drivetrain.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// A drive between its motor and its load as a chain of inertias and springs.

namespace strainwave {

/// Compliances of the three springs of a drive, at the flexspline's torque or the output's torque
/// [rad/(N*m)]; >= 0, not all 0.
struct DriveSprings {
  double mesh = 0.0;   ///< from wave generator and circular spline to the rim of the flexspline
  double body = 0.0;   ///< from the rim of the flexspline to its hub
  double shaft = 0.0;  ///< from the output of the gear to the load
};

/// Moments of inertia of the gear's own parts [kg*m^2]; >= 0.
struct GearInertias {
  double rim = 0.0;              ///< rim of the flexspline, and half of its barrel
  double hub = 0.0;              ///< diaphragm and boss of the flexspline, half of its barrel
  double circular_spline = 0.0;  ///< ring of the circular spline
  double shaft = 0.0;            ///< output shaft; half of it turns with the output of the gear
};

/// Moments of inertia of flexspline, circular spline and output shaft by their geometry (DY-9).  A
/// part whose material has no density has no inertia.
[[nodiscard]] GearInertias gear_inertias(const GearSet& gear);

/// The chain of a drive, with the place of each spring of the drive in it.
struct DrivetrainChain {
  TorsionalChain chain;   ///< inertias and springs, from the motor to the load
  std::size_t motor = 0;  ///< index of the inertia that the motor turns
  std::size_t load = 0;   ///< index of the inertia of the load
  /// share of mesh, body and shaft in the compliance of each spring of the chain [-]; all 0 for the
  /// coupling
  struct Parts {
    double mesh = 0.0;   ///< share of DriveSprings::mesh [-]
    double body = 0.0;   ///< share of DriveSprings::body [-]
    double shaft = 0.0;  ///< share of DriveSprings::shaft [-]
  };
  std::vector<Parts> parts = {};  ///< as many as the chain has springs
  /// Index of the spring in which the kinematic error acts: the mesh, or the first spring behind it
  /// if the mesh is rigid.
  std::size_t error_spring = 0;
  /// Error of the twist of this spring per kinematic error at the output, with sign (DY-12) [-].
  double error_twist = 0.0;
};

/// Implements theory manual eq. (DY-10).  Inertias are motor, wave generator (behind a coupling),
/// rim, output of the gear and load.  Springs in series without an inertia between them are one
/// spring, and a spring without compliance joins its inertias.
/// @param drivetrain   fixed member, coupling, inertias and dampings
/// @param ratio        i, turns of the wave generator in one turn of the flexspline, without sign
///                     [-]; > 0
/// @param springs      compliances of mesh, body and shaft [rad/(N*m)]; >= 0, not all 0
/// @param own          inertias of the gear's parts [kg*m^2]; >= 0
/// @throws InputError  if a number is out of range, or the drive has no compliance
[[nodiscard]] DrivetrainChain drivetrain_chain(const Drivetrain& drivetrain, double ratio,
                                               const DriveSprings& springs,
                                               const GearInertias& own);

}  // namespace strainwave
