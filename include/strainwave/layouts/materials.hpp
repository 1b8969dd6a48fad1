// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/study/materials.hpp"

namespace strainwave {

/// The records as a table, at most 100 columns wide.
[[nodiscard]] std::string material_list_text(const MaterialData& data);

/// The records as a Markdown page, with their sources: docs/guide/materials.md.
[[nodiscard]] std::string material_list_markdown(const MaterialData& data);

/// All fields of the first record, at most 100 columns wide.
[[nodiscard]] std::string material_text(const MaterialData& data);

}  // namespace strainwave
