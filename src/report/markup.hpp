// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

// Text as HTML and SVG want it.

namespace strainwave::report {

/// Text from outside as the content of an element or of a quoted attribute: `<`, `>`, `&` and both
/// quotes as entities; what XML has no place for (control characters, broken UTF-8) as U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// A coordinate on paper [mm], to a micrometre, without trailing zeros.
[[nodiscard]] std::string coordinate(double millimetres);

/// Numbers in a text as people write them: "6.33·10⁻⁶" for "6.33e-06", with a true minus.
[[nodiscard]] std::string typeset(std::string_view text);

/// The label of a row or column of a plain table as HTML: symbols and units are typeset.
[[nodiscard]] std::string label(std::string_view text);

/// A number for people: `digits` significant ones, a true minus, no exponent where that is short.
[[nodiscard]] std::string number(double value, int digits = 4);

/// A length in mm with its unit: "0.755 mm".
[[nodiscard]] std::string in_mm(double metres);

}  // namespace strainwave::report
