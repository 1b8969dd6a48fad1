// SPDX-License-Identifier: Apache-2.0
// The private equation solver, against dense matrices of Eigen.
#include "direct_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/fem/memory_error.hpp"
#include "support/mpi.hpp"

namespace strainwave::fem {
namespace {

/// Symmetric positive definite, full.
Eigen::MatrixXd definite(Eigen::Index n) {
  Eigen::MatrixXd a(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) a(i, j) = std::sin(static_cast<double>(1 + 3 * i + 7 * j));
  return a * a.transpose() + Eigen::MatrixXd::Identity(n, n);
}

SymmetricEntries lower_entries(const Eigen::MatrixXd& a) {
  SymmetricEntries entries;
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j <= i; ++j) {  // in two parts, the second in the other triangle
      entries.add(i + 1, j + 1, 0.25 * a(i, j));
      entries.add(j + 1, i + 1, 0.75 * a(i, j));
    }
  return entries;
}

// The tolerance is rounding.
TEST(DirectSolver, CrosscheckDenseMatrix) {
  test::start_mpi();
  const Eigen::MatrixXd a = definite(12);
  std::vector<double> rhs(12);
  for (std::size_t i = 0; i < rhs.size(); ++i) rhs[i] = static_cast<double>(i) - 4;
  const Eigen::VectorXd expected = a.llt().solve(Eigen::Map<Eigen::VectorXd>(rhs.data(), 12));
  DirectSolver solver(lower_entries(a), 12);
  EXPECT_GT(solver.operations(), 0);
  std::vector<double> both = rhs;  // followed by a second load, twice as large
  for (const double f : rhs) both.push_back(2 * f);
  for (const std::vector<double>& found : {solver.solve(rhs), solver.solve(both, 2)})
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], (i < 12 ? 1 : 2) * expected(static_cast<Eigen::Index>(i % 12)),
                  1e-11 * expected.norm())
          << i;
}

// Separate cells leave no unknowns for the solver.
TEST(DirectSolver, LimitNoUnknowns) {
  test::start_mpi();
  DirectSolver solver({}, 0);
  EXPECT_TRUE(solver.solve({}).empty());
  EXPECT_EQ(solver.megabytes(), 0.0);
  EXPECT_EQ(solver.operations(), 0.0);
}

// A workspace that is too small only causes a repetition.
TEST(DirectSolver, IdentityWorkspaceThatWasTooSmall) {
  test::start_mpi();
  const Eigen::MatrixXd a = definite(300);
  const std::vector<double> rhs(300, 1.0);
  DirectSolver ample(lower_entries(a), 300);
  DirectSolver scant(lower_entries(a), 300, -90);
  EXPECT_EQ(ample.repeats(), 0);
  EXPECT_GT(scant.repeats(), 0);
  EXPECT_EQ(scant.solve(rhs), ample.solve(rhs));
}

// Faults of the machine, of the problem and of the program give different exceptions.
TEST(DirectSolver, InputFaultsByCode) {
  EXPECT_NO_THROW(check_mumps(0, 0));
  EXPECT_NO_THROW(check_mumps(1, 0));  // a warning
  for (const int code : {-5, -7, -13, -19}) EXPECT_THROW(check_mumps(code, 1), MemoryError);
  const auto is_memory = [](int code) {
    try {
      check_mumps(code, 1);
    } catch (const MemoryError&) {
      return true;
    } catch (const SolverError&) {
    }
    return false;
  };
  EXPECT_FALSE(is_memory(-10));
  try {
    check_mumps(-3, 7);
    ADD_FAILURE();
  } catch (const SolverError&) {
    ADD_FAILURE() << "not of the problem";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the direct solver failed (code -3, 7)");
  }
}

// FE-45: the matrix after elimination of the inner unknowns is the inverse of the outer block of
// the inverse.
TEST(DirectSolver, IdentityCondensedMatrix) {
  const Eigen::MatrixXd a = definite(9);
  const Eigen::MatrixXd inverse = a.inverse();
  for (const Eigen::Index inner : {0, 1, 5}) {
    const Eigen::Index outer = 9 - inner;
    const CondensedMatrix found = condense(a.triangularView<Eigen::Lower>(), inner);
    const Eigen::MatrixXd all = found.outer.selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd expected = inverse.bottomRightCorner(outer, outer).inverse();
    EXPECT_LT((all - expected).norm(), 1e-11 * a.norm()) << inner;
    const Eigen::MatrixXd factor = found.factor.triangularView<Eigen::Lower>();
    EXPECT_LT((factor * found.coupling - a.topRightCorner(inner, outer)).norm(), 1e-12 * a.norm());
  }
}

TEST(DirectSolver, IdentityLowerSquare) {
  const Eigen::MatrixXd a = definite(7).leftCols(4);
  const Eigen::MatrixXd found = lower_square(a).selfadjointView<Eigen::Lower>();
  EXPECT_LT((found - a * a.transpose()).norm(), 1e-13 * found.norm());
}

TEST(DirectSolver, InputNotDefinite) {
  test::start_mpi();
  Eigen::MatrixXd a = definite(4);
  a.row(3) = a.row(2);
  a.col(3) = a.col(2);
  a(3, 3) = a(2, 2) - 1;  // indefinite
  EXPECT_THROW(DirectSolver(lower_entries(a), 4), SolverError);
  EXPECT_THROW((void)condense(a, 4), SolverError);
  Eigen::MatrixXd spring(2, 2);  // not held
  spring << 1, -1, -1, 1;
  EXPECT_THROW(DirectSolver(lower_entries(spring), 2), SolverError);
}

}  // namespace
}  // namespace strainwave::fem
