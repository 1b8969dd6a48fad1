// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave::sif {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;

const Row& through() { return solution("plate-through"); }
const Row& surface() { return solution("plate-surface"); }

const ComplianceEntry& entry(const Evaluation& e, const std::string& i, const std::string& j) {
  for (const ComplianceEntry& c : e.compliance)
    if (c.load_i == i && c.load_j == j) return c;
  throw std::runtime_error("no entry " + i + ", " + j);
}

TEST(Evaluation, ReferenceGriffithCrack) {
  // By hand: K = sigma sqrt(pi a), G = K^2/E, U = sigma^2 pi a^2 t/E, C = 2U/sigma^2.
  const double a = 3 * mm;
  const double t = 1 * mm;
  const Evaluation e =
      evaluate(through(), {{"half_length", a}, {"thickness", t}, {"tension", 100 * MPa}},
               {.youngs_modulus = 200 * GPa, .poissons_ratio = 0.25, .fracture_toughness = 20e6});
  ASSERT_EQ(e.points.size(), 1U);
  const double K = 100 * MPa * std::sqrt(pi * a);
  EXPECT_DOUBLE_EQ(e.points[0].K_I, K);
  EXPECT_NEAR(e.points[0].K_II, 0, 1e-9 * K);
  EXPECT_DOUBLE_EQ(e.largest->K_I, K);
  EXPECT_NEAR(*e.equivalent, K, 1e-12 * K);
  EXPECT_NEAR(*e.utilisation, K / 20e6, 1e-12);
  const ComplianceEntry& C = entry(e, "tension", "tension");
  EXPECT_NEAR(C.value, 2 * pi * a * a * t / (200 * GPa), 1e-9 * C.value);
  EXPECT_EQ(C.unit, "m^3/Pa");
  EXPECT_TRUE(e.converged);
  EXPECT_TRUE(e.in_range());
}

TEST(Evaluation, ReferenceModeThreeHasItsOwnModulus) {
  // K_eq^2 = E G, G = K_III^2/(2 mu): K_eq = K_III sqrt(1 + nu) in plane stress; (FR-20).
  const Evaluation e =
      evaluate(through(), {{"antiplane_shear", 1 * MPa}},
               {.youngs_modulus = 200 * GPa, .poissons_ratio = 0.25, .fracture_toughness = {}});
  EXPECT_NEAR(*e.equivalent, e.points[0].K_III * std::sqrt(1.25), 1e-12 * *e.equivalent);
  EXPECT_FALSE(e.utilisation);
  const ComplianceEntry& C = entry(e, "antiplane_shear", "antiplane_shear");
  const double mu = 200 * GPa / 2.5;
  EXPECT_NEAR(C.value, pi * std::pow(5 * mm, 2) * 2 * mm / mu, 1e-9 * C.value);
}

TEST(Evaluation, ReferencePlaneStrainOfTheSurfaceCrack) {
  // In plane strain, compliance is proportional to 1 - nu^2, and K does not depend on nu.
  const Evaluation low = evaluate(
      surface(), {}, {.youngs_modulus = 210 * GPa, .poissons_ratio = 0, .fracture_toughness = {}});
  const Evaluation high =
      evaluate(surface(), {},
               {.youngs_modulus = 210 * GPa, .poissons_ratio = 0.4, .fracture_toughness = {}});
  EXPECT_NEAR(entry(high, "tension", "tension").value / entry(low, "tension", "tension").value,
              1 - 0.16, 1e-9);
}

TEST(Evaluation, IdentityLoadsSuperpose) {
  const auto with = [](double tension, double bending) {
    return evaluate(surface(), {{"tension", tension}, {"bending", bending}}).points[1].K_I;
  };
  EXPECT_NEAR(with(100e6, -40e6), with(100e6, 0) + with(0, -40e6), 1e-6);
  EXPECT_LT(with(0, -40e6), 0);
}

TEST(Evaluation, IdentityGeometryFactorsAreThoseOfTheStressIntensity) {
  const Evaluation e = evaluate(surface(), {{"depth", 1 * mm}, {"bending", 50 * MPa}});
  const double scale = 50 * MPa * std::sqrt(pi * 1 * mm);
  for (const PointIntensity& point : e.points)
    for (const GeometryFactors& factor : e.factors)
      if (factor.load == "bending" && factor.point == point.name) {
        EXPECT_NEAR(factor.Y_I, point.K_I / scale, 1e-12);
      }
  EXPECT_EQ(e.factors.size(), 4U);
}

TEST(Evaluation, IdentityLargestIsTheLargestOfTheFront) {
  const Evaluation e = evaluate(surface(), {{"tension", 1 * MPa}});
  for (const PointIntensity& point : e.points) EXPECT_GE(e.largest->K_I, std::abs(point.K_I));
}

TEST(Evaluation, IdentityPressedFacesCountAsNothing) {
  // (FR-17): under pure compression mode I vanishes.
  const CrackMaterial steel{
      .youngs_modulus = 210 * GPa, .poissons_ratio = 0.3, .fracture_toughness = 50e6};
  const Evaluation e = evaluate(surface(), {{"tension", -2000 * MPa}}, steel);
  EXPECT_TRUE(e.pressed);
  EXPECT_EQ(*e.equivalent, 0);
  EXPECT_EQ(*e.utilisation, 0);
  EXPECT_LT(e.largest->K_I, 0);
  EXPECT_FALSE(evaluate(surface(), {{"tension", 2000 * MPa}}, steel).pressed);
  // Bending opens one side of a bar while a larger force presses the other.  Only the opening
  // counts as mode I, and the shear of the torque stays.
  const Row& bar = solution("bar-annular");
  const Evaluation opened = evaluate(bar, {{"moment", 100.0}, {"force", -3000.0}}, steel);
  const double moment = evaluate(bar, {{"moment", 100.0}}, steel).largest->K_I;
  const double force = evaluate(bar, {{"force", 3000.0}}, steel).largest->K_I;
  EXPECT_NEAR(opened.largest->K_I, moment - force, 1e-9 * moment);
  EXPECT_NEAR(*opened.equivalent, moment - force, 1e-9 * moment);
  EXPECT_TRUE(opened.pressed);
}

TEST(Evaluation, ReferenceOnePoissonsRatio) {
  // Penny under shear: C = 32 (1 - nu^2) a^3/(3 (2 - nu) E); by hand from Eshelby's slip.
  const Row& penny = solution("body-penny");
  const auto compliance = [&](const Assignments& values, double nu) {
    return entry(evaluate(
                     penny, values,
                     {.youngs_modulus = 210 * GPa, .poissons_ratio = nu, .fracture_toughness = {}}),
                 "shear", "shear")
        .value;
  };
  const double a = 1 * mm;
  const std::string size(penny.fields.front().name);
  for (const double nu : {0.0, 0.25, 0.4}) {
    const double by_hand = 32 * (1 - nu * nu) * a * a * a / (3 * (2 - nu) * 210 * GPa);
    EXPECT_NEAR(compliance({{size, a}, {"poissons_ratio", nu}}, 0.3) / by_hand, 1, 1e-8) << nu;
    EXPECT_NEAR(compliance({{size, a}}, nu) / by_hand, 1, 1e-8) << nu;
  }
}

TEST(Evaluation, BehaviourAccuracyOfTheModesThatAreThere) {
  const auto modes = [](const char* name, const Assignments& loads) {
    std::string text;
    for (const ModeAccuracy& accuracy : mode_accuracies(evaluate(solution(name), loads)))
      text += std::string(accuracy.of) + " " +
              std::to_string(accuracy.relative_uncertainty).substr(0, 4) + "; ";
    return text;
  };
  for (const char* const bar : {"bar-surface", "bar-straight"}) {
    EXPECT_EQ(modes(bar, {{"torque", 100.0}}), "K_II and K_III 0.05; ");
    EXPECT_EQ(modes(bar, {{"force", 100.0}}), "K_I 0.03; ");
    EXPECT_EQ(modes(bar, {{"torque", 100.0}, {"moment", 5.0}}), "K_I 0.03; K_II and K_III 0.05; ");
    EXPECT_EQ(modes(bar, {{"torque", 100.0}, {"moment", 0.0}}), "K_II and K_III 0.05; ");
    EXPECT_EQ(modes(bar, {}), "K_I 0.03; K_II and K_III 0.05; ");
  }
  EXPECT_EQ(modes("bar-penny", {{"torque", 100.0}}), "K 0.00; ");
}

TEST(Evaluation, InputAbsurdNumbersHaveNoAnswer) {
  EXPECT_THROW((void)evaluate(through(), {{"tension", 1e200}}), SolverError);
}

TEST(Evaluation, IdentityWithoutLoadsThereIsNoStressIntensity) {
  const Evaluation e = evaluate(through(), {});
  EXPECT_TRUE(e.points.empty());
  EXPECT_FALSE(e.largest);
  EXPECT_FALSE(e.equivalent);
  for (const Input& load : e.loads) EXPECT_FALSE(load.given);
  EXPECT_FALSE(e.factors.empty());
}

TEST(Evaluation, InputWhatIsOutsideTheRangeIsSaid) {
  const Evaluation e = evaluate(through(), {{"half_length", 1 * mm}, {"thickness", 2 * mm}});
  EXPECT_FALSE(e.in_range());
  ASSERT_EQ(e.validity.size(), 1U);
  EXPECT_FALSE(e.validity[0].inside);
}

TEST(Evaluation, InputEachRuleBroken) {
  const double nan = std::nan("");
  EXPECT_THROW((void)evaluate(surface(), {{"depht", 1 * mm}}), InputError);
  EXPECT_THROW((void)evaluate(surface(), {{"depth", 0.0}}), InputError);
  EXPECT_THROW((void)evaluate(surface(), {{"depth", 10 * mm}}), InputError);
  EXPECT_THROW((void)evaluate(surface(), {{"half_length", 100 * mm}}), InputError);
  EXPECT_THROW((void)evaluate(surface(), {{"tension", nan}}), InputError);
  const auto with = [](double E, double nu) {
    return evaluate(surface(), {},
                    {.youngs_modulus = E, .poissons_ratio = nu, .fracture_toughness = {}});
  };
  EXPECT_THROW((void)with(0, 0.3), InputError);
  EXPECT_THROW((void)with(nan, 0.3), InputError);
  EXPECT_THROW((void)with(210e9, 0.5), InputError);
  EXPECT_THROW((void)with(210e9, -1), InputError);
}

TEST(ComplianceUnit, ReferenceOfAllPairs) {
  const LoadInfo stress{"s", "Pa", ""};
  const LoadInfo force{"n", "N", ""};
  const LoadInfo moment{"m", "N*m", ""};
  EXPECT_EQ(compliance_unit(stress, stress), "m^3/Pa");
  EXPECT_EQ(compliance_unit(force, force), "m/N");
  EXPECT_EQ(compliance_unit(moment, moment), "rad/(N*m)");
  EXPECT_EQ(compliance_unit(force, moment), "1/N");
  EXPECT_EQ(compliance_unit(moment, force), "1/N");
  EXPECT_EQ(compliance_unit(force, stress), "m/Pa");
  EXPECT_EQ(compliance_unit(moment, stress), "rad/Pa");
  EXPECT_EQ(compliance_unit(stress, moment), "m^3/(N*m)");
}

}  // namespace
}  // namespace strainwave::sif
