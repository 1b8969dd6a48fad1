// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "stiffness/members_support.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/reference.hpp"
#include "support/scaling.hpp"
#include "support/steel.hpp"

namespace strainwave {
namespace {

using test::Codes;
using test::entries;
using test::kComplianceNmm;
using test::kG;
using test::kPlaneStrain;

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;
using test::Arg;

constexpr CrackModuli kSteel{.opening = kPlaneStrain, .shear = kG};

/// The article's hollow shaft, long enough for its crack.
GearSet hollow(double depth = 1 * mm) {
  GearSet gear = test::article_gear(depth);
  gear.output_shaft->length = 300 * mm;
  return gear;
}

GearSet solid(double depth = 1 * mm, AnnularSolution solution = AnnularSolution::improved) {
  GearSet gear = hollow(depth);
  gear.output_shaft->outer_diameter = 60 * mm;
  gear.output_shaft->inner_diameter = 0;
  std::get<AnnularCrack>(gear.output_shaft->crack[0]).solution = solution;
  return gear;
}

CrackReport first_shaft_crack(const GearSet& gear) {
  return output_shaft_compliance(gear).cracks.at(0);
}

std::array<double, 3> uncertainties(const GearSet& gear) {
  const std::array<Quantity, 3> m = first_shaft_crack(gear).positive.axial_torsion.value();
  return {*m[0].relative_uncertainty, *m[1].relative_uncertainty, *m[2].relative_uncertainty};
}

// --- the sound shaft (ST-2)
// ------------------------------------------------------------------------

TEST(OutputShaft, ReferenceSound) {
  GearSet gear = test::article_gear();
  test::expect_reference(
      output_shaft_compliance(gear).intact / kComplianceNmm,
      test::corrected_reference(1.2790352e-9, "rad/(N*mm)", 5e-8, "eight digits printed"));
  gear = solid();
  gear.output_shaft->length = 200 * mm;
  test::expect_reference(
      output_shaft_compliance(gear).intact / kComplianceNmm,
      test::corrected_reference(1.9648758e-9, "rad/(N*mm)", 5e-8, "eight digits printed"));
  EXPECT_EQ(output_shaft_compliance(gear).relative_uncertainty, 0.01);
}

// --- the cracked shaft
// --------------------------------------------------------------------------------

TEST(OutputShaftCrack, ReferenceHollow) {
  struct Case {
    double depth, torsion, axial;  // [mm], [rad/(N*mm)], [mm/N]
  };
  // Polynomials fitted to finite elements for 70/45 mm.
  for (const Case& c :
       {Case{0.1, 1.3846374e-14, 7.3889722e-12}, Case{1.0, 1.3920049e-12, 7.5050278e-10}}) {
    const auto [PP, PT, TT] = entries(first_shaft_crack(hollow(c.depth * mm)).positive);
    test::expect_reference(
        TT / kComplianceNmm,
        test::corrected_reference(
            c.torsion, "rad/(N*mm)", 1e-4,
            "model form: the fit, 6.5e-5, and the table it is compared with, 3e-5"));
    test::expect_reference(
        PP * (N / mm),
        test::corrected_reference(c.axial, "mm/N", 5e-4,
                                  "model form: the fit, 2e-4, of elements of a lower degree"));
    EXPECT_EQ(PT, 0.0);
  }
}

TEST(OutputShaftCrack, ReferenceSolid) {
  struct Case {
    double depth;
    AnnularSolution solution;
    double torsion, axial;  // [mm], -, [rad/(N*mm)], [mm/N]
  };
  for (const Case& c : {Case{0.1, AnnularSolution::tada, 2.0646479e-14, 4.0305855e-12},
                        Case{1.0, AnnularSolution::tada, 2.1000955e-12, 3.9758414e-10},
                        Case{0.1, AnnularSolution::improved, 2.0580757e-14, 4.0381213e-12},
                        Case{1.0, AnnularSolution::improved, 2.0698257e-12, 4.0410622e-10}}) {
    const auto [PP, PT, TT] = entries(first_shaft_crack(solid(c.depth * mm, c.solution)).positive);
    test::expect_reference(
        TT / kComplianceNmm,
        test::corrected_reference(c.torsion, "rad/(N*mm)", 5e-8, "eight digits printed"));
    test::expect_reference(
        PP * (N / mm), test::corrected_reference(c.axial, "mm/N", 5e-8, "eight digits printed"));
    EXPECT_EQ(PT, 0.0);
  }
}

TEST(OutputShaftCrack, CrosscheckMatrixByTheFractureModule) {
  for (const double axial_force : {0.0, 500.0, -500.0}) {
    GearSet gear = hollow(3 * mm);
    gear.load.axial_force = axial_force;
    const bool open = axial_force >= 0;
    const auto expected = added_compliance(sif::AnnularCrackHollow({.depth = 3 * mm,
                                                                    .outer_radius = 35 * mm,
                                                                    .inner_radius = 22.5 * mm,
                                                                    .open = open}),
                                           kSteel)
                              .matrix.upper;
    const CrackReport crack = first_shaft_crack(gear);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(entries(crack.positive)[i], expected[i], 1e-12 * expected[i]);
      EXPECT_EQ(entries(crack.positive)[i], entries(crack.negative)[i]);
    }
    EXPECT_EQ(crack.positive.at_output.value, entries(crack.positive)[2]);
    EXPECT_EQ((*crack.positive.axial_torsion)[0].unit, "m/N");
    EXPECT_EQ((*crack.positive.axial_torsion)[1].unit, "1/N");
    EXPECT_EQ((*crack.positive.axial_torsion)[2].unit, "rad/(N*m)");

    gear = solid(3 * mm);
    gear.load.axial_force = axial_force;
    const auto in_solid =
        added_compliance(sif::AnnularCrackSolid{.depth = 3 * mm, .diameter = 60 * mm, .open = open},
                         kSteel)
            .matrix.upper;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(entries(first_shaft_crack(gear).positive)[i], in_solid[i], 1e-12 * in_solid[i]);
  }
}

TEST(OutputShaftCrack, LimitSquareOfTheDepth) {
  for (const bool is_solid : {false, true}) {
    const auto coefficient = [&](double a) {
      return first_shaft_crack(is_solid ? solid(a) : hollow(a)).positive.at_output.value / (a * a);
    };
    EXPECT_NEAR(coefficient(1e-9) / coefficient(1e-6), 1, 1e-3);  // next term a/d
  }
}

TEST(OutputShaftCrack, IdentityTorqueNeitherOpensNorCloses) {
  const auto opens = [](double axial_force, double torque) {
    GearSet gear = hollow();
    gear.load = {.torque = torque, .axial_force = axial_force};
    return first_shaft_crack(gear).opens_under;
  };
  for (const double torque : {100.0, -100.0}) {
    EXPECT_EQ(opens(0, torque), OpensUnder::neither);
    EXPECT_EQ(opens(1e-9, torque), OpensUnder::both);
    EXPECT_EQ(opens(-1e-9, torque), OpensUnder::neither);
  }
}

// --- stress intensities at the load (FR-12) to (FR-20)
// ---------------------------------------------------

TEST(OutputShaftIntensities, IdentityOfBothLoads) {
  for (const bool is_solid : {false, true})
    for (const double axial_force : {2e4, 0.0, -2e4}) {
      GearSet gear = is_solid ? solid(2 * mm) : hollow(2 * mm);
      gear.load = {.torque = -700, .axial_force = axial_force};
      gear.material["steel"].fracture_toughness = 50e6;
      gear.material["steel"].yield_strength = 600 * MPa;
      const UnitStressIntensity<2> k =
          is_solid ? sif::AnnularCrackSolid{.depth = 2 * mm, .diameter = 60 * mm}.stress_intensity(
                         2 * mm, 0)
                   : sif::AnnularCrackHollow(
                         {.depth = 2 * mm, .outer_radius = 35 * mm, .inner_radius = 22.5 * mm})
                         .stress_intensity(2 * mm, 0);
      const double K_I = std::max(0.0, k.I[0] * axial_force);
      const double K_III = k.III[1] * -700;
      const CrackReport crack = first_shaft_crack(gear);
      test::expect_relative(crack.deepest->K_III.value, K_III, 1e-13);
      EXPECT_NEAR(crack.deepest->K_I.value, K_I, 1e-13 * K_I);
      EXPECT_EQ(crack.deepest->K_II.value, 0.0);
      EXPECT_EQ(crack.largest->K_III.value, crack.deepest->K_III.value);
    }
}

TEST(OutputShaftIntensities, ReferenceHandbookShallowCrack) {
  // K_III -> 16T/(pi d^3) sqrt(pi a) at a half plane's edge; the fit 2e-4, a/d = 1.7e-6.
  GearSet gear = solid(1e-7);
  gear.load.torque = 1000;
  test::expect_reference(first_shaft_crack(gear).deepest->K_III.value,
                         {.value = 16 * 1000 / (pi * std::pow(60 * mm, 3)) * std::sqrt(pi * 1e-7),
                          .unit = "Pa*m^0.5",
                          .relative_tolerance = 3e-4,
                          .source = "tada2000 (secondary): half plane in antiplane shear, exact",
                          .tolerance_is = "accuracy of the fitted polynomial"});
}

// --- notes, accuracies, ranges
// -----------------------------------------------------------------------------

TEST(OutputShaft, BehaviourNotesOfEachCase) {
  const auto codes = [](const GearSet& gear) {
    return test::note_codes(output_shaft_compliance(gear).notes);
  };
  EXPECT_EQ(codes(hollow()), Codes{});
  EXPECT_EQ(codes(solid()), Codes{});
  GearSet gear = hollow();
  gear.load.axial_force = -1;
  EXPECT_EQ(codes(gear), Codes{"crack.closed"});
  gear = hollow();
  gear.output_shaft->crack.push_back(gear.output_shaft->crack[0]);
  EXPECT_EQ(codes(gear), Codes{"crack.superposed"});
  EXPECT_EQ(output_shaft_compliance(gear).cracks.at(0).path, "output_shaft.crack[0]");
  EXPECT_EQ(output_shaft_compliance(gear).cracks.at(1).path, "output_shaft.crack[1]");
  EXPECT_EQ(first_shaft_crack(gear).kind, "annular");
  gear.output_shaft->crack.clear();
  gear.output_shaft->length = 1 * mm;  // short, but without a crack
  EXPECT_EQ(codes(gear), Codes{});
}

TEST(OutputShaftCrack, LimitShortShaft) {
  const double bound = 2 * (70 * mm);
  for (const auto& [length, noted] :
       {std::pair{bound, 0}, {bound * (1 - 1e-11), 1}, {100 * mm, 1}, {300 * mm, 0}}) {
    GearSet gear = hollow();
    gear.output_shaft->length = length;
    EXPECT_EQ(test::count_notes(output_shaft_compliance(gear).notes, "crack.short_shaft",
                                "output_shaft.crack[0]"),
              noted);
  }
}

TEST(OutputShaftCrack, LimitPoissonsRatio) {
  for (const auto& [nu, noted] : {std::pair{0.3, 0},
                                  {0.3199, 0},
                                  {0.2801, 0},
                                  {0.32015, 1},
                                  {0.27985, 1},
                                  {0.25, 1},
                                  {0.35, 1}})
    for (const bool is_solid : {false, true}) {
      GearSet gear = is_solid ? solid() : hollow();
      gear.material["steel"].poissons_ratio = nu;
      EXPECT_EQ(test::note_codes(output_shaft_compliance(gear).notes), Codes{});  // torsion alone
      gear.load.axial_force = 10;
      const MemberCompliance member = output_shaft_compliance(gear);
      EXPECT_EQ(test::note_codes(member.notes),
                noted == 1 ? Codes{"crack.poissons_ratio"} : Codes{})
          << nu;
      for (const Note& note : member.notes) EXPECT_EQ(note.equation, is_solid ? "FR-13" : "FR-15");
    }
}

TEST(OutputShaftCrack, IdentityPoissonsRatioEntersTensionOnly) {
  GearSet gear = hollow();
  const auto at_03 = entries(first_shaft_crack(gear).positive);
  gear.material["steel"].poissons_ratio = 0.25;
  const auto at_025 = entries(first_shaft_crack(gear).positive);
  test::expect_relative(at_025[0] / at_03[0], (1 - 0.25 * 0.25) / (1 - 0.3 * 0.3), 1e-12);
  test::expect_relative(at_025[2], at_03[2], 1e-12);
}

/// A hollow shaft whose lengths have exact ratios.  Its outer radius is 1/4 and not 1, because
/// division and multiplication by 1 could not be distinguished.
GearSet of_ratios(double radius_ratio, double depth_ratio) {
  GearSet gear = hollow();
  gear.output_shaft->outer_diameter = 0.5;
  gear.output_shaft->inner_diameter = radius_ratio / 2;
  gear.output_shaft->length = 5.0;
  std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = depth_ratio * (1 - radius_ratio) / 4;
  return gear;
}

TEST(OutputShaftCrack, LimitDepthOfTheTable) {
  EXPECT_TRUE(output_shaft_compliance(of_ratios(0.5, 0.8)).unusable_because.empty());
  const std::string reason = output_shaft_compliance(of_ratios(0.5, 0.81)).unusable_because;
  EXPECT_TRUE(reason.starts_with("output_shaft.crack[0]: a/t = 0.81 ")) << reason;
  EXPECT_TRUE(reason.ends_with("a/t <= 0.8")) << reason;
  EXPECT_FALSE(output_shaft_compliance(of_ratios(0.5, 0.8 * (1 + 1e-11))).unusable_because.empty());
  // A depth of 0.8 of the wall given in millimetres must count as 0.8 in spite of rounding.
  for (int outer = 20; outer <= 80; outer += 3)
    for (int inner = 2; inner < outer; inner += 5) {
      GearSet gear = hollow();
      gear.output_shaft->outer_diameter = outer * mm;
      gear.output_shaft->inner_diameter = inner * mm;
      std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth = 0.4 * (outer - inner) * mm;
      EXPECT_TRUE(output_shaft_compliance(gear).unusable_because.empty()) << outer << ' ' << inner;
    }
  // A solid shaft does not have this limit.
  EXPECT_TRUE(output_shaft_compliance(solid(29.9 * mm)).unusable_because.empty());
}

TEST(OutputShaftCrack, LimitRadiusRatioOfTheTable) {
  for (const auto& [radius_ratio, noted] :
       {std::pair{0.5, 0}, {0.95, 0}, {0.95 * (1 + 1e-11), 1}, {0.97, 1}}) {
    GearSet gear = of_ratios(radius_ratio, 0.3);
    EXPECT_EQ(test::count_notes(output_shaft_compliance(gear).notes, "crack.tension_range"), 0);
    gear.load.axial_force = 10;
    EXPECT_EQ(test::count_notes(output_shaft_compliance(gear).notes, "crack.tension_range",
                                "output_shaft.crack[0]"),
              noted)
        << radius_ratio;
    EXPECT_EQ(uncertainties(gear),
              noted == 1 ? (std::array{1.0, 1.0, 0.002}) : (std::array{0.005, 0.005, 0.002}));
    // Growth takes the moment of the duty.
    gear.load.axial_force = 0;
    gear.duty.emplace().block.emplace_back().bending_moment = 5;
    EXPECT_EQ(test::count_notes(output_shaft_compliance(gear).notes, "crack.tension_range"), noted);
  }
}

TEST(OutputShaftCrack, BehaviourAccuraciesOfEachCase) {
  EXPECT_EQ(uncertainties(hollow()), (std::array{0.005, 0.005, 0.002}));
  EXPECT_EQ(uncertainties(solid()), (std::array{0.005, 0.005, 0.002}));
  EXPECT_EQ(uncertainties(solid(1 * mm, AnnularSolution::tada)), (std::array{0.055, 0.055, 0.055}));
  EXPECT_EQ(*first_shaft_crack(hollow()).positive.at_output.relative_uncertainty, 0.002);
  // The uncertainty of K is half, because compliance is proportional to its square; for the slope
  // of the table in tension it is larger.
  EXPECT_EQ(*first_shaft_crack(hollow()).deepest->K_III.relative_uncertainty, 0.0015);
  EXPECT_EQ(*first_shaft_crack(hollow()).deepest->K_I.relative_uncertainty, 0.015);
  EXPECT_EQ(*first_shaft_crack(solid()).deepest->K_I.relative_uncertainty, 0.0025);
  EXPECT_EQ(
      *first_shaft_crack(solid(1 * mm, AnnularSolution::tada)).deepest->K_I.relative_uncertainty,
      0.0275);

  using Basis = std::vector<std::pair<std::string, double>>;
  const auto basis = [](const GearSet& gear) {
    Basis result;
    for (const AccuracyBasis& a : output_shaft_compliance(gear).accuracies) {
      EXPECT_FALSE(a.source.empty());
      result.emplace_back(a.path, a.relative_uncertainty);
    }
    return result;
  };
  GearSet gear = hollow();
  EXPECT_EQ(basis(gear), (Basis{{"output_shaft", 0.01}, {"output_shaft.crack[0]", 0.002}}));
  gear.load.axial_force = 10;
  EXPECT_EQ(basis(gear), (Basis{{"output_shaft", 0.01},
                                {"output_shaft.crack[0]", 0.002},
                                {"output_shaft.crack[0]", 0.005}}));
  gear.output_shaft->crack.clear();
  EXPECT_EQ(basis(gear), (Basis{{"output_shaft", 0.01}}));
}

TEST(OutputShaft, BehaviourEquationsOfEachCase) {
  using Tags = std::vector<std::string>;
  GearSet gear = hollow();
  EXPECT_EQ(output_shaft_compliance(gear).equations,
            (Tags{"ST-2", "FR-2", "FR-18", "FR-14", "FR-15", "FR-16"}));
  EXPECT_EQ(output_shaft_compliance(solid()).equations,
            (Tags{"ST-2", "FR-2", "FR-18", "FR-12", "FR-13"}));
  gear.output_shaft->crack.clear();
  EXPECT_EQ(output_shaft_compliance(gear).equations, Tags{"ST-2"});
}

TEST(OutputShaft, ConvergenceIsDemanded) {
  const StiffnessOptions impossible{.quadrature = {.relative_tolerance = 1e-30, .max_pieces = 1}};
  const MemberCompliance member = output_shaft_compliance(solid(), impossible);
  EXPECT_NE(member.unusable_because.find("output_shaft.crack[0]"), std::string::npos);
  EXPECT_NE(member.unusable_because.find("did not converge"), std::string::npos);
  EXPECT_TRUE(output_shaft_compliance(solid()).unusable_because.empty());
}

TEST(OutputShaft, ScalingSoundAndCracked) {
  const auto expect = [](std::string_view unit, bool is_solid, const auto& result_of) {
    test::expect_dimensionally_consistent(
        unit,
        [&](double a, double D, double d, double L, double E, double G, double T, double P) {
          GearSet gear = hollow(a);
          gear.output_shaft->outer_diameter = D;
          gear.output_shaft->inner_diameter = is_solid ? 0.0 : d;
          gear.output_shaft->length = L;
          gear.material["steel"].youngs_modulus = E;
          gear.material["steel"].shear_modulus = G;
          gear.material["steel"].yield_strength = E / 300;
          gear.load = {.torque = T, .axial_force = P};
          return result_of(gear);
        },
        Arg{1e-3, "m"}, Arg{0.07, "m"}, Arg{0.045, "m"}, Arg{0.3, "m"}, Arg{2.1e11, "Pa"},
        Arg{8e10, "Pa"}, Arg{100, "N*m"}, Arg{500, "N"});
  };
  for (const bool is_solid : {false, true}) {
    expect("rad/(N*m)", is_solid,
           [](const GearSet& gear) { return output_shaft_compliance(gear).intact; });
    expect("m/N", is_solid,
           [](const GearSet& gear) { return entries(first_shaft_crack(gear).positive)[0]; });
    expect("rad/(N*m)", is_solid,
           [](const GearSet& gear) { return entries(first_shaft_crack(gear).positive)[2]; });
    expect("Pa*m^0.5", is_solid,
           [](const GearSet& gear) { return first_shaft_crack(gear).deepest->K_I.value; });
    expect("Pa*m^0.5", is_solid,
           [](const GearSet& gear) { return first_shaft_crack(gear).deepest->K_III.value; });
  }
}

}  // namespace
}  // namespace strainwave
