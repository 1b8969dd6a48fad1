// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "space.hpp"

namespace strainwave::fem::solid {

/// The fields that the problem requests under a load, for this rank's cells or for all cells.
[[nodiscard]] SampledFields sampled_fields(const Space& space, const SolidLoad& load,
                                           const Vector& u);

}  // namespace strainwave::fem::solid
