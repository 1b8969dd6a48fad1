// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace strainwave {

/// Text as XML wants it; control characters, which XML has no place for, become blanks.
[[nodiscard]] std::string svg_text(std::string_view text);

/// "10⁻⁵"
[[nodiscard]] std::string power_of_ten(int exponent);

}  // namespace strainwave
