// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "chapters.hpp"
#include "strainwave/contact/hertz.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/member/wall_through.hpp"

namespace strainwave {

using std::numbers::pi;

Rows fracture_mechanics_rows() {
  Rows rows;
  const Printed p;
  const double isotropic = p.E / (2 * (1 + p.nu));
  rows.push_back({.id = "A1",
                  .quantity = "G of mode III in plane stress, K_III = 1",
                  .unit = "mm^2/N",
                  .own = article::energy_release_rate(0, 0, 1, p.E, p.nu),
                  .corrected = energy_release_rate(0, 0, 1, {.opening = p.E, .shear = isotropic}),
                  .verdict = AuditVerdict::physics,
                  .sentence = "mode III is the same in plane stress and plane strain: "
                              "K_III^2/(E'(1-nu)) is right only with E' of plane strain"});
  // A through crack of the flexspline serves as the example for both integrals.
  const double tau_squared = 1.0;
  const auto G = [&](double area) { return tau_squared * pi * area / (2 * p.delta) / p.E; };
  const double area = 2 * p.delta * p.a;
  const sif::ThroughCrackInTube crack{.half_length = p.a,
                                      .mean_radius = p.r_m,
                                      .wall_thickness = p.delta,
                                      .angle = pi / 4,
                                      .shell_correction = false};
  const double per_torque = article::wall_shear(1, p.r_m, p.delta);
  const double engine =
      added_compliance(crack, {.opening = p.E, .shear = p.mu}).matrix(kTorsion, kTorsion) /
      (per_torque * per_torque);
  rows.push_back({.id = "A2",
                  .quantity = "displacement du = int G/P dA, P = 1",
                  .unit = "mm",
                  .own = article::added_displacement(G, area, 1),
                  .corrected = engine,
                  .verdict = AuditVerdict::physics,
                  .sentence = "Castigliano at constant load gives int 2G/P dA: half is missing, "
                              "although the article itself uses the 2 later"});
  rows.push_back({.id = "A3",
                  .quantity = "compliance dl = int 2G/P^2 dA, P = 1",
                  .unit = "mm/N",
                  .own = article::added_compliance(G, area, 1),
                  .corrected = engine,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "right, but it contradicts the displacement above"});
  const PointContact ball{.curvature_sums = {0.01, 0.1}, .contact_modulus = p.E};
  rows.push_back({.id = "A4",
                  .quantity = "exponent n in K ~ P^n of a Hertz-driven crack",
                  .unit = "1",
                  .own = 1.0,
                  .corrected = std::log2(hertz_contact(ball, 2 * p.F_r).peak_pressure /
                                         hertz_contact(ball, p.F_r).peak_pressure),
                  .verdict = AuditVerdict::ambiguous,
                  .sentence = "K = alpha P is valid if the stress is proportional to the load, but "
                              "a contact pressure is not"});
  rows.push_back({.id = "A5",
                  .quantity = "1/(l_H + l_f + l_so) times their sum",
                  .unit = "1",
                  .own = article::drive_stiffness(3.0, 2.0, 7.0) * (3.0 + 2.0 + 7.0),
                  .corrected = 1.0,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "compliances in series add; the sum lacks tooth mesh, circular "
                              "spline, bearing and diaphragm"});
  rows.push_back({.id = "A6",
                  .quantity = "references to Eq. (4) and Eq. (18)",
                  .unit = "1",
                  .verdict = AuditVerdict::misprint,
                  .sentence = "no equation of the article is numbered, and K_II/T lacks a brace"});
  const double in_series = 1 / (1 / p.K_G0 + 1 / p.dK_G);
  rows.push_back(
      {.id = "A7",
       .quantity = "K_G by the article's list of steps",
       .unit = "N/mm",
       .printed = 1.185e5,
       .own = in_series,
       .verdict = AuditVerdict::physics,
       .sentence = fmt::format(
           "the list of steps adds compliances, but the derivation subtracts stiffnesses; with the "
           "printed numbers the results differ by a factor of {:.0f}",
           article::radial_stiffness(p.K_G0, p.dK_G) / in_series)});
  return rows;
}

}  // namespace strainwave
