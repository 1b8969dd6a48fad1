// SPDX-License-Identifier: Apache-2.0
#include "anderson.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace strainwave::gear_fem {
namespace {

using Vector = std::vector<double>;

double distance(const Vector& a, const Vector& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// Kind: exact.  An affine map of n numbers with different factors, one of which diverges, is solved
// in n + 1 combined steps.
TEST(Anderson, IdentityAffineMap) {
  const Vector factor = {0.9, -0.5, 1.4, 0.2};
  const auto g = [&](const Vector& x) {
    Vector answer(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      answer[i] = factor[i] * x[i] + static_cast<double>(i + 1);
    return answer;
  };
  Anderson anderson(5);
  Vector x(4, 0.0);
  for (int step = 0; step < 5; ++step) x = anderson.next(x, g(x));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(x[i], static_cast<double>(i + 1) / (1 - factor[i]), 1e-8);
  // Once it has settled, it stays, and equal steps are left out.
  for (int step = 0; step < 3; ++step) x = anderson.next(x, g(x));
  EXPECT_LT(distance(x, g(x)), 1e-12);
}

// Kind: behaviour.  x = cos x settles much sooner than by plain steps; without earlier steps the
// answer is the plain step.
TEST(Anderson, BehaviourOfACurvedMap) {
  Anderson anderson(1);
  Anderson plain(0);
  Vector x = {0.5};
  Vector slow = {0.5};
  for (int step = 0; step < 7; ++step) {
    x = anderson.next(x, {std::cos(x[0])});
    slow = plain.next(slow, {std::cos(slow[0])});
  }
  EXPECT_NEAR(x[0], 0.7390851332151607, 1e-12);
  EXPECT_GT(std::abs(slow[0] - 0.7390851332151607), 1e-3);
}

}  // namespace
}  // namespace strainwave::gear_fem
