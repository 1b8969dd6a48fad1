// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// How the values of a sweep follow on each other.
enum class Spacing {
  linear,       ///< equal differences
  logarithmic,  ///< equal ratios; both ends have one sign
};
template <>
struct EnumNames<Spacing> {
  static constexpr std::array<std::string_view, 2> names = {"linear", "logarithmic"};
};

/// The sequence of values of one number of the gear.
struct Variation {
  std::string path;   ///< path of the number: "output_shaft.crack[0].depth"
  double from = 0.0;  ///< first value [unit of the field]
  double to = 0.0;    ///< last value [unit of the field]; may be smaller than `from`
  int n_points = 0;   ///< >= 2
  Spacing spacing = Spacing::linear;  ///< equal differences or equal ratios

  /// Value i of 0 .. n_points - 1; the first value is exactly `from`, the last exactly `to`.
  [[nodiscard]] double value(int i) const;
};

/// Largest number of points of one sweep.
inline constexpr int kMaxSweepPoints = 100'000;

/// Reads "PATH=FROM..TO:N" or "PATH=FROM..TO:N:log", such as
/// "output_shaft.crack[0].depth=0.05 mm..8 mm:60:log".
///
/// FROM and TO have units; pure numbers are bare.  Both may lie outside the range of the field,
/// because a sweep reports the points that are refused.
///
/// @param gear    drive that has the number
/// @param text    path, range and number of points, 2 to kMaxSweepPoints, in the form above
/// @param option  name of the option in messages
/// @throws InputError  if the path does not name a number of `gear`, or the text has another form
[[nodiscard]] Variation parse_variation(const GearSet& gear, std::string_view text,
                                        std::string_view option = "--vary");

/// Checks a variation.
/// @throws InputError  unless both ends are finite and different, the number of points is 2 to
///                     kMaxSweepPoints, and a logarithmic range neither reaches nor crosses 0
void check_variation(const Variation& variation, std::string_view option = "--vary");

}  // namespace strainwave
