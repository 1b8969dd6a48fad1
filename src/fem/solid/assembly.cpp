// SPDX-License-Identifier: Apache-2.0
#include "assembly.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <new>
#include <span>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/fem/memory_error.hpp"
#include "strainwave/fem/mpi_session.hpp"

namespace strainwave::fem::solid {
namespace {

/// Expresses u_k of the node by its other components such that the displacement along n vanishes.
void hold(Constraints& constraints, const Node& node, const Tensor<1, 3>& n) {
  unsigned k = 0;
  for (unsigned i = 1; i < 3; ++i)
    if (std::abs(n[i]) > std::abs(n[k])) k = i;
  if (constraints.is_constrained(node[k])) return;
  constraints.add_line(node[k]);
  for (unsigned i = 0; i < 3; ++i) {
    const double factor = n[i] / n[k];
    if (i != k && std::abs(factor) > 1e-14) constraints.add_entry(node[k], node[i], -factor);
  }
}

/// Lower triangle of the stiffness of one cell; component i of node a is row i * nodes + a.
Eigen::MatrixXd stiffness(const dealii::FEValues<3>& values, const Lame& lame) {
  const auto n = static_cast<Eigen::Index>(values.dofs_per_cell);
  const auto points = static_cast<Eigen::Index>(values.n_quadrature_points);
  Eigen::MatrixXd gradient(3 * n, points);  // gradients scaled by the root of the weight
  for (Eigen::Index q = 0; q < points; ++q) {
    const double root = std::sqrt(values.JxW(static_cast<unsigned>(q)));
    for (Eigen::Index a = 0; a < n; ++a) {
      const Tensor<1, 3>& g = values.shape_grad(static_cast<unsigned>(a), static_cast<unsigned>(q));
      for (unsigned i = 0; i < 3; ++i) gradient(i * n + a, q) = root * g[i];
    }
  }
  const Eigen::MatrixXd product = lower_square(gradient);
  Eigen::MatrixXd matrix(3 * n, 3 * n);
  for (Eigen::Index j = 0; j < 3; ++j) {
    for (Eigen::Index b = 0; b < n; ++b)
      for (Eigen::Index a = b; a < n; ++a) {
        const double laplace =
            product(a, b) + product(n + a, n + b) + product(2 * n + a, 2 * n + b);
        matrix(j * n + a, j * n + b) =
            (lame.lambda + lame.mu) * product(j * n + a, j * n + b) + lame.mu * laplace;
      }
    for (Eigen::Index i = j + 1; i < 3; ++i) {
      const auto block = product.block(i * n, j * n, n, n);
      matrix.block(i * n, j * n, n, n) =
          lame.lambda * block + lame.mu * block.transpose();  // (FE-20)
    }
  }
  return matrix;
}

}  // namespace

Tensor<1, 3> released_traction(const SolidLoad& of, const dealii::FEFaceValues<3>& values,
                               unsigned q) {
  const auto s = of.stress_without_crack(to_array(values.quadrature_point(q)));
  const Tensor<1, 3>& n = values.normal_vector(q);
  Tensor<1, 3> t;
  for (unsigned i = 0; i < 3; ++i) t[i] = -(s[i][0] * n[0] + s[i][1] * n[1] + s[i][2] * n[2]);
  return t;
}

Vector nodal_loads(const Space& space, const SolidLoad& of) {
  Vector load(space.dofs.n_dofs());
  const dealii::QGauss<2> rule(static_cast<unsigned>(space.problem.order) + 3);
  dealii::FEFaceValues<3> values(space.body.mapping, space.scalar, rule,
                                 dealii::update_values | dealii::update_quadrature_points |
                                     dealii::update_JxW_values | dealii::update_normal_vectors);
  for (const Cell& cell : space.dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const std::vector<Index> indices = space.indices(cell);
    const auto add = [&](const auto& traction) {
      for (const unsigned q : values.quadrature_point_indices()) {
        const Tensor<1, 3> t = traction(q);
        for (unsigned a = 0; a < space.scalar.n_dofs_per_cell(); ++a)
          for (unsigned i = 0; i < 3; ++i)
            load[indices[space.node_of[i][a]]] += t[i] * values.shape_value(a, q) * values.JxW(q);
      }
    };
    for (const unsigned f : cell->face_indices()) {
      for (const Traction& traction : of.tractions) {
        if (!space.has_tag(cell, f, traction.tag)) continue;
        Space::reinit(values, cell, f);
        add([&](unsigned q) {
          return to_tensor(traction.value(to_array(values.quadrature_point(q))));
        });
      }
      if (!of.released || !space.is_crack_face(cell, f)) continue;
      Space::reinit(values, cell, f);
      add([&](unsigned q) { return released_traction(of, values, q); });  // (FE-54)
    }
  }
  sum_over_ranks(load);
  return load;
}

Constraints support_constraints(const Space& space) {
  Constraints constraints;
  for (const Cell& cell : space.dofs.active_cell_iterators())
    for (const unsigned f : cell->face_indices())
      for (const Support& support : space.problem.supports) {
        if (!space.has_tag(cell, f, support.tag)) continue;
        space.visit_face_nodes(cell, f, [&](unsigned a, const Node& node) {
          const Point<3> unit = space.scalar.unit_support_point(a);
          const std::vector<Point3> directions =
              support.directions(space.source(cell).map(to_array(unit)));
          if (directions.size() == 3) {
            for (const Index i : node)
              if (!constraints.is_constrained(i)) constraints.add_line(i);
          } else {
            for (const Point3& d : directions) hold(constraints, node, to_tensor(d));
          }
        });
      }
  constraints.close();
  return constraints;
}

InternalForces internal_forces(const Space& space, const Vector& u) {
  InternalForces result{.forces = Vector(space.dofs.n_dofs())};
  const dealii::QGauss<3> rule(static_cast<unsigned>(space.problem.order) + 1);
  dealii::FEValues<3> values(space.body.mapping, space.scalar, rule,
                             dealii::update_gradients | dealii::update_JxW_values);
  for (const Cell& cell : space.dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    Space::reinit(values, cell);
    const std::vector<Tensor2> gradient = CellDisplacement(space, cell, u).gradients(values);
    const std::vector<Index> indices = space.indices(cell);
    for (unsigned q = 0; q < rule.size(); ++q) {
      const Tensor2 stress = values.JxW(q) * space.lame.stress(gradient[q]);
      result.energy += 0.5 * scalar_product(stress, gradient[q]);
      for (unsigned a = 0; a < space.scalar.n_dofs_per_cell(); ++a) {
        const Tensor<1, 3> force = stress * values.shape_grad(a, q);
        for (unsigned i = 0; i < 3; ++i) result.forces[indices[space.node_of[i][a]]] += force[i];
      }
    }
  }
  sum_over_ranks(result.forces);
  result.energy = dealii::Utilities::MPI::sum(result.energy, MPI_COMM_WORLD);
  return result;
}

Numbering::Numbering(const Space& space, const Constraints& constraints)
    : number(space.dofs.n_dofs(), kInner) {
  std::vector<char> seen(space.dofs.n_dofs(), 0);
  for (const Cell& cell : space.dofs.active_cell_iterators())
    for (const Index i : space.indices(cell)) {
      if (seen[i]) number[i] = 0;
      seen[i] = 1;
    }
  if (space.problem.crack_faces == CrackFaces::contact)  // contact will push these faces apart
    space.visit_crack_faces([&](const Cell& cell, unsigned f) {
      space.visit_face_nodes(cell, f, [&](unsigned, const Node& node) {
        for (const Index i : node) number[i] = 0;
      });
    });
  for (const auto& line : constraints.get_lines())
    for (const auto& entry : line.entries) number[entry.first] = 0;
  for (const auto& line : constraints.get_lines()) number[line.index] = kConstrained;
  for (int& n : number)
    if (n >= 0) n = unknowns++;
}

struct Equations::CellRows {
  std::vector<Index> dof;              ///< dof of each row
  std::vector<Eigen::Index> order;     ///< rows that are not held, inner rows first
  Eigen::Index n_inner = 0;            ///< number of inner rows
  std::vector<Index> inner;            ///< dofs of the inner rows
  std::vector<int> outer;              ///< unknowns that replace the other rows
  std::map<int, Eigen::Index> column;  ///< index of an unknown in `outer`
  bool plain = true;                   ///< whether each other row is itself an unknown
};

Equations::Equations(const Space& space, const Constraints& constraints)
    : space_(space), constraints_(constraints), numbering_(space, constraints) {
  SymmetricEntries entries = assemble_together();
  assembled_ = std::chrono::steady_clock::now();
  solver_ = std::make_unique<DirectSolver>(std::move(entries), numbering_.unknowns);
}

Equations::CellRows Equations::rows_of(const Cell& cell) const {
  const std::vector<int>& number = numbering_.number;
  const std::vector<Index> indices = space_.indices(cell);
  CellRows rows;
  for (const std::vector<unsigned>& component : space_.node_of)
    for (const unsigned i : component) rows.dof.push_back(indices[i]);
  std::vector<Eigen::Index> rest;
  const auto include = [&](int unknown) {
    if (rows.column.emplace(unknown, static_cast<Eigen::Index>(rows.outer.size())).second)
      rows.outer.push_back(unknown);
  };
  for (std::size_t row = 0; row < rows.dof.size(); ++row) {
    const Index i = rows.dof[row];
    if (number[i] == Numbering::kInner) {
      rows.order.push_back(static_cast<Eigen::Index>(row));
      rows.inner.push_back(i);
    } else if (number[i] >= 0) {
      rest.push_back(static_cast<Eigen::Index>(row));
      include(number[i]);
    } else if (!constraints_.get_constraint_entries(i)->empty()) {
      rows.plain = false;
      rest.push_back(static_cast<Eigen::Index>(row));
      for (const auto& entry : *constraints_.get_constraint_entries(i))
        include(number[entry.first]);
    }
  }
  rows.n_inner = static_cast<Eigen::Index>(rows.inner.size());
  rows.order.insert(rows.order.end(), rest.begin(), rest.end());
  return rows;
}

/// The matrix of a cell, whose rows are in the order of `rows`, expressed by its unknowns.
Eigen::MatrixXd Equations::turned(const Eigen::MatrixXd& matrix, const CellRows& rows) const {
  const std::vector<int>& number = numbering_.number;
  const Eigen::Index n = matrix.rows();
  const auto kept = static_cast<Eigen::Index>(rows.outer.size());
  Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(n, rows.n_inner + kept);
  turn.topLeftCorner(rows.n_inner, rows.n_inner).setIdentity();
  for (Eigen::Index row = rows.n_inner; row < n; ++row) {
    const Index i = rows.dof[static_cast<std::size_t>(rows.order[row])];
    if (number[i] >= 0)
      turn(row, rows.n_inner + rows.column.at(number[i])) = 1;
    else
      for (const auto& entry : *constraints_.get_constraint_entries(i))
        turn(row, rows.n_inner + rows.column.at(number[entry.first])) += entry.second;
  }
  return turn.transpose() * (matrix.selfadjointView<Eigen::Lower>() * turn);
}

/// Stiffness of this rank's cells; keeps the data for the inner unknowns in `cells_`.
SymmetricEntries Equations::assemble() {
  const dealii::QGauss<3> rule(static_cast<unsigned>(space_.problem.order) + 1);
  dealii::FEValues<3> values(space_.body.mapping, space_.scalar, rule,
                             dealii::update_gradients | dealii::update_JxW_values);
  SymmetricEntries entries;
  for (const Cell& cell : space_.dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const CellRows rows = rows_of(cell);
    const Eigen::MatrixXd all = stiffness(Space::reinit(values, cell), space_.lame);
    const std::vector<Eigen::Index>& order = rows.order;
    const auto n = static_cast<Eigen::Index>(order.size());
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = j; i < n; ++i)
        matrix(i, j) = all(std::max(order[i], order[j]), std::min(order[i], order[j]));
    if (!rows.plain) matrix = turned(matrix, rows);
    CondensedMatrix condensed = condense(matrix, rows.n_inner);
    const auto n_outer = static_cast<Eigen::Index>(rows.outer.size());
    if (entries.value.empty())
      entries.reserve(space_.body.triangulation.n_locally_owned_active_cells() *
                      static_cast<std::size_t>(n_outer * (n_outer + 1) / 2));
    for (Eigen::Index j = 0; j < n_outer; ++j)
      for (Eigen::Index i = j; i < n_outer; ++i)
        entries.add(rows.outer[i] + 1, rows.outer[j] + 1, condensed.outer(i, j));
    condensed.outer.resize(0, 0);
    cells_.push_back({rows.inner, rows.outer, std::move(condensed)});
  }
  return entries;
}

/// Calls `assemble` on all ranks.  A fault on one rank ends all, because MUMPS would wait for this
/// rank.
SymmetricEntries Equations::assemble_together() {
  SymmetricEntries entries;
  std::exception_ptr fault;
  try {
    entries = assemble();
  } catch (const std::bad_alloc&) {
    fault = std::make_exception_ptr(MemoryError(
        "the memory does not suffice for the matrix; use a coarser mesh or more ranks"));
  } catch (...) {
    fault = std::current_exception();
  }
  const bool all_well = dealii::Utilities::MPI::min(fault ? 0 : 1, MPI_COMM_WORLD) == 1;
  if (fault) std::rethrow_exception(fault);
  if (!all_well) throw OtherRankError("another rank could not assemble its cells");
  return entries;
}

Vector Equations::displacements(Vector forces) {
  std::vector<Vector> one;
  one.push_back(std::move(forces));
  return std::move(displacements(std::move(one)).front());
}

std::vector<Vector> Equations::displacements(std::vector<Vector> forces) {
  constexpr std::size_t kBlock = 64;
  std::vector<Vector> found;
  for (std::size_t first = 0; first < forces.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, forces.size() - first);
    for (Vector& u : block_displacements(std::span(forces).subspan(first, count)))
      found.push_back(std::move(u));
  }
  return found;
}

/// The displacements under nodal forces, which it changes.
std::vector<Vector> Equations::block_displacements(std::span<Vector> forces) {
  const std::vector<int>& number = numbering_.number;
  const auto unknowns = static_cast<std::size_t>(numbering_.unknowns);
  const auto count = static_cast<Eigen::Index>(forces.size());
  for (Vector& f : forces) constraints_.condense(f);
  std::vector<double> rhs(unknowns * forces.size(), 0.0);
  std::vector<Eigen::MatrixXd> inner_forces;  // L^-1 f_i, cell by cell
  for (const CondensedCell& cell : cells_) {
    Eigen::MatrixXd& f =
        inner_forces.emplace_back(static_cast<Eigen::Index>(cell.inner.size()), count);
    for (Eigen::Index n = 0; n < count; ++n)
      for (Eigen::Index i = 0; i < f.rows(); ++i)
        f(i, n) = forces[static_cast<std::size_t>(n)][cell.inner[i]];
    if (!f.any()) continue;
    cell.matrix.factor.triangularView<Eigen::Lower>().solveInPlace(f);
    const Eigen::MatrixXd left = cell.matrix.coupling.transpose() * f;
    for (Eigen::Index n = 0; n < count; ++n)
      for (Eigen::Index i = 0; i < left.rows(); ++i)
        rhs[static_cast<std::size_t>(n) * unknowns + static_cast<std::size_t>(cell.outer[i])] -=
            left(i, n);
  }
  sum_over_ranks(rhs);
  for (std::size_t n = 0; n < forces.size(); ++n)
    for (Index i = 0; i < number.size(); ++i)
      if (number[i] >= 0) rhs[n * unknowns + static_cast<std::size_t>(number[i])] += forces[n][i];
  const std::vector<double> x = solver_->solve(std::move(rhs), static_cast<int>(count));
  std::vector<Vector> found(forces.size(), Vector(space_.dofs.n_dofs()));
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const CondensedCell& cell = cells_[c];
    Eigen::MatrixXd outer(static_cast<Eigen::Index>(cell.outer.size()), count);
    for (Eigen::Index n = 0; n < count; ++n)
      for (Eigen::Index i = 0; i < outer.rows(); ++i)
        outer(i, n) =
            x[static_cast<std::size_t>(n) * unknowns + static_cast<std::size_t>(cell.outer[i])];
    Eigen::MatrixXd inner = inner_forces[c] - cell.matrix.coupling * outer;
    cell.matrix.factor.triangularView<Eigen::Lower>().transpose().solveInPlace(inner);
    for (Eigen::Index n = 0; n < count; ++n)
      for (Eigen::Index i = 0; i < inner.rows(); ++i)
        found[static_cast<std::size_t>(n)][cell.inner[i]] = inner(i, n);
  }
  for (std::size_t n = 0; n < found.size(); ++n) {
    sum_over_ranks(found[n]);
    for (Index i = 0; i < number.size(); ++i)
      if (number[i] >= 0) found[n][i] = x[n * unknowns + static_cast<std::size_t>(number[i])];
    constraints_.distribute(found[n]);
  }
  return found;
}

}  // namespace strainwave::fem::solid
