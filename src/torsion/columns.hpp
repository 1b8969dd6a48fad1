// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <cstddef>

// Sums of columns, and systems of some dozens of equations.  At this size the blocks that Eigen
// makes for large matrices cost more than the arithmetic.

namespace strainwave {

/// Subtracts columns, each times its own factor, from a vector.
/// @param column  p -> first entry of column p
/// @param factor  p -> factor of column p
template <class Column, class Factor>
void subtract_columns(double* __restrict__ from, Eigen::Index rows, Eigen::Index count,
                      const Column& column, const Factor& factor) {
  Eigen::Index p = 0;
  // Eight in one pass keep the sums in registers.
  for (; p + 8 <= count; p += 8) {
    const double* const c0 = column(p);
    const double* const c1 = column(p + 1);
    const double* const c2 = column(p + 2);
    const double* const c3 = column(p + 3);
    const double* const c4 = column(p + 4);
    const double* const c5 = column(p + 5);
    const double* const c6 = column(p + 6);
    const double* const c7 = column(p + 7);
    const double f0 = factor(p);
    const double f1 = factor(p + 1);
    const double f2 = factor(p + 2);
    const double f3 = factor(p + 3);
    const double f4 = factor(p + 4);
    const double f5 = factor(p + 5);
    const double f6 = factor(p + 6);
    const double f7 = factor(p + 7);
    for (Eigen::Index i = 0; i < rows; ++i)
      from[i] -= ((f0 * c0[i] + f1 * c1[i]) + (f2 * c2[i] + f3 * c3[i])) +
                 ((f4 * c4[i] + f5 * c5[i]) + (f6 * c6[i] + f7 * c7[i]));
  }
  if (p + 4 <= count) {
    const double* const c0 = column(p);
    const double* const c1 = column(p + 1);
    const double* const c2 = column(p + 2);
    const double* const c3 = column(p + 3);
    const double f0 = factor(p);
    const double f1 = factor(p + 1);
    const double f2 = factor(p + 2);
    const double f3 = factor(p + 3);
    for (Eigen::Index i = 0; i < rows; ++i)
      from[i] -= (f0 * c0[i] + f1 * c1[i]) + (f2 * c2[i] + f3 * c3[i]);
    p += 4;
  }
  if (p + 2 <= count) {
    const double* const c0 = column(p);
    const double* const c1 = column(p + 1);
    const double f0 = factor(p);
    const double f1 = factor(p + 1);
    for (Eigen::Index i = 0; i < rows; ++i) from[i] -= f0 * c0[i] + f1 * c1[i];
    p += 2;
  }
  if (p < count) {
    const double* const c = column(p);
    const double f = factor(p);
    for (Eigen::Index i = 0; i < rows; ++i) from[i] -= f * c[i];
  }
}

/// Cholesky's factors of a symmetric matrix.
class SmallCholesky {
 public:
  /// Factors the lower part of a matrix.  Returns false if the matrix is not positive definite.
  [[nodiscard]] bool factor(Eigen::MatrixXd matrix);
  /// Solves the system for one right-hand side, in place.
  void solve(Eigen::VectorXd& right) const;

 private:
  [[nodiscard]] const double* below(Eigen::Index row, Eigen::Index column) const {
    return lower_.data() + column * lower_.rows() + row;
  }
  Eigen::MatrixXd lower_;    // the factor below its diagonal; the rest is not used
  Eigen::VectorXd inverse_;  // of the factor's diagonal
};

}  // namespace strainwave
