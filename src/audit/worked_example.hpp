// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/article/as_printed.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// The inputs of the worked example as printed, in N, mm, MPa, rad.
///
/// The system of units can be changed, because the audit finds the dimension of an equation by
/// evaluating it in two systems.
struct Printed {
  double E = 2.1e5, mu = 8e4, nu = 0.3;
  double T = 1e5;
  double i_h = 100, w_0 = 0.8, d_1 = 160, U = 2;
  double k_r = 0.35, F_r = 500, K_G0 = 1.2e5, dK_G = 1.5e3;
  double t_i = 10, a_contact = 5, b_contact = 2, beta = 0.45, Q = 1.5;
  double delta = 2.24, L = 160, r_m = 79.88, K_u = 1.1, K_d = 1.2;
  double D_s = 70, d_s_bore = 45, L_s = 200, d_s = 60, M_p = 0.85, M_M = 0.42;
  double a = 0.1;

  /// The same physical inputs in units of force and length smaller by these factors.
  [[nodiscard]] Printed in_smaller_units(double force, double length) const {
    Printed p = *this;
    const double stress = force / (length * length);
    for (double* const s : {&p.E, &p.mu}) *s *= stress;
    p.T *= force * length;
    p.F_r *= force;
    for (double* const k : {&p.K_G0, &p.dK_G}) *k *= force / length;
    for (double* const l : {&p.w_0, &p.d_1, &p.t_i, &p.a_contact, &p.b_contact, &p.delta, &p.L,
                            &p.r_m, &p.D_s, &p.d_s_bore, &p.L_s, &p.d_s, &p.a})
      *l *= length;
    return p;
  }

  [[nodiscard]] article::CrackedRace race() const {
    return {.depth = a,
            .ring_thickness = t_i,
            .flaw_parameter = Q,
            .contact_factor = beta,
            .contact_semi_major = a_contact,
            .contact_semi_minor = b_contact,
            .youngs_modulus = E};
  }
  [[nodiscard]] article::Cam cam() const {
    return {.force_transmission_coefficient = k_r,
            .pitch_diameter = d_1,
            .wave_number = U,
            .radial_displacement = w_0,
            .ratio = i_h};
  }
  [[nodiscard]] article::CrackedWall wall() const {
    return {.half_length = a,
            .mean_radius = r_m,
            .wall_thickness = delta,
            .stress_nonuniformity = K_u,
            .dynamic_load = K_d,
            .youngs_modulus = E};
  }
  [[nodiscard]] article::SoundCup cup(double k_f, double k_G) const {
    return {.shape_coefficient = k_f,
            .structure_coefficient = k_G,
            .length = L,
            .pitch_diameter = d_1,
            .wall_thickness = delta,
            .shear_modulus = mu};
  }
  [[nodiscard]] article::CrackedShaft shaft() const {
    return {.depth = a,
            .diameter = d_s,
            .M_p = M_p,
            .M_M = M_M,
            .youngs_modulus = E,
            .shear_modulus = mu};
  }
};

/// The printed inputs with one value changed.
[[nodiscard]] Printed with(double Printed::*input, double value);

/// The worked example for the corrected method, in SI.
/// @param crack_size   depth of the crack of the race and half length of the crack of the wall [m]
/// @param shaft_crack  depth of the annular crack of the shaft [m]
[[nodiscard]] GearSet example(double crack_size, double shaft_crack);

/// The result of the corrected method for the example with cracks of one size [mm].
[[nodiscard]] StiffnessResult corrected_example(double crack_size_mm);

/// From SI to the article's units: rad/(N*m) to rad/(N*mm), N*m/rad to N*mm/rad.
[[nodiscard]] double compliance_in_mm(const Quantity& q);
[[nodiscard]] double stiffness_in_mm(const Quantity& q);

}  // namespace strainwave
