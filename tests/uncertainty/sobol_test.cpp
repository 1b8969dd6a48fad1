// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/uncertainty/normal.hpp"
#include "strainwave/uncertainty/sobol_indices.hpp"
#include "strainwave/uncertainty/sobol_points.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

// --- Points
// ---------------------------------------------------------------------------------------

// Kind: identity (UQ-1).  Among 2^k scrambled points, each interval of length 2^-k has one, in each
// dimension; each box of 2^-i by 2^-(k-i) has one in the first two dimensions.
TEST(SobolPoints, IdentityScrambledPointsAreBalanced) {
  constexpr std::size_t kPoints = 64;
  const SobolPoints points(12, kPoints);
  for (std::uint64_t scrambling = 1; scrambling < 6; ++scrambling) {
    for (std::size_t d = 0; d < 12; ++d) {
      std::set<int> intervals;
      for (std::size_t n = 0; n < kPoints; ++n)
        intervals.insert(static_cast<int>(points.at(n, d, scrambling) * kPoints));
      EXPECT_EQ(intervals.size(), kPoints) << d;
    }
    for (int i = 0; i <= 6; ++i) {
      std::set<std::array<int, 2>> boxes;
      for (std::size_t n = 0; n < kPoints; ++n)
        boxes.insert({static_cast<int>(points.at(n, 0, scrambling) * (1 << i)),
                      static_cast<int>(points.at(n, 1, scrambling) * (1 << (6 - i)))});
      EXPECT_EQ(boxes.size(), kPoints) << i;
    }
  }
}

TEST(SobolPoints, BehaviourScramblingsDifferAndRepeat) {
  const SobolPoints points(2, 8);
  EXPECT_EQ(points.at(3, 1, 7), points.at(3, 1, 7));
  EXPECT_NE(points.at(3, 1, 7), points.at(3, 1, 8));
  EXPECT_NE(points.at(3, 1, 7), points.at(3, 0, 7));
  EXPECT_GT(points.at(0, 0, 1), 0.0);
}

// --- Indices
// --------------------------------------------------------------------------------------

double uniform(double z) { return normal_probability(z); }

InputGroups each_alone(std::size_t inputs) {
  InputGroups groups;
  for (std::size_t i = 0; i < inputs; ++i) groups.push_back({i});
  return groups;
}

/// The function of Ishigami and Homma, a = 7, b = 0.1, of uniform inputs in (-pi, pi).
NormalFunction ishigami() {
  return [](std::span<const double> z, std::span<double> y) {
    const auto x = [&](std::size_t i) { return pi * (2 * uniform(z[i]) - 1); };
    const double s = std::sin(x(1));
    y[0] = std::sin(x(0)) + 7 * s * s + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
    return true;
  };
}

struct Known {
  std::vector<double> first;
  std::vector<double> total;
  double variance;
};

Known known_ishigami() {
  const double a = 7;
  const double b = 0.1;
  const double v1 = 0.5 * std::pow(1 + b * std::pow(pi, 4) / 5, 2);
  const double v2 = a * a / 8;
  const double v13 = b * b * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50);
  const double v = v1 + v2 + v13;
  return {{v1 / v, v2 / v, 0}, {(v1 + v13) / v, v2 / v, v13 / v}, v};
}

const std::array<double, 5> kG = {0, 1, 4.5, 9, 99};

/// The g-function of Saltelli and Sobol.
NormalFunction g_function() {
  return [](std::span<const double> z, std::span<double> y) {
    y[0] = 1;
    for (std::size_t i = 0; i < kG.size(); ++i)
      y[0] *= (std::abs(4 * uniform(z[i]) - 2) + kG[i]) / (1 + kG[i]);
    return true;
  };
}

Known known_g() {
  const auto part = [](std::size_t i) { return 1.0 / 3 / std::pow(1 + kG[i], 2); };
  double all = 1;
  for (std::size_t i = 0; i < kG.size(); ++i) all *= 1 + part(i);
  Known known{{}, {}, all - 1};
  for (std::size_t i = 0; i < kG.size(); ++i) {
    known.first.push_back(part(i) / (all - 1));
    known.total.push_back(part(i) * all / (1 + part(i)) / (all - 1));
  }
  return known;
}

void expect_known(const NormalFunction& function, const Known& known) {
  const auto study = sobol_indices([&] { return function; }, each_alone(known.first.size()), 1,
                                   {.points = 1 << 15, .seed = 3});
  const SobolOutput& output = study.output[0];
  test::expect_relative(output.variance, known.variance, 5e-3);
  ASSERT_EQ(output.group.size(), known.first.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < known.first.size(); ++i) {
    EXPECT_NEAR(output.group[i].first.value, known.first[i], 8e-3) << i;
    EXPECT_NEAR(output.group[i].total.value, known.total[i], 8e-3) << i;
    sum += known.first[i];
  }
  EXPECT_NEAR(output.first_sum.value, sum, 8e-3);
  EXPECT_EQ(study.left_out, 0U);
  EXPECT_EQ(study.evaluations, (known.first.size() + 2) << 15);
}

// Kind: reference (UQ-2, UQ-3).  Source: closed forms, saltelli2010 (secondary).  Tolerance: 0.008,
// three times the standard error of 32768 points.
TEST(SobolIndices, ReferenceIshigami) { expect_known(ishigami(), known_ishigami()); }
TEST(SobolIndices, ReferenceGFunction) { expect_known(g_function(), known_g()); }

// Kind: reference.  The 95 % intervals contain the true share in about 95 of 100 studies.  With 240
// trials of a true 95 % interval, fewer than 211 or more than 239 have a probability below 1e-4.
TEST(SobolIndices, ReferenceIntervalsContainTheTruth) {
  const Known known = known_ishigami();
  int inside = 0;
  int trials = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto study =
        sobol_indices([] { return ishigami(); }, each_alone(3), 1, {.points = 1024, .seed = seed});
    for (std::size_t i = 0; i < 3; ++i)
      for (const auto& [estimate, truth] :
           {std::pair{study.output[0].group[i].first, known.first[i]},
            std::pair{study.output[0].group[i].total, known.total[i]}}) {
        ++trials;
        inside += estimate.low <= truth && truth <= estimate.high ? 1 : 0;
      }
  }
  EXPECT_EQ(trials, 240);
  EXPECT_GE(inside, 211);
  EXPECT_LE(inside, 239);
}

// Kind: identity.  A sum of inputs has no interactions: first and total shares agree, and add up.
TEST(SobolIndices, IdentityASumHasNoInteractions) {
  const auto study = sobol_indices(
      [] {
        return [](std::span<const double> z, std::span<double> y) {
          y[0] = 3 * z[0] + 4 * z[1];
          y[1] = 5.0;
          return true;
        };
      },
      each_alone(2), 2, {.points = 4096});
  const SobolOutput& output = study.output[0];
  EXPECT_NEAR(output.variance, 25, 0.2);
  EXPECT_NEAR(output.group[0].total.value, 0.36, 3e-3);
  EXPECT_NEAR(output.group[1].first.value, 0.64, 5e-3);
  EXPECT_NEAR(output.mean, 0, 0.01);
  // A constant has no shares.
  EXPECT_EQ(study.output[1].variance, 0);
  EXPECT_EQ(study.output[1].mean, 5);
  EXPECT_TRUE(study.output[1].group.empty());
}

TEST(SobolIndices, IdentityForAnyNumberOfThreads) {
  const auto with = [](int threads) {
    return sobol_indices([] { return ishigami(); }, each_alone(3), 1,
                         {.points = 256, .seed = 5, .threads = threads});
  };
  const auto one = with(1);
  for (const int threads : {2, 3, 8})
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(with(threads).output[0].group[i].total.value, one.output[0].group[i].total.value);
      EXPECT_EQ(with(threads).output[0].group[i].first.low, one.output[0].group[i].first.low);
    }
}

// Kind: behaviour.  Points without a value are left out and counted.
TEST(SobolIndices, BehaviourPointsWithoutAValueAreLeftOut) {
  const auto cut = [](double limit) {
    return sobol_indices(
        [limit] {
          return [limit](std::span<const double> z, std::span<double> y) {
            y[0] = z[0] + z[1];
            return z[0] < limit;
          };
        },
        each_alone(2), 1, {.points = 1024});
  };
  const auto study = cut(2.0);  // 2.3 % of the draws of z[0] are above, and each point has two
  EXPECT_NEAR(static_cast<double>(study.left_out), 1024 * 0.045, 10);
  EXPECT_EQ(test::broken_rule([&] { return cut(2.0); }), "no error");
  EXPECT_THROW((void)cut(-6.0), SolverError);
}

// Kind: behaviour (UQ-3).  An output that seldom changes varies, although it stands still in some
// replicates: 1.35 of 1000 draws are above 3, so 256 points of a replicate often have none.
TEST(SobolIndices, BehaviourAnOutputThatSeldomChanges) {
  const NormalFunction seldom = [](std::span<const double> z, std::span<double> y) {
    y[0] = z[0] > 3 ? 1.0 : 0.0;
    return true;
  };
  const auto study = sobol_indices([&] { return seldom; }, each_alone(2), 1, {.points = 4096});
  EXPECT_NEAR(study.output[0].variance, 1.35e-3, 0.4e-3);
  ASSERT_EQ(study.output[0].group.size(), 2U);
  EXPECT_NEAR(study.output[0].group[0].total.value, 1.0, 0.4);
  EXPECT_EQ(study.output[0].group[1].total.value, 0.0);
}

TEST(SobolIndices, InputOptionsOutOfRange) {
  const auto refusal = [](int points, int replicates, std::size_t inputs = 1) {
    return test::broken_rule([&] {
      return sobol_indices([] { return ishigami(); }, each_alone(inputs), 1,
                           {.points = points, .replicates = replicates});
    });
  };
  EXPECT_EQ(refusal(100, 16),
            "points = 100 violates: a multiple of 16, the replicates, and at least twice as many");
  EXPECT_EQ(refusal(16, 16),
            "points = 16 violates: a multiple of 16, the replicates, and at least twice as many");
  EXPECT_EQ(refusal(16, 1), "replicates = 1 violates: >= 2");
  EXPECT_EQ(refusal(32, 16, 0), "inputs = 0 violates: >= 1 and <= 500");
  EXPECT_EQ(refusal(32, 16, 501), "inputs = 501 violates: >= 1 and <= 500");
  EXPECT_EQ(test::broken_rule([] {
              return sobol_indices([] { return ishigami(); }, {{0}, {1, 3}}, 1, {.points = 32});
            }),
            "group = 3 violates: the index of one of the 3 inputs");
}

// Kind: reference.  Two groups of a linear function: the shares are those of the sums of squares,
// also if the function adds up the members of a group.  Tolerance: ten times the usual error.
TEST(SobolIndices, ReferenceGroupsOfInputs) {
  const auto study = sobol_indices(
      [] {
        return [](std::span<const double> u, std::span<double> y) {
          y[0] = 3 * u[0] + 4 * u[1] + 12 * u[2];
          return true;
        };
      },
      {{0, 2}, {1}}, 1, {.points = 4096});
  ASSERT_EQ(study.output[0].group.size(), 2U);
  EXPECT_EQ(study.evaluations, 4096U * 4);
  EXPECT_NEAR(study.output[0].group[0].first.value, 153.0 / 169, 1e-2);
  EXPECT_NEAR(study.output[0].group[0].total.value, 153.0 / 169, 1e-2);
  EXPECT_NEAR(study.output[0].group[1].total.value, 16.0 / 169, 1e-2);
}

}  // namespace
}  // namespace strainwave
