// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace strainwave {

/// SHA-256 of bytes in lower-case hexadecimal, as `sha256sum` prints it: 64 digits.
///
/// It ties a report to the file it was made from; it keeps nothing secret.
/// Source: FIPS 180-4 (secondary); held by its published examples and by `sha256sum`.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

}  // namespace strainwave
