// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/elastic_members.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

#include "stiffness/members_support.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "support/expect.hpp"
#include "support/not_finite.hpp"
#include "support/reference.hpp"
#include "support/reference_csv.hpp"
#include "support/scaling.hpp"
#include "support/steel.hpp"

namespace strainwave {
namespace {

using test::kComplianceNmm;
using test::kG;

using test::broken_rule;

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;
using test::Arg;

// --- (ST-2): the tube ----------------------------------------------------------------------------

TEST(TubeTorsion, ReferenceArticleMembers) {
  const auto eight_digits = [](double value) {
    return test::Reference{.value = value,
                           .unit = "rad/(N*mm)",
                           .relative_tolerance = 5e-8,
                           .source = "32 L/(pi G (D^4 - d^4)), by hand",
                           .tolerance_is = "eight digits printed"};
  };
  const double G = 80 * GPa;
  const double shaft = torsional_compliance(Tube{70 * mm, 45 * mm, 200 * mm}, G);
  test::expect_reference(shaft / kComplianceNmm, eight_digits(1.2790352e-9));
  const double solid = torsional_compliance(Tube{60 * mm, 0, 200 * mm}, G);
  test::expect_reference(solid / kComplianceNmm, eight_digits(1.9648758e-9));
  const double flexspline =
      0.83 * torsional_compliance(Tube{160 * mm, 160 * mm - 2 * 2.24 * mm, 160 * mm}, G);
  test::expect_reference(flexspline / kComplianceNmm, eight_digits(2.4026580e-10));
  // The article's 0.1 for pi/32 and 110 mm give its printed 6.906e-10.
  const double printed = torsional_compliance(Tube{70 * mm, 45 * mm, 110 * mm}, G) * pi / 3.2;
  test::expect_reference(printed / kComplianceNmm, eight_digits(6.9062941e-10));
}

TEST(TubeTorsion, ReferenceTable) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("tube_and_diaphragm")) {
    const double outer = 2 * row("outer_radius");
    const double inner = 2 * row("inner_radius");
    const double size = row("length_or_thickness");
    // The tolerance is rounding; a thin wall is a difference of diameters, with the error 1e-16
    // D/t.
    if (row.quantity == "diaphragm")
      test::expect_row(torsional_compliance(AnnularPlate{outer, inner, size}, row("shear_modulus")),
                       row, 1e-14);
    else
      test::expect_row(torsional_compliance(Tube{outer, inner, size}, row("shear_modulus")), row,
                       1e-14);
    ++n;
  }
  EXPECT_GE(n, 8);
}

TEST(TubeTorsion, CrosscheckFiniteElements) {
  // Three-dimensional elements of degree 4: T L/(mu J) = 2.867199393e-10 rad/(N*mm) to 1e-8, for
  // R = 78.88, t = 2.24, L = 160 mm, E = 210 GPa, nu = 0.3.
  const double tube = torsional_compliance(Tube{160 * mm, 155.52 * mm, 160 * mm}, 210 * GPa / 2.6);
  EXPECT_NEAR(tube / kComplianceNmm / 2.867199393e-10, 1, 1e-9);  // ten digits printed
}

TEST(TubeTorsion, LimitThinWallIsBredts) {
  // 2 pi r^3 t, with r to the middle of the wall: relative error (t/2r)^2.
  const double r = 30 * mm;
  const double t = 0.01 * mm;
  const double exact = torsional_compliance(Tube{2 * r + t, 2 * r - t, 1.0}, 1.0);
  EXPECT_NEAR(exact * 2 * pi * r * r * r * t, 1, t * t / (r * r));
}

TEST(TubeTorsion, IdentityTubesInSeriesAndNested) {
  const double G = 80 * GPa;
  const Tube whole{50 * mm, 20 * mm, 100 * mm};
  Tube half = whole;
  half.length /= 2;
  test::expect_relative(2 * torsional_compliance(half, G), torsional_compliance(whole, G), 1e-15);
  // A solid bar is a tube around a core.
  const double core = 1 / torsional_compliance(Tube{20 * mm, 0, 100 * mm}, G);
  const double bar = 1 / torsional_compliance(Tube{50 * mm, 0, 100 * mm}, G);
  test::expect_relative(core + 1 / torsional_compliance(whole, G), bar, 1e-14);
}

TEST(TubeTorsion, ScalingIsAnglePerTorque) {
  test::expect_dimensionally_consistent(
      "rad/(N*m)",
      [](double D, double d, double L, double G) {
        return torsional_compliance(Tube{D, d, L}, G);
      },
      Arg{0.07, "m"}, Arg{0.045, "m"}, Arg{0.2, "m"}, Arg{8e10, "Pa"});
}

TEST(TubeTorsion, InputRulesBrokenOnce) {
  const auto broken = [](double D, double d, double L, double G) {
    return broken_rule([=] { return torsional_compliance(Tube{D, d, L}, G); });
  };
  const std::string bore = " m violates: 0 <= inner_diameter < outer_diameter";
  EXPECT_EQ(broken(0, 0, 1, 1), "outer_diameter = 0 m violates: outer_diameter > 0");
  EXPECT_EQ(broken(test::kNaN, 0, 1, 1), "outer_diameter = nan m violates: outer_diameter > 0");
  EXPECT_EQ(broken(1, 1, 1, 1), "inner_diameter = 1" + bore);
  EXPECT_EQ(broken(1, -0.1, 1, 1), "inner_diameter = -0.1" + bore);
  EXPECT_EQ(broken(1, test::kNaN, 1, 1), "inner_diameter = nan" + bore);
  EXPECT_EQ(broken(1, 0.5, 0, 1), "length = 0 m violates: length > 0");
  EXPECT_EQ(broken(1, 0.5, test::kNaN, 1), "length = nan m violates: length > 0");
  EXPECT_EQ(broken(1, 0.5, 1, 0), "shear_modulus = 0 Pa violates: shear_modulus > 0");
  EXPECT_EQ(broken(1, 0.5, 1, test::kNaN), "shear_modulus = nan Pa violates: shear_modulus > 0");
  EXPECT_EQ(broken(1, 0, 1, 1), "no error");
}

// --- (ST-3): the annular plate
// ---------------------------------------------------------------------

TEST(PlateTorsion, IdentityShearStressIntegrated) {
  // dphi/dr = tau/(G r) with tau = T/(2 pi h r^2).
  const double ri = 20 * mm;
  const double ro = 65 * mm;
  const double h = 1.5 * mm;
  const double G = 80 * GPa;
  const double twist =
      integrate([&](double r) { return 1 / (2 * pi * h * r * r) / (G * r); }, ri, ro).value;
  test::expect_relative(torsional_compliance(AnnularPlate{2 * ro, 2 * ri, h}, G), twist, 1e-12);
}

TEST(PlateTorsion, CrosscheckFiniteElementsOfACup) {
  // Axisymmetric torsion elements of tube and flat bottom, 2.24 mm, clamped at the boss radius.
  struct Case {
    double boss_radius, compliance;  // [mm], [rad/(N*mm)]
  };
  const double mu = 210 * GPa / 2.6;
  for (const Case& c : {Case{30, 7.0095e-10}, Case{50, 3.8818e-10}}) {
    const double barrel = torsional_compliance(Tube{160 * mm, 155.52 * mm, 157.76 * mm}, mu);
    const double bottom =
        torsional_compliance(AnnularPlate{157.76 * mm, 2 * c.boss_radius * mm, 2.24 * mm}, mu);
    // The tolerance is the model form: the corner between tube and bottom, 0.1 %.
    EXPECT_NEAR((barrel + bottom) / kComplianceNmm / c.compliance, 1, 1e-3);
    EXPECT_LT((barrel + bottom) / kComplianceNmm, c.compliance);
    // The bottom adds 37 % (50 mm) to 148 % (30 mm) of the tube.
    EXPECT_NEAR(bottom / barrel, c.boss_radius == 30 ? 1.48 : 0.37, 0.01);
  }
}

TEST(PlateTorsion, IdentityRingsInSeries) {
  const double G = 80 * GPa;
  const double inner = torsional_compliance(AnnularPlate{60 * mm, 40 * mm, 2 * mm}, G);
  const double outer = torsional_compliance(AnnularPlate{100 * mm, 60 * mm, 2 * mm}, G);
  const double whole = torsional_compliance(AnnularPlate{100 * mm, 40 * mm, 2 * mm}, G);
  test::expect_relative(inner + outer, whole, 1e-14);
}

TEST(PlateTorsion, ScalingIsAnglePerTorque) {
  test::expect_dimensionally_consistent(
      "rad/(N*m)",
      [](double D, double d, double h, double G) {
        return torsional_compliance(AnnularPlate{D, d, h}, G);
      },
      Arg{0.15, "m"}, Arg{0.06, "m"}, Arg{2e-3, "m"}, Arg{8e10, "Pa"});
}

TEST(PlateTorsion, InputRulesBrokenOnce) {
  const auto broken = [](double D, double d, double h, double G) {
    return broken_rule([=] { return torsional_compliance(AnnularPlate{D, d, h}, G); });
  };
  EXPECT_EQ(broken(2, 0, 1, 1), "inner_diameter = 0 m violates: inner_diameter > 0");
  EXPECT_EQ(broken(2, test::kNaN, 1, 1), "inner_diameter = nan m violates: inner_diameter > 0");
  EXPECT_EQ(broken(2, 2, 1, 1), "outer_diameter = 2 m violates: outer_diameter > inner_diameter");
  EXPECT_EQ(broken(test::kNaN, 2, 1, 1),
            "outer_diameter = nan m violates: outer_diameter > inner_diameter");
  EXPECT_EQ(broken(2, 1, 0, 1), "thickness = 0 m violates: thickness > 0");
  EXPECT_EQ(broken(2, 1, test::kNaN, 1), "thickness = nan m violates: thickness > 0");
  EXPECT_EQ(broken(2, 1, 1, 0), "shear_modulus = 0 Pa violates: shear_modulus > 0");
  EXPECT_EQ(broken(2, 1, 1, test::kNaN), "shear_modulus = nan Pa violates: shear_modulus > 0");
  EXPECT_EQ(broken(2, 1, 1, 1), "no error");
}

// --- (ST-10), (ST-13): the ring
// -----------------------------------------------------------------------

TEST(Ring, ReferenceTwoForces) {
  // Two opposite forces: the radius changes by (pi/8 - 1/pi) F R^3/(EI).
  test::expect_reference(ring_compliance(2, 1.0, 1.0),
                         {.value = 0.0743892,
                          .unit = "R^3/(EI)",
                          .relative_tolerance = 1e-6,
                          .source = "Timoshenko's ring: 0.149 F R^3/(EI) on the diameter",
                          .tolerance_is = "six digits printed"});
  EXPECT_NEAR(2 * ring_compliance(2, 1.0, 1.0), 0.149, 5e-4);
  test::expect_relative(ring_compliance(2, 1.0, 1.0), pi / 8 - 1 / pi, 1e-14);
  test::expect_reference(ring_moment_factor(2),
                         {.value = 0.3183,
                          .unit = "F R",
                          .relative_tolerance = 1e-4,
                          .source = "Timoshenko's ring: 1/pi under the force",
                          .tolerance_is = "four digits printed"});
  test::expect_relative(ring_moment_factor(2), 1 / pi, 1e-14);
}

TEST(Ring, ReferenceTable) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("ring_bending")) {
    ASSERT_EQ(row.quantity, "radial_compliance_per_load");
    // The formula has differences of nearly equal terms, which cost a few digits at U = 4.
    test::expect_row(ring_compliance(static_cast<int>(row("wave_number")), row("mean_radius"),
                                     row("bending_stiffness")),
                     row, 1e-13);
    ++n;
  }
  EXPECT_GE(n, 6);
}

TEST(Ring, IdentityBendingEnergyOfASector) {
  // Sector of half angle theta between two forces; N_0 = F/(2 sin theta) and M_0 in its middle,
  // M(s) = M_0 + N_0 R (1 - cos s), int M ds = 0.  Work of the force = twice the sector's energy.
  for (const int U : {2, 3, 5, 8}) {
    const double theta = pi / U;
    const double N_0 = 1 / (2 * std::sin(theta));
    const double M_0 = -N_0 * (1 - std::sin(theta) / theta);
    const auto moment = [&](double s) { return M_0 + N_0 * (1 - std::cos(s)); };
    EXPECT_NEAR(integrate(moment, -theta, theta).value, 0, 1e-15);
    EXPECT_NEAR(moment(theta), ring_moment_factor(U), 1e-14) << "under the force, F R = 1";
    const double twice_energy =
        integrate([&](double s) { return moment(s) * moment(s); }, -theta, theta).value;
    EXPECT_NEAR(ring_compliance(U, 1.0, 1.0) / twice_energy, 1, 1e-10) << U;
  }
}

TEST(Ring, LimitManyForces) {
  // theta -> 0: moment theta/6 (1 + theta^2/15), deflection theta^3/90 (1 + 0.19 theta^2).
  for (const int U : {20, 60}) {
    const double theta = pi / U;
    EXPECT_NEAR(ring_moment_factor(U) / (theta / 6), 1 + theta * theta / 15, 1e-2 * theta * theta);
    EXPECT_NEAR(ring_compliance(U, 1.0, 1.0) / (std::pow(theta, 3) / 90), 1, 0.2 * theta * theta);
  }
}

TEST(Ring, ScalingIsDeflectionPerForce) {
  test::expect_dimensionally_consistent(
      "m/N", [](double R, double EI) { return ring_compliance(3, R, EI); }, Arg{0.06, "m"},
      Arg{350, "N*m^2"});
}

TEST(Ring, InputRulesBrokenOnce) {
  const auto broken = [](int U, double R, double EI) {
    return broken_rule([=] { return ring_compliance(U, R, EI); });
  };
  EXPECT_EQ(broken(1, 1, 1), "wave_number = 1 violates: wave_number >= 2");
  EXPECT_EQ(broken(2, 0, 1), "mean_radius = 0 m violates: mean_radius > 0");
  EXPECT_EQ(broken(2, test::kNaN, 1), "mean_radius = nan m violates: mean_radius > 0");
  EXPECT_EQ(broken(2, 1, 0), "bending_stiffness = 0 N*m^2 violates: bending_stiffness > 0");
  EXPECT_EQ(broken(2, 1, test::kNaN),
            "bending_stiffness = nan N*m^2 violates: bending_stiffness > 0");
  EXPECT_EQ(broken(2, 1, 1), "no error");
  EXPECT_EQ(broken_rule([] { return ring_moment_factor(1); }),
            "wave_number = 1 violates: wave_number >= 2");
  EXPECT_EQ(broken_rule([] { return ring_moment_factor(2); }), "no error");
}

// --- diaphragm of any thickness (TC-13), groove in it (TC-20)
// --------------------------------------------------------------------------------

Diaphragm tapered_diaphragm() {
  return {.outer_diameter = 150 * mm,
          .inner_diameter = 80 * mm,
          .thickness = 2 * mm,
          .profile = {{.radius = 40 * mm, .thickness = 5 * mm}}};
}

/// Integral of dr/(r^3 (c + k r)) from r_1 to r_2, by partial fractions.
double linear_law(double c, double k, double r_1, double r_2) {
  const auto primitive = [&](double r) {
    return -1 / (2 * c * r * r) + k / (c * c * r) + k * k / (c * c * c) * std::log(r / (c + k * r));
  };
  return primitive(r_2) - primitive(r_1);
}

TEST(DiaphragmTorsion, ReferenceExactIntegralOfALinearLaw) {
  const double k = (2 * mm - 5 * mm) / (75 * mm - 40 * mm);
  const double c = 5 * mm - k * 40 * mm;
  // Quadrature to 1e-12; the antiderivative loses two digits in its differences.
  test::expect_relative(torsional_compliance(tapered_diaphragm(), kG),
                        linear_law(c, k, 40 * mm, 75 * mm) / (2 * pi * kG), 1e-11);
}

TEST(DiaphragmTorsion, ReferenceExactIntegralOfThreePieces) {
  Diaphragm diaphragm = tapered_diaphragm();
  diaphragm.profile = {{.radius = 45 * mm, .thickness = 5 * mm},
                       {.radius = 60 * mm, .thickness = 3 * mm}};
  const double inside = (1 / std::pow(40 * mm, 2) - 1 / std::pow(45 * mm, 2)) / 2 / (5 * mm);
  const double k_1 = -2.0 / 15;
  const double k_2 = -1.0 / 15;
  const double expected = inside + linear_law(5 * mm - k_1 * 45 * mm, k_1, 45 * mm, 60 * mm) +
                          linear_law(3 * mm - k_2 * 60 * mm, k_2, 60 * mm, 75 * mm);
  test::expect_relative(torsional_compliance(diaphragm, kG), expected / (2 * pi * kG), 1e-11);
}

TEST(DiaphragmTorsion, IdentityConstantThickness) {
  Diaphragm diaphragm = tapered_diaphragm();
  diaphragm.profile.clear();
  const double plate = torsional_compliance(AnnularPlate{150 * mm, 80 * mm, 2 * mm}, kG);
  EXPECT_EQ(torsional_compliance(diaphragm, kG), plate);
  diaphragm.profile = {{.radius = 50 * mm, .thickness = 2 * mm}};
  test::expect_relative(torsional_compliance(diaphragm, kG), plate, 1e-12);  // of the quadrature
}

TEST(DiaphragmTorsion, IdentityGrooveIsAThinnerRing) {
  Diaphragm diaphragm = tapered_diaphragm();
  diaphragm.profile.clear();
  const DiaphragmGroove groove{.depth = 0.5 * mm, .width = 2 * mm, .radius = 50 * mm};
  const auto ring = [](double h) {
    return torsional_compliance(AnnularPlate{102 * mm, 98 * mm, h}, kG);
  };
  // Two integrals with an error of 1e-12 differ by a third of their value.
  test::expect_relative(groove_compliance(diaphragm, groove, kG), ring(1.5 * mm) - ring(2 * mm),
                        1e-11);
  // In a tapered diaphragm, the thickness law is reduced by the depth: h = c - d + k r.
  const Diaphragm tapered = tapered_diaphragm();
  const double k = -3.0 / 35;
  const double c = 5 * mm - k * 40 * mm;
  test::expect_relative(
      groove_compliance(tapered, groove, kG) * 2 * pi * kG,
      linear_law(c - 0.5 * mm, k, 49 * mm, 51 * mm) - linear_law(c, k, 49 * mm, 51 * mm), 1e-9);
}

TEST(DiaphragmTorsion, LimitShallowGroove) {
  // dr d/(r^3 h^2)/(2 pi G); the next term is d/h.
  Diaphragm diaphragm = tapered_diaphragm();
  diaphragm.profile.clear();
  const double d = 1e-4 * mm;
  const double limit = (1 / std::pow(49 * mm, 2) - 1 / std::pow(51 * mm, 2)) / 2 * d /
                       std::pow(2 * mm, 2) / (2 * pi * kG);
  EXPECT_NEAR(
      groove_compliance(diaphragm, {.depth = d, .width = 2 * mm, .radius = 50 * mm}, kG) / limit, 1,
      1.1 * d / (2 * mm));
}

TEST(DiaphragmTorsion, ScalingIsAnglePerTorque) {
  test::expect_dimensionally_consistent(
      "rad/(N*m)",
      [](double length, double G) {
        Diaphragm diaphragm = tapered_diaphragm();
        diaphragm.outer_diameter *= length;
        diaphragm.inner_diameter *= length;
        diaphragm.thickness *= length;
        diaphragm.profile[0].radius *= length;
        diaphragm.profile[0].thickness *= length;
        const DiaphragmGroove groove{
            .depth = 0.5 * mm * length, .width = 2 * mm * length, .radius = 50 * mm * length};
        return torsional_compliance(diaphragm, G) + groove_compliance(diaphragm, groove, G);
      },
      Arg{1.0, "m"}, Arg{8e10, "Pa"});
}

TEST(DiaphragmTorsion, InputRulesBrokenOnce) {
  EXPECT_EQ(broken_rule([] { return torsional_compliance(tapered_diaphragm(), 0.0); }),
            "shear_modulus = 0 Pa violates: shear_modulus > 0");
}

TEST(ElasticMembers, InputNothingUnlessGiven) {
  const Tube tube;
  EXPECT_EQ(tube.outer_diameter, 0.0);
  EXPECT_EQ(tube.inner_diameter, 0.0);
  EXPECT_EQ(tube.length, 0.0);
  const AnnularPlate plate;
  EXPECT_EQ(plate.outer_diameter, 0.0);
  EXPECT_EQ(plate.inner_diameter, 0.0);
  EXPECT_EQ(plate.thickness, 0.0);
}

}  // namespace
}  // namespace strainwave
