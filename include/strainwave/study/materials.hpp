// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/materials/material_library.hpp"

namespace strainwave {

/// Records of the material library with the sources that they cite.
struct MaterialData {
  std::vector<MaterialRecord> material;
  std::map<std::string, std::string> source;  ///< publications by key

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"material", "", "the records"}, &MaterialData::material);
    field({"source", "", "publications that the records cite, by key"}, &MaterialData::source);
  }
};

/// The built-in records, or only those for one use if it is given.
[[nodiscard]] MaterialData material_list(std::optional<MaterialUse> use = std::nullopt);

/// The record of one steel.
/// @throws InputError  if the library lacks a steel of that name
[[nodiscard]] MaterialData material_show(std::string_view name);

}  // namespace strainwave
