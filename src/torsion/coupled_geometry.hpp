// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "strainwave/torsion/flank.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

// The numbers of the coupled drive, and of its cracks inside the contact problem.

namespace strainwave {

/// The numbers of the model, from the file [SI].
struct CoupledGeometry {
  // transmission
  double pitch_radius = 0.0;         // R_p
  double radial_displacement = 0.0;  // w_0
  int teeth = 0;                     // z
  double module = 0.0;               // m
  // rim and outer ring as one ring
  double ring_radius = 0.0;    // R
  double rim_thickness = 0.0;  // t_r
  double rim_width = 0.0;      // b
  double rim_bending = 0.0;    // EI of the rim
  double outer_bending = 0.0;  // EI of the outer ring
  double extension = 0.0;      // EA
  double outer_thickness = 0.0;
  double outer_width = 0.0;
  ElasticConstants rim_steel;
  ElasticConstants ball_steel;
  // barrel and diaphragm
  double barrel_length = 0.0;
  double barrel_thickness = 0.0;
  double length = 0.0;  // L, from the bottom to the open end
  // bearing
  double ball_stiffness = 0.0;  // K_h, Q = K_h d^1.5
  int balls = 0;
  double clearance = 0.0;
  double cam_flattening = 0.0;  // c_cam
  // mesh
  double flank_angle = 0.0;  // geometric alpha
  double force_angle = 0.0;  // alpha turned by friction
  double gap_factor = 0.0;
  double lobe_gap = 0.0;
  FlankLaw flank;
  // circular spline; support 0: rigid
  double spline_radius = 0.0;   // R_c
  double spline_bending = 0.0;  // E I_c
  double support = 0.0;         // s_h
};

/// Effect of a ring crack in the contact problem.
struct RingHinge {
  enum class Ring { rim, outer, spline } ring = Ring::rim;
  double position = 0.0;   // theta_c
  double length = 0.0;     // l, over which the crack softens the ring [m]
  double softening = 0.0;  // alpha, bending stiffness lost times length (TC-22) [N*m^3]
};
struct SoftTooth {
  double position = 0.0;
  double stiffness_loss = 0.0;
};
struct SoftBall {
  double position = 0.0;
  double compliance = 0.0;  // compliance in series with the contact [m/N]
};
struct ContactCracks {
  std::vector<RingHinge> hinges;
  std::vector<SoftTooth> teeth;
  std::vector<SoftBall> balls;
};

[[nodiscard]] CoupledGeometry coupled_geometry(const GearSet& gear, const CoupledOptions& options);
/// Force of the ball nearest to a position, in the sound drive [N].
using BallForce = std::function<double(double position)>;
[[nodiscard]] ContactCracks contact_cracks(const GearSet& gear, const CoupledGeometry& geometry,
                                           const BallForce& ball_force, std::vector<Note>& notes);

}  // namespace strainwave
