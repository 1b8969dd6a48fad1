// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact.hpp"
#include "space.hpp"

namespace strainwave::fem::solid {

/// Fracture quantities of one crack front.
/// @param load     load of the body
/// @param contact  contact of the crack faces; null if they do not touch
/// @param front    number of the front in the mesh
/// @throws InputError  if fewer than three rings of cells surround the front
[[nodiscard]] CrackFront evaluate_front(const Space& space, const SolidLoad& load, const Vector& u,
                                        const Contact* contact, std::size_t front);

/// First dofs of the nodes of the crack's faces beside each node of a front, that is, in the cells
/// at the front and in the innermost ring; nodes on the front itself are among them.
[[nodiscard]] std::vector<std::vector<Index>> beside_stations(const Space& space, std::size_t front,
                                                              std::size_t nodes);

/// K along one front as a linear function of displacements and of tractions on the faces, (FE-54).
struct FrontFunctionals {
  std::vector<FrontStation> stations;  ///< position and place only
  /// Of number 3 * node + mode: the factors on the displacements [by dof].
  std::vector<Vector> of_displacement;
  /// Likewise, the factors on the traction of the side +1 at a node of either face [by dof]; the
  /// side -1 carries the opposite traction.
  std::vector<Vector> of_traction;
  /// K in the order of the functionals, from their values.
  Eigen::MatrixXd to_K;
};
[[nodiscard]] FrontFunctionals front_functionals(const Space& space, std::size_t front);

}  // namespace strainwave::fem::solid
