// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/losses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

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

TEST(Friction, ReferenceWarmGrease) {
  // (MO-55): the viscous part falls by e^-0.6 over 20 K at 0.03 per kelvin, the rest stays.
  LuGre model{.bristle_stiffness = 300,
              .viscous = 0.002,
              .coulomb = 0.03,
              .breakaway = 0.03,
              .thinning = 0.03,
              .warming = 20};
  test::expect_relative(model.steady(100), 0.03 + 0.2 * std::exp(-0.6), 1e-14);
  test::expect_relative(model.at(0.03 / 300, 100).torque, 0.03 + 0.2 * std::exp(-0.6), 1e-13);
  model.warming = -20;
  test::expect_relative(model.steady(-100), -0.03 - 0.2 * std::exp(0.6), 1e-14);
}

/// Uniform numbers that are the same on every machine.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : generator_(seed) {}
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 generator_;
};

TEST(Friction, IdentityLoadAddsToBothTorques) {
  // (MO-40): g = F_c + kappa_c L + (F_s + kappa_s L - F_c - kappa_c L) exp(-(w/w_s)^2), by hand.
  LuGre model{.bristle_stiffness = 300,
              .viscous = 0.002,
              .coulomb = 0.03,
              .breakaway = 0.05,
              .stribeck_speed = 2,
              .load_coulomb = 0.07,
              .load_breakaway = 0.05};
  EXPECT_TRUE(model.by_load());
  test::expect_relative(model.sliding(0.0, 0.4), 0.07, 1e-15);
  test::expect_relative(model.sliding(1e3, 0.4), 0.058, 1e-15);
  test::expect_relative(model.steady(-3, 0.4), -(0.058 + 0.012 * std::exp(-2.25)) - 0.006, 1e-14);
  test::expect_relative(model.at(0.058 / 300, 1e3, 0.4).torque, 0.058 + 2, 1e-14);
  EXPECT_NEAR(model.at(0.058 / 300, 1e3, 0.4).rate, 0, 1e-10);
  model.load_breakaway.reset();  // as load_coulomb
  test::expect_relative(model.sliding(0.0, 0.4), 0.078, 1e-15);
  model.load_coulomb = 0.0;
  EXPECT_FALSE(model.by_load());
  EXPECT_EQ(model.sliding(1.0, 0.4), model.sliding(1.0));
}

TEST(Friction, LimitOfTheDampingThatPushes) {
  // (MO-10): behind a breakaway the bristles bear s0 u = z g with |z| <= F_s/F_c.  The power that
  // is lost, w T_f less the rate of s0 u^2/2, is g|w|z^2 + s1 w^2 (1 - z) + s2 w^2; far above w_s
  // it is negative at some z only if s1 > s2/(F_s/F_c - 1).
  LuGre model{.bristle_stiffness = 1e3, .viscous = 0.4, .coulomb = 2, .breakaway = 6};
  EXPECT_EQ(model.largest_passive_damping(), 0.2);
  const auto least_power = [&](double damping) {
    model.bristle_damping = damping;
    double least = 1.0;
    for (const double w : {-1e4, -30.0, 30.0, 1e4})
      for (int n = -100; n <= 100; ++n) {
        const double u = model.breakaway / model.bristle_stiffness * n / 100;
        const LuGre::At at = model.at(u, w);
        const double lost = w * at.torque - model.bristle_stiffness * u * at.rate;
        least = std::min(least, lost / (w * w));
      }
    return least;
  };
  EXPECT_GE(least_power(0.2), 0.0);
  EXPECT_LT(least_power(0.201), 0.0);
  // With the load, the larger of the two drops counts.
  model.load_coulomb = 0.1;
  model.load_breakaway = 0.5;
  test::expect_relative(model.largest_passive_damping(), 0.1, 1e-15);
  model.load_coulomb = 0.0;
  EXPECT_EQ(model.largest_passive_damping(), 0.0);
  model.load_breakaway.reset();
  model.breakaway = 2;
  EXPECT_EQ(model.largest_passive_damping(), std::numeric_limits<double>::infinity());
  model.breakaway = 6;
  model.thinning = 0.01;
  model.warming = 30;
  test::expect_relative(model.largest_passive_damping(), 0.2 * std::exp(-0.3), 1e-15);
}

TEST(Friction, IdentityEveryPathUnderEveryLoadLosesEnergy) {
  // (MO-40): at constant speed and load the deflection of the bristles and its integral are exact,
  // so the work less the energy stored in the bristles is too.  It is positive in every piece.
  Uniform uniform(11);
  for (int trial = 0; trial < 40; ++trial) {
    LuGre model{.bristle_stiffness = uniform(10, 1000),
                .viscous = uniform(0, 1e-3),
                .coulomb = uniform(0.01, 0.1),
                .stribeck_speed = uniform(0.1, 5),
                .load_coulomb = uniform(0, 0.5),
                .load_breakaway = uniform(0, 0.5)};
    model.breakaway = model.coulomb * uniform(1, 3);
    double u = 0.0;
    for (int n = 0; n < 200; ++n) {
      const double w = uniform(-10, 10);
      const double g = model.sliding(w, uniform(0, 2));
      const double end = std::copysign(g / model.bristle_stiffness, w);
      const double rate = model.bristle_stiffness * std::abs(w) / g;
      const double time = uniform(0, 2) / rate;
      const double next = end + (u - end) * std::exp(-rate * time);
      const double integral = end * time + (u - next) / rate;
      const double work = (model.bristle_stiffness * integral + model.viscous * w * time) * w;
      const double stored = model.bristle_stiffness * (next * next - u * u) / 2;
      EXPECT_GE(work - stored, -1e-15 * (std::abs(work) + std::abs(stored)));
      u = next;
    }
  }
}

/// Four elements that slip one after the other.
std::vector<SlipElement> four_elements() {
  return {{4e4, 0.4}, {2e4, 0.6}, {1e4, 1.0}, {5e3, 1.5}};
}

/// The curve of the first loading: the sum of min(k x, F).
double first_loading(const std::vector<SlipElement>& elements, double twist) {
  double sum = 0.0;
  for (const SlipElement& of : elements) sum += std::min(of.stiffness * twist, of.limit);
  return sum;
}

TEST(SlipElements, IdentityFirstLoadingAndMasing) {
  // (MO-44): behind a reversal at phi_a the branch is the first curve at twice its size:
  // z = z_a - 2 f((phi_a - phi)/2), as long as it stays inside the first reversal.
  const std::vector<SlipElement> elements = four_elements();
  SlipState state = relaxed(elements, 1e-3);
  EXPECT_EQ(slip_torque(elements, state, 1e-3), 0.0);
  const double top = 2.3e-4;
  for (const double x : {1e-6, 1e-5, 2.9e-5, 9e-5, top}) {
    test::expect_relative(slip_torque(elements, state, 1e-3 + x), first_loading(elements, x),
                          1e-10);
    test::expect_relative(slip_torque(elements, state, 1e-3 - x), -first_loading(elements, x),
                          1e-10);
  }
  state = slip_after(elements, state, 1e-3 + top);
  const double at_top = first_loading(elements, top);
  for (const double x : {1e-5, 2.1e-5, 1e-4, 2e-4, 2 * top})
    EXPECT_NEAR(slip_torque(elements, state, 1e-3 + top - x),
                at_top - 2 * first_loading(elements, x / 2), 1e-10);
  // The loop closes at the opposite twist.
  EXPECT_NEAR(slip_torque(elements, state, 1e-3 - top), -at_top, 1e-10);
}

TEST(SlipElements, ReferenceAreaOfTheLoop) {
  // (MO-45): W = sum 4 F (X - F/k) over the elements that slip; the area is integrated here by
  // trapezoids over pieces between all corners of the loop, which is exact.
  const std::vector<SlipElement> elements = four_elements();
  for (const double X : {5e-6, 2e-5, 5e-5, 2e-4, 1e-3}) {
    double expected = 0.0;
    for (const SlipElement& of : elements)
      expected += 4 * of.limit * std::max(0.0, X - of.limit / of.stiffness);
    SlipState state = slip_after(elements, relaxed(elements, 0.0), X);
    double area = 0.0;
    for (const double end : {-X, X}) {
      std::vector<double> twists = {state.twist, end};
      const double way = end > 0 ? 1.0 : -1.0;
      for (const SlipElement& of : elements)
        if (of.limit / of.stiffness < X)
          twists.push_back(state.twist + way * 2 * of.limit / of.stiffness);
      std::ranges::sort(twists);
      if (way < 0) std::ranges::reverse(twists);
      for (std::size_t n = 1; n < twists.size(); ++n)
        area += (slip_torque(elements, state, twists[n]) +
                 slip_torque(elements, state, twists[n - 1])) /
                2 * (twists[n] - twists[n - 1]);
      state = slip_after(elements, state, end);
    }
    EXPECT_NEAR(area, expected, 1e-12 * (expected + 1e-4)) << X;
  }
}

TEST(SlipElements, IdentityWipingOut) {
  // (MO-44): a closed inner loop leaves nothing behind, and a larger swing forgets the smaller.
  const std::vector<SlipElement> elements = four_elements();
  const SlipState start = relaxed(elements, 0.0);
  const auto along = [&](std::initializer_list<double> path) {
    SlipState state = start;
    for (const double twist : path) state = slip_after(elements, state, twist);
    return state.torque;
  };
  const auto expect_equal = [](const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t j = 0; j < a.size(); ++j) EXPECT_NEAR(a[j], b[j], 1e-12);
  };
  expect_equal(along({2e-4, -1e-4, 5e-5, -1e-4, -1.5e-4}), along({2e-4, -1.5e-4}));
  expect_equal(along({2e-4, -1e-4, 5e-5, -5e-5, 2e-4}), along({2e-4}));
  expect_equal(along({1e-4, -5e-5, 3e-4}), along({3e-4}));
}

TEST(SlipElements, IdentityWorkIsStoredOrLost) {
  // (MO-45): the work along random paths, by trapezoids over short steps, is the change of the
  // elastic energy and what slips away; each step across a corner adds less than 1e-6 of the work.
  Uniform uniform(5);
  const std::vector<SlipElement> elements = four_elements();
  for (int trial = 0; trial < 20; ++trial) {
    SlipState state = relaxed(elements, 0.0);
    double work = 0.0;
    double lost = 0.0;
    for (int piece = 0; piece < 12; ++piece) {
      const double way = uniform(-6e-4, 6e-4);
      const double step = way / 2000;
      for (int n = 0; n < 2000; ++n) {
        const SlipState next = slip_after(elements, state, state.twist + step);
        const double before = slip_torque(elements, state, state.twist);
        work += (before + slip_torque(elements, next, next.twist)) / 2 * step;
        const double power = slip_loss(elements, next, next.twist, step);
        EXPECT_GE(power, 0.0);
        lost += power;
        state = next;
      }
    }
    EXPECT_NEAR(work, slip_energy(elements, state, state.twist) + lost, 2e-3 * work);
    EXPECT_GT(lost, 0.0);
    EXPECT_GE(work, slip_energy(elements, state, state.twist));
  }
}

TEST(SlipElements, LimitElementThatNeverSlipsIsASpring) {
  const std::vector<SlipElement> elements = {{3e4, 1e9}};
  SlipState state = relaxed(elements, 0.0);
  for (const double twist : {1e-3, -5e-4, 2e-3}) {
    state = slip_after(elements, state, twist);
    test::expect_relative(state.torque[0], 3e4 * twist, 1e-12);
    test::expect_relative(slip_energy(elements, state, twist), 1.5e4 * twist * twist, 1e-12);
    EXPECT_EQ(slip_loss(elements, state, twist, 1.0), 0.0);
  }
}

TEST(Losses, InputSlipElements) {
  const auto broken = [](const SlipElement& element) {
    return test::broken_rule([&] {
      require_constants(std::vector<SlipElement>{{1e4, 1.0}, element});
    });
  };
  EXPECT_EQ(broken({1e4, 2.0}), "no error");
  EXPECT_EQ(broken({0.0, 2.0}), "slip_element[1].stiffness = 0 N*m/rad violates: > 0");
  EXPECT_EQ(broken({1e4, -2.0}), "slip_element[1].limit = -2 N*m violates: > 0");
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
  EXPECT_NE(friction(&LuGre::thinning, -0.1).find("friction.thinning"), std::string::npos);
  EXPECT_NE(friction(&LuGre::warming, 201).find("friction.warming"), std::string::npos);
  EXPECT_NE(friction(&LuGre::load_coulomb, -0.1).find("friction.load_coulomb"), std::string::npos);
  EXPECT_EQ(test::broken_rule([&] {
              require_constants(LuGre{.bristle_stiffness = 1, .coulomb = 2, .breakaway = 1},
                                FieldPath("drivetrain") / "load_friction");
            }),
            "drivetrain.load_friction.breakaway = 1 N*m violates: at least "
            "drivetrain.load_friction.coulomb");
  LuGre negative = steel;
  negative.load_breakaway = -0.1;
  EXPECT_NE(test::broken_rule([&] { require_constants(negative); }).find("friction.load_breakaway"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
