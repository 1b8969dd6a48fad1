// SPDX-License-Identifier: Apache-2.0
#include "contact.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave::fem::solid {
FaceContact::FaceContact(const Space& space, const Constraints& constraints, Equations& equations)
    : space_(space), constraints_(constraints), equations_(equations) {
  find_places();
  solved_.assign(pairs(), false);
  if (rows_.empty()) throw InputError("mesh", "has no crack faces that could touch");
  area_.resize(static_cast<Eigen::Index>(pairs()));
  for (std::size_t i = 0; i < pairs(); ++i) area_[static_cast<Eigen::Index>(i)] = places_[i].area;
}

/// Nodes that can touch, and nodes that cannot because both sides share them.
void FaceContact::find_places() {
  const dealii::QGauss<2> rule(static_cast<unsigned>(space_.problem.order) + 2);
  dealii::FEFaceValues<3> values(
      space_.body.mapping, space_.scalar, rule,
      dealii::update_values | dealii::update_normal_vectors | dealii::update_JxW_values);
  struct Upper {
    Point<3> at;
    Tensor<1, 3> area;    // integral of the node's function, times the normal
    Tensor<1, 3> normal;  // integral of its square, which is positive also at a front
  };
  std::map<Node, Upper> upper;
  std::map<Node, Point<3>> lower;
  double size = 0;
  space_.visit_crack_faces([&](const Cell& cell, unsigned f) {
    Space::reinit(values, cell, f);
    size = std::max(size, cell->diameter());
    space_.visit_face_nodes(cell, f, [&](unsigned a, const Node& node) {
      const Point<3> place =
          to_point(space_.source(cell).map(to_array(space_.scalar.unit_support_point(a))));
      if (space_.source(cell).side < 0) {
        lower[node] = place;
        return;
      }
      Upper& entry = upper[node];
      entry.at = place;
      for (const unsigned q : values.quadrature_point_indices()) {
        const double value = values.shape_value(a, q);
        entry.area -= value * values.JxW(q) * values.normal_vector(q);
        entry.normal -= value * value * values.JxW(q) * values.normal_vector(q);
      }
    });
  });
  std::vector<FacePlace> at_fronts;
  for (const auto& [node, one] : upper) {
    if (lower.count(node)) {
      const Tensor<1, 3> normal = one.normal / one.normal.norm();
      on_front_.insert(node[0]);
      at_fronts.push_back({node, node, one.at, normal, one.area * normal});
      continue;
    }
    for (const auto& [twin, place] : lower)
      if (!upper.count(twin) && place.distance(one.at) < 1e-9 * size)
        places_.push_back({node, twin, one.at, one.area / one.area.norm(), one.area.norm()});
  }
  for (const FacePlace& pair : places_) rows_.push_back(gap_row(pair));
  places_.insert(places_.end(), at_fronts.begin(), at_fronts.end());
}

/// The gap of a pair as a sum over unconstrained dofs.
FaceContact::Row FaceContact::gap_row(const FacePlace& pair) const {
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
  return {row.begin(), row.end()};
}

/// Normal distance of the two sides at each pair; < 0 means that the sides pass through each other.
Eigen::VectorXd FaceContact::gaps(const Vector& u) const {
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(area_.size());
  for (std::size_t i = 0; i < pairs(); ++i)
    for (unsigned k = 0; k < 3; ++k)
      gap[static_cast<Eigen::Index>(i)] +=
          (u[places_[i].upper[k]] - u[places_[i].lower[k]]) * places_[i].normal[k];
  return gap;
}

double FaceContact::largest_jump(const Vector& u) const {
  double jump = 0;
  for (std::size_t i = 0; i < pairs(); ++i) {
    double square = 0;
    for (unsigned k = 0; k < 3; ++k)
      square += std::pow(u[places_[i].upper[k]] - u[places_[i].lower[k]], 2);
    jump = std::max(jump, std::sqrt(square));
  }
  return jump;
}

/// Solves for a unit pressure at each of some pairs, fills in their columns of the flexibility, and
/// calls visit(pair, unknowns) for each.
template <class Visit>
void FaceContact::solve_pressures(const std::vector<Eigen::Index>& of, const Visit& visit) {
  constexpr std::size_t kBlock = 64;
  const std::vector<int>& number = equations_.numbering().number;
  const auto unknowns = static_cast<std::size_t>(equations_.numbering().unknowns);
  const auto n = static_cast<Eigen::Index>(pairs());
  if (flexibility_.size() == 0) flexibility_ = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t first = 0; first < of.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, of.size() - first);
    std::vector<double> columns(count * unknowns, 0.0);
    for (std::size_t j = 0; j < count; ++j) {
      const auto pair = static_cast<std::size_t>(of[first + j]);
      for (const auto& [dof, value] : rows_[pair])
        columns[j * unknowns + static_cast<std::size_t>(number[dof])] += value * places_[pair].area;
    }
    columns = equations_.solver().solve(std::move(columns), static_cast<int>(count));
    for (std::size_t j = 0; j < count; ++j) {
      const std::span<const double> u =
          std::span<const double>(columns).subspan(j * unknowns, unknowns);
      const Eigen::Index pair = of[first + j];
      for (Eigen::Index i = 0; i < n; ++i)
        for (const auto& [dof, value] : rows_[static_cast<std::size_t>(i)])
          flexibility_(i, pair) += value * u[static_cast<std::size_t>(number[dof])];
      solved_[static_cast<std::size_t>(pair)] = true;
      visit(pair, u);
    }
  }
}

Eigen::MatrixXd FaceContact::displacements(const std::vector<Index>& at) {
  const std::vector<int>& number = equations_.numbering().number;
  Eigen::MatrixXd displaced(static_cast<Eigen::Index>(at.size()),
                            static_cast<Eigen::Index>(pairs()));
  flexibility_.resize(0, 0);
  std::vector<Eigen::Index> all(pairs());
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  solve_pressures(all, [&](Eigen::Index j, std::span<const double> u) {
    for (Eigen::Index i = 0; i < displaced.rows(); ++i)
      displaced(i, j) = u[static_cast<std::size_t>(number[at[static_cast<std::size_t>(i)]])];
  });
  return displaced;
}

/// The pressures that keep the faces from passing through each other [Pa].
///
/// Mostly few pairs touch.  So only the pairs that overlap are solved for, and those that overlap
/// under the pressures of the others join them until none is left.  All pairs together have one
/// solution, and this is the one.
Complementarity FaceContact::pressures(const Eigen::VectorXd& free_gap) {
  const Eigen::VectorXd weighted = area_.asDiagonal() * free_gap;
  const double nothing = 1e-9 * weighted.cwiseAbs().maxCoeff();
  std::vector<Eigen::Index> among;
  std::vector<bool> chosen(pairs(), false);
  Eigen::VectorXd slack = weighted;
  Complementarity answer{.x = std::vector<double>(pairs(), 0.0)};
  for (;;) {
    std::vector<Eigen::Index> unsolved;
    bool complete = true;
    for (Eigen::Index i = 0; i < slack.size(); ++i) {
      const auto pair = static_cast<std::size_t>(i);
      if (chosen[pair] || !(slack[i] < -nothing)) continue;
      complete = false;
      chosen[pair] = true;
      among.push_back(i);
      if (!solved_[pair]) unsolved.push_back(i);
    }
    if (complete) return answer;
    solve_pressures(unsolved, [](Eigen::Index, std::span<const double>) {});
    // Weights by area make the matrix symmetric.
    const Eigen::VectorXd weight = area_(among);
    const Eigen::MatrixXd matrix = weight.asDiagonal() * flexibility_(among, among);
    const Eigen::VectorXd gap = weighted(among);
    const Complementarity part = solve_complementarity(
        {matrix.data(), static_cast<std::size_t>(matrix.size())},
        {gap.data(), static_cast<std::size_t>(gap.size())}, "the crack faces");
    answer.steps += part.steps;
    slack = weighted;
    for (std::size_t k = 0; k < among.size(); ++k) {
      answer.x[static_cast<std::size_t>(among[k])] = part.x[k];
      slack += part.x[k] * (area_.asDiagonal() * flexibility_.col(among[k]));
    }
  }
}

std::map<Index, Index> FaceContact::neighbours_of_fronts() const {
  std::map<Index, Index> neighbour;
  space_.visit_crack_faces([&](const Cell& cell, unsigned f) {
    std::vector<std::pair<Point<3>, Index>> shared;
    std::vector<std::pair<Point<3>, Index>> paired;
    space_.visit_face_nodes(cell, f, [&](unsigned a, const Node& node) {
      (on_front_.count(node[0]) ? shared : paired)
          .push_back({space_.scalar.unit_support_point(a), node[0]});
    });
    for (const auto& [place, dof] : shared) {
      double nearest = 2;
      for (const auto& [other, twin] : paired)
        if (std::abs(other[2] - place[2]) < 1e-9 && other.distance(place) < nearest) {
          nearest = other.distance(place);
          neighbour[dof] = twin;
        }
    }
  });
  return neighbour;
}

std::optional<Contact> FaceContact::close(const Vector& load, const Vector& u) {
  constexpr double kNothing = 1e-5;  // share of the largest jump
  const double jump = largest_jump(u);
  const Eigen::VectorXd free_gap = gaps(u);
  if (free_gap.minCoeff() >= -kNothing * jump) return std::nullopt;
  const Complementarity answer = pressures(free_gap);
  Contact contact{.u = {},
                  .forces = Vector(space_.dofs.n_dofs()),
                  .pressure = std::vector<double>(space_.dofs.n_dofs(), 0.0),
                  .on_front = on_front_,
                  .iterations = answer.steps};
  double touching = 0;
  double whole = 0;
  for (std::size_t i = 0; i < pairs(); ++i) {
    const FacePlace& pair = places_[i];
    const double p = answer.x[i];
    whole += pair.area;
    if (!(p > 0)) continue;
    touching += pair.area;
    contact.pressure[pair.upper[0]] = contact.pressure[pair.lower[0]] = p;
    for (unsigned k = 0; k < 3; ++k) {
      contact.forces[pair.upper[k]] += p * pair.area * pair.normal[k];
      contact.forces[pair.lower[k]] -= p * pair.area * pair.normal[k];
    }
  }
  contact.share = touching / whole;
  Vector forces = load;
  forces += contact.forces;
  contact.u = equations_.displacements(std::move(forces));
  contact.overlap = std::max(0.0, -gaps(contact.u).minCoeff()) / jump;
  for (const auto& [at_front, neighbour] : neighbours_of_fronts())
    contact.pressure[at_front] = contact.pressure[neighbour];
  return contact;
}

}  // namespace strainwave::fem::solid
