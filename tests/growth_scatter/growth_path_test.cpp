// SPDX-License-Identifier: Apache-2.0
// Lives of drawn paths against closed moments and the draws of another program.
#include "strainwave/growth_scatter/growth_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/quantile.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kLives = test::kSanitized ? 1000 : 10000;

/// One part of a path: its ends and its deviation.
struct PathCell {
  double from;
  double to;
  double deviation;
};

std::vector<PathCell> cells_of(GrowthPath path, double from, double end) {
  std::vector<PathCell> cells;
  while (from < end) {
    const double to = std::min(path.end(), end);
    cells.push_back({from, to, path.deviation()});
    from = to;
    path.next();
  }
  return cells;
}

/// Share of a part of the path in a life by Paris' law with K proportional to the root of the size.
double share_of(double m, double from, double to, double end) {
  const double power = 1 - m / 2;
  return (std::pow(to, power) - std::pow(from, power)) / (std::pow(end, power) - 1);
}

/// Life over that without scatter.
double life_of(const PathScatter& scatter, double level, double m, double end, std::size_t draw) {
  double life = 0.0;
  for (const PathCell& cell : cells_of(GrowthPath(scatter, 5, draw, 1.0), 1.0, end))
    life += share_of(m, cell.from, cell.to, end) * std::exp(-cell.deviation);
  return life * std::exp(-level * counter_normal(6, draw, 0));
}

double mean_of(const std::vector<double>& v) {
  return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}
double spread_of(const std::vector<double>& v) {
  const double mean = mean_of(v);
  double sum = 0.0;
  for (const double x : v) sum += (x - mean) * (x - mean);
  return std::sqrt(sum / static_cast<double>(v.size()));
}

// Kind: reference (GS-12), (GS-13), tools/reference/scattered_paths.py, which integrates the
// covariance of the process without cells and draws on another grid.  Tolerance: four standard
// errors of the draws of both, and 0.2 % for the cells.
TEST(GrowthPath, ReferenceLives) {
  int cases = 0;
  for (const test::CsvRow& row : test::read_reference_csv("scattered_paths")) {
    if (row.quantity != "mean") continue;
    ++cases;
    const PathScatter scatter{
        .wander = row.inputs.at("wander"),
        .wander_length = row.inputs.at("wander") > 0 ? row.inputs.at("wander_length") : 0.0,
        .white = row.inputs.at("white"),
        .white_step = row.inputs.at("white") > 0 ? row.inputs.at("white_step") : 0.0};
    std::vector<double> lives(kLives);
    for (std::size_t i = 0; i < kLives; ++i)
      lives[i] =
          life_of(scatter, row.inputs.at("level"), row.inputs.at("m"), row.inputs.at("end"), i);
    const double root = std::sqrt(static_cast<double>(kLives));
    for (const test::CsvRow& other : test::read_reference_csv("scattered_paths")) {
      if (other.inputs != row.inputs) continue;
      const double spread = spread_of(lives);
      const double errors = 4 * spread / root;
      // Log-normal lives have more than a normal error of their deviation.
      const std::map<std::string, std::pair<double, double>> expected = {
          {"mean", {mean_of(lives), errors}},
          {"deviation", {spread, 1.3 * errors + 0.002 * spread}},
          {"low", {quantile(lives, 0.05), 2.3 * errors + 0.002}},
          {"median", {quantile(lives, 0.5), 1.4 * errors + 0.002}},
          {"high", {quantile(lives, 0.95), 3 * errors + 0.002}}};
      const auto& [value, tolerance] = expected.at(other.quantity);
      EXPECT_NEAR(value, other.value, tolerance) << other.quantity << " of case " << cases;
    }
  }
  EXPECT_EQ(cases, 5);
}

// Kind: reference (GS-13).  At constant K the life is a sum of log-normal steps.  With white steps
// of equal length n = 12: mean e^(w^2/2), variance e^(w^2) (e^(w^2) - 1)/n.  Tolerance: four
// standard errors.
TEST(GrowthPath, ReferenceSumOfLogNormalSteps) {
  constexpr double kWhite = 0.4;
  const PathScatter scatter{.white = kWhite, .white_step = 0.25};
  std::vector<double> lives(kLives);
  for (std::size_t i = 0; i < kLives; ++i) lives[i] = life_of(scatter, 0.0, 0.0, 4.0, i);
  const double square = kWhite * kWhite;
  const double spread = std::sqrt(std::exp(square) * std::expm1(square) / 12);
  const double errors = 4 / std::sqrt(static_cast<double>(kLives));
  EXPECT_NEAR(mean_of(lives), std::exp(square / 2), errors * spread);
  EXPECT_NEAR(spread_of(lives), spread, errors * spread);
}

// Kind: limit (GS-12).  A small scatter acts linearly: ln N deviates by minus the mean of the
// deviations, each with its share of the life; the next term is half of their variance over the
// path.
TEST(GrowthPath, LimitOfASmallScatter) {
  for (const double scale : {1e-2, 1e-3}) {
    const PathScatter scatter{
        .wander = 0.8 * scale, .wander_length = 0.3, .white = 0.6 * scale, .white_step = 0.2};
    double largest = 0.0;
    for (std::size_t draw = 0; draw < 20; ++draw) {
      double linear = 0.0;
      double square = 0.0;
      for (const PathCell& cell : cells_of(GrowthPath(scatter, 5, draw, 1.0), 1.0, 4.0)) {
        const double share = share_of(3.0, cell.from, cell.to, 4.0);
        linear -= share * cell.deviation;
        square += share * cell.deviation * cell.deviation;
      }
      const double next = (square - linear * linear) / 2;
      EXPECT_NEAR(std::log(life_of(scatter, 0.0, 3.0, 4.0, draw)), linear + next,
                  20 * std::pow(scale, 3));
      largest = std::max(largest, std::abs(linear));
    }
    EXPECT_GT(largest, 0.3 * scale);
  }
}

// Kind: identity (GS-13).  The cells end where they are said to, whatever came before; the numbers
// depend on seed, draw and place alone; a part that is left out changes nothing of the other.
TEST(GrowthPath, IdentityCells) {
  const PathScatter both{.wander = 0.2, .wander_length = 0.8, .white = 0.3, .white_step = 0.15};
  const std::vector<PathCell> cells = cells_of(GrowthPath(both, 5, 2, 1.0), 1.0, 2.0);
  PathScatter wander = both;
  wander.white_step = 0.0;
  PathScatter white = both;
  white.wander_length = 0.0;
  const std::vector<PathCell> wanders = cells_of(GrowthPath(wander, 5, 2, 1.0), 1.0, 2.0);
  const std::vector<PathCell> whites = cells_of(GrowthPath(white, 5, 2, 1.0), 1.0, 2.0);
  ASSERT_EQ(wanders.size(), 7U);  // ln 2 in cells of 0.1
  ASSERT_EQ(whites.size(), 7U);
  test::expect_relative(wanders[2].to, std::exp(0.3), 1e-14);
  test::expect_relative(whites[2].to, 1.45, 1e-14);
  const auto deviation_at = [](const std::vector<PathCell>& of, double size) {
    return std::ranges::find_if(of, [&](const PathCell& cell) { return size < cell.to; })
        ->deviation;
  };
  for (const PathCell& cell : cells) {
    const double middle = (cell.from + cell.to) / 2;
    EXPECT_EQ(cell.deviation, deviation_at(wanders, middle) + deviation_at(whites, middle));
  }
  EXPECT_NE(GrowthPath(both, 5, 3, 1.0).deviation(), cells[0].deviation);
  EXPECT_NE(GrowthPath(both, 6, 2, 1.0).deviation(), cells[0].deviation);
  EXPECT_TRUE(std::isinf(GrowthPath({}, 5, 2, 1.0).end()));
}

// Kind: reference (GS-13).  The correlated part of neighbouring cells has the correlation
// exp(-1/8), and a crack that goes on in another measure of its size keeps its deviation.
TEST(GrowthPath, ReferenceMemory) {
  const PathScatter scatter{.wander = 0.2, .wander_length = 0.8};
  double product = 0.0;
  double square = 0.0;
  for (std::size_t draw = 0; draw < kLives; ++draw) {
    GrowthPath path(scatter, 5, draw, 1.0);
    const double first = path.deviation();
    path.go_on(3.0);
    EXPECT_EQ(path.deviation(), first);
    test::expect_relative(path.end(), 3 * std::exp(0.1), 1e-14);
    path.next();
    product += first * path.deviation();
    square += path.deviation() * path.deviation();
  }
  const auto n = static_cast<double>(kLives);
  const double errors = 4 / std::sqrt(n);
  EXPECT_NEAR(square / n, 0.04, 0.04 * std::sqrt(2.0) * errors);
  EXPECT_NEAR(product / n, 0.04 * std::exp(-0.125), 0.04 * std::sqrt(2.0) * errors);
}

}  // namespace
}  // namespace strainwave
