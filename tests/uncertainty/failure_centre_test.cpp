// SPDX-License-Identifier: Apache-2.0
// Draws about the failures.
#include "strainwave/uncertainty/failure_centre.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "strainwave/uncertainty/sampled_probability.hpp"
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

FailureCentres centres_of(const LimitState& margin, SamplingOptions options = {.draws = 1000}) {
  return find_failure_centres([&] { return margin; }, 3, options);
}

// Kind: reference (UQ-10).  Beyond a plane the mean of the failures is phi(b)/Phi(-b) along its
// normal, and the search finds no other centre.  Tolerance: 0.35; this is five standard errors of a
// mean of some 100 weighted draws.
TEST(FailureCentre, ReferenceAPlane) {
  for (const double distance : {1.0, 2.0, 4.0, 6.0}) {
    const FailureCentres found = centres_of(beyond_plane(distance));
    ASSERT_EQ(found.places.size(), 1U) << found.reason << distance;
    EXPECT_TRUE(found.reason.empty());
    const double mean = normal_density(distance) / normal_probability(-distance);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(found.places[0][i], mean * kDirection[i], 0.35) << distance;
  }
}

// Kind: reference (UQ-10).  Two causes of failure have two centres, each the mean beyond its plane.
// A cause that is so rare that it hardly adds to the probability has none.
TEST(FailureCentre, ReferenceTwoPlanes) {
  const auto either = [](double first, double second) -> LimitState {
    return [=](std::span<const double> u) -> std::optional<double> {
      return std::min(first - u[0], second + u[1]);
    };
  };
  const FailureCentres two = centres_of(either(3.5, 3.5));
  ASSERT_EQ(two.places.size(), 2U);
  const double mean = normal_density(3.5) / normal_probability(-3.5);
  const bool swapped = two.places[0][0] < 1;
  EXPECT_NEAR(two.places[swapped ? 1 : 0][0], mean, 0.35);
  EXPECT_NEAR(two.places[swapped ? 0 : 1][1], -mean, 0.35);
  for (const std::vector<double>& place : two.places) {
    EXPECT_NEAR(std::hypot(place[0], place[1], place[2]), mean, 0.35);
    EXPECT_NEAR(place[2], 0, 0.35);
  }
  EXPECT_EQ(centres_of(either(3.0, 6.0)).places.size(), 1U);
}

// Kind: limit (UQ-10).  The heaviest failure of the search is about on the limit, where the weight
// is that at the design point.
TEST(FailureCentre, LimitHeaviestFailure) {
  const FailureCentres found = centres_of(beyond_plane(4));
  const std::vector<double> design = {4 * kDirection[0], 0.0, 4 * kDirection[2]};
  const double there = mixture_weight(design, found.places);
  EXPECT_GT(found.heaviest, there);
  EXPECT_LT(found.heaviest, 30 * there);
}

// Kind: identity (UQ-10).  Only the order of the margins and their sign count; drives without an
// end are the last.
TEST(FailureCentre, IdentityOnlyTheOrderCounts) {
  const FailureCentres smooth = centres_of(beyond_plane(3));
  const FailureCentres cubed = centres_of(
      [](std::span<const double> u) -> std::optional<double> { return std::pow(3 - along(u), 3); });
  const FailureCentres endless = centres_of([](std::span<const double> u) -> std::optional<double> {
    return along(u) < 0 ? std::numeric_limits<double>::infinity() : 3 - along(u);
  });
  ASSERT_EQ(smooth.places.size(), 1U);
  EXPECT_EQ(smooth.places, cubed.places);
  EXPECT_EQ(smooth.places, endless.places);
  EXPECT_EQ(smooth.places, centres_of(beyond_plane(3), {.draws = 1000, .threads = 3}).places);
  EXPECT_NE(smooth.places, centres_of(beyond_plane(3), {.draws = 1000, .seed = 2}).places);
  EXPECT_GT(smooth.rounds, 2);
}

// Kind: reference (UQ-10).  One drive of fifty has an end, and the search still finds the failures.
TEST(FailureCentre, ReferenceFewDrivesWithAnEnd) {
  const FailureCentres found = centres_of(
      [](std::span<const double> u) -> std::optional<double> {
        if (along(u) < 2.054) return std::numeric_limits<double>::infinity();
        return 4 - along(u);
      },
      {.draws = 200});
  ASSERT_EQ(found.places.size(), 1U) << found.reason;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.places[0][i], 4.2256 * kDirection[i], 0.8);
}

// Kind: behaviour.  A search without an answer says why.
TEST(FailureCentre, BehaviourWithoutFailures) {
  const auto reason = [](const LimitState& margin) {
    const FailureCentres found = centres_of(margin, {.draws = 100});
    EXPECT_TRUE(found.places.empty());
    return found.reason;
  };
  EXPECT_EQ(reason(beyond_plane(9)),
            "no failure is nearer than 8 standard deviations of the inputs");
  EXPECT_EQ(reason([](std::span<const double>) { return std::optional(1.0); }),
            "20 rounds of draws do not reach the failures");
  EXPECT_EQ(centres_of([](std::span<const double>) { return std::optional(1.0); }).rounds, 20);
  EXPECT_EQ(reason([](std::span<const double>) -> std::optional<double> { return std::nullopt; }),
            "no drawn drive has an end of its life");
}

// Kind: behaviour.  The progress never falls and stays within the whole, and a stop is heard.
TEST(FailureCentre, BehaviourProgress) {
  double last = 0.0;
  const auto make = [] { return beyond_plane(4); };
  const Progress told([&](double share) {
    EXPECT_GE(share, last);
    last = share;
    return true;
  });
  const FailureCentres found = find_failure_centres(make, 3, {.draws = 100, .threads = 1}, told);
  EXPECT_NEAR(last, found.rounds / 80.0, 1e-12);  // of four searches of at most 20 rounds
  const Progress stop([](double) { return false; });
  EXPECT_THROW((void)find_failure_centres(make, 3, {.draws = 100}, stop), Stopped);
}

// Kind: identity (UQ-11).  The weight is the ratio of the densities.
TEST(FailureCentre, IdentityWeight) {
  const std::vector<std::vector<double>> centres = {{1.5, -2.0, 0.5}, {0.0, 3.0, -1.0}};
  const auto density = [](const std::array<double, 3>& u, const std::vector<double>& at) {
    return normal_density(u[0] - at[0]) * normal_density(u[1] - at[1]) *
           normal_density(u[2] - at[2]);
  };
  const std::vector<double> origin = {0.0, 0.0, 0.0};
  for (const std::array<double, 3>& u :
       {std::array{0.0, 0.0, 0.0}, std::array{1.5, -2.0, 0.5}, std::array{-1.0, 0.3, 2.0}}) {
    const double plain = density(u, origin);
    const double all = plain + density(u, centres[0]) + density(u, centres[1]);
    test::expect_relative(mixture_weight(u, centres), 3 * plain / all, 1e-12);
  }
  EXPECT_EQ(mixture_weight(std::array{3.0, 1.0, -2.0}, {}), 1);
}

// Kind: cross-check (UQ-11).  Draws about the centres resolve Phi(-4) + Phi(-4.2), and leave the
// mean of a common quantity as it is.  Tolerance: four standard errors.
TEST(FailureCentre, CrosscheckARareAndACommonMean) {
  const LimitState either = [](std::span<const double> u) -> std::optional<double> {
    return std::min(4 - u[0], 4.2 - u[1]);
  };
  const std::vector<std::vector<double>> centres = centres_of(either).places;
  ASSERT_EQ(centres.size(), 2U);
  constexpr std::size_t kDraws = 6000;
  double failed = 0.0;
  double squares = 0.0;
  double square_of_first = 0.0;
  for (std::size_t n = 0; n < kDraws; ++n) {
    std::array<double, 3> u = {};
    for (std::size_t i = 0; i < 3; ++i)
      u[i] = counter_normal(7, n, i) + (n % 3 == 0 ? 0.0 : centres[n % 3 - 1][i]);
    const double weight = mixture_weight(u, centres);
    if (*either(u) < 0) {
      failed += weight;
      squares += weight * weight;
    }
    square_of_first += weight * u[0] * u[0];
  }
  const double exact = normal_probability(-4) + normal_probability(-4.2);
  EXPECT_NEAR(failed / kDraws, exact, 4 * std::sqrt(squares) / kDraws);
  EXPECT_LT(std::sqrt(squares) / kDraws, 0.06 * exact);
  EXPECT_NEAR(square_of_first / kDraws, 1, 4 * std::sqrt(2.0 / (kDraws / 3.0)));
}

// Kind: reference (UQ-11).  Two planes by draws about the origin and about both design points:
// Phi(-4) + Phi(-4.2) less the product.  Draws about one of them alone miss the other.  The answer
// is the same for any number of threads.  Tolerance: four standard errors.
TEST(FailureCentre, ReferenceMixtureSampling) {
  const LimitState either = [](std::span<const double> u) -> std::optional<double> {
    return std::min(4 - u[0], 4.2 - u[1]);
  };
  const auto make = [&] { return either; };
  const std::vector<std::vector<double>> both = {{4.0, 0.0}, {0.0, 4.2}};
  const double one = normal_probability(-4);
  const double other = normal_probability(-4.2);
  const SampledProbability two = mixture_sampling(make, both, {.draws = 20000});
  EXPECT_NEAR(two.probability, one + other - one * other, 4 * two.standard_error);
  EXPECT_LT(two.standard_error, 0.03 * (one + other));
  EXPECT_GT(two.low, one);
  EXPECT_LE(two.low, one + other);
  EXPECT_GE(two.high, one + other);
  // About a third of the draws scatter about each centre, and half of these fail.
  EXPECT_NEAR(static_cast<double>(two.failures) / 20000, 1.0 / 3, 0.02);
  const SampledProbability first = mixture_sampling(make, {both[0]}, {.draws = 20000});
  EXPECT_NEAR(first.probability, one, 4 * first.standard_error);
  const SampledProbability threads = mixture_sampling(make, both, {.draws = 20000, .threads = 2});
  EXPECT_EQ(threads.probability, two.probability);
  // Another seed gives other draws.
  EXPECT_NE(mixture_sampling(make, both, {.draws = 20000, .seed = 2}).probability, two.probability);
}

// Kind: reference (UQ-11).  Draws without a value count as failures in the upper limit alone, by
// their weight.  Tolerance: four standard errors.
TEST(FailureCentre, ReferenceMixtureWithoutAValue) {
  const LimitState limit = [](std::span<const double> u) -> std::optional<double> {
    if (u[0] > 3) return std::nullopt;
    return 2 - u[0];
  };
  const double beyond = normal_probability(-3);
  const double failed = normal_probability(-2) - beyond;
  const SampledProbability about =
      mixture_sampling([&] { return limit; }, {{2.0}}, {.draws = 100000});
  EXPECT_NEAR(about.probability, failed, 4 * about.standard_error);
  EXPECT_GT(about.without_value, 5000U);
  EXPECT_NEAR(about.high - about.probability, beyond + 1.96 * about.standard_error, 1e-4);
  EXPECT_NEAR(about.probability - about.low, 1.96 * about.standard_error, 1e-6);
}

}  // namespace
}  // namespace strainwave
