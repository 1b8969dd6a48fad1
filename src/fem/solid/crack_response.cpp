// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/crack_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "assembly.hpp"
#include "factored_solid.hpp"
#include "fronts.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fem/complementarity.hpp"

namespace strainwave::fem {
namespace {

using namespace solid;
using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

/// The dofs of the crack's faces, and the forces of tractions there.
struct Faces {
  std::vector<Index> dofs;
  std::map<Index, Eigen::Index> number;  ///< of a dof in `dofs`
  std::map<Index, std::size_t> place;    ///< of a node, by its first dof
  Matrix force;  ///< nodal force at each dof, in rows, per traction component of each place [m^2]

  Faces(const Space& space, const std::vector<FacePlace>& places) {
    for (std::size_t i = 0; i < places.size(); ++i)
      for (const Node* const node : {&places[i].upper, &places[i].lower})
        if (place.emplace((*node)[0], i).second)
          for (const Index dof : *node) {
            number.emplace(dof, static_cast<Eigen::Index>(dofs.size()));
            dofs.push_back(dof);
          }
    force = Matrix::Zero(static_cast<Eigen::Index>(dofs.size()),
                         3 * static_cast<Eigen::Index>(places.size()));
    const dealii::QGauss<2> rule(static_cast<unsigned>(space.problem.order) + 2);
    dealii::FEFaceValues<3> values(space.body.mapping, space.scalar, rule,
                                   dealii::update_values | dealii::update_JxW_values);
    space.visit_crack_faces([&](const Cell& cell, unsigned f) {
      Space::reinit(values, cell, f);
      const double side = space.source(cell).side;
      space.visit_face_nodes(cell, f, [&](unsigned a, const Node& node) {
        space.visit_face_nodes(cell, f, [&](unsigned b, const Node& other) {
          double mass = 0;
          for (const unsigned q : values.quadrature_point_indices())
            mass += values.shape_value(a, q) * values.shape_value(b, q) * values.JxW(q);
          const auto from = 3 * static_cast<Eigen::Index>(place.at(other[0]));
          for (unsigned k = 0; k < 3; ++k) force(number.at(node[k]), from + k) += side * mass;
        });
      });
    });
  }
};

/// The faces of cells on one side of the crack, as grids of nodes.
/// @param place  number of a node, by its first dof
std::vector<CrackCell> cells_of(const Space& space, const std::map<Index, std::size_t>& place) {
  struct GridNode {
    std::array<double, 2> at;  // second and first unit coordinate on the face
    std::size_t number;
  };
  std::vector<CrackCell> cells;
  space.visit_crack_faces([&](const Cell& cell, unsigned f) {
    if (space.source(cell).side < 0) return;
    const unsigned first = f / 2 == 0 ? 1 : 0;
    const unsigned second = f / 2 == 2 ? 1 : 2;
    std::vector<GridNode> grid;
    space.visit_face_nodes(cell, f, [&](unsigned a, const Node& node) {
      const Point<3>& unit = space.scalar.unit_support_point(a);
      grid.push_back({{unit[second], unit[first]}, place.at(node[0])});
    });
    std::ranges::sort(grid, {}, &GridNode::at);
    CrackCell& one = cells.emplace_back();
    for (const GridNode& node : grid) one.nodes.push_back(node.number);
  });
  return cells;
}

}  // namespace

struct CrackResponse::Parts {
  Parts(const HexMesh& mesh, const SolidProblem& problem) : solid(mesh, problem) {}

  FactoredSolid solid;
  std::vector<CrackNode> nodes;
  std::vector<CrackCell> cells;
  std::vector<StationPlace> stations;
  std::vector<std::vector<std::size_t>> beside;  ///< pairs beside each station, may repeat
  std::size_t pairs = 0;
  std::size_t unknowns = 0;
  std::size_t solutions = 0;
  double worst_jacobian = 1;
  // Rows of K: station, then mode.  Columns of tractions: node, then component.
  Matrix K_of_traction;  ///< [m^0.5]
  Matrix K_of_pressure;  ///< in columns the pairs [m^0.5]
  Matrix gap_of_traction;
  Matrix gap_of_pressure;  ///< [m/Pa]
  Column area;             ///< of each pair [m^2]
};

CrackResponse::CrackResponse(const HexMesh& mesh, const SolidProblem& problem) {
  if (problem.crack_tag == 0 || problem.crack_faces != CrackFaces::contact)
    throw InputError("problem", "must have a crack whose faces can touch");
  parts_ = std::make_unique<Parts>(mesh, problem);
  Parts& parts = *parts_;
  const Space& space = parts.solid.space();
  const Constraints& constraints = parts.solid.constraints();
  Equations& equations = parts.solid.equations();
  FaceContact& contact = parts.solid.contact();
  parts.worst_jacobian = space.jacobian;
  parts.unknowns = space.dofs.n_dofs();
  const std::vector<FacePlace>& places = contact.places();
  const Faces faces(space, places);
  for (const Index dof : faces.dofs)
    if (constraints.is_constrained(dof))
      throw InputError("mesh", "must not hold a node of the crack's faces");
  parts.pairs = contact.pairs();
  const auto pairs = static_cast<Eigen::Index>(parts.pairs);
  parts.area.resize(pairs);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const FacePlace& p = places[i];
    parts.nodes.push_back({.place = to_array(p.at),
                           .normal = {p.normal[0], p.normal[1], p.normal[2]},
                           .area = p.area,
                           .on_front = i >= parts.pairs});
    if (i < parts.pairs) parts.area[static_cast<Eigen::Index>(i)] = p.area;
  }

  parts.cells = cells_of(space, faces.place);

  // Gaps, by reciprocity: the work of the forces of tractions on the displacements under a unit
  // pressure at a pair is the pair's area times its gap under these forces.
  const Matrix displaced = contact.displacements(faces.dofs);
  parts.gap_of_pressure = contact.flexibility();
  parts.gap_of_traction =
      parts.area.cwiseInverse().asDiagonal() * (displaced.transpose() * faces.force);
  parts.solutions = parts.pairs;

  // Pressures as nodal forces, and as tractions with the pressure of the neighbour at fronts.
  Matrix pressed = Matrix::Zero(faces.force.rows(), pairs);
  Matrix traction_of_pressure = Matrix::Zero(faces.force.cols(), pairs);
  for (Eigen::Index i = 0; i < pairs; ++i) {
    const FacePlace& pair = places[static_cast<std::size_t>(i)];
    for (unsigned k = 0; k < 3; ++k) {
      pressed(faces.number.at(pair.upper[k]), i) = pair.area * pair.normal[k];
      pressed(faces.number.at(pair.lower[k]), i) = -pair.area * pair.normal[k];
      traction_of_pressure(3 * i + k, i) = pair.normal[k];
    }
  }
  for (const auto& [front_node, neighbour] : contact.neighbours_of_fronts()) {
    const auto node = static_cast<Eigen::Index>(faces.place.at(front_node));
    const auto pair = static_cast<Eigen::Index>(faces.place.at(neighbour));
    for (unsigned k = 0; k < 3; ++k)
      traction_of_pressure(3 * node + k, pair) = places[static_cast<std::size_t>(node)].normal[k];
  }

  // K by weight functions: the displacements under the factors of a functional as forces are its
  // values under unit forces.
  std::vector<Matrix> of_traction;
  std::vector<Matrix> of_pressure;
  Eigen::Index rows = 0;
  for (std::size_t f = 0; f < mesh.fronts; ++f) {
    const FrontFunctionals front = front_functionals(space, f);
    const std::size_t count = front.of_displacement.size();
    Matrix weight(static_cast<Eigen::Index>(count), faces.force.rows());
    Matrix direct = Matrix::Zero(static_cast<Eigen::Index>(count), faces.force.cols());
    const std::vector<Vector> solved = equations.displacements(front.of_displacement);
    parts.solutions += count;
    for (std::size_t n = 0; n < count; ++n) {
      const auto row = static_cast<Eigen::Index>(n);
      for (std::size_t d = 0; d < faces.dofs.size(); ++d)
        weight(row, static_cast<Eigen::Index>(d)) = solved[n][faces.dofs[d]];
      for (std::size_t p = 0; p < places.size(); ++p)
        for (unsigned k = 0; k < 3; ++k) {
          const auto column = 3 * static_cast<Eigen::Index>(p) + k;
          direct(row, column) = front.of_traction[n][places[p].upper[k]];
          if (p < parts.pairs) direct(row, column) += front.of_traction[n][places[p].lower[k]];
        }
    }
    of_traction.push_back(front.to_K * (weight * faces.force + direct));
    of_pressure.push_back(front.to_K * (weight * pressed + direct * traction_of_pressure));
    rows += of_traction.back().rows();
    for (const FrontStation& station : front.stations)
      parts.stations.push_back({.front = f, .position = station.position, .place = station.place});
    for (const std::vector<Index>& near : beside_stations(space, f, front.stations.size())) {
      std::vector<std::size_t>& list = parts.beside.emplace_back();
      for (const Index dof : near)
        if (const std::size_t place = faces.place.at(dof); place < parts.pairs)
          list.push_back(place);
    }
  }
  parts.K_of_traction.resize(rows, faces.force.cols());
  parts.K_of_pressure.resize(rows, pairs);
  Eigen::Index row = 0;
  for (std::size_t f = 0; f < of_traction.size(); ++f) {
    parts.K_of_traction.middleRows(row, of_traction[f].rows()) = of_traction[f];
    parts.K_of_pressure.middleRows(row, of_pressure[f].rows()) = of_pressure[f];
    row += of_traction[f].rows();
  }
}

CrackResponse::~CrackResponse() = default;
CrackResponse::CrackResponse(CrackResponse&&) noexcept = default;
CrackResponse& CrackResponse::operator=(CrackResponse&&) noexcept = default;

std::span<const CrackNode> CrackResponse::nodes() const { return parts_->nodes; }
std::span<const CrackCell> CrackResponse::cells() const { return parts_->cells; }
std::span<const StationPlace> CrackResponse::stations() const { return parts_->stations; }
std::size_t CrackResponse::unknowns() const { return parts_->unknowns; }
double CrackResponse::worst_jacobian() const { return parts_->worst_jacobian; }
std::size_t CrackResponse::solutions() const { return parts_->solutions; }

std::vector<SolidResult> CrackResponse::solve(std::span<const SolidLoad> loads) const {
  return parts_->solid.solve(loads, Factors::kept);
}

CrackState CrackResponse::state(std::span<const Point3> traction, CrackFaces faces) const {
  const Parts& parts = *parts_;
  if (traction.size() != parts.nodes.size())
    throw InputError("traction", fmt::format("has {} values, but the crack has {} nodes",
                                             traction.size(), parts.nodes.size()));
  Column t(3 * static_cast<Eigen::Index>(traction.size()));
  for (std::size_t i = 0; i < traction.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      require(std::isfinite(traction[i][k]), "traction", traction[i][k], "Pa", "a finite number");
      t(static_cast<Eigen::Index>(3 * i + k)) = traction[i][k];
    }
  Column K = parts.K_of_traction * t;
  Column gap = parts.gap_of_traction * t;
  Column pressure = Column::Zero(gap.size());
  CrackState state;
  constexpr double kNothing = 1e-5;  // share of the largest gap, as in the contact of solve_solid
  if (faces == CrackFaces::contact && gap.minCoeff() < -kNothing * gap.cwiseAbs().maxCoeff()) {
    const Matrix matrix = parts.area.asDiagonal() * parts.gap_of_pressure;
    const Column weighted = parts.area.asDiagonal() * gap;
    const Complementarity answer = solve_complementarity(
        {matrix.data(), static_cast<std::size_t>(matrix.size())},
        {weighted.data(), static_cast<std::size_t>(weighted.size())}, "the crack faces");
    pressure = Eigen::Map<const Column>(answer.x.data(), pressure.size());
    state.contact_steps = answer.steps;
    state.contact_share = (pressure.array() > 0).select(parts.area, 0.0).sum() / parts.area.sum();
    K += parts.K_of_pressure * pressure;
    gap += parts.gap_of_pressure * pressure;
  }
  state.gap.assign(parts.nodes.size(), 0.0);
  state.pressure.assign(parts.nodes.size(), 0.0);
  for (std::size_t i = 0; i < parts.pairs; ++i) {
    state.gap[i] = gap(static_cast<Eigen::Index>(i));
    state.pressure[i] = pressure(static_cast<Eigen::Index>(i));
  }
  for (std::size_t s = 0; s < parts.stations.size(); ++s) {
    const auto row = 3 * static_cast<Eigen::Index>(s);
    StationFactors factors{.K_I = K(row), .K_II = K(row + 1), .K_III = K(row + 2)};
    if (faces == CrackFaces::contact) {
      int balance = 0;
      for (const std::size_t pair : parts.beside[s]) balance += state.pressure[pair] > 0 ? 1 : -1;
      factors.closed = balance > 0 || factors.K_I < 0;
      if (factors.closed) factors.K_I = 0;
    }
    state.stations.push_back(factors);
  }
  return state;
}

}  // namespace strainwave::fem
