// SPDX-License-Identifier: Apache-2.0
#include "strainwave/strength/failure_assessment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/drive_cracks/reference_stress.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"
#include "support/scaling.hpp"

namespace strainwave {
namespace {

using test::Arg;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr AssessmentMaterial kSteel{
    .youngs_modulus = 210e9, .yield_strength = 700e6, .ultimate_strength = 840e6};

// --- the line (FA-1), (FA-2) -------------------------------------------------------------------

TEST(AssessmentLine, ReferenceTable) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("failure_assessment")) {
    if (row.quantity != "line") continue;
    const double Y = 500e6;
    const AssessmentMaterial steel{.youngs_modulus = row("youngs_over_yield") * Y,
                                   .yield_strength = Y,
                                   .ultimate_strength = row("ultimate_over_yield") * Y};
    test::expect_row(assessment_line(row("L_r"), steel), row, 1e-14);
    ++n;
  }
  EXPECT_EQ(n, 48);
}

TEST(AssessmentLine, ReferenceByHand) {
  // mu = 0.3; at yield (2/3)^(1/2) (0.3 + 0.7 e^-0.3); N = 0.05, exponent -9.5; limit 1.1.
  const double at_yield = std::sqrt(2.0 / 3) * (0.3 + 0.7 * std::exp(-0.3));
  EXPECT_NEAR(assessment_line(1.0, kSteel), at_yield, 1e-15);
  EXPECT_NEAR(assessment_line(1.08, kSteel), at_yield * std::pow(1.08, -9.5), 1e-14);
  EXPECT_NEAR(collapse_limit(kSteel), 1.1, 1e-15);
}

TEST(AssessmentLine, LimitWithoutLoadIsToughness) {
  // f = 1 - L^2/4 + O(L^4): the tolerance is the next term.
  EXPECT_EQ(assessment_line(0.0, kSteel), 1.0);
  EXPECT_NEAR(assessment_line(0.01, kSteel), 1 - 0.01 * 0.01 / 4, 1e-8);
}

TEST(AssessmentLine, IdentityJoinsAtYieldAndEndsAtCollapse) {
  EXPECT_NEAR(assessment_line(1.0, kSteel), assessment_line(1.0 + 1e-12, kSteel), 1e-10);
  const double end = collapse_limit(kSteel);
  EXPECT_GT(assessment_line(end, kSteel), 0.0);
  EXPECT_EQ(assessment_line(end * (1 + 1e-12), kSteel), 0.0);
}

TEST(AssessmentLine, IdentityFallsAllTheWay) {
  double before = 2.0;
  for (double L = 0.0; L < collapse_limit(kSteel); L += 0.01) {
    const double f = assessment_line(L, kSteel);
    EXPECT_LT(f, before) << L;
    before = f;
  }
}

TEST(AssessmentLine, IdentityMuIsCapped) {
  // 0.001 E/sigma_Y = 0.6 and 2.1: the same line.
  const AssessmentMaterial soft{.youngs_modulus = 210e9, .yield_strength = 100e6};
  const AssessmentMaterial at_cap{.youngs_modulus = 210e9, .yield_strength = 350e6};
  EXPECT_NEAR(assessment_line(0.9, soft), assessment_line(0.9, at_cap), 1e-15);
  EXPECT_NE(assessment_line(0.9, kSteel), assessment_line(0.9, at_cap));
}

TEST(AssessmentLine, LimitWithoutUltimateStrengthEndsAtYield) {
  const AssessmentMaterial steel{.youngs_modulus = 210e9, .yield_strength = 700e6};
  EXPECT_EQ(collapse_limit(steel), 1.0);
  EXPECT_EQ(assessment_line(1.0, steel), assessment_line(1.0, kSteel));
  EXPECT_EQ(assessment_line(1.0 + 1e-12, steel), 0.0);
}

TEST(AssessmentTable, IdentityIsTheLine) {
  for (const auto& ultimate : {std::optional<double>(), std::optional<double>(840e6)}) {
    const AssessmentMaterial steel{
        .youngs_modulus = 210e9, .yield_strength = 700e6, .ultimate_strength = ultimate};
    const auto rows = assessment_table(steel, 10);
    EXPECT_EQ(rows.front().L_r, 0.0);
    EXPECT_EQ(rows.front().K_r, 1.0);
    EXPECT_EQ(rows.back().L_r, collapse_limit(steel));
    EXPECT_EQ(rows.back().K_r, 0.0);
    EXPECT_EQ(rows.size(), ultimate ? 13U : 12U);  // 0, 0.1 ... 1 or 1.1, and the end
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      EXPECT_EQ(rows[i].K_r, assessment_line(rows[i].L_r, steel));
      if (i > 0) {
        EXPECT_GT(rows[i].L_r, rows[i - 1].L_r);
      }
    }
    EXPECT_EQ(rows[rows.size() - 2].L_r, collapse_limit(steel));
  }
}

TEST(AssessmentLine, InputRules) {
  const auto broken = [](AssessmentMaterial steel, const std::string& field) {
    try {
      (void)assessment_line(0.5, steel);
      FAIL() << field;
    } catch (const InputError& error) {
      EXPECT_EQ(error.field(), field);
    }
    EXPECT_THROW((void)collapse_limit(steel), InputError);
  };
  broken({.youngs_modulus = 0, .yield_strength = 1}, "youngs_modulus");
  broken({.youngs_modulus = 1, .yield_strength = 0}, "yield_strength");
  broken({.youngs_modulus = 1, .yield_strength = 2, .ultimate_strength = 1.9}, "ultimate_strength");
  EXPECT_THROW((void)assessment_line(-0.1, kSteel), InputError);
  EXPECT_THROW((void)assessment_table(kSteel, 0), InputError);
  EXPECT_THROW((void)plasticity_interaction(-1, 0.5), InputError);
  EXPECT_THROW((void)plasticity_interaction(1, -0.5), InputError);
}

// --- interaction (FA-3) ------------------------------------------------------------------------

TEST(PlasticityInteraction, ReferenceTable) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("failure_assessment")) {
    if (row.quantity != "interaction") continue;
    test::expect_row(plasticity_interaction(row("chi"), row("L_r")), row, 1e-14);
    ++n;
  }
  EXPECT_EQ(n, 40);
}

TEST(PlasticityInteraction, LimitAndCap) {
  EXPECT_EQ(plasticity_interaction(0, 0), 1.0);
  EXPECT_NEAR(plasticity_interaction(2, 1.05 - 1e-12), 1.0, 1e-11);
  EXPECT_EQ(plasticity_interaction(2, 1.05), 1.0);
  EXPECT_EQ(plasticity_interaction(40, 0.3), plasticity_interaction(4, 0.3));
  EXPECT_EQ(plasticity_interaction(kInfinity, 0.3), plasticity_interaction(4, 0.3));
  EXPECT_LT(plasticity_interaction(3.9, 0.3), plasticity_interaction(4, 0.3));
}

// --- reference stresses (FA-6) to (FA-11) ------------------------------------------------------

TEST(ReferenceStress, ReferencePlasticTorqueOfARing) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("failure_assessment")) {
    if (row.quantity != "ring_torque") continue;
    // At the plastic torque of tau_Y = sigma_Y/sqrt(3) the reference stress is sigma_Y.  FA-7
    const double Y = 650e6;
    const double T = row.value * Y / std::sqrt(3.0);
    test::expect_relative(
        ring_reference_stress(
            {.outer_radius = row("outer_radius"), .inner_radius = row("inner_radius")}, 0, T),
        Y, 1e-13);
    ++n;
  }
  EXPECT_EQ(n, 3);
}

TEST(ReferenceStress, IdentityRing) {
  const NetRing ring{.outer_radius = 0.03, .inner_radius = 0.01};
  const double area = std::numbers::pi * (0.03 * 0.03 - 0.01 * 0.01);
  test::expect_relative(ring_reference_stress(ring, -5e3, 0), 5e3 / area, 1e-14);
  // By von Mises, squares add, so the senses do not matter.
  const double P = ring_reference_stress(ring, 7e3, 0);
  const double T = ring_reference_stress(ring, 0, 90);
  test::expect_relative(ring_reference_stress(ring, 7e3, -90), std::hypot(P, T), 1e-14);
  EXPECT_EQ(von_mises(3.0, 0.0), 3.0);
  EXPECT_NEAR(von_mises(1.0, 2.0), std::sqrt(13.0), 1e-15);
}

TEST(ReferenceStress, LimitThinRingIsMeanShear) {
  // T/(2 pi r^2 t) sqrt(3); the next term is t^2/(12 r^2).
  const double t = 1e-4;
  const double r = 0.05;
  const double T = 100;
  test::expect_relative(
      ring_reference_stress({.outer_radius = r + t / 2, .inner_radius = r - t / 2}, 0, T),
      std::sqrt(3.0) * T / (2 * std::numbers::pi * r * r * t), t * t / (6 * r * r));
}

TEST(ReferenceStress, ReferenceThroughWall) {
  // FA-8: two gaps of 2 a |sin| in the circumference; one of 2 a |cos| in the length.
  const auto share = [](double a, double angle, double length) {
    return through_wall_share(
        {.half_length = a, .angle = angle, .mean_radius = 0.04, .length = length});
  };
  const double half_pi = std::numbers::pi / 2;
  const double round = 2 * std::numbers::pi * 0.04;
  EXPECT_NEAR(*share(0.01, half_pi, 0.1), 1 - 2 * 2 * 0.01 / round, 1e-15);
  EXPECT_NEAR(*share(0.01, -half_pi, kInfinity), 1 - 2 * 2 * 0.01 / round, 1e-15);
  EXPECT_NEAR(*share(0.01, 0.0, 0.1), 0.8, 1e-15);
  EXPECT_NEAR(*share(0.01, std::numbers::pi / 3, 0.1), 1 - 4 * 0.01 * std::sqrt(0.75) / round,
              1e-15);
  // A crack over half of the circumference leaves nothing, because two gaps are counted.
  EXPECT_FALSE(share(round / 4, half_pi, kInfinity).has_value());
  EXPECT_FALSE(share(0.05, 0.0, 0.1).has_value());
  EXPECT_TRUE(share(0.0499, 0.0, 0.1).has_value());
}

// Kind: reference (FA-16).  Cracks in one line leave 1 - 2a/p; a row of short cracks is sound;
// where the tips of neighbours are level, the line between them and the strip are the same section.
TEST(ReferenceStress, ReferenceRowThroughWall) {
  const double half_pi = std::numbers::pi / 2;
  const auto row = [](double a, double angle, double sigma, double tau) {
    return *row_reference_stress({.half_length = a, .angle = angle, .pitch = 1.0}, sigma, tau);
  };
  test::expect_relative(row(0.3, half_pi, 0, 1), std::sqrt(3.0) / 0.4, 1e-12);
  test::expect_relative(row(0.3, half_pi, 2, 0), 2 / 0.4, 1e-12);
  for (const double angle : {0.0, 0.4, -1.1})
    test::expect_relative(row(1e-9, angle, 0.7, 1), von_mises(0.7, 1), 1e-8);
  for (const double angle : {0.3, -0.8, 1.2})
    for (const double tau : {1.0, -1.0}) {
      const double level = std::abs(std::sin(angle)) / 2;
      test::expect_relative(row(level * (1 - 1e-9), angle, 0.5, tau),
                            row(level * (1 + 1e-9), angle, 0.5, tau), 1e-7);
    }
  // Axial cracks: a beam of width p and length 2a with the shear tau p; long ones bend alone, with
  // M = tau p^2 a/p = sigma p^2/4.
  const double a = 20;
  const double shear = 1.0;
  test::expect_relative(row(a, 0.0, 0, shear), std::hypot(4 * a, std::sqrt(3.0)), 1e-12);
  // A strip along its own pull: sigma round a 45 degree row, the other sense presses it alike.
  const double strip = std::numbers::sqrt2 / 2;
  const double h = 2 * 0.8 - strip;
  const double bend = 2 * 1.0 * h / strip;  // F_m = tau p/sqrt(2), w = p/sqrt(2)
  test::expect_relative(row(0.8, std::numbers::pi / 4, 0, 1),
                        von_mises(bend / 2 + std::hypot(bend / 2, 1.0), 1.0), 1e-12);
  test::expect_relative(row(0.8, std::numbers::pi / 4, 0, -1), row(0.8, std::numbers::pi / 4, 0, 1),
                        1e-12);
  // Between the tips, by hand: from tip to tip (1 - 2a/sqrt(2), 2a/sqrt(2)) at 45 degrees.
  const double to_round = 1 - 0.3 * std::numbers::sqrt2;
  const double to_along = 0.3 * std::numbers::sqrt2;
  const double square = to_round * to_round + to_along * to_along;
  test::expect_relative(row(0.3, std::numbers::pi / 4, 0, 1),
                        std::max(std::sqrt(3.0), von_mises(to_along / square, to_round / square)),
                        1e-12);
  // The sense counts where an axial force acts too.
  EXPECT_NE(row(0.3, std::numbers::pi / 4, 1.5, 1), row(0.3, std::numbers::pi / 4, 1.5, -1));
  EXPECT_FALSE(row_reference_stress({.half_length = 0.5, .angle = half_pi, .pitch = 1.0}, 0, 1));
}

TEST(ReferenceStress, ReferenceLigament) {
  // FA-9: the net thickness.  FA-10: the plastic moment sigma_Y B (t-a)^2/4 against sigma B t^2/6.
  const double Y = 900e6;
  const double B = 0.011;
  const double t = 0.003;
  for (const double a : {0.0, 0.001, 0.0025}) {
    const double force = Y * B * (t - a);
    test::expect_relative(
        ligament_reference_stress(SectionLoading::membrane, force / (B * t), a / t), Y, 1e-14);
    const double moment = Y * B * (t - a) * (t - a) / 4;
    test::expect_relative(
        ligament_reference_stress(SectionLoading::bending, 6 * moment / (B * t * t), a / t), Y,
        1e-14);
  }
}

TEST(ReferenceStress, LimitOfTheGroove) {
  // FA-11: shallow, the antiplane edge crack tau sqrt(pi d), next term (pi d/2h)^2/6; at half
  // depth, tau sqrt(2 h).
  const double tau = annulus_shear(300, 0.03, 0.001);
  test::expect_relative(tau, 300 / (2 * std::numbers::pi * 0.03 * 0.03 * 0.001), 1e-15);
  const double d = 1e-6;
  test::expect_relative(groove_intensity(tau, d, 0.001), tau * std::sqrt(std::numbers::pi * d),
                        1e-6);
  test::expect_relative(groove_intensity(tau, 0.0005, 0.001), tau * std::sqrt(0.002), 1e-14);
  EXPECT_EQ(groove_intensity(tau, 0.0, 0.001), 0.0);
}

TEST(ReferenceStress, ScalingOfTheUnits) {
  test::expect_dimensionally_consistent(
      "Pa",
      [](double r_e, double r_i, double P, double T) {
        return ring_reference_stress({.outer_radius = r_e, .inner_radius = r_i}, P, T);
      },
      Arg{0.03, "m"}, Arg{0.01, "m"}, Arg{2e3, "N"}, Arg{50, "N*m"});
  test::expect_dimensionally_consistent(
      "Pa*m^0.5",
      [](double T, double r, double h, double d) {
        return groove_intensity(annulus_shear(T, r, h), d, h);
      },
      Arg{50, "N*m"}, Arg{0.03, "m"}, Arg{0.002, "m"}, Arg{0.001, "m"});
}

TEST(ReferenceStress, InputRules) {
  EXPECT_THROW((void)ring_reference_stress({.outer_radius = 1, .inner_radius = -0.1}, 0, 1),
               InputError);
  EXPECT_THROW((void)ring_reference_stress({.outer_radius = 1, .inner_radius = 1}, 0, 1),
               InputError);
  for (const double alpha : {-0.1, 1.0})
    EXPECT_THROW((void)ligament_reference_stress(SectionLoading::membrane, 1, alpha), InputError);
  EXPECT_THROW((void)groove_intensity(1, 0, 0), InputError);
  EXPECT_THROW((void)groove_intensity(1, -0.1, 1), InputError);
  EXPECT_THROW((void)groove_intensity(1, 1, 1), InputError);
}

}  // namespace
}  // namespace strainwave
