// SPDX-License-Identifier: Apache-2.0
// Stress of the plies and their first failure.
#include "strainwave/laminate/ply_failure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

const Lamina<> kPlyCarbon{.E1 = 181e9, .E2 = 10.3e9, .G12 = 7.17e9, .nu12 = 0.28};
const LaminaStrength kStrength{.fibre_tension = 1500e6,
                               .fibre_compression = 1500e6,
                               .transverse_tension = 40e6,
                               .transverse_compression = 246e6,
                               .shear = 68e6};

// Kind: identity (LA-12).  The criterion is 1 at each strength; with equal strengths it is that of
// von Mises.  Tolerance: rounding.
TEST(PlyFailure, IdentityCriterionAtTheStrengths) {
  const double all[][3] = {{1500e6, 0, 0}, {-1500e6, 0, 0}, {0, 40e6, 0},
                           {0, -246e6, 0}, {0, 0, 68e6},    {0, 0, -68e6}};
  for (const auto& s : all)
    test::expect_relative(tsai_wu({.along = s[0], .across = s[1], .shear = s[2]}, kStrength), 1,
                          1e-13);
  const double y = 900e6;
  const LaminaStrength metal{y, y, y, y, y / std::sqrt(3.0)};
  const LaminaStress stress{.along = 300e6, .across = -200e6, .shear = 150e6};
  const double mises = std::sqrt(300e6 * 300e6 + 200e6 * 200e6 + 300e6 * 200e6 + 3 * 150e6 * 150e6);
  test::expect_relative(tsai_wu(stress, metal), mises * mises / (y * y), 1e-13);
}

// Kind: reference (LA-12).  Source: hand calculation of the criterion for T300/5208 at (400, -100,
// 30) MPa: 0.071111 + 1.016260 + 0.194637 + 0.268826 - 2.093496 = -0.542662, which is not a
// failure. Tolerance: six digits of the hand calculation.
TEST(PlyFailure, ReferenceCriterionOfACombinedStress) {
  EXPECT_NEAR(tsai_wu({.along = 400e6, .across = -100e6, .shear = 30e6}, kStrength), -0.542662,
              2e-6);
}

// Kind: identity (LA-13), (LA-14).  At the factor the criterion is met, and below it is not; a
// fixed stress beyond the limit gives 0; no load gives none.  Tolerance: rounding.
TEST(PlyFailure, IdentityFactorsMeetTheirLimits) {
  const LaminaStress fixed{.along = 100e6, .across = 12e6, .shear = -8e6};
  for (const LaminaStress& load : {LaminaStress{200e6, 5e6, 3e6}, LaminaStress{-200e6, -5e6, 3e6},
                                   LaminaStress{0, -7e6, 0}, LaminaStress{0, 0, 4e6}}) {
    const double f = tsai_wu_factor(fixed, load, kStrength).value();
    const auto at = [&](double factor) {
      return LaminaStress{fixed.along + factor * load.along, fixed.across + factor * load.across,
                          fixed.shear + factor * load.shear};
    };
    EXPECT_GT(f, 0);
    test::expect_relative(tsai_wu(at(f), kStrength), 1, 1e-10);
    EXPECT_LT(tsai_wu(at(0.99 * f), kStrength), 1);
    const double g = strain_factor(fixed, load, kPlyCarbon, kStrength).value();
    const LaminaStress s = at(g);
    const double along = (s.along - 0.28 * s.across) / 1500e6;
    const double across = s.across - 0.28 * 10.3 / 181 * s.along;
    const double used =
        std::max({std::abs(along), across / 40e6, -across / 246e6, std::abs(s.shear) / 68e6});
    test::expect_relative(used, 1, 1e-12);
  }
  EXPECT_EQ(tsai_wu_factor({.along = 0, .across = 50e6, .shear = 0}, fixed, kStrength), 0.0);
  EXPECT_EQ(strain_factor({.along = 0, .across = 50e6, .shear = 0}, fixed, kPlyCarbon, kStrength),
            0.0);
  EXPECT_EQ(strain_factor({.along = 0, .across = 0, .shear = -69e6}, fixed, kPlyCarbon, kStrength),
            0.0);
  EXPECT_FALSE(tsai_wu_factor(fixed, {}, kStrength));
  EXPECT_FALSE(strain_factor(fixed, {}, kPlyCarbon, kStrength));
  // A stress at its limit fails, also under a load that would relieve it.
  for (const double across : {40e6, -246e6})
    EXPECT_EQ(strain_factor({.along = 0, .across = across, .shear = 0},
                            {.along = 0, .across = -across, .shear = 0}, kPlyCarbon, kStrength),
              0.0);
  // Any stress counts, however small.
  for (const double across : {0.5, -0.5})
    test::expect_relative(
        strain_factor({}, {.along = 0, .across = across, .shear = 0}, kPlyCarbon, kStrength)
            .value(),
        (across > 0 ? 40e6 : 246e6) / 0.5, 1e-12);
}

// Kind: identity (LA-11).  The stresses of all plies, turned to the axes of the wall, add up to the
// forces; their first moment about the neutral surface is the bending stiffness times the
// curvature. Tolerance: rounding.
TEST(PlyFailure, IdentityStressesBalanceTheLoads) {
  const std::vector<LaminatePly<>> plies = {
      {kPlyCarbon, 0.5, 1}, {kPlyCarbon, -0.9, 2}, {kPlyCarbon, 0.1, 1}};
  const TubeLoads loads{.radius = 0.04, .torque = 137, .axial_force = -900, .curvature = 0.3};
  const double h = 1.2e-3;
  const std::vector<PlyFace> faces = ply_stresses(plies, h, loads);
  ASSERT_EQ(faces.size(), 6U);
  double Nx = 0, Ny = 0, Nxy = 0, hoop = 0, moment = 0;
  double z = -h / 2;
  for (std::size_t i = 0; i < plies.size(); ++i) {
    const double t = plies[i].thickness / 4 * h;
    const double c = std::cos(plies[i].angle);
    const double s = std::sin(plies[i].angle);
    const auto turned_y = [&](const LaminaStress& of) {
      return s * s * of.along + c * c * of.across + 2 * c * s * of.shear;
    };
    const LaminaStress& load = faces[2 * i].load;
    Nx += t * (c * c * load.along + s * s * load.across - 2 * c * s * load.shear);
    Ny += t * turned_y(load);
    Nxy += t * (c * s * (load.along - load.across) + (c * c - s * s) * load.shear);
    const double y0 = turned_y(faces[2 * i].assembly);
    const double y1 = turned_y(faces[2 * i + 1].assembly);
    hoop += t * (y0 + y1) / 2;
    moment += t * ((y0 + y1) / 2 * (z + t / 2) + (y1 - y0) * t / 12);
    z += t;
    EXPECT_FALSE(faces[2 * i].outer);
    EXPECT_TRUE(faces[2 * i + 1].outer);
    EXPECT_EQ(faces[2 * i + 1].ply, i);
  }
  test::expect_relative(Nx, -900 / (2 * pi * 0.04), 1e-12);
  EXPECT_NEAR(Ny, 0, 1e-10 * std::abs(Nx));
  test::expect_relative(Nxy, -137 / (2 * pi * 0.04 * 0.04), 1e-12);
  EXPECT_NEAR(hoop, 0, 1e-9 * moment / h);
  test::expect_relative(moment, hoop_bending_stiffness(laminate_stiffness<double>(plies, h)) * 0.3,
                        1e-11);
}

const LaminaEndurance kEndurance{.fibre = 600e6, .transverse = 16e6, .shear = 30e6};

// Kind: reference (LA-19).  Source: hand calculation.  Each line ends at the endurance without mean
// stress and at the strength of its sign without amplitude; across and shear add up as squares.
// Tolerance: rounding.
TEST(PlyFailure, ReferenceHaighLines) {
  const auto share = [](const LaminaStress& a, const LaminaStress& m) {
    return ply_endurance(a, m, kStrength, kEndurance);
  };
  test::expect_relative(share({600e6, 0, 0}, {}).fibre, 1, 1e-13);
  test::expect_relative(share({-600e6, 0, 0}, {}).utilisation(), 1, 1e-13);
  test::expect_relative(share({}, {1500e6, 0, 0}).fibre, 1, 1e-13);
  test::expect_relative(share({}, {0, 40e6, 0}).matrix, 1, 1e-13);
  test::expect_relative(share({}, {0, -246e6, 0}).matrix, 1, 1e-13);
  test::expect_relative(share({}, {0, 0, -68e6}).matrix, 1, 1e-13);
  test::expect_relative(share({0, -16e6, 0}, {}).matrix, 1, 1e-13);
  test::expect_relative(share({0, 0, -30e6}, {}).utilisation(), 1, 1e-13);
  const PlyEndurance both = share({150e6, 4e6, -6e6}, {-300e6, 10e6, 17e6});
  test::expect_relative(both.fibre, 0.25 + 0.2, 1e-13);
  test::expect_relative(both.matrix, std::hypot(0.25 + 0.25, 0.2 + 0.25), 1e-13);
  EXPECT_EQ(both.utilisation(), both.matrix);
  EXPECT_EQ(share({150e6, 4e6, 6e6}, {-300e6, 10e6, -17e6}).matrix, both.matrix);
  test::expect_relative(share({}, {0, 0.5, 0}).matrix, 0.5 / 40e6, 1e-13);
  test::expect_relative(share({}, {0.5, 0, 0}).fibre, 0.5 / 1500e6, 1e-13);
  LaminaStrength uneven = kStrength;
  uneven.fibre_compression = 1200e6;
  test::expect_relative(ply_endurance({}, {-300e6, 0, 0}, uneven, kEndurance).fibre, 0.25, 1e-13);
}

// Kind: identity (LA-19).  At the factor on the mean stress the share is 1, of the fibres or of the
// matrix; an amplitude beyond the endurance gives 0; no mean stress gives none.  Tolerance:
// rounding.
TEST(PlyFailure, IdentityEnduranceFactor) {
  const LaminaStress amplitude{200e6, 5e6, -8e6};
  for (const LaminaStress& mean :
       {LaminaStress{300e6, 1e6, 1e6}, LaminaStress{-100e6, 9e6, -4e6}, LaminaStress{0, -20e6, 0},
        LaminaStress{0, 0, 12e6}, LaminaStress{400e6, 0, 0}}) {
    const double f = endurance_factor(amplitude, mean, kStrength, kEndurance).value();
    const LaminaStress at{f * mean.along, f * mean.across, f * mean.shear};
    test::expect_relative(ply_endurance(amplitude, at, kStrength, kEndurance).utilisation(), 1,
                          1e-12);
  }
  const LaminaStress mean{300e6, 1e6, 1e6};
  EXPECT_EQ(endurance_factor({601e6, 0, 0}, mean, kStrength, kEndurance), 0.0);
  EXPECT_EQ(endurance_factor({0, 16.1e6, 0}, mean, kStrength, kEndurance), 0.0);
  EXPECT_EQ(endurance_factor({0, 12e6, 23e6}, mean, kStrength, kEndurance), 0.0);
  EXPECT_EQ(endurance_factor({600e6, 0, 0}, {0, 0, 1e6}, kStrength, kEndurance), 0.0);
  EXPECT_GT(endurance_factor({599e6, 0, 0}, mean, kStrength, kEndurance).value(), 0.0);
  EXPECT_FALSE(endurance_factor(amplitude, {}, kStrength, kEndurance));
}

// Kind: identity (LA-18).  The assembly's stress runs between that at a lobe and its negative. What
// both criteria admit is convex, so the least factor over the turn is that of one end.  Tolerance:
// rounding.
TEST(PlyFailure, IdentityWorstAngleIsAnEnd) {
  const LaminaStress bent{90e6, 14e6, 11e6};
  for (const LaminaStress& load : {LaminaStress{200e6, 5e6, 3e6}, LaminaStress{-200e6, -5e6, 3e6},
                                   LaminaStress{50e6, -7e6, -9e6}}) {
    const auto at = [&](double share) {
      const LaminaStress fixed{share * bent.along, share * bent.across, share * bent.shear};
      return std::array{tsai_wu_factor(fixed, load, kStrength).value(),
                        strain_factor(fixed, load, kPlyCarbon, kStrength).value()};
    };
    for (std::size_t of = 0; of < 2; ++of) {
      const double ends = std::min(at(1)[of], at(-1)[of]);
      for (int i = -20; i <= 20; ++i) EXPECT_GE(at(i / 20.0)[of], ends * (1 - 1e-12));
    }
  }
}

}  // namespace
}  // namespace strainwave
