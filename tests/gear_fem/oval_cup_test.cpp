// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/oval_cup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

constexpr fem::Elasticity kSteelOfCup{.youngs_modulus = 206e9, .poissons_ratio = 0.3};

/// The short cup of size 25 in examples/cracked_size25.toml.
CupSection size25() {
  return {
      .barrel = {.outer_diameter = 62.499e-3, .wall_thickness = 0.453e-3, .length = 17.2e-3},
      .rim = TubeSection{.outer_diameter = 62.801e-3, .wall_thickness = 0.755e-3, .length = 9.5e-3},
      .diaphragm = Diaphragm{.outer_diameter = 62.046e-3,
                             .inner_diameter = 36.8e-3,
                             .thickness = 0.762e-3,
                             .profile = {}}};
}

CamFit fit_of_size25() { return {.radial_displacement = 0.3175e-3, .band_width = 9.2e-3}; }

constexpr double kBarrelFoot = 0.762e-3;            // z of the lower end of the barrel
constexpr double kLoadLine = 17.2e-3 + 9.5e-3 / 2;  // from there to the middle of the band

double degrees(double angle) { return angle * pi / 180; }

// Kind: closed form.  Source: inextensional bending of a cone (a cup whose bottom does not resist
// warping): w = w0 z/L cos 2 theta, v = -w0 z/(2L) sin 2 theta, axial warping r w0/(4L) cos 2
// theta. Tolerance 4 %: the bottom of the cup gives way to warping only to this extent.
TEST(OvalCup, LimitInextensionalCone) {
  CamFit fit = fit_of_size25();
  const OvalCup cup(size25(), kSteelOfCup, fit,
                    {.one_sided = false, .most_waves = 8, .large_rotations = LargeRotations::off});
  const double r = 31.023e-3;
  const double w0 = fit.radial_displacement;
  for (const double z : {8.6e-3, 12e-3}) {
    const OvalPlace middle = cup.at(r, kBarrelFoot + z);
    const double share = z / kLoadLine;
    const auto u = [&](double angle) { return cup.field(middle, degrees(angle), 0).displacement; };
    EXPECT_NEAR(u(0)[0] / (w0 * share), 1, 0.04);
    EXPECT_NEAR(u(90)[0] / (-w0 * share), 1, 0.04);
    EXPECT_NEAR(u(45)[1] / (-w0 * share / 2), 1, 0.04);
    EXPECT_NEAR(u(0)[2] / (-r * w0 / (4 * kLoadLine)), 1, 0.04);
    EXPECT_NEAR(u(45)[0], 0, 1e-6 * w0);
  }
}

// Kind: closed form.  Source: hoop bending of a wide ring, E/(1-nu^2) 3 w t/(2 r^2), and twist of
// the cone, 3/2 G t w0/(r L) sin 2 theta (two faces of opposite sign).  Tolerance 4 % in the
// middle of the rim, 3 % of the twist with the mean of the two faces.
TEST(OvalCup, LimitBendingOfTheRimAndTwistOfTheWall) {
  CamFit fit = fit_of_size25();
  const OvalCup cup(size25(), kSteelOfCup, fit,
                    {.one_sided = false, .most_waves = 8, .large_rotations = LargeRotations::off});
  const double w0 = fit.radial_displacement;
  const double r = 31.023e-3;
  const auto faces = [&](double z, double thickness, double angle, std::size_t component) {
    const double half = 0.9999 * thickness / 2;
    const double in = cup.field(cup.at(r - half, z), degrees(angle), 0).stress[component];
    const double out = cup.field(cup.at(r + half, z), degrees(angle), 0).stress[component];
    return (out - in) / 2;
  };
  const double E = kSteelOfCup.youngs_modulus;
  const double nu = kSteelOfCup.poissons_ratio;
  EXPECT_NEAR(faces(kBarrelFoot + kLoadLine, 0.755e-3, 0, 1) /
                  (E / (1 - nu * nu) * 3 * w0 * 0.755e-3 / (2 * r * r)),
              1, 0.04);
  EXPECT_NEAR(faces(kBarrelFoot + 8.6e-3, 0.453e-3, 45, 3) /
                  (1.5 * kSteelOfCup.shear_modulus() * 0.453e-3 * w0 / (r * kLoadLine)),
              1, 0.03);
}

// Kind: closed form.  Source: shear of a thin tube under torque, T r/J.  Tolerance 0.2 %.
TEST(OvalCup, LimitShearByTorque) {
  const OvalCup cup(size25(), kSteelOfCup, fit_of_size25(),
                    {.most_waves = 16, .large_rotations = LargeRotations::off});
  const double r = 31.023e-3;
  const double t = 0.453e-3;
  const double J = pi / 2 * (std::pow(r + t / 2, 4) - std::pow(r - t / 2, 4));
  const OvalPlace place = cup.at(r, kBarrelFoot + 8.6e-3);
  const auto shear = [&](double torque) { return cup.field(place, 0.3, torque).stress[3]; };
  EXPECT_NEAR((shear(48) - shear(0)) / (48 * r / J), 1, 2e-3);
  EXPECT_NEAR((shear(-48) - shear(0)) / (-48 * r / J), 1, 2e-3);
}

// (FE-52) Kind: closed form.  The band follows the cam, w_0 cos 2 theta + c w_0^2/(2R) cos 4 theta
// plus the mean that the perimeter and the clearance give.  Tolerance 2 % of the small terms: the
// mean over the width of the band against its middle.
TEST(OvalCup, ReferenceShapeOfTheCam) {
  CamFit fit = fit_of_size25();
  fit.shape = FlattenedCosine{30};
  fit.clearance = 0.02e-3;
  fit.perimeter_excess = 2 * pi * 0.05e-3;
  const OvalCup cup(size25(), kSteelOfCup, fit,
                    {.one_sided = false, .most_waves = 8, .large_rotations = LargeRotations::off});
  const double R = 62.801e-3 / 2 - 0.755e-3 / 2;
  const double bore = R - 0.755e-3 / 2;
  const OvalPlace place = cup.at(bore, kBarrelFoot + kLoadLine);
  const auto w = [&](double angle) { return cup.field(place, degrees(angle), 0).displacement[0]; };
  const double w0 = fit.radial_displacement;
  const double mean = 0.05e-3 - 0.02e-3;
  const double four = 30 * w0 * w0 / (2 * R);
  EXPECT_NEAR((w(0) + w(90)) / 2 - w(45), 2 * four, 0.02 * four);
  EXPECT_NEAR((w(0) + w(90)) / 4 + w(45) / 2, mean, 0.1 * mean);
  EXPECT_NEAR((w(0) - w(90)) / 2, w0, 2e-3 * w0);
}

// Kind: identity.  Where the band follows a cosine all round, the pressure is p cos 2 theta, and
// its resultant over half a turn round a lobe is p R b int cos 2x cos x dx = 2/3 p R b.  Tolerance
// 1e-6: rounding.
TEST(OvalCup, IdentityForceOfALobe) {
  CamFit fit = fit_of_size25();
  const OvalCup cup(size25(), kSteelOfCup, fit,
                    {.one_sided = false, .most_waves = 8, .large_rotations = LargeRotations::off});
  const OvalContact& contact = cup.contact();
  const double bore = 62.801e-3 / 2 - 0.755e-3;
  EXPECT_NEAR(contact.lobe_force / (contact.largest_pressure * bore * 9.2e-3 * 2 / 3), 1, 1e-6);
  EXPECT_EQ(contact.steps, 0);
}

// (FE-52) Kind: rules of the contact: the band is nowhere inside the cam, the apex goes as far as
// the cam, and a cam with clearance presses on a shorter arc.  Tolerance 1.5 % of w_0: the cam with
// the perimeter of the bore lies w_0/R = 1 % inside the cosine.
TEST(OvalCup, BehaviourOneSidedContact) {
  CamFit fit = fit_of_size25();
  const OvalOptions options{.order = 4};
  const OvalCup tight(size25(), kSteelOfCup, fit, options);
  fit.clearance = 0.05e-3;
  const OvalCup loose(size25(), kSteelOfCup, fit, options);
  const double r = 31.023e-3;
  for (const OvalCup* const cup : {&tight, &loose}) {
    EXPECT_LT(cup->contact().overlap, 1e-6);
    EXPECT_GT(cup->contact().steps, 0);
    EXPECT_GT(cup->contact().lobe_force, 0);
  }
  EXPECT_GT(tight.contact().half_arc, degrees(45));
  EXPECT_LT(tight.contact().half_arc, degrees(75));
  EXPECT_LT(loose.contact().half_arc, tight.contact().half_arc);
  const auto apex = [&](const OvalCup& cup) {
    return cup.field(cup.at(r, kBarrelFoot + kLoadLine), 0, 0).displacement[0];
  };
  const double w0 = fit.radial_displacement;
  EXPECT_NEAR(apex(tight), w0, 0.015 * w0);
  EXPECT_NEAR(apex(tight) - apex(loose), fit.clearance, 0.01 * w0);
}

// Kind: convergence.  Tolerance 1 % of the largest stress: order 5 against 6 and 48 waves against
// 64, away from the corners.
TEST(OvalCup, ConvergenceOfOrderAndWaves) {
  const OvalCup cup(size25(), kSteelOfCup, fit_of_size25(),
                    {.large_rotations = LargeRotations::off});
  const OvalCup finer(size25(), kSteelOfCup, fit_of_size25(),
                      {.order = 6, .most_waves = 64, .large_rotations = LargeRotations::off});
  for (const double z : {8.6e-3, 12e-3, kLoadLine})
    for (const double angle : {0.0, 30.0, 60.0, 90.0})
      for (const double off : {-0.2e-3, 0.2e-3}) {
        const auto stress = [&](const OvalCup& of) {
          return of.field(of.at(31.023e-3 + off, kBarrelFoot + z), degrees(angle), 48).stress;
        };
        const auto coarse = stress(cup);
        const auto fine = stress(finer);
        for (std::size_t i = 0; i < 6; ++i)
          EXPECT_NEAR(coarse[i], fine[i], 0.8e6) << z << ' ' << angle << ' ' << i;
      }
}

// (FE-52), (FE-53) Kind: closed form.  The mean hoop stress round the turn, where bending vanishes.
// A cam whose perimeter exceeds that of the bore by Delta stretches the rim by Delta/(2 pi R). With
// Delta = 0 the rim is not plane either: its warping, r w0/(4L) cos 2 theta, stretches it by
// (w0/(2L))^2/4. Tolerance 8 %: the barrel holds the rim at one end; 15 % of the small stretch by
// warping.
TEST(OvalCup, LimitPerimeterStretchesTheRim) {
  const double R = 31.023e-3;
  CamFit fit = fit_of_size25();
  const OvalOptions options{.one_sided = false, .order = 4, .most_waves = 16};
  const double w0 = fit.radial_displacement;
  const auto mean_hoop = [&](const OvalCup& cup) {
    const OvalPlace place = cup.at(R, kBarrelFoot + kLoadLine);
    double sum = 0;
    for (int i = 0; i < 36; ++i) sum += cup.field(place, degrees(5 * i), 0).stress[1] / 36;
    return sum;
  };
  const double same = mean_hoop(OvalCup(size25(), kSteelOfCup, fit, options));
  fit.perimeter_excess = 2 * pi * w0 * w0 / R;
  const OvalCup longer(size25(), kSteelOfCup, fit, options);
  const double E = kSteelOfCup.youngs_modulus;
  EXPECT_NEAR((mean_hoop(longer) - same) / (E * fit.perimeter_excess / (2 * pi * R)), 1, 0.08);
  EXPECT_NEAR(same / (E * std::pow(w0 / (2 * kLoadLine), 2) / 4), 1, 0.15);
  EXPECT_TRUE(longer.contact().large_rotations);
  EXPECT_GT(longer.contact().iterations, 3);
  EXPECT_LT(longer.contact().overlap, 1e-6);
}

// Kind: limit.  A hundredth of the displacement leaves the answer of small rotations, and `off`
// gives that answer at any displacement.
TEST(OvalCup, LimitSmallRotations) {
  CamFit fit = fit_of_size25();
  OvalOptions options{.most_waves = 16, .large_rotations = LargeRotations::on};
  fit.radial_displacement *= 0.01;
  const OvalCup small(size25(), kSteelOfCup, fit, options);
  const OvalPlace place = small.at(31.1e-3, kBarrelFoot + 8.6e-3);
  const auto large = small.field(place, 0.4, 0);
  const auto linear = small.small_field(place, 0.4, 0);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(large.stress[i], linear.stress[i], 2e-3 * std::abs(linear.stress[3])) << i;
  EXPECT_GT(std::abs(linear.stress[3]), 1e4);
  options.large_rotations = LargeRotations::automatic;
  fit.radial_displacement = 1e-6;  // 0.1 % of the bending stress: not worth the time
  EXPECT_FALSE(OvalCup(size25(), kSteelOfCup, fit, options).contact().large_rotations);
  options.large_rotations = LargeRotations::off;
  const OvalCup off(size25(), kSteelOfCup, fit_of_size25(), options);
  EXPECT_FALSE(off.contact().large_rotations);
  EXPECT_EQ(off.contact().iterations, 0);
}

TEST(OvalCup, InputRefused) {
  CupSection bare = size25();
  bare.rim.reset();
  EXPECT_THROW(OvalCup(bare, kSteelOfCup, fit_of_size25()), InputError);
  CamFit loose = fit_of_size25();
  loose.clearance = 0.4e-3;  // more than the displacement
  EXPECT_THROW(OvalCup(size25(), kSteelOfCup, loose), InputError);
  CamFit none = fit_of_size25();
  none.radial_displacement = 0;
  EXPECT_THROW(OvalCup(size25(), kSteelOfCup, none), InputError);
  EXPECT_THROW(OvalCup(size25(), kSteelOfCup, fit_of_size25(), {.most_waves = 10}), InputError);
  const OvalCup cup(size25(), kSteelOfCup, fit_of_size25(), {.order = 3, .most_waves = 8});
  EXPECT_THROW((void)cup.at(0.02, kBarrelFoot + 5e-3), InputError);
}

}  // namespace
}  // namespace strainwave::gear_fem
