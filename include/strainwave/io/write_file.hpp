// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace strainwave {

/// Writes a file whole or not at all: the text goes to a file beside it, which then takes its name.
/// @throws Error  if it cannot be written; nothing is left behind
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace strainwave
