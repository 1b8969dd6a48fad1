// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/quantile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace strainwave {
namespace {

TEST(Quantile, ReferenceByHand) {
  std::vector<double> values = {4, 1, 3, 2, 5};
  EXPECT_DOUBLE_EQ(quantile(values, 0), 1);
  EXPECT_DOUBLE_EQ(quantile(values, 0.5), 3);
  EXPECT_DOUBLE_EQ(quantile(values, 1), 5);
  EXPECT_DOUBLE_EQ(quantile(values, 0.1), 1.4);   // 0.4 of the way from 1 to 2
  EXPECT_DOUBLE_EQ(quantile(values, 0.95), 4.8);  // 0.8 of the way from 4 to 5
  std::vector<double> one = {7};
  EXPECT_DOUBLE_EQ(quantile(one, 0.3), 7);
}

TEST(Quantile, CrosscheckAgainstSorting) {
  std::mt19937_64 generator(3);
  std::vector<double> values(1001);
  for (double& value : values) value = std::normal_distribution<double>()(generator);
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  for (int k = 0; k <= 1000; ++k)
    EXPECT_DOUBLE_EQ(quantile(values, k / 1000.0), sorted[static_cast<std::size_t>(k)]);
}

// Kind: identity.  Several quantiles at once are those one by one, to the last bit: for samples of
// any size, with equal values, and for quantiles between the same two values.
TEST(Quantile, IdentitySeveralAtOnce) {
  const std::array p = {0.0, 0.05, 0.051, 0.5, 0.95, 1.0};
  std::mt19937_64 engine(1);
  for (const std::size_t n : {1U, 2U, 3U, 5U, 20U, 21U, 100U, 1000U})
    for (const std::uint64_t different : {2U, 7U, 1'000'000U}) {
      std::vector<double> values(n);
      for (double& value : values) value = static_cast<double>(engine() % different) / 3;
      std::vector<double> reordered = values;
      const auto together = quantiles(std::span(reordered), p);
      for (std::size_t i = 0; i < p.size(); ++i) {
        std::vector<double> alone = values;
        EXPECT_EQ(together[i], quantile(alone, p[i])) << n << ", " << different << ", " << p[i];
      }
    }
}

}  // namespace
}  // namespace strainwave
