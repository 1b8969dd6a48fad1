// SPDX-License-Identifier: Apache-2.0
#pragma once

// The headers of deal.II cause warnings that this project treats as errors.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Dense>
#pragma GCC diagnostic pop

#include <array>
#include <vector>

#include "strainwave/fem/solid.hpp"

/// @file
/// The body as used by the parts of the solver: geometry, displacements, material.  Every rank
/// holds the whole body and works on the cells that it owns.

namespace strainwave::fem::solid {

using dealii::Point;
using dealii::Tensor;
using Tensor2 = Tensor<2, 3>;
using Vector = dealii::Vector<double>;
using Index = dealii::types::global_dof_index;
using Cell = dealii::DoFHandler<3>::active_cell_iterator;
using Constraints = dealii::AffineConstraints<double>;
using Node = std::array<Index, 3>;  ///< the dofs of one node

inline Point<3> to_point(const Point3& p) { return {p[0], p[1], p[2]}; }
inline Point3 to_array(const Point<3>& p) { return {p[0], p[1], p[2]}; }
inline Tensor<1, 3> to_tensor(const Point3& p) { return Tensor<1, 3>({p[0], p[1], p[2]}); }

/// Replaces the values of each rank by their sum over the ranks.
template <class Values>
void sum_over_ranks(Values& values) {
  const auto size = static_cast<std::size_t>(values.end() - values.begin());
  dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(&*values.begin(), size),
                              MPI_COMM_WORLD, dealii::ArrayView<double>(&*values.begin(), size));
}

/// The mesh in deal.II with the analytic geometry, complete on every rank.
struct Body {
  dealii::parallel::shared::Triangulation<3> triangulation;
  dealii::MappingQCache<3> mapping;

  Body(const HexMesh& mesh, int order);
};

/// Whether the map of the cell is singular on its edge u = v = 0 by design (FE-46).
[[nodiscard]] bool is_singular(const HexCell& cell);

/// The smallest scaled determinant of the Jacobian matrix [-], (FE-22).
/// @throws InputError  if a determinant is <= 0; the message names the first such cell
[[nodiscard]] double worst_jacobian(const HexMesh& mesh, const Body& body);

/// Lame's constants [Pa].
struct Lame {
  double lambda;
  double mu;

  explicit Lame(const Elasticity& m);

  /// Stress from a displacement gradient [i][j] = du_i/dx_j.
  [[nodiscard]] Tensor2 stress(const Tensor2& gradient) const;
};

/// The space of displacements on a body.
struct Space {
  Space(const HexMesh& mesh, const SolidProblem& problem);

  const HexMesh& mesh;
  const SolidProblem& problem;
  Lame lame;
  Body body;
  double jacobian;  ///< worst scaled Jacobian determinant [-]
  dealii::FE_Q<3> scalar;
  dealii::FESystem<3> element;
  dealii::DoFHandler<3> dofs;
  std::vector<std::vector<unsigned>> node_of;  ///< [component][node of the scalar element]

  [[nodiscard]] const HexCell& source(const Cell& cell) const {
    return mesh.cells[static_cast<std::size_t>(cell->index())];
  }
  [[nodiscard]] std::vector<Index> indices(const Cell& cell) const;

  [[nodiscard]] bool has_tag(const Cell& cell, unsigned f, int tag) const {
    return cell->face(f)->at_boundary() &&
           cell->face(f)->boundary_id() == static_cast<unsigned>(tag);
  }
  [[nodiscard]] bool is_crack_face(const Cell& cell, unsigned f) const {
    return problem.crack_tag != 0 && has_tag(cell, f, problem.crack_tag);
  }

  /// Calls visit(cell, f) for every face of a crack.
  template <class Visit>
  void visit_crack_faces(const Visit& visit) const {
    for (const Cell& cell : dofs.active_cell_iterators())
      for (const unsigned f : cell->face_indices())
        if (is_crack_face(cell, f)) visit(cell, f);
  }

  /// Calls visit(a, dofs) for every node of a cell's face; a is its number in the scalar element.
  template <class Visit>
  void visit_face_nodes(const Cell& cell, unsigned f, const Visit& visit) const {
    const std::vector<Index> of_cell = indices(cell);
    for (unsigned a = 0; a < scalar.n_dofs_per_cell(); ++a)
      if (scalar.has_support_on_face(a, f))
        visit(a, Node{of_cell[node_of[0][a]], of_cell[node_of[1][a]], of_cell[node_of[2][a]]});
  }

  /// Evaluates `values` of the scalar element at a cell, or at one of its faces.
  static dealii::FEValues<3>& reinit(dealii::FEValues<3>& values, const Cell& cell);
  static dealii::FEFaceValues<3>& reinit(dealii::FEFaceValues<3>& values, const Cell& cell,
                                         unsigned f);
};

/// Displacements of one cell.
class CellDisplacement {
 public:
  CellDisplacement(const Space& space, const Cell& cell, const Vector& u);

  /// Displacement at point q of `values`, which belong to the scalar element.
  [[nodiscard]] Tensor<1, 3> at(const dealii::FEValuesBase<3>& values, unsigned q) const;

  /// Displacement gradients at all points of `values`.
  [[nodiscard]] std::vector<Tensor2> gradients(const dealii::FEValuesBase<3>& values) const;

 private:
  const Space& space_;
  std::vector<double> local_;  ///< values by number of the dof in the cell
};

}  // namespace strainwave::fem::solid
