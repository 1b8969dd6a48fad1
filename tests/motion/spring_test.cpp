// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/spring.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "strainwave/core/roots.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

const CatalogueSpring kCatalogue{{6.7e4, 1.1e5, 1.2e5}, {29.0, 108.0}};

/// Twist of a spring at a torque, by bisection of the torque.
double twist_at(const Spring& spring, double torque, double compliance = 0.0) {
  return bracketed_root(
      [&](double twist) { return in_series(spring, twist, compliance).torque - torque; }, -0.1,
      0.1);
}

TEST(Spring, ReferenceCatalogueExample) {
  // (MO-2): Catalogue 1018856, eq. 42, prints 7.15e-4 rad at 60 N*m; the digits are of the same
  // equation, and the tolerance is theirs.
  test::expect_relative(twist_at(kCatalogue, 60), 7.14654003e-4, 1e-9);
  test::expect_relative(twist_at(kCatalogue, 200), 1.917684306e-3, 1e-9);
  test::expect_relative(twist_at(kCatalogue, -60), -7.14654003e-4, 1e-9);
}

TEST(Spring, IdentitySeriesSharesTheTwist) {
  // (MO-1, MO-2, MO-3): psi + Lambda T(psi) = phi, and T is that of the spring alone at psi.  The
  // tolerance is rounding.
  for (const Spring& spring :
       {Spring(LinearSpring{5e4}), Spring(kCatalogue), Spring(CubicSpring{5e4, 1e10})})
    for (const double compliance : {0.0, 1e-9, 2e-6, 1e-3})
      for (const double twist : {-4e-3, -6e-4, -1e-12, 0.0, 1e-9, 4.4e-4, 2e-3}) {
        const SpringState at = in_series(spring, twist, compliance);
        EXPECT_NEAR(at.twist + compliance * at.torque, twist, 1e-14 * std::abs(twist));
        const double alone = in_series(spring, at.twist, 0.0).torque;
        EXPECT_NEAR(at.torque, alone, 1e-13 * std::abs(alone));
      }
}

TEST(Spring, IdentityTorqueIsTheDerivativeOfTheEnergy) {
  // Differences of the fourth order; 1e-8 is their error.
  const double h = 1e-6;
  for (const Spring& spring :
       {Spring(LinearSpring{5e4}), Spring(kCatalogue), Spring(CubicSpring{5e4, 1e10})})
    for (const double at : {-2.1e-3, -2e-4, 1e-4, 7e-4, 1.7e-3}) {
      const auto slope = [&](const auto& f) {
        return (8 * (f(at + h) - f(at - h)) - (f(at + 2 * h) - f(at - 2 * h))) / (12 * h);
      };
      const double torque = slope([&](double x) { return elastic_energy(spring, x); });
      test::expect_relative(in_series(spring, at, 0.0).torque, torque, 1e-8);
      const double tangent = slope([&](double x) { return in_series(spring, x, 0.0).torque; });
      test::expect_relative(tangent_stiffness(spring, at), tangent, 1e-8);
    }
}

TEST(Spring, LimitEqualPiecesAndNoCubeAreLinear) {
  const CatalogueSpring pieces{{5e4, 5e4, 5e4}, {14, 48}};
  for (const double twist : {-3e-3, 1e-4, 6e-4, 2e-3}) {
    const SpringState linear = in_series(LinearSpring{5e4}, twist, 3e-6);
    for (const Spring& spring : {Spring(pieces), Spring(CubicSpring{5e4, 0.0})}) {
      test::expect_relative(in_series(spring, twist, 3e-6).torque, linear.torque, 1e-14);
      test::expect_relative(elastic_energy(spring, twist), 2.5e4 * twist * twist, 1e-14);
    }
  }
}

TEST(Spring, BehaviourCornersAreTheTorquesOfTheCatalogue) {
  EXPECT_EQ(corner_torques(kCatalogue), (std::vector{29.0, 108.0}));
  EXPECT_TRUE(corner_torques(LinearSpring{1.0}).empty());
  EXPECT_TRUE(corner_torques(CubicSpring{1.0, 1.0}).empty());
}

TEST(Spring, InputEachRuleBrokenOnce) {
  const auto broken = [](const Spring& spring) {
    return test::broken_rule([&] { require_constants(spring); });
  };
  EXPECT_EQ(broken(kCatalogue), "no error");
  EXPECT_NE(broken(LinearSpring{0.0}).find("stiffness"), std::string::npos);
  EXPECT_NE(broken(CatalogueSpring{{0, 1, 1}, {1, 2}}).find("K1"), std::string::npos);
  EXPECT_NE(broken(CatalogueSpring{{1, -1, 1}, {1, 2}}).find("K2"), std::string::npos);
  EXPECT_NE(
      broken(CatalogueSpring{{1, 1, std::numeric_limits<double>::quiet_NaN()}, {1, 2}}).find("K3"),
      std::string::npos);
  EXPECT_NE(broken(CatalogueSpring{{1, 1, 1}, {0, 2}}).find("T1"), std::string::npos);
  EXPECT_NE(broken(CatalogueSpring{{1, 1, 1}, {2, 2}}).find("larger than T1"), std::string::npos);
  EXPECT_NE(broken(CubicSpring{-1, 1}).find("stiffness"), std::string::npos);
  EXPECT_NE(broken(CubicSpring{1, -1}).find("cubic"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
