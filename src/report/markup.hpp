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

/// A number for people: `digits` significant ones, a true minus, no exponent where that is short.
[[nodiscard]] std::string number(double value, int digits = 4);

/// A length in mm with its unit: "0.755 mm".
[[nodiscard]] std::string in_mm(double metres);

/// The base unit as it is set: "N·m/arcmin", "MPa·√m".
[[nodiscard]] std::string typeset_unit(std::string_view unit);

}  // namespace strainwave::report
