// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/correlated_normals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

/// Four variables; 0, 1 and 3 depend on each other, 0 and 3 by way of 1 alone.
CorrelatedNormals four() {
  auto normals = CorrelatedNormals::of(4, {{0, 1, 0.6}, {3, 1, -0.5}});
  EXPECT_TRUE(normals.has_value());
  return *std::move(normals);
}

// Kind: identity (UQ-8).  The factor gives back the matrix of the correlations.
TEST(CorrelatedNormals, IdentityOfTheMatrix) {
  const CorrelatedNormals normals = four();
  EXPECT_FALSE(normals.independent());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(normals.correlation(i, i), 1, 1e-15);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(normals.correlation(0, 1), 2 * std::sin(pi * 0.6 / 6), 1e-15);
  EXPECT_NEAR(normals.correlation(1, 3), -2 * std::sin(pi * 0.5 / 6), 1e-15);
  EXPECT_NEAR(normals.correlation(0, 3), 0, 1e-15);
  EXPECT_EQ(normals.correlation(0, 2), 0);
}

std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t n) { return values[n]; });
  std::vector<double> ranks(values.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    ranks[order[rank]] = static_cast<double>(rank);
  return ranks;
}

double correlation_of(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  const double x_mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double y_mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    yy += (y[i] - y_mean) * (y[i] - y_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  return xy / std::sqrt(xx * yy);
}

// Kind: reference.  The definition of Spearman's rank correlation, over 40000 draws.  Tolerance:
// four standard errors of a correlation, 4/sqrt(n) = 0.02.
TEST(CorrelatedNormals, ReferenceRanksOfDraws) {
  const CorrelatedNormals normals = four();
  constexpr std::size_t kDraws = 40000;
  std::vector<std::vector<double>> drawn(4, std::vector<double>(kDraws));
  for (std::size_t n = 0; n < kDraws; ++n) {
    std::vector<double> u(4);
    for (std::size_t i = 0; i < 4; ++i) u[i] = counter_normal(7, n, i);
    normals.correlate(u);
    for (std::size_t i = 0; i < 4; ++i) drawn[i][n] = u[i];
  }
  for (auto& values : drawn) values = ranks_of(values);
  EXPECT_NEAR(correlation_of(drawn[0], drawn[1]), 0.6, 0.02);
  EXPECT_NEAR(correlation_of(drawn[1], drawn[3]), -0.5, 0.02);
  EXPECT_NEAR(correlation_of(drawn[0], drawn[3]), 0, 0.02);
  EXPECT_NEAR(correlation_of(drawn[1], drawn[2]), 0, 0.02);
}

// Kind: identity (UQ-9).  The slope in z gives the same change as the slope in u, and the shares
// are those of the covariances.
TEST(CorrelatedNormals, IdentityOfSlopesAndShares) {
  const CorrelatedNormals normals = four();
  const std::vector<double> in_u = {0.3, -1.0, 2.0, 0.7};
  const std::vector<double> in_z = normals.slope_in_z(in_u);
  std::vector<double> u = {1.1, 0.4, -0.2, 0.9};
  double change = 0.0;
  for (std::size_t i = 0; i < 4; ++i) change += in_u[i] * u[i];
  normals.correlate(u);
  for (std::size_t i = 0; i < 4; ++i) change -= in_z[i] * u[i];
  EXPECT_NEAR(change, 0, 1e-14);
  const std::vector<double> shares = normals.shares(in_z);
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-14);
  const double variance = std::inner_product(in_u.begin(), in_u.end(), in_u.begin(), 0.0);
  double first = 0.0;
  for (std::size_t j = 0; j < 4; ++j) first += in_z[0] * normals.correlation(0, j) * in_z[j];
  EXPECT_NEAR(shares[0], first / variance, 1e-14);
  EXPECT_NEAR(shares[2], 4.0 / variance, 1e-14);
}

TEST(CorrelatedNormals, BehaviourGroupsAndIndependence) {
  using Groups = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(four().groups(), (Groups{{0, 1, 3}, {2}}));
  const auto none = CorrelatedNormals::of(3, {{0, 2, 0.0}});
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->independent());
  EXPECT_EQ(none->groups(), (Groups{{0}, {1}, {2}}));
  std::vector<double> u = {1, 2, 3};
  none->correlate(u);
  EXPECT_EQ(u, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(none->slope_in_z(u), u);
  // 0 and 1, and 2 and 3, are joined by the last pair.
  const auto joined = CorrelatedNormals::of(4, {{0, 1, 0.3}, {2, 3, 0.3}, {1, 2, 0.3}});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->groups(), (Groups{{0, 1, 2, 3}}));
}

// Kind: behaviour.  Three variables cannot all be nearly opposite to each other; the matrix is
// singular at r = -1/2.
TEST(CorrelatedNormals, BehaviourContradictionsAreRefused) {
  const double singular = 6 / std::numbers::pi * std::asin(-0.25);  // r = -1/2
  const auto of = [](double rank) {
    return CorrelatedNormals::of(3, {{0, 1, rank}, {1, 2, rank}, {0, 2, rank}}).has_value();
  };
  EXPECT_TRUE(of(0.999));
  EXPECT_TRUE(of(singular + 1e-3));
  EXPECT_FALSE(of(singular));
  EXPECT_FALSE(of(-0.9));
}

}  // namespace
}  // namespace strainwave
