// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/harmonic_section.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "condensed_solver.hpp"
#include "direct_solver.hpp"
#include "section/grid.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave::fem {
namespace {

using dealii::Triangulation;
using dealii::types::global_dof_index;
using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;
using Strain = Eigen::Matrix<double, 6, 1>;
using Stiffness = Eigen::Matrix<double, 6, 6>;

constexpr unsigned kComponents = 3;

/// Elasticity in the order of WaveStress.
Stiffness stiffness_of(const Elasticity& elasticity) {
  const double mu = elasticity.shear_modulus();
  const double lambda = 2 * mu * elasticity.poissons_ratio / (1 - 2 * elasticity.poissons_ratio);
  Stiffness C = Stiffness::Zero();
  C.topLeftCorner<3, 3>().setConstant(lambda);
  C.diagonal() << lambda + 2 * mu, lambda + 2 * mu, lambda + 2 * mu, mu, mu, mu;
  return C;
}

/// Columns of strain per unit of the three components of one function, in the order of WaveStress;
/// (FE-51).
/// @param n  number of waves; any real number
Eigen::Matrix<double, 6, 3> strains(double value, double by_r, double by_z, double r, double n) {
  const double hoop = value / r;
  Eigen::Matrix<double, 6, 3> b = Eigen::Matrix<double, 6, 3>::Zero();
  b(0, 0) = by_r;
  b(1, 0) = hoop;
  b(1, 1) = n * hoop;
  b(2, 2) = by_z;
  b(3, 1) = by_z;
  b(3, 2) = -n * hoop;
  b(4, 0) = by_z;
  b(4, 2) = by_r;
  b(5, 0) = -n * hoop;
  b(5, 1) = by_r - hoop;
  return b;
}

using Gradient = Eigen::Matrix3d;

/// Second Piola-Kirchhoff stress of a displacement gradient.
Gradient material_stress(const Gradient& H, const Stiffness& elasticity) {
  const Gradient E = (H + H.transpose() + H.transpose() * H) / 2;  // (FE-53)
  const double mu = elasticity(3, 3);
  return elasticity(0, 1) * E.trace() * Gradient::Identity() + 2 * mu * E;
}

/// Stress of the linear theory.
Gradient linear_stress(const Gradient& H, const Stiffness& elasticity) {
  return elasticity(0, 1) * H.trace() * Gradient::Identity() +
         elasticity(3, 3) * (H + H.transpose());
}

/// The integral of the square of a wave over the turn.
double round_turn(int waves) { return (waves == 0 ? 2 : 1) * std::numbers::pi; }

/// Stiffness of a cell over the integral of the wave's square: A + n B + n^2 C.
struct WaveStiffness {
  Matrix A, B, C;

  [[nodiscard]] Matrix at(int n) const { return A + n * B + n * n * C; }
};

/// Functions of one component at the quadrature points of a cell: rows are points.
struct HarmonicCell {
  Matrix N, Nr, Nz;  ///< value, and derivatives by r and z
  Column r;          ///< [m]
  Column weight;     ///< r times the area of a point [m^3/rad]
};

}  // namespace

struct HarmonicSection::Parts {
  Triangulation<2> grid;
  dealii::MappingQ<2> mapping;
  dealii::FE_Q<2> scalar;
  dealii::FESystem<2> element;
  dealii::DoFHandler<2> dofs;
  dealii::AffineConstraints<double> constraints;
  Stiffness elasticity;
  bool held;
  std::vector<WaveStiffness> cells;
  std::vector<HarmonicCell> shapes;
  std::vector<std::vector<global_dof_index>> unknowns;  ///< of each cell

  Parts(const SectionMesh& mesh, const Elasticity& steel, const HarmonicOptions& options)
      : mapping(static_cast<unsigned>(options.order)),
        scalar(static_cast<unsigned>(options.order)),
        element(dealii::FE_Q<2>(static_cast<unsigned>(options.order)), kComponents),
        dofs(grid),
        elasticity(stiffness_of(steel)),
        held(std::ranges::find(mesh.roles, EdgeRole::held, &RoleEdge::role) != mesh.roles.end()) {
    section::make_grid(grid, mesh, {.corner_rings = options.corner_rings});
    dofs.distribute_dofs(element);
    hold();
    for (const auto& cell : dofs.active_cell_iterators()) {
      unknowns.emplace_back(element.n_dofs_per_cell());
      cell->get_dof_indices(unknowns.back());
    }
    assemble();
  }

  void hold() {
    std::vector<global_dof_index> index(element.n_dofs_per_face());
    for (const auto& cell : dofs.active_cell_iterators())
      for (const unsigned f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != section::kHeld)
          continue;
        cell->face(f)->get_dof_indices(index);
        for (const global_dof_index i : index) constraints.add_line(i);
      }
    dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
    constraints.close();
  }

  /// Places `part` of one function and component in the order of the cell's unknowns.
  [[nodiscard]] unsigned own(unsigned function, unsigned component) const {
    return element.component_to_system_index(component, function);
  }

  void assemble() {
    const dealii::QGauss<2> rule(scalar.degree + 2);
    dealii::FEValues<2> values(mapping, scalar, rule,
                               dealii::update_values | dealii::update_gradients |
                                   dealii::update_quadrature_points | dealii::update_JxW_values);
    const unsigned functions = scalar.n_dofs_per_cell();
    const Eigen::LLT<Stiffness> root(elasticity);
    const Stiffness upper = root.matrixU();
    for (const auto& cell : dofs.active_cell_iterators()) {
      values.reinit(static_cast<Triangulation<2>::active_cell_iterator>(cell));
      const auto points = static_cast<Eigen::Index>(rule.size());
      HarmonicCell& shape = shapes.emplace_back();
      shape = {.N = Matrix(points, functions),
               .Nr = Matrix(points, functions),
               .Nz = Matrix(points, functions),
               .r = Column(points),
               .weight = Column(points)};
      for (unsigned q = 0; q < rule.size(); ++q) {
        shape.r(q) = values.quadrature_point(q)[0];
        shape.weight(q) = values.JxW(q) * shape.r(q);
        if (!(values.JxW(q) > 0))
          throw InputError(
              "mesh", fmt::format("a cell at r = {:.6g} mm is folded", shape.r(q) / units::mm));
        for (unsigned a = 0; a < functions; ++a) {
          shape.N(q, a) = values.shape_value(a, q);
          shape.Nr(q, a) = values.shape_grad(a, q)[0];
          shape.Nz(q, a) = values.shape_grad(a, q)[1];
        }
      }
      const auto square = [&](double n) -> Matrix {
        Matrix b(Eigen::Index{kComponents} * functions, 6 * points);
        for (unsigned q = 0; q < rule.size(); ++q)
          for (unsigned a = 0; a < functions; ++a) {
            const Eigen::Matrix<double, 6, 3> column =
                std::sqrt(shape.weight(q)) * upper *
                strains(shape.N(q, a), shape.Nr(q, a), shape.Nz(q, a), shape.r(q), n);
            for (unsigned c = 0; c < kComponents; ++c)
              b.block<1, 6>(own(a, c), 6 * Eigen::Index{q}) = column.col(c).transpose();
          }
        return Matrix(lower_square(b)).selfadjointView<Eigen::Lower>();
      };
      const Matrix none = square(0);
      const Matrix plus = square(1);
      const Matrix minus = square(-1);
      cells.push_back({.A = none, .B = (plus - minus) / 2, .C = (plus + minus) / 2 - none});
    }
  }

  /// The free unknowns on which those of a cell depend.
  struct Free {
    struct Share {
      Eigen::Index own;     ///< unknown of the cell
      Eigen::Index column;  ///< index in `number`
      double factor;
    };
    std::vector<Eigen::Index> number;
    std::vector<Share> shares;  ///< empty if the cell's unknowns are free themselves

    /// Converts columns of the cell's unknowns to columns of the free unknowns.
    [[nodiscard]] Matrix gathered(const Matrix& columns) const {
      Matrix result = Matrix::Zero(columns.rows(), static_cast<Eigen::Index>(number.size()));
      for (const Share& s : shares) result.col(s.column) += s.factor * columns.col(s.own);
      return result;
    }
  };
  [[nodiscard]] Free free_unknowns(std::size_t c) const {
    Free free;
    if (std::ranges::none_of(unknowns[c], [&](auto i) { return constraints.is_constrained(i); })) {
      free.number.assign(unknowns[c].begin(), unknowns[c].end());
      return free;
    }
    const auto add = [&](std::size_t own, global_dof_index dof, double factor) {
      const auto number = static_cast<Eigen::Index>(dof);
      const auto at = std::ranges::find(free.number, number);
      free.shares.push_back({static_cast<Eigen::Index>(own), at - free.number.begin(), factor});
      if (at == free.number.end()) free.number.push_back(number);
    };
    for (std::size_t i = 0; i < unknowns[c].size(); ++i)
      if (!constraints.is_constrained(unknowns[c][i]))
        add(i, unknowns[c][i], 1.0);
      else
        for (const auto& [other, factor] : *constraints.get_constraint_entries(unknowns[c][i]))
          add(i, other, factor);
    return free;
  }

  /// Nodal forces of tractions over the integral of the wave's square, in columns.
  [[nodiscard]] Matrix nodal_loads(std::span<const EdgeTraction> loads) const {
    Matrix forces = Matrix::Zero(dofs.n_dofs(), static_cast<Eigen::Index>(loads.size()));
    dealii::FEFaceValues<2> values(mapping, scalar, dealii::QGauss<1>(scalar.degree + 2),
                                   dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_JxW_values | dealii::update_normal_vectors);
    std::size_t c = 0;
    for (const auto& cell : dofs.active_cell_iterators()) {
      const std::vector<global_dof_index>& index = unknowns[c++];
      for (const unsigned f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary()) continue;
        values.reinit(static_cast<Triangulation<2>::active_cell_iterator>(cell), f);
        for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
          const SectionPoint place{values.quadrature_point(q)[0], values.quadrature_point(q)[1]};
          const SectionPoint out{values.normal_vector(q)[0], values.normal_vector(q)[1]};
          for (std::size_t n = 0; n < loads.size(); ++n) {
            const WaveVector t = loads[n](place, out);
            if (t == WaveVector{}) continue;
            for (unsigned a = 0; a < scalar.n_dofs_per_cell(); ++a)
              for (unsigned k = 0; k < kComponents; ++k)
                forces(static_cast<Eigen::Index>(index[own(a, k)]), static_cast<Eigen::Index>(n)) +=
                    place.r * values.JxW(q) * t[k] * values.shape_value(a, q);
          }
        }
      }
    }
    return forces;
  }

  /// Expresses nodal forces by the free unknowns.
  [[nodiscard]] Column condensed(const Column& forces) const {
    dealii::Vector<double> all(forces.begin(), forces.end());
    constraints.condense(all);
    constraints.set_zero(all);
    return Eigen::Map<const Column>(all.begin(), static_cast<Eigen::Index>(all.size()));
  }
};

HarmonicSection::HarmonicSection(const SectionMesh& mesh, const Elasticity& elasticity,
                                 const HarmonicOptions& options) {
  require(elasticity.youngs_modulus > 0 && std::isfinite(elasticity.youngs_modulus),
          "youngs_modulus", elasticity.youngs_modulus, "Pa", "> 0");
  require(elasticity.poissons_ratio > -1 && elasticity.poissons_ratio < 0.5, "poissons_ratio",
          elasticity.poissons_ratio, "1", "> -1 and < 0.5");
  require(options.order >= 2 && options.order <= 8, "order", options.order, "1", ">= 2 and <= 8");
  require(options.corner_rings >= 0 && options.corner_rings <= 16, "corner_rings",
          options.corner_rings, "1", ">= 0 and <= 16");
  check_mesh(mesh);
  if (mesh.crack) throw InputError("mesh.crack", "must be left out of a body with waves");
  for (const SectionPoint& point : mesh.points)
    require(point.r > 0, "mesh.points.r", point.r, "m", "> 0 in a body with waves");
  parts_ = std::make_unique<Parts>(mesh, elasticity, options);
}

HarmonicSection::~HarmonicSection() = default;
HarmonicSection::HarmonicSection(HarmonicSection&&) noexcept = default;
HarmonicSection& HarmonicSection::operator=(HarmonicSection&&) noexcept = default;

std::size_t HarmonicSection::unknowns() const { return parts_->dofs.n_dofs(); }

struct HarmonicEquations::Parts {
  const HarmonicSection::Parts& section;
  int waves;
  CondensedEquations equations;

  /// Solves under nodal forces over the integral of the wave's square, in columns.
  [[nodiscard]] std::vector<HarmonicSolution> solve(const Matrix& raw) const;
};

HarmonicEquations HarmonicSection::equations(int waves) const {
  const Parts& parts = *parts_;
  require(waves >= 0, "waves", waves, "1", ">= 0");
  if (waves < 2 && !parts.held)
    throw InputError("mesh.roles",
                     "no edge is held, so a body under fewer than two waves can move");
  std::vector<Parts::Free> free;
  std::vector<std::vector<Eigen::Index>> elements;
  for (std::size_t c = 0; c < parts.cells.size(); ++c) {
    free.push_back(parts.free_unknowns(c));
    elements.push_back(free.back().number);
  }
  const auto matrix = [&](std::size_t c) -> Matrix {
    Matrix k = parts.cells[c].at(waves);
    if (free[c].shares.empty()) return k;
    return free[c].gathered(free[c].gathered(k).transpose());
  };
  auto factored =
      CondensedEquations::factor(elements, matrix, static_cast<Eigen::Index>(parts.dofs.n_dofs()));
  if (!factored)
    throw SolverError(
        fmt::format("finite elements: the equations of {} unknowns for {} waves could not be "
                    "factored; check that an edge of the section is held",
                    parts.dofs.n_dofs(), waves));
  return HarmonicEquations(std::make_unique<HarmonicEquations::Parts>(
      HarmonicEquations::Parts{parts, waves, std::move(*factored)}));
}

HarmonicEquations::HarmonicEquations(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
HarmonicEquations::~HarmonicEquations() = default;
HarmonicEquations::HarmonicEquations(HarmonicEquations&&) noexcept = default;
HarmonicEquations& HarmonicEquations::operator=(HarmonicEquations&&) noexcept = default;

std::vector<HarmonicSolution> HarmonicEquations::solve(std::span<const EdgeTraction> loads) const {
  if (loads.empty()) throw InputError("loads", "must have at least one load");
  return parts_->solve(parts_->section.nodal_loads(loads));
}

HarmonicSolution HarmonicEquations::solve(const EdgeTraction& load,
                                          const std::vector<double>& forces) const {
  Matrix raw = parts_->section.nodal_loads(std::span(&load, 1));
  if (forces.size() != static_cast<std::size_t>(raw.rows()))
    throw InputError("forces", "must have a number for each unknown");
  raw += Eigen::Map<const Column>(forces.data(), raw.rows());
  return std::move(parts_->solve(raw).front());
}

std::vector<HarmonicSolution> HarmonicEquations::Parts::solve(const Matrix& raw) const {
  Matrix forces(raw.rows(), raw.cols());
  for (Eigen::Index n = 0; n < raw.cols(); ++n) forces.col(n) = section.condensed(raw.col(n));
  const Matrix found = equations.solve(forces);
  const double turn = round_turn(waves);
  std::vector<HarmonicSolution> solutions;
  for (Eigen::Index n = 0; n < raw.cols(); ++n) {
    dealii::Vector<double> u(found.col(n).begin(), found.col(n).end());
    section.constraints.distribute(u);
    HarmonicSolution& solution = solutions.emplace_back();
    solution.waves = waves;
    solution.displacement.assign(u.begin(), u.end());
    const Eigen::Map<const Column> all(u.begin(), static_cast<Eigen::Index>(u.size()));
    Column inner = Column::Zero(all.size());
    for (std::size_t c = 0; c < section.cells.size(); ++c) {
      const Column local = all(section.unknowns[c]);
      const Column force = section.cells[c].at(waves) * local;
      solution.energy += 0.5 * turn * local.dot(force);
      inner(section.unknowns[c]) += force;
    }
    for (Eigen::Index load = 0; load < raw.cols(); ++load)
      solution.work_of_loads.push_back(turn * raw.col(load).dot(all));
    const double largest = forces.col(n).lpNorm<Eigen::Infinity>();
    solution.equilibrium_residual =
        section.condensed(inner - raw.col(n)).lpNorm<Eigen::Infinity>() / largest;
  }
  return solutions;
}

std::vector<std::vector<double>> HarmonicSection::large_rotation_forces(
    std::span<const HarmonicSolution> waves) const {
  const Parts& parts = *parts_;
  for (std::size_t k = 0; k < waves.size(); ++k)
    if (waves[k].waves != static_cast<int>(2 * k))
      throw InputError("waves", "must be solutions of 0, 2, 4, ... waves");
  const auto count = static_cast<int>(waves.size());
  // Products of three waves have up to three times as many; the quarter turn has enough angles to
  // tell them from the waves that are kept.
  const int intervals = 2 * count + 1;
  std::vector<Column> forces(waves.size(), Column::Zero(static_cast<Eigen::Index>(unknowns())));
  const unsigned functions = parts.scalar.n_dofs_per_cell();
  for (std::size_t c = 0; c < parts.cells.size(); ++c) {
    const HarmonicCell& shape = parts.shapes[c];
    const Eigen::Index points = shape.r.size();
    // Amplitudes at the points: columns u_r, u_theta, u_z.
    std::vector<Matrix> value;
    std::vector<Matrix> by_r;
    std::vector<Matrix> by_z;
    for (const HarmonicSolution& wave : waves) {
      Matrix u(functions, 3);
      for (unsigned a = 0; a < functions; ++a)
        for (unsigned k = 0; k < kComponents; ++k)
          u(a, k) = wave.displacement[parts.unknowns[c][parts.own(a, k)]];
      value.push_back(shape.N * u);
      by_r.push_back(shape.Nr * u);
      by_z.push_back(shape.Nz * u);
    }
    // Integrals of the stresses with each wave: on value, by_r and by_z of each component.
    std::vector<std::array<Matrix, 3>> on(
        waves.size(), {Matrix::Zero(points, 3), Matrix::Zero(points, 3), Matrix::Zero(points, 3)});
    for (int j = 0; j <= intervals; ++j) {
      const double angle = std::numbers::pi / 2 * j / intervals;
      const double span = (j == 0 || j == intervals ? 0.5 : 1.0) * 2 * std::numbers::pi / intervals;
      for (Eigen::Index q = 0; q < points; ++q) {
        Gradient H = Gradient::Zero();
        for (int k = 0; k < count; ++k) {
          const auto at = static_cast<std::size_t>(k);
          const double cosine = std::cos(2 * k * angle);
          const double sine = k == 0 ? 0.0 : std::sin(2 * k * angle);
          const double n = 2 * k;
          const double hoop = 1 / shape.r(q);
          H(0, 0) += cosine * by_r[at](q, 0);
          H(0, 1) += sine * (-n * value[at](q, 0) - value[at](q, 1)) * hoop;
          H(0, 2) += cosine * by_z[at](q, 0);
          H(1, 0) += sine * by_r[at](q, 1);
          H(1, 1) += cosine * (n * value[at](q, 1) + value[at](q, 0)) * hoop;
          H(1, 2) += sine * by_z[at](q, 1);
          H(2, 0) += cosine * by_r[at](q, 2);
          H(2, 1) += sine * -n * value[at](q, 2) * hoop;
          H(2, 2) += cosine * by_z[at](q, 2);
        }
        const Gradient S = material_stress(H, parts.elasticity);
        const Gradient linear = linear_stress(H, parts.elasticity);
        // What the linear equations have too much: sigma - (I + H) S.
        const Gradient P = linear - S - H * S;
        for (int k = 0; k < count; ++k) {
          const auto at = static_cast<std::size_t>(k);
          const double scale = span * shape.weight(q) / round_turn(2 * k);
          const double cosine = scale * std::cos(2 * k * angle);
          const double sine = k == 0 ? 0.0 : scale * std::sin(2 * k * angle);
          const double n = 2 * k;
          const double hoop = 1 / shape.r(q);
          std::array<Matrix, 3>& to = on[at];
          to[1](q, 0) += cosine * P(0, 0);
          to[1](q, 1) += sine * P(1, 0);
          to[1](q, 2) += cosine * P(2, 0);
          to[2](q, 0) += cosine * P(0, 2);
          to[2](q, 1) += sine * P(1, 2);
          to[2](q, 2) += cosine * P(2, 2);
          to[0](q, 0) += hoop * (cosine * P(1, 1) - n * sine * P(0, 1));
          to[0](q, 1) += hoop * (n * cosine * P(1, 1) - sine * P(0, 1));
          to[0](q, 2) += hoop * -n * sine * P(2, 1);
        }
      }
    }
    for (std::size_t k = 0; k < waves.size(); ++k) {
      const Matrix nodal = shape.N.transpose() * on[k][0] + shape.Nr.transpose() * on[k][1] +
                           shape.Nz.transpose() * on[k][2];
      for (unsigned a = 0; a < functions; ++a)
        for (unsigned component = 0; component < kComponents; ++component)
          forces[k](static_cast<Eigen::Index>(parts.unknowns[c][parts.own(a, component)])) +=
              nodal(a, component);
    }
  }
  std::vector<std::vector<double>> result;
  for (const Column& f : forces) result.emplace_back(f.begin(), f.end());
  return result;
}

WaveStress HarmonicSection::large_rotation_stress(const CylinderGradient& gradient) const {
  Gradient H;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      H(i, k) = gradient[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  const Gradient S = material_stress(H, parts_->elasticity);
  return {S(0, 0), S(1, 1), S(2, 2), S(1, 2), S(0, 2), S(0, 1)};
}

void add_gradient(CylinderGradient& to, const HarmonicPoint& point, int waves, double r,
                  double angle) {
  const double cosine = std::cos(waves * angle);
  const double sine = waves == 0 ? 1.0 : std::sin(waves * angle);
  const auto& [u, v, w] = point.displacement;
  const double n = waves;
  to[0][0] += cosine * point.by_r[0];
  to[0][1] += sine * (-n * u - v) / r;
  to[0][2] += cosine * point.by_z[0];
  to[1][0] += sine * point.by_r[1];
  to[1][1] += cosine * (n * v + u) / r;
  to[1][2] += sine * point.by_z[1];
  to[2][0] += cosine * point.by_r[2];
  to[2][1] += sine * -n * w / r;
  to[2][2] += cosine * point.by_z[2];
}

std::vector<SectionPlace> HarmonicSection::locate(std::span<const SectionPoint> points,
                                                  double beyond) const {
  const Parts& parts = *parts_;
  struct Box {
    Triangulation<2>::active_cell_iterator cell;
    std::size_t number;
    dealii::BoundingBox<2> bounds;
  };
  std::vector<Box> boxes;
  for (const auto& cell : parts.dofs.active_cell_iterators())
    boxes.push_back({cell, boxes.size(), parts.mapping.get_bounding_box(cell)});
  std::vector<SectionPlace> places;
  for (const SectionPoint& point : points) {
    const dealii::Point<2> at(point.r, point.z);
    std::optional<dealii::Point<2>> unit;
    std::size_t number = 0;
    double off = beyond;
    for (const Box& box : boxes) {
      if (!box.bounds.point_inside(at, std::max(1e-6, 2 * beyond))) continue;
      try {
        const dealii::Point<2> in_cell = parts.mapping.transform_real_to_unit_cell(box.cell, at);
        double outside = 0;
        for (unsigned k = 0; k < 2; ++k) outside = std::max({outside, -in_cell[k], in_cell[k] - 1});
        if (outside > off) continue;
        off = outside;
        unit = in_cell;
        number = box.number;
        if (outside <= 0) break;
      } catch (const dealii::Mapping<2>::ExcTransformationFailed&) {
        continue;  // far outside of a curved cell
      }
    }
    if (!unit)
      throw InputError("points", fmt::format("the point r = {:.6g} mm, z = {:.6g} mm is outside of "
                                             "the section",
                                             point.r / units::mm, point.z / units::mm));
    dealii::FEValues<2> values(parts.mapping, parts.scalar, dealii::Quadrature<2>(*unit),
                               dealii::update_values | dealii::update_gradients);
    values.reinit(boxes[number].cell);
    SectionPlace& place = places.emplace_back();
    place.point = point;
    for (unsigned a = 0; a < parts.scalar.n_dofs_per_cell(); ++a) {
      for (unsigned k = 0; k < kComponents; ++k)
        place.unknowns.push_back(parts.unknowns[number][parts.own(a, k)]);
      place.value.push_back(values.shape_value(a, 0));
      place.by_r.push_back(values.shape_grad(a, 0)[0]);
      place.by_z.push_back(values.shape_grad(a, 0)[1]);
    }
  }
  return places;
}

HarmonicPoint HarmonicSection::at(const HarmonicSolution& solution,
                                  const SectionPlace& place) const {
  HarmonicPoint point;
  Strain strain = Strain::Zero();
  for (std::size_t a = 0; a < place.value.size(); ++a) {
    Eigen::Vector3d u;
    for (std::size_t k = 0; k < kComponents; ++k) {
      u(static_cast<Eigen::Index>(k)) = solution.displacement[place.unknowns[kComponents * a + k]];
      point.displacement[k] += place.value[a] * u(static_cast<Eigen::Index>(k));
      point.by_r[k] += place.by_r[a] * u(static_cast<Eigen::Index>(k));
      point.by_z[k] += place.by_z[a] * u(static_cast<Eigen::Index>(k));
    }
    strain +=
        strains(place.value[a], place.by_r[a], place.by_z[a], place.point.r, solution.waves) * u;
  }
  const Strain stress = parts_->elasticity * strain;
  std::ranges::copy(stress, point.stress.begin());
  return point;
}

}  // namespace strainwave::fem
