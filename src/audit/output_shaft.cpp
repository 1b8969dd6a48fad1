// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "chapters.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/stiffness/elastic_members.hpp"

namespace strainwave {
namespace {

/// Torsional compliance that a crack adds to a solid shaft [rad/(N*mm)]; lengths in mm.
double solid_shaft(double depth, double diameter) {
  const Printed p;
  return added_compliance(sif::AnnularCrackSolid{.depth = depth, .diameter = diameter},
                          {.opening = p.E / (1 - p.nu * p.nu), .shear = p.mu})
      .matrix(kTorsion, kTorsion);
}

double tada_M_p(double ratio) {
  return std::sqrt(ratio) / 2 * sif::annular_p1(sif::AnnularPolynomials::tada, ratio);
}

double tada_M_M(double ratio) {
  return 3 * std::sqrt(ratio) / 8 * sif::annular_p3(sif::AnnularPolynomials::tada, ratio);
}

/// Ratio d_e/d_s of the printed crack.
double net_ratio() {
  const Printed p;
  return (p.d_s - 2 * p.a) / p.d_s;
}

/// The printed shaft, with coefficients from the printed polynomials.
article::CrackedShaft shaft_by_polynomials() {
  article::CrackedShaft shaft = Printed{}.shaft();
  shaft.M_p = article::axial_coefficient(net_ratio());
  shaft.M_M = article::torsion_coefficient(net_ratio());
  return shaft;
}

Rows shaft_intensity_rows() {
  Rows rows;
  const Printed p;
  const sif::AnnularCrackSolid improved{.depth = p.a, .diameter = p.d_s};
  rows.push_back({.id = "D1",
                  .quantity = "K_III of the shaft, M_M from its polynomial",
                  .unit = "MPa*mm^0.5",
                  .own = article::shaft_stress_intensity(shaft_by_polynomials(), 0, p.T).K_III,
                  .corrected = improved.stress_intensity(p.a, 0).III[kTorsion] * p.T,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "the handbook's form on the net section"});
  rows.push_back(
      {.id = "D2",
       .quantity = "M_p(1), printed +0.182 and 0.166",
       .unit = "1",
       .own = article::axial_coefficient(1),
       .corrected = tada_M_p(1),
       .verdict = AuditVerdict::misprint,
       .sentence = "the handbook prints -0.182 and 0.366, which give 1.1215 for a shallow crack"});
  rows.push_back({.id = "D3",
                  .quantity = "M_M(1), printed 0.376",
                  .unit = "1",
                  .own = article::torsion_coefficient(1),
                  .corrected = tada_M_M(1),
                  .verdict = AuditVerdict::misprint,
                  .sentence = "the handbook prints 0.375"});
  return rows;
}

Rows shaft_crack_terms_rows() {
  Rows rows;
  const Printed p;
  const article::ShaftCrackCompliance terms = article::shaft_crack_compliance(p.shaft());
  rows.push_back({.id = "D4",
                  .quantity = "first term of Delta l_so (K_I) at P = 0",
                  .unit = kCompliance,
                  .own = terms.axial_term,
                  .corrected = 0.0,
                  .verdict = AuditVerdict::physics,
                  .sentence = "K_I belongs to the axial force, so it does not contribute to the "
                              "torsional compliance; the two loads are not coupled"});
  const double solid = solid_shaft(p.a, p.d_s);
  rows.push_back({.id = "D5",
                  .quantity = "second term (K_III), dA = 2 pi a da",
                  .unit = kCompliance,
                  .own = article::shaft_crack_compliance(shaft_by_polynomials()).torsion_term,
                  .corrected = solid,
                  .verdict = AuditVerdict::physics,
                  .sentence = "this is the area of a penny crack; an annulus sweeps pi d_e da, "
                              "larger by a factor of some 3 d_e/(4a)"});
  const auto first_term = [](const Printed& q) {
    return article::shaft_crack_compliance(q.shaft()).axial_term;
  };
  rows.push_back({.id = "D6",
                  .quantity = "exponent of length of the first term",
                  .unit = "1",
                  .own = std::round(exponents_of(first_term).length) + 0.0,
                  .corrected = -1.0,
                  .verdict = AuditVerdict::dimension,
                  .sentence = fmt::format("the dimension is {}; that of a torsional compliance is "
                                          "force^-1 length^-1",
                                          dimension_text(exponents_of(first_term)))});
  rows.push_back({.id = "D7",
                  .quantity = "second term with the printed M_M = 0.42",
                  .unit = kCompliance,
                  .own = terms.torsion_term,
                  .corrected = solid,
                  .verdict = AuditVerdict::physics,
                  .sentence = "the algebra is right, but area and coefficient are wrong; M_M and "
                              "d_e vary during crack growth"});
  rows.push_back({.id = "D8",
                  .quantity = "2/E in front of K_I^2, over plane strain",
                  .unit = "1",
                  .own = 1.0,
                  .corrected = 1 - p.nu * p.nu,
                  .verdict = AuditVerdict::physics,
                  .sentence = "an annular crack is in plane strain"});
  return rows;
}

Rows sound_shaft_rows(const StiffnessResult& result) {
  Rows rows;
  const Printed p;
  const double sound = article::sound_shaft_compliance(p.L_s, p.d_s, p.mu);
  rows.push_back(
      {.id = "D9",
       .quantity = "l_so0 of a 60 x 200 mm shaft, factor 0.1",
       .unit = kCompliance,
       .own = sound,
       .corrected = torsional_compliance(Tube{.outer_diameter = p.d_s, .length = p.L_s}, p.mu),
       .verdict = AuditVerdict::reproduced,
       .sentence = "0.1 replaces pi/32"});
  const double hollow_fourth = std::pow(p.D_s, 4) - std::pow(p.d_s_bore, 4);
  rows.push_back({.id = "D10",
                  .quantity = "equivalent solid diameter d_s",
                  .unit = "mm",
                  .printed = p.d_s,
                  .own = std::pow(hollow_fourth, 0.25),
                  .corrected = std::pow(hollow_fourth, 0.25),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = fmt::format(
                      "equal polar moment gives {:.1f}, equal section modulus {:.1f}, equal area "
                      "{:.1f}; for a crack, an equivalent solid shaft does not exist",
                      std::pow(hollow_fourth, 0.25), std::cbrt(hollow_fourth / p.D_s),
                      std::sqrt(p.D_s * p.D_s - p.d_s_bore * p.d_s_bore)),
                  .reproduce = reproducing("bore", "mm", p.d_s, 1, 69, [&](double bore) {
                    return std::pow(std::pow(p.D_s, 4) - std::pow(bore, 4), 0.25);
                  })});
  rows.push_back(
      {.id = "D11",
       .quantity = "l_so0",
       .unit = kCompliance,
       .printed = 6.906e-10,
       .own = sound,
       .corrected = compliance_in_mm(result.intact.compliance.output_shaft),
       .verdict = AuditVerdict::not_reproducible,
       .sentence = "the value belongs to the hollow shaft with another length",
       .reproduce = reproducing("L_s (hollow)", "mm", 6.906e-10, 10, 1000, [&](double L) {
         return article::sound_shaft_compliance(L, std::pow(hollow_fourth, 0.25), p.mu);
       })});
  return rows;
}

Rows shaft_crack_rows(const StiffnessResult& result) {
  Rows rows;
  const Printed p;
  const double x = net_ratio();
  rows.push_back({.id = "D12",
                  .quantity = "Delta l_so",
                  .unit = kCompliance,
                  .printed = 3.9e-14,
                  .own = article::shaft_crack_compliance(p.shaft()).total(),
                  .corrected = compliance_in_mm(result.cracks[2].positive.at_output),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "the printed formula and inputs give a third of the value; the "
                              "printed value agrees with the corrected value by chance",
                  .reproduce = reproducing("a", "mm", 3.9e-14, 0.01, 10, [&](double a) {
                    return article::shaft_crack_compliance(with(&Printed::a, a).shaft()).total();
                  })});
  const double solid = solid_shaft(p.a, p.d_s);
  const double doubled = solid_shaft(p.a, 2 * p.d_s);
  rows.push_back({.id = "D13",
                  .quantity = "exponent n in Delta l_so ~ d_s^n",
                  .unit = "1",
                  .corrected = std::log2(doubled / solid),
                  .verdict = AuditVerdict::physics,
                  .sentence = "\"more compliance with larger diameters\" reverses the truth"});
  rows.push_back({.id = "D14",
                  .quantity = "M_p at d_e/d_s = 0.9967",
                  .unit = "1",
                  .printed = p.M_p,
                  .own = article::axial_coefficient(x),
                  .corrected = tada_M_p(x),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "the value belongs to a crack 46 times as deep",
                  .reproduce = reproducing("d_e/d_s (handbook)", "1", p.M_p, 0.1, 1, tada_M_p)});
  rows.push_back({.id = "D15",
                  .quantity = "M_M at d_e/d_s = 0.9967",
                  .unit = "1",
                  .printed = p.M_M,
                  .own = article::torsion_coefficient(x),
                  .corrected = tada_M_M(x),
                  .verdict = AuditVerdict::not_reproducible,
                  .sentence = "the value belongs to another crack than M_p",
                  .reproduce = reproducing("d_e/d_s (handbook)", "1", p.M_M, 0.1, 1, tada_M_M)});
  return rows;
}

}  // namespace

Rows output_shaft_rows() {
  const StiffnessResult result = corrected_example(Printed{}.a);
  return joined(shaft_intensity_rows(), shaft_crack_terms_rows(), sound_shaft_rows(result),
                shaft_crack_rows(result));
}

}  // namespace strainwave
