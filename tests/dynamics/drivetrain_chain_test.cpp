// SPDX-License-Identifier: Apache-2.0
#include "strainwave/dynamics/drivetrain_chain.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

Drivetrain two_ends() { return {.motor_inertia = 1e-4, .load_inertia = 1.0}; }

double lowest(const DrivetrainChain& made, bool held) {
  std::vector<std::size_t> fixed;
  if (held) fixed.push_back(made.motor);
  const auto modes = chain_modes(made.chain, fixed);
  return held ? modes[0].frequency : modes[1].frequency;
}

TEST(DrivetrainChain, ReferenceTwoInertias) {
  // (DY-10): f_r = sqrt(K (1/J_L + 1/(i^2 J_m)))/2 pi and f_a = sqrt(K/J_L)/2 pi with K = 5e4, ten
  // digits given.  The split between mesh, body and shaft does not matter without inertias there.
  for (const DriveSprings& springs :
       {DriveSprings{.mesh = 2e-5}, DriveSprings{.mesh = 4e-6, .body = 6e-6, .shaft = 1e-5},
        DriveSprings{.body = 5e-6, .shaft = 1.5e-5}, DriveSprings{.shaft = 2e-5}}) {
    const DrivetrainChain made = drivetrain_chain(two_ends(), 100, springs, {});
    ASSERT_EQ(made.chain.inertias.size(), 2U);
    ASSERT_EQ(made.chain.springs.size(), 1U);
    test::expect_relative(made.chain.springs[0].compliance, 2e-5, 1e-14);
    test::expect_relative(lowest(made, false), 50.32921210, 1e-9);
    test::expect_relative(lowest(made, true), 35.58812717, 1e-9);
    const DrivetrainChain::Parts& parts = made.parts[0];
    EXPECT_NEAR(parts.mesh, springs.mesh / 2e-5, 1e-14);
    EXPECT_NEAR(parts.body, springs.body / 2e-5, 1e-14);
    EXPECT_NEAR(parts.shaft, springs.shaft / 2e-5, 1e-14);
  }
}

TEST(DrivetrainChain, ReferenceFourInertias) {
  // (DY-10): eigenvalues of an independent program for the same springs and inertias, all digits
  // given.
  const Drivetrain ends{.motor_inertia = 46.8e-4, .load_inertia = 20.0};
  const DrivetrainChain made =
      drivetrain_chain(ends, 100, {.mesh = 3.407e-7, .body = 2.359e-7, .shaft = 6.906e-7},
                       {.rim = 0.02, .hub = 0.03});
  const auto modes = chain_modes(made.chain);
  ASSERT_EQ(modes.size(), 4U);
  const std::array<double, 3> frequencies = {37.76907141, 1437.55305, 3438.53968};
  for (std::size_t m = 0; m < 3; ++m)
    test::expect_relative(modes[m + 1].frequency, frequencies[m], 1e-7);
}

TEST(DrivetrainChain, ReferenceFlexsplineFixed) {
  // (DY-1, DY-10): the circular spline is the output with the ratio i + 1; the springs of the
  // flexspline act there by (i/(i + 1))^2.  Closed form of two inertias.
  Drivetrain ends = two_ends();
  ends.fixed = FixedMember::flexspline;
  const double at_output = std::pow(50.0 / 51, 2) * 1.2e-5 + 3e-6;
  const DrivetrainChain made =
      drivetrain_chain(ends, 50, {.mesh = 8e-6, .body = 4e-6, .shaft = 3e-6}, {});
  test::expect_relative(lowest(made, false),
                        std::sqrt((1 + 1 / (51.0 * 51 * 1e-4)) / at_output) / (2 * pi), 1e-12);
  test::expect_relative(lowest(made, true), std::sqrt(1 / at_output) / (2 * pi), 1e-12);
  // Without twist, motor and output turn by the ratio of this arrangement.
  const std::vector<double>& twist = made.chain.springs[0].twist_of;
  test::expect_relative(-twist[made.load] / twist[made.motor],
                        signed_ratio(arrangement_of(ends.fixed), 50), 1e-12);
  EXPECT_NEAR(made.parts[0].mesh + made.parts[0].body + made.parts[0].shaft, 1.0, 1e-14);
}

TEST(DrivetrainChain, IdentityRatioOfTheTurnsInBothArrangements) {
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    Drivetrain ends = two_ends();
    ends.fixed = fixed;
    ends.wave_generator_inertia = 4e-5;
    ends.coupling_stiffness = 2000.0;
    const DrivetrainChain made = drivetrain_chain(
        ends, 80, {.mesh = 8e-6, .body = 4e-6, .shaft = 3e-6}, {.rim = 1e-5, .hub = 2e-5});
    const auto modes = chain_modes(made.chain);
    ASSERT_EQ(modes.front().frequency, 0.0);
    test::expect_relative(modes.front().shape[made.motor] / modes.front().shape[made.load],
                          signed_ratio(arrangement_of(ends.fixed), 80), 1e-9);
  }
}

TEST(DrivetrainChain, LimitOfSmallInertiasIsTheChainWithoutThem) {
  const DriveSprings springs{.mesh = 8e-6, .body = 4e-6, .shaft = 3e-6};
  const double without = lowest(drivetrain_chain(two_ends(), 100, springs, {}), false);
  double before = 1.0;
  for (const double own : {1e-3, 1e-4, 1e-5}) {
    const DrivetrainChain made =
        drivetrain_chain(two_ends(), 100, springs, {.rim = own, .hub = own});
    EXPECT_EQ(made.chain.inertias.size(), 4U);
    const double off = std::abs(lowest(made, false) / without - 1);
    EXPECT_LT(off, 0.2 * before);
    before = off;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(DrivetrainChain, IdentityAllInertiasTurnWithTheDrive) {
  // (DY-9, DY-10): without twist, the chain has the inertia of all its parts at the output.
  const GearInertias own{.rim = 0.05, .hub = 0.02, .circular_spline = 0.3, .shaft = 0.4};
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    Drivetrain ends = two_ends();
    ends.fixed = fixed;
    const DrivetrainChain made =
        drivetrain_chain(ends, 50, {.mesh = 8e-6, .body = 4e-6, .shaft = 3e-6}, own);
    const ChainMode turning = chain_modes(made.chain).front();
    ASSERT_EQ(turning.frequency, 0.0);
    double sum = 0.0;
    for (std::size_t n = 0; n < made.chain.inertias.size(); ++n)
      sum +=
          made.chain.inertias[n].inertia * std::pow(turning.shape[n] / turning.shape[made.load], 2);
    const double ratio = signed_ratio(arrangement_of(fixed), 50);
    const double parts =
        fixed == FixedMember::circular_spline ? own.rim + own.hub : own.circular_spline;
    test::expect_relative(sum, ratio * ratio * 1e-4 + 1.0 + parts + own.shaft, 1e-9);
  }
}

TEST(DrivetrainChain, LimitOfAStiffMeshIsARigidOne) {
  // (DY-10): the rim of a fixed flexspline follows the wave generator and the circular spline, so
  // none of these may be taken out in its place.  A compliance of 1e-9 of the body moves the first
  // mode by as much.
  Drivetrain ends = two_ends();
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    ends.fixed = fixed;
    const double rim = fixed == FixedMember::circular_spline ? 0.05 : 0.0;
    const GearInertias own{.rim = rim, .hub = 0.02, .circular_spline = 0.3};
    const double stiff = lowest(
        drivetrain_chain(ends, 50, {.mesh = 4e-15, .body = 4e-6, .shaft = 6e-6}, own), false);
    const DrivetrainChain made =
        drivetrain_chain(ends, 50, {.mesh = 0.0, .body = 4e-6, .shaft = 6e-6}, own);
    test::expect_relative(lowest(made, false), stiff, 1e-7);
    EXPECT_EQ(made.chain.inertias.size(), 3U);
  }
}

TEST(DrivetrainChain, LimitOfAStiffCouplingIsARigidOne) {
  Drivetrain ends = two_ends();
  ends.wave_generator_inertia = 4e-5;
  const double rigid = lowest(drivetrain_chain(ends, 100, {.mesh = 2e-5}, {}), false);
  // All of the input turns as one.
  test::expect_relative(rigid, std::sqrt(5e4 * (1 + 1 / (1e4 * 1.4e-4))) / (2 * pi), 1e-12);
  ends.coupling_stiffness = 1e9;
  const DrivetrainChain made = drivetrain_chain(ends, 100, {.mesh = 2e-5}, {});
  EXPECT_EQ(made.chain.inertias.size(), 3U);
  test::expect_relative(lowest(made, false), rigid, 1e-6);
}

TEST(DrivetrainChain, ReferenceDampingOfTheWholeDrive) {
  // (DY-5, DY-10): zeta = c omega/(2 K), whatever the split of the springs; c = 10, K = 5e4.
  Drivetrain ends = two_ends();
  ends.gear_damping = 10.0;
  for (const DriveSprings& springs :
       {DriveSprings{.mesh = 2e-5}, DriveSprings{.mesh = 4e-6, .body = 6e-6, .shaft = 1e-5}}) {
    const DrivetrainChain made = drivetrain_chain(ends, 100, springs, {});
    test::expect_relative(made.chain.springs[0].damping, 10.0, 1e-12);
    test::expect_relative(chain_modes(made.chain)[1].damping_ratio, 0.0316227766, 1e-9);
    const DrivetrainChain with_inertias =
        drivetrain_chain(ends, 100, springs, {.rim = 1e-7, .hub = 1e-7});
    test::expect_relative(chain_modes(with_inertias.chain)[1].damping_ratio, 0.0316227766, 1e-4);
  }
}

/// A cup by sections of one material, and a shaft.
GearSet cup() {
  GearSet gear;
  gear.material["steel"].density = 7850.0;
  gear.drive.pitch_diameter = 60e-3;
  Flexspline& of = gear.flexspline.emplace();
  of.material = "steel";
  of.crack_free = CrackFree::sections;
  of.rim = TubeSection{.outer_diameter = 62e-3, .wall_thickness = 0.8e-3, .length = 12e-3};
  of.barrel = TubeSection{.outer_diameter = 61e-3, .wall_thickness = 0.4e-3, .length = 20e-3};
  of.diaphragm = Diaphragm{
      .outer_diameter = 60e-3, .inner_diameter = 30e-3, .thickness = 0.5e-3, .profile = {}};
  gear.output_shaft.emplace();
  gear.output_shaft->material = "steel";
  gear.output_shaft->outer_diameter = 30e-3;
  gear.output_shaft->inner_diameter = 10e-3;
  gear.output_shaft->length = 100e-3;
  gear.circular_spline = CircularSpline{.material = "steel",
                                        .outer_diameter = 80e-3,
                                        .inner_diameter = 70e-3,
                                        .width = 12e-3,
                                        .crack = {}};
  return gear;
}

TEST(DrivetrainChain, ReferenceInertiasOfThickAndThinParts) {
  // (DY-9): m r^2 of thin rings within t/r squared, and closed forms of a disc and a shaft.
  const GearSet gear = cup();
  const auto ring = [](double mean_radius, double thickness, double length) {
    return 7850.0 * 2 * pi * mean_radius * thickness * length *
           (mean_radius * mean_radius + thickness * thickness / 4);
  };
  const double barrel = ring(30.3e-3, 0.4e-3, 20e-3);
  const double disc = 7850.0 * pi / 2 * 0.5e-3 * (std::pow(30e-3, 4) - std::pow(15e-3, 4));
  const double shaft = 7850.0 * pi / 2 * 0.1 * (std::pow(15e-3, 4) - std::pow(5e-3, 4));
  const GearInertias own = gear_inertias(gear);
  test::expect_relative(own.rim, ring(30.6e-3, 0.8e-3, 12e-3) + barrel / 2, 1e-12);
  test::expect_relative(own.hub, barrel / 2 + disc, 1e-12);
  test::expect_relative(own.shaft, shaft, 1e-12);
  test::expect_relative(own.circular_spline, ring(37.5e-3, 5e-3, 12e-3), 1e-12);
}

TEST(DrivetrainChain, ReferenceInertiaOfADiaphragmWithAProfile) {
  // (DY-9): h = h_0 r/R between two stations: 2 pi rho h_0/R times the integral of r^4.
  GearSet gear = cup();
  gear.output_shaft.reset();
  gear.flexspline->barrel->length = 1e-12;
  gear.flexspline->rim.reset();
  gear.flexspline->diaphragm->thickness = 0.6e-3;
  gear.flexspline->diaphragm->profile = {{.radius = 15e-3, .thickness = 0.3e-3}};
  const double conical =
      2 * pi * 7850.0 * 0.6e-3 / 30e-3 * (std::pow(30e-3, 5) - std::pow(15e-3, 5)) / 5;
  test::expect_relative(gear_inertias(gear).hub, conical, 1e-8);
}

// Kind: reference (DY-9).  Sections of their own materials have their own densities, and plies
// without a density of the laminate the mean of theirs.  Tolerance: rounding.
TEST(DrivetrainChain, ReferenceInertiasOfSectionsOfOtherMaterials) {
  GearSet gear = cup();
  const GearInertias steel = gear_inertias(gear);
  Material layer;
  layer.youngs_modulus = 181e9;
  layer.transverse_modulus = 10.3e9;
  layer.shear_modulus = 7.17e9;
  layer.poissons_ratio = 0.28;
  layer.density = 1600;
  gear.material["light"] = layer;
  layer.density = 2000;
  gear.material["heavy"] = layer;
  gear.material["tube"].ply = {{.material = "light", .angle = 0.0, .thickness = 1e-3},
                               {.material = "heavy", .angle = 1.0, .thickness = 3e-3}};
  gear.flexspline->barrel->material = "tube";
  GearSet half = gear;
  half.flexspline->barrel->length /= 2;
  // Half of the barrel less takes a quarter of its inertia from the rim, and as much from the hub.
  const double barrel = 4 * (gear_inertias(gear).rim - gear_inertias(half).rim);
  const double of_steel = 2 * (steel.rim - gear_inertias(gear).rim) + barrel;
  test::expect_relative(barrel / of_steel, 1900.0 / 7850.0, 1e-10);
  gear.material.at("heavy").density.reset();
  EXPECT_LT(gear_inertias(gear).rim, gear_inertias(half).rim);
  gear.material.at("tube").density = 1900;
  test::expect_relative(4 * (gear_inertias(gear).rim - gear_inertias(half).rim), barrel, 1e-10);
}

TEST(DrivetrainChain, IdentityWithoutADensityPartsHaveNoInertia) {
  GearSet gear = cup();
  gear.material["steel"].density.reset();
  const GearInertias own = gear_inertias(gear);
  EXPECT_EQ(own.rim + own.hub + own.circular_spline + own.shaft, 0.0);
}

TEST(DrivetrainChain, BehaviourTheOutputOfTheGearTurnsWithHalfOfTheShaft) {
  // The circular spline stands or turns; the other part is the output of the gear.
  const GearInertias own{.rim = 1e-5, .hub = 2e-5, .circular_spline = 3e-5, .shaft = 8e-6};
  const DriveSprings springs{.mesh = 8e-6, .body = 4e-6, .shaft = 3e-6};
  for (const FixedMember fixed : {FixedMember::circular_spline, FixedMember::flexspline}) {
    Drivetrain ends = two_ends();
    ends.fixed = fixed;
    const DrivetrainChain made = drivetrain_chain(ends, 100, springs, own);
    ASSERT_EQ(made.chain.inertias.size(), 4U);
    const ChainInertia& output = made.chain.inertias[2];
    const bool spline_stands = fixed == FixedMember::circular_spline;
    EXPECT_EQ(output.name, spline_stands ? "hub" : "circular spline");
    test::expect_relative(output.inertia, spline_stands ? 2.4e-5 : 3.4e-5, 1e-12);
    EXPECT_EQ(made.chain.inertias[1].inertia, 1e-5);
  }
}

TEST(DrivetrainChain, InputEachRuleBrokenOnce) {
  const DriveSprings good{.mesh = 2e-5};
  EXPECT_THROW((void)drivetrain_chain(two_ends(), 0.0, good, {}), InputError);
  EXPECT_THROW((void)drivetrain_chain(two_ends(), 100, {.mesh = -1e-5}, {}), InputError);
  EXPECT_THROW((void)drivetrain_chain(two_ends(), 100, {.body = -1e-5}, {}), InputError);
  EXPECT_THROW((void)drivetrain_chain(two_ends(), 100, {.shaft = std::nan("")}, {}), InputError);
  EXPECT_THROW((void)drivetrain_chain(two_ends(), 100, {}, {}), InputError);
}

}  // namespace
}  // namespace strainwave
