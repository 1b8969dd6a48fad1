// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "chapters.hpp"
#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Sum of curvatures of the Hertz contact that gives the article's ellipse, a' = 5 mm, b' = 2 mm,
/// at a load.
double curvature_sum_of_printed_ellipse(double load) {
  const Printed p;
  const double contact_modulus = p.E / (2 * (1 - p.nu * p.nu));
  const auto contact = [&](double sum, double difference) {
    return hertz_contact(
        {.curvature_sums = {sum * (1 - difference) / 2, sum * (1 + difference) / 2},
         .contact_modulus = contact_modulus},
        load);
  };
  const double difference = bracketed_root(
      [&](double F) {
        const HertzContact h = contact(1e-3, F);
        return h.minor_semi_axis / h.major_semi_axis - p.b_contact / p.a_contact;
      },
      0.01, 0.999);
  return bracketed_root(
      [&](double sum) { return contact(sum, difference).major_semi_axis - p.a_contact; }, 1e-6,
      1.0);
}

/// Force of a lobe per torque at the output [1/mm].
double lobe_force() {
  const GearSet gear = example(1e-4, 1e-4);
  return lobe_force_per_torque(gear.drive, *gear.wave_generator) * units::mm;
}

/// Compliance that the crack of the race adds to one lobe [mm/N].
double race_crack_compliance(const StiffnessResult& result) {
  const double f = lobe_force();
  return compliance_in_mm(result.cracks[0].positive.at_output) / (f * f);
}

/// Stiffness Delta K_G by the printed equation [N/mm].
double crack_stiffness(const Printed& p) { return article::race_crack_stiffness(p.race(), p.F_r); }
double crack_stiffness_at(double a) { return crack_stiffness(with(&Printed::a, a)); }

Rows contact_rows() {
  Rows rows;
  const Printed p;
  const double pressure = article::contact_pressure(p.F_r, p.a_contact, p.b_contact);
  const double stress = article::race_stress(p.beta, pressure);
  const double axis_ratio = p.b_contact / p.a_contact;

  rows.push_back({.id = "B1",
                  .quantity = "1.95 of K_I = 1.95 sigma sqrt(a/Q)",
                  .unit = "1",
                  .printed = 1.95,
                  .own = article::race_stress_intensity(1, 1, 1),
                  .corrected = 1.1 * std::sqrt(pi),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "1.1 sqrt(pi), Irwin's deepest point of a shallow crack; only the "
                              "old form of Q depends on the material"});
  rows.push_back({.id = "B2",
                  .quantity = "sigma = beta/2 sigma_max",
                  .unit = "MPa",
                  .own = stress,
                  .corrected = edge_tension(axis_ratio, p.nu).minor_end * pressure,
                  .verdict = AuditVerdict::physics,
                  .sentence = "beta/2 sigma_max is the subsurface orthogonal shear, not a hoop "
                              "tension; the only Hertz tension is at the edge of the contact"});
  rows.push_back({.id = "B3",
                  .quantity = "beta for a' = 5, b' = 2",
                  .unit = "1",
                  .printed = p.beta,
                  .own = orthogonal_shear_factor(axis_ratio),
                  .corrected = orthogonal_shear_factor(axis_ratio),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = fmt::format("beta follows from b'/a' and is {:.4f} here",
                                          orthogonal_shear_factor(axis_ratio)),
                  .reproduce = reproducing("b'/a'", "1", p.beta, 0.1, 1.0,
                                           [](double x) { return orthogonal_shear_factor(x); })});
  rows.push_back({.id = "B4",
                  .quantity = "sigma_max = 3F_r/(2 pi a' b')",
                  .unit = "MPa",
                  .own = pressure,
                  .corrected = peak_pressure(p.F_r, p.a_contact, p.b_contact),
                  .verdict = AuditVerdict::ambiguous,
                  .sentence = "right if a', b' are semi-axes, which the text does not state; four "
                              "times as large if they are axes"});
  // 12.7 mm ball in a groove of conformity 0.52 on a race of 55 mm radius.
  const HertzContact ball =
      hertz_contact({.curvature_sums = {2 / 12.7 - 1 / (0.52 * 12.7), 2 / 12.7 + 1 / 55.0},
                     .contact_modulus = p.E / (2 * (1 - p.nu * p.nu))},
                    p.F_r);
  rows.push_back({.id = "B5",
                  .quantity = "a' at 500 N (12.7 mm ball, 55 mm race radius)",
                  .unit = "mm",
                  .printed = p.a_contact,
                  .own = ball.major_semi_axis,
                  .corrected = ball.major_semi_axis,
                  .verdict = AuditVerdict::physics,
                  .sentence = "contact axes follow from load and curvature; 5 x 2 mm requires "
                              "bodies with radii of metres",
                  .reproduce = ReproducingInput{"sum of curvatures",
                                                curvature_sum_of_printed_ellipse(p.F_r), "1/mm"}});
  const auto load = [&](double T) { return article::radial_load(1.15, p.k_r, T, p.d_1); };
  rows.push_back({.id = "B6",
                  .quantity = "radial load F_r",
                  .unit = "N",
                  .printed = p.F_r,
                  .own = load(p.T),
                  .corrected = lobe_force() * p.T,
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "the equation gives half of the value; twice the value results if "
                              "d_1 is read as a radius",
                  .reproduce = reproducing("T", "N*mm", p.F_r, 1e4, 1e6, load)});
  return rows;
}

Rows race_crack_rows(const StiffnessResult& result) {
  Rows rows;
  const Printed p;
  const double newman_raju = race_crack_compliance(result);
  const double per_force = article::race_crack_displacement(p.race(), 1);
  rows.push_back({.id = "B7",
                  .quantity = "crack compliance with dA = t_i da, F_r^1",
                  .unit = "mm/N",
                  .own = per_force,
                  .corrected = newman_raju,
                  .verdict = AuditVerdict::physics,
                  .sentence = "the crack grows in the direction of t_i, so t_i is not its width: a "
                              "semi-ellipse sweeps c da dphi"});
  const auto displacement = [](const Printed& q) {
    return article::race_crack_displacement(q.race(), q.F_r);
  };
  rows.push_back({.id = "B8a",
                  .quantity = "coefficient 0.217 of Delta u_H",
                  .unit = "1",
                  .printed = 0.217,
                  .own = std::pow(1.95 * 3 / (4 * pi), 2),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "(1.95)^2 (3/(4 pi))^2; the 2 in front of G cancels the 1/2 of the "
                              "integral"});
  rows.push_back({.id = "B8b",
                  .quantity = "Delta u_H",
                  .unit = "mm",
                  .own = displacement(p),
                  .corrected = newman_raju * p.F_r,
                  .verdict = AuditVerdict::dimension,
                  .sentence = fmt::format("F_r must not be squared: as printed the result has the "
                                          "dimension {}",
                                          dimension_text(exponents_of(displacement)))});
  rows.push_back({.id = "B9",
                  .quantity = "crack stiffness Delta K_G",
                  .unit = "N/mm",
                  .printed = p.dK_G,
                  .own = crack_stiffness(p),
                  .corrected = 1 / newman_raju,
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = fmt::format("no input of the article gives this value, and F_r in "
                                          "the denominator leaves the dimension {}",
                                          dimension_text(exponents_of(crack_stiffness))),
                  .reproduce = reproducing("a", "mm", p.dK_G, 0.01, 100, crack_stiffness_at)});
  return rows;
}

Rows radial_stiffness_rows(const StiffnessResult& result) {
  Rows rows;
  const Printed p;
  const double newman_raju = race_crack_compliance(result);
  rows.push_back({.id = "B10",
                  .quantity = "K_G0 = F_r/(Db + Dg + Da)",
                  .unit = "N/mm",
                  .printed = p.K_G0,
                  .own = article::sound_radial_stiffness(p.F_r, p.F_r / p.K_G0, 0, 0),
                  .verdict = AuditVerdict::input,
                  .sentence = "the article estimates this value from literature; displacements "
                              "add, and that of the shaft is zero for two symmetric lobes"});
  const auto by_subtraction = [&](double a) {
    return article::radial_stiffness(p.K_G0, crack_stiffness_at(a));
  };
  rows.push_back(
      {.id = "B11a",
       .quantity = "K_G = K_G0 - Delta K_G, printed Delta K_G",
       .unit = "N/mm",
       .printed = 1.185e5,
       .own = article::radial_stiffness(p.K_G0, p.dK_G),
       .corrected = 1 / (1 / p.K_G0 + newman_raju),
       .verdict = AuditVerdict::physics,
       .sentence = "the arithmetic is right, but the subtraction is wrong: compliances add"});
  rows.push_back({.id = "B11b",
                  .quantity = "K_G = K_G0 - Delta K_G, its own Delta K_G",
                  .unit = "N/mm",
                  .own = by_subtraction(p.a),
                  .corrected = 1 / (1 / p.K_G0 + newman_raju),
                  .verdict = AuditVerdict::physics,
                  .sentence = "negative, and minus infinity without a crack; the input is the "
                              "value at which the sign changes",
                  .reproduce = reproducing("a of K_G = 0", "mm", 0, 0.1, 100, by_subtraction)});
  return rows;
}

Rows member_compliance_rows(const StiffnessResult& result) {
  Rows rows;
  const Printed p;
  const double own_lambda = article::wave_generator_compliance(p.cam(), p.K_G0);
  const double true_lambda = compliance_in_mm(result.intact.compliance.wave_generator);
  rows.push_back({.id = "B12",
                  .quantity = "l_H of a given K_G, sound",
                  .unit = kCompliance,
                  .own = own_lambda,
                  .corrected = true_lambda,
                  .verdict = AuditVerdict::physics,
                  .sentence = "turning the cam back over its mean slope violates reciprocity with "
                              "the lobe force, where w_0 i = d_1/2, by pi/(4 c_F^2 k_r)"});
  const auto lambda_of = [&](double K_G) {
    return article::wave_generator_compliance(p.cam(), K_G);
  };
  rows.push_back({.id = "B13a",
                  .quantity = "l_H, no cracks",
                  .unit = kCompliance,
                  .printed = 3.407e-10,
                  .own = own_lambda,
                  .corrected = true_lambda,
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "half of the value follows from the printed K_G0",
                  .reproduce = reproducing("K_G", "N/mm", 3.407e-10, 1e3, 1e7, lambda_of)});
  rows.push_back(
      {.id = "B13b",
       .quantity = "l_H, with cracks",
       .unit = kCompliance,
       .printed = 3.558e-10,
       .own = lambda_of(1.185e5),
       .corrected = compliance_in_mm(result.positive.compliance.wave_generator),
       .verdict = AuditVerdict::not_reproducible,
       .sentence = "its ratio to the sound value does not agree with the printed K_G either",
       .reproduce = reproducing("K_G", "N/mm", 3.558e-10, 1e3, 1e7, lambda_of)});
  return rows;
}

}  // namespace

Rows wave_generator_rows() {
  const StiffnessResult result = corrected_example(Printed{}.a);
  return joined(contact_rows(), race_crack_rows(result), radial_stiffness_rows(result),
                member_compliance_rows(result));
}

}  // namespace strainwave
