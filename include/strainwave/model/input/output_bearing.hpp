// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The crossed roller or four-point bearing that carries the output.
struct OutputBearing {
  double dynamic_rating = 0.0;  ///< C [N]; > 0
  double pitch_diameter = 0.0;  ///< d_p of the rollers [m]; > 0
  double load_factor = 1.5;     ///< f_w of shocks [-]; >= 1

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "dynamic_rating",
                .unit = "N",
                .doc = "basic dynamic load rating C",
                .range = kPositive,
                .example = R"("11.4 kN")"},
          &OutputBearing::dynamic_rating);
    field(Field{.name = "pitch_diameter",
                .unit = "m",
                .doc = "pitch diameter d_p of the rollers",
                .range = kPositive,
                .example = R"("85 mm")"},
          &OutputBearing::pitch_diameter);
    field(Field{.name = "load_factor",
                .unit = "1",
                .doc = "f_w: 1 to 1.2 without shocks, 1.2 to 1.5 in normal use, 1.5 to 3 with "
                       "shocks",
                .range = {.lower = 1.0, .lower_open = false},
                .example = "1.5",
                .fallback = "1.5"},
          &OutputBearing::load_factor);
  }
};

}  // namespace strainwave
