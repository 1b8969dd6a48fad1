// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
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

/// Computes the pressure between faces that would pass through each other, (FE-30); absent if they
/// stay apart.
/// @param load  nodal forces of the problem [N]
/// @param u     displacements without contact [m]
/// @throws InputError   if the mesh has no faces that could touch
/// @throws SolverError  if the contact does not converge
[[nodiscard]] std::optional<Contact> close_crack(const Space& space, const Constraints& constraints,
                                                 Equations& equations, const Vector& load,
                                                 const Vector& u);

}  // namespace strainwave::fem::solid
