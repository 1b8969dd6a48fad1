// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "assembly.hpp"
#include "space.hpp"
#include "strainwave/fem/complementarity.hpp"

namespace strainwave::fem::solid {

/// Faces of a crack that press on each other.
struct Contact {
  Vector u;                      ///< displacements with the contact [m]
  Vector forces;                 ///< nodal forces of the contact [N]
  std::vector<double> pressure;  ///< pressure at a node's first dof [Pa]
  std::set<Index> on_front;      ///< first dofs of the nodes that both sides share
  double share = 0;              ///< share of the crack's area that touches [-]
  int iterations = 0;
  double overlap = 0;  ///< deepest remaining overlap over the largest jump without contact [-]
};

/// A place of a crack, with the nodes of its two sides.
struct FacePlace {
  Node upper;
  Node lower;  ///< at a front, the same node
  Point<3> at;
  Tensor<1, 3> normal;  ///< from lower to upper
  double area;          ///< the node's share of the crack [m^2]; may be < 0 at a front
};

/// The two sides of a crack, which touch under some loads of a body, (FE-30).
class FaceContact {
 public:
  /// @throws InputError  if the mesh has no faces that could touch
  FaceContact(const Space& space, const Constraints& constraints, Equations& equations);

  /// Places that can touch, then those at fronts.
  [[nodiscard]] const std::vector<FacePlace>& places() const { return places_; }
  /// Number of places that can touch.
  [[nodiscard]] std::size_t pairs() const { return rows_.size(); }
  /// Displacements at unknowns `at`, in rows, under a unit pressure at each pair, in columns: that
  /// is, under a pair of forces equal to its area [m/Pa].
  /// @param at  dofs without constraints
  [[nodiscard]] Eigen::MatrixXd displacements(const std::vector<Index>& at);
  /// Gap of each pair, in rows, under the same pressures [m/Pa]; complete after `displacements`.
  [[nodiscard]] const Eigen::MatrixXd& flexibility() const { return flexibility_; }

  /// The nearest paired node of a face, for each node at a front, by their first dofs.  At a front
  /// both sides share their nodes, so no pair gives a pressure there; that of the neighbour is
  /// used.
  [[nodiscard]] std::map<Index, Index> neighbours_of_fronts() const;

  /// Computes the pressure between faces that would pass through each other; absent if they stay
  /// apart.
  /// @param load  nodal forces [N]
  /// @param u     displacements without contact [m]
  /// @throws SolverError  if the contact does not converge
  [[nodiscard]] std::optional<Contact> close(const Vector& load, const Vector& u);

 private:
  using Row = std::vector<std::pair<Index, double>>;

  void find_places();
  [[nodiscard]] Row gap_row(const FacePlace& place) const;
  [[nodiscard]] Eigen::VectorXd gaps(const Vector& u) const;
  [[nodiscard]] double largest_jump(const Vector& u) const;
  template <class Visit>
  void solve_pressures(const std::vector<Eigen::Index>& of, const Visit& visit);
  [[nodiscard]] Complementarity pressures(const Eigen::VectorXd& free_gap);

  const Space& space_;
  const Constraints& constraints_;
  Equations& equations_;
  std::vector<FacePlace> places_;  ///< pairs, then places at fronts
  std::vector<Row> rows_;          ///< gap of each pair as a sum over unconstrained dofs
  std::set<Index> on_front_;       ///< first dofs of the nodes that both sides share
  Eigen::VectorXd area_;           ///< of each pair [m^2]
  Eigen::MatrixXd flexibility_;    ///< empty before it is needed; columns of the pairs solved for
  std::vector<bool> solved_;       ///< pairs whose columns are there
};

}  // namespace strainwave::fem::solid
