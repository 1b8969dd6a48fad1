// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "chapters.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Mean radius from the printed diameter and wall [mm].
double own_mean_radius() {
  const Printed p;
  return (p.d_1 - p.delta) / 2;
}

Rows wall_stress_rows() {
  Rows rows;
  const Printed p;
  const double mean_radius = own_mean_radius();
  const double tau = article::wall_shear(p.T, mean_radius, p.delta);
  const auto K = article::wall_stress_intensity(tau, pi / 4, p.a);
  const sif::ThroughCrackInTube crack{.half_length = p.a,
                                      .mean_radius = mean_radius,
                                      .wall_thickness = p.delta,
                                      .angle = pi / 4,
                                      .shell_correction = false};
  const UnitStressIntensity<2> k = crack.stress_intensity(p.a, 0);
  rows.push_back({.id = "C1",
                  .quantity = "K_I of the flexspline crack",
                  .unit = "MPa*mm^0.5",
                  .own = K.K_I,
                  .corrected = k.I[kTorsion] * p.T,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "right for a through crack of half length a; the text calls a its "
                              "depth, but a surface crack needs other factors"});
  rows.push_back({.id = "C2",
                  .quantity = "K_II/K_I at 45 deg, \"mixed mode I-II\"",
                  .unit = "1",
                  .own = K.K_II / K.K_I,
                  .corrected = k.II[kTorsion] / k.I[kTorsion],
                  .verdict = AuditVerdict::physics,
                  .sentence = "at 45 deg to the axis torsion is pure mode I: K_II vanishes"});
  rows.push_back(
      {.id = "C3",
       .quantity = "tau = T/(2 pi r_m^2 delta), r_m = 78.88",
       .unit = "MPa",
       .own = tau,
       .corrected = sif::crack_plane_stress(mean_radius, p.delta, 0, 1).shear[kTorsion] * p.T,
       .verdict = AuditVerdict::reproduced,
       .sentence = "Bredt's formula"});
  return rows;
}

Rows wall_compliance_rows() {
  Rows rows;
  const Printed p;
  const StiffnessResult result = corrected_example(p.a);
  const double mean_radius = own_mean_radius();
  const double corrected_crack = compliance_in_mm(result.cracks[1].positive.at_output);
  rows.push_back({.id = "C4",
                  .quantity = "Delta l_f with r_m = 78.88",
                  .unit = kCompliance,
                  .own = article::wall_crack_compliance(with(&Printed::r_m, mean_radius).wall()),
                  .corrected = corrected_crack,
                  .verdict = AuditVerdict::physics,
                  .sentence = "K_u multiplies a stress and enters squared; a load factor K_d does "
                              "not belong in a compliance; a crack this short is in plane strain"});
  rows.push_back(
      {.id = "C5",
       .quantity = "factor 0.1 of l_f0 for pi/32",
       .unit = "1",
       .printed = 0.1,
       .own = pi / 32,
       .corrected = pi / 32,
       .verdict = AuditVerdict::reproduced,
       .sentence = fmt::format("rounded, {:.1f} % too stiff", 100 * (0.1 / (pi / 32) - 1))});
  const auto with_factor = [&](double factor) {
    return article::sound_flexspline_compliance(p.cup(factor, 1));
  };
  const double true_sound = compliance_in_mm(result.intact.compliance.flexspline);
  rows.push_back({.id = "C6",
                  .quantity = "l_f0",
                  .unit = kCompliance,
                  .printed = 2.359e-10,
                  .own = article::sound_flexspline_compliance(p.cup(0.83, 0.83)),
                  .corrected = true_sound,
                  .verdict = AuditVerdict::misprint,
                  .sentence = "k_f and k_G are the same factor 0.83; the formula contains this "
                              "factor twice, the printed number once",
                  .reproduce = reproducing("k_f k_G", "1", 2.359e-10, 0.1, 2, with_factor)});
  rows.push_back({.id = "C7",
                  .quantity = "mean radius r_m",
                  .unit = "mm",
                  .printed = p.r_m,
                  .own = mean_radius,
                  .corrected = mean_radius,
                  .verdict = AuditVerdict::misprint,
                  .sentence = "(160 - 2.24)/2 differs from the printed number in one digit"});
  rows.push_back({.id = "C8",
                  .quantity = "Delta l_f",
                  .unit = kCompliance,
                  .printed = 1.0e-15,
                  .own = article::wall_crack_compliance(p.wall()),
                  .corrected = corrected_crack,
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "the printed number is ten times too large",
                  .reproduce = reproducing("a", "mm", 1.0e-15, 0.01, 10, [&](double a) {
                    return article::wall_crack_compliance(with(&Printed::a, a).wall());
                  })});
  rows.push_back({.id = "C9",
                  .quantity = "l_f with crack",
                  .unit = kCompliance,
                  .printed = 2.359e-10,
                  .own = 2.359e-10 + 1.0e-15,
                  .corrected = compliance_in_mm(result.positive.compliance.flexspline),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "the sum of the printed parts"});
  rows.push_back({.id = "C10",
                  .quantity = "Delta l_f under reversed torque",
                  .unit = kCompliance,
                  .own = article::wall_crack_compliance(p.wall()),
                  .corrected = compliance_in_mm(result.cracks[1].negative.at_output),
                  .verdict = AuditVerdict::physics,
                  .sentence = fmt::format(
                      "one sense of torque opens a 45 deg crack and the other closes it; the "
                      "assembly bends the wall by {:.1f} MPa, far more than the shear stress",
                      ovalisation_stress(example(1e-4, 1e-4)) / units::MPa)});
  return rows;
}

}  // namespace

Rows flexspline_rows() { return joined(wall_stress_rows(), wall_compliance_rows()); }

}  // namespace strainwave
