// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/axisymmetric.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

using dealii::Triangulation;
using dealii::types::global_dof_index;
using std::numbers::pi;
using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;
using Array = Eigen::ArrayXd;

constexpr dealii::types::boundary_id kFree = 0;
constexpr dealii::types::boundary_id kHeld = 1;
constexpr dealii::types::boundary_id kLoaded = 2;
constexpr dealii::types::boundary_id kAxis = 3;

double extent_of(const SectionMesh& mesh) {
  double extent = 0.0;
  for (const SectionPoint& p : mesh.points)
    extent = std::max({extent, p.r, std::abs(p.z - mesh.points.front().z)});
  return extent;
}

void check_input(const SectionMesh& mesh, SectionLoad load, const Elasticity& elasticity,
                 const SectionOptions& options) {
  require(elasticity.youngs_modulus > 0 && std::isfinite(elasticity.youngs_modulus),
          "youngs_modulus", elasticity.youngs_modulus, "Pa", "> 0");
  require(elasticity.poissons_ratio > -1 && elasticity.poissons_ratio < 0.5, "poissons_ratio",
          elasticity.poissons_ratio, "1", "> -1 and < 0.5");
  const int least = load == SectionLoad::torsion ? 1 : 2;
  require(options.order >= least && options.order <= 8, "order", options.order, "1",
          load == SectionLoad::torsion ? ">= 1 and <= 8" : ">= 2 and <= 8");
  require(options.tip_rings >= 4 && options.tip_rings <= 16, "tip_rings", options.tip_rings, "1",
          ">= 4 and <= 16");
  require(options.corner_rings >= 0 && options.corner_rings <= 16, "corner_rings",
          options.corner_rings, "1", ">= 0 and <= 16");
  require(options.halvings >= 0 && options.halvings <= 5, "halvings", options.halvings, "1",
          ">= 0 and <= 5");
  require(options.fields.divisions >= 0 && options.fields.divisions <= 8, "divisions",
          options.fields.divisions, "1", ">= 0 and <= 8");
  check_mesh(mesh);
  for (const EdgeRole role : {EdgeRole::held, EdgeRole::loaded})
    if (std::ranges::find(mesh.roles, role, &RoleEdge::role) == mesh.roles.end())
      throw InputError("mesh.roles",
                       role == EdgeRole::held ? "no edge is held" : "no edge is loaded");
}

/// Halves the cells that touch a point, `rings` times.
void refine_towards(Triangulation<2>& grid, const SectionPoint& point, int rings, double extent) {
  const dealii::Point<2> centre(point.r, point.z);
  for (int n = 0; n < rings; ++n) {
    for (const auto& cell : grid.active_cell_iterators())
      for (const unsigned v : cell->vertex_indices())
        if (cell->vertex(v).distance(centre) < 1e-9 * extent) cell->set_refine_flag();
    grid.execute_coarsening_and_refinement();
  }
}

void make_grid(Triangulation<2>& grid, const SectionMesh& mesh, const SectionOptions& options) {
  std::vector<dealii::Point<2>> points;
  for (const SectionPoint& p : mesh.points) points.emplace_back(p.r, p.z);
  std::vector<dealii::CellData<2>> cells;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    dealii::CellData<2> cell;
    const auto& v = mesh.cells[c];
    cell.vertices = {static_cast<unsigned>(v[0]), static_cast<unsigned>(v[1]),
                     static_cast<unsigned>(v[3]), static_cast<unsigned>(v[2])};
    cell.material_id = static_cast<dealii::types::material_id>(mesh.part[c]);
    cells.push_back(cell);
  }
  // Two cells must see their common edge run the same way, or unknowns of order 3 and more are
  // joined crosswise, without a message.
  dealii::GridTools::consistently_order_cells(cells);
  grid.create_triangulation(points, cells, dealii::SubCellData());

  const double extent = extent_of(mesh);
  std::map<std::pair<unsigned, unsigned>, EdgeRole> roles;
  std::map<std::pair<unsigned, unsigned>, std::size_t> arcs;
  const auto key = [](std::size_t a, std::size_t b) {
    return std::pair(static_cast<unsigned>(std::min(a, b)), static_cast<unsigned>(std::max(a, b)));
  };
  for (const RoleEdge& e : mesh.roles) roles[key(e.first, e.second)] = e.role;
  for (std::size_t n = 0; n < mesh.arcs.size(); ++n)
    arcs[key(mesh.arcs[n].first, mesh.arcs[n].second)] = n;
  for (const auto& cell : grid.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      const auto face = cell->face(f);
      const auto ends = key(face->vertex_index(0), face->vertex_index(1));
      if (face->at_boundary()) {
        const auto role = roles.find(ends);
        if (role != roles.end())
          face->set_boundary_id(role->second == EdgeRole::held ? kHeld : kLoaded);
        else if (std::max(face->vertex(0)[0], face->vertex(1)[0]) < 1e-12 * extent)
          face->set_boundary_id(kAxis);
      }
      const auto arc = arcs.find(ends);
      if (arc != arcs.end())
        face->set_manifold_id(static_cast<dealii::types::manifold_id>(arc->second));
    }
  for (std::size_t n = 0; n < mesh.arcs.size(); ++n)
    grid.set_manifold(static_cast<dealii::types::manifold_id>(n),
                      dealii::SphericalManifold<2>({mesh.arcs[n].centre.r, mesh.arcs[n].centre.z}));
  grid.refine_global(static_cast<unsigned>(options.halvings));
  for (const SectionPoint& corner : mesh.corners)
    refine_towards(grid, corner, options.corner_rings, extent);
  if (mesh.crack) refine_towards(grid, mesh.crack->tip, options.tip_rings, extent);
}

/// Shape functions of one cell at its quadrature points: rows are points, columns functions.
struct CellShape {
  Matrix N, Nr, Nz;  ///< value, d/dr, d/dz
  Array r, z, w;     ///< place [m], and 2 pi det J times weight [m^2]
};

/// What a solution is at the quadrature points of one cell.
struct CellField {
  Array energy;                 ///< integrand of strain energy, over w
  Array explicit_r;             ///< its derivative by r, with the unknowns and their gradients held
  Array pull_r, pull_z;         ///< (d energy/d grad u) . du/dr, its two components
  std::array<Column, 2> force;  ///< of the cell on its nodes, by component
};

class Solver {
 public:
  Solver(const SectionMesh& mesh, SectionLoad load, const Elasticity& elasticity,
         const SectionOptions& options)
      : mesh_(mesh),
        torsion_(load == SectionLoad::torsion),
        pressure_(load == SectionLoad::pressure),
        p_(static_cast<unsigned>(options.order)),
        rings_(options.tip_rings),
        divisions_(options.fields.divisions),
        tip_cell_(mesh.crack ? std::ldexp(mesh.crack->cell, -options.halvings) : 0.0),
        mu_(elasticity.shear_modulus()),
        lambda_(2 * mu_ * elasticity.poissons_ratio / (1 - 2 * elasticity.poissons_ratio)),
        plane_strain_(elasticity.youngs_modulus /
                      (1 - elasticity.poissons_ratio * elasticity.poissons_ratio)),
        components_(torsion_ ? 1 : 2),
        mapping_(p_),
        scalar_(p_),
        element_(dealii::FE_Q<2>(p_), components_),
        // p+2 points make the weak form of torsion exact in cells with straight sides.
        quadrature_(p_ + 2),
        dofs_(grid_) {
    make_grid(grid_, mesh, options);
    dofs_.distribute_dofs(element_);
    outer_ = element_.get_first_quad_index();
    for (unsigned i = 0; i < element_.n_dofs_per_cell(); ++i)
      place_.push_back(element_.system_to_component_index(i));
    number_skeleton_first();
    constrain();
  }

  SectionSolution solve() {
    assemble();
    load_vector();
    dealii::SparseDirectUMFPACK direct;
    dealii::Vector<double> x(n_skeleton_);
    dealii::Vector<double> f = load_;
    try {
      direct.initialize(matrix_);
      direct.vmult(x, f);
    } catch (const dealii::ExceptionBase& error) {
      throw SolverError(
          fmt::format("finite elements: the equations of {} unknowns could not be "
                      "factored; usual cause: nothing holds the section",
                      n_skeleton_));
    }
    solution_.reinit(dofs_.n_dofs());
    for (unsigned i = 0; i < n_skeleton_; ++i) solution_(i) = x(i);
    constraints_.distribute(solution_);
    recover_inner();
    return evaluate();
  }

 private:
  using Cell = dealii::DoFHandler<2>::active_cell_iterator;

  /// Unknowns inside a cell are numbered last, so that the global matrix can do without them.
  void number_skeleton_first() {
    std::vector<char> inner(dofs_.n_dofs(), 0);
    std::vector<global_dof_index> index(element_.n_dofs_per_cell());
    for (const auto& cell : dofs_.active_cell_iterators()) {
      cell->get_dof_indices(index);
      for (unsigned i = outer_; i < index.size(); ++i) inner[index[i]] = 1;
    }
    n_skeleton_ = static_cast<unsigned>(std::ranges::count(inner, 0));
    std::vector<global_dof_index> number(dofs_.n_dofs());
    global_dof_index next_outer = 0;
    global_dof_index next_inner = n_skeleton_;
    for (std::size_t i = 0; i < number.size(); ++i)
      number[i] = inner[i] != 0 ? next_inner++ : next_outer++;
    dofs_.renumber_dofs(number);
  }

  void constrain() {
    std::vector<global_dof_index> index(element_.n_dofs_per_face());
    for (const auto& cell : dofs_.active_cell_iterators())
      for (const unsigned f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary()) continue;
        const auto id = cell->face(f)->boundary_id();
        // Held: no twist, or no axial displacement.  On the axis: no radial displacement.
        if (id != kHeld && !(id == kAxis && !torsion_)) continue;
        const unsigned component = id == kHeld && !torsion_ ? 1 : 0;
        cell->face(f)->get_dof_indices(index);
        for (unsigned i = 0; i < index.size(); ++i)
          if (element_.face_system_to_component_index(i).first == component)
            constraints_.add_line(index[i]);
      }
    dealii::DoFTools::make_hanging_node_constraints(dofs_, constraints_);
    constraints_.close();
  }

  /// Shape functions and weights of a cell; refuses a cell whose mapping folds.
  CellShape shape(dealii::FEValues<2>& values, const Cell& cell) {
    values.reinit(static_cast<Triangulation<2>::active_cell_iterator>(cell));
    const unsigned points = values.n_quadrature_points;
    const unsigned functions = scalar_.n_dofs_per_cell();
    CellShape s{.N = Matrix(points, functions),
                .Nr = Matrix(points, functions),
                .Nz = Matrix(points, functions),
                .r = Array(points),
                .z = Array(points),
                .w = Array(points)};
    double least = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (unsigned q = 0; q < points; ++q) {
      const double det = values.JxW(q) / quadrature_.weight(q);
      least = std::min(least, det);
      sum += det;
      s.r(q) = values.quadrature_point(q)[0];
      s.z(q) = values.quadrature_point(q)[1];
      s.w(q) = 2 * pi * values.JxW(q);
      for (unsigned i = 0; i < functions; ++i) {
        s.N(q, i) = values.shape_value(i, q);
        const auto gradient = values.shape_grad(i, q);
        s.Nr(q, i) = gradient[0];
        s.Nz(q, i) = gradient[1];
      }
    }
    const double worst = least * points / sum;
    if (!(least > 0))
      throw InputError("mesh",
                       fmt::format("the cell at r = {:.6g} m, z = {:.6g} m is folded: its Jacobian "
                                   "falls to {:.3g} of its mean, and must be > 0",
                                   cell->center()[0], cell->center()[1], worst));
    worst_jacobian_ = std::min(worst_jacobian_, worst);
    return s;
  }

  /// Stiffness of a cell, in the order of its unknowns.
  [[nodiscard]] Matrix stiffness(const CellShape& s) const {
    const auto form = [&](const Matrix& a, const Matrix& b, const Array& weight) -> Matrix {
      return a.transpose() * weight.matrix().asDiagonal() * b;
    };
    if (torsion_) {
      const Array weight = mu_ * s.r.cube() * s.w;  // (FE-1)
      return form(s.Nr, s.Nr, weight) + form(s.Nz, s.Nz, weight);
    }
    const Array weight = s.r * s.w;
    const Matrix hoop = s.r.inverse().matrix().asDiagonal() * s.N;
    const double direct = lambda_ + 2 * mu_;
    const Matrix rr = form(s.Nr, s.Nr, weight);
    const Matrix zz = form(s.Nz, s.Nz, weight);
    const Matrix rz = form(s.Nr, s.Nz, weight);
    const Matrix rh = form(s.Nr, hoop, weight);
    const Matrix hh = form(hoop, hoop, weight);
    const Matrix hz = form(hoop, s.Nz, weight);
    const Matrix radial =  // (FE-2)
        direct * (rr + hh) + lambda_ * (rh + rh.transpose()) + mu_ * zz;
    const Matrix mixed = lambda_ * (rz + hz) + mu_ * rz.transpose();
    const Matrix axial = direct * zz + mu_ * rr;
    Matrix k(element_.n_dofs_per_cell(), element_.n_dofs_per_cell());
    for (unsigned i = 0; i < k.rows(); ++i)
      for (unsigned j = 0; j < k.cols(); ++j) {
        const auto [ci, ni] = place_[i];
        const auto [cj, nj] = place_[j];
        k(i, j) = ci == 0 ? (cj == 0 ? radial(ni, nj) : mixed(ni, nj))
                          : (cj == 0 ? mixed(nj, ni) : axial(ni, nj));
      }
    return k;
  }

  static inline const auto kUpdate = dealii::update_values | dealii::update_gradients |
                                     dealii::update_quadrature_points | dealii::update_JxW_values;

  void assemble() {
    std::vector<global_dof_index> index(element_.n_dofs_per_cell());
    std::vector<global_dof_index> skeleton(outer_);
    dealii::DynamicSparsityPattern entries(n_skeleton_);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      cell->get_dof_indices(index);
      std::copy_n(index.begin(), outer_, skeleton.begin());
      constraints_.add_entries_local_to_global(skeleton, entries, false);
    }
    // Constrained unknowns keep a diagonal entry.
    for (unsigned i = 0; i < n_skeleton_; ++i) entries.add(i, i);
    pattern_.copy_from(entries);
    matrix_.reinit(pattern_);

    dealii::FEValues<2> values(mapping_, scalar_, quadrature_, kUpdate);
    dealii::FullMatrix<double> local(outer_);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      shapes_.push_back(shape(values, cell));
      const Matrix k = stiffness(shapes_.back());
      const Eigen::Index n = outer_;
      const Eigen::Index m = k.rows() - n;
      Matrix condensed = k.topLeftCorner(n, n);
      Matrix inner;
      if (m > 0) {
        inner = k.bottomRightCorner(m, m).llt().solve(k.bottomLeftCorner(m, n));
        condensed -= k.topRightCorner(n, m) * inner;
      }
      for (unsigned i = 0; i < outer_; ++i)
        for (unsigned j = 0; j < outer_; ++j) local(i, j) = (condensed(i, j) + condensed(j, i)) / 2;
      inner_.push_back(std::move(inner));
      cell->get_dof_indices(index);
      std::copy_n(index.begin(), outer_, skeleton.begin());
      constraints_.distribute_local_to_global(local, skeleton, matrix_);
    }
  }

  /// Torque as shear stress r/J, force as stress 1/A, over the loaded edges.  (FE-3)
  void load_vector() {
    dealii::FEFaceValues<2> values(mapping_, scalar_, dealii::QGauss<1>(p_ + 2),
                                   dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_JxW_values | dealii::update_normal_vectors);
    load_.reinit(n_skeleton_);
    raw_load_.reinit(dofs_.n_dofs());
    std::vector<global_dof_index> index(element_.n_dofs_per_cell());
    double whole = 0.0;
    for (const auto& cell : dofs_.active_cell_iterators())
      for (const unsigned f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != kLoaded) continue;
        values.reinit(static_cast<Triangulation<2>::active_cell_iterator>(cell), f);
        cell->get_dof_indices(index);
        for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
          const double r = values.quadrature_point(q)[0];
          const double weight = 2 * pi * (torsion_ ? r * r * r : r) * values.JxW(q);
          whole += weight;
          const auto normal = values.normal_vector(q);
          for (unsigned i = 0; i < index.size(); ++i) {
            const auto [component, function] = place_[i];
            const double along = pressure_                      ? -normal[component]
                                 : component == components_ - 1 ? 1.0
                                                                : 0.0;
            raw_load_(index[i]) += along * weight * values.shape_value(function, q);
          }
        }
      }
    if (!pressure_) raw_load_ /= whole;
    dealii::Vector<double> condensed = raw_load_;
    constraints_.condense(condensed);
    for (unsigned i = 0; i < n_skeleton_; ++i) load_(i) = condensed(i);
  }

  void recover_inner() {
    std::vector<global_dof_index> index(element_.n_dofs_per_cell());
    std::size_t c = 0;
    for (const auto& cell : dofs_.active_cell_iterators()) {
      const Matrix& inner = inner_[c++];
      if (inner.rows() == 0) continue;
      cell->get_dof_indices(index);
      Column outer(outer_);
      for (unsigned i = 0; i < outer_; ++i) outer(i) = solution_(index[i]);
      const Column found = -inner * outer;
      for (unsigned i = 0; i < found.size(); ++i) solution_(index[outer_ + i]) = found(i);
    }
  }

  /// The solution of a cell by component, in the order of its scalar shape functions.
  [[nodiscard]] std::array<Column, 2> nodal(const std::vector<global_dof_index>& index) const {
    std::array<Column, 2> u{Column::Zero(scalar_.n_dofs_per_cell()),
                            Column::Zero(scalar_.n_dofs_per_cell())};
    for (unsigned i = 0; i < index.size(); ++i)
      u[place_[i].first](place_[i].second) = solution_(index[i]);
    return u;
  }

  [[nodiscard]] CellField field(const CellShape& s, const std::array<Column, 2>& u) const {
    const auto back = [&](const Matrix& n, const Array& a) -> Column {
      return n.transpose() * (s.w * a).matrix();
    };
    const Array a_r = (s.Nr * u[0]).array();
    const Array a_z = (s.Nz * u[0]).array();
    if (torsion_) {
      const Array weight = mu_ * s.r.cube();
      const Array square = a_r.square() + a_z.square();
      return {.energy = weight * square / 2,
              .explicit_r = 1.5 * mu_ * s.r.square() * square,
              .pull_r = weight * a_r * a_r,
              .pull_z = weight * a_z * a_r,
              .force = {back(s.Nr, weight * a_r) + back(s.Nz, weight * a_z), Column()}};
    }
    const Array b_r = (s.Nr * u[1]).array();
    const Array b_z = (s.Nz * u[1]).array();
    const Array hoop = (s.N * u[0]).array() / s.r;
    const Array volume = lambda_ * (a_r + hoop + b_z);
    const Array s_rr = volume + 2 * mu_ * a_r;
    const Array s_hh = volume + 2 * mu_ * hoop;
    const Array s_zz = volume + 2 * mu_ * b_z;
    const Array s_rz = mu_ * (a_z + b_r);
    const Array density = (s_rr * a_r + s_hh * hoop + s_zz * b_z + s_rz * (a_z + b_r)) / 2;
    return {.energy = s.r * density,
            .explicit_r = density - s_hh * hoop,
            .pull_r = s.r * (s_rr * a_r + s_rz * b_r),
            .pull_z = s.r * (s_rz * a_r + s_zz * b_r),
            .force = {back(s.Nr, s.r * s_rr) + back(s.N, s_hh) + back(s.Nz, s.r * s_rz),
                      back(s.Nz, s.r * s_zz) + back(s.Nr, s.r * s_rz)}};
  }

  SectionSolution evaluate() {
    SectionSolution result{
        .part_energy = std::vector<double>(1 + *std::ranges::max_element(mesh_.part), 0.0),
        .worst_jacobian = worst_jacobian_,
        .cells = grid_.n_active_cells(),
        .dofs = dofs_.n_dofs()};
    dealii::Vector<double> force(dofs_.n_dofs());
    std::vector<double> ring_change(static_cast<std::size_t>(rings_), 0.0);
    std::vector<global_dof_index> index(element_.n_dofs_per_cell());
    std::size_t c = 0;
    for (const auto& cell : dofs_.active_cell_iterators()) {
      const CellShape& s = shapes_[c++];
      cell->get_dof_indices(index);
      const CellField at = field(s, nodal(index));
      result.part_energy[cell->material_id()] += (s.w * at.energy).sum();
      for (unsigned i = 0; i < index.size(); ++i)
        force(index[i]) += at.force[place_[i].first](place_[i].second);
      if (mesh_.crack) add_rings(ring_change, s, at);
    }
    double energy = 0.0;
    for (const double part : result.part_energy) energy += part;
    const double work = raw_load_ * solution_;
    // Both are the compliance, but an error of the solution enters this one squared only.
    result.compliance = 2 * work - 2 * energy;        // (FE-4)
    result.energy_balance = energy / (work / 2) - 1;  // (FE-5)
    force -= raw_load_;
    constraints_.condense(force);
    constraints_.set_zero(force);
    result.equilibrium_residual = force.linfty_norm() / load_.linfty_norm();
    if (mesh_.crack) result.tip = tip(ring_change);
    if (divisions_ > 0) result.fields = sample();
    return result;
  }

  /// Change of strain energy when the material is moved outward by q: 1 inside a ring, falling to
  /// 0 across it, and bilinear in each of its cells.  (FE-6)
  void add_rings(std::vector<double>& change, const CellShape& s, const CellField& at) const {
    const Array dr = s.r - mesh_.crack->tip.r;
    const Array dz = s.z - mesh_.crack->tip.z;
    if (std::max(dr.abs().minCoeff(), dz.abs().minCoeff()) > tip_cell_) return;
    for (std::size_t k = 0; k < change.size(); ++k) {
      const double outer = std::ldexp(tip_cell_, -static_cast<int>(k));
      const auto hat = [&](const Array& x) -> Array {
        return (2 - 2 * x.abs() / outer).max(0.0).min(1.0);
      };
      const auto slope = [&](const Array& x) -> Array {
        return ((x.abs() > outer / 2) && (x.abs() < outer)).select(-2 / outer * x.sign(), 0.0);
      };
      const Array q = hat(dr) * hat(dz);
      const Array q_r = slope(dr) * hat(dz);
      const Array q_z = hat(dr) * slope(dz);
      change[k] +=
          (s.w * (at.explicit_r * q + (at.energy - at.pull_r) * q_r - at.pull_z * q_z)).sum();
    }
  }

  /// Relative displacement of the faces, larger z minus smaller, at h/2^k behind the tip.
  [[nodiscard]] std::vector<std::array<double, 2>> jumps() const {
    const CrackTip& crack = *mesh_.crack;
    std::vector<std::array<double, 2>> jump(static_cast<std::size_t>(rings_) + 1, {0.0, 0.0});
    std::vector<std::array<bool, 2>> seen(jump.size(), {false, false});
    for (const auto& cell : dofs_.active_cell_iterators())
      for (const unsigned v : cell->vertex_indices()) {
        if (std::abs(cell->vertex(v)[1] - crack.tip.z) > 1e-9 * tip_cell_) continue;
        const double behind = (crack.tip.r - cell->vertex(v)[0]) * crack.direction;
        if (!(behind > 0) || behind > 1.5 * tip_cell_) continue;
        const auto k = static_cast<std::size_t>(std::lround(std::log2(tip_cell_ / behind)));
        if (k >= jump.size() ||
            std::abs(std::ldexp(behind, static_cast<int>(k)) - tip_cell_) > 1e-6 * tip_cell_)
          continue;
        const bool above = cell->center()[1] > crack.tip.z;
        if (std::exchange(seen[k][above ? 1 : 0], true)) continue;
        for (unsigned component = 0; component < components_; ++component)
          jump[k][component] += (above ? 1 : -1) * solution_(cell->vertex_dof_index(v, component)) *
                                (torsion_ ? cell->vertex(v)[0] : 1.0);
      }
    return jump;
  }

  [[nodiscard]] TipResult tip(const std::vector<double>& ring_change) const {
    const CrackTip& crack = *mesh_.crack;
    TipResult result;
    // The two innermost rings are next to cells that do not know the singularity.
    const std::size_t used = ring_change.size() - 2;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t k = 0; k < used; ++k) {
      const double G = -crack.direction * ring_change[k] / (2 * pi * crack.tip.r);
      least = std::min(least, G);
      most = std::max(most, G);
      result.energy_release_rate += G / static_cast<double>(used);
    }
    result.ring_spread = (most - least) / result.energy_release_rate;

    // K(x) = K + K' x + ..., extrapolated to the tip from three distances.  (FE-7)
    const auto jump = jumps();
    const auto extrapolated = [&](std::size_t component, double modulus) {
      const auto at = [&](int k) {
        return modulus * jump[static_cast<std::size_t>(k)][component] *
               std::sqrt(2 * pi / std::ldexp(tip_cell_, -k));
      };
      const double one = 2 * at(2) - at(1);
      const double two = 2 * at(3) - at(2);
      return (4 * two - one) / 3;
    };
    double of_K = 0.0;
    if (torsion_) {
      result.K_III = extrapolated(0, mu_ / 4);
      of_K = result.K_III * result.K_III / (2 * mu_);
    } else {
      result.K_I = extrapolated(1, plane_strain_ / 8);
      result.K_II = crack.direction * extrapolated(0, plane_strain_ / 8);
      of_K = (result.K_I * result.K_I + result.K_II * result.K_II) / plane_strain_;
    }
    result.displacement_check = of_K / result.energy_release_rate - 1;
    const double scale =  // so that G of K is G
        of_K > 0 ? std::sqrt(std::max(0.0, result.energy_release_rate) / of_K) : 0.0;
    result.K_I *= scale;
    result.K_II *= scale;
    result.K_III *= scale;
    return result;
  }

  /// The solution in the half plane y = 0, whose x is r and whose y goes round.
  [[nodiscard]] SampledFields sample() const {
    SampledFields fields{.dimension = 2, .divisions = divisions_, .cells = {}, .crack_faces = {}};
    std::vector<dealii::Point<2>> unit;
    for (int j = 0; j <= divisions_; ++j)
      for (int i = 0; i <= divisions_; ++i)
        unit.emplace_back(static_cast<double>(i) / divisions_, static_cast<double>(j) / divisions_);
    dealii::FEValues<2> values(
        mapping_, scalar_, dealii::Quadrature<2>(unit),
        dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points);
    const double tiny = 1e-12 * extent_of(mesh_);
    std::vector<global_dof_index> index(element_.n_dofs_per_cell());
    for (const auto& cell : dofs_.active_cell_iterators()) {
      values.reinit(static_cast<Triangulation<2>::active_cell_iterator>(cell));
      cell->get_dof_indices(index);
      const std::array<Column, 2> u = nodal(index);
      FieldCell& sampled = fields.cells.emplace_back();
      for (unsigned q = 0; q < unit.size(); ++q) {
        std::array<double, 2> value{};
        std::array<dealii::Tensor<1, 2>, 2> slope;  // d/dr, d/dz
        for (unsigned i = 0; i < scalar_.n_dofs_per_cell(); ++i)
          for (unsigned c = 0; c < components_; ++c) {
            value[c] += u[c](i) * values.shape_value(i, q);
            slope[c] += u[c](i) * values.shape_grad(i, q);
          }
        const double r = values.quadrature_point(q)[0];
        FieldPoint p{.place = {r, 0, values.quadrature_point(q)[1]}};
        if (torsion_) {
          p.displacement = {0, r * value[0], 0};
          const double shear_r = mu_ * r * slope[0][0];
          const double shear_z = mu_ * r * slope[0][1];
          p.stress = {0, 0, 0, shear_z, 0, shear_r};
          p.energy_density = (shear_r * shear_r + shear_z * shear_z) / (2 * mu_);  // (FE-38)
        } else {
          p.displacement = {value[0], 0, value[1]};
          const double hoop = r > tiny ? value[0] / r : slope[0][0];  // its limit on the axis
          const double volume = lambda_ * (slope[0][0] + hoop + slope[1][1]);
          const double shear = mu_ * (slope[0][1] + slope[1][0]);
          p.stress = {volume + 2 * mu_ * slope[0][0],
                      volume + 2 * mu_ * hoop,
                      volume + 2 * mu_ * slope[1][1],
                      0,
                      shear,
                      0};
          p.energy_density = (p.stress[0] * slope[0][0] + p.stress[1] * hoop +
                              p.stress[2] * slope[1][1] + shear * shear / mu_) /
                             2;  // (FE-38)
        }
        sampled.points.push_back(p);
      }
    }
    return fields;
  }

  const SectionMesh& mesh_;
  bool torsion_;
  bool pressure_;
  unsigned p_;
  int rings_;
  int divisions_;
  double tip_cell_;
  double mu_;
  double lambda_;
  double plane_strain_;
  unsigned components_;
  Triangulation<2> grid_;
  dealii::MappingQ<2> mapping_;
  dealii::FE_Q<2> scalar_;
  dealii::FESystem<2> element_;
  dealii::QGauss<2> quadrature_;
  dealii::DoFHandler<2> dofs_;
  dealii::AffineConstraints<double> constraints_;
  dealii::SparsityPattern pattern_;
  dealii::SparseMatrix<double> matrix_;
  dealii::Vector<double> load_;      ///< on the skeleton, constraints applied
  dealii::Vector<double> raw_load_;  ///< on all unknowns
  dealii::Vector<double> solution_;
  std::vector<std::pair<unsigned, unsigned>> place_;  ///< component and function of an unknown
  unsigned outer_ = 0;                                ///< unknowns of a cell on its boundary
  unsigned n_skeleton_ = 0;
  std::vector<CellShape> shapes_;  ///< of each cell
  std::vector<Matrix> inner_;      ///< of each cell: inner unknowns = - inner * outer ones
  double worst_jacobian_ = 1.0;
};

}  // namespace

SectionSolution solve_section(const SectionMesh& mesh, SectionLoad load,
                              const Elasticity& elasticity, const SectionOptions& options) {
  check_input(mesh, load, elasticity, options);
  return Solver(mesh, load, elasticity, options).solve();
}

}  // namespace strainwave::fem
