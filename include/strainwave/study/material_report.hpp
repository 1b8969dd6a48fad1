// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "strainwave/materials/material_library.hpp"

namespace strainwave {

/// The built-in records as a table, at most 100 columns; only those for one use, if it is given.
[[nodiscard]] std::string material_list_text(std::optional<MaterialUse> use = std::nullopt);

/// The built-in records and their sources as a JSON document: SI, every number with its unit,
/// source, confidence and scatter.
[[nodiscard]] std::string material_list_json(std::optional<MaterialUse> use = std::nullopt);

/// The built-in records as a Markdown page, with their sources: docs/guide/materials.md.
[[nodiscard]] std::string material_list_markdown(std::optional<MaterialUse> use = std::nullopt);

/// All that is known of one steel, at most 100 columns.
[[nodiscard]] std::string material_text(const MaterialRecord& record);

/// The same as a JSON object.
[[nodiscard]] std::string material_json(const MaterialRecord& record);

}  // namespace strainwave
