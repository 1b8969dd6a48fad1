// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/multiple_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace strainwave {
namespace {

TEST(MultipleAngle, CrosscheckAgainstSines) {
  // Tolerance: one unit in the last place per rotation, and the rounding of the multiple itself.
  for (const double angle : {0.0, 0.3, -2.0, 3.141592653589793, 117.25}) {
    MultipleAngle multiple(angle);
    EXPECT_EQ(multiple.cosine(), 1.0);
    EXPECT_EQ(multiple.sine(), 0.0);
    for (int k = 1; k <= 300; ++k) {
      multiple.next();
      const double rounding = k * (1 + std::abs(angle)) * std::numeric_limits<double>::epsilon();
      EXPECT_NEAR(multiple.cosine(), std::cos(k * angle), rounding) << k << " times " << angle;
      EXPECT_NEAR(multiple.sine(), std::sin(k * angle), rounding) << k << " times " << angle;
    }
  }
}

}  // namespace
}  // namespace strainwave
