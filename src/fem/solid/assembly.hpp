// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "direct_solver.hpp"
#include "space.hpp"

namespace strainwave::fem::solid {

/// Nodal forces of the problem's tractions [N].
[[nodiscard]] Vector nodal_loads(const Space& space);

/// What the problem's supports hold.
[[nodiscard]] Constraints support_constraints(const Space& space);

/// Nodal forces of the stresses, without any constraint [N], and their energy [J].
struct InternalForces {
  Vector forces;
  double energy = 0;
};
[[nodiscard]] InternalForces internal_forces(const Space& space, const Vector& u);

/// Which unknowns the solver gets: neither constrained ones, nor those of one cell alone.
struct Numbering {
  static constexpr int kConstrained = -1;
  static constexpr int kInner = -2;

  std::vector<int> number;  ///< of each dof in the linear equations, or why it has none
  int unknowns = 0;         ///< of the linear equations

  Numbering(const Space& space, const Constraints& constraints);
};

/// The stiffness of the body, factorised; every rank makes it and calls it with the same arguments.
class Equations {
 public:
  /// @throws SolverError, MemoryError, OtherRankError  on every rank
  Equations(const Space& space, const Constraints& constraints);

  /// The displacements under nodal forces [m].
  [[nodiscard]] Vector displacements(Vector forces);

  [[nodiscard]] const Numbering& numbering() const { return numbering_; }
  [[nodiscard]] DirectSolver& solver() { return *solver_; }
  /// When the matrix was complete and its factorisation began.
  [[nodiscard]] std::chrono::steady_clock::time_point assembled() const { return assembled_; }

 private:
  /// A cell after the elimination of the dofs that no other cell has.
  struct CondensedCell {
    std::vector<Index> inner;  ///< dofs that were eliminated
    std::vector<int> outer;    ///< numbers of the unknowns that were not
    CondensedMatrix matrix;    ///< its `outer` is given away
  };
  /// Rows of a cell's stiffness by their kind.
  struct CellRows;

  [[nodiscard]] SymmetricEntries assemble();
  [[nodiscard]] SymmetricEntries assemble_together();
  [[nodiscard]] CellRows rows_of(const Cell& cell) const;
  [[nodiscard]] Eigen::MatrixXd turned(const Eigen::MatrixXd& matrix, const CellRows& rows) const;

  const Space& space_;
  const Constraints& constraints_;
  Numbering numbering_;
  std::vector<CondensedCell> cells_;  ///< of this rank
  std::unique_ptr<DirectSolver> solver_;
  std::chrono::steady_clock::time_point assembled_;
};

}  // namespace strainwave::fem::solid
