// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/solid.hpp"

// deal.II's own headers do not pass this project's warnings.
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

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "direct_solver.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fem/memory_error.hpp"
#include "strainwave/fem/mpi_session.hpp"

namespace strainwave::fem {

namespace {

using dealii::Point;
using dealii::Tensor;
using Tensor2 = Tensor<2, 3>;
using Vector = dealii::Vector<double>;
using Index = dealii::types::global_dof_index;
using Cell = dealii::DoFHandler<3>::active_cell_iterator;

constexpr int kGeometryOrder = 4;  // at least; 45 degrees of a circle to 1e-6

Point<3> to_point(const Point3& p) { return {p[0], p[1], p[2]}; }
Point3 to_array(const Point<3>& p) { return {p[0], p[1], p[2]}; }
Tensor<1, 3> to_tensor(const Point3& p) { return Tensor<1, 3>({p[0], p[1], p[2]}); }

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The mesh as deal.II has it, whole on every rank, with the analytic geometry.
struct Body {
  dealii::parallel::shared::Triangulation<3> triangulation;
  dealii::MappingQCache<3> mapping;

  Body(const HexMesh& mesh, int order)
      : triangulation(MPI_COMM_WORLD, dealii::Triangulation<3>::none, false,
                      dealii::parallel::shared::Triangulation<3>::partition_zorder),
        mapping(static_cast<unsigned>(std::max(order, kGeometryOrder))) {
    std::vector<Point<3>> vertices(mesh.vertices.size());
    std::transform(mesh.vertices.begin(), mesh.vertices.end(), vertices.begin(), to_point);
    std::vector<dealii::CellData<3>> cells(mesh.cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (std::size_t i = 0; i < 8; ++i)
        cells[c].vertices[i] = static_cast<unsigned>(mesh.cells[c].vertices[i]);
    triangulation.create_triangulation(vertices, cells, {});
    for (const auto& cell : triangulation.active_cell_iterators())
      for (const unsigned f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(static_cast<unsigned>(
              mesh.cells[static_cast<std::size_t>(cell->index())].face_tag[f]));
    const std::vector<Point<3>> unit =
        dealii::FE_Q<3>(mapping.get_degree()).get_unit_support_points();
    mapping.initialize(triangulation, [&](const auto& cell) {
      std::vector<Point<3>> points(unit.size());
      const PointMap& map = mesh.cells[static_cast<std::size_t>(cell->index())].map;
      std::transform(unit.begin(), unit.end(), points.begin(),
                     [&](const Point<3>& p) { return to_point(map(to_array(p))); });
      return points;
    });
  }
};

double scaled_determinant(const Tensor2& J) {
  double lengths = 1;
  for (unsigned k = 0; k < 3; ++k)
    lengths *= std::sqrt(J[0][k] * J[0][k] + J[1][k] * J[1][k] + J[2][k] * J[2][k]);
  return lengths > 0 ? dealii::determinant(J) / lengths : 0;
}

/// Whether the map of the cell has no inverse on its edge u = v = 0, by design (FE-46).
bool is_singular(const HexCell& cell) {
  return cell.front && cell.front->square_root && cell.front->ring < 0;
}

double worst_jacobian(const HexMesh& mesh, const Body& body) {
  const dealii::FE_Q<3> element(1);
  const dealii::QGauss<3> gauss(5);
  const dealii::QTrapezoid<3> corners;
  std::vector<Point<3>> points = gauss.get_points();
  points.insert(points.end(), corners.get_points().begin(), corners.get_points().end());
  dealii::FEValues<3> values(body.mapping, element, dealii::Quadrature<3>(points),
                             dealii::update_jacobians);
  double worst = 1;
  for (const auto& cell : body.triangulation.active_cell_iterators()) {
    values.reinit(cell);
    const HexCell& source = mesh.cells[static_cast<std::size_t>(cell->index())];
    for (const unsigned q : values.quadrature_point_indices()) {
      if (is_singular(source) && points[q][0] == 0 && points[q][1] == 0) continue;
      const double scaled = scaled_determinant(Tensor2(values.jacobian(q)));  // (FE-22)
      if (!(scaled > 0))
        throw InputError("mesh", fmt::format("cell {} is tangled or left-handed: scaled Jacobian "
                                             "determinant {:.3g} where it must be positive",
                                             cell->index(), scaled));
      worst = std::min(worst, scaled);
    }
  }
  return worst;
}

struct Lame {
  double lambda;
  double mu;

  explicit Lame(const Elasticity& m)
      : lambda(m.youngs_modulus * m.poissons_ratio /
               ((1 + m.poissons_ratio) * (1 - 2 * m.poissons_ratio))),
        mu(m.youngs_modulus / (2 * (1 + m.poissons_ratio))) {}

  /// Stress of a displacement gradient [i][j] = du_i/dx_j.
  [[nodiscard]] Tensor2 stress(const Tensor2& gradient) const {
    Tensor2 s = mu * (gradient + transpose(gradient));
    const double volume = lambda * trace(gradient);
    for (unsigned i = 0; i < 3; ++i) s[i][i] += volume;
    return s;
  }
};

/// Displacement gradient of one mode with K = 1 at a crack tip, in plane strain; (FE-24).
/// @param mode  0, 1, 2 for I, II, III
/// @param side  of the crack, which tells +180 from -180 degrees near its faces
Tensor2 crack_tip_gradient(std::size_t mode, double x1, double x2, int side, double nu, double mu) {
  using std::numbers::pi;
  const double r = std::hypot(x1, x2);
  double angle = std::atan2(x2, x1);
  if (std::abs(angle) > pi / 2 && angle * side < 0) angle += 2 * pi * side;
  const double s = std::sin(angle / 2);
  const double c = std::cos(angle / 2);
  const double S = std::sin(angle);
  const double C = std::cos(angle);
  const double kappa = 3 - 4 * nu;
  Tensor<1, 3> f;   // u = sqrt(r) f(angle)
  Tensor<1, 3> df;  // df/dangle
  if (mode == 0) {
    f = Tensor<1, 3>({c * (kappa - C), s * (kappa - C), 0});
    df = Tensor<1, 3>({-0.5 * s * (kappa - C) + c * S, 0.5 * c * (kappa - C) + s * S, 0});
  } else if (mode == 1) {
    f = Tensor<1, 3>({s * (kappa + 2 + C), -c * (kappa - 2 + C), 0});
    df = Tensor<1, 3>({0.5 * c * (kappa + 2 + C) - s * S, 0.5 * s * (kappa - 2 + C) + c * S, 0});
  } else {
    f = Tensor<1, 3>({0, 0, 4 * s});
    df = Tensor<1, 3>({0, 0, 2 * c});
  }
  const double scale = 1 / (2 * mu * std::sqrt(2 * pi * r));
  Tensor2 gradient;
  for (unsigned i = 0; i < 3; ++i) {
    gradient[i][0] = scale * (C * f[i] / 2 - S * df[i]);
    gradient[i][1] = scale * (S * f[i] / 2 + C * df[i]);
  }
  return gradient;
}

struct Complementarity {
  Eigen::VectorXd x;
  int steps;
};

/// x >= 0 with M x + b >= 0 and one of both zero everywhere; M symmetric, positive definite.
///
/// Principal pivoting: all wrong signs are changed at once as long as they become fewer, else
/// only the last one (Murty), which ends after a finite number of steps.
Complementarity solve_complementarity(const Eigen::MatrixXd& M, const Eigen::VectorXd& b) {
  constexpr int kPatience = 5;
  const Eigen::Index n = b.size();
  const int most = 200 + 20 * static_cast<int>(n);
  std::vector<bool> active(static_cast<std::size_t>(n), true);
  Eigen::Index fewest = n + 1;
  int patience = kPatience;
  for (int steps = 1; steps <= most; ++steps) {
    std::vector<Eigen::Index> set;
    for (Eigen::Index i = 0; i < n; ++i)
      if (active[static_cast<std::size_t>(i)]) set.push_back(i);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    const Eigen::MatrixXd part = M(set, set);
    const Eigen::VectorXd load = -b(set);
    const Eigen::VectorXd found = part.llt().solve(load);
    x(set) = found;
    const Eigen::VectorXd slack = M * x + b;
    const double nothing_x = 1e-9 * x.cwiseAbs().maxCoeff();
    const double nothing_slack = 1e-9 * b.cwiseAbs().maxCoeff();
    std::vector<Eigen::Index> wrong;
    for (Eigen::Index i = 0; i < n; ++i)
      if (active[static_cast<std::size_t>(i)] ? x[i] < -nothing_x : slack[i] < -nothing_slack)
        wrong.push_back(i);
    const auto count = static_cast<Eigen::Index>(wrong.size());
    if (count == 0) return {x.cwiseMax(0.0), steps};
    if (count < fewest) {
      fewest = count;
      patience = kPatience;
    } else {
      --patience;
    }
    if (patience < 0) wrong = {wrong.back()};
    for (const Eigen::Index i : wrong)
      active[static_cast<std::size_t>(i)] = !active[static_cast<std::size_t>(i)];
  }
  throw SolverError(fmt::format("contact of the crack faces did not settle in {} steps", most));
}

/// Everything between the problem and its displacements.
class Model {
 public:
  Model(const HexMesh& mesh, const SolidProblem& problem)
      : mesh_(mesh),
        problem_(problem),
        lame_(problem.material),
        body_(mesh, problem.order),
        scalar_(static_cast<unsigned>(problem.order)),
        element_(scalar_, 3),
        dofs_(body_.triangulation) {
    result_.worst_jacobian = worst_jacobian(mesh_, body_);
    dofs_.distribute_dofs(element_);
    u_.reinit(dofs_.n_dofs());
    result_.dofs = dofs_.n_dofs();
    result_.cells = mesh.cells.size();
    node_of_.resize(3, std::vector<unsigned>(scalar_.n_dofs_per_cell()));
    for (unsigned i = 0; i < element_.n_dofs_per_cell(); ++i)
      node_of_[element_.system_to_component_index(i).first]
              [element_.system_to_component_index(i).second] = i;
    assemble_loads();
  }

  SolidResult run() {
    solve();
    if (problem_.crack_faces == CrackFaces::contact) close_crack();
    solver_.reset();
    evaluate();
    if (problem_.fields.divisions > 0) result_.fields = sample();
    return std::move(result_);
  }

  [[nodiscard]] const HexMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Body& body() const { return body_; }
  [[nodiscard]] const Lame& lame() const { return lame_; }
  [[nodiscard]] const dealii::FE_Q<3>& scalar() const { return scalar_; }
  [[nodiscard]] const dealii::DoFHandler<3>& dofs() const { return dofs_; }
  [[nodiscard]] const HexCell& source(const Cell& cell) const {
    return mesh_.cells[static_cast<std::size_t>(cell->index())];
  }

  /// Displacement gradients at the points of `values`, which are of the scalar element.
  void gradients(const Cell& cell, const dealii::FEValuesBase<3>& values,
                 std::vector<Tensor2>& out) const {
    cell_values(cell);
    out.assign(values.n_quadrature_points, Tensor2());
    for (unsigned q = 0; q < values.n_quadrature_points; ++q)
      for (unsigned a = 0; a < scalar_.n_dofs_per_cell(); ++a) {
        const Tensor<1, 3>& g = values.shape_grad(a, q);
        for (unsigned i = 0; i < 3; ++i) out[q][i] += local_[node_of_[i][a]] * g;
      }
  }

 private:
  /// The dofs of the crack's two sides at one place.
  struct Pair {
    std::array<Index, 3> upper;
    std::array<Index, 3> lower;
    Tensor<1, 3> normal;                        ///< from lower to upper
    double area;                                ///< the node's share of the crack [m^2]
    std::vector<std::pair<Index, double>> row;  ///< its gap as a sum over unconstrained dofs
  };

  void cell_values(const Cell& cell) const {
    indices_.resize(element_.n_dofs_per_cell());
    local_.resize(element_.n_dofs_per_cell());
    cell->get_dof_indices(indices_);
    for (std::size_t i = 0; i < indices_.size(); ++i) local_[i] = u_[indices_[i]];
  }

  static dealii::FEValues<3>& reinit(dealii::FEValues<3>& values, const Cell& cell) {
    values.reinit(typename dealii::Triangulation<3>::active_cell_iterator(cell));
    return values;
  }

  void sum(Vector& v) const {
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(v.begin(), v.size()),
                                MPI_COMM_WORLD, dealii::ArrayView<double>(v.begin(), v.size()));
  }

  void assemble_loads() {
    load_.reinit(dofs_.n_dofs());
    const dealii::QGauss<2> rule(static_cast<unsigned>(problem_.order) + 3);
    dealii::FEFaceValues<3> values(
        body_.mapping, scalar_, rule,
        dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values);
    indices_.resize(element_.n_dofs_per_cell());
    for (const Cell& cell : dofs_.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned f : cell->face_indices())
          for (const Traction& traction : problem_.tractions)
            if (cell->face(f)->at_boundary() &&
                cell->face(f)->boundary_id() == static_cast<unsigned>(traction.tag)) {
              values.reinit(typename dealii::Triangulation<3>::active_cell_iterator(cell), f);
              cell->get_dof_indices(indices_);
              for (const unsigned q : values.quadrature_point_indices()) {
                const Point3 t = traction.value(to_array(values.quadrature_point(q)));
                for (unsigned a = 0; a < scalar_.n_dofs_per_cell(); ++a)
                  for (unsigned i = 0; i < 3; ++i)
                    load_[indices_[node_of_[i][a]]] +=
                        t[i] * values.shape_value(a, q) * values.JxW(q);
              }
            }
    sum(load_);
  }

  /// The three dofs of every node of a cell's face.
  template <class Visit>
  void visit_face_nodes(const Cell& cell, unsigned f, const Visit& visit) const {
    indices_.resize(element_.n_dofs_per_cell());
    cell->get_dof_indices(indices_);
    for (unsigned a = 0; a < scalar_.n_dofs_per_cell(); ++a)
      if (scalar_.has_support_on_face(a, f))
        visit(a, std::array<Index, 3>{indices_[node_of_[0][a]], indices_[node_of_[1][a]],
                                      indices_[node_of_[2][a]]});
  }

  /// u_k of the node = combination of its other components, so that the one along n vanishes.
  static void hold(dealii::AffineConstraints<double>& constraints, const std::array<Index, 3>& node,
                   const Tensor<1, 3>& n) {
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

  void make_constraints() {
    constraints_.clear();
    for (const Cell& cell : dofs_.active_cell_iterators())
      for (const unsigned f : cell->face_indices())
        for (const Support& support : problem_.supports)
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == static_cast<unsigned>(support.tag))
            visit_face_nodes(cell, f, [&](unsigned a, const std::array<Index, 3>& node) {
              const Point<3> unit = scalar_.unit_support_point(a);
              const std::vector<Point3> directions =
                  support.directions(source(cell).map(to_array(unit)));
              if (directions.size() == 3) {
                for (const Index i : node)
                  if (!constraints_.is_constrained(i)) constraints_.add_line(i);
              } else {
                for (const Point3& d : directions) hold(constraints_, node, to_tensor(d));
              }
            });
    constraints_.close();
  }

  void solve() {
    auto start = std::chrono::steady_clock::now();
    make_constraints();
    number_unknowns();
    SymmetricEntries entries = assemble_together();
    result_.assembly_seconds += seconds_since(start);
    start = std::chrono::steady_clock::now();
    solver_ = std::make_unique<DirectSolver>(std::move(entries), unknowns_);
    result_.factor_megabytes = solver_->megabytes();
    result_.factor_operations = solver_->operations();
    displace(load_);
    result_.solver_seconds += seconds_since(start);
  }

  /// A cell after the elimination of the dofs that no other cell has.
  struct CondensedCell {
    std::vector<Index> inner;  ///< dofs that were eliminated
    std::vector<int> outer;    ///< numbers of the unknowns that were not
    CondensedMatrix matrix;    ///< its `outer` is given away
  };

  static constexpr int kConstrained = -1;
  static constexpr int kInner = -2;

  /// Which unknowns the solver gets: neither constrained ones, nor those of one cell alone.
  void number_unknowns() {
    number_.assign(dofs_.n_dofs(), kInner);
    std::vector<char> seen(dofs_.n_dofs(), 0);
    indices_.resize(element_.n_dofs_per_cell());
    for (const Cell& cell : dofs_.active_cell_iterators()) {
      cell->get_dof_indices(indices_);
      for (const Index i : indices_) {
        if (seen[i]) number_[i] = 0;
        seen[i] = 1;
      }
    }
    if (problem_.crack_faces == CrackFaces::contact)  // these will be pushed apart
      for (const Cell& cell : dofs_.active_cell_iterators())
        for (const unsigned f : cell->face_indices())
          if (is_crack_face(cell, f))
            visit_face_nodes(cell, f, [&](unsigned, const std::array<Index, 3>& node) {
              for (const Index i : node) number_[i] = 0;
            });
    for (const auto& line : constraints_.get_lines())
      for (const auto& entry : line.entries) number_[entry.first] = 0;
    for (const auto& line : constraints_.get_lines()) number_[line.index] = kConstrained;
    unknowns_ = 0;
    for (int& number : number_)
      if (number >= 0) number = unknowns_++;
  }

  /// Lower triangle of the stiffness of one cell; component i of node a is row i * nodes + a.
  [[nodiscard]] Eigen::MatrixXd stiffness(const dealii::FEValues<3>& values) const {
    const auto n = static_cast<Eigen::Index>(scalar_.n_dofs_per_cell());
    const auto points = static_cast<Eigen::Index>(values.n_quadrature_points);
    Eigen::MatrixXd gradient(3 * n, points);  // scaled by the root of the weight
    for (Eigen::Index q = 0; q < points; ++q) {
      const double root = std::sqrt(values.JxW(static_cast<unsigned>(q)));
      for (Eigen::Index a = 0; a < n; ++a) {
        const Tensor<1, 3>& g =
            values.shape_grad(static_cast<unsigned>(a), static_cast<unsigned>(q));
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
              (lame_.lambda + lame_.mu) * product(j * n + a, j * n + b) + lame_.mu * laplace;
        }
      for (Eigen::Index i = j + 1; i < 3; ++i) {
        const auto block = product.block(i * n, j * n, n, n);
        matrix.block(i * n, j * n, n, n) =
            lame_.lambda * block + lame_.mu * block.transpose();  // (FE-20)
      }
    }
    return matrix;
  }

  /// Stiffness of this rank's cells; keeps in `cells_` what the inner unknowns need.
  SymmetricEntries assemble() {
    const dealii::QGauss<3> rule(static_cast<unsigned>(problem_.order) + 1);
    dealii::FEValues<3> values(body_.mapping, scalar_, rule,
                               dealii::update_gradients | dealii::update_JxW_values);
    const std::size_t size = element_.n_dofs_per_cell();
    const std::size_t nodes = scalar_.n_dofs_per_cell();
    SymmetricEntries entries;
    indices_.resize(size);
    for (const Cell& cell : dofs_.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      reinit(values, cell);
      cell->get_dof_indices(indices_);
      // Rows of the cell's stiffness by their kind, and the unknowns that a row turns into.
      std::vector<Eigen::Index> inner;
      std::vector<Eigen::Index> rest;
      CondensedCell& mine = cells_.emplace_back();
      std::map<int, Eigen::Index> column;
      bool plain = true;
      const auto dof = [&](Eigen::Index row) {
        const auto r = static_cast<std::size_t>(row);
        return indices_[node_of_[r / nodes][r % nodes]];
      };
      const auto include = [&](int number) {
        if (column.emplace(number, static_cast<Eigen::Index>(mine.outer.size())).second)
          mine.outer.push_back(number);
      };
      for (Eigen::Index row = 0; row < static_cast<Eigen::Index>(size); ++row) {
        const Index i = dof(row);
        if (number_[i] == kInner) {
          inner.push_back(row);
          mine.inner.push_back(i);
        } else if (number_[i] >= 0) {
          rest.push_back(row);
          include(number_[i]);
        } else if (!constraints_.get_constraint_entries(i)->empty()) {
          plain = false;
          rest.push_back(row);
          for (const auto& entry : *constraints_.get_constraint_entries(i))
            include(number_[entry.first]);
        }
      }
      const auto n_inner = static_cast<Eigen::Index>(inner.size());
      std::vector<Eigen::Index> order = inner;
      order.insert(order.end(), rest.begin(), rest.end());
      const Eigen::MatrixXd all = stiffness(values);
      const auto n = static_cast<Eigen::Index>(order.size());
      Eigen::MatrixXd matrix(n, n);
      for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = j; i < n; ++i)
          matrix(i, j) = all(std::max(order[i], order[j]), std::min(order[i], order[j]));
      if (!plain) {
        const auto kept = static_cast<Eigen::Index>(mine.outer.size());
        Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(n, n_inner + kept);
        turn.topLeftCorner(n_inner, n_inner).setIdentity();
        for (Eigen::Index row = n_inner; row < n; ++row) {
          const Index i = dof(order[row]);
          if (number_[i] >= 0)
            turn(row, n_inner + column.at(number_[i])) = 1;
          else
            for (const auto& entry : *constraints_.get_constraint_entries(i))
              turn(row, n_inner + column.at(number_[entry.first])) += entry.second;
        }
        matrix = turn.transpose() * (matrix.selfadjointView<Eigen::Lower>() * turn);
      }
      mine.matrix = condense(matrix, n_inner);
      const auto n_outer = static_cast<Eigen::Index>(mine.outer.size());
      if (entries.value.empty())
        entries.reserve(body_.triangulation.n_locally_owned_active_cells() *
                        static_cast<std::size_t>(n_outer * (n_outer + 1) / 2));
      for (Eigen::Index j = 0; j < n_outer; ++j)
        for (Eigen::Index i = j; i < n_outer; ++i)
          entries.add(mine.outer[i] + 1, mine.outer[j] + 1, mine.matrix.outer(i, j));
      mine.matrix.outer.resize(0, 0);
    }
    return entries;
  }

  /// The displacements u_ under nodal forces.
  void displace(Vector forces) {
    constraints_.condense(forces);
    std::vector<double> rhs(static_cast<std::size_t>(unknowns_));
    std::vector<double> inner_rhs(rhs.size(), 0.0);
    std::vector<Eigen::VectorXd> inner_forces;  // L^-1 f_i, cell by cell
    for (const CondensedCell& cell : cells_) {
      Eigen::VectorXd& f = inner_forces.emplace_back(static_cast<Eigen::Index>(cell.inner.size()));
      for (Eigen::Index i = 0; i < f.size(); ++i) f(i) = forces[cell.inner[i]];
      if (!f.any()) continue;
      cell.matrix.factor.triangularView<Eigen::Lower>().solveInPlace(f);
      const Eigen::VectorXd left = cell.matrix.coupling.transpose() * f;
      for (Eigen::Index i = 0; i < left.size(); ++i) inner_rhs[cell.outer[i]] -= left(i);
    }
    dealii::Utilities::MPI::sum(inner_rhs, MPI_COMM_WORLD, inner_rhs);
    for (Index i = 0; i < number_.size(); ++i)
      if (number_[i] >= 0) rhs[static_cast<std::size_t>(number_[i])] = forces[i];
    for (std::size_t i = 0; i < rhs.size(); ++i) rhs[i] += inner_rhs[i];
    const std::vector<double> x = solver_->solve(std::move(rhs));
    u_.reinit(dofs_.n_dofs());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const CondensedCell& cell = cells_[c];
      Eigen::VectorXd outer(static_cast<Eigen::Index>(cell.outer.size()));
      for (Eigen::Index i = 0; i < outer.size(); ++i) outer(i) = x[cell.outer[i]];
      Eigen::VectorXd u = inner_forces[c] - cell.matrix.coupling * outer;
      cell.matrix.factor.triangularView<Eigen::Lower>().transpose().solveInPlace(u);
      for (Eigen::Index i = 0; i < u.size(); ++i) u_[cell.inner[i]] = u(i);
    }
    sum(u_);
    for (Index i = 0; i < number_.size(); ++i)
      if (number_[i] >= 0) u_[i] = x[static_cast<std::size_t>(number_[i])];
    constraints_.distribute(u_);
  }

  /// `assemble`; a fault of one rank's cells ends all, for MUMPS would wait for it.
  SymmetricEntries assemble_together() {
    SymmetricEntries entries;
    std::exception_ptr fault;
    try {
      entries = assemble();
    } catch (const std::bad_alloc&) {
      fault = std::make_exception_ptr(MemoryError("there is too little memory for the matrix"));
    } catch (...) {
      fault = std::current_exception();
    }
    const bool all_well = dealii::Utilities::MPI::min(fault ? 0 : 1, MPI_COMM_WORLD) == 1;
    if (fault) std::rethrow_exception(fault);
    if (!all_well) throw OtherRankError("another rank could not assemble its cells");
    return entries;
  }

  /// Internal nodal forces, without any constraint.
  [[nodiscard]] Vector internal_forces(double& energy) const {
    Vector forces(dofs_.n_dofs());
    const dealii::QGauss<3> rule(static_cast<unsigned>(problem_.order) + 1);
    dealii::FEValues<3> values(body_.mapping, scalar_, rule,
                               dealii::update_gradients | dealii::update_JxW_values);
    std::vector<Tensor2> gradient;
    energy = 0;
    for (const Cell& cell : dofs_.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      reinit(values, cell);
      gradients(cell, values, gradient);
      for (unsigned q = 0; q < rule.size(); ++q) {
        const Tensor2 stress = values.JxW(q) * lame_.stress(gradient[q]);
        energy += 0.5 * scalar_product(stress, gradient[q]);
        for (unsigned a = 0; a < scalar_.n_dofs_per_cell(); ++a) {
          const Tensor<1, 3> force = stress * values.shape_grad(a, q);
          for (unsigned i = 0; i < 3; ++i) forces[indices_[node_of_[i][a]]] += force[i];
        }
      }
    }
    sum(forces);
    energy = dealii::Utilities::MPI::sum(energy, MPI_COMM_WORLD);
    return forces;
  }

  // --- contact of the crack faces

  [[nodiscard]] bool is_crack_face(const Cell& cell, unsigned f) const {
    return problem_.crack_tag != 0 && cell->face(f)->at_boundary() &&
           cell->face(f)->boundary_id() == static_cast<unsigned>(problem_.crack_tag);
  }

  void find_pairs() {
    const dealii::QGauss<2> rule(static_cast<unsigned>(problem_.order) + 2);
    dealii::FEFaceValues<3> values(
        body_.mapping, scalar_, rule,
        dealii::update_values | dealii::update_normal_vectors | dealii::update_JxW_values);
    std::map<std::array<Index, 3>, std::pair<Point<3>, Tensor<1, 3>>> upper;
    std::map<std::array<Index, 3>, Point<3>> lower;
    double size = 0;
    for (const Cell& cell : dofs_.active_cell_iterators())
      for (const unsigned f : cell->face_indices()) {
        if (!is_crack_face(cell, f)) continue;
        values.reinit(typename dealii::Triangulation<3>::active_cell_iterator(cell), f);
        size = std::max(size, cell->diameter());
        visit_face_nodes(cell, f, [&](unsigned a, const std::array<Index, 3>& node) {
          const Point<3> place =
              to_point(source(cell).map(to_array(scalar_.unit_support_point(a))));
          if (source(cell).side < 0) {
            lower[node] = place;
            return;
          }
          auto& entry = upper[node];
          entry.first = place;
          for (const unsigned q : values.quadrature_point_indices())
            entry.second -= values.shape_value(a, q) * values.JxW(q) * values.normal_vector(q);
        });
      }
    for (const auto& [node, at] : upper) {
      if (lower.count(node)) {
        on_front_.insert(node[0]);
        continue;
      }
      for (const auto& [twin, place] : lower)
        if (!upper.count(twin) && place.distance(at.first) < 1e-9 * size)
          pairs_.push_back({node, twin, at.second / at.second.norm(), at.second.norm(), {}});
    }
    for (Pair& pair : pairs_) {
      std::map<Index, double> row;
      const auto add = [&](Index i, double value) {
        if (!constraints_.is_constrained(i)) {
          row[i] += value;
          return;
        }
        for (const auto& [j, factor] : *constraints_.get_constraint_entries(i))
          row[j] += factor * value;
      };
      for (unsigned k = 0; k < 3; ++k) {
        add(pair.upper[k], pair.normal[k]);
        add(pair.lower[k], -pair.normal[k]);
      }
      pair.row.assign(row.begin(), row.end());
    }
  }

  /// Normal distance of the two sides at each pair; < 0: they pass through each other.
  [[nodiscard]] Eigen::VectorXd gaps() const {
    Eigen::VectorXd gap = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(pairs_.size()));
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      for (unsigned k = 0; k < 3; ++k)
        gap[static_cast<Eigen::Index>(i)] +=
            (u_[pairs_[i].upper[k]] - u_[pairs_[i].lower[k]]) * pairs_[i].normal[k];
    return gap;
  }

  [[nodiscard]] double largest_jump() const {
    double jump = 0;
    for (const Pair& pair : pairs_) {
      double square = 0;
      for (unsigned k = 0; k < 3; ++k) square += std::pow(u_[pair.upper[k]] - u_[pair.lower[k]], 2);
      jump = std::max(jump, std::sqrt(square));
    }
    return jump;
  }

  /// Gap of pair i under a unit pressure at pair j, that is under a pair of forces of its area.
  [[nodiscard]] Eigen::MatrixXd contact_flexibility() const {
    constexpr std::size_t kBlock = 64;
    const auto n = static_cast<Eigen::Index>(pairs_.size());
    const auto unknowns = static_cast<std::size_t>(unknowns_);
    Eigen::MatrixXd flexibility = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t first = 0; first < pairs_.size(); first += kBlock) {
      const std::size_t count = std::min(kBlock, pairs_.size() - first);
      std::vector<double> columns(count * unknowns, 0.0);
      for (std::size_t j = 0; j < count; ++j)
        for (const auto& [dof, value] : pairs_[first + j].row)
          columns[j * unknowns + static_cast<std::size_t>(number_[dof])] +=
              value * pairs_[first + j].area;
      columns = solver_->solve(std::move(columns), static_cast<int>(count));
      for (std::size_t j = 0; j < count; ++j)
        for (Eigen::Index i = 0; i < n; ++i)
          for (const auto& [dof, value] : pairs_[static_cast<std::size_t>(i)].row)
            flexibility(i, static_cast<Eigen::Index>(first + j)) +=
                value * columns[j * unknowns + static_cast<std::size_t>(number_[dof])];
    }
    return flexibility;
  }

  /// Pressure between the faces where they would pass through each other; (FE-30).
  void close_crack() {
    constexpr double kNothing = 1e-5;  // of the largest jump
    const auto start = std::chrono::steady_clock::now();
    find_pairs();
    if (pairs_.empty()) throw InputError("mesh", "has no crack faces that could touch");
    const double jump = largest_jump();
    const Eigen::VectorXd free_gap = gaps();
    if (free_gap.minCoeff() >= -kNothing * jump) return;
    Eigen::VectorXd area(free_gap.size());
    for (Eigen::Index i = 0; i < area.size(); ++i)
      area[i] = pairs_[static_cast<std::size_t>(i)].area;
    const Complementarity answer = solve_complementarity(area.asDiagonal() * contact_flexibility(),
                                                         area.asDiagonal() * free_gap);
    result_.contact_iterations = answer.steps;
    contact_forces_.reinit(dofs_.n_dofs());
    pressure_.assign(dofs_.n_dofs(), 0.0);
    double touching = 0;
    double whole = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Pair& pair = pairs_[i];
      const double p = answer.x[static_cast<Eigen::Index>(i)];
      whole += pair.area;
      if (!(p > 0)) continue;
      touching += pair.area;
      pressure_[pair.upper[0]] = pressure_[pair.lower[0]] = p;
      for (unsigned k = 0; k < 3; ++k) {
        contact_forces_[pair.upper[k]] += p * pair.area * pair.normal[k];
        contact_forces_[pair.lower[k]] -= p * pair.area * pair.normal[k];
      }
    }
    result_.contact_share = touching / whole;
    Vector forces = load_;
    forces += contact_forces_;
    displace(forces);
    result_.contact_overlap = std::max(0.0, -gaps().minCoeff()) / jump;
    result_.solver_seconds += seconds_since(start);
    extend_pressure_to_fronts();
  }

  /// At a front both sides share their nodes and bear no pressure as a pair: it is that of the
  /// neighbour on the face.
  void extend_pressure_to_fronts() {
    for (const Cell& cell : dofs_.active_cell_iterators())
      for (const unsigned f : cell->face_indices()) {
        if (!is_crack_face(cell, f)) continue;
        std::vector<std::pair<Point<3>, Index>> shared;
        std::vector<std::pair<Point<3>, Index>> paired;
        visit_face_nodes(cell, f, [&](unsigned a, const std::array<Index, 3>& node) {
          (on_front_.count(node[0]) ? shared : paired)
              .push_back({scalar_.unit_support_point(a), node[0]});
        });
        for (const auto& [place, dof] : shared) {
          double nearest = 2;
          for (const auto& [other, twin] : paired)
            if (std::abs(other[2] - place[2]) < 1e-9 && other.distance(place) < nearest) {
              nearest = other.distance(place);
              pressure_[dof] = pressure_[twin];
            }
        }
      }
  }

  // --- what is made of the displacements

  void evaluate() {
    double energy = 0;
    Vector residual = internal_forces(energy);
    result_.strain_energy = energy;
    result_.work = load_ * u_;
    residual -= load_;
    if (!pressure_.empty()) residual -= contact_forces_;
    constraints_.condense(residual);
    double largest = 0;
    for (Index i = 0; i < residual.size(); ++i)
      if (!constraints_.is_constrained(i)) largest = std::max(largest, std::abs(residual[i]));
    result_.equilibrium_residual = largest / load_.linfty_norm();  // (FE-21)
    result_.energy_balance = std::abs(result_.work / (2 * energy) - 1);
    evaluate_crack_faces();
    for (std::size_t f = 0; f < mesh_.fronts; ++f) result_.fronts.push_back(evaluate_front(f));
  }

  void evaluate_crack_faces() {
    const dealii::QGauss<2> rule(static_cast<unsigned>(problem_.order) + 3);
    dealii::FEFaceValues<3> values(body_.mapping, scalar_, rule,
                                   dealii::update_values | dealii::update_normal_vectors |
                                       dealii::update_quadrature_points |
                                       dealii::update_JxW_values);
    double work = 0;
    double volume = 0;
    for (const Cell& cell : dofs_.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      for (const unsigned f : cell->face_indices()) {
        if (!is_crack_face(cell, f)) continue;
        values.reinit(typename dealii::Triangulation<3>::active_cell_iterator(cell), f);
        cell_values(cell);
        for (const unsigned q : values.quadrature_point_indices()) {
          Tensor<1, 3> u;
          for (unsigned a = 0; a < scalar_.n_dofs_per_cell(); ++a)
            for (unsigned i = 0; i < 3; ++i)
              u[i] += local_[node_of_[i][a]] * values.shape_value(a, q);
          const Tensor<1, 3>& n = values.normal_vector(q);
          volume -= u * n * values.JxW(q);
          if (!problem_.stress_without_crack) continue;
          const auto s = problem_.stress_without_crack(to_array(values.quadrature_point(q)));
          for (unsigned i = 0; i < 3; ++i)
            work -= (s[i][0] * n[0] + s[i][1] * n[1] + s[i][2] * n[2]) * u[i] *
                    values.JxW(q);  // (FE-26)
        }
      }
    }
    result_.added_work = dealii::Utilities::MPI::sum(work, MPI_COMM_WORLD);
    result_.crack_volume = dealii::Utilities::MPI::sum(volume, MPI_COMM_WORLD);
  }

  /// Rotation of the cells about a front, mean over their volume: the antisymmetric gradient.
  [[nodiscard]] Tensor2 mean_spin(std::size_t front) const {
    const dealii::QGauss<3> rule(static_cast<unsigned>(problem_.order) + 1);
    dealii::FEValues<3> values(body_.mapping, scalar_, rule,
                               dealii::update_gradients | dealii::update_JxW_values);
    std::vector<Tensor2> gradient;
    std::array<double, 4> sums{};  // three rotations, volume
    for (const Cell& cell : dofs_.active_cell_iterators()) {
      const HexCell& origin = source(cell);
      if (!origin.front || origin.front->front != front || !cell->is_locally_owned()) continue;
      reinit(values, cell);
      gradients(cell, values, gradient);
      for (unsigned q = 0; q < rule.size(); ++q) {
        for (unsigned k = 0; k < 3; ++k) {
          const unsigned i = (k + 1) % 3;
          const unsigned j = (k + 2) % 3;
          sums[k] += values.JxW(q) * 0.5 * (gradient[q][i][j] - gradient[q][j][i]);
        }
        sums[3] += values.JxW(q);
      }
    }
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(sums.data(), sums.size()),
                                MPI_COMM_WORLD,
                                dealii::ArrayView<double>(sums.data(), sums.size()));
    Tensor2 spin;
    for (unsigned k = 0; k < 3; ++k) {
      spin[(k + 1) % 3][(k + 2) % 3] = sums[k] / sums[3];
      spin[(k + 2) % 3][(k + 1) % 3] = -sums[k] / sums[3];
    }
    return spin;
  }
  /// Pressure of contact at a point of a crack face; 0 without contact.
  [[nodiscard]] double pressure_at(const Cell& cell, const dealii::FEValuesBase<3>& values,
                                   unsigned q) const {
    if (pressure_.empty()) return 0;
    cell->get_dof_indices(indices_);
    double pressure = 0;
    for (unsigned a = 0; a < scalar_.n_dofs_per_cell(); ++a)
      pressure += pressure_[indices_[node_of_[0][a]]] * values.shape_value(a, q);
    return pressure;
  }

  [[nodiscard]] SampledFields sample() const;
  void sample_crack_faces(SampledFields& fields) const;
  [[nodiscard]] CrackFront evaluate_front(std::size_t front) const;
  [[nodiscard]] CrackFront front_of_integrals(const std::map<std::size_t, const HexCell*>& tips,
                                              const std::vector<double>& integral,
                                              const std::vector<double>& radius,
                                              const std::vector<bool>& touching) const;
  [[nodiscard]] std::vector<bool> touching_stations(std::size_t front, std::size_t nodes) const;

  const HexMesh& mesh_;
  const SolidProblem& problem_;
  Lame lame_;
  Body body_;
  dealii::FE_Q<3> scalar_;
  dealii::FESystem<3> element_;
  dealii::DoFHandler<3> dofs_;
  std::vector<std::vector<unsigned>> node_of_;  ///< [component][node of the scalar element]
  dealii::AffineConstraints<double> constraints_;
  Vector load_;
  Vector u_;
  std::unique_ptr<DirectSolver> solver_;
  std::vector<CondensedCell> cells_;  ///< of this rank
  std::vector<Pair> pairs_;
  std::set<Index> on_front_;  ///< first dofs of the nodes that both sides share
  Vector contact_forces_;
  std::vector<double> pressure_;  ///< of contact, at a node's first dof [Pa]; empty without contact
  std::vector<int> number_;       ///< of each dof in the linear equations, or why it has none
  int unknowns_ = 0;              ///< of the linear equations
  SolidResult result_;
  mutable std::vector<Index> indices_;
  mutable std::vector<double> local_;
};

// --- fracture quantities

/// The front's frame and place at one point.
struct FrontFrame {
  Point<3> place;
  Tensor2 axes;    ///< rows x1, x2, x3
  double rate;     ///< area swept per length of front and unit of `advance`
  double stretch;  ///< length of front per unit of w
};

FrontFrame front_frame(const HexCell& tip, double w) {
  constexpr double kStep = 1e-4;
  FrontFrame frame;
  frame.place = to_point(tip.map({0, 0, w}));
  const Tensor<1, 3> along =
      (to_point(tip.map({0, 0, w + kStep})) - to_point(tip.map({0, 0, w - kStep}))) / (2 * kStep);
  frame.stretch = along.norm();
  const Tensor<1, 3> x3 = along / frame.stretch;
  const Tensor<1, 3> d = to_tensor(tip.front->advance({0, 0, w}));
  Tensor<1, 3> x1 = d - (d * x3) * x3;
  frame.rate = x1.norm();
  x1 /= frame.rate;
  frame.axes[0] = x1;
  frame.axes[1] = cross_product_3d(x3, x1);
  frame.axes[2] = x3;
  return frame;
}

/// Quadratic shape functions on [0,1], nodes 0, 1/2, 1.
std::array<double, 3> quadratic(double w) {
  return {(1 - w) * (1 - 2 * w), 4 * w * (1 - w), w * (2 * w - 1)};
}

/// Gauss points on a face; `toward`: the coordinate (0 or 1) that starts at a crack front, about
/// which the points crowd so that its inverse root is integrated too.
dealii::Quadrature<2> face_points(unsigned n, std::optional<unsigned> toward) {
  dealii::Quadrature<2> rule = dealii::QGauss<2>(n);
  if (!toward) return rule;
  std::vector<Point<2>> points = rule.get_points();
  std::vector<double> weights = rule.get_weights();
  for (std::size_t q = 0; q < points.size(); ++q) {
    const double s = points[q][*toward];
    points[q][*toward] = s * s;
    weights[q] *= 2 * s;
  }
  return {points, weights};
}

struct FaceRule {
  dealii::Quadrature<2> points;
  dealii::FEFaceValues<3> values;    ///< of the displacements
  dealii::FEFaceValues<3> velocity;  ///< of the virtual crack advance

  FaceRule(const dealii::Mapping<3>& mapping, const dealii::FE_Q<3>& displacements,
           const dealii::FE_Q<3>& advance, const dealii::Quadrature<2>& at)
      : points(at),
        values(mapping, displacements, at,
               dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                   dealii::update_quadrature_points | dealii::update_normal_vectors),
        velocity(mapping, advance, at, dealii::update_values) {}
};

CrackFront Model::evaluate_front(std::size_t front) const {
  constexpr std::size_t kFields = 4;           // G and the interaction with modes I, II, III
  std::map<std::size_t, const HexCell*> tips;  // one cell at the front of each segment
  int rings = 0;
  for (const HexCell& cell : mesh_.cells)
    if (cell.front && cell.front->front == front) {
      if (cell.front->ring < 0) tips[cell.front->segment] = &cell;
      rings = std::max(rings, cell.front->ring + 1);
    }
  const std::size_t segments = tips.size();
  const std::size_t nodes = 2 * segments + 1;
  const auto columns = static_cast<std::size_t>(rings);

  // Domain integrals [field][node of the front][ring].
  std::vector<double> integral(kFields * nodes * columns, 0.0);
  const auto at = [&](std::size_t field, std::size_t node, std::size_t ring) -> double& {
    return integral[(field * nodes + node) * columns + ring];
  };
  std::vector<double> radius(columns, 0.0);

  const dealii::FE_Q<3> velocity(4);  // of the virtual crack advance within a cell
  const dealii::QGauss<3> rule(static_cast<unsigned>(problem_.order) + 3);
  dealii::FEValues<3> values(
      body_.mapping, scalar_, rule,
      dealii::update_gradients | dealii::update_JxW_values | dealii::update_quadrature_points);
  dealii::FEValues<3> q_values(body_.mapping, velocity, rule, dealii::update_gradients);
  const auto face_rule = [&](std::optional<unsigned> toward) {
    return std::make_unique<FaceRule>(
        body_.mapping, scalar_, velocity,
        face_points(static_cast<unsigned>(problem_.order) + 3, toward));
  };
  // The crack's faces at its front: u = 0 has the coordinates (v, w), v = 0 has (w, u).
  const std::array<std::unique_ptr<FaceRule>, 3> face_rules{face_rule({}), face_rule(0U),
                                                            face_rule(1U)};
  const auto auxiliary = [&](std::size_t mode, const FrontFrame& frame, const Point<3>& place,
                             const HexCell& cell) {
    const Tensor<1, 3> from = place - frame.place;
    const Tensor2 local =
        crack_tip_gradient(mode, from * frame.axes[0], from * frame.axes[1], cell.front->side,
                           problem_.material.poissons_ratio, lame_.mu);
    return transpose(frame.axes) * local * frame.axes;
  };
  const unsigned n_velocity = velocity.n_dofs_per_cell();
  std::vector<Tensor2> gradient;
  // The auxiliary fields are not in equilibrium on a curved front and would take a rotation of the
  // body for a stress intensity: it is taken off.
  const Tensor2 spin = mean_spin(front);
  std::vector<Tensor<1, 3>> moment(kFields * n_velocity);
  for (const Cell& cell : dofs_.active_cell_iterators()) {
    const HexCell& origin = source(cell);
    if (!origin.front || origin.front->front != front) continue;
    const std::size_t segment = origin.front->segment;
    const HexCell& tip = *tips.at(segment);
    const int ring = origin.front->ring;
    if (ring >= 0 && 2 * segment + 1 >= segments && 2 * segment <= segments)
      radius[static_cast<std::size_t>(ring)] =
          to_point(origin.map({1, 0.5, 0.5})).distance(front_frame(tip, 0.5).place);
    if (!cell->is_locally_owned()) continue;
    reinit(values, cell);
    reinit(q_values, cell);
    gradients(cell, values, gradient);
    std::fill(moment.begin(), moment.end(), Tensor<1, 3>());
    for (unsigned q = 0; q < rule.size(); ++q) {
      const Tensor2& du = gradient[q];
      const Tensor2 stress = lame_.stress(du);
      std::array<Tensor2, kFields> flux;  // [k][j]: contracted with dq_k/dx_j
      flux[0] = transpose(du) * stress;
      const double density = 0.5 * scalar_product(stress, du);
      for (unsigned k = 0; k < 3; ++k) flux[0][k][k] -= density;  // (FE-23)
      const FrontFrame frame = front_frame(tip, rule.point(q)[2]);
      for (std::size_t mode = 0; mode < 3; ++mode) {
        const Tensor2 dv = auxiliary(mode, frame, values.quadrature_point(q), origin);
        flux[mode + 1] = transpose(dv) * stress + transpose(du - spin) * lame_.stress(dv);
        const double mutual = scalar_product(stress, dv);
        for (unsigned k = 0; k < 3; ++k) flux[mode + 1][k][k] -= mutual;  // (FE-24)
      }
      for (unsigned n = 0; n < n_velocity; ++n) {
        const Tensor<1, 3> slope = values.JxW(q) * q_values.shape_grad(n, q);
        for (std::size_t field = 0; field < kFields; ++field)
          moment[field * n_velocity + n] += flux[field] * slope;
      }
    }
    // The auxiliary fields leave tractions on curved crack faces and on the front's end faces.
    for (const unsigned f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary()) continue;
      const bool crack = is_crack_face(cell, f);
      FaceRule& on_face = *face_rules[crack && ring < 0 ? (f < 2 ? 1 : 2) : 0];
      dealii::FEFaceValues<3>& face_values = on_face.values;
      face_values.reinit(typename dealii::Triangulation<3>::active_cell_iterator(cell), f);
      on_face.velocity.reinit(typename dealii::Triangulation<3>::active_cell_iterator(cell), f);
      gradients(cell, face_values, gradient);
      for (unsigned q = 0; q < on_face.points.size(); ++q) {
        const Tensor2& du = gradient[q];
        const Tensor<1, 3>& normal = face_values.normal_vector(q);
        const double w = f == 4   ? 0.0
                         : f == 5 ? 1.0
                         : f < 2  ? on_face.points.point(q)[1]
                                  : on_face.points.point(q)[0];
        const FrontFrame frame = front_frame(tip, w);
        const Tensor<1, 3> traction =
            crack ? -pressure_at(cell, face_values, q) * normal : lame_.stress(du) * normal;
        std::array<Tensor<1, 3>, kFields> force;
        if (crack) force[0] = transpose(du) * traction;  // (FE-31)
        for (std::size_t mode = 0; mode < 3; ++mode) {
          const Tensor2 dv = auxiliary(mode, frame, face_values.quadrature_point(q), origin);
          force[mode + 1] =
              transpose(du - spin) * (lame_.stress(dv) * normal) + transpose(dv) * traction;
        }
        for (unsigned n = 0; n < n_velocity; ++n)
          for (std::size_t field = 0; field < kFields; ++field)
            moment[field * n_velocity + n] -=
                on_face.velocity.shape_value(n, q) * face_values.JxW(q) * force[field];  // (FE-24)
      }
    }
    for (unsigned n = 0; n < n_velocity; ++n) {
      const Point3 unit = to_array(velocity.unit_support_point(n));
      const Tensor<1, 3> d = to_tensor(origin.front->advance(unit));
      const std::array<double, 3> shape = quadratic(unit[2]);
      for (std::size_t k = 0; k < columns; ++k) {
        const int domain = static_cast<int>(k);
        const double weight = ring < domain ? 1.0 : ring == domain ? 1 - unit[0] : 0.0;
        if (weight == 0) continue;
        for (std::size_t field = 0; field < kFields; ++field)
          for (std::size_t i = 0; i < 3; ++i)
            at(field, 2 * segment + i, k) +=
                weight * shape[i] * (d * moment[field * n_velocity + n]);
      }
    }
  }
  dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(integral.data(), integral.size()),
                              MPI_COMM_WORLD,
                              dealii::ArrayView<double>(integral.data(), integral.size()));
  return front_of_integrals(tips, integral, radius, touching_stations(front, nodes));
}

/// Whether the faces touch next to the nodes of a front: at most of the places of the cells at the
/// front and of the innermost ring that are closest to it.
std::vector<bool> Model::touching_stations(std::size_t front, std::size_t nodes) const {
  std::vector<int> balance(nodes, 0);
  if (!pressure_.empty())
    for (const Cell& cell : dofs_.active_cell_iterators()) {
      const HexCell& origin = source(cell);
      if (!origin.front || origin.front->front != front || origin.front->ring > 0) continue;
      for (const unsigned f : cell->face_indices())
        if (is_crack_face(cell, f))
          visit_face_nodes(cell, f, [&](unsigned a, const std::array<Index, 3>& node) {
            const auto nearest =
                static_cast<std::size_t>(std::lround(2 * scalar_.unit_support_point(a)[2]));
            if (on_front_.count(node[0]) == 0)
              balance[2 * origin.front->segment + nearest] += pressure_[node[0]] > 0 ? 1 : -1;
          });
    }
  std::vector<bool> touching(nodes);
  std::transform(balance.begin(), balance.end(), touching.begin(), [](int b) { return b > 0; });
  return touching;
}

CrackFront Model::front_of_integrals(const std::map<std::size_t, const HexCell*>& tips,
                                     const std::vector<double>& integral,
                                     const std::vector<double>& radius,
                                     const std::vector<bool>& touching) const {
  const std::size_t nodes = 2 * tips.size() + 1;
  const std::size_t columns = radius.size();
  if (columns < 3) throw InputError("mesh", "needs three rings about a crack front");
  const auto at = [&](std::size_t field, std::size_t node, std::size_t ring) {
    return integral[(field * nodes + node) * columns + ring];
  };
  // The rate of area is given to G by its own shape functions: consistent, not lumped.
  const auto n = static_cast<Eigen::Index>(nodes);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
  CrackFront result;
  const dealii::QGauss<1> rule(6);
  for (const auto& [segment, tip] : tips)
    for (unsigned q = 0; q < rule.size(); ++q) {
      const double w = rule.point(q)[0];
      const FrontFrame frame = front_frame(*tip, w);
      const double ds = rule.weight(q) * frame.stretch;
      result.length += ds;
      const std::array<double, 3> shape = quadratic(w);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          mass(static_cast<Eigen::Index>(2 * segment + i),
               static_cast<Eigen::Index>(2 * segment + j)) += shape[i] * shape[j] * frame.rate * ds;
    }
  const Eigen::LDLT<Eigen::MatrixXd> solver(mass);
  const auto pointwise = [&](std::size_t field, std::size_t ring) {
    Eigen::VectorXd b(n);
    for (std::size_t i = 0; i < nodes; ++i) b(static_cast<Eigen::Index>(i)) = at(field, i, ring);
    return Eigen::VectorXd(solver.solve(b));
  };

  // G: mean over the rings but the innermost, whose field is the least accurate.
  std::vector<Eigen::VectorXd> G;
  std::vector<double> release;
  for (std::size_t k = 1; k < columns; ++k) {
    G.push_back(pointwise(0, k));
    release.push_back(0);
    for (std::size_t i = 0; i < nodes; ++i) release.back() += at(0, i, k);
  }
  const double count = static_cast<double>(G.size());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
  for (std::size_t k = 0; k < G.size(); ++k) {
    mean += G[k] / count;
    result.release += release[k] / count;
  }
  const auto [least, most] = std::minmax_element(release.begin(), release.end());
  result.ring_spread = (*most - *least) / std::abs(result.release);

  // The interaction integral is exact in the limit of a small ring: a line through two rings.
  const double E = problem_.material.youngs_modulus;
  const double nu = problem_.material.poissons_ratio;
  const double plane_strain = E / (1 - nu * nu);
  const std::array<double, 3> factor{plane_strain / 2, plane_strain / 2, lame_.mu};
  std::array<Eigen::VectorXd, 3> K;
  for (std::size_t mode = 0; mode < 3; ++mode) {
    const Eigen::VectorXd near = pointwise(mode + 1, 1);
    const Eigen::VectorXd far = pointwise(mode + 1, 2);
    K[mode] = factor[mode] * (near - (far - near) * (radius[1] / (radius[2] - radius[1])));
  }
  double of_K = 0;
  double of_G = 0;
  double closed_K_I = 0;
  const double scale = std::abs(mean.sum() / static_cast<double>(nodes));
  const Eigen::VectorXd area = mass.rowwise().sum();
  for (const auto& [segment, tip] : tips)
    for (std::size_t j = segment == 0 ? 0 : 1; j < 3; ++j) {
      const auto i = static_cast<Eigen::Index>(2 * segment + j);
      FrontStation station;
      station.position = (static_cast<double>(segment) + 0.5 * static_cast<double>(j)) /
                         static_cast<double>(tips.size());
      station.place = to_array(front_frame(*tip, 0.5 * static_cast<double>(j)).place);
      station.energy_release_rate = mean(i);
      for (const Eigen::VectorXd& ring : G)
        station.ring_spread = std::max(station.ring_spread, std::abs(ring(i) - mean(i)) / scale);
      if (problem_.crack_faces == CrackFaces::contact &&
          (touching[static_cast<std::size_t>(i)] || K[0](i) < 0)) {
        closed_K_I = std::max(closed_K_I, std::abs(K[0](i)));
        station.closed = true;
        K[0](i) = 0;
      }
      station.G_of_K = (K[0](i) * K[0](i) + K[1](i) * K[1](i)) / plane_strain +
                       K[2](i) * K[2](i) / (2 * lame_.mu);  // (FE-25)
      const double rescale = station.energy_release_rate > 0 && station.G_of_K > 0
                                 ? std::sqrt(station.energy_release_rate / station.G_of_K)
                                 : 1.0;
      station.K_I = rescale * K[0](i);
      station.K_II = rescale * K[1](i);
      station.K_III = rescale * K[2](i);
      of_K += station.G_of_K * area(i);
      of_G += station.energy_release_rate * area(i);
      result.stations.push_back(station);
    }
  result.mode_energy_ratio = of_K / of_G;
  result.closed_K_I = closed_K_I;
  return result;
}

// --- sampled fields

/// Points i/n of each unit coordinate, the first one fastest.
template <int dim>
dealii::Quadrature<dim> sample_points(int n) {
  std::vector<Point<dim>> points;
  const auto count = static_cast<unsigned>(std::lround(std::pow(n + 1, dim)));
  for (unsigned k = 0; k < count; ++k) {
    Point<dim> point;
    unsigned rest = k;
    for (unsigned d = 0; d < dim; ++d, rest /= static_cast<unsigned>(n) + 1)
      point[d] = static_cast<double>(rest % (static_cast<unsigned>(n) + 1)) / n;
    points.push_back(point);
  }
  return dealii::Quadrature<dim>(points);
}

/// sigma:epsilon/2 of a stress [J/m^3].
double energy_of_stress(const Tensor2& s, const Elasticity& m) {
  const double nu = m.poissons_ratio;
  const double pressure = trace(s);
  return ((1 + nu) * scalar_product(s, s) - nu * pressure * pressure) /
         (2 * m.youngs_modulus);  // (FE-38)
}

SampledFields Model::sample() const {
  const FieldRequest& request = problem_.fields;
  SampledFields fields{.dimension = 3,
                       .divisions = request.divisions,
                       .without_crack = static_cast<bool>(problem_.stress_without_crack),
                       .cells = {},
                       .crack_faces = {}};
  const dealii::Quadrature<3> points = sample_points<3>(request.divisions);
  // At a front with a singular map the gradient is infinite: it is taken next to it.
  std::vector<Point<3>> inner = points.get_points();
  for (Point<3>& point : inner)
    if (point[0] == 0 && point[1] == 0)
      point[0] = point[1] = 0.25 / static_cast<double>(request.divisions);
  dealii::FEValues<3> values(body_.mapping, scalar_, points,
                             dealii::update_values | dealii::update_quadrature_points);
  dealii::FEValues<3> slopes(body_.mapping, scalar_, points, dealii::update_gradients);
  dealii::FEValues<3> inner_slopes(body_.mapping, scalar_, dealii::Quadrature<3>(inner),
                                   dealii::update_gradients);
  std::vector<Tensor2> gradient;
  for (const Cell& cell : dofs_.active_cell_iterators()) {
    if (!request.every_cell && !cell->is_locally_owned()) continue;
    reinit(values, cell);
    gradients(cell, reinit(is_singular(source(cell)) ? inner_slopes : slopes, cell), gradient);
    FieldCell& sampled = fields.cells.emplace_back();
    sampled.face_tag = source(cell).face_tag;
    sampled.cell = static_cast<std::size_t>(cell->index());
    for (unsigned q = 0; q < points.size(); ++q) {
      FieldPoint p{.place = to_array(values.quadrature_point(q))};
      for (unsigned a = 0; a < scalar_.n_dofs_per_cell(); ++a)
        for (unsigned i = 0; i < 3; ++i)
          p.displacement[i] += local_[node_of_[i][a]] * values.shape_value(a, q);
      const Tensor2 s = lame_.stress(gradient[q]);
      p.stress = {s[0][0], s[1][1], s[2][2], s[1][2], s[0][2], s[0][1]};
      p.energy_density = energy_of_stress(s, problem_.material);
      if (fields.without_crack) {
        const auto sound = problem_.stress_without_crack(p.place);
        Tensor2 s0;
        for (unsigned i = 0; i < 3; ++i) s0[i] = to_tensor(sound[i]);
        p.energy_density_without_crack = energy_of_stress(s0, problem_.material);
      }
      sampled.points.push_back(p);
    }
  }
  sample_crack_faces(fields);
  return fields;
}

void Model::sample_crack_faces(SampledFields& fields) const {
  struct Face {
    Cell cell;
    unsigned number;
    Point<3> middle;
  };
  std::vector<Face> upper;
  std::vector<Face> lower;
  for (const Cell& cell : dofs_.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (!is_crack_face(cell, f)) continue;
      Point3 unit{0.5, 0.5, 0.5};
      unit[f / 2] = f % 2;
      (source(cell).side > 0 ? upper : lower)
          .push_back({cell, f, to_point(source(cell).map(unit))});
    }
  const dealii::Quadrature<2> points = sample_points<2>(fields.divisions);
  // There is no normal at a front with a singular map: it is taken next to it.
  std::vector<Point<2>> inner = points.get_points();
  for (Point<2>& point : inner) point += 1e-6 * (Point<2>(0.5, 0.5) - point);
  dealii::FEFaceValues<3> values(body_.mapping, scalar_, points,
                                 dealii::update_values | dealii::update_quadrature_points);
  dealii::FEFaceValues<3> normals(body_.mapping, scalar_, dealii::Quadrature<2>(inner),
                                  dealii::update_normal_vectors);
  const auto displacements = [&](const Face& face) {
    values.reinit(typename dealii::Triangulation<3>::active_cell_iterator(face.cell), face.number);
    cell_values(face.cell);
    std::vector<Tensor<1, 3>> u(points.size());
    for (unsigned q = 0; q < points.size(); ++q)
      for (unsigned a = 0; a < scalar_.n_dofs_per_cell(); ++a)
        for (unsigned i = 0; i < 3; ++i)
          u[q][i] += local_[node_of_[i][a]] * values.shape_value(a, q);
    return u;
  };
  for (const Face& face : upper) {
    if (!problem_.fields.every_cell && !face.cell->is_locally_owned()) continue;
    const double near = 1e-6 * face.cell->diameter();
    const auto twin = std::find_if(lower.begin(), lower.end(), [&](const Face& other) {
      return other.middle.distance(face.middle) < near;
    });
    if (twin == lower.end()) throw InputError("mesh", "has a crack face without its other side");
    const std::vector<Tensor<1, 3>> below = displacements(*twin);
    const std::vector<Point<3>> place_below = values.get_quadrature_points();
    const std::vector<Tensor<1, 3>> above = displacements(face);
    normals.reinit(typename dealii::Triangulation<3>::active_cell_iterator(face.cell), face.number);
    CrackFacePatch& patch = fields.crack_faces.emplace_back();
    for (unsigned q = 0; q < points.size(); ++q) {
      const Point<3>& place = values.quadrature_point(q);
      // The other face may count its points in another direction.
      const auto same = std::min_element(place_below.begin(), place_below.end(),
                                         [&](const Point<3>& a, const Point<3>& b) {
                                           return a.distance(place) < b.distance(place);
                                         });
      const Tensor<1, 3>& u = below[static_cast<std::size_t>(same - place_below.begin())];
      patch.points.push_back({.place = to_array(place),
                              .upper = {above[q][0], above[q][1], above[q][2]},
                              .lower = {u[0], u[1], u[2]},
                              .opening = (u - above[q]) * normals.normal_vector(q)});  // (FE-39)
    }
  }
}

}  // namespace

SolidResult solve_solid(const HexMesh& mesh, const SolidProblem& problem) {
  const Elasticity& m = problem.material;
  require(m.youngs_modulus > 0 && std::isfinite(m.youngs_modulus), "youngs_modulus",
          m.youngs_modulus, "Pa", "youngs_modulus > 0");
  require(m.poissons_ratio >= 0 && m.poissons_ratio < 0.5, "poissons_ratio", m.poissons_ratio, "1",
          "0 <= poissons_ratio < 0.5");
  require(problem.order >= 1 && problem.order <= 6, "order", problem.order, "1", "1 <= order <= 6");
  require(problem.fields.divisions >= 0 && problem.fields.divisions <= 8, "divisions",
          problem.fields.divisions, "1", "0 <= divisions <= 8");
  if (mesh.cells.empty()) throw InputError("mesh", "has no cells");
  return Model(mesh, problem).run();
}

double check_jacobians(const HexMesh& mesh) { return worst_jacobian(mesh, Body(mesh, 1)); }

}  // namespace strainwave::fem
