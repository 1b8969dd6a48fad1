// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace strainwave {

/// Exponents of (length, mass, time, temperature, angle, energy tag).
///
/// The last two are not physical dimensions.  They exist *in text only* and make units stricter
/// than SI.  An angle is not a pure number, so "Hz" is refused for "rad/s" and "N*m" for "N*m/rad".
/// A joule carries a tag, so "J" is refused for a torque.
using Dimension = std::array<double, 6>;

/// A unit written in text, such as "N*m/rad", "MPa*m^0.5", "1/(N*m)" or "1".
struct Unit {
  double factor = 1.0;       ///< value in strainwave units = factor * value in this unit
  Dimension dimension = {};  ///< exponents of the base units that make up the unit
  /// The exponent of the factor if the factor is a power of ten.  Such a unit moves the decimal
  /// point exactly.
  std::optional<int> power_of_ten = 0;
};

/// A unit that texts can name.
struct KnownUnit {
  std::string_view symbol;    ///< as texts spell it: "rpm"
  Unit unit;                  ///< factor and dimension, without a prefix
  std::string_view kind;      ///< "length"
  bool takes_prefix = false;  ///< those of unit_prefixes
};

/// A prefix of units: "k" for 10^3.
struct UnitPrefix {
  std::string_view symbol;  ///< as texts spell it, before the symbol of the unit
  int power = 0;            ///< of ten
};

/// All units that `parse_unit` knows, without prefixes.
[[nodiscard]] std::span<const KnownUnit> known_units();
/// All prefixes that `parse_unit` knows.
[[nodiscard]] std::span<const UnitPrefix> unit_prefixes();

/// Whether values of one unit can be converted to the other.
[[nodiscard]] bool same_dimension(const Unit& a, const Unit& b);

/// Reads a product of known units with `*`, `/`, `^` and parentheses, or as it is typeset: "N·m",
/// "MPa·√m", "m²", "°".
/// @throws InputError if `text` is anything else.
[[nodiscard]] Unit parse_unit(std::string_view text);

/// Reads "12.5 kN*m" as a double in strainwave units.
///
/// @param field  name used in the error message
/// @param text   a number and a unit; the unit may be left out only if `unit` is "1"
/// @param unit   the unit the model expects; `text` must have its dimension
/// @return       the value in strainwave units (m, kg, s, K, rad); always finite
/// @throws InputError if the text does not parse, has another dimension, or is not finite.
[[nodiscard]] double parse_quantity(std::string_view field, std::string_view text,
                                    std::string_view unit);

/// The number of a value in a unit, in the shortest digits that `parse_quantity` reads back; the
/// nearest number if none in this unit reads back to the value.
/// @param value  in strainwave units
/// @param unit   unit of the number; of the dimension of the value, which is not checked
[[nodiscard]] std::string number_in(double value, const Unit& unit);

/// Writes a value so that `parse_quantity` reads back the same double: "0.00224 m".
[[nodiscard]] std::string quantity_text(double value, std::string_view unit);

}  // namespace strainwave
