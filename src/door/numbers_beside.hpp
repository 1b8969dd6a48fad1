// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// The numbers of the files beside a drive as text with all their bits.  A checkpoint compares
/// them.
[[nodiscard]] std::string numbers_beside(const GearSet& gear);

}  // namespace strainwave
