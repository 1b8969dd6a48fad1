// SPDX-License-Identifier: Apache-2.0
// Sums of columns and small systems of equations.
#include "columns.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace strainwave {
namespace {

/// A matrix with entries of both signs that repeat nowhere.
Eigen::MatrixXd entries(Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd matrix(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < columns; ++j)
      matrix(i, j) = std::sin(1.0 + 7.3 * static_cast<double>(i) + 2.9 * static_cast<double>(j));
  return matrix;
}

TEST(Columns, IdentityTheSumIsTheProduct) {
  // All remainders of the groups of eight, four and two columns.  Tolerance: rounding of 20 terms.
  for (Eigen::Index count = 0; count <= 20; ++count)
    for (const Eigen::Index rows : {0, 1, 2, 5, 8}) {
      const Eigen::MatrixXd columns = entries(rows, count);
      const Eigen::VectorXd factors = entries(count, 1);
      const Eigen::VectorXd before = entries(rows, 1);
      Eigen::VectorXd left = before;
      subtract_columns(
          left.data(), rows, count, [&](Eigen::Index p) { return columns.data() + p * rows; },
          [&](Eigen::Index p) { return factors[p]; });
      const Eigen::VectorXd expected = before - columns * factors;
      for (Eigen::Index i = 0; i < rows; ++i)
        EXPECT_NEAR(left[i], expected[i], 1e-14) << count << " " << rows;
    }
}

TEST(SmallCholesky, CrosscheckOtherFactors) {
  // Against Eigen's factors, at sizes on both sides of the groups of columns.  Tolerance: rounding
  // times the condition of the matrices, below 100.
  for (const Eigen::Index n : {1, 2, 3, 4, 5, 7, 8, 9, 11, 12, 16, 17, 31, 32, 33, 61}) {
    const Eigen::MatrixXd half = entries(n, n);
    const Eigen::MatrixXd matrix =
        Eigen::MatrixXd::Identity(n, n) + half * half.transpose() / static_cast<double>(n);
    Eigen::MatrixXd lower = matrix.triangularView<Eigen::Lower>();  // the rest is not read
    SmallCholesky small;
    ASSERT_TRUE(small.factor(lower)) << n;
    for (const double sign : {1.0, -1.0}) {
      const Eigen::VectorXd right = sign * entries(n, 2).col(1);
      Eigen::VectorXd found = right;
      small.solve(found);
      const Eigen::VectorXd expected = matrix.llt().solve(right);
      EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-13) << n;
    }
  }
}

TEST(SmallCholesky, InputAMatrixThatIsNotPositive) {
  // A pivot of zero, below zero, and not a number, in the first row and after it.
  for (const Eigen::Index n : {1, 9}) {
    for (const double last : {0.0, -1.0, std::nan("")}) {
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
      matrix(n - 1, n - 1) = last;
      EXPECT_FALSE(SmallCholesky().factor(matrix)) << n << " " << last;
    }
  }
}

}  // namespace
}  // namespace strainwave
