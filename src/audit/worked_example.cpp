// SPDX-License-Identifier: Apache-2.0
#include "worked_example.hpp"

#include "strainwave/core/roots.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {

Printed with(double Printed::*input, double value) {
  Printed p;
  p.*input = value;
  return p;
}

GearSet example(double crack_size, double shaft_crack) {
  using units::mm;
  const Printed p;
  GearSet gear;
  gear.material["steel"] = {.youngs_modulus = p.E * units::MPa,
                            .shear_modulus = p.mu * units::MPa,
                            .poissons_ratio = p.nu,
                            .yield_strength = {},
                            .fracture_toughness = {}};
  gear.drive = {.ratio = p.i_h,
                .wave_number = 2,
                .pitch_diameter = p.d_1 * mm,
                .radial_displacement = p.w_0 * mm};
  gear.load = {.torque = p.T * mm, .axial_force = 0};
  WaveGenerator wg;
  wg.material = "steel";
  wg.force_transmission_coefficient = p.k_r;
  wg.radial_stiffness = p.K_G0 / mm;
  wg.inner_ring_thickness = p.t_i * mm;
  wg.contact_semi_axes = {p.a_contact * mm, p.b_contact * mm};
  RaceSurfaceCrack race;
  race.depth = crack_size;
  race.aspect_ratio = bracketed_root(
      [&](double rho) { return sif::NewmanRaju(rho).shape_parameter() - p.Q; }, 0.1, 1);
  race.contact_factor = p.beta;
  wg.crack = {race};
  gear.wave_generator = wg;
  Flexspline fs;
  fs.material = "steel";
  fs.wall_thickness = p.delta * mm;
  fs.length = p.L * mm;
  fs.stress_nonuniformity = p.K_u;
  WallThroughCrack wall;
  wall.half_length = crack_size;
  fs.crack = {wall};
  gear.flexspline = fs;
  OutputShaft shaft;
  shaft.material = "steel";
  shaft.outer_diameter = p.D_s * mm;
  shaft.inner_diameter = p.d_s_bore * mm;
  shaft.length = p.L_s * mm;
  AnnularCrack ring;
  ring.depth = shaft_crack;
  shaft.crack = {ring};
  gear.output_shaft = shaft;
  return gear;
}

StiffnessResult corrected_example(double crack_size_mm) {
  return torsional_stiffness(example(crack_size_mm * units::mm, crack_size_mm * units::mm));
}

double compliance_in_mm(const Quantity& q) { return q.value * units::mm; }
double stiffness_in_mm(const Quantity& q) { return q.value / units::mm; }

}  // namespace strainwave
