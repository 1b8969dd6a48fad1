// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <vector>

namespace strainwave::fem {

/// The part of a symmetric positive definite matrix on one rank: entries of one triangle in any
/// order.  Entries given more than once, also by different ranks, are summed.
struct SymmetricEntries {
  std::vector<int> row;     ///< rows, counted from 1
  std::vector<int> column;  ///< columns, counted from 1
  std::vector<double> value;

  void reserve(std::size_t size);
  void add(int i, int j, double v) {
    row.push_back(i);
    column.push_back(j);
    value.push_back(v);
  }
};

/// A Cholesky factorisation by MUMPS.  Every rank must construct it with its own entries and call
/// `solve` with the same right-hand sides.
class DirectSolver {
 public:
  /// @param unknowns  number of rows; may be 0
  /// @param workspace_percent  initial workspace above the estimate of the analysis; if it does not
  ///                           suffice, the factorisation is repeated with more; if left out, MUMPS
  ///                           decides
  /// @throws SolverError  if the matrix is singular
  /// @throws MemoryError  if the memory does not suffice
  /// @throws Error        if MUMPS reports any other fault
  DirectSolver(SymmetricEntries entries, int unknowns,
               std::optional<int> workspace_percent = std::nullopt);
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Solutions for consecutive right-hand sides, the same on every rank.
  [[nodiscard]] std::vector<double> solve(std::vector<double> rhs, int count = 1);

  [[nodiscard]] double megabytes() const;   ///< memory of the factorisation, over all ranks [MB]
  [[nodiscard]] double operations() const;  ///< floating-point operations of the elimination
  /// repetitions of the factorisation because of insufficient workspace
  [[nodiscard]] int repeats() const;

 private:
  struct Mumps;
  std::unique_ptr<Mumps> mumps_;
};

/// Throws the exception for a fault code of MUMPS, INFOG(1) and INFOG(2); returns without a fault.
void check_mumps(int code, int detail);

/// Sets up OpenBLAS if the system uses it; must be called before the first use of BLAS.
///
/// OpenBLAS gets one thread unless OMP_NUM_THREADS or OPENBLAS_NUM_THREADS is set, because more
/// threads only wait for each other in matrices as small as ours.  It also gets kernels for this
/// processor if it does not know the processor: 0.3.21 of Debian 12 falls back to kernels of a
/// Pentium 4 ("Prescott"), at a fifth of the speed, on processors newer than itself.
/// OPENBLAS_CORETYPE overrides this choice.
void prepare_blas();

// Dense matrices use BLAS and LAPACK, which unlike our own code are compiled for the processor.

/// Lower triangle of A A^T.
[[nodiscard]] Eigen::MatrixXd lower_square(const Eigen::MatrixXd& a);

/// The matrix of a cell after elimination of its inner unknowns, which occur in no other cell.
struct CondensedMatrix {
  Eigen::MatrixXd factor;    ///< L of the block of the inner unknowns
  Eigen::MatrixXd coupling;  ///< L^-1 K_io
  Eigen::MatrixXd outer;     ///< K_oo - K_oi K_ii^-1 K_io, lower triangle
};

/// @param stiffness  lower triangle, with the inner unknowns first
/// @param inner      number of inner unknowns; may be 0
/// @throws SolverError  if their block is not positive definite
[[nodiscard]] CondensedMatrix condense(const Eigen::MatrixXd& stiffness, Eigen::Index inner);

}  // namespace strainwave::fem
