// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "space.hpp"

namespace strainwave::fem::solid {

/// The fields that the problem requests, for this rank's cells or for all cells.
[[nodiscard]] SampledFields sampled_fields(const Space& space, const Vector& u);

}  // namespace strainwave::fem::solid
