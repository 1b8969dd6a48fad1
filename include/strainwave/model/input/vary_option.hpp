// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "strainwave/model/input/gear_set.hpp"

// Parts shared by the options of sweep, solve and `fe tabulate`.  A message names the option,
// "--vary" or "--over", and the value.

namespace strainwave {

/// The text "KEY=VALUE" split at the last `=`; the value is absent without `=`.
struct Assignment {
  std::string_view key;    ///< text before the `=`, or the whole text
  std::string_view value;  ///< text behind the `=`
  bool has_value = false;  ///< whether there is a `=`
};

/// Splits "KEY=VALUE" and removes blanks round key and value.
[[nodiscard]] Assignment assignment(std::string_view text);

/// The text without blanks at its ends.
[[nodiscard]] std::string_view without_blanks(std::string_view text);

/// The option that messages name, unless the caller states another one.
inline constexpr std::string_view kVaryOption = "--vary";

/// The number of the gear that the option names.
/// @throws InputError  if it does not exist
[[nodiscard]] NumberAt varied_number(const GearSet& gear, std::string_view path,
                                     std::string_view option = kVaryOption);

/// The beginning of an error message: "--vary PATH".
[[nodiscard]] std::string vary_option(std::string_view path, std::string_view option = kVaryOption);

/// Both ends of a sweep.
struct Interval {
  double from = 0.0;  ///< first value [SI unit of the number]
  double to = 0.0;    ///< last value [SI unit of the number]; not equal to `from`
};

/// Reads "FROM..TO" in the unit of a number.
/// @throws InputError  if the text has another form, or both ends are equal
[[nodiscard]] Interval parse_interval(const NumberAt& number, std::string_view text,
                                      std::string_view option = kVaryOption);

}  // namespace strainwave
