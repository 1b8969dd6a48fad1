// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/dual.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/laminate/laminate.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Loads of the members that carry cracks, from torque and assembly: force on a lobe, contacts of
/// the balls, bending of ring and wall.

namespace strainwave {

/// Geometry of a ball's contacts with its two races.
template <class Real>
struct BasicRaceContacts {
  BasicPointContact<Real> inner;  ///< convex race
  BasicPointContact<Real> outer;  ///< concave race
};
/// BasicRaceContacts in plain numbers.
using RaceContacts = BasicRaceContacts<double>;

/// Contacts of a ball with its races; ball and races have one material; eq. (CO-1).
/// @param lift     reads the numbers of the bearing
/// @param bearing  bearing of the wave generator
/// @param steel    material of balls and races
template <class Real>
[[nodiscard]] BasicRaceContacts<Real> race_contacts(const Lift<Real>& lift, const Bearing& bearing,
                                                    const BasicElasticConstants<Real>& steel) {
  const Real D = lift(bearing.ball_diameter);
  // Ball and races have one material, so 1/E* = 2 (1 - nu^2)/E.
  const Real contact_modulus = steel.plane_strain_modulus() / 2;
  const auto contact = [&](const Real& race_curvature, const Real& conformity) {
    // (CO-1): the first entry is across the groove, the second along the rolling direction.
    return BasicPointContact<Real>{
        .curvature_sums = {2 / D - 1 / (conformity * D), 2 / D + race_curvature},
        .contact_modulus = contact_modulus};
  };
  return {
      .inner = contact(2 / lift(bearing.inner_raceway_diameter), lift(bearing.inner_conformity)),
      .outer = contact(-2 / lift(bearing.outer_raceway_diameter), lift(bearing.outer_conformity))};
}
/// The same in plain numbers.
[[nodiscard]] inline RaceContacts race_contacts(const Bearing& bearing,
                                                const ElasticConstants& steel) {
  return race_contacts(Lift<double>(), bearing, steel);
}

/// Force on one lobe per unit of torque, f = 2 c_F k_r/(U d_1) [1/m]; eq. (ST-5).
template <class Real>
[[nodiscard]] Real lobe_force_per_torque(const Lift<Real>& lift, const Transmission& drive,
                                         const WaveGenerator& wg) {
  return 2 * lift(wg.load_factor) * lift(wg.force_transmission_coefficient) /
         (drive.wave_number * lift(drive.pitch_diameter));  // (ST-5)
}
/// The same in plain numbers [1/m].
[[nodiscard]] inline double lobe_force_per_torque(const Transmission& drive,
                                                  const WaveGenerator& wg) {
  return lobe_force_per_torque(Lift<double>(), drive, wg);
}

/// Bending moment of a thin ring under U equal and evenly spaced radial forces F, at one of them
/// and over F R [-]: (1/theta - cot(theta))/2, theta = pi/U; eq. (ST-13).
/// @param wave_number  U [-]; >= 2
/// @throws InputError  if U < 2
[[nodiscard]] double ring_moment_factor(int wave_number);

/// Bending stress of a ring that takes the shape r + w_0 cos(U theta), at its inner and outer
/// surface [Pa].
///
/// The stress is E/(1-nu^2) (t/2) (U^2-1) w_0/r^2.  It applies to the wall of the flexspline
/// (ST-17) and to a ring on its cam (SW-9).
[[nodiscard]] double bending_to_shape(const Transmission& drive, const ElasticConstants& steel,
                                      double mean_radius, double thickness);

/// The wall of a tube, or a ring.
template <class Real>
struct Wall {
  Real mean_radius{};  ///< r [m]
  Real thickness{};    ///< t [m]
};

/// The wall under the teeth of the flexspline, where the wave generator deflects it; eq. (ST-11).
template <class Real>
[[nodiscard]] Wall<Real> tooth_ring(const Lift<Real>& lift, const GearSet& gear) {
  const Real delta = lift(gear.flexspline->ring_thickness());
  return {(lift(gear.drive.pitch_diameter) - delta) / 2, delta};  // (ST-11)
}

/// Bending stress of the flexspline's wall from its assembly on the wave generator [Pa].
///
/// Implements theory manual eq. (ST-17), E/(1-nu^2) (delta/2) (U^2-1) w_0/r_m^2, for a deflection
/// w_0 cos(U theta).  The stress is constant along the axis.
/// @param gear  drive with a flexspline
[[nodiscard]] double ovalisation_stress(const GearSet& gear);

/// Stress of the assembly on the plane of a crack in the flexspline's wall, at its surface [Pa].
struct AssemblyStress {
  double normal = 0.0;  ///< normal stress on the crack plane, where the hoop stress is tensile
  double shear = 0.0;   ///< shear along the crack from the same moment; sign as in CrackPlaneStress
};

/// Bound of the stress of the assembly on the plane of a through crack of a laminate.
///
/// Implements theory manual eq. (LA-20): the strain of the face that is farther from the line
/// without hoop force acts through the whole wall.  In an isotropic wall this is (FA-12).
///
/// @param drive        gives U and w_0
/// @param wall         stiffness of the cracked wall
/// @param mean_radius  r of the cracked wall [m]; > 0
/// @param angle        beta of the crack [rad]
/// @throws InputError  if the radius is not positive
[[nodiscard]] AssemblyStress assembly_stress(const Transmission& drive,
                                             const LaminateStiffness<double>& wall,
                                             double mean_radius, double angle);

/// Stress of the assembly on the plane of a crack.
///
/// Implements theory manual eq. (FA-12).  The hoop stress sigma_b of (ST-17) in a wall of this
/// radius and thickness, with nu sigma_b along the axis, is turned into the crack's frame,
///
///     normal = sigma_b (cos^2(beta) + nu sin^2(beta)),
///     shear  = -(1 - nu) sigma_b sin(beta) cos(beta).
///
/// The result is the amplitude of a deflection w_0 cos(U theta) at the crack.  In a cup this
/// deflection falls along the axis, so the result is an upper bound in the barrel.  It is not a
/// bound on the rim or for a flattened cam.
///
/// @param drive        gives U and w_0
/// @param steel        material of the cracked wall
/// @param mean_radius  r of the cracked wall [m]; > 0
/// @param thickness    t of the cracked wall [m]; > 0
/// @param angle        beta of the crack [rad]
/// @throws InputError  if the drive lacks a flexspline, or a length is not positive
[[nodiscard]] AssemblyStress assembly_stress(const Transmission& drive,
                                             const ElasticConstants& steel, double mean_radius,
                                             double thickness, double angle);
/// The same for a flexspline of one material.
[[nodiscard]] AssemblyStress assembly_stress(const GearSet& gear, double mean_radius,
                                             double thickness, double angle);

}  // namespace strainwave
