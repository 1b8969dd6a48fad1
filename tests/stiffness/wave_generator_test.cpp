// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "stiffness/members_support.hpp"
#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"
#include "support/reference.hpp"
#include "support/scaling.hpp"
#include "support/steel.hpp"

namespace strainwave {
namespace {

using test::Codes;
using test::kComplianceNmm;
using test::kE;
using test::kPlaneStrain;

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;
using test::Arg;

test::Reference race_digits(double value, std::string_view unit) {
  return test::corrected_reference(value, unit, 1e-7,
                                   "eight digits printed, and a/c to eight digits");
}

GearSet sound_wave_generator() {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  return gear;
}

RaceSurfaceCrack& surface_crack(GearSet& gear) {
  return std::get<RaceSurfaceCrack>(gear.wave_generator->crack.at(0));
}

/// The article's drive with another stress driver on its race crack.
GearSet driven_by(StressDriver driver, double depth = 0.1 * mm) {
  GearSet gear = test::article_gear(depth);
  surface_crack(gear).stress_driver = driver;
  surface_crack(gear).contact_factor.reset();
  gear.wave_generator->inner_ring_width = 20 * mm;
  gear.wave_generator->inner_ring_mean_radius = 60 * mm;
  if (driver == StressDriver::given) surface_crack(gear).stress = 5 * MPa;
  return gear;
}

/// The article's drive with an edge crack through the width of the ring.
GearSet edge_crack_driven_by(StressDriver driver, double depth = 0.1 * mm) {
  GearSet gear = driven_by(driver, depth);
  const RaceSurfaceCrack surface = surface_crack(gear);
  gear.wave_generator->crack = {RaceEdgeCrack{.depth = depth,
                                              .stress_driver = driver,
                                              .contact_factor = surface.contact_factor,
                                              .stress = surface.stress}};
  return gear;
}

/// A ball bearing instead of a radial stiffness.
GearSet with_bearing(double balls = 1.0) {
  GearSet gear = sound_wave_generator();
  gear.wave_generator->radial_stiffness.reset();
  gear.wave_generator->contact_semi_axes.reset();
  gear.wave_generator->bearing = Bearing{.ball_diameter = 12.7 * mm,
                                         .inner_raceway_diameter = 110 * mm,
                                         .outer_raceway_diameter = 135.4 * mm,
                                         .inner_conformity = 0.52,
                                         .outer_conformity = 0.53,
                                         .loaded_balls = balls,
                                         .ball_count = {},
                                         .outer_ring = {}};
  return gear;
}

double force_per_torque(const GearSet& gear) {
  return lobe_force_per_torque(gear.drive, *gear.wave_generator);
}

/// Compliance that the first crack adds to its lobe [m/N].
double added_lobe_compliance(const GearSet& gear) {
  const double f = force_per_torque(gear);
  return wave_generator_compliance(gear).cracks.at(0).positive.at_output.value / (f * f);
}

/// Half of the ring's width, if the file gives the width [m].
std::optional<double> half_ring_width(const GearSet& gear) {
  const auto& width = gear.wave_generator->inner_ring_width;
  return width ? std::optional(*width / 2) : std::nullopt;
}

/// The same by the fracture module alone, for a stress per lobe force.
double surface_lobe_compliance(const GearSet& gear, double unit_stress,
                               sif::StripLoading loading = sif::StripLoading::tension) {
  const RaceSurfaceCrack& crack = std::get<RaceSurfaceCrack>(gear.wave_generator->crack.at(0));
  const sif::SurfaceCrack<1> model({.depth = crack.depth,
                                    .aspect_ratio = crack.aspect_ratio,
                                    .thickness = *gear.wave_generator->inner_ring_thickness,
                                    .half_width = half_ring_width(gear),
                                    .normal_stress = {unit_stress},
                                    .loading = loading});
  return added_compliance(model, {.opening = kPlaneStrain, .shear = 1.0}).matrix(0, 0);
}

double edge_lobe_compliance(const GearSet& gear, double unit_stress, sif::StripLoading loading) {
  const RaceEdgeCrack& crack = std::get<RaceEdgeCrack>(gear.wave_generator->crack.at(0));
  const sif::EdgeCrack model{.depth = crack.depth,
                             .thickness = *gear.wave_generator->inner_ring_thickness,
                             .width = *gear.wave_generator->inner_ring_width,
                             .unit_stress = unit_stress,
                             .loading = loading};
  return added_compliance(model, {.opening = kPlaneStrain, .shear = 1.0}).matrix(0, 0);
}

// --- (ST-5): the force on a lobe
// ----------------------------------------------------------------------

TEST(LobeForce, ReferenceArticle) {
  const GearSet gear = test::article_gear();
  test::expect_reference(force_per_torque(gear) * 100,
                         {.value = 251.5625,
                          .unit = "N",
                          .relative_tolerance = 1e-15,
                          .source = "1.15 * 0.35 * 2 * 100 N*m/(2 * 160 mm), exact",
                          .tolerance_is = "rounding"});
}

TEST(LobeForce, IdentityProportions) {
  GearSet gear = test::article_gear();
  const double plain = force_per_torque(gear);
  gear.drive.wave_number = 3;
  test::expect_relative(force_per_torque(gear), plain * 2 / 3, 1e-15);
  gear.wave_generator->load_factor = 1.0;
  test::expect_relative(force_per_torque(gear), plain * 2 / 3 / 1.15, 1e-15);
  gear.wave_generator->force_transmission_coefficient = 0.7;
  test::expect_relative(force_per_torque(gear), plain * 4 / 3 / 1.15, 1e-15);
}

TEST(LobeForce, ScalingIsOneOverLength) {
  test::expect_dimensionally_consistent(
      "1/m",
      [](double d, double k_r) {
        GearSet gear = test::article_gear();
        gear.drive.pitch_diameter = d;
        gear.wave_generator->force_transmission_coefficient = k_r;
        return force_per_torque(gear);
      },
      Arg{0.16, "m"}, Arg{0.35, "1"});
}

// --- (ST-6), (ST-7): conversion to the output
// ------------------------------------------------------------

TEST(WaveGenerator, ReferenceSound) {
  GearSet gear = sound_wave_generator();
  const auto intact = [&] { return wave_generator_compliance(gear).intact / kComplianceNmm; };
  test::expect_reference(intact(), race_digits(1.0547282e-10, "rad/(N*mm)"));
  gear.wave_generator->load_factor = 1.0;
  test::expect_reference(intact(), race_digits(7.9752604e-11, "rad/(N*mm)"));
  gear.wave_generator->conversion = Conversion::cam;
  test::expect_reference(intact(), race_digits(1.7896443e-10, "rad/(N*mm)"));
  gear.wave_generator->load_factor = 1.15;  // which the article's conversion does not contain
  test::expect_reference(intact(), race_digits(1.7896443e-10, "rad/(N*mm)"));
}

TEST(WaveGenerator, IdentityMaxwellBetti) {
  // Reciprocity would make both conversions equal; they differ by pi/(U^2 c_F^2 k_r) for two lobes
  // where w_0 i = d_1/2 (U^2 replaces 4 for general U).
  for (const int U : {2, 3}) {
    GearSet gear = sound_wave_generator();
    gear.drive.wave_number = U;
    ASSERT_DOUBLE_EQ(gear.drive.radial_displacement * gear.drive.ratio,
                     gear.drive.pitch_diameter / 2);
    const double energy = wave_generator_compliance(gear).intact;
    gear.wave_generator->conversion = Conversion::cam;
    const double cam = wave_generator_compliance(gear).intact;
    test::expect_reference(cam / energy, {.value = 1.6967824,
                                          .unit = "1",
                                          .relative_tolerance = 3e-8,
                                          .source = "pi/(4 * 1.15^2 * 0.35)",
                                          .tolerance_is = "eight digits printed"});
    test::expect_relative(cam / energy, pi / (4 * 1.15 * 1.15 * 0.35), 1e-12);
  }
}

TEST(WaveGenerator, IdentityEnergyOfTheLobes) {
  // 1/2 lambda T^2 = U 1/2 C F^2, input locked.
  for (const int U : {1, 2, 3, 4}) {
    GearSet gear = sound_wave_generator();
    gear.drive.wave_number = U;
    const double F = force_per_torque(gear);
    test::expect_relative(wave_generator_compliance(gear).intact, U * F * F / 1.2e8, 1e-14);
  }
}

TEST(WaveGenerator, IdentityCamProportions) {
  // k_r pi/(2 d_1 U w_0 i) per unit of radial compliance; the share of a crack has the same factor.
  GearSet gear = test::article_gear(1 * mm);
  const double lobe = added_lobe_compliance(gear);
  gear.wave_generator->conversion = Conversion::cam;
  gear.drive = {
      .ratio = 80, .wave_number = 3, .pitch_diameter = 0.1, .radial_displacement = 0.3 * mm};
  gear.wave_generator->force_transmission_coefficient = 0.4;
  const double factor = 0.4 * pi / (2 * 0.1 * 3 * 0.3 * mm * 80);
  const MemberCompliance member = wave_generator_compliance(gear);
  test::expect_relative(member.intact, factor / 1.2e8, 1e-14);
  test::expect_relative(member.cracks.at(0).positive.at_output.value, factor * lobe, 1e-10);
}

TEST(WaveGenerator, IdentityOneCrackLoadsOneLobe) {
  GearSet gear = test::article_gear(1 * mm);
  for (const int U : {2, 4}) {
    gear.drive.wave_number = U;
    const double f = force_per_torque(gear);
    const double unit_stress = 0.45 / 2 * peak_pressure(1, 5 * mm, 2 * mm);
    test::expect_relative(wave_generator_compliance(gear).cracks.at(0).positive.at_output.value,
                          f * f * surface_lobe_compliance(gear, unit_stress), 1e-10);
  }
}

// --- (ST-8) to (ST-10): the lobe's compliance
// ---------------------------------------------------------------

TEST(WaveGenerator, IdentityDisplacementsOverTheLobeForce) {
  const GearSet stiff = sound_wave_generator();
  const double F = 251.5625;
  const double total = F / 1.2e8;
  for (const double torque : {100.0, -100.0}) {
    GearSet gear = stiff;
    gear.load.torque = torque;
    gear.wave_generator->radial_stiffness.reset();
    gear.wave_generator->displacements =
        LobeDisplacements{.bearing = 0.5 * total, .cam = 0.3 * total, .shaft = 0.2 * total};
    const MemberCompliance member = wave_generator_compliance(gear);
    test::expect_relative(member.intact, wave_generator_compliance(stiff).intact, 1e-14);
    // The lobe force, 15 %, enters once: squared in the conversion, inverse in the compliance.
    EXPECT_EQ(member.relative_uncertainty, 0.15);
    EXPECT_TRUE(test::uses_equation(member.equations, "ST-8"));
  }
  EXPECT_FALSE(test::uses_equation(wave_generator_compliance(stiff).equations, "ST-8"));
}

TEST(WaveGenerator, IdentityShaftBendingNeedsAnUnbalancedForce) {
  GearSet gear = sound_wave_generator();
  gear.wave_generator->radial_stiffness.reset();
  gear.wave_generator->displacements =
      LobeDisplacements{.bearing = 1e-6, .cam = 0.0, .shaft = 1e-7};
  for (const auto& [U, noted] : {std::pair{1, false}, {2, true}, {3, true}, {4, true}}) {
    gear.drive.wave_number = U;
    EXPECT_EQ(
        test::count_notes(wave_generator_compliance(gear).notes, "wave_generator.shaft_bending",
                          "wave_generator.displacements.shaft"),
        noted)
        << U;
  }
  gear.wave_generator->displacements->shaft = 0.0;
  EXPECT_EQ(
      test::count_notes(wave_generator_compliance(gear).notes, "wave_generator.shaft_bending"), 0);
}

TEST(WaveGenerator, CrosscheckBearingByItsContacts) {
  const double D = 12.7 * mm;
  for (const double balls : {1.0, 2.5}) {
    const GearSet gear = with_bearing(balls);
    const double Q = 251.5625 / balls;
    const HertzContact inner =
        hertz_contact({.curvature_sums = {2 / D - 1 / (0.52 * D), 2 / D + 2 / (110 * mm)},
                       .contact_modulus = kPlaneStrain / 2},
                      Q);
    const HertzContact outer =
        hertz_contact({.curvature_sums = {2 / D - 1 / (0.53 * D), 2 / D - 2 / (135.4 * mm)},
                       .contact_modulus = kPlaneStrain / 2},
                      Q);
    // The tangents are 2/3 of approach over force.
    const double C = 2.0 / 3 * (inner.approach + outer.approach) / Q / balls;
    const double f = force_per_torque(gear);
    const MemberCompliance member = wave_generator_compliance(gear);
    test::expect_relative(member.intact, 2 * f * f * C, 1e-13);
    // The result contains the lobe force to the power 5/3.
    test::expect_relative(member.relative_uncertainty, std::hypot(0.15 * 5 / 3, 0.30), 1e-14);
    EXPECT_EQ(test::note_codes(member.notes), Codes{"wave_generator.hertz"});
    // The note names the pressure on the inner race, in MPa.
    const double MPa_inner = inner.peak_pressure / MPa;
    char text[64];
    std::snprintf(text, sizeof text, "peak pressure on the inner race is %.3g MPa", MPa_inner);
    EXPECT_NE(member.notes.at(0).text.find(text), std::string::npos) << member.notes.at(0).text;
    for (const char* const tag : {"ST-9", "CO-1", "CO-2", "CO-3", "CO-4"})
      EXPECT_TRUE(test::uses_equation(member.equations, tag)) << tag;
    EXPECT_FALSE(test::uses_equation(member.equations, "ST-10"));
  }
}

TEST(WaveGenerator, IdentityHertzStiffensWithTheCubeRootOfTheTorque) {
  GearSet gear = with_bearing();
  const double at_100 = wave_generator_compliance(gear).intact;
  gear.load.torque = 800;
  test::expect_relative(wave_generator_compliance(gear).intact, at_100 / 2, 1e-13);
  gear.load.torque = -800;
  test::expect_relative(wave_generator_compliance(gear).intact, at_100 / 2, 1e-13);
}

TEST(WaveGenerator, IdentityOuterRingInSeries) {
  for (const int U : {2, 3}) {
    GearSet gear = with_bearing(3);
    gear.drive.wave_number = U;
    const double balls_only = wave_generator_compliance(gear).intact;
    gear.wave_generator->bearing->outer_ring =
        BearingRing{.mean_radius = 70 * mm, .thickness = 4 * mm, .width = 20 * mm};
    const MemberCompliance member = wave_generator_compliance(gear);
    const double EI = kE * 20 * mm * std::pow(4 * mm, 3) / 12;
    const double f = force_per_torque(gear);
    test::expect_relative(member.intact - balls_only, U * f * f * ring_compliance(U, 70 * mm, EI),
                          1e-12);
    EXPECT_TRUE(test::uses_equation(member.equations, "ST-10"));
  }
}

// --- (ST-12), (CO-7), (ST-13): what stresses a race crack
// ------------------------------------------------------

TEST(RaceCrack, ReferenceLobeCompliance) {
  struct Case {
    double depth, half_beta, edge, ring;  // [mm], [mm/N]
  };
  for (const Case& c : {Case{0.1, 3.9835790e-12, 6.9683470e-13, 1.1331069e-10},
                        Case{1.0, 4.0167663e-9, 7.0264004e-10, 1.1425469e-7}}) {
    const double mm_per_N = mm / N;
    test::expect_reference(added_lobe_compliance(test::article_gear(c.depth * mm)) / mm_per_N,
                           race_digits(c.half_beta, "mm/N"));
    // The digits are those of a wide plate.
    GearSet edge = driven_by(StressDriver::contact_edge, c.depth * mm);
    edge.wave_generator->inner_ring_width.reset();
    test::expect_reference(added_lobe_compliance(edge) / mm_per_N, race_digits(c.edge, "mm/N"));
    // The stress of ring bending, taken as uniform over the thickness.
    GearSet uniform = driven_by(StressDriver::given, c.depth * mm);
    const double stress = 6 / pi * 60 * mm / (20 * mm * std::pow(10 * mm, 2));
    surface_crack(uniform).stress = stress * force_per_torque(uniform) * uniform.load.torque;
    uniform.wave_generator->inner_ring_width.reset();
    test::expect_reference(added_lobe_compliance(uniform) / mm_per_N, race_digits(c.ring, "mm/N"));
  }
}

TEST(RaceCrack, ReferenceAddedComplianceAtTheOutput) {
  const auto added = [](double depth) {
    return wave_generator_compliance(test::article_gear(depth))
               .cracks.at(0)
               .positive.at_output.value /
           kComplianceNmm;
  };
  test::expect_reference(added(0.1 * mm), race_digits(2.5209559e-17, "rad/(N*mm)"));
  test::expect_reference(added(1.0 * mm), race_digits(2.5419580e-14, "rad/(N*mm)"));
}

TEST(RaceCrack, IdentityContactFactorFromTheAxes) {
  // If beta is left out, it follows from b'/a' = 0.4: 0.48255370 instead of the printed 0.45.
  GearSet gear = test::article_gear(1 * mm);
  const double printed = added_lobe_compliance(gear);
  surface_crack(gear).contact_factor.reset();
  test::expect_relative(added_lobe_compliance(gear) / printed, std::pow(0.48255370 / 0.45, 2),
                        1e-7);
  EXPECT_TRUE(test::uses_equation(wave_generator_compliance(gear).equations, "CO-5"));
  surface_crack(gear).contact_factor = 0.9;
  test::expect_relative(added_lobe_compliance(gear) / printed, 4, 1e-12);
  EXPECT_FALSE(test::uses_equation(wave_generator_compliance(gear).equations, "CO-5"));
}

TEST(RaceCrack, IdentityContactOfTheBearing) {
  // Without given axes, the axes are those of one ball under its share of the lobe force.
  for (const double balls : {1.0, 4.0}) {
    GearSet gear = with_bearing(balls);
    gear.wave_generator->crack = test::article_gear(1 * mm).wave_generator->crack;
    const double D = 12.7 * mm;
    const HertzContact inner =
        hertz_contact({.curvature_sums = {2 / D - 1 / (0.52 * D), 2 / D + 2 / (110 * mm)},
                       .contact_modulus = kPlaneStrain / 2},
                      251.5625 / balls);
    const double pressure_per_force = inner.peak_pressure / 251.5625;
    test::expect_relative(added_lobe_compliance(gear),
                          surface_lobe_compliance(gear, 0.45 / 2 * pressure_per_force), 1e-10);
    surface_crack(gear).stress_driver = StressDriver::contact_edge;
    surface_crack(gear).contact_factor.reset();
    const double edge = edge_tension(inner.minor_semi_axis / inner.major_semi_axis, 0.3).minor_end;
    test::expect_relative(added_lobe_compliance(gear),
                          surface_lobe_compliance(gear, edge * pressure_per_force), 1e-9);
  }
}

TEST(RaceCrack, IdentityRingBendingStress) {
  // 6 M/(B t^2) with M = F R (1/theta - cot theta)/2; for two lobes F R/pi.
  for (const auto& [U, factor] : {std::pair{2, 1 / pi}, {3, (3 / pi - 1 / std::sqrt(3.0)) / 2}}) {
    GearSet gear = driven_by(StressDriver::ring_bending, 1 * mm);
    gear.drive.wave_number = U;
    const double stress = 6 * factor * 60 * mm / (20 * mm * std::pow(10 * mm, 2));
    test::expect_relative(added_lobe_compliance(gear),
                          surface_lobe_compliance(gear, stress, sif::StripLoading::bending), 1e-10);
    EXPECT_TRUE(test::uses_equation(wave_generator_compliance(gear).equations, "SP-3"));
  }
}

/// Compliance of a surface crack of the length c/b of the ring over that of the edge crack of its
/// depth [-].
double share_of_the_edge_crack(StressDriver driver, double depth_ratio, double aspect_ratio,
                               double c_b) {
  const double depth = depth_ratio * 10 * mm;
  GearSet surface = driven_by(driver, depth);
  GearSet edge = edge_crack_driven_by(driver, depth);
  surface_crack(surface).aspect_ratio = aspect_ratio;
  for (GearSet* const gear : {&surface, &edge})
    gear->wave_generator->inner_ring_width = 2 * depth / aspect_ratio / c_b;
  return added_lobe_compliance(surface) / added_lobe_compliance(edge);
}

TEST(RaceCrack, LimitSurfaceCrackStifferThanTheEdgeCrackOfItsDepth) {
  // A surface crack leaves more of the ring whole than an edge crack of its depth over the whole
  // width.  The bounds are those of the manual, (FR-4): of every shape in the range of the width
  // factor, and of every length in the range of the fit.
  for (const StressDriver driver : {StressDriver::orthogonal_shear, StressDriver::contact_edge,
                                    StressDriver::ring_bending, StressDriver::given})
    for (const double depth : {0.01, 0.1, 0.3, 0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9}) {
      for (const double aspect_ratio : {1e-3, 0.01, 0.03, 0.1, 0.3, 1.0})
        EXPECT_LT(share_of_the_edge_crack(driver, depth, aspect_ratio, 0.5), 0.6)
            << enum_name(driver) << ", a/c = " << aspect_ratio << ", a/t = " << depth;
      for (const double aspect_ratio : {0.2, 0.3, 0.5, 1.0})
        EXPECT_LT(share_of_the_edge_crack(driver, depth, aspect_ratio, 1.0), 0.7)
            << enum_name(driver) << ", a/c = " << aspect_ratio << ", a/t = " << depth;
    }
}

/// A ring 11 mm wide and 3 mm thick with a crack half as deep.
GearSet narrow_ring(double c_b) {
  GearSet gear = driven_by(StressDriver::given, 1.5 * mm);
  gear.wave_generator->inner_ring_thickness = 3 * mm;
  gear.wave_generator->inner_ring_width = 11 * mm;
  surface_crack(gear).aspect_ratio = 1.5 / (c_b * 5.5);
  return gear;
}

TEST(RaceCrack, ReferenceWidthOfTheRing) {
  // (SP-1): f_w = sqrt(sec(pi/2 c/b sqrt(1/2))), by hand.
  for (const auto& [c_b, f_w] : {std::pair{0.4, 1.05239}, {0.5, 1.08484}, {0.975, 1.46064}}) {
    const GearSet ring = narrow_ring(c_b);
    GearSet wide = ring;
    wide.wave_generator->inner_ring_width.reset();
    const MemberCompliance member = wave_generator_compliance(ring);
    const CrackReport& crack = member.cracks.at(0);
    const MemberCompliance in_plate = wave_generator_compliance(wide);
    const CrackReport& other = in_plate.cracks.at(0);
    EXPECT_NEAR(crack.deepest->K_I.value / other.deepest->K_I.value, f_w, 1e-4);
    EXPECT_NEAR(crack.largest->K_I.value / other.largest->K_I.value, f_w, 1e-4);
    EXPECT_TRUE(test::uses_equation(member.equations, "SP-1"));
    EXPECT_FALSE(test::uses_equation(in_plate.equations, "SP-1"));
    // The compliance is the integral of K^2 over a growing crack: its factor is below f_w^2.
    const double softer = added_lobe_compliance(ring) / added_lobe_compliance(wide);
    EXPECT_GT(softer, 1.0);
    EXPECT_LT(softer, f_w * f_w);
    // It contains the square of the factor to first order: dC/da is K^2 of the crack.
    const auto rate = [](GearSet gear) {
      const double h = 1e-4;
      const double depth = 1.5 * mm;
      surface_crack(gear).depth = depth * (1 + h);
      const double more = added_lobe_compliance(gear);
      surface_crack(gear).depth = depth * (1 - h);
      return (more - added_lobe_compliance(gear)) / (2 * h * depth);
    };
    EXPECT_NEAR(rate(ring) / rate(wide), f_w * f_w, 2e-4 * f_w * f_w) << c_b;
  }
}

TEST(RaceCrack, BehaviourLongerThanHalfOfTheRing) {
  const auto wide = [](const GearSet& gear) {
    return test::count_notes(wave_generator_compliance(gear).notes, "crack.wide",
                             "wave_generator.crack[0]");
  };
  const auto uncertainty = [](const GearSet& gear) {
    const MemberCompliance member = wave_generator_compliance(gear);
    const CrackReport& crack = member.cracks.at(0);
    return std::pair{*crack.positive.at_output.relative_uncertainty, *crack.intensity_uncertainty};
  };
  EXPECT_EQ(wide(narrow_ring(0.5)), 0);
  EXPECT_EQ(wide(narrow_ring(0.5 + 1e-9)), 1);
  GearSet unknown = narrow_ring(0.975);
  unknown.wave_generator->inner_ring_width.reset();
  EXPECT_EQ(wide(unknown), 0);
  // f_w^2 - 1 of the compliance beside what a crack within the range has, half of it of K.
  const auto inside = uncertainty(narrow_ring(0.5));
  const auto outside = uncertainty(narrow_ring(0.975));
  const double beyond = 1 / std::cos(pi / 2 * 0.975 * std::sqrt(0.5)) - 1;
  EXPECT_NEAR(outside.first, std::hypot(inside.first, beyond), 1e-9);
  EXPECT_NEAR(outside.second, std::hypot(inside.second, beyond / 2), 1e-9);
  for (const Note& note : wave_generator_compliance(narrow_ring(0.975)).notes) {
    if (note.code != "crack.wide") continue;
    EXPECT_EQ(note.severity, Severity::care);
    EXPECT_FALSE(note.next_step.empty());
    EXPECT_NE(note.text.find("1.46 here"), std::string::npos) << note.text;
  }
}

TEST(RaceCrack, BehaviourNearTheFullThicknessOfTheRing) {
  // The fit of the surface crack ends at 0.8; beyond 0.9 neither crack has a usable answer.
  for (const auto& [depth, extrapolated, usable] :
       {std::tuple{8.0, 0, true}, {8.01, 1, true}, {9.0, 1, true}, {9.01, 1, false}}) {
    GearSet surface = driven_by(StressDriver::given, depth * mm);
    surface.wave_generator->inner_ring_width = 100 * mm;
    GearSet edge = edge_crack_driven_by(StressDriver::given, depth * mm);
    for (const auto& [gear, code] :
         {std::pair{&surface, "crack.surface_range"}, {&edge, "crack.edge_range"}}) {
      const MemberCompliance member = wave_generator_compliance(*gear);
      EXPECT_EQ(test::count_notes(member.notes, code, "wave_generator.crack[0]"), extrapolated)
          << depth;
      EXPECT_EQ(member.unusable_because.empty(), usable) << depth;
      EXPECT_EQ(torsional_stiffness(*gear).usable(), usable) << depth;
      EXPECT_EQ(series_compliance<double>(*gear).usable, usable) << depth;
    }
  }
}

TEST(RaceCrack, IdentityGivenStressIsAtTheGivenTorque) {
  for (const double torque : {100.0, -100.0, 50.0}) {
    GearSet gear = driven_by(StressDriver::given, 1 * mm);
    gear.load.torque = torque;
    const double force = force_per_torque(gear) * std::abs(torque);
    test::expect_relative(added_lobe_compliance(gear),
                          surface_lobe_compliance(gear, 5 * MPa / force), 1e-10);
    // At the load, the stress is the given one.
    const double K = wave_generator_compliance(gear).cracks.at(0).deepest->K_I.value;
    const double c_b = 1 / 0.52147039 / 10;
    test::expect_relative(K,
                          5 * MPa * std::sqrt(pi * 1 * mm) *
                              sif::NewmanRaju(0.52147039).factor(0.1, pi / 2) /
                              std::sqrt(std::cos(pi / 2 * c_b * std::sqrt(0.1))),
                          1e-14);
  }
}

TEST(RaceCrack, CrosscheckEdgeCrackByTheFractureModule) {
  struct Case {
    StressDriver driver;
    double unit_stress;
    sif::StripLoading loading;
  };
  const double pressure = peak_pressure(1, 5 * mm, 2 * mm);
  for (const Case& c :
       {Case{StressDriver::orthogonal_shear, orthogonal_shear_factor(0.4) / 2 * pressure,
             sif::StripLoading::tension},
        Case{StressDriver::contact_edge, edge_tension(0.4, 0.3).minor_end * pressure,
             sif::StripLoading::tension},
        Case{StressDriver::ring_bending, 6 / pi * 60 * mm / (20 * mm * 1e-4),
             sif::StripLoading::bending},
        Case{StressDriver::given, 5 * MPa / 251.5625, sif::StripLoading::tension}}) {
    const GearSet gear = edge_crack_driven_by(c.driver, 2 * mm);
    test::expect_relative(added_lobe_compliance(gear),
                          edge_lobe_compliance(gear, c.unit_stress, c.loading), 1e-10);
    EXPECT_EQ(wave_generator_compliance(gear).cracks.at(0).kind, "edge");
  }
}

TEST(RaceCrack, LimitPowersOfTheDepth) {
  // Surface crack a^3, edge crack a^2; the next terms are of order (a/t)^2 and a/t.
  const auto surface = [](double a) {
    return added_lobe_compliance(test::article_gear(a)) / std::pow(a, 3);
  };
  EXPECT_NEAR(surface(1e-9) / surface(1e-5), 1, 1e-4);
  const auto edge = [](double a) {
    return added_lobe_compliance(edge_crack_driven_by(StressDriver::given, a)) / (a * a);
  };
  EXPECT_NEAR(edge(1e-9) / edge(1e-5), 1, 1e-2);
}

// --- closure (FR-17) and reports
// ----------------------------------------------------------------------------

TEST(RaceCrack, IdentityCompressionClosesIt) {
  for (const bool edge : {false, true}) {
    GearSet gear = edge ? edge_crack_driven_by(StressDriver::given, 1 * mm)
                        : driven_by(StressDriver::given, 1 * mm);
    std::visit(
        [](auto& crack) {
          if constexpr (requires { crack.stress; }) crack.stress = -5 * MPa;
        },
        gear.wave_generator->crack[0]);
    const MemberCompliance member = wave_generator_compliance(gear);
    const CrackReport& crack = member.cracks.at(0);
    EXPECT_EQ(crack.positive.at_output.value, 0.0);
    EXPECT_EQ(crack.negative.at_output.value, 0.0);
    EXPECT_EQ(crack.opens_under, OpensUnder::neither);
    EXPECT_EQ(crack.deepest->K_I.value, 0.0);
    EXPECT_EQ(test::count_notes(member.notes, "crack.closed", "wave_generator.crack[0]"), 1);
  }
  // Zero stress neither opens nor closes the crack.
  GearSet gear = driven_by(StressDriver::given);
  surface_crack(gear).stress = 0.0;
  const MemberCompliance member = wave_generator_compliance(gear);
  EXPECT_EQ(member.cracks.at(0).opens_under, OpensUnder::neither);
  EXPECT_EQ(member.cracks.at(0).positive.at_output.value, 0.0);
  EXPECT_EQ(test::count_notes(member.notes, "crack.closed"), 0);
  EXPECT_TRUE(member.unusable_because.empty());
}

TEST(RaceCrack, IdentityBothSensesOfTorqueAreTheSame) {
  for (const double torque : {100.0, -100.0}) {
    GearSet gear = test::article_gear(1 * mm);
    gear.load.torque = torque;
    const CrackReport crack = wave_generator_compliance(gear).cracks.at(0);
    EXPECT_EQ(crack.opens_under, OpensUnder::both);
    EXPECT_EQ(crack.positive.at_output.value, crack.negative.at_output.value);
    test::expect_relative(
        crack.positive.at_output.value,
        wave_generator_compliance(test::article_gear(1 * mm)).cracks.at(0).positive.at_output.value,
        1e-14);
    EXPECT_GT(crack.deepest->K_I.value, 0.0);
    EXPECT_FALSE(crack.positive.axial_torsion.has_value());
    EXPECT_FALSE(crack.negative.axial_torsion.has_value());
  }
}

TEST(RaceCrack, CrosscheckStressIntensitiesAlongTheFront) {
  // 33 points of half the front; the last point is the deepest.
  for (const double rho : {0.3, 0.52147039, 0.9}) {
    GearSet gear = test::article_gear(3 * mm);
    surface_crack(gear).aspect_ratio = rho;
    gear.material["steel"].fracture_toughness = 60e6;
    gear.material["steel"].yield_strength = 900 * MPa;
    const double stress = 0.45 / 2 * peak_pressure(251.5625, 5 * mm, 2 * mm);
    double largest = 0.0;
    double deepest = 0.0;
    for (int i = 0; i <= 32; ++i) {
      deepest = stress * std::sqrt(pi * 3 * mm) * sif::NewmanRaju(rho).factor(0.3, i * pi / 64);
      largest = std::max(largest, deepest);
    }
    const CrackReport crack = wave_generator_compliance(gear).cracks.at(0);
    test::expect_relative(crack.deepest->K_I.value, deepest, 1e-13);
    test::expect_relative(crack.largest->K_I.value, largest, 1e-13);
    EXPECT_EQ(crack.deepest->K_II.value, 0.0);
    EXPECT_EQ(crack.largest->K_III.value, 0.0);
    EXPECT_EQ(crack.deepest->K_I.unit, "Pa*m^0.5");
    // Uncertainties of fit, stress and lobe force.
    const double uncertainty = 2 * std::hypot(0.05, 1.0, 0.15);
    test::expect_relative(*crack.deepest->K_I.relative_uncertainty, uncertainty / 2, 1e-14);
    test::expect_relative(*crack.largest->K_I.relative_uncertainty, uncertainty / 2, 1e-14);
    test::expect_relative(*crack.intensity_uncertainty, uncertainty / 2, 1e-14);
  }
}

TEST(WaveGenerator, BehaviourNotesOfEachCase) {
  const auto codes = [](const GearSet& gear) {
    return test::note_codes(wave_generator_compliance(gear).notes);
  };
  const std::string under_lobe = "wave_generator.crack_under_lobe";
  EXPECT_EQ(codes(sound_wave_generator()), Codes{});
  EXPECT_EQ(codes(test::article_gear()), (Codes{"crack.orthogonal_shear", under_lobe}));
  EXPECT_EQ(codes(driven_by(StressDriver::contact_edge)),
            (Codes{"crack.contact_edge", under_lobe}));
  EXPECT_EQ(codes(driven_by(StressDriver::ring_bending)),
            (Codes{"crack.ring_bending", under_lobe}));
  EXPECT_EQ(codes(driven_by(StressDriver::given)), Codes{under_lobe});
  EXPECT_EQ(codes(edge_crack_driven_by(StressDriver::given)), Codes{under_lobe});

  GearSet cam = sound_wave_generator();
  cam.wave_generator->conversion = Conversion::cam;
  EXPECT_EQ(codes(cam), Codes{"wave_generator.cam_conversion"});
  EXPECT_EQ(wave_generator_compliance(cam).notes.at(0).path, "wave_generator.conversion");

  GearSet two = driven_by(StressDriver::given);
  two.wave_generator->crack.push_back(two.wave_generator->crack[0]);
  EXPECT_EQ(codes(two), (Codes{"crack.superposed", under_lobe}));
  EXPECT_EQ(wave_generator_compliance(two).cracks.at(1).path, "wave_generator.crack[1]");
}

TEST(RaceCrack, LimitRangeOfTheFit) {
  struct Case {
    double depth, aspect_ratio;
    bool inside;
    double fit;
  };
  const double bound = 0.8 * (10 * mm);
  for (const Case& c : {Case{bound, 0.5, true, 0.16}, Case{bound * (1 + 1e-11), 0.5, false, 0.20},
                        Case{1 * mm, 0.2, true, 0.10}, Case{1 * mm, 0.2 * (1 - 1e-11), false, 0.20},
                        Case{7 * mm, 0.201, true, 0.10}, Case{7.9 * mm, 0.201, true, 0.16}}) {
    GearSet gear = driven_by(StressDriver::given, c.depth);
    surface_crack(gear).aspect_ratio = c.aspect_ratio;
    gear.wave_generator->inner_ring_width = 1.0;  // so wide that the width factor is in its range
    const MemberCompliance member = wave_generator_compliance(gear);
    EXPECT_EQ(test::count_notes(member.notes, "crack.surface_range", "wave_generator.crack[0]"),
              c.inside ? 0 : 1)
        << c.depth << ' ' << c.aspect_ratio;
    // Uncertainties of the fit and of the given stress, 10 % twice; the lobe force cancels.
    test::expect_relative(*member.cracks.at(0).positive.at_output.relative_uncertainty,
                          std::hypot(c.fit, 0.20), 1e-14);
  }
}

TEST(WaveGenerator, BehaviourAccuraciesOfEachCase) {
  const auto of_crack = [](const GearSet& gear) {
    return *wave_generator_compliance(gear).cracks.at(0).positive.at_output.relative_uncertainty;
  };
  // The stress counts twice, because compliance is proportional to its square.
  test::expect_relative(of_crack(test::article_gear()), std::hypot(0.10, 2.0, 0.30), 1e-14);
  test::expect_relative(of_crack(driven_by(StressDriver::contact_edge)),
                        std::hypot(0.10, 1.0, 0.30), 1e-14);
  test::expect_relative(of_crack(driven_by(StressDriver::ring_bending)),
                        std::hypot(0.10, 0.6, 0.30), 1e-14);
  test::expect_relative(of_crack(edge_crack_driven_by(StressDriver::ring_bending)),
                        std::hypot(0.20, 0.6, 0.30), 1e-14);
  test::expect_relative(of_crack(edge_crack_driven_by(StressDriver::given)), std::hypot(0.20, 0.2),
                        1e-14);
  GearSet cam = test::article_gear();
  cam.wave_generator->conversion = Conversion::cam;
  test::expect_relative(of_crack(cam), std::hypot(0.10, 2.0, 0.70), 1e-14);
  EXPECT_EQ(wave_generator_compliance(cam).relative_uncertainty, 0.70);
  // For K, half of the fit counts, the stress once, and the lobe force once unless the stress is
  // given.
  const auto of_K = [](const GearSet& gear) {
    return *wave_generator_compliance(gear).cracks.at(0).deepest->K_I.relative_uncertainty;
  };
  test::expect_relative(of_K(test::article_gear()), std::hypot(0.05, 1.0, 0.15), 1e-14);
  test::expect_relative(of_K(edge_crack_driven_by(StressDriver::given)), std::hypot(0.10, 0.10),
                        1e-14);

  // Each is recorded with its basis.
  const auto basis = [](const GearSet& gear) {
    std::vector<std::pair<std::string, double>> result;
    for (const AccuracyBasis& a : wave_generator_compliance(gear).accuracies) {
      EXPECT_FALSE(a.source.empty());
      result.emplace_back(a.path, a.relative_uncertainty);
    }
    return result;
  };
  using Basis = std::vector<std::pair<std::string, double>>;
  const std::string path = "wave_generator.crack[0]";
  EXPECT_EQ(basis(sound_wave_generator()), (Basis{{"wave_generator", 0.30}}));
  EXPECT_EQ(basis(with_bearing()),
            (Basis{{"wave_generator", 0.25}, {"wave_generator.bearing", 0.30}}));
  EXPECT_EQ(basis(test::article_gear()),
            (Basis{{"wave_generator", 0.30}, {path, 2.0}, {path, 0.30}, {path, 0.10}}));
  EXPECT_EQ(basis(edge_crack_driven_by(StressDriver::given)),
            (Basis{{"wave_generator", 0.30}, {path, 0.20}, {path, 0.20}}));

  // The cam's conversion does not contain the lobe force, so it does not cancel and counts twice.
  cam = edge_crack_driven_by(StressDriver::given);
  cam.wave_generator->conversion = Conversion::cam;
  test::expect_relative(of_crack(cam), std::hypot(std::hypot(0.20, 0.20), 0.70, 0.30), 1e-14);
  EXPECT_EQ(basis(cam),
            (Basis{{"wave_generator.conversion", 0.70}, {path, 0.20}, {path, 0.30}, {path, 0.20}}));
}

TEST(WaveGenerator, BehaviourEquationsOfEachCase) {
  using Tags = std::vector<std::string>;
  EXPECT_EQ(wave_generator_compliance(sound_wave_generator()).equations, (Tags{"ST-5", "ST-6"}));
  EXPECT_EQ(wave_generator_compliance(test::article_gear()).equations,
            (Tags{"ST-5", "ST-6", "ST-12", "CO-3", "FR-2", "FR-3", "FR-4", "FR-5", "FR-18"}));
  EXPECT_EQ(
      wave_generator_compliance(driven_by(StressDriver::contact_edge)).equations,
      (Tags{"ST-5", "ST-6", "SP-1", "CO-7", "CO-3", "FR-2", "FR-3", "FR-4", "FR-5", "FR-18"}));
  EXPECT_EQ(wave_generator_compliance(edge_crack_driven_by(StressDriver::ring_bending)).equations,
            (Tags{"ST-5", "ST-6", "ST-13", "FR-2", "FR-11", "FR-18"}));
}

TEST(WaveGenerator, ConvergenceIsDemanded) {
  const StiffnessOptions impossible{.quadrature = {.relative_tolerance = 1e-30, .max_pieces = 1}};
  const MemberCompliance member = wave_generator_compliance(test::article_gear(), impossible);
  EXPECT_NE(member.unusable_because.find("wave_generator.crack[0]"), std::string::npos);
  EXPECT_NE(member.unusable_because.find("did not converge"), std::string::npos);
  EXPECT_TRUE(wave_generator_compliance(test::article_gear()).unusable_because.empty());
}

TEST(WaveGenerator, ScalingSoundAndCracked) {
  const auto expect = [](std::string_view unit, const auto& result_of) {
    test::expect_dimensionally_consistent(
        unit,
        [&](double a, double t, double d, double w, double K, double E, double G, double T) {
          GearSet gear = test::article_gear(a);
          gear.drive.pitch_diameter = d;
          gear.drive.radial_displacement = w;
          gear.wave_generator->radial_stiffness = K;
          gear.wave_generator->inner_ring_thickness = t;
          gear.wave_generator->contact_semi_axes = {t / 2, t / 5};
          gear.material["steel"].youngs_modulus = E;
          gear.material["steel"].shear_modulus = G;
          gear.load.torque = T;
          return result_of(gear);
        },
        Arg{1e-3, "m"}, Arg{0.01, "m"}, Arg{0.16, "m"}, Arg{8e-4, "m"}, Arg{1.2e8, "N/m"},
        Arg{2.1e11, "Pa"}, Arg{8e10, "Pa"}, Arg{100, "N*m"});
  };
  expect("rad/(N*m)", [](const GearSet& gear) { return wave_generator_compliance(gear).intact; });
  expect("rad/(N*m)", [](GearSet gear) {
    gear.wave_generator->conversion = Conversion::cam;
    return wave_generator_compliance(gear).intact;
  });
  expect("rad/(N*m)", [](const GearSet& gear) {
    return wave_generator_compliance(gear).cracks.at(0).positive.at_output.value;
  });
  expect("Pa*m^0.5", [](const GearSet& gear) {
    return wave_generator_compliance(gear).cracks.at(0).deepest->K_I.value;
  });
}

// --- what acts through the contacts
// ---------------------------------------------------------------

TEST(OuterRaceCrack, IdentityAddsNothingHere) {
  GearSet gear = with_bearing(3);
  gear.wave_generator->bearing->outer_ring =
      BearingRing{.mean_radius = 70 * mm, .thickness = 4 * mm, .width = 20 * mm};
  const double sound = wave_generator_compliance(gear).intact;
  OuterRaceCrack crack;
  crack.depth = 1 * mm;
  gear.wave_generator->crack = {crack};
  const MemberCompliance member = wave_generator_compliance(gear);
  EXPECT_EQ(member.intact, sound);
  EXPECT_TRUE(member.cracks.empty());
  EXPECT_EQ(test::count_notes(member.notes, "crack.contact_path", "wave_generator.crack[0]"), 1);
  EXPECT_EQ(test::count_notes(member.notes, "wave_generator.crack_under_lobe"), 0);
  // Only the coupled drive uses the groove's share of the ring's stiffness.
  gear.wave_generator->bearing->outer_ring->groove_factor = 0.5;
  gear.wave_generator->bearing->clearance = 5e-6;
  gear.wave_generator->cam_flattening = 1.5;
  EXPECT_EQ(wave_generator_compliance(gear).intact, sound);
  EXPECT_EQ(test::count_notes(member.notes, "wave_generator.free_ring"), 1);
}

TEST(OuterRing, IdentityHeldByAllBallsItsBendingIsLeftOut) {
  // If the file gives the number of balls, the ring is held by them; a ring free between the lobes
  // would be a hundred times too soft.
  GearSet gear = with_bearing(3);
  const double without_ring = wave_generator_compliance(gear).intact;
  gear.wave_generator->bearing->outer_ring =
      BearingRing{.mean_radius = 70 * mm, .thickness = 4 * mm, .width = 20 * mm};
  EXPECT_GT(wave_generator_compliance(gear).intact, 10 * without_ring);
  gear.wave_generator->bearing->ball_count = 23;
  const MemberCompliance held = wave_generator_compliance(gear);
  EXPECT_EQ(held.intact, without_ring);
  EXPECT_EQ(test::count_notes(held.notes, "wave_generator.held_ring"), 1);
}

}  // namespace
}  // namespace strainwave
