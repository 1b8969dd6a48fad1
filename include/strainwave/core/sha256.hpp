// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace strainwave {

/// SHA-256 of bytes in lower-case hexadecimal, as `sha256sum` prints it: 64 digits.
///
/// The digest ties a report to its input file; it does not serve security.  Source: FIPS 180-4
/// (secondary); tested by the published examples and by `sha256sum`.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

}  // namespace strainwave
