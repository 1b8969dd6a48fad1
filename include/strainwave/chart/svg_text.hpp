// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace strainwave {

/// Text escaped for XML.  Control characters, which XML forbids, become blanks.
[[nodiscard]] std::string svg_text(std::string_view text);

/// A power of ten as text: "10⁻⁵".
[[nodiscard]] std::string power_of_ten(int exponent);

}  // namespace strainwave
