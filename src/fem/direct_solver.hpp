// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <vector>

namespace strainwave::fem {

/// What one rank has of a symmetric positive definite matrix: entries of one triangle in any
/// order; an entry that is given more than once, by whichever rank, counts as the sum.
struct SymmetricEntries {
  std::vector<int> row;     ///< from 1
  std::vector<int> column;  ///< from 1
  std::vector<double> value;

  void reserve(std::size_t size);
  void add(int i, int j, double v) {
    row.push_back(i);
    column.push_back(j);
    value.push_back(v);
  }
};

/// A Cholesky factorisation by MUMPS.  Every rank makes it, with its own entries, and calls
/// `solve` with the same right-hand sides.
class DirectSolver {
 public:
  /// @param unknowns  number of rows; may be 0
  /// @param workspace_percent  above the estimate of the analysis, to begin with: where it is too
  ///                  little the factorisation is repeated with more; MUMPS's own if left out
  /// @throws SolverError  a matrix that is singular
  /// @throws MemoryError  too little memory
  /// @throws Error        any other fault of MUMPS
  DirectSolver(SymmetricEntries entries, int unknowns,
               std::optional<int> workspace_percent = std::nullopt);
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Solutions for right-hand sides that stand one after the other; the same on every rank.
  [[nodiscard]] std::vector<double> solve(std::vector<double> rhs, int count = 1);

  [[nodiscard]] double megabytes() const;   ///< memory of the factorisation, over all ranks [MB]
  [[nodiscard]] double operations() const;  ///< floating-point operations of the elimination
  [[nodiscard]] int repeats() const;        ///< of the factorisation, for want of workspace

 private:
  struct Mumps;
  std::unique_ptr<Mumps> mumps_;
};

/// Throws what a code of MUMPS, INFOG(1) and INFOG(2), stands for; nothing if there is no fault.
void check_mumps(int code, int detail);

/// Sets up OpenBLAS, if it is that: before the first use of BLAS.
///
/// One thread, unless OMP_NUM_THREADS or OPENBLAS_NUM_THREADS say otherwise: more only wait for
/// each other in matrices as small as ours.  And the kernels of this processor where OpenBLAS does
/// not know it: 0.3.21 of Debian 12 falls back to those of a Pentium 4 ("Prescott"), a fifth of the
/// speed, on processors newer than itself; unless OPENBLAS_CORETYPE says which.
void prepare_blas();

// Dense matrices by BLAS and LAPACK, which unlike our own code are compiled for the processor.

/// Lower triangle of A A^T.
[[nodiscard]] Eigen::MatrixXd lower_square(const Eigen::MatrixXd& a);

/// A cell whose first unknowns occur nowhere else, after these were eliminated.
struct CondensedMatrix {
  Eigen::MatrixXd factor;    ///< L of the block of the inner unknowns
  Eigen::MatrixXd coupling;  ///< L^-1 K_io
  Eigen::MatrixXd outer;     ///< K_oo - K_oi K_ii^-1 K_io, lower triangle
};

/// @param stiffness  lower triangle, the inner unknowns first
/// @param inner      how many of them, may be 0
/// @throws SolverError  if their block is not positive definite
[[nodiscard]] CondensedMatrix condense(const Eigen::MatrixXd& stiffness, Eigen::Index inner);

}  // namespace strainwave::fem
