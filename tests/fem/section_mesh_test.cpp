// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/section_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace strainwave::fem {
namespace {

TEST(GridLines, IdentityBreaksAreLines) {
  const auto lines = grid_lines({.breaks = {0, 1, 3}, .focus = {{1, 0.1}}, .coarse = 1});
  EXPECT_EQ(lines.front(), 0);
  EXPECT_EQ(lines.back(), 3);
}

}  // namespace
}  // namespace strainwave::fem
