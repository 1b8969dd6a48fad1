// SPDX-License-Identifier: Apache-2.0
#include "space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave::fem::solid {
namespace {

constexpr int kGeometryOrder = 4;  // least order; it maps 45 degrees of a circle to 1e-6

double scaled_determinant(const Tensor2& J) {
  double lengths = 1;
  for (unsigned k = 0; k < 3; ++k)
    lengths *= std::sqrt(J[0][k] * J[0][k] + J[1][k] * J[1][k] + J[2][k] * J[2][k]);
  return lengths > 0 ? dealii::determinant(J) / lengths : 0;
}

}  // namespace

Body::Body(const HexMesh& mesh, int order)
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
        cell->face(f)->set_boundary_id(
            static_cast<unsigned>(mesh.cells[static_cast<std::size_t>(cell->index())].face_tag[f]));
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
        throw InputError("mesh", fmt::format("cell {} is tangled or left-handed: its scaled "
                                             "Jacobian determinant is {:.3g}, but must be positive",
                                             cell->index(), scaled));
      worst = std::min(worst, scaled);
    }
  }
  return worst;
}

Lame::Lame(const Elasticity& m)
    : lambda(m.youngs_modulus * m.poissons_ratio /
             ((1 + m.poissons_ratio) * (1 - 2 * m.poissons_ratio))),
      mu(m.youngs_modulus / (2 * (1 + m.poissons_ratio))) {}

Tensor2 Lame::stress(const Tensor2& gradient) const {
  Tensor2 s = mu * (gradient + transpose(gradient));
  const double volume = lambda * trace(gradient);
  for (unsigned i = 0; i < 3; ++i) s[i][i] += volume;
  return s;
}

Space::Space(const HexMesh& mesh_of_body, const SolidProblem& problem_of_body)
    : mesh(mesh_of_body),
      problem(problem_of_body),
      lame(problem.material),
      body(mesh, problem.order),
      jacobian(worst_jacobian(mesh, body)),
      scalar(static_cast<unsigned>(problem.order)),
      element(scalar, 3),
      dofs(body.triangulation),
      node_of(3, std::vector<unsigned>(scalar.n_dofs_per_cell())) {
  dofs.distribute_dofs(element);
  for (unsigned i = 0; i < element.n_dofs_per_cell(); ++i)
    node_of[element.system_to_component_index(i).first]
           [element.system_to_component_index(i).second] = i;
}

std::vector<Index> Space::indices(const Cell& cell) const {
  std::vector<Index> result(element.n_dofs_per_cell());
  cell->get_dof_indices(result);
  return result;
}

dealii::FEValues<3>& Space::reinit(dealii::FEValues<3>& values, const Cell& cell) {
  values.reinit(typename dealii::Triangulation<3>::active_cell_iterator(cell));
  return values;
}

dealii::FEFaceValues<3>& Space::reinit(dealii::FEFaceValues<3>& values, const Cell& cell,
                                       unsigned f) {
  values.reinit(typename dealii::Triangulation<3>::active_cell_iterator(cell), f);
  return values;
}

CellDisplacement::CellDisplacement(const Space& space, const Cell& cell, const Vector& u)
    : space_(space) {
  for (const Index i : space.indices(cell)) local_.push_back(u[i]);
}

Tensor<1, 3> CellDisplacement::at(const dealii::FEValuesBase<3>& values, unsigned q) const {
  Tensor<1, 3> u;
  for (unsigned a = 0; a < space_.scalar.n_dofs_per_cell(); ++a)
    for (unsigned i = 0; i < 3; ++i)
      u[i] += local_[space_.node_of[i][a]] * values.shape_value(a, q);
  return u;
}

std::vector<Tensor2> CellDisplacement::gradients(const dealii::FEValuesBase<3>& values) const {
  std::vector<Tensor2> result(values.n_quadrature_points);
  for (unsigned q = 0; q < values.n_quadrature_points; ++q)
    for (unsigned a = 0; a < space_.scalar.n_dofs_per_cell(); ++a) {
      const Tensor<1, 3>& g = values.shape_grad(a, q);
      for (unsigned i = 0; i < 3; ++i) result[q][i] += local_[space_.node_of[i][a]] * g;
    }
  return result;
}

}  // namespace strainwave::fem::solid
