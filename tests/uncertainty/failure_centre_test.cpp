// SPDX-License-Identifier: Apache-2.0
// Draws about the failures.
#include "strainwave/uncertainty/failure_centre.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr std::array kDirection = {0.6, 0.0, -0.8};

double along(std::span<const double> u) {
  return kDirection[0] * u[0] + kDirection[1] * u[1] + kDirection[2] * u[2];
}

/// Fails beyond a plane.
LimitState beyond_plane(double distance) {
  return [distance](std::span<const double> u) -> std::optional<double> {
    return distance - along(u);
  };
}

FailureCentre centre_of(const LimitState& margin, SamplingOptions options = {.draws = 1000}) {
  return find_failure_centre([&] { return margin; }, 3, options);
}

// Kind: reference (UQ-10).  Beyond a plane the mean of the failures is phi(b)/Phi(-b) along its
// normal.  Tolerance: 0.35, five standard errors of the mean of some 100 weighted draws.
TEST(FailureCentre, ReferenceAPlane) {
  for (const double distance : {0.0, 2.0, 4.0, 6.0}) {
    const FailureCentre centre = centre_of(beyond_plane(distance));
    ASSERT_TRUE(centre.found) << centre.reason;
    const double mean = normal_density(distance) / normal_probability(-distance);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(centre.place[i], mean * kDirection[i], 0.35) << distance;
  }
}

// Kind: identity (UQ-10).  Only the order of the margins and their sign count; drives without an
// end are the last.
TEST(FailureCentre, IdentityOnlyTheOrderCounts) {
  const FailureCentre smooth = centre_of(beyond_plane(3));
  const FailureCentre cubed = centre_of(
      [](std::span<const double> u) -> std::optional<double> { return std::pow(3 - along(u), 3); });
  const FailureCentre endless = centre_of([](std::span<const double> u) -> std::optional<double> {
    return along(u) < 0 ? std::numeric_limits<double>::infinity() : 3 - along(u);
  });
  ASSERT_TRUE(smooth.found);
  EXPECT_EQ(smooth.place, cubed.place);
  EXPECT_EQ(smooth.place, endless.place);
  EXPECT_EQ(smooth.place, centre_of(beyond_plane(3), {.draws = 1000, .threads = 3}).place);
  EXPECT_NE(smooth.place, centre_of(beyond_plane(3), {.draws = 1000, .seed = 2}).place);
  EXPECT_GT(smooth.rounds, 2);
}

// Kind: behaviour.  A search without an answer says why.
TEST(FailureCentre, BehaviourWithoutFailures) {
  const auto reason = [](const LimitState& margin) {
    const FailureCentre centre = centre_of(margin, {.draws = 100});
    EXPECT_FALSE(centre.found);
    EXPECT_TRUE(centre.place.empty());
    return centre.reason;
  };
  EXPECT_EQ(reason(beyond_plane(9)),
            "no failure is nearer than 8 standard deviations of the inputs");
  EXPECT_EQ(reason([](std::span<const double>) { return std::optional(1.0); }),
            "20 rounds of draws do not reach the failures");
  EXPECT_EQ(reason([](std::span<const double> u) -> std::optional<double> {
              if (u[0] > -1.5) return std::nullopt;
              return 1 - u[1];
            }),
            "fewer than a tenth of the drawn drives have an end");
}

// Kind: identity (UQ-11).  The weight is the ratio of the densities, and that of the centre.
TEST(FailureCentre, IdentityWeight) {
  const std::vector<double> centre = {1.5, -2.0, 0.5};
  const auto density = [](double x, double y, double z) {
    return normal_density(x) * normal_density(y) * normal_density(z);
  };
  for (const std::array<double, 3> u :
       {std::array{0.0, 0.0, 0.0}, std::array{1.5, -2.0, 0.5}, std::array{-1.0, 0.3, 2.0}}) {
    const double plain = density(u[0], u[1], u[2]);
    const double about = density(u[0] - centre[0], u[1] - centre[1], u[2] - centre[2]);
    test::expect_relative(mixture_weight(u, centre), 2 * plain / (plain + about), 1e-12);
  }
  const std::vector<double> nowhere = {0.0, 0.0, 0.0};
  EXPECT_EQ(mixture_weight(std::array{3.0, 1.0, -2.0}, nowhere), 1);
}

// Kind: cross-check (UQ-11).  Half of the draws about the centre resolve Phi(-4) = 3.167e-5, and
// leave the mean of a common quantity as it is.  Tolerance: four standard errors.
TEST(FailureCentre, CrosscheckARareAndACommonMean) {
  const std::vector<double> centre = centre_of(beyond_plane(4)).place;
  constexpr std::size_t kDraws = 4000;
  double failed = 0.0;
  double squares = 0.0;
  double square_of_first = 0.0;
  for (std::size_t n = 0; n < kDraws; ++n) {
    std::array<double, 3> u = {};
    for (std::size_t i = 0; i < 3; ++i)
      u[i] = counter_normal(7, n, i) + (n % 2 == 1 ? centre[i] : 0.0);
    const double weight = mixture_weight(u, centre);
    if (along(u) > 4) {
      failed += weight;
      squares += weight * weight;
    }
    square_of_first += weight * u[0] * u[0];
  }
  const double exact = normal_probability(-4);
  EXPECT_NEAR(failed / kDraws, exact, 4 * std::sqrt(squares) / kDraws);
  EXPECT_LT(std::sqrt(squares) / kDraws, 0.06 * exact);
  EXPECT_NEAR(square_of_first / kDraws, 1, 4 * std::sqrt(2.0 / (kDraws / 2.0)));
}

}  // namespace
}  // namespace strainwave
