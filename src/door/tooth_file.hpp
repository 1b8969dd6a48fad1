// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "strainwave/door/door.hpp"
#include "strainwave/study/transmission_report.hpp"

namespace strainwave {

/// Files of the measured teeth of both parts, as options of a command.
struct ToothFiles {
  std::optional<std::string> flexspline_teeth;
  std::optional<std::string> spline_teeth;

  /// @param field  visits the options of a command that has them
  template <class Options, class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "flexspline_teeth",
           .unit = "",
           .doc = "measured teeth of the flexspline: CSV with a row for each tooth and the columns "
                  "position and thickness, deviations with their units; one column is enough",
           .names = "history"},
          &Options::flexspline_teeth);
    field({.name = "spline_teeth",
           .unit = "",
           .doc = "measured teeth of the circular spline, likewise",
           .names = "history"},
          &Options::spline_teeth);
  }
};

/// The measured teeth that a command names, without their gap; absent: it names none.
/// @throws InputError  if a file has a wrong number of rows, or no column position or thickness
[[nodiscard]] std::optional<Deviations> measured_teeth(const Request& request,
                                                       const ToothFiles& files);

}  // namespace strainwave
