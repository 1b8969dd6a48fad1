// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

// Text in the form that HTML and SVG require.

namespace strainwave::report {

/// Foreign text as the content of an element or of a quoted attribute.  `<`, `>`, `&` and both
/// quotes become entities; characters that XML forbids (control characters, broken UTF-8) become
/// U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// A coordinate on paper [mm], rounded to a micrometre, without trailing zeros.
[[nodiscard]] std::string coordinate(double millimetres);

/// A text with its numbers typeset: "6.33·10⁻⁶" for "6.33e-06", with a typographic minus sign.
[[nodiscard]] std::string typeset(std::string_view text);

/// The label of a row or column of a plain table as HTML: symbols and units are typeset.
[[nodiscard]] std::string label(std::string_view text);

/// A number for people with `digits` significant digits, a typographic minus sign, and without an
/// exponent if that is short enough.
[[nodiscard]] std::string number(double value, int digits = 4);

/// A quantity in its display unit, typeset: "1.2·10⁷ N·m".
[[nodiscard]] std::string typeset_quantity(double value, std::string_view si, int digits = 4);

/// A length with its unit, in mm unless another unit is asked for: "0.755 mm".
[[nodiscard]] std::string in_mm(double metres);

}  // namespace strainwave::report
