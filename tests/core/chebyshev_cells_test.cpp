// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/chebyshev_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

namespace strainwave {
namespace {

using Place = ChebyshevCells::Place;
using Values = ChebyshevCells::Values;

/// Three smooth functions of three variables.
bool smooth(const Place& x, Values& f) {
  f[0] = std::exp(x[0] - 0.5 * x[1]) / (2 + std::sin(x[2]));
  f[1] = std::log(3 + x[0] * x[1]) + x[2];
  f[2] = 1.0;
  return true;
}

Place random_place(int n, double width) {
  const auto turned = [&](double by) { return width * (2 * std::fmod(n * by, 1.0) - 1); };
  return {turned(0.754877666), turned(0.569840296), turned(0.430159709)};
}

// Kind: cross-check (ST-22).  Source: the function itself.  Tolerance: the one asked of the cells,
// relative to the largest value in a box, which is up to 3 times the value here.
TEST(ChebyshevCells, CrosscheckSmoothFunctionsOfOneToThreeVariables) {
  for (std::size_t variables = 1; variables <= 3; ++variables) {
    ChebyshevCells cells(
        [&](const Place& place, Values& values) {
          Place x = place;
          for (std::size_t v = variables; v < 3; ++v) x[v] = 0.1;
          return smooth(x, values);
        },
        {.widths = std::vector<double>(variables, 0.5), .values = 3});
    ChebyshevCells::Reader read(cells);
    for (int n = 0; n < 400; ++n) {
      Place place = random_place(n, 1.0);
      Values values{};
      ASSERT_TRUE(read(place, values));
      for (std::size_t v = variables; v < 3; ++v) place[v] = 0.1;
      Values exact{};
      (void)smooth(place, exact);
      for (std::size_t p = 0; p < 3; ++p)
        ASSERT_NEAR(values[p], exact[p], 3e-11 * std::abs(exact[p])) << n << ' ' << p;
    }
    EXPECT_LT(cells.largest_error(), 1e-11);
    EXPECT_GT(cells.largest_error(), 0.0);
  }
}

// Kind: behaviour.  A pole at 1e-2 from the axis needs boxes of its own size, which halving finds.
TEST(ChebyshevCells, BehaviourBoxesAreHalvedWhereTheFunctionIsSharp) {
  const auto sharp = [](double x) { return 1 / (x * x + 1e-4); };
  ChebyshevCells cells(
      [&](const Place& place, Values& values) {
        values[0] = sharp(place[0]);
        return true;
      },
      {.widths = {0.5}});
  ChebyshevCells::Reader read(cells);
  for (int n = 0; n < 2000; ++n) {
    const double x = n * 1e-4 - 0.1;
    Values values{};
    ASSERT_TRUE(read({x}, values)) << x;
    // the largest value of a box may be 100 times the value at x
    ASSERT_NEAR(values[0] / sharp(x), 1, 1e-9) << x;
  }
}

// Kind: behaviour.  The 16th Chebyshev polynomial of a box is -1 at all of its nodes, as a constant
// is.  Only the comparison between the nodes finds the difference.
TEST(ChebyshevCells, BehaviourAWaveThatTheNodesDoNotSeeIsFound) {
  const auto wave = [](double x) { return 3 + std::cos(16 * std::acos(4 * x - 1)); };
  ChebyshevCells cells(
      [&](const Place& place, Values& values) {
        values[0] = wave(place[0]);
        return true;
      },
      {.widths = {0.5}});
  ChebyshevCells::Reader read(cells);
  for (int n = 1; n < 50; ++n) {
    const double x = 0.01 * n;
    Values values{};
    ASSERT_TRUE(read({x}, values)) << x;
    EXPECT_NEAR(values[0], wave(x), 1e-10) << x;
  }
}

// Kind: behaviour.  Only the second variable needs smaller boxes, six halvings for 1e-11 with eight
// nodes.  Its highest coefficients are all negative, and halving along the first variable would not
// help.
TEST(ChebyshevCells, BehaviourABoxIsHalvedAlongTheVariableThatNeedsIt) {
  const auto falling = [](double x, double y) { return (2 + 0.1 * x) * -std::exp(12 * y); };
  ChebyshevCells cells(
      [&](const Place& place, Values& values) {
        values[0] = falling(place[0], place[1]);
        return true;
      },
      {.widths = {1.0, 1.0}, .halvings = 7});
  ChebyshevCells::Reader read(cells);
  for (int n = 0; n < 50; ++n) {
    const double x = std::fmod(n * 0.754877666, 1.0);
    const double y = std::fmod(n * 0.569840296, 1.0);
    Values values{};
    ASSERT_TRUE(read({x, y}, values)) << x << ' ' << y;
    ASSERT_NEAR(values[0] / falling(x, y), 1, 1e-10) << x << ' ' << y;
  }
}

// Kind: behaviour.  At a kink no polynomial converges, so the box there says that it has none;
// beside the kink polynomials answer.
TEST(ChebyshevCells, BehaviourABoxWithAKinkHasNoPolynomial) {
  ChebyshevCells cells(
      [](const Place& place, Values& values) {
        values[0] = 1 + std::abs(place[0] - 0.2);
        return true;
      },
      {.widths = {0.5}, .halvings = 6});
  ChebyshevCells::Reader read(cells);
  Values values{};
  EXPECT_FALSE(read({0.2}, values));
  EXPECT_TRUE(read({0.45}, values));
  EXPECT_NEAR(values[0], 1.25, 1e-14);
}

// Kind: behaviour.  Where the function has no value, or none that is finite, no polynomial answers.
TEST(ChebyshevCells, BehaviourNoPolynomialWhereTheFunctionHasNoValue) {
  ChebyshevCells cells(
      [](const Place& place, Values& values) {
        values[0] = place[0] > 2 ? std::nan("") : 1.0;
        return place[0] > 1;
      },
      {.widths = {0.5}});
  ChebyshevCells::Reader read(cells);
  Values values{};
  EXPECT_FALSE(read({0.2}, values));
  EXPECT_TRUE(read({1.2}, values));
  EXPECT_FALSE(read({2.2}, values));
}

// Kind: identity.  The answer depends on the place alone: not on the order of the questions, nor on
// the number of threads.
TEST(ChebyshevCells, IdentityForAnyOrderAndAnyNumberOfThreads) {
  const ChebyshevCells::Options options{.widths = {0.5, 0.5}, .values = 2};
  constexpr int kPlaces = 500;
  std::vector<double> ascending(kPlaces);
  ChebyshevCells one(smooth, options);
  ChebyshevCells::Reader read(one);
  for (int n = 0; n < kPlaces; ++n) {
    Values values{};
    ASSERT_TRUE(read(random_place(n, 1.5), values));
    ascending[static_cast<std::size_t>(n)] = values[0];
  }
  ChebyshevCells other(smooth, options);
  std::vector<double> together(kPlaces);
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&, t] {
        ChebyshevCells::Reader of_thread(other);
        for (int n = kPlaces - 1 - t; n >= 0; n -= 4) {
          Values values{};
          (void)of_thread(random_place(n, 1.5), values);
          together[static_cast<std::size_t>(n)] = values[0];
        }
      });
  }
  EXPECT_EQ(ascending, together);
  EXPECT_EQ(one.evaluations(), other.evaluations());
}

// Kind: limit.  Both sides of the border between two boxes: the function is continuous there, so
// the polynomials must agree within their tolerance, and their slopes within a hundred times that.
TEST(ChebyshevCells, LimitBothSidesOfABorder) {
  ChebyshevCells cells(smooth, {.widths = {0.5}});
  ChebyshevCells::Reader read(cells);
  const auto at = [&](double x) {
    Values values{};
    EXPECT_TRUE(read({x}, values));
    return values[0];
  };
  for (const double border : {-0.5, 0.0, 0.5, 1.0}) {
    EXPECT_NEAR(at(std::nextafter(border, -9)) / at(border), 1, 2e-11);
    const double h = 1e-3;
    const double below = (at(border - 1e-12) - at(border - h)) / h;
    const double above = (at(border + h) - at(border)) / h;
    // the second derivative times h, and the errors over h
    EXPECT_NEAR(below / above, 1, 1.01e-3) << border;
  }
}

}  // namespace
}  // namespace strainwave
