// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// A drive as an input file: `read_gear_set` gives back the same drive, to the last bit.
///
/// Quantities are in the units of drawings where that loses nothing: "2.24 mm" rather than
/// "0.00224 m".  Fields that may be left out, and have the value that they then get, are left out
/// unless there is a comment for them.
///
/// @param comments  by the path of a field, one line each
[[nodiscard]] std::string gear_text(const GearSet& gear,
                                    const std::map<std::string, std::string>& comments = {});

}  // namespace strainwave
