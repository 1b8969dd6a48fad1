// SPDX-License-Identifier: Apache-2.0
#include "twist_cycle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
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

/// Two slip elements that slip in turn, and one that sticks, for twists of about 1e-3 rad.
const std::vector<SlipElement> kElements = {{4e4, 2.0}, {2e4, 6.0}, {1e4, 90.0}};

TEST(TwistCycle, ReferenceWorkOfSlipElements) {
  // (MO-45, MO-47): W = sum 4 F (X - F/k) over the elements that slip, of one element and of
  // three; and the largest torque sum min(k X, F); rounding.
  for (const std::vector<SlipElement>& elements : {std::vector<SlipElement>{{4e4, 2.0}}, kElements})
    for (const double X : {2e-5, 1e-4, 1e-3}) {
      const ElasticCurve elastic(LinearSpring{1e-9}, {});
      TwistCycle cycle(elastic, {}, 9, false, elements);
      Eigen::VectorXd x = Eigen::VectorXd::Zero(19);
      x(0) = 0.4 * X;
      x(1) = X;
      cycle.evaluate(x);
      double work = 0.0;
      double most = 1e-9 * X;  // of the soft spring
      int slips = 0;
      for (const SlipElement& of : elements) {
        most += std::min(of.stiffness * X, of.limit);
        if (of.limit >= of.stiffness * X) continue;
        work += 4 * of.limit * (X - of.limit / of.stiffness);
        slips += 2;  // at each of two turns
      }
      EXPECT_NEAR(-pi * X * cycle.torque()(2), work, 1e-12 * 4 * most * X);
      test::expect_relative(cycle.torque_amplitude(), most, 1e-13);
      EXPECT_EQ(cycle.slips(), slips);
      // The loop is symmetric, so it has no mean.
      EXPECT_NEAR(cycle.torque()(0), 1e-9 * x(0), 1e-12 * most);
    }
}

TEST(TwistCycle, ReferenceDescribingFunctionOfASlipElement) {
  // (MO-44, MO-47): under X cos tau the element sticks from tau = 0 to theta, where
  // k X (1 - cos theta) = 2 F, and then bears -F.  Its first harmonic has the cosine
  // k X (theta - sin theta cos theta)/pi and the sine -k X sin^2 theta/pi, by integration of
  // these two pieces; rounding.
  const double k = 4e4;
  const double F = 2.0;
  for (const double X : {5.0001e-5, 7e-5, 1e-4, 1e-3, 0.1}) {
    const ElasticCurve elastic(LinearSpring{1e-9}, {});
    TwistCycle cycle(elastic, {}, 9, false, {{k, F}});
    Eigen::VectorXd x = Eigen::VectorXd::Zero(19);
    x(1) = X;
    cycle.evaluate(x);
    const double theta = std::acos(1 - 2 * F / (k * X));
    const double sine = std::sin(theta);
    EXPECT_NEAR(cycle.torque()(1), 1e-9 * X + k * X / pi * (theta - sine * std::cos(theta)),
                1e-11 * F);
    EXPECT_NEAR(cycle.torque()(2), -k * X / pi * sine * sine, 1e-11 * F);
  }
}

TEST(TwistCycle, CrosscheckSlipElementsAgainstAFineSum) {
  // (MO-2, MO-44, MO-47): the harmonics against a plain sum of 400 000 points of a twist with inner
  // turns.  The elements are marched from a twist that swings out and decays, so the one that
  // sticks bears nothing in the middle of the range; the tolerance is the error of the sum.
  const ElasticCurve elastic(kPieces, kCrack);
  Eigen::VectorXd x = twist_with_harmonics(3, 1e-3);
  x(5) = 9e-4;  // a third harmonic that makes inner turns
  TwistCycle cycle(elastic, {}, 3, false, kElements);
  cycle.evaluate(x);
  const TwistSeries series{x};
  constexpr int kPoints = 400000;
  double low = 1e9;
  double high = -1e9;
  for (int n = 0; n < kPoints; ++n) {
    const double twist = series.at(2 * pi * n / kPoints).value;
    low = std::min(low, twist);
    high = std::max(high, twist);
  }
  SlipState state = relaxed(kElements, (low + high) / 2);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(7);
  double least = 1e9;
  double most = -1e9;
  int turns = 0;
  double rate = 0.0;
  for (int round = 0; round < 2; ++round)
    for (int n = 1; n <= kPoints; ++n) {
      const double angle = 2 * pi * n / kPoints;
      const TwistSeries::At at = series.at(angle);
      state = slip_after(kElements, state, at.value);
      if (round == 0) continue;
      turns += n > 1 && (at.slope > 0) != (rate > 0) ? 1 : 0;
      rate = at.slope;
      const double torque = elastic.at(at.value).torque + slip_torque(kElements, state, at.value);
      least = std::min(least, torque);
      most = std::max(most, torque);
      sum(0) += torque / kPoints;
      for (int k = 1; k <= 3; ++k) {
        sum(2 * k - 1) += 2 * torque * std::cos(k * angle) / kPoints;
        sum(2 * k) += 2 * torque * std::sin(k * angle) / kPoints;
      }
    }
  EXPECT_GE(turns, 4);
  for (Eigen::Index k = 0; k < 7; ++k) EXPECT_NEAR(cycle.torque()(k), sum(k), 2e-8 * most) << k;
  EXPECT_NEAR(cycle.torque_amplitude(), (most - least) / 2, 1e-7 * most);
  const SlipState own = cycle.slip_at_zero();
  for (std::size_t j = 0; j < kElements.size(); ++j)
    EXPECT_NEAR(own.torque[j], state.torque[j], 1e-7 * most) << j;
}

TEST(TwistCycle, CrosscheckDerivativesWithSlipElements) {
  // (MO-47): each derivative against a central difference, with two turns and with inner turns,
  // also beside a hysteresis of Dahl; the tolerance is the error of the difference.
  for (const bool with_loop : {false, true})
    for (const double inner : {0.0, 0.9})
      for (const double amplitude : {2e-5, 3e-4, 3e-3}) {
        const ElasticCurve elastic(kPieces, kCrack);
        const std::optional<BoucWen> loop =
            with_loop ? std::optional<BoucWen>(dahl(1e5, 3)) : std::nullopt;
        TwistCycle cycle(elastic, loop, 4, false, kElements);
        Eigen::VectorXd x = twist_with_harmonics(4, amplitude);
        x(5) += inner * amplitude;
        cycle.evaluate(x);
        const Eigen::MatrixXd slope = cycle.by_twist();
        const Eigen::VectorXd harmonics = cycle.torque();
        for (Eigen::Index k = 0; k < 9; ++k) {
          const double h = 1e-6 * amplitude;
          Eigen::VectorXd moved = x;
          moved(k) += h;
          cycle.evaluate(moved);
          const Eigen::VectorXd up = cycle.torque();
          moved(k) -= 2 * h;
          cycle.evaluate(moved);
          for (Eigen::Index r = 0; r < 9; ++r)
            EXPECT_NEAR(slope(r, k), (up(r) - cycle.torque()(r)) / (2 * h), 2e-6 * 1e5)
                << "row " << r << " column " << k << " amplitude " << amplitude << ' ' << inner;
        }
      }
}

/// A table over torque and one angle, with a step near zero and a stiffening twist.
EnergyTable bent_table() {
  const std::vector<double> torques = {-100, -40, -10, -2, 2, 10, 40, 100};
  EnergySamples samples{.rate = 1.3, .period = 0.7, .energy = {}, .twist = {}, .compliance = {}};
  for (int q = 0; q < 12; ++q) {
    const double wave = std::cos(2 * pi * q / 12);
    std::vector<double> twist;
    for (const double T : torques)
      twist.push_back(3e-5 * T / (1 + std::abs(T) / 90) + (T > 0 ? 2e-5 : -2e-5) +
                      wave * (2e-7 * T + 1e-5));
    const std::vector<double> slopes = rising_slopes(torques, twist);
    samples.energy.push_back(1e-4);
    samples.twist.insert(samples.twist.end(), twist.begin(), twist.end());
    samples.compliance.insert(samples.compliance.end(), slopes.begin(), slopes.end());
  }
  return {torques, {samples}, 4e-6};
}

TEST(TwistCycle, CrosscheckCurveOfATableAgainstItsSlice) {
  // (MO-25, MO-26, MO-28): torque and tangent of any twist by the table's own solver, with a crack
  // of one sense about the place of rest, and beyond the table; rounding.
  const EnergyTable table = bent_table();
  const EnergyTable::Slice slice = table.at(0.0);
  const ElasticCurve curve(slice, table.torques(), kCrack);
  const ElasticCurve sound(slice, table.torques(), {});
  for (int n = -400; n <= 400; ++n) {
    const double twist = n * 1.1e-5 + 1e-7;
    const double in_series = twist > slice.rest() ? 4e-6 : 0.0;
    const EnergyTable::At at = slice.at_twist(twist, in_series);
    EXPECT_NEAR(curve.at(twist).torque, at.torque, 1e-12 * (1 + std::abs(at.torque)));
    test::expect_relative(curve.at(twist).tangent, 1 / at.compliance, 1e-9);
    EXPECT_NEAR(sound.at(twist).torque, slice.at_twist(twist).torque, 1e-10);
    EXPECT_NEAR(curve.twist_under(at.torque), twist, 1e-15);
  }
  EXPECT_EQ(curve.twist_under(0.0), slice.rest());
  EXPECT_GT(std::abs(slice.rest()), 1e-6);
  EXPECT_EQ(curve.corners().size(), 9U);
}

TEST(TwistCycle, CrosscheckHarmonicsOfATableAgainstAFineSum) {
  // (MO-28): the harmonics of the torque against a plain sum of 100 000 points; the tolerance is
  // that of Gauss' rule in the pieces of the table.
  const EnergyTable table = bent_table();
  const EnergyTable::Slice slice = table.at(0.0);
  const ElasticCurve elastic(slice, table.torques(), {});
  TwistCycle cycle(elastic, {}, 4, false);
  const Eigen::VectorXd x = twist_with_harmonics(4, 1e-3);
  cycle.evaluate(x);
  constexpr int kPoints = 100000;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(9);
  for (int n = 0; n < kPoints; ++n) {
    const double angle = 2 * pi * n / kPoints;
    const double torque = slice.at_twist(TwistSeries{x}.at(angle).value).torque;
    sum(0) += torque / kPoints;
    for (int k = 1; k <= 4; ++k) {
      sum(2 * k - 1) += 2 * torque * std::cos(k * angle) / kPoints;
      sum(2 * k) += 2 * torque * std::sin(k * angle) / kPoints;
    }
  }
  for (Eigen::Index k = 0; k < 9; ++k) EXPECT_NEAR(cycle.torque()(k), sum(k), 1e-6) << k;
}

TEST(TwistCycle, LimitStandingTwistMeetsSlipElementsAsSprings) {
  // (MO-47): at rest the elements are springs about the mean, so they do not bear the mean.
  const ElasticCurve elastic(LinearSpring{5e4}, {});
  TwistCycle cycle(elastic, {}, 3, false, kElements);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(7);
  x(0) = 1e-4;
  cycle.evaluate(x);
  EXPECT_NEAR(cycle.torque()(0), 5.0, 1e-12);
  EXPECT_NEAR(cycle.by_twist()(0, 0), 5e4, 1e-6);
  EXPECT_NEAR(cycle.by_twist()(1, 1), 1.2e5, 1e-6);
  EXPECT_EQ(cycle.slip_at_zero(), relaxed(kElements, 1e-4));
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
