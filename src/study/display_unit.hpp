// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>

#include "strainwave/core/units.hpp"

// The units that engineers read: millimetres, degrees, N*m/arcmin.  Files have SI.

namespace strainwave {

/// A unit for people.
struct DisplayUnit {
  std::string_view text;     ///< as `parse_unit` reads it
  std::string_view typeset;  ///< as a figure shows it
  double in_si = 1.0;        ///< divide a value in SI by it
};

/// The unit for an output or a field of this name and SI unit.
[[nodiscard]] inline DisplayUnit display_unit(std::string_view name, std::string_view si) {
  struct Entry {
    std::string_view si;
    DisplayUnit shown;
  };
  static constexpr Entry kShown[] = {
      {"m", {"mm", "mm", units::mm}},
      {"rad", {"deg", "deg", units::deg}},
      {"Pa", {"MPa", "MPa", units::MPa}},
      {"N/m", {"N/mm", "N/mm", units::N / units::mm}},
      {"N*m", {"N*m", "N·m", 1.0}},
      {"N*m/rad", {"N*m/arcmin", "N·m/arcmin", 1 / units::arcmin}},
      {"rad/(N*m)", {"rad/(N*m)", "rad/(N·m)", 1.0}},
      {"Pa*m^0.5", {"MPa*m^0.5", "MPa·√m", units::MPa}},
  };
  if (name.ends_with("wind_up")) return {"arcmin", "arcmin", units::arcmin};
  if (name.ends_with("_change")) return {"%", "%", 0.01};
  const auto* const found = std::ranges::find(kShown, si, &Entry::si);
  return found != std::end(kShown) ? found->shown : DisplayUnit{si, si, 1.0};
}

}  // namespace strainwave
