// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace strainwave {

/// A number over time by straight lines between points; constant before the first point and behind
/// the last.
struct Profile {
  std::vector<double> time = {};   ///< [s]; rising
  std::vector<double> value = {};  ///< as many; a single one without time is a constant

  /// The number at a time [s].
  [[nodiscard]] double at(double time) const;
  [[nodiscard]] double slope(double time) const;  ///< behind the time [1/s]
  /// From the time 0; the value's unit times [s].
  [[nodiscard]] double integral(double time) const;
};

/// Throws InputError, which names the number, unless the profile has as many finite values as
/// rising times.
/// @param profile  to be checked
/// @param name     of the profile in messages
void require_constants(const Profile& profile, const std::string& name);

}  // namespace strainwave
