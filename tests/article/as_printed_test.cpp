// SPDX-License-Identifier: Apache-2.0
#include "strainwave/article/as_printed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <ostream>
#include <string>
#include <string_view>

#include "article/article_support.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/reference.hpp"
#include "support/reference_csv.hpp"
#include "support/scaling.hpp"

namespace strainwave {
namespace {

using test::has_note;
using test::kCompliance;
using test::kStiffness;
using test::kStressIntensity;

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;

/// A number of the article's method, in N and mm, computed with 30 digits and rounded to eight.
test::Reference table_AP1(double value, std::string_view unit) {
  return {.value = value,
          .unit = unit,
          .relative_tolerance = 1e-7,
          .source = "theory manual, table AP-1 (printed equations, evaluated with mpmath)",
          .tolerance_is = "eight digits printed: half a unit of the last is at most 5e-8"};
}

GearSet without_printed_coefficients(double crack_size) {
  GearSet gear = test::article_gear(crack_size);
  gear.article->M_p.reset();
  gear.article->M_M.reset();
  return gear;
}

bool has_equation(const StiffnessResult& result, std::string_view tag) {
  return std::ranges::find(result.equations, tag) != result.equations.end();
}

article::CrackedRace race_of(double a, double t, double a_contact, double b_contact, double E) {
  return {.depth = a,
          .ring_thickness = t,
          .flaw_parameter = 1.5,
          .contact_factor = 0.45,
          .contact_semi_major = a_contact,
          .contact_semi_minor = b_contact,
          .youngs_modulus = E};
}

// --- The table of the example -------------------------------------------------------------------

/// One column of the table: the printed equations and inputs for one crack size; N, mm, rad.
struct PrintedColumn {
  double a;
  double K_I, Delta_u_H, Delta_K_G, K_G, lambda_H;
  double Delta_lambda_f;
  double axial_term, torsion_term, Delta_lambda_so;
  double sum, K_HD, drop_percent;
  // with M_p and M_M from the printed polynomials
  double M_p, M_M, polynomial_Delta_lambda_so, polynomial_sum, polynomial_K_HD;

  friend std::ostream& operator<<(std::ostream& out, const PrintedColumn& column) {
    return out << "a = " << column.a << " mm";
  }
};

constexpr PrintedColumn kPrintedTable[] = {
    {0.1, 2.7044745, 3.4875000e-5, 1.4336918e7, -1.4216918e7, -1.5105758e-12, 1.0969189e-16,
     1.3701999e-14, 8.2290594e-18, 1.3710228e-14, 2.1232963e-9, 4.7096582e8, -8.4991049, 1.2777642,
     0.99496179, 3.1009503e-14, 2.1233136e-9, 4.7096199e8},
    {0.5, 6.0473888, 8.7187500e-4, 5.7347670e5, -4.5347670e5, -4.7357959e-11, 2.7422973e-15,
     3.6151026e-13, 1.1152064e-15, 3.6262547e-13, 2.0778005e-9, 4.8127816e8, -10.874818, 1.2453670,
     0.96737039, 7.8194441e-13, 2.0782198e-9, 4.8118106e8},
    {1.0, 8.5522993, 3.4875000e-3, 1.4336918e5, -2.3369176e4, -9.1897683e-10, 1.0969189e-14,
     1.5483769e-12, 9.8852883e-15, 1.5582622e-12, 1.2073855e-9, 8.2823591e8, -90.805468, 1.2060730,
     0.93411009, 3.1662507e-12, 1.2089935e-9, 8.2713434e8},
    {2.0, 12.094778, 1.3950000e-2, 3.5842294e4, 8.4157706e4, 2.5518437e-10, 4.3876757e-14,
     7.1268325e-12, 9.7615577e-14, 7.2244480e-12, 2.3872458e-9, 4.1889277e8, 3.4972632, 1.1313336,
     0.87147560, 1.3045524e-11, 2.3930668e-9, 4.1787383e8},
};

class AsPrintedTable : public testing::TestWithParam<PrintedColumn> {};

// (AP-1), (AP-5), (AP-6), (AP-8), (AP-9), (AP-11), (AP-16)
TEST_P(AsPrintedTable, ReferenceEquations) {
  const PrintedColumn& c = GetParam();
  const article::CrackedRace race{.depth = c.a,
                                  .ring_thickness = 10,
                                  .flaw_parameter = 1.5,
                                  .contact_factor = 0.45,
                                  .contact_semi_major = 5,
                                  .contact_semi_minor = 2,
                                  .youngs_modulus = 2.1e5};
  const double Delta_K_G = article::race_crack_stiffness(race, 500);
  test::expect_reference(article::race_crack_displacement(race, 500),
                         table_AP1(c.Delta_u_H, "N*mm"));
  test::expect_reference(Delta_K_G, table_AP1(c.Delta_K_G, "1/mm"));
  test::expect_reference(article::radial_stiffness(1.2e5, Delta_K_G), table_AP1(c.K_G, "N/mm"));

  const article::CrackedShaft shaft{.depth = c.a,
                                    .diameter = 60,
                                    .M_p = 0.85,
                                    .M_M = 0.42,
                                    .youngs_modulus = 2.1e5,
                                    .shear_modulus = 8e4};
  const auto Delta_lambda_so = article::shaft_crack_compliance(shaft);
  test::expect_reference(Delta_lambda_so.axial_term, table_AP1(c.axial_term, "1/N"));
  test::expect_reference(Delta_lambda_so.torsion_term, table_AP1(c.torsion_term, "rad/(N*mm)"));

  const double x = (60 - 2 * c.a) / 60;
  test::expect_reference(article::axial_coefficient(x), table_AP1(c.M_p, "1"));
  test::expect_reference(article::torsion_coefficient(x), table_AP1(c.M_M, "1"));
}

// (AP-18)
TEST_P(AsPrintedTable, ReferenceDrive) {
  const PrintedColumn& c = GetParam();
  const StiffnessResult result = torsional_stiffness_as_printed(test::article_gear(c.a * mm));
  ASSERT_EQ(result.cracks.size(), 3U);
  test::expect_reference(result.cracks[0].deepest->K_I.value / kStressIntensity,
                         table_AP1(c.K_I, "MPa*mm^0.5"));
  test::expect_reference(result.positive.compliance.wave_generator.value / kCompliance,
                         table_AP1(c.lambda_H, "rad/(N*mm)"));
  test::expect_reference(result.cracks[1].positive.at_output.value / kCompliance,
                         table_AP1(c.Delta_lambda_f, "rad/(N*mm)"));
  test::expect_reference(result.cracks[2].positive.at_output.value / kCompliance,
                         table_AP1(c.Delta_lambda_so, "rad/(N*mm)"));
  test::expect_reference(result.positive.compliance.total.value / kCompliance,
                         table_AP1(c.sum, "rad/(N*mm)"));
  test::expect_reference(result.positive.stiffness.value / kStiffness,
                         table_AP1(c.K_HD, "N*mm/rad"));
  test::expect_reference(-100 * result.positive.stiffness_change.value,
                         table_AP1(c.drop_percent, "%"));
}

TEST_P(AsPrintedTable, ReferenceDriveWithThePrintedPolynomials) {
  const PrintedColumn& c = GetParam();
  const StiffnessResult result =
      torsional_stiffness_as_printed(without_printed_coefficients(c.a * mm));
  test::expect_reference(result.cracks[2].positive.at_output.value / kCompliance,
                         table_AP1(c.polynomial_Delta_lambda_so, "rad/(N*mm)"));
  test::expect_reference(result.positive.compliance.total.value / kCompliance,
                         table_AP1(c.polynomial_sum, "rad/(N*mm)"));
  test::expect_reference(result.positive.stiffness.value / kStiffness,
                         table_AP1(c.polynomial_K_HD, "N*mm/rad"));
}

TEST_P(AsPrintedTable, IdentityCracksAddWhatTheMembersGain) {
  const StiffnessResult result =
      torsional_stiffness_as_printed(test::article_gear(GetParam().a * mm));
  const Compliances& sound = result.intact.compliance;
  const Compliances& cracked = result.positive.compliance;
  const double gained[] = {cracked.wave_generator.value - sound.wave_generator.value,
                           cracked.flexspline.value - sound.flexspline.value,
                           cracked.output_shaft.value - sound.output_shaft.value};
  for (std::size_t i = 0; i < 3;
       ++i)  // a difference of members keeps 16 - log10(lambda/gain) digits
    EXPECT_NEAR(result.cracks[i].positive.at_output.value, gained[i],
                4e-16 * result.intact.compliance.total.value);
  EXPECT_NEAR(result.positive.stiffness_change.value,
              result.positive.stiffness.value / result.intact.stiffness.value - 1, 4e-15);
  EXPECT_NEAR(result.positive.wind_up.value, cracked.total.value * 100, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(CrackSizes, AsPrintedTable, testing::ValuesIn(kPrintedTable));

// (AP-2), (AP-3)
TEST(AsPrinted, ReferenceStressOfTheRace) {
  const double sigma_max = article::contact_pressure(500, 5, 2);
  test::expect_reference(sigma_max, table_AP1(23.873241, "MPa"));
  test::expect_reference(article::race_stress(0.45, sigma_max), table_AP1(5.3714793, "MPa"));
}

TEST(AsPrinted, ReferenceSoundDrive) {
  const IntactDrive intact = torsional_stiffness_as_printed(test::article_gear()).intact;
  const auto& [wave_generator, flexspline, output_shaft, total] = intact.compliance;
  test::expect_reference(wave_generator.value / kCompliance,
                         table_AP1(1.7896443e-10, "rad/(N*mm)"));
  test::expect_reference(flexspline.value / kCompliance, table_AP1(1.9578073e-10, "rad/(N*mm)"));
  test::expect_reference(output_shaft.value / kCompliance, table_AP1(1.9290123e-9, "rad/(N*mm)"));
  test::expect_reference(total.value / kCompliance, table_AP1(2.3037575e-9, "rad/(N*mm)"));
  test::expect_reference(intact.stiffness.value / kStiffness, table_AP1(4.3407347e8, "N*mm/rad"));
  EXPECT_DOUBLE_EQ(intact.wind_up.value, total.value * 100);
}

// (AP-4)
TEST(AsPrinted, ReferenceWithoutOverridesTheInputsAreUsed) {
  GearSet gear = test::article_gear();
  gear.article.reset();
  const StiffnessResult result = torsional_stiffness_as_printed(gear);
  const double tau = article::wall_shear(1e5, 78.88, 2.24);
  test::expect_reference(tau, table_AP1(1.1419269, "MPa"));
  EXPECT_NEAR(result.cracks[1].deepest->K_I.value / kStressIntensity, tau * std::sqrt(pi * 0.1),
              1e-14);
  // F_r = 251.5625 N enters K_I in proportion, Q = 1.5 follows from the aspect ratio.
  EXPECT_NEAR(result.cracks[0].deepest->K_I.value / kStressIntensity, 2.7044745 * 251.5625 / 500,
              1e-7);
  test::expect_reference(result.cracks[1].positive.at_output.value / kCompliance,
                         table_AP1(1.1536103e-16, "rad/(N*mm)"));
  test::expect_reference(result.intact.compliance.output_shaft.value / kCompliance,
                         table_AP1(1.2556898e-9, "rad/(N*mm)"));
}

TEST(AsPrinted, BehaviourModesThatTheArticleDoesNotHave) {
  const auto cracks = torsional_stiffness_as_printed(test::article_gear()).cracks;
  EXPECT_EQ(cracks.at(0).deepest->K_II.value, 0.0);
  EXPECT_EQ(cracks.at(0).deepest->K_III.value, 0.0);
  EXPECT_EQ(cracks.at(1).deepest->K_III.value, 0.0);
  EXPECT_EQ(cracks.at(2).deepest->K_II.value, 0.0);
}

// (AP-12)
TEST(AsPrinted, ReferenceSoundFlexsplineByNumberOfFactors) {
  article::SoundCup cup{.shape_coefficient = 1.0,
                        .structure_coefficient = 1.0,
                        .length = 160,
                        .pitch_diameter = 160,
                        .wall_thickness = 2.24,
                        .shear_modulus = 8e4};
  test::expect_reference(article::sound_flexspline_compliance(cup),
                         table_AP1(2.8419324e-10, "rad/(N*mm)"));
  cup.shape_coefficient = 0.83;
  test::expect_reference(article::sound_flexspline_compliance(cup),
                         table_AP1(2.3588039e-10, "rad/(N*mm)"));
  cup.structure_coefficient = 0.83;
  test::expect_reference(article::sound_flexspline_compliance(cup),
                         table_AP1(1.9578073e-10, "rad/(N*mm)"));
}

// (AP-17)
TEST(AsPrinted, ReferenceSoundShaft) {
  const double hollow = std::pow(std::pow(70.0, 4) - std::pow(45.0, 4), 0.25);
  test::expect_reference(hollow, table_AP1(66.798146, "mm"));
  test::expect_reference(article::sound_shaft_compliance(110, hollow, 8e4),
                         table_AP1(6.9062941e-10, "rad/(N*mm)"));
}

// (AP-13)
TEST(AsPrinted, IdentityStressOfTheNetShaftTimesItsCoefficient) {
  // K = M sigma_net sqrt(pi a): P over the area, T over the polar section modulus, of 60 mm - 2a.
  for (const double a : {0.1, 0.5, 5.0}) {
    const double r_e = 30 - a;
    const double area = pi * r_e * r_e;               // [mm^2]
    const double modulus = pi * r_e * r_e * r_e / 2;  // [mm^3]
    const double root = std::sqrt(pi * a);
    const double K_I = 0.85 * 1e4 / area * root;       // of 10 kN [MPa*mm^0.5]
    const double K_III = 0.42 * 1e5 / modulus * root;  // of 100 N*m
    for (const double sense : {1.0, -1.0}) {
      GearSet gear = test::article_gear();
      std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = a * mm;
      gear.load = {.torque = 100 * sense, .axial_force = 1e4 * sense};
      const StressIntensities K = torsional_stiffness_as_printed(gear).cracks[2].deepest.value();
      EXPECT_NEAR(K.K_I.value / kStressIntensity, sense * K_I, 1e-14 * K_I);
      EXPECT_EQ(K.K_II.value, 0.0);
      EXPECT_NEAR(K.K_III.value / kStressIntensity, K_III, 1e-14 * K_III);
    }
  }
}

// (AP-14), (AP-15)
TEST(AsPrinted, ReferencePolynomialsAtAShallowCrack) {
  EXPECT_NEAR(article::axial_coefficient(1.0), 1.286, 1e-15);  // 1.1215 is right
  EXPECT_NEAR(article::torsion_coefficient(1.0), 1.002, 1e-15);
}

// --- The same by a script ------------------------------------------------------------------------

/// The numbers of tests/data/article_example.csv in SI.  The file uses N/mm wherever the article
/// does, even if the dimension is wrong.
std::map<std::string, double> numbers_of(const GearSet& gear) {
  const double a = std::get<RaceSurfaceCrack>(gear.wave_generator->crack[0]).depth / mm;
  const article::CrackedRace race = race_of(a, 10, 5, 2, 2.1e5);
  const double sigma_max = article::contact_pressure(500, 5, 2);
  const double Delta_K_G = article::race_crack_stiffness(race, 500);
  const double x = (60 - 2 * a) / 60;
  const double M_p = gear.article->M_p.value_or(article::axial_coefficient(x));
  const double M_M = gear.article->M_M.value_or(article::torsion_coefficient(x));
  const auto terms = article::shaft_crack_compliance({.depth = a,
                                                      .diameter = 60,
                                                      .M_p = M_p,
                                                      .M_M = M_M,
                                                      .youngs_modulus = 2.1e5,
                                                      .shear_modulus = 8e4});
  const StiffnessResult result = torsional_stiffness_as_printed(gear);
  return {
      {"contact_pressure", sigma_max * MPa},
      {"crack_stress", article::race_stress(0.45, sigma_max) * MPa},
      {"wave_generator_stress_intensity", result.cracks[0].deepest->K_I.value},
      {"wave_generator_added_displacement", article::race_crack_displacement(race, 500) * mm},
      {"wave_generator_added_stiffness", Delta_K_G * N / mm},
      {"wave_generator_radial_stiffness", article::radial_stiffness(1.2e5, Delta_K_G) * N / mm},
      {"wave_generator_compliance", result.positive.compliance.wave_generator.value},
      {"flexspline_added_compliance", result.cracks[1].positive.at_output.value},
      {"M_p", M_p},
      {"M_M", M_M},
      {"shaft_axial_term", terms.axial_term * kCompliance},
      {"shaft_torsion_term", terms.torsion_term * kCompliance},
      {"shaft_added_compliance", result.cracks[2].positive.at_output.value},
      {"total_compliance", result.positive.compliance.total.value},
      {"stiffness", result.positive.stiffness.value},
      {"stiffness_change", result.positive.stiffness_change.value},
  };
}

std::map<std::string, double> sound_numbers_of(const GearSet& gear) {
  std::map<std::string, double> numbers = numbers_of(gear);
  const IntactDrive intact = torsional_stiffness_as_printed(gear).intact;
  numbers["wave_generator_compliance"] = intact.compliance.wave_generator.value;
  numbers["flexspline_compliance"] = intact.compliance.flexspline.value;
  numbers["shaft_compliance"] = intact.compliance.output_shaft.value;
  numbers["total_compliance"] = intact.compliance.total.value;
  numbers["stiffness"] = intact.stiffness.value;
  return numbers;
}

TEST(AsPrinted, ReferenceTableOfTheScript) {
  int compared = 0;
  for (const test::CsvRow& row : test::read_reference_csv("article_example")) {
    const std::size_t dot = row.quantity.find('.');
    const std::string variant = row.quantity.substr(0, dot);
    if (variant != "printed_inputs" && variant != "printed_polynomials") continue;
    const double a = row("depth");
    GearSet gear = test::article_gear(a > 0 ? a : 0.1 * mm);
    if (variant == "printed_polynomials") {
      gear.article->M_p.reset();
      gear.article->M_M.reset();
    }
    const auto numbers = a > 0 ? numbers_of(gear) : sound_numbers_of(gear);
    const auto number = numbers.find(row.quantity.substr(dot + 1));
    ASSERT_NE(number, numbers.end()) << row.place << ": " << row.quantity << " is not compared";
    // K_G0 - Delta K_G of 1 mm cracks loses one digit.
    test::expect_row(number->second, row, 1e-14);
    ++compared;
  }
  EXPECT_GE(compared, 2 * (4 * 16 + 7));
}

// --- Equations by themselves --------------------------------------------------------------------

// (AP-20), (AP-21)
TEST(AsPrinted, IdentityPrintedDisplacementIsHalfOfCastiglianos) {
  // G = c P^2 A, U = c P^2 A^2/2 with c = 3: dU/dP = 3 P A^2.
  const double load = 7.0;
  const double area = 0.5;
  const auto release_rate = [&](double A) { return 3 * load * load * A; };
  const double castigliano = 3 * load * area * area;
  EXPECT_NEAR(article::added_displacement(release_rate, area, load), castigliano / 2, 1e-14);
  EXPECT_NEAR(article::added_compliance(release_rate, area, load), castigliano / load, 1e-14);
}

// (AP-19)
TEST(AsPrinted, IdentityReleaseRateOfModeIIIHoldsInPlaneStrainOnly) {
  const double E = 210e9;
  const double nu = 0.3;
  const double right = (1 + nu) / E;  // 1/(2 mu)
  EXPECT_NEAR(article::energy_release_rate(0, 0, 1, E / (1 - nu * nu), nu) / right, 1.0, 1e-15);
  EXPECT_NEAR(article::energy_release_rate(0, 0, 1, E, nu) / right, 1 / (1 - nu * nu), 1e-15);
}

// (AP-19)
TEST(AsPrinted, IdentityReleaseRatesOfTheModesAddUp) {
  const double E = 210e9;
  EXPECT_DOUBLE_EQ(article::energy_release_rate(3e6, 0, 0, E, 0.3), 9e12 / E);
  EXPECT_DOUBLE_EQ(article::energy_release_rate(0, 5e6, 0, E, 0.3), 25e12 / E);
  EXPECT_DOUBLE_EQ(article::energy_release_rate(0, 0, 7e6, E, 0.3), 49e12 / 0.7 / E);
  EXPECT_DOUBLE_EQ(article::energy_release_rate(3e6, -5e6, 7e6, E, 0.3),
                   (34 + 49 / 0.7) * 1e12 / E);
}

// (AP-7)
TEST(AsPrinted, IdentitySeriesOfDisplacements) {
  GearSet gear = test::article_gear();
  gear.wave_generator->radial_stiffness.reset();
  gear.wave_generator->displacements = LobeDisplacements{.bearing = 3e-6, .cam = 1e-6};
  const StiffnessResult from_displacements = torsional_stiffness_as_printed(gear);
  EXPECT_TRUE(has_equation(from_displacements, "AP-7"));
  gear.wave_generator->displacements.reset();
  gear.wave_generator->radial_stiffness = 500 * N / (4e-6 * m);
  const StiffnessResult from_stiffness = torsional_stiffness_as_printed(gear);
  EXPECT_DOUBLE_EQ(from_displacements.positive.stiffness.value,
                   from_stiffness.positive.stiffness.value);
}

// (AP-10)
TEST(AsPrinted, IdentityThroughCrackOfEveryAngleAddsTheSame) {
  GearSet gear = test::article_gear();
  const double at_45 = torsional_stiffness_as_printed(gear).cracks[1].positive.at_output.value;
  for (const double angle : {-45 * deg, 0 * deg, 20 * deg, 90 * deg}) {
    std::get<WallThroughCrack>(gear.flexspline->crack[0]).angle = angle;
    const CrackReport crack = torsional_stiffness_as_printed(gear).cracks[1];
    EXPECT_DOUBLE_EQ(crack.positive.at_output.value, at_45);
    EXPECT_NEAR(std::hypot(crack.deepest->K_I.value, crack.deepest->K_II.value) / kStressIntensity,
                article::wall_shear(1e5, 79.88, 2.24) * std::sqrt(pi * 0.1), 1e-14);
  }
}

TEST(AsPrinted, IdentityBothSensesOfTorqueAreOne) {
  for (const bool printed_numbers : {true, false}) {
    GearSet gear = test::article_gear();
    if (!printed_numbers) gear.article.reset();  // then F_r follows from the torque
    const StiffnessResult forward = torsional_stiffness_as_printed(gear);
    gear.load.torque = -gear.load.torque;
    const StiffnessResult backward = torsional_stiffness_as_printed(gear);
    for (const StiffnessResult& result : {forward, backward}) {
      EXPECT_EQ(result.positive.stiffness.value, forward.positive.stiffness.value);
      EXPECT_EQ(result.negative.stiffness.value, forward.positive.stiffness.value);
      EXPECT_EQ(result.intact.wind_up.value, 100 * result.intact.compliance.total.value);
      EXPECT_EQ(result.positive.wind_up.value, 100 * result.positive.compliance.total.value);
      EXPECT_TRUE(has_note(result, "article.no_closure"));
      ASSERT_EQ(result.cracks.size(), 3U);
      for (std::size_t i = 0; i < 3; ++i) {
        const StressIntensities& K = *result.cracks[i].deepest;
        EXPECT_EQ(K.K_I.value, forward.cracks[i].deepest->K_I.value);
        EXPECT_EQ(K.K_II.value, forward.cracks[i].deepest->K_II.value);
        EXPECT_EQ(K.K_III.value, forward.cracks[i].deepest->K_III.value);
        EXPECT_EQ(result.cracks[i].opens_under, OpensUnder::both);
      }
    }
  }
}

TEST(AsPrinted, LimitVanishingCrackTakesTheWholeWaveGeneratorAway) {
  // Subtracted stiffnesses: Delta K_G -> infinity, so lambda_H -> -0 instead of lambda_H0.
  const StiffnessResult result = torsional_stiffness_as_printed(test::article_gear(1e-6 * mm));
  EXPECT_NEAR(result.cracks[0].positive.at_output.value,
              -result.intact.compliance.wave_generator.value,
              1e-9 * result.intact.compliance.wave_generator.value);
  EXPECT_LT(result.positive.compliance.wave_generator.value, 0.0);
}

// --- Dimensions ---------------------------------------------------------------------------------

TEST(AsPrinted, ScalingOfTheRace) {
  using test::Arg;
  test::expect_dimensionally_consistent("MPa", article::contact_pressure, Arg{500, "N"},
                                        Arg{5, "m"}, Arg{2, "m"});
  test::expect_dimensionally_consistent("N", article::radial_load, Arg{1.15, "1"}, Arg{0.35, "1"},
                                        Arg{1e5, "N*m"}, Arg{160, "m"});
  test::expect_dimensionally_consistent("Pa*m^0.5", article::race_stress_intensity, Arg{5.4, "Pa"},
                                        Arg{0.1, "m"}, Arg{1.5, "1"});
  test::expect_dimensionally_consistent("N/m", article::sound_radial_stiffness, Arg{500, "N"},
                                        Arg{3, "m"}, Arg{1, "m"}, Arg{0, "m"});
}

TEST(AsPrinted, ScalingWrongOfTheRaceCrack) {
  // The printed displacement has the dimension of a work, and the printed stiffness lacks its
  // force.
  using test::Arg;
  test::expect_dimensionally_consistent(
      "N*m",
      [](double a, double t, double ac, double bc, double E, double F_r) {
        return article::race_crack_displacement(race_of(a, t, ac, bc, E), F_r);
      },
      Arg{0.1, "m"}, Arg{10, "m"}, Arg{5, "m"}, Arg{2, "m"}, Arg{2.1e5, "Pa"}, Arg{500, "N"});
  test::expect_dimensionally_consistent(
      "1/m",
      [](double a, double t, double ac, double bc, double E, double F_r) {
        return article::race_crack_stiffness(race_of(a, t, ac, bc, E), F_r);
      },
      Arg{0.1, "m"}, Arg{10, "m"}, Arg{5, "m"}, Arg{2, "m"}, Arg{2.1e5, "Pa"}, Arg{500, "N"});
}

// (AP-9), (AP-12), (AP-13), (AP-17)
TEST(AsPrinted, ScalingOfTheSoundMembers) {
  using test::Arg;
  test::expect_dimensionally_consistent(
      "1/(N*m)",
      [](double K_G, double d_1, double w_0) {
        return article::wave_generator_compliance({.force_transmission_coefficient = 0.35,
                                                   .pitch_diameter = d_1,
                                                   .wave_number = 2,
                                                   .radial_displacement = w_0,
                                                   .ratio = 100},
                                                  K_G);
      },
      Arg{1.2e5, "N/m"}, Arg{160, "m"}, Arg{0.8, "m"});
  test::expect_dimensionally_consistent(
      "1/(N*m)",
      [](double L, double d_1, double delta, double mu) {
        return article::sound_flexspline_compliance({.shape_coefficient = 0.83,
                                                     .structure_coefficient = 0.83,
                                                     .length = L,
                                                     .pitch_diameter = d_1,
                                                     .wall_thickness = delta,
                                                     .shear_modulus = mu});
      },
      Arg{160, "m"}, Arg{160, "m"}, Arg{2.24, "m"}, Arg{8e4, "Pa"});
  test::expect_dimensionally_consistent("1/(N*m)", article::sound_shaft_compliance, Arg{200, "m"},
                                        Arg{60, "m"}, Arg{8e4, "Pa"});
}

TEST(AsPrinted, ScalingOfTheWallCrack) {
  using test::Arg;
  test::expect_dimensionally_consistent(
      "1/(N*m)",
      [](double a, double r, double t, double E) {
        return article::wall_crack_compliance({.half_length = a,
                                               .mean_radius = r,
                                               .wall_thickness = t,
                                               .stress_nonuniformity = 1.1,
                                               .dynamic_load = 1.2,
                                               .youngs_modulus = E});
      },
      Arg{0.1, "m"}, Arg{79.88, "m"}, Arg{2.24, "m"}, Arg{2.1e5, "Pa"});
  test::expect_dimensionally_consistent("Pa", article::wall_shear, Arg{1e5, "N*m"}, Arg{79.88, "m"},
                                        Arg{2.24, "m"});
}

TEST(AsPrinted, ScalingWrongOfTheAxialTermOfTheShaftCrack) {
  using test::Arg;
  const auto compliance = [](double a, double d, double E, double mu) {
    return article::shaft_crack_compliance({.depth = a,
                                            .diameter = d,
                                            .M_p = 0.85,
                                            .M_M = 0.42,
                                            .youngs_modulus = E,
                                            .shear_modulus = mu});
  };
  test::expect_dimensionally_consistent(
      "1/N",  // of a compliance that must be 1/(N*m)
      [&](double a, double d, double E, double mu) { return compliance(a, d, E, mu).axial_term; },
      Arg{0.1, "m"}, Arg{60, "m"}, Arg{2.1e5, "Pa"}, Arg{8e4, "Pa"});
  test::expect_dimensionally_consistent(
      "1/(N*m)",
      [&](double a, double d, double E, double mu) { return compliance(a, d, E, mu).torsion_term; },
      Arg{0.1, "m"}, Arg{60, "m"}, Arg{2.1e5, "Pa"}, Arg{8e4, "Pa"});
}

// --- Evidence -----------------------------------------------------------------------------------

TEST(AsPrinted, BehaviourNegativeComplianceIsNotedAndReturned) {
  const StiffnessResult negative = torsional_stiffness_as_printed(test::article_gear(0.1 * mm));
  EXPECT_LT(negative.positive.compliance.wave_generator.value, 0.0);
  EXPECT_TRUE(has_note(negative, "article.negative_compliance", "wave_generator"));
  EXPECT_TRUE(negative.usable());
  const StiffnessResult positive = torsional_stiffness_as_printed(test::article_gear(2.0 * mm));
  EXPECT_FALSE(has_note(positive, "article.negative_compliance"));
  // Just above the depth at which the two stiffnesses are equal, the whole drive turns negative.
  const StiffnessResult worse = torsional_stiffness_as_printed(test::article_gear(1.08 * mm));
  EXPECT_LT(worse.positive.stiffness.value, 0.0);
  EXPECT_TRUE(std::ranges::any_of(worse.notes, [](const Note& note) {
    return note.code == "article.negative_compliance" && note.path.empty();
  }));
}

TEST(AsPrinted, BehaviourNoUncertaintyIsStatedAndANoteSaysWhy) {
  const StiffnessResult result = torsional_stiffness_as_printed(test::article_gear());
  EXPECT_FALSE(result.intact.stiffness.relative_uncertainty.has_value());
  EXPECT_FALSE(result.positive.stiffness.relative_uncertainty.has_value());
  EXPECT_TRUE(has_note(result, "article.accuracy"));
  EXPECT_EQ(result.method, Method::as_printed);
}

TEST(AsPrinted, BehaviourFieldsThatAreNotReadAreNoted) {
  GearSet gear = test::article_gear();
  EXPECT_TRUE(has_note(torsional_stiffness_as_printed(gear), "article.not_read",
                       "wave_generator.conversion"));
  EXPECT_TRUE(has_note(torsional_stiffness_as_printed(gear), "article.not_read",
                       "flexspline.crack[0].shell_correction"));
  gear.wave_generator->conversion = Conversion::cam;
  std::get<WallThroughCrack>(gear.flexspline->crack[0]).shell_correction = false;
  EXPECT_FALSE(has_note(torsional_stiffness_as_printed(gear), "article.not_read"));

  gear.output_shaft->inner_diameter = 0;
  EXPECT_TRUE(has_note(torsional_stiffness_as_printed(gear), "article.not_read",
                       "output_shaft.crack[0].solution"));
  gear.load.axial_force = 10;
  EXPECT_TRUE(has_note(torsional_stiffness_as_printed(gear), "article.axial_force"));
  gear.drive.wave_number = 3;
  EXPECT_TRUE(has_note(torsional_stiffness_as_printed(gear), "article.wave_number"));
  gear.flexspline->shape_factor = 0.9;
  EXPECT_TRUE(has_note(torsional_stiffness_as_printed(gear), "article.factor_squared"));
}

TEST(AsPrinted, BehaviourEquationsAreThoseThatWereUsed) {
  const GearSet gear = test::article_gear();
  EXPECT_FALSE(has_equation(torsional_stiffness_as_printed(gear), "AP-4"));
  EXPECT_FALSE(has_equation(torsional_stiffness_as_printed(gear), "AP-14"));
  GearSet plain = gear;
  plain.article.reset();
  EXPECT_TRUE(has_equation(torsional_stiffness_as_printed(plain), "AP-4"));
  EXPECT_TRUE(has_equation(torsional_stiffness_as_printed(plain), "AP-14"));
  EXPECT_TRUE(has_equation(torsional_stiffness_as_printed(plain), "AP-18"));
}

TEST(AsPrinted, IdentityAbsentMembersAddNothingAndAreNoted) {
  GearSet gear = test::article_gear();
  gear.wave_generator.reset();
  gear.flexspline.reset();
  const StiffnessResult result = torsional_stiffness_as_printed(gear);
  EXPECT_EQ(result.intact.compliance.wave_generator.value, 0.0);
  EXPECT_EQ(result.intact.compliance.flexspline.value, 0.0);
  EXPECT_EQ(result.intact.compliance.total.value, result.intact.compliance.output_shaft.value);
  EXPECT_TRUE(has_note(result, "member.absent", "wave_generator"));
  EXPECT_TRUE(has_note(result, "member.absent", "flexspline"));
  EXPECT_EQ(result.cracks.size(), 1U);
}

TEST(AsPrinted, IdentitySoundDriveHasNoCrackAndNoChange) {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  gear.flexspline->crack.clear();
  gear.output_shaft->crack.clear();
  const StiffnessResult result = torsional_stiffness_as_printed(gear);
  EXPECT_EQ(result.positive.stiffness.value, result.intact.stiffness.value);
  EXPECT_EQ(result.positive.stiffness_change.value, 0.0);
  EXPECT_TRUE(result.cracks.empty());
}

// --- Refusals -----------------------------------------------------------------------------------

void printed_refuses(std::string_view path, const std::function<void(GearSet&)>& change) {
  test::expect_refused([](const GearSet& gear) { return torsional_stiffness_as_printed(gear); },
                       "as-printed", path, change);
}

TEST(AsPrinted, InputCracksThatTheArticleDoesNotHave) {
  printed_refuses("wave_generator.crack[0]", [](GearSet& gear) {
    gear.wave_generator->inner_ring_width = 20 * mm;
    gear.wave_generator->crack = {
        RaceEdgeCrack{.depth = 0.1 * mm, .contact_factor = {}, .stress = {}}};
  });
  printed_refuses("flexspline.crack[0]", [](GearSet& gear) {
    gear.flexspline->crack = {WallSurfaceCrack{.depth = 0.1 * mm, .half_length = 0.2 * mm}};
  });
}

TEST(AsPrinted, InputCracksOfTheCoupledDrive) {
  // With the sections that contain these cracks, crack_free is refused; a cracked tooth or a
  // circular spline is not read.
  const auto sections = [](GearSet& gear) {
    gear.flexspline->crack_free = CrackFree::sections;
    gear.flexspline->rim = TubeSection{160 * mm, 2.24 * mm, 20 * mm};
    gear.flexspline->barrel = TubeSection{160 * mm, 2.24 * mm, 100 * mm};
    gear.flexspline->diaphragm = Diaphragm{157.76 * mm, 80 * mm, 3 * mm, {}};
  };
  RimAxialCrack rim;
  rim.depth = 0.1 * mm;
  for (const FlexsplineCrack& crack :
       {FlexsplineCrack(rim),
        FlexsplineCrack(DiaphragmArcCrack{.half_length = 1 * mm, .radius = {}}),
        FlexsplineCrack(DiaphragmGroove{.depth = 0.1 * mm, .width = 1 * mm, .radius = 50 * mm})}) {
    GearSet gear = test::article_gear();
    sections(gear);
    gear.flexspline->crack = {crack};
    EXPECT_THROW((void)torsional_stiffness_as_printed(gear), InputError);
  }
  OuterRaceCrack race;
  race.depth = 0.1 * mm;
  GearSet gear = test::article_gear();
  gear.wave_generator->contact_semi_axes.reset();
  gear.wave_generator->radial_stiffness.reset();
  gear.wave_generator->bearing = Bearing{
      .ball_diameter = 12.7 * mm,
      .inner_raceway_diameter = 110 * mm,
      .outer_raceway_diameter = 135.4 * mm,
      .ball_count = 23,
      .outer_ring = BearingRing{.mean_radius = 70 * mm, .thickness = 4 * mm, .width = 20 * mm}};
  gear.wave_generator->crack = {race};
  EXPECT_THROW((void)torsional_stiffness_as_printed(gear), InputError);
}

TEST(AsPrinted, InputMoreThanOneCrackInAMember) {
  printed_refuses("wave_generator.crack[1]", [](GearSet& gear) {
    gear.wave_generator->crack.push_back(gear.wave_generator->crack[0]);
  });
  printed_refuses("flexspline.crack[1]", [](GearSet& gear) {
    gear.flexspline->crack.push_back(gear.flexspline->crack[0]);
    std::get<WallThroughCrack>(gear.flexspline->crack[1]).half_length *= 0.9;
  });
  printed_refuses("output_shaft.crack[1]", [](GearSet& gear) {
    gear.output_shaft->crack.push_back(gear.output_shaft->crack[0]);
  });
}

TEST(AsPrinted, InputModelsThatTheArticleDoesNotHave) {
  printed_refuses("wave_generator.bearing", [](GearSet& gear) {
    gear.wave_generator->contact_semi_axes.reset();
    gear.wave_generator->radial_stiffness.reset();
    gear.wave_generator->bearing = Bearing{.ball_diameter = 12.7 * mm,
                                           .inner_raceway_diameter = 110 * mm,
                                           .outer_raceway_diameter = 135.4 * mm,
                                           .ball_count = {},
                                           .outer_ring = {}};
  });
  printed_refuses("flexspline.crack_free", [](GearSet& gear) {
    gear.flexspline->crack_free = CrackFree::sections;
    gear.flexspline->barrel = TubeSection{160 * mm, 2.24 * mm, 160 * mm};
    gear.flexspline->diaphragm = Diaphragm{157.76 * mm, 80 * mm, 3 * mm, {}};
  });
  printed_refuses("wave_generator.crack[0].stress_driver", [](GearSet& gear) {
    auto& crack = std::get<RaceSurfaceCrack>(gear.wave_generator->crack[0]);
    crack.contact_factor.reset();
    crack.stress_driver = StressDriver::contact_edge;
  });
  printed_refuses("wave_generator.crack[0].contact_factor", [](GearSet& gear) {
    std::get<RaceSurfaceCrack>(gear.wave_generator->crack[0]).contact_factor.reset();
  });
}

TEST(AsPrinted, InputCrackDeeperThanTheEquivalentShaft) {
  printed_refuses("output_shaft.crack[0].depth", [](GearSet& gear) {
    gear.article->equivalent_shaft_diameter = 5 * mm;
    std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 3 * mm;
  });
}

TEST(AsPrinted, InputGearIsChecked) {
  GearSet gear = test::article_gear();
  gear.load.torque = 0;
  EXPECT_THROW((void)torsional_stiffness_as_printed(gear), InputError);
}

}  // namespace
}  // namespace strainwave
