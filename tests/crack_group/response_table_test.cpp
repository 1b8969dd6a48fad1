// SPDX-License-Identifier: Apache-2.0
// Responses of two cracks from polynomials over their half lengths.
#include "strainwave/crack_group/response_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

constexpr double kRound = 0.195;
const std::vector<SheetStress> kStresses = {{.yy = 1}, {.xy = 1}, {.xx = 1, .yy = 0.3}};

/// The pair of examples/crack_pair.toml, with faces of choice.
std::vector<FacedCrack> pair(bool first_closed = false, bool second_closed = false) {
  return {{{{0, 7e-3}, 1.5e-3, 2.356}, first_closed},
          {{{-2.7e-3, 9.5e-3}, 0.8e-3, 2.356}, second_closed}};
}

std::vector<FacedCrack> at_sizes(std::vector<FacedCrack> cracks, double first, double second) {
  cracks[0].crack.half_length = first;
  cracks[1].crack.half_length = second;
  return cracks;
}

/// Largest difference of factors, jumps and largest faces, over the largest of its kind.
double difference(const std::vector<std::vector<CrackResponse>>& one,
                  const std::vector<std::vector<CrackResponse>>& other) {
  double worst = 0.0;
  const auto kind = [&](const auto& value) {
    double size = 0.0;
    double apart = 0.0;
    for (std::size_t s = 0; s < one.size(); ++s)
      for (std::size_t j = 0; j < one[s].size(); ++j) {
        size = std::max(size, std::abs(value(other[s][j])));
        apart = std::max(apart, std::abs(value(one[s][j]) - value(other[s][j])));
      }
    if (size > 0) worst = std::max(worst, apart / size);
  };
  kind([](const CrackResponse& of) { return of.behind.mode_1; });
  kind([](const CrackResponse& of) { return of.behind.mode_2; });
  kind([](const CrackResponse& of) { return of.ahead.mode_1; });
  kind([](const CrackResponse& of) { return of.ahead.mode_2; });
  kind([](const CrackResponse& of) { return of.opening; });
  kind([](const CrackResponse& of) { return of.sliding; });
  return worst;
}

// Kind: cross-check (CG-15).  The table against the solution of each group, with faces apart and
// closed, far from each other and up to a gap of a fifth of the longer half length.
// Tolerance: twice that of the table, which checks the corners of its cells alone.
TEST(ResponseTable, CrosscheckAgainstTheGroups) {
  for (const auto& cracks : {pair(), pair(true, false), pair(true, true)}) {
    ResponseTable table(cracks, kStresses, kRound);
    for (const double share : {0.0, 0.31, 0.77, 0.999}) {
      const double first = 1.5e-3 + share * 0.617e-3;
      const double second = 0.8e-3 + share * 0.368e-3;
      const auto direct =
          group_response(at_sizes(cracks, first, second), kStresses, {.period = kRound});
      EXPECT_LT(difference(table.at({first, second}), direct), 2 * ResponseTable::kTolerance)
          << share;
      if (test::kSanitized) break;
    }
  }
}

// Kind: behaviour (CG-15).  Sizes of a path share cells, so many questions need few solutions; a
// table that was asked in another order gives the same bits.
TEST(ResponseTable, BehaviourFewSolutionsAndNoOrder) {
  ResponseTable table(pair(), kStresses, kRound);
  ResponseTable backwards(pair(), kStresses, kRound);
  const int questions = test::kSanitized ? 4 : 400;
  const auto first = [&](int i) { return 1.5e-3 * (1 + 0.3 * i / questions); };
  const auto second = [&](int i) { return 0.8e-3 * (1 + 0.2 * i / questions); };
  std::vector<double> forth;
  for (int i = 0; i < questions; ++i)
    forth.push_back(table.at({first(i), second(i)})[1][0].ahead.mode_1);
  for (int i = questions; i-- > 0;)
    EXPECT_EQ(backwards.at({first(i), second(i)})[1][0].ahead.mode_1,
              forth[static_cast<std::size_t>(i)]);
  EXPECT_EQ(table.cells(), backwards.cells());
  EXPECT_GE(table.cells(), 1U);
  EXPECT_EQ(table.solved(), 52 * table.cells());  // 7 times 7 nodes and 3 checks
}

// Kind: limit (CG-15).  Cracks that almost touch have no cell: the answer is that of the group, to
// the last bit.
TEST(ResponseTable, LimitAlmostTouchingCracks) {
  const std::vector<FacedCrack> cracks = {{{{0, 0}, 1e-3, 0.0}, false},
                                          {{{2.06e-3, 0}, 1e-3, 0.0}, false}};
  ResponseTable table(cracks, kStresses, kRound);
  const auto direct = group_response(cracks, kStresses, {.period = kRound});
  const auto answer = table.at({1e-3, 1e-3});
  EXPECT_EQ(answer[0][0].ahead.mode_1, direct[0][0].ahead.mode_1);
  EXPECT_EQ(answer[0][0].faces, direct[0][0].faces);
  EXPECT_EQ(table.cells(), 0U);
}

// Kind: input (CG-15).
TEST(ResponseTable, InputTwoCracks) {
  EXPECT_NE(test::broken_rule([] {
              return ResponseTable({pair()[0]}, kStresses, kRound).cells();
            }).find("must be two"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
