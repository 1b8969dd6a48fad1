// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <vector>

#include "direct_solver.hpp"
#include "space.hpp"

namespace strainwave::fem::solid {

/// Traction on a face of the crack that takes away the stress without the crack [Pa].
[[nodiscard]] Tensor<1, 3> released_traction(const SolidLoad& of,
                                             const dealii::FEFaceValues<3>& values, unsigned q);

/// Nodal forces of the tractions of a load [N].
[[nodiscard]] Vector nodal_loads(const Space& space, const SolidLoad& of);

/// Constraints from the supports of the problem.
[[nodiscard]] Constraints support_constraints(const Space& space);

/// Nodal forces of the stresses, without any constraint [N], and their energy [J].
struct InternalForces {
  Vector forces;
  double energy = 0;
};
[[nodiscard]] InternalForces internal_forces(const Space& space, const Vector& u);

/// Numbering of the solver's unknowns, without constrained dofs and dofs of one cell alone.
struct Numbering {
  static constexpr int kConstrained = -1;
  static constexpr int kInner = -2;

  /// number of each dof in the linear equations, or a code of the reason why it has none
  std::vector<int> number;
  int unknowns = 0;  ///< number of unknowns of the linear equations

  Numbering(const Space& space, const Constraints& constraints);
};

/// The stiffness of the body, factorised; every rank must construct it and call it with the same
/// arguments.
class Equations {
 public:
  /// @throws SolverError, MemoryError, OtherRankError  on every rank
  Equations(const Space& space, const Constraints& constraints);

  /// The displacements under nodal forces [m].
  [[nodiscard]] Vector displacements(Vector forces);
  /// The same under several nodal forces.
  [[nodiscard]] std::vector<Vector> displacements(std::vector<Vector> forces);

  [[nodiscard]] const Numbering& numbering() const { return numbering_; }
  [[nodiscard]] DirectSolver& solver() { return *solver_; }
  /// Time at which the matrix was complete and its factorisation began.
  [[nodiscard]] std::chrono::steady_clock::time_point assembled() const { return assembled_; }

 private:
  /// A cell after the elimination of the dofs that belong to it alone.
  struct CondensedCell {
    std::vector<Index> inner;  ///< eliminated dofs
    std::vector<int> outer;    ///< numbers of the remaining unknowns
    CondensedMatrix matrix;    ///< without its `outer`, which was moved out
  };
  /// Rows of a cell's stiffness, grouped by kind.
  struct CellRows;

  [[nodiscard]] std::vector<Vector> block_displacements(std::span<Vector> forces);
  [[nodiscard]] SymmetricEntries assemble();
  [[nodiscard]] SymmetricEntries assemble_together();
  [[nodiscard]] CellRows rows_of(const Cell& cell) const;
  [[nodiscard]] Eigen::MatrixXd turned(const Eigen::MatrixXd& matrix, const CellRows& rows) const;

  const Space& space_;
  const Constraints& constraints_;
  Numbering numbering_;
  std::vector<CondensedCell> cells_;  ///< cells of this rank
  std::unique_ptr<DirectSolver> solver_;
  std::chrono::steady_clock::time_point assembled_;
};

}  // namespace strainwave::fem::solid
