// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace strainwave {

/// The text of data/materials.toml; written at build time from material_data.cpp.in.
[[nodiscard]] std::string_view material_data();

}  // namespace strainwave
