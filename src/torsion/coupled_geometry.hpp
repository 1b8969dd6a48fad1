// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/lift.hpp"
#include "strainwave/torsion/flank.hpp"
#include "strainwave/torsion/tooth_flanks.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "tooth_neighbours.hpp"

// The numbers of the coupled drive, and of its cracks inside the contact problem.

namespace strainwave {

/// The numbers of the model, from the file [SI].
template <class Real>
struct BasicCoupledGeometry {
  // transmission
  Real pitch_radius{};         // R_p
  Real radial_displacement{};  // w_0
  int teeth = 0;               // z
  Real module{};               // m
  // rim and outer ring as one ring
  Real ring_radius{};    // R
  Real rim_thickness{};  // t_r
  Real rim_width{};      // b
  Real rim_bending{};    // EI of the rim
  Real outer_bending{};  // EI of the outer ring
  Real extension{};      // EA
  Real outer_thickness{};
  Real outer_width{};
  BasicElasticConstants<Real> rim_steel;
  BasicElasticConstants<Real> ball_steel;
  // barrel and diaphragm
  Real barrel_length{};
  Real barrel_thickness{};
  std::optional<Real> barrel_modulus{};  // E/(1 - nu^2); absent for a laminate [Pa]
  Real tilt{};  // slope of the rim along the axis per radial displacement, n = 2 (TC-2) [1/m]
  // bearing
  Real ball_stiffness{};  // K_h, Q = K_h d^1.5
  int balls = 0;
  Real clearance{};
  Real cam_flattening{};  // c_cam
  // mesh
  Real flank_angle{};  // alpha; of half-path flanks their mean angle
  Real gap_factor{};
  Real lobe_gap{};
  BasicFlankLaw<Real> flank;                   // without `tooth`, of every flank
  std::optional<BasicToothGap<Real>> tooth{};  // teeth as drawn
  // circular spline; support 0: rigid
  Real spline_radius{};   // R_c
  Real spline_bending{};  // E I_c
  Real support{};         // s_h
  // of drawn teeth with a circular spline in the file
  std::optional<BasicToothNeighbours<Real>> neighbours{};
};
using CoupledGeometry = BasicCoupledGeometry<double>;

/// The rings that a crack can soften in the contact problem.
enum class HingedRing { rim, outer, spline };
template <class Real>
struct BasicRingHinge {
  using Ring = HingedRing;
  Ring ring = Ring::rim;
  Real position{};           // theta_c
  Real length{};             // length l over which the crack softens the ring [m]
  Real softening{};          // alpha, lost bending stiffness times length (TC-22) [N*m^3]
  bool from_inside = false;  // a crack from inside opens where the ring bends less
  std::string path = {};     // path of the crack in the file
  double depth = 0.0;        // a [m]
};
template <class Real>
struct BasicSoftTooth {
  double position = 0.0;
  Real stiffness_loss{};
};
template <class Real>
struct BasicSoftBall {
  double position = 0.0;
  Real compliance{};  // compliance in series with the contact [m/N]
};
template <class Real>
struct BasicContactCracks {
  std::vector<BasicRingHinge<Real>> hinges;
  std::vector<BasicSoftTooth<Real>> teeth;
  std::vector<BasicSoftBall<Real>> balls;
};
using RingHinge = BasicRingHinge<double>;
using SoftTooth = BasicSoftTooth<double>;
using SoftBall = BasicSoftBall<double>;
using ContactCracks = BasicContactCracks<double>;

/// @throws InputError  if a rule of `check` or of the coupled drive is broken
void check_coupled(const GearSet& gear, const CoupledOptions& options);
/// @param gear  has passed `check_coupled`
template <class Real>
[[nodiscard]] BasicCoupledGeometry<Real> coupled_geometry(const GearSet& gear,
                                                          const CoupledOptions& options,
                                                          const Lift<Real>& lift);
[[nodiscard]] CoupledGeometry coupled_geometry(const GearSet& gear, const CoupledOptions& options);
/// Force of the ball nearest to a position, in the sound drive [N].
template <class Real>
using BasicBallForce = std::function<Real(double position)>;
using BallForce = BasicBallForce<double>;
template <class Real>
[[nodiscard]] BasicContactCracks<Real> contact_cracks(const GearSet& gear, const Lift<Real>& lift,
                                                      const BasicCoupledGeometry<Real>& geometry,
                                                      const BasicBallForce<Real>& ball_force,
                                                      std::vector<Note>& notes);

}  // namespace strainwave
