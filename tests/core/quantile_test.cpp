// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/quantile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
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

}  // namespace
}  // namespace strainwave
