// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace strainwave {

/// The version of the library, as in CITATION.cff: "1.2.3".
[[nodiscard]] std::string_view version();

/// The git revision the library was built from, as `git describe --always --dirty` prints it;
/// "unknown" if it was not built in a git checkout or without git.
[[nodiscard]] std::string_view git_revision();

}  // namespace strainwave
