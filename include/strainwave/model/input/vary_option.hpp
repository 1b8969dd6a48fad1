// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "strainwave/model/input/gear_set.hpp"

// What the options of sweep, solve and `fe tabulate` have in common.  A fault names the option,
// "--vary" or "--over", and the value.

namespace strainwave {

/// "KEY=VALUE", cut at the last `=`; the value is absent where there is none.
struct Assignment {
  std::string_view key;
  std::string_view value;
  bool has_value = false;
};

/// Blanks round key and value do not count.
[[nodiscard]] Assignment assignment(std::string_view text);

/// Text without blanks at its ends.
[[nodiscard]] std::string_view without_blanks(std::string_view text);

inline constexpr std::string_view kVaryOption = "--vary";

/// The number of the gear that the option names.
/// @throws InputError  if there is none
[[nodiscard]] NumberAt varied_number(const GearSet& gear, std::string_view path,
                                     std::string_view option = kVaryOption);

/// "--vary PATH", to begin an error message with.
[[nodiscard]] std::string vary_option(std::string_view path, std::string_view option = kVaryOption);

struct Interval {
  double from = 0.0;
  double to = 0.0;
};

/// Reads "FROM..TO" in the unit of a number.
/// @throws InputError  if it is anything else, or both ends are the same
[[nodiscard]] Interval parse_interval(const NumberAt& number, std::string_view text,
                                      std::string_view option = kVaryOption);

}  // namespace strainwave
