// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "growth_support.hpp"
#include "support/expect.hpp"

/// @file
/// Rows, events and times at the ends of a path.

namespace strainwave {
namespace {

TEST(PathEnds, BehaviourRowsNeverRunBackwards) {  // GR-24
  // The end by assessment lies before the last step, so no row may lie beyond it.  Source: time
  // runs forwards; exact.
  GrowthOptions options;
  options.points = 1000;
  const GrowthReport report = grow_cracks(test::growing_shaft(), options);
  ASSERT_EQ(report.end, DriveEnd::assessment);
  const auto& series = report.cracks[0].series;
  EXPECT_TRUE(std::ranges::is_sorted(series, {}, &GrowthPoint::time));
  EXPECT_TRUE(std::ranges::is_sorted(series, {}, &GrowthPoint::size));
  EXPECT_EQ(series.back().time, report.time);
  EXPECT_TRUE(std::ranges::is_sorted(report.stiffness, {}, &StiffnessOverLife::time));
  EXPECT_EQ(report.drives.size(), report.stiffness.size());
}

}  // namespace
}  // namespace strainwave
