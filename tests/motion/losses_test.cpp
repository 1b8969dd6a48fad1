// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/losses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "support/expect.hpp"

namespace strainwave {
namespace {

/// z after a monotonic change of the twist, by Runge and Kutta's fourth order.
double integrated(const BoucWen& model, double z, double change, int steps) {
  const double h = 1.0 / steps;
  for (int n = 0; n < steps; ++n) {
    const double k1 = model.rate(z, change);
    const double k2 = model.rate(z + h / 2 * k1, change);
    const double k3 = model.rate(z + h / 2 * k2, change);
    const double k4 = model.rate(z + h * k3, change);
    z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return z;
}

TEST(Hysteresis, ReferenceLoopsOfDahl) {
  // (MO-9): sigma_0 1e5, F_c 5: F_max = F_c tanh q, W = 4 F_c X (1 - tanh(q)/q), q = sigma_0 X/F_c,
  // with the printed digits.  The loop is cut into 2000 exact pieces; trapezoids add 1e-7.
  struct Case {
    double amplitude, work, largest;
  };
  const BoucWen model = dahl(1e5, 5);
  for (const auto& [X, work, largest] :
       {Case{2e-5, 2.005104e-5, 1.899745}, Case{5e-5, 2.384058e-4, 3.807971},
        Case{2e-4, 3.000671e-3, 4.996646}}) {
    double z = dahl_after(model, 0.0, X);
    const auto branch = [&](double change) {
      double area = 0.0;
      for (int n = 0; n < 2000; ++n) {
        const double next = dahl_after(model, z, change / 2000);
        area += (z + next) / 2 * change / 2000;
        z = next;
      }
      return area;
    };
    for (int turn = 0; turn < 20; ++turn) branch(-2 * X), branch(2 * X);
    test::expect_relative(z, largest, 1e-6);
    test::expect_relative(branch(-2 * X) + branch(2 * X), work, 3e-6);
  }
}

TEST(Hysteresis, CrosscheckRateAgainstTheExactPath) {
  // (MO-8, MO-9): 200 steps of fourth order on the smooth path to 1e-9.
  const BoucWen model = dahl(1e5, 5);
  double z = 0.0;
  for (const double change : {3e-5, -1e-5, 4e-5, -8e-5}) {
    test::expect_relative(integrated(model, z, change, 400), dahl_after(model, z, change), 1e-8);
    z = dahl_after(model, z, change);
  }
}

TEST(Hysteresis, LimitOfBoucAndWen) {
  // z approaches F_c for every exponent and asymmetry, from either side.
  for (const double n : {1.0, 1.7, 3.0})
    for (const double g : {-0.5, 0.0, 0.5}) {
      const BoucWen model{.stiffness = 1e5, .limit = 5, .exponent = n, .asymmetry = g};
      EXPECT_NEAR(integrated(model, 0.0, 2e-3, 4000), 5, 1e-6);
      EXPECT_NEAR(integrated(model, 0.0, -2e-3, 4000), -5, 1e-6);
      test::expect_relative(model.rate(0.0, 1e-3), 100.0, 1e-15);  // A behind z = 0
      EXPECT_NEAR(model.rate(5.0, 1e-3), 0.0, 1e-11);
    }
}

TEST(Hysteresis, IdentityEveryClosedPathLosesEnergy) {
  std::mt19937_64 generator(7);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(generator() >> 11) * 0x1p-53;
  };
  for (int trial = 0; trial < 30; ++trial) {
    const BoucWen model{.stiffness = uniform(1e4, 1e6),
                        .limit = uniform(1, 20),
                        .exponent = uniform(1, 4),
                        .asymmetry = uniform(-1, 0.5)};
    const double scale = model.limit / model.stiffness;
    // A random path that is run until it repeats itself.
    std::vector<double> path;
    double sum = 0.0;
    for (int n = 0; n < 6; ++n) sum += path.emplace_back(uniform(-3, 3) * scale);
    path.push_back(-sum);
    double z = 0.0;
    double work = 0.0;
    for (int lap = 0; lap < 30; ++lap) {
      work = 0.0;
      for (const double change : path)
        for (int n = 0; n < 50; ++n) {
          const double next = integrated(model, z, change / 50, 4);
          work += (z + next) / 2 * change / 50;
          z = next;
        }
    }
    EXPECT_GT(work, 0.0);
  }
}

TEST(Friction, LimitSteadySpeed) {
  // (MO-10): u' = 0 at u = g(w)/sigma_0 sgn w; the torque is that of Stribeck's curve.
  const LuGre model{.bristle_stiffness = 300,
                    .bristle_damping = 0.4,
                    .viscous = 0.002,
                    .coulomb = 0.03,
                    .breakaway = 0.05,
                    .stribeck_speed = 2};
  for (const double speed : {-40.0, -1.0, 0.1, 3.0}) {
    const double g = 0.03 + 0.02 * std::exp(-speed * speed / 4);
    const LuGre::At at = model.at(std::copysign(g / 300, speed), speed);
    EXPECT_NEAR(at.rate, 0.0, 1e-15 * std::abs(speed) + 1e-16);
    test::expect_relative(at.torque, std::copysign(g, speed) + 0.002 * speed, 1e-13);
    test::expect_relative(model.steady(speed), at.torque, 1e-13);
  }
  EXPECT_EQ(model.steady(0.0), 0.0);
  EXPECT_EQ(model.at(1e-4, 0.0).torque, 300 * 1e-4);  // sticking: a spring
  test::expect_relative(model.at(0.0, 1.5).torque, (0.4 + 0.002) * 1.5, 1e-14);
}

TEST(Losses, InputEachRuleBrokenOnce) {
  const BoucWen sound{.stiffness = 1e5, .limit = 5};
  const auto hysteresis = [&](double BoucWen::*member, double value) {
    BoucWen model = sound;
    model.*member = value;
    return test::broken_rule([&] { require_constants(model); });
  };
  EXPECT_EQ(hysteresis(&BoucWen::limit, 5), "no error");
  EXPECT_NE(hysteresis(&BoucWen::stiffness, 0).find("hysteresis.stiffness"), std::string::npos);
  EXPECT_NE(hysteresis(&BoucWen::limit, -1).find("hysteresis.limit"), std::string::npos);
  EXPECT_NE(hysteresis(&BoucWen::exponent, 0.9).find("hysteresis.exponent"), std::string::npos);
  EXPECT_NE(hysteresis(&BoucWen::asymmetry, 0.51).find("hysteresis.asymmetry"), std::string::npos);
  const LuGre steel{.bristle_stiffness = 1, .coulomb = 1, .breakaway = 1};
  const auto friction = [&](double LuGre::*member, double value) {
    LuGre model = steel;
    model.*member = value;
    return test::broken_rule([&] { require_constants(model); });
  };
  EXPECT_EQ(friction(&LuGre::viscous, 0), "no error");
  EXPECT_NE(friction(&LuGre::bristle_stiffness, 0).find("bristle_stiffness"), std::string::npos);
  EXPECT_NE(friction(&LuGre::bristle_damping, -1).find("bristle_damping"), std::string::npos);
  EXPECT_NE(friction(&LuGre::viscous, -1).find("viscous"), std::string::npos);
  EXPECT_NE(friction(&LuGre::coulomb, 0).find("coulomb"), std::string::npos);
  EXPECT_NE(friction(&LuGre::breakaway, 0.9).find("breakaway"), std::string::npos);
  EXPECT_NE(friction(&LuGre::stribeck_speed, 0).find("stribeck_speed"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
