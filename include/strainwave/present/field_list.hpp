// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "strainwave/present/schema.hpp"

namespace strainwave {

/// A field of a described type that holds a value.
struct ListedField {
  /// `[]` stands for each element of a list, `<name>` for each name of a map.
  std::string path;
  Field field;
  std::string values;  ///< values that the field may have, in words; empty if the unit is enough
  std::string kind;    ///< name of an alternative, to which the following fields belong; else empty
};

/// The fields of a described type, in their order.
[[nodiscard]] std::vector<ListedField> list_of_fields(TypeWalk walk);

/// Whether a path that somebody wrote is a path of a list: "flexspline.crack[0].depth" and
/// "crack.depth" are "flexspline.crack[].depth", and "material.steel.yield_strength" is
/// "material.<name>.yield_strength".
[[nodiscard]] bool is_path(std::string_view written, std::string_view listed);

}  // namespace strainwave
