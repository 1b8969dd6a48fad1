// SPDX-License-Identifier: Apache-2.0
#include "twist_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A twist with a mean and harmonics of falling size.
Eigen::VectorXd twist_with_harmonics(int harmonics, double amplitude) {
  Eigen::VectorXd x(2 * harmonics + 1);
  x(0) = 0.3 * amplitude;
  for (int k = 1; k <= harmonics; ++k) {
    x(2 * k - 1) = amplitude / std::pow(k, 3) * std::cos(1.0 + k);
    x(2 * k) = amplitude / std::pow(k, 3) * std::sin(2.0 * k);
  }
  return x;
}

const CatalogueSpring kPieces{{3.1e4, 5e4, 5.7e4}, {14, 48}};
const std::vector<BreathingCrack> kCrack = {{.compliance = 4e-6, .sense = OpeningSense::positive}};

TEST(TwistCycle, ReferenceDahlLoop) {
  // (MO-9): W = 4 F_c X (1 - tanh q/q) and F_max = F_c tanh q with q = sigma_0 X/F_c; the printed
  // digits of three loops are the tolerance of the first numbers, rounding that of the formulas.
  for (const auto& [X, W, F] : {std::tuple{2e-5, 2.005104e-5, 1.899745},
                                {5e-5, 2.384058e-4, 3.807971},
                                {2e-4, 3.000671e-3, 4.996646}}) {
    const double soft = 1e-9;
    const ElasticCurve elastic(LinearSpring{soft}, {});
    TwistCycle cycle(elastic, dahl(1e5, 5), 9, false);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(19);
    x(1) = X;
    cycle.evaluate(x);
    const double work = -pi * X * cycle.torque()(2);
    const double q = 1e5 * X / 5;
    test::expect_relative(work, W, 3e-7);
    test::expect_relative(cycle.torque_amplitude(), F, 3e-7);
    test::expect_relative(work, 4 * 5 * X * (1 - std::tanh(q) / q), 1e-11);
    test::expect_relative(cycle.torque_amplitude(), 5 * std::tanh(q), 1e-12);
  }
}

TEST(TwistCycle, LimitWideDahlLoopIsCoulombFriction) {
  // (MO-9): for q = 2000 the loop loses 4 F_c X (1 - 1/q); the first harmonic is found to 1e-9.
  const ElasticCurve elastic(LinearSpring{1e-9}, {});
  TwistCycle cycle(elastic, dahl(1e6, 5), 9, false);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(19);
  x(1) = 1e-2;
  cycle.evaluate(x);
  test::expect_relative(-pi * x(1) * cycle.torque()(2), 4 * 5 * 1e-2 * (1 - 1 / 2000.0), 1e-9);
}

TEST(TwistCycle, ReferenceBreathingCrackUnderASine) {
  // (MO-5): for the twist X cos tau and a crack that opens for T > 0 the torque has the mean
  // (K+ - K-) X/pi, first harmonic (K+ + K-) X/2 and second 2 (K+ - K-) X/(3 pi), the Fourier
  // series of a rectified cosine.
  const double K = 5e4;
  const double soft = 1 / (1 / K + 4e-6);
  const ElasticCurve elastic(LinearSpring{K}, kCrack);
  for (const bool even : {true, false}) {
    TwistCycle cycle(elastic, {}, 9, even);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(even ? 10 : 19);
    x(1) = 1e-3;
    cycle.evaluate(x);
    test::expect_relative(cycle.torque()(0), (soft - K) * 1e-3 / pi, 1e-12);
    test::expect_relative(cycle.torque()(1), (soft + K) * 1e-3 / 2, 1e-12);
    test::expect_relative(cycle.torque()(even ? 2 : 3), (soft - K) * 1e-3 * 2 / (3 * pi), 1e-11);
    test::expect_relative(cycle.amplitude(), 1e-3, 1e-14);
  }
}

TEST(TwistCycle, CrosscheckTorqueAgainstAFineSum) {
  // (MO-2, MO-5, MO-9, MO-15): the harmonics against a plain sum of 400 000 points, with z marched
  // over two periods; the tolerance is the error of the sum at corners and turns.
  const ElasticCurve elastic(kPieces, kCrack);
  const BoucWen loop = dahl(1e5, 3);
  const Eigen::VectorXd x = twist_with_harmonics(5, 1.5e-3);
  TwistCycle cycle(elastic, loop, 5, false);
  cycle.evaluate(x);
  const TwistSeries series{x};
  constexpr int kPoints = 400000;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(11);
  double z = 0.0;
  double before = series.at(0.0).value;
  double lowest = 1e9;
  double highest = -1e9;
  for (int round = 0; round < 2; ++round) {
    for (int n = 1; n <= kPoints; ++n) {
      const double angle = 2 * pi * n / kPoints;
      const double twist = series.at(angle).value;
      z = dahl_after(loop, z, twist - before);
      before = twist;
      if (round == 0) continue;
      const double torque = elastic.at(twist).torque + z;
      lowest = std::min(lowest, torque);
      highest = std::max(highest, torque);
      sum(0) += torque / kPoints;
      for (int k = 1; k <= 5; ++k) {
        sum(2 * k - 1) += 2 * torque * std::cos(k * angle) / kPoints;
        sum(2 * k) += 2 * torque * std::sin(k * angle) / kPoints;
      }
    }
  }
  for (Eigen::Index k = 0; k < 11; ++k) EXPECT_NEAR(cycle.torque()(k), sum(k), 2e-8) << k;
  EXPECT_NEAR(cycle.torque_amplitude(), (highest - lowest) / 2, 1e-7);
  EXPECT_NEAR(cycle.loop_at_zero(), z, 1e-7);
}

TEST(TwistCycle, CrosscheckDerivativesAgainstDifferences) {
  // (MO-15): each derivative against a central difference; the tolerance is the error of the
  // difference.
  const BoucWen loops[] = {dahl(1e5, 3),
                           {.stiffness = 1e5, .limit = 3, .exponent = 2, .asymmetry = 0.3},
                           {.stiffness = 6e4, .limit = 2, .exponent = 1, .asymmetry = -0.4}};
  for (const BoucWen& loop : loops)
    for (const double amplitude : {2e-5, 3e-4, 3e-3}) {
      const ElasticCurve elastic(kPieces, kCrack);
      TwistCycle cycle(elastic, loop, 4, false);
      const Eigen::VectorXd x = twist_with_harmonics(4, amplitude);
      cycle.evaluate(x);
      const Eigen::MatrixXd slope = cycle.by_twist();
      const Eigen::VectorXd of_amplitude = cycle.amplitude_slope();
      for (Eigen::Index k = 0; k < 9; ++k) {
        const double h = 1e-6 * amplitude;
        Eigen::VectorXd moved = x;
        moved(k) += h;
        cycle.evaluate(moved);
        const Eigen::VectorXd up = cycle.torque();
        const double wide = cycle.amplitude();
        moved(k) -= 2 * h;
        cycle.evaluate(moved);
        EXPECT_NEAR(of_amplitude(k), (wide - cycle.amplitude()) / (2 * h), 1e-5);
        for (Eigen::Index r = 0; r < 9; ++r)
          EXPECT_NEAR(slope(r, k), (up(r) - cycle.torque()(r)) / (2 * h), 1e-6 * 1e5)
              << "row " << r << " column " << k << " amplitude " << amplitude;
      }
    }
}

TEST(TwistCycle, ReferenceLoopsOfBoucAndWen) {
  // (MO-8): in closed form on one side: n = 2, g = 1/2, rising twist from 0: z = F tanh(q) for
  // z > 0 has dz/dq = 1 - z^2; n = 1, g = 1/2: dz/dq = 1 - z for z > 0 and 1 for z < 0.  1e-8 is
  // what the steps promise.
  const BoucWen square{.stiffness = 2e4, .limit = 2, .exponent = 2, .asymmetry = 0.5};
  const BoucWen hinge{.stiffness = 2e4, .limit = 2, .exponent = 1, .asymmetry = 0.5};
  for (const double q : {0.01, 0.3, 1.0, 4.0}) {
    const LoopStep step = loop_after(square, 0.0, q * 1e-4);
    EXPECT_NEAR(step.torque / 2, std::tanh(q), 1e-8);
    EXPECT_NEAR(step.by_torque, 1 / std::pow(std::cosh(q), 2), 1e-7);
    EXPECT_NEAR(loop_after(square, 0.0, -q * 1e-4).torque / 2, -std::tanh(q), 1e-8);
    EXPECT_NEAR(loop_after(hinge, 0.0, q * 1e-4).torque / 2, 1 - std::exp(-q), 1e-8);
  }
  EXPECT_NEAR(loop_after(hinge, -2.0, 0.5e-4).torque / 2, -0.5, 1e-12);
  EXPECT_NEAR(loop_after(square, -1.0, 1.0).torque, 2.0, 1e-12);
}

TEST(TwistCycle, CrosscheckLoopStepsAgainstTheRate) {
  // (MO-8): steps of the closed forms and of the fourth order against 20 000 steps of Heun with
  // `BoucWen::rate`; the derivative by the start against a difference.
  for (const double exponent : {1.0, 1.5, 2.0, 3.0})
    for (const double asymmetry : {0.5, 0.3, 0.0, -0.6})
      for (const double start : {-1.7, -0.4, 0.0, 1.1})
        for (const double change : {1.3e-4, -0.6e-4, 0.3e-4}) {
          const BoucWen model{
              .stiffness = 2e4, .limit = 2, .exponent = exponent, .asymmetry = asymmetry};
          double z = start;
          const double h = change / 20000;
          for (int n = 0; n < 20000; ++n) {
            const double sense = change > 0 ? 1.0 : -1.0;
            const double first = loop_slope(model, z, sense);
            z += h / 2 * (first + loop_slope(model, z + h * first, sense));
          }
          const LoopStep step = loop_after(model, start, change);
          EXPECT_NEAR(step.torque, z, 2e-8) << exponent << ' ' << asymmetry << ' ' << start;
          const double d = 1e-5;
          const double difference = (loop_after(model, start + d, change).torque -
                                     loop_after(model, start - d, change).torque) /
                                    (2 * d);
          EXPECT_NEAR(step.by_torque, difference, 1e-4) << exponent << ' ' << asymmetry;
        }
}

TEST(TwistCycle, LimitTwistThatStandsStillMeetsTheStiffnessOfTheLoop) {
  // (MO-8): at rest the hysteresis is a spring A.
  const ElasticCurve elastic(LinearSpring{5e4}, {});
  TwistCycle cycle(elastic, dahl(1e5, 3), 3, false);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(7);
  x(0) = 1e-4;
  cycle.evaluate(x);
  EXPECT_NEAR(cycle.torque()(0), 5.0, 1e-12);
  EXPECT_NEAR(cycle.by_twist()(1, 1), 1.5e5, 1e-6);
  EXPECT_EQ(cycle.amplitude(), 0.0);
  EXPECT_EQ(cycle.loop_at_zero(), 0.0);
}

}  // namespace
}  // namespace strainwave
