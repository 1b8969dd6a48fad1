// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/present/schema.hpp"

namespace strainwave {

/// The fields of a described type as a Markdown table: path, unit, meaning and allowed values.
/// `[]` stands for each element of a list, `<name>` for each name of a map.
[[nodiscard]] std::string fields_reference(TypeWalk walk);

}  // namespace strainwave
