// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Options of the solution of the coupled drive.

namespace strainwave {

/// Resolution, tolerances and assumptions of the solution of the coupled drive.
struct CoupledOptions {
  int harmonics = 32;             ///< N of the ring [-]; 8 to 128; error of K 0.1 % at 32
  bool diaphragm_warping = true;  ///< whether the diaphragm resists warping of the barrel (TC-2)
  /// psi_0, angle of the first ball from the major axis [rad]; the cam is that of the drive with a
  /// ball at the lobe (TC-12)
  double cage_phase = 0.0;
  double tolerance = 1e-11;  ///< tolerance of the contact forces, relative to the largest [-]
  int max_iterations = 200;  ///< Newton steps per load
};

}  // namespace strainwave
