// SPDX-License-Identifier: Apache-2.0
#include "condensed_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <utility>
#include <vector>

namespace strainwave::fem {
namespace {

using Eigen::Index;

/// Square cells of a grid, each with the unknowns of its four corners, two on each side, and one
/// inside.
std::vector<std::vector<Index>> grid(Index across, Index along) {
  std::vector<std::vector<Index>> elements;
  const Index row = across + 1;
  const Index corners = row * (along + 1);
  const Index flat = corners;
  const Index upright = flat + 2 * across * (along + 1);
  const Index inner = upright + 2 * row * along;
  for (Index j = 0; j < along; ++j)
    for (Index i = 0; i < across; ++i) {
      const Index below = flat + 2 * (j * across + i);
      const Index left = upright + 2 * (j * row + i);
      elements.push_back({inner + j * across + i, j * row + i, j * row + i + 1, (j + 1) * row + i,
                          (j + 1) * row + i + 1, below, below + 1, below + 2 * across,
                          below + 2 * across + 1, left + 1, left, left + 2, left + 3});
    }
  return elements;
}

Index unknowns_of(const std::vector<std::vector<Index>>& elements) {
  Index most = 0;
  for (const auto& element : elements)
    for (const Index i : element) most = std::max(most, i);
  return most + 1;
}

/// A positive definite matrix that differs for each element; its upper half must not be read.
Eigen::MatrixXd matrix_of(std::size_t e, Index n) {
  Eigen::MatrixXd root(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      root(i, j) =
          std::sin(1.0 + static_cast<double>(3 * i + 7 * j) + 0.7 * static_cast<double>(e));
  Eigen::MatrixXd k = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
  k.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
  return k;
}

Eigen::MatrixXd sum_of(const std::vector<std::vector<Index>>& elements) {
  const Index n = unknowns_of(elements);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto k = matrix_of(e, static_cast<Index>(elements[e].size()));
    sum(elements[e], elements[e]) += Eigen::MatrixXd(k.selfadjointView<Eigen::Lower>());
  }
  return sum;
}

std::optional<Eigen::MatrixXd> solved(const std::vector<std::vector<Index>>& elements,
                                      const Eigen::MatrixXd& loads) {
  return solve_condensed(
      elements, [&](std::size_t e) { return matrix_of(e, static_cast<Index>(elements[e].size())); },
      loads);
}

// Against the dense sum: one element, a strip, a block, two separate blocks, odd elements.
TEST(SolveCondensed, CrosscheckDenseSum) {
  auto two = grid(2, 3);
  const Index first = unknowns_of(two);
  for (auto element : grid(3, 1)) {
    for (Index& i : element) i += first;
    two.push_back(element);
  }
  auto more = grid(2, 2);
  more.insert(more.begin() + 1, {{}, {0, 8}, {3}});  // without unknowns, without own unknowns
  for (const auto& elements : {grid(1, 1), grid(1, 6), grid(5, 4), two, more}) {
    const Index n = unknowns_of(elements);
    Eigen::MatrixXd loads(n, 2);  // two columns that differ
    loads << Eigen::VectorXd::LinSpaced(n, -1, 2), Eigen::VectorXd::LinSpaced(n, 3, 1);
    const auto x = solved(elements, loads);
    ASSERT_TRUE(x);
    const Eigen::MatrixXd dense = sum_of(elements).ldlt().solve(loads);
    EXPECT_LT((*x - dense).norm() / dense.norm(), 1e-10) << n;  // rounding
  }
}

TEST(SolveCondensed, IdentityUnknownOfNoElementIsZero) {
  auto elements = grid(2, 2);
  const Index n = unknowns_of(elements);
  for (auto& element : elements)
    for (Index& i : element) i += i < 3 ? 0 : 2;  // 3 and 4 are in no element
  const Eigen::VectorXd load = Eigen::VectorXd::Ones(n + 2);
  const auto x = solved(elements, load);
  ASSERT_TRUE(x);
  EXPECT_EQ((*x)(3, 0), 0);
  EXPECT_EQ((*x)(4, 0), 0);
  EXPECT_NE((*x)(2, 0), 0);
}

TEST(SolveCondensed, InputNotPositiveDefiniteGivesNothing) {
  const std::vector<std::vector<Index>> chain = {{0, 1}, {1, 2}};
  const auto spring = [](double k) { return Eigen::MatrixXd{{k, -k}, {-k, k}}; };
  const Eigen::VectorXd load = Eigen::VectorXd::Ones(3);
  // The chain is not held; with springs of 0.1 and 0.3, rounding leaves a pivot near 1e-17.
  EXPECT_FALSE(solve_condensed(
      chain, [&](auto) { return spring(1); }, load));
  EXPECT_FALSE(solve_condensed(
      chain, [&](auto e) { return spring(e == 0 ? 0.1 : 0.3); }, load));
  const auto held = [&](double by) {
    return [=](std::size_t e) {
      Eigen::MatrixXd k = spring(1);
      if (e == 0) k(0, 0) += by;
      return k;
    };
  };
  EXPECT_FALSE(solve_condensed(chain, held(-0.5), load));
  const auto x = solve_condensed(chain, held(1e-10), load);  // held weakly
  ASSERT_TRUE(x);
  EXPECT_NEAR((*x)(0, 0) * 1e-10 / 3, 1, 1e-5);  // the sum of the load; 1e-16/1e-10
}

}  // namespace
}  // namespace strainwave::fem
