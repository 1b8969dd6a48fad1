// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/core/correlated_normals.hpp"
#include "strainwave/uncertainty/design_point.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "strainwave/uncertainty/sampled_probability.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

std::vector<double> origin(std::size_t inputs) { return std::vector<double>(inputs, 0.0); }

LimitState plane(double distance) {
  return [distance](std::span<const double> z) -> std::optional<double> {
    return distance - (3 * z[0] - 4 * z[1]) / 5;
  };
}

// Kind: reference (UQ-4).  A plane at a distance: beta is the distance, and every road is exact.
TEST(Reliability, ReferenceAPlaneLimit) {
  for (const double distance : {3.0, 0.5, -1.5}) {
    const LimitState limit = plane(distance);
    const DesignPoint point = find_design_point(limit, origin(2));
    ASSERT_TRUE(point.converged) << point.reason;
    EXPECT_NEAR(point.reliability_index, distance, 1e-9);
    EXPECT_NEAR(point.place[0], 0.6 * distance, 1e-6);
    EXPECT_NEAR(point.place[1], -0.8 * distance, 1e-6);
    EXPECT_NEAR(point.normal[0], 0.6, 1e-9);
    test::expect_relative(point.probability(), normal_probability(-distance), 1e-8);
    const CurvedLimit curved = curved_limit(limit, point);
    ASSERT_TRUE(curved.probability);
    EXPECT_NEAR(curved.curvatures[0], 0, 1e-6);
    test::expect_relative(*curved.probability, point.probability(), 1e-6);
    const auto make = [&] { return limit; };
    const auto about = importance_sampling(make, point.place, {.draws = 20000});
    EXPECT_NEAR(about.probability, point.probability(), 4 * about.standard_error);
    const auto plain = plain_sampling(make, 2, {.draws = 20000});
    // (UQ-6): of the binomial distribution.
    EXPECT_NEAR(plain.standard_error,
                std::sqrt(plain.probability * (1 - plain.probability) / 20000), 1e-15);
    EXPECT_NEAR(plain.probability, point.probability(), 4 * plain.standard_error + 1e-4);
  }
}

// Kind: identity (UQ-5), (UQ-7).  What fails and what meets the requirement are the two sides of
// one limit: their probabilities add up to 1, also if the drive of the file fails.
TEST(Reliability, IdentityBothSidesOfALimit) {
  const LimitState curved = [](std::span<const double> z) -> std::optional<double> {
    return 2.5 + z[0] + 0.15 * z[1] * z[1];
  };
  const LimitState other = [&](std::span<const double> z) { return std::optional(-*curved(z)); };
  const DesignPoint one = find_design_point(curved, origin(2));
  const DesignPoint two = find_design_point(other, origin(2));
  ASSERT_TRUE(one.converged && two.converged);
  EXPECT_NEAR(one.reliability_index, 2.5, 1e-6);
  EXPECT_NEAR(two.reliability_index, -2.5, 1e-6);
  const double fails = *curved_limit(curved, one).probability;
  EXPECT_LT(fails, one.probability());
  EXPECT_NEAR(*curved_limit(other, two).probability, 1 - fails, 1e-12);
  const auto about = importance_sampling([&] { return curved; }, one.place, {.draws = 20000});
  const auto mirror = importance_sampling([&] { return other; }, two.place, {.draws = 20000});
  EXPECT_NEAR(mirror.probability, 1 - about.probability, 1e-12);
  EXPECT_NEAR(mirror.low, 1 - about.high, 1e-12);
  EXPECT_NEAR(mirror.high, 1 - about.low, 1e-12);
  for (const double distance : {-3.0, -5.0}) {
    const LimitState limit = plane(distance);
    const auto sampled = importance_sampling(
        [&] { return limit; }, find_design_point(limit, origin(2)).place, {.draws = 20000});
    EXPECT_LT(sampled.standard_error, 0.02 * normal_probability(distance));
    EXPECT_LE(sampled.low, normal_probability(-distance));
    EXPECT_GE(sampled.high, normal_probability(-distance));
  }
}

// Kind: behaviour.  A start on the limit, but beside the nearest failure, is not the design point.
TEST(Reliability, BehaviourAStartOnTheLimitIsNotTheEnd) {
  const DesignPoint point = find_design_point(plane(3.0), {1.8 + 0.05 * 0.8, -2.4 + 0.05 * 0.6});
  ASSERT_TRUE(point.converged) << point.reason;
  EXPECT_NEAR(point.place[0], 1.8, 1e-5);
  EXPECT_NEAR(point.place[1], -2.4, 1e-5);
}

/// The standard normal limit of the two springs in series of tools/reference/reliability.py.
LimitState springs(double least) {
  return [least](std::span<const double> z) -> std::optional<double> {
    const double x1 = std::exp(std::sqrt(std::log1p(0.15 * 0.15)) * z[0]);
    // Weibull, mean 1, relative standard deviation 0.08: the exponent by bisection.
    static const double k = [] {
      double low = 1;
      double high = 200;
      for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        const double ratio =
            std::tgamma(1 + 2 / middle) / std::pow(std::tgamma(1 + 1 / middle), 2) - 1;
        (ratio > 0.0064 ? low : high) = middle;
      }
      return low;
    }();
    const double x2 =
        std::pow(-std::log(normal_probability(-z[1])), 1 / k) / std::tgamma(1 + 1 / k);
    const double x3 = 1 + 0.05 * std::numbers::sqrt3 * (2 * normal_probability(z[2]) - 1);
    return 1 / (1 / (3 * x1) + 1 / (2 * x2 * x3 * x3 * x3)) - least;
  };
}

// Kind: reference.  Source: OpenTURNS 1.20 and a quadrature, tests/data/reliability.csv. Tolerance:
// 1e-5 of beta and the design point, where the searches stop; 1e-4 of the second-order probability,
// whose curvatures are differences; three standard errors of the draws.
TEST(Reliability, ReferenceSpringsInSeries) {
  for (const double least : {0.95, 0.85, 0.75}) {
    const LimitState limit = springs(least);
    const DesignPoint point = find_design_point(limit, origin(3));
    ASSERT_TRUE(point.converged) << point.reason;
    const CurvedLimit curved = curved_limit(limit, point);
    ASSERT_TRUE(curved.probability) << curved.reason;
    const auto make = [&] { return limit; };
    const auto about = importance_sampling(make, point.place, {.draws = 200000});
    const auto plain = plain_sampling(make, 3, {.draws = 200000});
    int compared = 0;
    for (const test::CsvRow& row : test::read_reference_csv("reliability")) {
      if (std::abs(row("k_min") - least) > 1e-9 || row.quantity.starts_with("correlated_"))
        continue;
      ++compared;
      if (row.quantity == "beta") test::expect_relative(point.reliability_index, row.value, 1e-5);
      if (row.quantity.starts_with("design_")) {
        EXPECT_NEAR(point.place[static_cast<std::size_t>(row.quantity.back() - '1')], row.value,
                    1e-4);
      }
      if (row.quantity == "first_order")
        test::expect_relative(point.probability(), row.value, 5e-5);
      if (row.quantity == "second_order")
        test::expect_relative(*curved.probability, row.value, 2e-4);
      if (row.quantity == "exact") {
        EXPECT_NEAR(about.probability, row.value, 3 * about.standard_error);
        EXPECT_LT(about.standard_error, 0.01 * row.value);
        EXPECT_LE(plain.low, row.value);
        EXPECT_GE(plain.high, row.value);
      }
    }
    EXPECT_EQ(compared, 7);
  }
}

// Kind: reference.  Source: OpenTURNS 1.20 with a normal copula of given rank correlations,
// tests/data/reliability.csv.  Tolerances: as without correlation.
TEST(Reliability, ReferenceSpringsWithRankCorrelation) {
  const auto normals = CorrelatedNormals::of(3, {{0, 1, 0.6}, {2, 1, -0.3}});
  ASSERT_TRUE(normals);
  for (const double least : {0.95, 0.85, 0.75}) {
    const LimitState limit = [&, of_z = springs(least)](std::span<const double> u) {
      std::vector<double> z(u.begin(), u.end());
      normals->correlate(z);
      return of_z(z);
    };
    const DesignPoint point = find_design_point(limit, origin(3));
    ASSERT_TRUE(point.converged) << point.reason;
    const CurvedLimit curved = curved_limit(limit, point);
    ASSERT_TRUE(curved.probability) << curved.reason;
    int compared = 0;
    for (const test::CsvRow& row : test::read_reference_csv("reliability")) {
      if (std::abs(row("k_min") - least) > 1e-9) continue;
      const bool correlated = row.quantity.starts_with("correlated_");
      compared += correlated ? 1 : 0;
      if (row.quantity == "correlated_beta")
        test::expect_relative(point.reliability_index, row.value, 1e-5);
      if (row.quantity.starts_with("correlated_design_")) {
        EXPECT_NEAR(point.place[static_cast<std::size_t>(row.quantity.back() - '1')], row.value,
                    1e-4);
      }
      if (row.quantity == "correlated_first_order")
        test::expect_relative(point.probability(), row.value, 5e-5);
      if (row.quantity == "correlated_second_order")
        test::expect_relative(*curved.probability, row.value, 2e-4);
    }
    EXPECT_EQ(compared, 6);
  }
}

// Kind: reference.  A sphere round the origin: the distance has a chi-square distribution.  All of
// the sphere is as near, so first order is far off and second order refuses; plain draws tell.
TEST(Reliability, ReferenceASphere) {
  const double radius = 2.0;
  const auto inside = [&](std::span<const double> z) -> std::optional<double> {
    return radius * radius - z[0] * z[0] - z[1] * z[1] - z[2] * z[2];
  };
  const DesignPoint point = find_design_point(inside, {1.0, 0.0, 0.0});
  ASSERT_TRUE(point.converged) << point.reason;
  EXPECT_NEAR(point.reliability_index, radius, 1e-6);
  const CurvedLimit curved = curved_limit(inside, point);
  for (const double curvature : curved.curvatures) EXPECT_NEAR(curvature, -1 / radius, 1e-4);
  const double exact = boost::math::gamma_q(1.5, radius * radius / 2);
  const auto plain = plain_sampling([&] { return LimitState(inside); }, 3, {.draws = 50000});
  EXPECT_NEAR(plain.probability, exact, 4 * plain.standard_error);
  EXPECT_GT(exact, 5 * point.probability());
  // From the centre the gradient says nothing, so the search does not converge and says why.
  const DesignPoint centre = find_design_point(inside, origin(3));
  EXPECT_FALSE(centre.converged);
  EXPECT_EQ(centre.reason, "the output does not depend on the scattering inputs");
}

// Kind: reference (UQ-5).  A paraboloid about its design point, by one quadrature.  The correction
// of Hohenbichler and Rackwitz is exact as beta grows; at 3 it is within 3 %.
TEST(Reliability, ReferenceAParaboloid) {
  const double beta = 3.0;
  for (const double curvature : {0.3, -0.15}) {
    const auto limit = [&](std::span<const double> z) -> std::optional<double> {
      return beta - z[0] + curvature / 2 * z[1] * z[1];
    };
    const DesignPoint point = find_design_point(limit, origin(2));
    ASSERT_TRUE(point.converged) << point.reason;
    const CurvedLimit curved = curved_limit(limit, point);
    EXPECT_NEAR(curved.curvatures[0], curvature, 1e-5);
    const double exact = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        [&](double z) {
          return normal_density(z) * normal_probability(-(beta + curvature / 2 * z * z));
        },
        -8.0, 8.0, 10, 1e-10);
    ASSERT_TRUE(curved.probability);
    test::expect_relative(*curved.probability, exact, 0.03);
    EXPECT_GT(std::abs(point.probability() / exact - 1), 0.1);
  }
}

// Kind: behaviour.  What the search says where there is no design point.
TEST(Reliability, BehaviourReasons) {
  const auto reason = [](const LimitState& limit) {
    const DesignPoint point = find_design_point(limit, origin(2));
    EXPECT_FALSE(point.converged);
    return point.reason;
  };
  EXPECT_EQ(reason([](std::span<const double>) -> std::optional<double> { return 1.0; }),
            "the output does not depend on the scattering inputs");
  EXPECT_EQ(reason(plane(9.0)), "no failure is nearer than 8 standard deviations of the inputs");
  EXPECT_EQ(
      reason(plane(-9.0)),
      "no drive that meets the requirement is nearer than 8 standard deviations of the inputs");
  EXPECT_EQ(reason([](std::span<const double>) -> std::optional<double> { return std::nullopt; }),
            "the output has no value where the search starts");
  EXPECT_EQ(reason([](std::span<const double> z) -> std::optional<double> {
              if (z[0] != 0 || z[1] != 0) return std::nullopt;
              return 1.0;
            }),
            "the output has no value on either side of a place of the search");
  // A narrow curved valley leads to the limit: the search counts its steps, and gives up.
  const DesignPoint valley = find_design_point(
      [](std::span<const double> z) -> std::optional<double> {
        return 3 - z[0] + (z[1] - z[0] * z[0]) * (z[1] - z[0] * z[0]);
      },
      {0.1, 0.2});
  EXPECT_EQ(valley.reason, "the search does not converge in 100 steps");
  EXPECT_EQ(valley.iterations, 100);
  // A step without a slope towards it.
  EXPECT_NE(reason([](std::span<const double> z) -> std::optional<double> {
              return z[0] < 1 ? 1 - 0.01 * z[0] : 2.0;
            }).find("the limit has a kink or a step"),
            std::string::npos);
}

// Kind: behaviour.  A failure behind a region without values is found by the side that has values.
TEST(Reliability, BehaviourTheSearchGoesAroundWhatHasNoValue) {
  const auto limit = [](std::span<const double> z) -> std::optional<double> {
    if (z[0] > 2.5) return std::nullopt;
    return 2 - z[0] - 0.1 * z[1];
  };
  const DesignPoint point = find_design_point(limit, origin(2));
  ASSERT_TRUE(point.converged) << point.reason;
  EXPECT_NEAR(point.reliability_index, 2 / std::sqrt(1.01), 1e-6);
}

// Kind: reference (UQ-7).  Draws without a value count as failures in the upper limit alone.
TEST(Reliability, ReferenceDrawsWithoutAValue) {
  const auto limit = [](std::span<const double> z) -> std::optional<double> {
    if (z[0] > 2) return std::nullopt;
    return 1 - z[0];
  };
  const auto make = [&] { return LimitState(limit); };
  const double beyond = normal_probability(-2);
  const double failed = normal_probability(-1) - beyond;
  const auto plain = plain_sampling(make, 1, {.draws = 100000});
  EXPECT_NEAR(plain.probability, failed, 4 * plain.standard_error);
  EXPECT_NEAR(static_cast<double>(plain.without_value) / 1e5, beyond, 2e-3);
  EXPECT_NEAR(plain.high - plain.low, beyond, 6e-3);
  const auto about = importance_sampling(make, {1.0}, {.draws = 100000});
  EXPECT_NEAR(about.probability, failed, 4 * about.standard_error);
  EXPECT_GT(about.without_value, 10000U);
  EXPECT_NEAR(about.high, failed + beyond, 3e-3);
}

// Kind: reference (UQ-6).  The interval of plain draws contains the probability in at least 95 of
// 100 studies; with 200 studies of exactly 95 %, fewer than 178 have a probability of 1e-4. Without
// a failure the upper limit is 1 - 0.025^(1/n).
TEST(Reliability, ReferenceIntervalOfPlainDraws) {
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const auto plain =
        plain_sampling([] { return plane(1.5); }, 2, {.draws = 400, .seed = seed, .threads = 1});
    inside += plain.low <= normal_probability(-1.5) && normal_probability(-1.5) <= plain.high;
  }
  EXPECT_GE(inside, 178);
  const auto none = plain_sampling([] { return plane(9.0); }, 2, {.draws = 1000});
  EXPECT_EQ(none.failures, 0U);
  EXPECT_EQ(none.low, 0.0);
  test::expect_relative(none.high, 1 - std::pow(0.025, 1e-3), 1e-9);
  EXPECT_TRUE(none.nearest_failure.empty());
  const auto all = plain_sampling([] { return plane(-9.0); }, 2, {.draws = 1000});
  EXPECT_EQ(all.high, 1.0);
  test::expect_relative(all.low, std::pow(0.025, 1e-3), 1e-9);
}

TEST(Reliability, IdentityForAnyNumberOfThreads) {
  const auto with = [](int threads) {
    return plain_sampling([] { return springs(0.95); }, 3,
                          {.draws = 3000, .seed = 4, .threads = threads});
  };
  const auto one = with(1);
  EXPECT_GT(one.failures, 50U);
  for (const int threads : {2, 5}) {
    EXPECT_EQ(with(threads).failures, one.failures);
    EXPECT_EQ(with(threads).nearest_failure, one.nearest_failure);
  }
  // The nearest failure among the draws is no nearer than the design point.
  double square = 0.0;
  for (const double z : one.nearest_failure) square += z * z;
  EXPECT_GE(std::sqrt(square), find_design_point(springs(0.95), origin(3)).reliability_index);
}

}  // namespace
}  // namespace strainwave
