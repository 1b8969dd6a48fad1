// SPDX-License-Identifier: Apache-2.0
#include "fields.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave::fem::solid {
namespace {

/// Points i/n of each unit coordinate; the first coordinate runs fastest.
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

/// Energy density sigma:epsilon/2 of a stress [J/m^3].
double energy_of_stress(const Tensor2& s, const Elasticity& m) {
  const double nu = m.poissons_ratio;
  const double pressure = trace(s);
  return ((1 + nu) * scalar_product(s, s) - nu * pressure * pressure) /
         (2 * m.youngs_modulus);  // (FE-38)
}

struct CrackFace {
  Cell cell;
  unsigned number;
  Point<3> middle;
};

/// The faces of the cracks on one side of them.
std::vector<CrackFace> crack_faces(const Space& space, bool upper) {
  std::vector<CrackFace> faces;
  space.visit_crack_faces([&](const Cell& cell, unsigned f) {
    if ((space.source(cell).side > 0) != upper) return;
    Point3 unit{0.5, 0.5, 0.5};
    unit[f / 2] = f % 2;
    faces.push_back({cell, f, to_point(space.source(cell).map(unit))});
  });
  return faces;
}

/// Displacement of the body without the crack where the load does not cause it [m].
Tensor<1, 3> sound_displacement(const SolidLoad& load, const Point<3>& place) {
  if (!load.released || !load.displacement_without_crack) return {};
  return to_tensor(load.displacement_without_crack(to_array(place)));
}

std::vector<CrackFacePatch> crack_face_patches(const Space& space, const SolidLoad& load,
                                               const Vector& u) {
  const std::vector<CrackFace> lower = crack_faces(space, false);
  const dealii::Quadrature<2> points = sample_points<2>(space.problem.fields.divisions);
  // The normal is not defined at a front with a singular map, so evaluate it next to the front.
  std::vector<Point<2>> inner = points.get_points();
  for (Point<2>& point : inner) point += 1e-6 * (Point<2>(0.5, 0.5) - point);
  dealii::FEFaceValues<3> values(space.body.mapping, space.scalar, points,
                                 dealii::update_values | dealii::update_quadrature_points);
  dealii::FEFaceValues<3> normals(space.body.mapping, space.scalar, dealii::Quadrature<2>(inner),
                                  dealii::update_normal_vectors);
  const auto displacements = [&](const CrackFace& face) {
    Space::reinit(values, face.cell, face.number);
    const CellDisplacement displacement(space, face.cell, u);
    std::vector<Tensor<1, 3>> at;
    for (unsigned q = 0; q < points.size(); ++q) at.push_back(displacement.at(values, q));
    return at;
  };
  std::vector<CrackFacePatch> patches;
  for (const CrackFace& face : crack_faces(space, true)) {
    if (!space.problem.fields.every_cell && !face.cell->is_locally_owned()) continue;
    const double near = 1e-6 * face.cell->diameter();
    const auto twin = std::find_if(lower.begin(), lower.end(), [&](const CrackFace& other) {
      return other.middle.distance(face.middle) < near;
    });
    if (twin == lower.end()) throw InputError("mesh", "has a crack face without its other side");
    const std::vector<Tensor<1, 3>> below = displacements(*twin);
    // A copy, because the next face overwrites the points.
    std::vector<Point<3>> place_below = values.get_quadrature_points();
    const std::vector<Tensor<1, 3>> above = displacements(face);
    Space::reinit(normals, face.cell, face.number);
    CrackFacePatch& patch = patches.emplace_back();
    for (unsigned q = 0; q < points.size(); ++q) {
      const Point<3>& place = values.quadrature_point(q);
      // The other face may number its points in another direction.
      const auto same = std::min_element(place_below.begin(), place_below.end(),
                                         [&](const Point<3>& a, const Point<3>& b) {
                                           return a.distance(place) < b.distance(place);
                                         });
      const Tensor<1, 3>& opposite = below[static_cast<std::size_t>(same - place_below.begin())];
      const Tensor<1, 3> sound = sound_displacement(load, place);
      const Tensor<1, 3> up = above[q] + sound;
      const Tensor<1, 3> down = opposite + sound;
      patch.points.push_back(
          {.place = to_array(place),
           .upper = {up[0], up[1], up[2]},
           .lower = {down[0], down[1], down[2]},
           .opening = (opposite - above[q]) * normals.normal_vector(q)});  // (FE-39)
    }
  }
  return patches;
}

}  // namespace

SampledFields sampled_fields(const Space& space, const SolidLoad& load, const Vector& u) {
  const SolidProblem& problem = space.problem;
  const FieldRequest& request = problem.fields;
  SampledFields fields{.dimension = 3,
                       .divisions = request.divisions,
                       .without_crack = static_cast<bool>(load.stress_without_crack),
                       .cells = {},
                       .crack_faces = {}};
  const dealii::Quadrature<3> points = sample_points<3>(request.divisions);
  // The gradient is infinite at a front with a singular map, so evaluate it next to the front.
  std::vector<Point<3>> inner = points.get_points();
  for (Point<3>& point : inner)
    if (point[0] == 0 && point[1] == 0)
      point[0] = point[1] = 0.25 / static_cast<double>(request.divisions);
  dealii::FEValues<3> values(space.body.mapping, space.scalar, points,
                             dealii::update_values | dealii::update_quadrature_points);
  dealii::FEValues<3> slopes(space.body.mapping, space.scalar, points, dealii::update_gradients);
  dealii::FEValues<3> inner_slopes(space.body.mapping, space.scalar, dealii::Quadrature<3>(inner),
                                   dealii::update_gradients);
  for (const Cell& cell : space.dofs.active_cell_iterators()) {
    if (!request.every_cell && !cell->is_locally_owned()) continue;
    const HexCell& source = space.source(cell);
    const CellDisplacement displacement(space, cell, u);
    Space::reinit(values, cell);
    const std::vector<Tensor2> gradient =
        displacement.gradients(Space::reinit(is_singular(source) ? inner_slopes : slopes, cell));
    FieldCell& sampled = fields.cells.emplace_back();
    sampled.face_tag = source.face_tag;
    sampled.cell = static_cast<std::size_t>(cell->index());
    for (unsigned q = 0; q < points.size(); ++q) {
      const Tensor<1, 3> moved =
          displacement.at(values, q) + sound_displacement(load, values.quadrature_point(q));
      Tensor2 s = space.lame.stress(gradient[q]);
      FieldPoint p{.place = to_array(values.quadrature_point(q))};
      if (fields.without_crack) {
        const auto sound = load.stress_without_crack(p.place);
        Tensor2 s0;
        for (unsigned i = 0; i < 3; ++i) s0[i] = to_tensor(sound[i]);
        p.energy_density_without_crack = energy_of_stress(s0, problem.material);
        if (load.released) s += s0;
      }
      p.displacement = {moved[0], moved[1], moved[2]};
      p.stress = {s[0][0], s[1][1], s[2][2], s[1][2], s[0][2], s[0][1]};
      p.energy_density = energy_of_stress(s, problem.material);
      sampled.points.push_back(p);
    }
  }
  fields.crack_faces = crack_face_patches(space, load, u);
  return fields;
}

}  // namespace strainwave::fem::solid
