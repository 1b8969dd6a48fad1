// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/oval_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace strainwave {
namespace {

// Kind: exact.  One tension is itself, one shear counts sqrt(3) times, an even pressure counts
// nothing, and a stress counts the same in any direction: tension s along 45 degrees between two
// axes is s/2 along both and a shear of s/2.
TEST(OvalStress, ReferenceVonMises) {
  for (std::size_t i = 0; i < 6; ++i) {
    std::array<double, 6> stress{};
    stress[i] = -7;
    EXPECT_NEAR(von_mises(stress), i < 3 ? 7 : 7 * std::sqrt(3.0), 1e-12) << i;
  }
  EXPECT_NEAR(von_mises({5, 5, 5, 0, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(von_mises({0, 4, 4, 4, 0, 0}), 8, 1e-12);
  EXPECT_NEAR(von_mises({4, 0, 4, 0, 4, 0}), 8, 1e-12);
  EXPECT_NEAR(von_mises({4, 4, 0, 0, 0, -4}), 8, 1e-12);
  EXPECT_NEAR(von_mises({0, 3, 3, 0, 0, 0}), 3, 1e-12);
}

// Kind: exact.  The extremes are those of the values that were taken, the first one if several tie.
TEST(OvalStress, ReferenceExtremes) {
  StressExtremes extremes;
  extremes.take(-3, 0.1, true);
  extremes.take(-5, 0.2, false);
  extremes.take(-1, 0.3, false);
  extremes.take(-1, 0.4, false);
  EXPECT_EQ(extremes.largest, -1);
  EXPECT_EQ(extremes.at_largest, 0.3);
  EXPECT_EQ(extremes.least, -5);
  EXPECT_EQ(extremes.at_least, 0.2);
  EXPECT_EQ(extremes.range(), 4);
}

}  // namespace
}  // namespace strainwave
