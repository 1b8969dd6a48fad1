// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/rainflow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using History = std::vector<double>;
/// Range and mean of each cycle with the sum of its counts.
using Counts = std::map<std::pair<double, double>, double>;

std::vector<CountedCycle> counted(const History& history, Residue residue,
                                  std::size_t piece = 1000) {
  std::vector<CountedCycle> cycles;
  const auto sink = [&](const CountedCycle& cycle) { cycles.push_back(cycle); };
  RainflowCounter counter;
  for (std::size_t i = 0; i < history.size(); i += piece)
    counter.add(std::span(history).subspan(i, std::min(piece, history.size() - i)), sink);
  counter.finish(residue, sink);
  return cycles;
}

Counts sums(const std::vector<CountedCycle>& cycles) {
  Counts sum;
  for (const CountedCycle& cycle : cycles) sum[{cycle.range(), cycle.mean()}] += cycle.count;
  return sum;
}

std::map<double, double> by_range(const std::vector<CountedCycle>& cycles) {
  std::map<double, double> sum;
  for (const CountedCycle& cycle : cycles) sum[cycle.range()] += cycle.count;
  return sum;
}

History reversals_of(const History& history) {
  History r;
  for (const double x : history) {
    if (!r.empty() && x == r.back()) continue;
    if (r.size() >= 2 && (x > r.back()) == (r.back() > r[r.size() - 2])) r.pop_back();
    r.push_back(x);
  }
  return r;
}

/// ASTM E1049, 5.4.4, as printed there: three points, half cycles that contain the start.
Counts by_three_points(const History& history) {
  Counts sum;
  History s;
  const auto count = [&](double a, double b, double weight) {
    sum[{std::abs(b - a), (a + b) / 2}] += weight;
  };
  for (const double x : reversals_of(history)) {
    s.push_back(x);
    while (s.size() >= 3) {
      const std::size_t n = s.size();
      if (std::abs(s[n - 1] - s[n - 2]) < std::abs(s[n - 2] - s[n - 3])) break;
      if (n == 3) {
        count(s[0], s[1], 0.5);
        s.erase(s.begin());
      } else {
        count(s[n - 3], s[n - 2], 1.0);
        s.erase(s.end() - 3, s.end() - 1);
      }
    }
  }
  for (std::size_t i = 1; i < s.size(); ++i) count(s[i - 1], s[i], 0.5);
  return sum;
}

/// Whole cycles of a history that follows on itself: begun at its largest value, no range stays
/// open.
Counts from_the_largest(const History& history) {
  History turned = history;
  std::rotate(turned.begin(), std::max_element(turned.begin(), turned.end()), turned.end());
  turned.push_back(turned.front());
  return by_three_points(turned);
}

History random_history(int seed, int size, int levels) {
  std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
  History history(static_cast<std::size_t>(size));
  for (double& x : history)
    x = static_cast<double>(generator() % static_cast<std::uint64_t>(levels));
  return history;
}

// --- published counts ---------------------------------------------------------------------------

TEST(Rainflow, ReferenceFigure6OfTheStandard) {  // GR-1
  // ASTM E1049, figure 6.  Exact.
  const auto cycles = counted({-2, 1, -3, 5, -1, 3, -4, 4, -2}, Residue::half_cycles);
  EXPECT_EQ(by_range(cycles),
            (std::map<double, double>{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1.0}, {9, 0.5}}));
  EXPECT_EQ(sums(cycles), (Counts{{{3, -0.5}, 0.5},
                                  {{4, -1.0}, 0.5},
                                  {{4, 1.0}, 1.0},
                                  {{8, 1.0}, 0.5},
                                  {{9, 0.5}, 0.5},
                                  {{8, 0.0}, 0.5},
                                  {{6, 1.0}, 0.5}}));
}

TEST(Rainflow, ReferenceSeriesOf23Points) {
  // Published with the counts of another program.  Exact.
  const auto cycles = counted(
      {-1.5, 1, -3, 10, -1, 3, -8, 4, -2, 6, -1, -4, -8, 2, 1, -5, 0, 2.5, -4, 1, 0, 2, -0.5},
      Residue::half_cycles);
  EXPECT_EQ(by_range(cycles), (std::map<double, double>{{1, 1},
                                                        {2.5, 1},
                                                        {4, 1.5},
                                                        {6, 1.5},
                                                        {6.5, 0.5},
                                                        {7, 1},
                                                        {10.5, 0.5},
                                                        {13, 0.5},
                                                        {14, 1},
                                                        {18, 0.5}}));
}

TEST(Rainflow, ReferenceRepeatedResidue) {
  // Published with the ranges that another program finds: those that close, and those of the
  // residue that follows on itself.  Exact.
  const auto cycles =
      counted({4, 7, 2, 10, 5, 9, 3, 4, 2, 12, 5, 11, 1, 4, 3, 10, 6, 12, 4, 8, 1, 9, 4, 6},
              Residue::repeated);
  EXPECT_EQ(
      by_range(cycles),
      (std::map<double, double>{{1, 2}, {2, 1}, {3, 1}, {4, 3}, {6, 1}, {7, 1}, {8, 1}, {11, 2}}));
}

// --- the same counts by another method ----------------------------------------------------------

TEST(Rainflow, CrosscheckThreePointsAndFourPoints) {
  // Four points with half cycles count the same ranges and means as the three points of the
  // standard, also where ranges are equal.  Exact.
  for (int seed = 0; seed < 300; ++seed) {
    const History history = random_history(seed, 1 + seed, 2 + seed % 17);
    EXPECT_EQ(sums(counted(history, Residue::half_cycles)), by_three_points(history)) << seed;
  }
}

TEST(Rainflow, CrosscheckRepeatedHistoryFromItsLargestValue) {
  // A history that follows on itself has the cycles of the one that begins and ends at the largest
  // value.  There, three points leave half cycles in equal pairs, so ranges agree.  Exact.
  for (int seed = 0; seed < 300; ++seed) {
    const History history = random_history(seed, 2 + seed, 2 + seed % 17);
    EXPECT_EQ(sums(counted(history, Residue::repeated)), from_the_largest(history)) << seed;
  }
}

TEST(Rainflow, IdentityDoesNotDependOnThePieces) {
  const History history = random_history(7, 997, 23);
  for (const Residue residue : {Residue::half_cycles, Residue::repeated}) {
    const auto whole = counted(history, residue, history.size());
    for (const std::size_t piece : {1U, 2U, 3U, 64U}) {
      const auto pieces = counted(history, residue, piece);
      ASSERT_EQ(pieces.size(), whole.size());
      for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(pieces[i].from.place, whole[i].from.place);
        EXPECT_EQ(pieces[i].to.place, whole[i].to.place);
        EXPECT_EQ(pieces[i].count, whole[i].count);
      }
    }
  }
}

TEST(Rainflow, IdentityLongHistoryOneByOne) {
  // Long pieces find 64 reversals at once; single values are taken one by one.  Steps of equal
  // values, sums beyond the largest number and tiny steps stand in groups of each kind.
  std::mt19937_64 generator(3);
  History history(20000);
  for (double& x : history) x = static_cast<double>(generator()) * 0x1p-63 - 1;
  for (std::size_t i = 2000; i < 4000; ++i) history[i] = std::round(4 * history[i]);
  for (std::size_t i = 5000; i < 15000; i += 1 + generator() % 200) history[i] = history[i - 1];
  for (std::size_t i = 6000; i < 6100; ++i) history[i] *= 0.8e308;
  for (std::size_t i = 7000; i < 7100; ++i) history[i] *= 5e-324;
  for (std::size_t i = 8000; i < 9000; ++i) history[i] = history[i - 1] + 0.01;
  for (const Residue residue : {Residue::half_cycles, Residue::repeated}) {
    const auto single = counted(history, residue, 1);
    for (const std::size_t piece : {63U, 64U, 65U, 577U, 20000U}) {
      const auto pieces = counted(history, residue, piece);
      ASSERT_EQ(pieces.size(), single.size()) << piece;
      for (std::size_t i = 0; i < single.size(); ++i) {
        ASSERT_EQ(pieces[i].from.place, single[i].from.place) << piece;
        ASSERT_EQ(pieces[i].to.place, single[i].to.place) << piece;
        ASSERT_EQ(pieces[i].from.value, single[i].from.value) << piece;
        ASSERT_EQ(pieces[i].to.value, single[i].to.value) << piece;
      }
    }
  }
  EXPECT_EQ(sums(counted(history, Residue::half_cycles, 20000)), by_three_points(history));
}

TEST(Rainflow, IdentityReversedAndMirrored) {
  const History history = random_history(11, 500, 40);
  History mirrored = history;
  for (double& x : mirrored) x = -x;
  for (const Residue residue : {Residue::half_cycles, Residue::repeated}) {
    Counts expected;
    for (const auto& [cycle, count] : sums(counted(history, residue)))
      expected[{cycle.first, 0.0 - cycle.second}] = count;
    EXPECT_EQ(sums(counted(mirrored, residue)), expected);
    History backwards(history.rbegin(), history.rend());
    EXPECT_EQ(by_range(counted(backwards, residue)), by_range(counted(history, residue)));
  }
}

TEST(Rainflow, IdentityPlacesAreThoseOfTheHistory) {
  const History history = {0, 2, 2, 2, 1, 1, 3, 3, 0, 0};
  for (const CountedCycle& cycle : counted(history, Residue::half_cycles)) {
    EXPECT_EQ(history.at(cycle.from.place), cycle.from.value);
    EXPECT_EQ(history.at(cycle.to.place), cycle.to.value);
  }
  // Of equal values the first one is the reversal.
  const auto cycles = counted(history, Residue::half_cycles);
  EXPECT_EQ(cycles.front().from.place, 1U);
  EXPECT_EQ(cycles.front().to.place, 4U);
}

// --- short and flat histories -------------------------------------------------------------------

TEST(Rainflow, LimitShortHistories) {
  for (const Residue residue : {Residue::half_cycles, Residue::repeated}) {
    EXPECT_TRUE(counted({}, residue).empty());
    EXPECT_TRUE(counted({3}, residue).empty());
    EXPECT_TRUE(counted({3, 3, 3}, residue).empty());
  }
  EXPECT_EQ(sums(counted({0, 5}, Residue::half_cycles)), (Counts{{{5, 2.5}, 0.5}}));
  EXPECT_EQ(sums(counted({0, 5}, Residue::repeated)), (Counts{{{5, 2.5}, 1.0}}));
  EXPECT_EQ(sums(counted({0, 2, 5}, Residue::repeated)), (Counts{{{5, 2.5}, 1.0}}));
}

TEST(Rainflow, LimitMemoryOfARepeatedCycle) {
  // A million equal cycles leave a few open reversals.
  RainflowCounter counter;
  double cycles = 0;
  const auto sink = [&](const CountedCycle& cycle) { cycles += cycle.count; };
  const History period = {0, 1, -1, 0.5};
  for (int i = 0; i < 250000; ++i) counter.add(period, sink);
  EXPECT_LT(counter.open().size(), 6U);
  EXPECT_EQ(counter.size(), 1000000U);
  counter.finish(Residue::repeated, sink);
  EXPECT_EQ(cycles, 500000.0);  // 1 to -1 and 0.5 to 0 in each period
}

TEST(Rainflow, InputOnlyFiniteValues) {
  const auto sink = [](const CountedCycle&) {};
  const auto message = [&](double value) -> std::string {
    RainflowCounter counter;
    counter.add(History{1, 2}, sink);
    try {
      counter.add(History{3, value}, sink);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(message(std::nan("")), "history: value 4 is nan; give finite numbers only");
  EXPECT_EQ(message(std::numeric_limits<double>::infinity()),
            "history: value 4 is inf; give finite numbers only");
  EXPECT_EQ(message(5), "");
}

TEST(Rainflow, InputOnlyFiniteValuesInLongPieces) {
  // The message counts the values exactly, wherever the value stands.
  const auto sink = [](const CountedCycle&) {};
  for (const double value : {std::nan(""), -std::numeric_limits<double>::infinity()})
    for (std::size_t place = 0; place < 700; place += 23) {
      History history = random_history(5, 700, 1000000);
      history[place] = value;
      std::string message;
      try {
        RainflowCounter().add(history, sink);
      } catch (const InputError& error) {
        message = error.what();
      }
      EXPECT_TRUE(message.starts_with("history: value " + std::to_string(place + 1) + " is "))
          << message;
    }
}

}  // namespace
}  // namespace strainwave
