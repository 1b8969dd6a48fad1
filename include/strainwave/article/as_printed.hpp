// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

/// @file
/// The article's method exactly as printed, with every misprint.  This code reproduces what a
/// reader finds in the article, right or wrong, so that each printed number can be reproduced or
/// refuted.  Theory manual, chapter AP, states the errors of every equation.

namespace strainwave {

/// Each printed equation by itself.
///
/// These functions take and return bare numbers in one consistent system of units.  The article
/// uses N and mm, and its misprints make the choice matter: where a docstring says "dimension", the
/// result depends on the system of units.  No function checks its arguments.
namespace article {

// --- Fracture mechanics ---------------------------------------------------------------------

/// Energy release rate, G = K_I^2/E' + K_II^2/E' + K_III^2/(E'(1 - nu)).
///
/// Implements theory manual eq. (AP-19).  The term of mode III is valid only if E' is that of plane
/// strain.
[[nodiscard]] double energy_release_rate(double K_I, double K_II, double K_III,
                                         double generalised_modulus, double poissons_ratio);

/// Energy release rate as a function of the cracked area.
using ReleaseRateOverArea = std::function<double(double area)>;

/// Displacement that a crack adds, Delta u = int_0^A G/P dA.  Castigliano's theorem gives twice
/// this value.  Implements theory manual eq. (AP-20).
[[nodiscard]] double added_displacement(const ReleaseRateOverArea& release_rate, double area,
                                        double load);

/// Compliance that a crack adds, Delta lambda = int_0^A 2 G/P^2 dA.
///
/// Implements theory manual eq. (AP-21).
[[nodiscard]] double added_compliance(const ReleaseRateOverArea& release_rate, double area,
                                      double load);

// --- Wave generator -------------------------------------------------------------------------

/// The inner ring of the bearing with its crack.
struct CrackedRace {
  double depth = 0.0;               ///< a
  double ring_thickness = 0.0;      ///< t_i
  double flaw_parameter = 0.0;      ///< Q
  double contact_factor = 0.0;      ///< beta
  double contact_semi_major = 0.0;  ///< a'
  double contact_semi_minor = 0.0;  ///< b'
  double youngs_modulus = 0.0;      ///< E
};

/// The quantities that convert a radial compliance into a torsional one.
struct Cam {
  double force_transmission_coefficient = 0.0;  ///< k_r
  double pitch_diameter = 0.0;                  ///< d_1
  double wave_number = 0.0;                     ///< U
  double radial_displacement = 0.0;             ///< w_0
  double ratio = 0.0;                           ///< i_h
};

/// K_I = 1.95 sigma sqrt(a/Q).  Implements theory manual eq. (AP-1).
[[nodiscard]] double race_stress_intensity(double stress, double depth, double flaw_parameter);

/// The stress sigma = beta/2 sigma_max, a shear stress that the article treats as a tensile stress.
///
/// Implements theory manual eq. (AP-2).
[[nodiscard]] double race_stress(double contact_factor, double contact_pressure);

/// sigma_max = 3 F_r/(2 pi a' b').  Implements theory manual eq. (AP-3).
[[nodiscard]] double contact_pressure(double radial_load, double semi_major, double semi_minor);

/// F_r = 1.15 k_r T/d_1, with the article's 1.15 as `load_factor`.
///
/// Implements theory manual eq. (AP-4).  This is the force on one lobe, and it holds for two lobes
/// only.
[[nodiscard]] double radial_load(double load_factor, double force_transmission_coefficient,
                                 double torque, double pitch_diameter);

/// Delta u_H = 0.217 t_i (beta a/(a' b'))^2 F_r^2/(E Q).
///
/// Implements theory manual eq. (AP-5).  Dimension: F_r must not be squared.
[[nodiscard]] double race_crack_displacement(const CrackedRace& race, double radial_load);

/// Delta K_G = E Q/(0.217 F_r t_i (beta a/(a' b'))^2).
///
/// Implements theory manual eq. (AP-6).  Dimension: F_r must not appear.
[[nodiscard]] double race_crack_stiffness(const CrackedRace& race, double radial_load);

/// K_G0 = F_r/(Delta_b + Delta_g + Delta_a).  Implements theory manual eq. (AP-7).
[[nodiscard]] double sound_radial_stiffness(double radial_load, double bearing, double cam,
                                            double shaft);

/// K_G = K_G0 - Delta K_G, which tends to minus infinity for a vanishing crack.
///
/// Implements theory manual eq. (AP-8).
[[nodiscard]] double radial_stiffness(double sound, double of_crack);

/// lambda_H = k_r/K_G pi/(2 d_1 U w_0 i_h).  Implements theory manual eq. (AP-9).
[[nodiscard]] double wave_generator_compliance(const Cam& cam, double radial_stiffness);

// --- Flexspline -----------------------------------------------------------------------------

/// The wall of the flexspline with its crack.
struct CrackedWall {
  double half_length = 0.0;           ///< a
  double mean_radius = 0.0;           ///< r_m
  double wall_thickness = 0.0;        ///< delta
  double stress_nonuniformity = 1.0;  ///< K_u
  double dynamic_load = 1.0;          ///< K_d
  double youngs_modulus = 0.0;        ///< E
};

/// The flexspline without a crack.
struct SoundCup {
  double shape_coefficient = 1.0;      ///< k_f
  double structure_coefficient = 1.0;  ///< k_G
  double length = 0.0;                 ///< L
  double pitch_diameter = 0.0;         ///< d_1
  double wall_thickness = 0.0;         ///< delta
  double shear_modulus = 0.0;          ///< mu
};

/// Stress intensity factors of two modes.
struct WallStressIntensity {
  /// stress intensity factor of mode I [stress times root of length, in the caller's units]
  double K_I = 0.0;
  double K_II = 0.0;  ///< stress intensity factor of mode II, in the same unit
};

/// tau = T/(2 pi r_m^2 delta).  Implements theory manual eq. (AP-10), its first line.
[[nodiscard]] double wall_shear(double torque, double mean_radius, double wall_thickness);

/// K_I = tau sin(2 beta) sqrt(pi a), K_II = tau cos(2 beta) sqrt(pi a).
///
/// Implements theory manual eq. (AP-10).
[[nodiscard]] WallStressIntensity wall_stress_intensity(double shear, double angle,
                                                        double half_length);

/// Delta lambda_f = K_u K_d a^2/(2 pi E r_m^4 delta).  Implements theory manual eq. (AP-11).
[[nodiscard]] double wall_crack_compliance(const CrackedWall& wall);

/// lambda_f0 = k_f k_G c_L/(0.1 mu [1 - (1 - 2 c_delta)^4] d_1^3), c_L = L/d_1, c_delta =
/// delta/d_1.
///
/// Implements theory manual eq. (AP-12).
[[nodiscard]] double sound_flexspline_compliance(const SoundCup& cup);

// --- Output shaft ---------------------------------------------------------------------------

/// The (equivalent) solid shaft with its crack; d_e = d_s - 2a.
struct CrackedShaft {
  double depth = 0.0;           ///< a
  double diameter = 0.0;        ///< d_s
  double M_p = 0.0;             ///< geometry coefficient of K_I
  double M_M = 0.0;             ///< geometry coefficient of K_III
  double youngs_modulus = 0.0;  ///< E
  double shear_modulus = 0.0;   ///< mu
};

/// Stress intensity factors of two modes.
struct ShaftStressIntensity {
  /// stress intensity factor of mode I [stress times root of length, in the caller's units]
  double K_I = 0.0;
  double K_III = 0.0;  ///< stress intensity factor of mode III, in the same unit
};

/// Added compliance of a shaft crack: the two terms of eq. (AP-16).
struct ShaftCrackCompliance {
  double axial_term = 0.0;    ///< from K_I
  double torsion_term = 0.0;  ///< from K_III

  /// The sum of both terms as printed.  Their dimensions differ, so the sum means nothing.
  [[nodiscard]] double total() const { return axial_term + torsion_term; }
};

/// K_I = M_p 4P/(pi d_e^2) sqrt(pi a), K_III = M_M 16T/(pi d_e^3) sqrt(pi a).
///
/// Implements theory manual eq. (AP-13).
[[nodiscard]] ShaftStressIntensity shaft_stress_intensity(const CrackedShaft& shaft,
                                                          double axial_force, double torque);

/// M_p(d_e/d_s), with the printed +0.182 and 0.166.  Implements theory manual eq. (AP-14).
[[nodiscard]] double axial_coefficient(double net_diameter_ratio);

/// M_M(d_e/d_s), with the printed 0.376.  Implements theory manual eq. (AP-15).
[[nodiscard]] double torsion_coefficient(double net_diameter_ratio);

/// Delta lambda_so = 16 M_p^2 a^2/(pi E d_e^4) + 512 M_M^2 a^3/(3 mu d_e^6).
///
/// Implements theory manual eq. (AP-16).  Dimension: the first term is 1/force.
[[nodiscard]] ShaftCrackCompliance shaft_crack_compliance(const CrackedShaft& shaft);

/// lambda_so0 = L_s/(0.1 mu d_s^4).  Implements theory manual eq. (AP-17).
[[nodiscard]] double sound_shaft_compliance(double length, double diameter, double shear_modulus);

// --- Drive ----------------------------------------------------------------------------------

/// K_HD = 1/(lambda_H + lambda_f + lambda_so).  Implements theory manual eq. (AP-18).
[[nodiscard]] double drive_stiffness(double wave_generator, double flexspline, double output_shaft);

}  // namespace article

/// Torsional stiffness of a drive by the article's method as printed.
///
/// Implements theory manual eqs. (AP-1) to (AP-18), evaluated in N and mm because some of them are
/// dimensionally wrong; input and result are in SI.  The values of `[article]` replace the numbers
/// that they name.  A negative compliance is returned unchanged, with a note.
///
/// The accuracy cannot be stated.  The method takes one crack per member: a surface crack of the
/// race (driver orthogonal_shear, contact factor given), a through crack of the flexspline, an
/// annular crack of the shaft.  The shaft is treated as solid with an equivalent diameter.  Both
/// senses of torque give the same values, because the article does not model crack closure.
///
/// @param gear         the drive
/// @return             compliances, stiffness, cracks, notes
/// @throws InputError  if `check(gear)` refuses the drive, or the article's method cannot treat it
[[nodiscard]] StiffnessResult torsional_stiffness_as_printed(const GearSet& gear);

}  // namespace strainwave
