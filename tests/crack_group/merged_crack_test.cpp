// SPDX-License-Identifier: Apache-2.0
// The crack that two cracks of one line become.
#include "strainwave/crack_group/merged_crack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "strainwave/crack_group/group_response.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using Place = std::complex<double>;

/// A crack that continues one of half length 1 at the origin beyond a gap.
StraightCrack behind_gap(double gap, double half_length, double angle) {
  return {.centre = std::polar(1 + gap + half_length, angle),
          .half_length = half_length,
          .angle = angle};
}

// Kind: identity (CG-14).  From outer tip to outer tip, at any angle, in any order, whatever the
// sense in which a crack is written, and over the end of a period.  Tolerance: rounding.
TEST(MergedCrack, IdentityOuterTips) {
  for (const double angle : {0.0, 0.7, pi / 2, 2.5}) {
    const StraightCrack one{.centre = 0.0, .half_length = 1, .angle = angle};
    StraightCrack other = behind_gap(0.2, 0.6, angle);
    for (const int way : {0, 1, 2, 3}) {
      if (way == 1) other.angle += pi;
      if (way == 2) other.centre += 10.0;
      const auto merged =
          way == 3 ? merged_crack(other, one, 10.0) : merged_crack(one, other, 10.0);
      ASSERT_TRUE(merged);
      EXPECT_NEAR(merged->half_length, (2 + 0.2 + 1.2) / 2, 1e-12);
      // The middle is between the tips -1 and 2.4 of the line.
      const Place off = merged->centre - std::polar(0.7, angle);
      EXPECT_NEAR(std::abs(off - 10 * std::round(off.real() / 10)), 0, 1e-12);
      EXPECT_NEAR(std::sin(merged->angle - angle), 0, 1e-12);
    }
  }
}

// Kind: input (CG-14).  Cracks of two lines and bent ones have no straight crack.  The limit is a
// twentieth of the longer half length.
TEST(MergedCrack, InputOneLine) {
  const StraightCrack one{.centre = 0.0, .half_length = 1, .angle = 0};
  StraightCrack other = behind_gap(0.2, 0.6, 0);
  other.centre += Place(0, 0.06);
  EXPECT_TRUE(merged_crack(one, other, {}));  // the line through the outer tips turns, too
  other.centre += Place(0, 0.06);
  EXPECT_FALSE(merged_crack(one, other, {}));
  other = behind_gap(0.2, 0.6, 0);
  other.angle = 0.2;
  EXPECT_FALSE(merged_crack(one, other, {}));
  EXPECT_FALSE(merged_crack(one, {.centre = {0, 0.15}, .half_length = 1, .angle = 0}, {}));
}

// Kind: limit (CG-14).  Energy: the ligament gives energy when it breaks, so one crack adds more
// compliance than two with a gap, which approaches that of the one with the gap.
TEST(MergedCrack, LimitTheGapCloses) {
  const auto work = [](const std::vector<FacedCrack>& cracks) {
    const std::vector<SheetStress> shear = {{.xy = 1}};
    const auto response = group_response(cracks, shear, {});
    double sum = 0.0;
    for (const CrackResponse& of : response[0]) sum += of.sliding;
    return sum;
  };
  const StraightCrack one{.centre = 0.0, .half_length = 1, .angle = 0};
  double last = 0.0;
  for (const double gap : {2.0, 1.0, 0.5, 0.2}) {
    const StraightCrack other = behind_gap(gap, 0.6, 0);
    const double share =
        work({{one, false}, {other, false}}) / work({{*merged_crack(one, other, {}), false}});
    EXPECT_LT(share, 1);
    EXPECT_GT(share, last);
    last = share;
  }
  EXPECT_GT(last, 0.5);
}

}  // namespace
}  // namespace strainwave
