// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "strainwave/core/asked_units.hpp"
#include "strainwave/core/quantity.hpp"

/// @file
/// Numbers and text for people, with few digits and in the units of engineering drawings.  Files
/// use SI units and all digits.

namespace strainwave {

/// Width of the text that strainwave writes, in columns.
inline constexpr std::size_t kTextWidth = 100;

/// Text broken at spaces to `width` columns; lines after the first are indented.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

/// A paragraph of text, broken to `kTextWidth` columns and ended by a line feed.  Lines after the
/// first are indented by `hanging` more blanks.
[[nodiscard]] std::string paragraph(std::string_view text, std::size_t indent = 0,
                                    std::size_t hanging = 2);

/// A number with the given count of significant digits, without an exponent if that is short
/// enough.
[[nodiscard]] std::string shown_number(double value, int digits = 4);

/// A share, such as 0.05, as "5 %".
[[nodiscard]] std::string percent(double share, int digits = 2);
/// A change, such as -0.0123, as "-1.23 %".  A change below rounding gives "0 %".
[[nodiscard]] std::string percent_change(double change);

/// A number with two digits more than its relative uncertainty warrants.
[[nodiscard]] std::string warranted_digits(const Quantity& quantity);
/// One standard relative uncertainty such as "5 %"; "none" if it cannot be stated, "-" for a zero.
[[nodiscard]] std::string accuracy_text(const Quantity& quantity);

/// The display unit for an output or field with this name and SI unit: the unit that the caller
/// asked for, or the usual unit of engineering drawings.
[[nodiscard]] DisplayUnit display_unit(std::string_view name, std::string_view si);
/// The unit for a place with its own usual unit: the unit that was asked for, otherwise the usual
/// unit.
[[nodiscard]] DisplayUnit display_unit(std::string_view name, std::string_view si,
                                       const DisplayUnit& usual);

/// A value in its display unit: "2 mm", "210 GPa".
/// @param value   [si]
/// @param si      SI unit of the value, such as "Pa"; "1" for a pure number
/// @param digits  number of significant digits; >= 1
/// @param name    name of the output or field, which may determine the unit; empty: none
[[nodiscard]] std::string shown_quantity(double value, std::string_view si, int digits = 5,
                                         std::string_view name = {});

/// A unit as typeset in a figure: "N·m/arcmin", "MPa·√m"; empty for a pure number.
[[nodiscard]] std::string typeset_unit(std::string_view unit);

}  // namespace strainwave
