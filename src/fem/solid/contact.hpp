// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "assembly.hpp"
#include "space.hpp"

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

/// The two sides of a crack, which touch under some loads of a body, (FE-30).
class FaceContact {
 public:
  /// @throws InputError  if the mesh has no faces that could touch
  FaceContact(const Space& space, const Constraints& constraints, Equations& equations);

  /// Computes the pressure between faces that would pass through each other; absent if they stay
  /// apart.
  /// @param load  nodal forces [N]
  /// @param u     displacements without contact [m]
  /// @throws SolverError  if the contact does not converge
  [[nodiscard]] std::optional<Contact> close(const Vector& load, const Vector& u);

 private:
  /// The dofs of the crack's two sides at one place.
  struct Pair {
    Node upper;
    Node lower;
    Tensor<1, 3> normal;                        ///< normal from lower to upper
    double area;                                ///< the node's share of the crack [m^2]
    std::vector<std::pair<Index, double>> row;  ///< gap as a sum over unconstrained dofs
  };

  void find_pairs();
  [[nodiscard]] std::vector<std::pair<Index, double>> gap_row(const Pair& pair) const;
  [[nodiscard]] Eigen::VectorXd gaps(const Vector& u) const;
  [[nodiscard]] double largest_jump(const Vector& u) const;
  [[nodiscard]] Eigen::MatrixXd flexibility() const;

  const Space& space_;
  const Constraints& constraints_;
  Equations& equations_;
  std::vector<Pair> pairs_;      ///< nodes that can touch
  std::set<Index> on_front_;     ///< first dofs of the nodes that both sides share
  Eigen::VectorXd area_;         ///< of each pair [m^2]
  Eigen::MatrixXd flexibility_;  ///< times `area_`, from the first load whose faces touch on
};

}  // namespace strainwave::fem::solid
