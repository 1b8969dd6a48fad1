// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/order_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Angles of a number of turns from 17.3 rad on, whose speed swings by 20 %, in steps of about
/// 0.01 turn.
std::vector<double> angles(double turns, double direction = 1.0) {
  std::vector<double> made;
  const auto n = static_cast<int>(turns * 100);
  for (int k = 0; k <= n; ++k) {
    const double even = 2 * pi * turns * k / n;
    made.push_back(17.3 + direction * (even + 0.2 / 3 * std::sin(3 * even)));
  }
  return made;
}

std::vector<double> signal_of(const std::vector<double>& at, auto f) {
  std::vector<double> made;
  for (const double angle : at) made.push_back(f(angle));
  return made;
}

TEST(OrderSpectrum, IdentityLinesMeanAndDrift) {
  // (MO-20): the fit contains the signal, so amplitudes and phases return; 1e-10 is the rounding of
  // the normal equations.  Falling angles give the lines of the same function.
  for (const double direction : {1.0, -1.0}) {
    const std::vector<double> at = angles(120, direction);
    const auto f = [](double angle) {
      return 3.0 + 1e-3 * angle + 0.5 * std::cos(2 * angle - 0.4) +
             0.02 * std::cos(2.02 * angle + 1.3) + 1e-3 * std::cos(6.5 * angle);
    };
    const std::vector<double> orders = {2, 2.02, 6.5, 1};
    const OrderSpectrum made = order_spectrum(at, signal_of(at, f), orders);
    EXPECT_NEAR(made.turns, 120, 1e-9);
    ASSERT_EQ(made.lines.size(), 4U);
    const std::vector<double> amplitude = {0.5, 0.02, 1e-3, 0.0};
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_TRUE(made.lines[k].separate);
      EXPECT_EQ(made.lines[k].order, orders[k]);
      EXPECT_NEAR(made.lines[k].amplitude, amplitude[k], 1e-10);
    }
    EXPECT_NEAR(made.lines[0].phase, 0.4, 1e-9);
    EXPECT_NEAR(made.lines[1].phase, -1.3, 1e-8);
    EXPECT_LT(made.floor, 1e-10);
  }
}

TEST(OrderSpectrum, BehaviourLinesThatTheTurnsDoNotSeparate) {
  // 2 and 2.02 need 2/0.02 = 100 turns, an order of 0.01 needs 200; order 2 twice is one line.
  const std::vector<double> at = angles(99);
  const std::vector<double> signal = signal_of(at, [](double a) { return std::cos(2 * a); });
  const std::vector<double> orders = {2, 2.02, 0.01, 2};
  const OrderSpectrum made = order_spectrum(at, signal, orders);
  EXPECT_TRUE(made.lines[0].separate);
  EXPECT_NEAR(made.lines[0].turns_needed, 1.0, 1e-12);
  EXPECT_NEAR(made.lines[0].amplitude, 1.0, 1e-10);
  for (const std::size_t k : {1U, 2U, 3U}) {
    EXPECT_FALSE(made.lines[k].separate);
    EXPECT_EQ(made.lines[k].amplitude, 0.0);
  }
  EXPECT_NEAR(made.lines[1].turns_needed, 100.0, 1e-9);
  EXPECT_NEAR(made.lines[2].turns_needed, 200.0, 1e-9);
  EXPECT_EQ(made.lines[3].turns_needed, std::numeric_limits<double>::infinity());
  // One turn more is enough.
  const std::vector<double> longer = angles(100);
  EXPECT_TRUE(
      order_spectrum(longer, signal_of(longer, [](double a) { return std::cos(a); }), orders)
          .lines[1]
          .separate);
}

TEST(OrderSpectrum, IdentityFloorOfNoise) {
  // Independent noise of a standard deviation s has, at any order, an amplitude by Rayleigh's
  // distribution with the median 2 s sqrt(ln 2 * sum of w^2)/(sum of w); for Hann's weights
  // the sum of w^2 is 3/8 N and that of w is N/2.  The median of about 90 probes, of which about
  // every second one is independent, scatters by 15 %, and the mean of 60 such medians by 2 %;
  // 6 % is three of these.
  const std::vector<double> at = angles(40);
  const std::vector<double> orders = {2.0, 5.0};
  const double s = 0.01;
  const double n = static_cast<double>(at.size());
  const double expected = 2 * s * std::sqrt(std::numbers::ln2 * 0.375 * n) / (n / 2);
  double sum = 0.0;
  const std::uint64_t draws = 60;
  for (std::uint64_t draw = 0; draw < draws; ++draw) {
    std::vector<double> signal;
    for (std::size_t k = 0; k < at.size(); ++k)
      signal.push_back(std::cos(2 * at[k]) + s * counter_normal(7 + draw, k, 0));
    const OrderSpectrum made = order_spectrum(at, signal, orders);
    EXPECT_NEAR(made.lines[0].amplitude, 1.0, 10 * expected);
    sum += made.floor;
  }
  EXPECT_NEAR(sum / static_cast<double>(draws), expected, 0.06 * expected);
}

TEST(OrderSpectrum, BehaviourTheFloorIsThatOfTheOrdersBelow) {
  // Lines of the amplitude 1e-3 at each 0.05 up to the order 4, closer than 40 turns separate: the
  // floor up to 6.25 is of their size, because two thirds of the orders are theirs.  A search above
  // the line of order 5 alone would find next to nothing.
  const std::vector<double> at = angles(40);
  std::vector<double> signal(at.size(), 0.0);
  for (std::uint64_t line = 1; line <= 80; ++line) {
    const double phase = 2 * pi * counter_uniform(3, line, 0);
    for (std::size_t n = 0; n < at.size(); ++n)
      signal[n] += 1e-3 * std::cos(0.05 * static_cast<double>(line) * at[n] + phase);
  }
  const double floor = order_spectrum(at, signal, std::vector<double>{5.0}).floor;
  EXPECT_GT(floor, 0.3e-3);
  EXPECT_LT(floor, 2e-3);
}

TEST(OrderSpectrum, LimitALineActsLittleOnOrdersFarAway) {
  // Hann's weights: far from a line the rest falls with the cube of the distance, and 100 times
  // the spacing leaves far less than 1e-5.  Even weights would leave 3e-3.
  const std::vector<double> at = angles(40);
  const OrderSpectrum made = order_spectrum(
      at, signal_of(at, [](double a) { return std::cos(3.3 * a); }), std::vector<double>{9.0});
  EXPECT_LT(made.floor, 1e-5);
  EXPECT_LT(made.lines[0].amplitude, 1e-5);
}

TEST(OrderSpectrum, IdentityOfSumsThatGoOn) {
  // (MO-20, MO-22): sums of two signals that were kept in the middle are those of one go, bit for
  // bit, and each signal has the lines that it has alone.
  const std::vector<double> at = angles(30);
  const std::vector<double> one = signal_of(at, [](double a) { return 5 + std::cos(2 * a); });
  const std::vector<double> two = signal_of(at, [](double a) { return std::sin(3.5 * a); });
  const std::vector<double> orders = {2, 3.5};
  OrderSums whole(orders, 2);
  OrderSums before(orders, 2);
  OrderSums after(orders, 2);
  for (std::size_t n = 0; n < at.size(); ++n) {
    const double share = static_cast<double>(n) / static_cast<double>(at.size() - 1);
    const std::vector<double> values = {one[n], two[n]};
    whole.add(share, at[n], values);
    if (n == 1234) after.restore(before.numbers());
    (n < 1234 ? before : after).add(share, at[n], values);
  }
  EXPECT_EQ(after.numbers(), whole.numbers());
  EXPECT_EQ(whole.count(), static_cast<double>(at.size()));
  EXPECT_EQ(whole.whole(), at.back() - at.front());
  for (const std::size_t signal : {0U, 1U}) {
    const OrderSpectrum made = whole.spectrum(signal);
    const OrderSpectrum alone = order_spectrum(at, signal == 0 ? one : two, orders);
    for (const std::size_t k : {0U, 1U}) {
      EXPECT_NEAR(made.lines[k].amplitude, signal == k ? 1.0 : 0.0, 1e-12);
      EXPECT_NEAR(made.lines[k].amplitude, alone.lines[k].amplitude, 1e-13);
    }
    EXPECT_NEAR(made.floor, alone.floor, 1e-13);
  }
  OrderSums turned(orders, 1);
  EXPECT_FALSE(turned.turns_on());
  for (const double angle : {0.0, 1.0, 2.0, 1.5, 3.0, 4.0, 5.0, 6.0, 7.0})
    turned.add(0.5, angle, std::vector<double>{angle});
  EXPECT_FALSE(turned.turns_on());
  EXPECT_NE(test::broken_rule([&] { (void)turned.spectrum(0); }).find("must rise, or fall"),
            std::string::npos);
  EXPECT_NE(test::broken_rule([&] { turned.restore({1.0}); }).find("has other orders"),
            std::string::npos);
  EXPECT_NE(test::broken_rule([&] {
              (void)OrderSums(orders, 1).spectrum(0);
            }).find("at least four values more"),
            std::string::npos);
}

TEST(OrderSpectrum, InputEachRuleBrokenOnce) {
  const std::vector<double> at = angles(10);
  const std::vector<double> orders = {2};
  const auto broken = [&](std::vector<double> angle, std::vector<double> signal,
                          const std::vector<double>& lines) {
    return test::broken_rule([&] { (void)order_spectrum(angle, signal, lines); });
  };
  const std::vector<double> signal(at.size(), 1.0);
  EXPECT_EQ(broken(at, signal, orders), "no error");
  EXPECT_NE(broken(at, {1.0}, orders).find("signal: must have as many"), std::string::npos);
  EXPECT_NE(broken({0, 1, 2}, {0, 1, 2}, orders).find("angle: must have at least four"),
            std::string::npos);
  std::vector<double> turned = at;
  turned[5] = turned[4];
  EXPECT_NE(broken(turned, signal, orders).find("angle: must rise"), std::string::npos);
  std::vector<double> falling;
  for (const double angle : at) falling.push_back(-angle);
  EXPECT_EQ(broken(falling, signal, orders), "no error");
  falling[5] = falling[4];
  EXPECT_NE(broken(falling, signal, orders).find("angle: must rise, or fall"), std::string::npos);
  std::vector<double> unknown = signal;
  unknown[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(broken(at, unknown, orders).find("signal: must have finite"), std::string::npos);
  EXPECT_NE(broken(at, signal, {0.0}).find("order"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
