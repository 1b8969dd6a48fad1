// SPDX-License-Identifier: Apache-2.0
#include "contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave::fem::solid {
namespace {

struct Complementarity {
  Eigen::VectorXd x;
  int steps;
};

/// Solves x >= 0 with M x + b >= 0 where in each row x or M x + b is zero; M is symmetric, positive
/// definite.
///
/// Uses principal pivoting.  All wrong signs are changed at once while their number falls, else
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
  throw SolverError(
      fmt::format("the contact of the crack faces did not converge in {} steps", most));
}

/// At a front both sides share their nodes, so no pair gives a pressure there; the pressure of the
/// neighbour on the face is used.
void extend_pressure_to_fronts(const Space& space, Contact& contact) {
  space.visit_crack_faces([&](const Cell& cell, unsigned f) {
    std::vector<std::pair<Point<3>, Index>> shared;
    std::vector<std::pair<Point<3>, Index>> paired;
    space.visit_face_nodes(cell, f, [&](unsigned a, const Node& node) {
      (contact.on_front.count(node[0]) ? shared : paired)
          .push_back({space.scalar.unit_support_point(a), node[0]});
    });
    for (const auto& [place, dof] : shared) {
      double nearest = 2;
      for (const auto& [other, twin] : paired)
        if (std::abs(other[2] - place[2]) < 1e-9 && other.distance(place) < nearest) {
          nearest = other.distance(place);
          contact.pressure[dof] = contact.pressure[twin];
        }
    }
  });
}

}  // namespace

FaceContact::FaceContact(const Space& space, const Constraints& constraints, Equations& equations)
    : space_(space), constraints_(constraints), equations_(equations) {
  find_pairs();
  if (pairs_.empty()) throw InputError("mesh", "has no crack faces that could touch");
  area_.resize(static_cast<Eigen::Index>(pairs_.size()));
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    pairs_[i].row = gap_row(pairs_[i]);
    area_[static_cast<Eigen::Index>(i)] = pairs_[i].area;
  }
}

/// Nodes that can touch, and nodes that cannot because both sides share them.
void FaceContact::find_pairs() {
  const dealii::QGauss<2> rule(static_cast<unsigned>(space_.problem.order) + 2);
  dealii::FEFaceValues<3> values(
      space_.body.mapping, space_.scalar, rule,
      dealii::update_values | dealii::update_normal_vectors | dealii::update_JxW_values);
  std::map<Node, std::pair<Point<3>, Tensor<1, 3>>> upper;
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
      auto& entry = upper[node];
      entry.first = place;
      for (const unsigned q : values.quadrature_point_indices())
        entry.second -= values.shape_value(a, q) * values.JxW(q) * values.normal_vector(q);
    });
  });
  for (const auto& [node, at] : upper) {
    if (lower.count(node)) {
      on_front_.insert(node[0]);
      continue;
    }
    for (const auto& [twin, place] : lower)
      if (!upper.count(twin) && place.distance(at.first) < 1e-9 * size)
        pairs_.push_back({node, twin, at.second / at.second.norm(), at.second.norm(), {}});
  }
}

/// The gap of a pair as a sum over unconstrained dofs.
std::vector<std::pair<Index, double>> FaceContact::gap_row(const Pair& pair) const {
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
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    for (unsigned k = 0; k < 3; ++k)
      gap[static_cast<Eigen::Index>(i)] +=
          (u[pairs_[i].upper[k]] - u[pairs_[i].lower[k]]) * pairs_[i].normal[k];
  return gap;
}

double FaceContact::largest_jump(const Vector& u) const {
  double jump = 0;
  for (const Pair& pair : pairs_) {
    double square = 0;
    for (unsigned k = 0; k < 3; ++k) square += std::pow(u[pair.upper[k]] - u[pair.lower[k]], 2);
    jump = std::max(jump, std::sqrt(square));
  }
  return jump;
}

/// Gap of pair i under a unit pressure at pair j, that is, under a pair of forces equal to its
/// area.
Eigen::MatrixXd FaceContact::flexibility() const {
  constexpr std::size_t kBlock = 64;
  const std::vector<int>& number = equations_.numbering().number;
  const auto n = static_cast<Eigen::Index>(pairs_.size());
  const auto unknowns = static_cast<std::size_t>(equations_.numbering().unknowns);
  Eigen::MatrixXd flexibility = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t first = 0; first < pairs_.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, pairs_.size() - first);
    std::vector<double> columns(count * unknowns, 0.0);
    for (std::size_t j = 0; j < count; ++j)
      for (const auto& [dof, value] : pairs_[first + j].row)
        columns[j * unknowns + static_cast<std::size_t>(number[dof])] +=
            value * pairs_[first + j].area;
    columns = equations_.solver().solve(std::move(columns), static_cast<int>(count));
    for (std::size_t j = 0; j < count; ++j)
      for (Eigen::Index i = 0; i < n; ++i)
        for (const auto& [dof, value] : pairs_[static_cast<std::size_t>(i)].row)
          flexibility(i, static_cast<Eigen::Index>(first + j)) +=
              value * columns[j * unknowns + static_cast<std::size_t>(number[dof])];
  }
  return flexibility;
}

std::optional<Contact> FaceContact::close(const Vector& load, const Vector& u) {
  constexpr double kNothing = 1e-5;  // share of the largest jump
  const double jump = largest_jump(u);
  const Eigen::VectorXd free_gap = gaps(u);
  if (free_gap.minCoeff() >= -kNothing * jump) return std::nullopt;
  if (flexibility_.size() == 0) flexibility_ = area_.asDiagonal() * flexibility();
  const Complementarity answer = solve_complementarity(flexibility_, area_.asDiagonal() * free_gap);
  Contact contact{.u = {},
                  .forces = Vector(space_.dofs.n_dofs()),
                  .pressure = std::vector<double>(space_.dofs.n_dofs(), 0.0),
                  .on_front = on_front_,
                  .iterations = answer.steps};
  double touching = 0;
  double whole = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const double p = answer.x[static_cast<Eigen::Index>(i)];
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
  extend_pressure_to_fronts(space_, contact);
  return contact;
}

}  // namespace strainwave::fem::solid
