// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/axisymmetric.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "condensed_solver.hpp"
#include "section/grid.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

using dealii::Triangulation;
using namespace section;
using dealii::types::global_dof_index;
using std::numbers::pi;
using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;
using Array = Eigen::ArrayXd;

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

/// Shape functions at quadrature points: rows are points, columns functions.
struct Shape {
  Matrix N, Nr, Nz;  ///< value, and derivatives by r and z
};

/// One cell at its quadrature points.
struct CellShape {
  /// shape of this cell, or that of the unit square for all rectangles
  std::shared_ptr<const Shape> shape;
  double per_r = 1.0;  ///< factor from Nr to d/dr; 1/width for a rectangle [1/m]
  double per_z = 1.0;  ///< factor from Nz to d/dz
  Array r, z, w;       ///< place [m], and 2 pi det J times weight [m^2]
};

/// A cell with sides along r and z.
struct Rectangle {
  double r = 0.0, z = 0.0;           ///< corner with the least r and z [m]
  double width = 0.0, height = 0.0;  ///< [m]
};

/// Shape functions of one variable in (0, 1) at its quadrature points, in ascending order.
struct LineShape {
  Matrix N, Nx;
  Array x, w;
};

/// Stiffness of a cell by components; torsion uses `radial` only.
struct Blocks {
  Matrix radial, mixed, axial;  ///< u_r with u_r, u_r with u_z, u_z with u_z
};

/// The free unknowns on which the unknowns of a cell depend.
struct CellUnknowns {
  struct Share {
    unsigned own;         ///< index of the cell's unknown
    Eigen::Index column;  ///< index in `free`
    double factor;
  };
  std::vector<Eigen::Index> free;
  std::vector<Share> shares;  ///< empty for a held unknown; not filled if all are free
  bool all_free = false;

  /// Converts columns of the cell's unknowns to columns of the free unknowns.
  [[nodiscard]] Matrix gathered(const Matrix& columns) const {
    Matrix result = Matrix::Zero(columns.rows(), static_cast<Eigen::Index>(free.size()));
    for (const Share& s : shares) result.col(s.column) += s.factor * columns.col(s.own);
    return result;
  }
};

/// A solution at the quadrature points of one cell.
struct CellField {
  Array energy;  ///< integrand of strain energy, over w
  /// derivative of the energy by r at constant unknowns and gradients
  Array explicit_r;
  Array pull_r, pull_z;         ///< (d energy/d grad u) . du/dr, its two components
  std::array<Column, 2> force;  ///< force of the cell on its nodes, by component
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
        extent_(extent_of(mesh)),
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
    make_grid(grid_, mesh,
              {.halvings = options.halvings,
               .corner_rings = options.corner_rings,
               .tip_rings = options.tip_rings});
    dofs_.distribute_dofs(element_);
    for (unsigned i = 0; i < element_.n_dofs_per_cell(); ++i)
      place_.push_back(element_.system_to_component_index(i));
    line_shape();
    constrain();
  }

  SectionSolution solve() {
    shape_cells();
    load_vector();
    std::vector<CellUnknowns> unknowns;
    std::vector<std::vector<Eigen::Index>> elements;
    for (const auto& cell : dofs_.active_cell_iterators()) {
      unknowns.push_back(unknowns_of(cell));
      elements.push_back(unknowns.back().free);
    }
    const auto matrix = [&](std::size_t c) -> Matrix {
      Matrix k = stiffness(c);
      if (unknowns[c].all_free) return k;
      const Matrix whole = k.selfadjointView<Eigen::Lower>();
      return unknowns[c].gathered(unknowns[c].gathered(whole).transpose());
    };
    const auto x = solve_condensed(elements, matrix, load_);
    if (!x)
      throw SolverError(
          fmt::format("finite elements: the equations of {} unknowns could not be factored; check "
                      "that an edge of the section is held",
                      dofs_.n_dofs()));
    solution_.reinit(dofs_.n_dofs());
    std::ranges::copy(x->col(0), solution_.begin());
    constraints_.distribute(solution_);
    return evaluate();
  }

 private:
  using Cell = dealii::DoFHandler<2>::active_cell_iterator;

  void constrain() {
    std::vector<global_dof_index> index(element_.n_dofs_per_face());
    for (const auto& cell : dofs_.active_cell_iterators())
      for (const unsigned f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary()) continue;
        const auto id = cell->face(f)->boundary_id();
        // Held edges have neither twist nor axial displacement.  The axis has zero radial
        // displacement.
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

  /// Shape functions of the unit square and of its sides.  Functions and quadrature points of the
  /// square are products, so an integral over a rectangle is a product of two sums.
  void line_shape() {
    const dealii::QGauss<1> points(p_ + 2);
    const auto n = static_cast<Eigen::Index>(points.size());
    const dealii::FE_Q<1> line(p_);
    const auto rising = dealii::FETools::hierarchic_to_lexicographic_numbering<1>(p_);
    line_ = {.N = Matrix(n, p_ + 1), .Nx = Matrix(n, p_ + 1), .x = Array(n), .w = Array(n)};
    for (unsigned q = 0; q < n; ++q) {
      line_.x(q) = points.point(q)[0];
      line_.w(q) = points.weight(q);
      for (unsigned i = 0; i <= p_; ++i) {
        line_.N(q, rising[i]) = line.shape_value(i, points.point(q));
        line_.Nx(q, rising[i]) = line.shape_grad(i, points.point(q))[0];
      }
    }
    const unsigned functions = scalar_.n_dofs_per_cell();
    Shape square{.N = Matrix(n * n, functions),
                 .Nr = Matrix(n * n, functions),
                 .Nz = Matrix(n * n, functions)};
    const auto lexicographic = dealii::FETools::hierarchic_to_lexicographic_numbering<2>(p_);
    for (unsigned i = 0; i < functions; ++i) {
      as_is_.push_back(i);
      product_.push_back(lexicographic[i]);
      const Eigen::Index a = lexicographic[i] % (p_ + 1);
      const Eigen::Index b = lexicographic[i] / (p_ + 1);
      for (Eigen::Index q = 0; q < n * n; ++q) {
        square.N(q, i) = line_.N(q % n, a) * line_.N(q / n, b);
        square.Nr(q, i) = line_.Nx(q % n, a) * line_.N(q / n, b);
        square.Nz(q, i) = line_.N(q % n, a) * line_.Nx(q / n, b);
      }
    }
    square_ = std::make_shared<const Shape>(std::move(square));
  }

  /// The cell as a rectangle, if its sides are straight, lie along r and z, and are numbered in
  /// that order.
  [[nodiscard]] std::optional<Rectangle> rectangle(const Cell& cell) const {
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->manifold_id() != dealii::numbers::flat_manifold_id) return {};
    const auto low = cell->vertex(0);
    const auto high = cell->vertex(3);
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * extent_;
    const auto same = [&](double a, double b) { return std::abs(a - b) <= rounding; };
    const bool straight = same(cell->vertex(1)[0], high[0]) && same(cell->vertex(1)[1], low[1]) &&
                          same(cell->vertex(2)[0], low[0]) && same(cell->vertex(2)[1], high[1]);
    if (!straight || !(high[0] > low[0]) || !(high[1] > low[1])) return {};
    return Rectangle{
        .r = low[0], .z = low[1], .width = high[0] - low[0], .height = high[1] - low[1]};
  }

  [[nodiscard]] CellShape shape(const Rectangle& box) const {
    const Eigen::Index n = line_.x.size();
    CellShape s{.shape = square_,
                .per_r = 1 / box.width,
                .per_z = 1 / box.height,
                .r = (box.r + box.width * line_.x).replicate(n, 1),
                .z = Array(n * n),
                .w = Array(n * n)};
    for (Eigen::Index b = 0; b < n; ++b) {
      s.z.segment(b * n, n).setConstant(box.z + box.height * line_.x(b));
      s.w.segment(b * n, n) = 2 * pi * box.width * box.height * line_.w(b) * line_.w;
    }
    return s;
  }

  /// Shape functions and weights of any cell; a cell with a folded mapping is refused.
  [[nodiscard]] CellShape shape(dealii::FEValues<2>& values, const Cell& cell) {
    values.reinit(static_cast<Triangulation<2>::active_cell_iterator>(cell));
    const unsigned points = values.n_quadrature_points;
    const unsigned functions = scalar_.n_dofs_per_cell();
    Shape own{.N = Matrix(points, functions),
              .Nr = Matrix(points, functions),
              .Nz = Matrix(points, functions)};
    CellShape s{.shape = nullptr, .r = Array(points), .z = Array(points), .w = Array(points)};
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
        own.N(q, i) = values.shape_value(i, q);
        const auto gradient = values.shape_grad(i, q);
        own.Nr(q, i) = gradient[0];
        own.Nz(q, i) = gradient[1];
      }
    }
    const double worst = least * points / sum;
    if (!(least > 0))
      throw InputError("mesh", fmt::format("the cell at r = {:.6g} m, z = {:.6g} m is folded: its "
                                           "Jacobian falls to {:.3g} of its mean, but must be > 0",
                                           cell->center()[0], cell->center()[1], worst));
    worst_jacobian_ = std::min(worst_jacobian_, worst);
    s.shape = std::make_shared<const Shape>(std::move(own));
    return s;
  }

  /// Stiffness of any cell, in the order of its scalar shape functions.
  [[nodiscard]] Blocks stiffness(const CellShape& s) const {
    const auto form = [&](const Matrix& a, const Matrix& b, const Array& weight) -> Matrix {
      return a.transpose() * weight.matrix().asDiagonal() * b;
    };
    const Shape& at = *s.shape;
    if (torsion_) {
      const Array weight = mu_ * s.r.cube() * s.w;  // (FE-1)
      return {.radial = form(at.Nr, at.Nr, weight) + form(at.Nz, at.Nz, weight),
              .mixed = {},
              .axial = {}};
    }
    const Array weight = s.r * s.w;
    const Matrix hoop = s.r.inverse().matrix().asDiagonal() * at.N;
    const double direct = lambda_ + 2 * mu_;
    const Matrix rr = form(at.Nr, at.Nr, weight);
    const Matrix zz = form(at.Nz, at.Nz, weight);
    const Matrix rz = form(at.Nr, at.Nz, weight);
    const Matrix rh = form(at.Nr, hoop, weight);
    const Matrix hh = form(hoop, hoop, weight);
    const Matrix hz = form(hoop, at.Nz, weight);
    return {.radial =  // (FE-2)
            direct * (rr + hh) + lambda_ * (rh + rh.transpose()) + mu_ * zz,
            .mixed = lambda_ * (rz + hz) + mu_ * rz.transpose(),
            .axial = direct * zz + mu_ * rr};
  }

  /// Stiffness of a rectangle; each integral is the product of an integral along r and one along z.
  [[nodiscard]] Blocks stiffness(const Rectangle& box) const {
    const Array r = box.r + box.width * line_.x;
    const auto sum = [&](const Matrix& a, const Matrix& b, const Array& weight) -> Matrix {
      return a.transpose() * (line_.w * weight).matrix().asDiagonal() * b;
    };
    const Array one = Array::Ones(r.size());
    const double across = 2 * pi * box.width;
    // Integrals along z: value with value, slope with slope, value with slope.
    const Matrix z00 = box.height * sum(line_.N, line_.N, one);
    const Matrix z11 = sum(line_.Nx, line_.Nx, one) / box.height;
    const Matrix z01 = sum(line_.N, line_.Nx, one);
    const Matrix slope = line_.Nx / box.width;
    if (torsion_) {
      const Array weight = mu_ * across * r.cube();  // (FE-1)
      return {
          .radial = products(sum(slope, slope, weight), z00, sum(line_.N, line_.N, weight), z11),
          .mixed = {},
          .axial = {}};
    }
    const double direct = lambda_ + 2 * mu_;
    const Matrix rr = sum(slope, slope, across * r);
    const Matrix hh = sum(line_.N, line_.N, across / r);
    const Matrix rh = sum(slope, line_.N, across * one);
    const Matrix vv = sum(line_.N, line_.N, across * r);
    const Matrix rv = sum(slope, line_.N, across * r);
    const Matrix hv = sum(line_.N, line_.N, across * one);
    return {.radial = products(  // (FE-2)
                direct * (rr + hh) + lambda_ * (rh + rh.transpose()), z00, mu_ * vv, z11),
            .mixed = products(lambda_ * (rv + hv), z01, mu_ * rv.transpose(), z01.transpose()),
            .axial = products(direct * vv, z11, mu_ * rr, z00)};
  }

  /// The products r(a,c) z(b,d) + R(a,c) Z(b,d), with function (a,b) at index a + (p+1) b.
  [[nodiscard]] static Matrix products(const Matrix& r, const Matrix& z, const Matrix& R,
                                       const Matrix& Z) {
    const Eigen::Index n = r.rows();
    Matrix k(n * n, n * n);
    for (Eigen::Index d = 0; d < n; ++d)
      for (Eigen::Index b = 0; b < n; ++b) k.block(b * n, d * n, n, n) = z(b, d) * r + Z(b, d) * R;
    return k;
  }

  /// Lower half of the stiffness in the order of the cell's unknowns; `order` is the index of a
  /// scalar shape function in the blocks.
  [[nodiscard]] Matrix join(const Blocks& blocks, const std::vector<unsigned>& order) const {
    Matrix k(element_.n_dofs_per_cell(), element_.n_dofs_per_cell());
    for (unsigned j = 0; j < k.cols(); ++j) {
      const auto [cj, fj] = place_[j];
      const unsigned nj = order[fj];
      for (unsigned i = j; i < k.rows(); ++i) {
        const auto [ci, fi] = place_[i];
        const unsigned ni = order[fi];
        k(i, j) = ci == 0 ? (cj == 0 ? blocks.radial(ni, nj) : blocks.mixed(ni, nj))
                          : (cj == 0 ? blocks.mixed(nj, ni) : blocks.axial(ni, nj));
      }
    }
    return k;
  }

  static inline const auto kUpdate = dealii::update_values | dealii::update_gradients |
                                     dealii::update_quadrature_points | dealii::update_JxW_values;

  void shape_cells() {
    dealii::FEValues<2> values(mapping_, scalar_, quadrature_, kUpdate);
    for (const auto& cell : dofs_.active_cell_iterators()) {
      boxes_.push_back(rectangle(cell));
      shapes_.push_back(boxes_.back() ? shape(*boxes_.back()) : shape(values, cell));
    }
  }

  /// Lower half of the stiffness of a cell, in the order of its unknowns.
  [[nodiscard]] Matrix stiffness(std::size_t c) const {
    return boxes_[c] ? join(stiffness(*boxes_[c]), product_) : join(stiffness(shapes_[c]), as_is_);
  }

  [[nodiscard]] CellUnknowns unknowns_of(const Cell& cell) const {
    std::vector<global_dof_index> index(element_.n_dofs_per_cell());
    cell->get_dof_indices(index);
    CellUnknowns result;
    result.all_free =
        std::ranges::none_of(index, [&](auto i) { return constraints_.is_constrained(i); });
    if (result.all_free) {
      result.free.assign(index.begin(), index.end());
      return result;
    }
    const auto share = [&](unsigned own, global_dof_index dof, double factor) {
      const auto known = static_cast<Eigen::Index>(dof);
      const auto at = std::ranges::find(result.free, known);
      result.shares.push_back({own, at - result.free.begin(), factor});
      if (at == result.free.end()) result.free.push_back(known);
    };
    for (unsigned i = 0; i < index.size(); ++i)
      if (!constraints_.is_constrained(index[i]))
        share(i, index[i], 1.0);
      else
        for (const auto& [other, factor] : *constraints_.get_constraint_entries(index[i]))
          share(i, other, factor);
    return result;
  }

  /// Applies the torque as shear stress r/J, or the force as stress 1/A, over the loaded edges.
  /// (FE-3)
  void load_vector() {
    dealii::FEFaceValues<2> values(mapping_, scalar_, dealii::QGauss<1>(p_ + 2),
                                   dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_JxW_values | dealii::update_normal_vectors);
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
    constraints_.set_zero(condensed);
    load_ = Eigen::Map<const Column>(condensed.begin(), condensed.size());
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
    const Matrix& N = s.shape->N;
    const Matrix& Nr = s.shape->Nr;
    const Matrix& Nz = s.shape->Nz;
    const Array a_r = s.per_r * (Nr * u[0]).array();
    const Array a_z = s.per_z * (Nz * u[0]).array();
    if (torsion_) {
      const Array weight = mu_ * s.r.cube();
      const Array square = a_r.square() + a_z.square();
      return {
          .energy = weight * square / 2,
          .explicit_r = 1.5 * mu_ * s.r.square() * square,
          .pull_r = weight * a_r * a_r,
          .pull_z = weight * a_z * a_r,
          .force = {back(Nr, s.per_r * weight * a_r) + back(Nz, s.per_z * weight * a_z), Column()}};
    }
    const Array b_r = s.per_r * (Nr * u[1]).array();
    const Array b_z = s.per_z * (Nz * u[1]).array();
    const Array hoop = (N * u[0]).array() / s.r;
    const Array volume = lambda_ * (a_r + hoop + b_z);
    const Array s_rr = volume + 2 * mu_ * a_r;
    const Array s_hh = volume + 2 * mu_ * hoop;
    const Array s_zz = volume + 2 * mu_ * b_z;
    const Array s_rz = mu_ * (a_z + b_r);
    const Array density = (s_rr * a_r + s_hh * hoop + s_zz * b_z + s_rz * (a_z + b_r)) / 2;
    return {
        .energy = s.r * density,
        .explicit_r = density - s_hh * hoop,
        .pull_r = s.r * (s_rr * a_r + s_rz * b_r),
        .pull_z = s.r * (s_rz * a_r + s_zz * b_r),
        .force = {back(Nr, s.per_r * s.r * s_rr) + back(N, s_hh) + back(Nz, s.per_z * s.r * s_rz),
                  back(Nz, s.per_z * s.r * s_zz) + back(Nr, s.per_r * s.r * s_rz)}};
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
    // Work and energy both give the compliance, but an error of the solution affects this
    // combination only in second order.
    result.compliance = 2 * work - 2 * energy;        // (FE-4)
    result.energy_balance = energy / (work / 2) - 1;  // (FE-5)
    force -= raw_load_;
    constraints_.condense(force);
    constraints_.set_zero(force);
    result.equilibrium_residual = force.linfty_norm() / load_.lpNorm<Eigen::Infinity>();
    if (mesh_.crack) result.tip = tip(ring_change);
    if (divisions_ > 0) result.fields = sample();
    return result;
  }

  /// Change of strain energy when the material moves outward by q (FE-6).  q is 1 inside a ring,
  /// falls to 0 across it, and is bilinear in each of its cells.
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
    // Leave out the two innermost rings, because their neighbouring cells do not model the
    // singularity.
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
    const double scale =  // makes G from K equal to G
        of_K > 0 ? std::sqrt(std::max(0.0, result.energy_release_rate) / of_K) : 0.0;
    result.K_I *= scale;
    result.K_II *= scale;
    result.K_III *= scale;
    return result;
  }

  /// The solution in the half plane y = 0, with x = r and y in the circumferential direction.
  [[nodiscard]] SampledFields sample() const {
    SampledFields fields{.dimension = 2, .divisions = divisions_, .cells = {}, .crack_faces = {}};
    std::vector<dealii::Point<2>> unit;
    for (int j = 0; j <= divisions_; ++j)
      for (int i = 0; i <= divisions_; ++i)
        unit.emplace_back(static_cast<double>(i) / divisions_, static_cast<double>(j) / divisions_);
    dealii::FEValues<2> values(
        mapping_, scalar_, dealii::Quadrature<2>(unit),
        dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points);
    const double tiny = 1e-12 * extent_;
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
          const double hoop = r > tiny ? value[0] / r : slope[0][0];  // limit on the axis
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
  double extent_;
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
  Column load_;                      ///< load with constraints applied
  dealii::Vector<double> raw_load_;  ///< load on all unknowns
  dealii::Vector<double> solution_;
  std::vector<std::pair<unsigned, unsigned>> place_;  ///< component and function of each unknown
  LineShape line_;
  std::shared_ptr<const Shape> square_;          ///< shape functions of the unit square
  std::vector<unsigned> product_;                ///< indices of the shape functions in products()
  std::vector<unsigned> as_is_;                  ///< identity order 0, 1, ...
  std::vector<CellShape> shapes_;                ///< shape of each cell
  std::vector<std::optional<Rectangle>> boxes_;  ///< each cell that is a rectangle
  double worst_jacobian_ = 1.0;
};

}  // namespace

SectionSolution solve_section(const SectionMesh& mesh, SectionLoad load,
                              const Elasticity& elasticity, const SectionOptions& options) {
  check_input(mesh, load, elasticity, options);
  return Solver(mesh, load, elasticity, options).solve();
}

}  // namespace strainwave::fem
