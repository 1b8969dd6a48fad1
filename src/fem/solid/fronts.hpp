// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact.hpp"
#include "space.hpp"

namespace strainwave::fem::solid {

/// Fracture quantities of one crack front.
/// @param contact  contact of the crack faces; null if they do not touch
/// @param front    number of the front in the mesh
/// @throws InputError  if fewer than three rings of cells surround the front
[[nodiscard]] CrackFront evaluate_front(const Space& space, const Vector& u, const Contact* contact,
                                        std::size_t front);

}  // namespace strainwave::fem::solid
