// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/cycle_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

std::vector<CycleCount> random_cycles(int seed, int size) {
  std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
  const auto number = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  std::vector<CycleCount> cycles(static_cast<std::size_t>(size));
  for (CycleCount& cycle : cycles)
    cycle = {.range = 100 * number() + 0.001, .mean = 300 * number() - 100, .count = 0.5};
  return cycles;
}

void expect_same_rows(const CycleTable& a, const CycleTable& b) {
  const auto rows = a.rows();
  const auto others = b.rows();
  ASSERT_EQ(rows.size(), others.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].range, others[i].range);
    EXPECT_EQ(rows[i].mean, others[i].mean);
    EXPECT_EQ(rows[i].count, others[i].count);
  }
  EXPECT_EQ(a.left_out(), b.left_out());
  EXPECT_EQ(a.largest_left_out(), b.largest_left_out());
}

TEST(CycleTable, BehaviourEqualCyclesAreOneRow) {  // LI-23
  CycleTable table;
  table.add(3, -0.0, 1);
  table.add(5, 1, 0.5);
  table.add(3, 0.0, 0.5);
  table.add(3, -1, 2);
  table.add(0, 7, 1);  // no cycle
  const auto rows = table.rows();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].range, 5.0);
  EXPECT_EQ(rows[1].mean, -1.0);
  EXPECT_EQ(rows[2].count, 1.5);
  EXPECT_EQ(table.cycles(), 4.0);
  EXPECT_EQ(table.largest_range(), 5.0);
  EXPECT_EQ(table.left_out(), 0.0);
  EXPECT_FALSE(table.class_width().has_value());
}

TEST(CycleTable, IdentityOrderOfTheCycles) {
  for (const std::optional<int> classes : {std::optional<int>(), std::optional<int>(16)}) {
    std::vector<CycleCount> cycles = random_cycles(1, 5000);
    CycleTable forward(classes, 100);
    for (const CycleCount& c : cycles) forward.add(c.range, c.mean, c.count);
    std::ranges::sort(cycles, {}, &CycleCount::range);
    CycleTable rising(classes, 100);
    for (const CycleCount& c : cycles) rising.add(c.range, c.mean, c.count);
    std::ranges::reverse(cycles);
    CycleTable falling(classes, 100);
    for (const CycleCount& c : cycles) falling.add(c.range, c.mean, c.count);
    expect_same_rows(forward, rising);
    expect_same_rows(forward, falling);
  }
}

TEST(CycleTable, CrosscheckLargestRanges) {
  // The rows are the head of the sorted list.
  std::vector<CycleCount> cycles = random_cycles(2, 3000);
  CycleTable table({}, 200);
  for (const CycleCount& c : cycles) table.add(c.range, c.mean, c.count);
  std::ranges::sort(cycles, std::ranges::greater(), &CycleCount::range);
  const auto rows = table.rows();
  ASSERT_EQ(rows.size(), 200U);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].range, cycles[i].range);
  EXPECT_EQ(table.largest_left_out(), cycles[200].range);
  EXPECT_EQ(table.left_out(), 1400.0);
}

TEST(CycleTable, CrosscheckClasses) {
  // Ranges up to 100 and means from -100 to 200 need a width of 32 for 11 classes; counted
  // directly.
  const std::vector<CycleCount> cycles = random_cycles(3, 2000);
  CycleTable table(11);
  for (const CycleCount& c : cycles) table.add(c.range, c.mean, c.count);
  ASSERT_EQ(table.class_width(), 32.0);
  double sum = 0;
  for (const CycleCount& row : table.rows()) {
    double count = 0;
    for (const CycleCount& c : cycles)
      if (std::abs(c.range - row.range) < 16 && std::abs(c.mean - row.mean) < 16) count += c.count;
    EXPECT_EQ(row.count, count);
    sum += row.count;
  }
  EXPECT_EQ(sum, 1000.0);
}

TEST(CycleTable, InputFiniteRanges) {
  CycleTable table;
  EXPECT_THROW(table.add(std::numeric_limits<double>::infinity(), 0, 1), InputError);
}

}  // namespace
}  // namespace strainwave
