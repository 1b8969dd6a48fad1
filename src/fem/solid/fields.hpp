// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "space.hpp"

namespace strainwave::fem::solid {

/// The fields that the problem asks for, of this rank's cells or of all.
[[nodiscard]] SampledFields sampled_fields(const Space& space, const Vector& u);

}  // namespace strainwave::fem::solid
