// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Tolerances of the parts of the coupled drive (TC-36).  They do not scale with the deflection.
struct Tolerance {
  int grade = 5;  ///< class of flexspline and circular spline by ISO 1328-1:2013 [-]; 1 to 11
  /// standard deviation of the thickness of the teeth along the pitch circle [m]; absent: a third
  /// of the single pitch deviation, as of flanks that deviate independently
  std::optional<double> thickness_deviation;
  double run_out = 5e-6;  ///< full reading of the run-out of the cam against the bearing [m]
  double ball_variation = 0.25e-6;  ///< standard deviation of the diameters of the balls [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "grade",
                .unit = "1",
                .doc = "tolerance class of flexspline and circular spline by ISO 1328-1; it "
                       "limits the deviations of the pitch",
                .range = {.lower = 1.0, .lower_open = false, .upper = 11.0, .upper_open = false},
                .example = "5",
                .fallback = "5",
                .usual = {.lower = 3.0, .upper = 8.0}},
          &Tolerance::grade);
    field(Field{.name = "thickness_deviation",
                .unit = "m",
                .doc = "standard deviation of the thickness of the teeth along the pitch circle; "
                       "a third of the single pitch deviation if left out",
                .range = kNonNegative,
                .example = R"("1.7 um")",
                .in_template = InTemplate::commented},
          &Tolerance::thickness_deviation);
    field(Field{.name = "run_out",
                .unit = "m",
                .doc = "full reading of the radial run-out of the cam against the bearing, twice "
                       "the eccentricity",
                .range = {.lower = 0.0, .lower_open = false, .upper = 20e-6, .upper_open = false},
                .example = R"("5 um")",
                .fallback = R"("5 um")"},
          &Tolerance::run_out);
    field(Field{.name = "ball_variation",
                .unit = "m",
                .doc = "standard deviation of the diameters of the balls",
                .range = {.lower = 0.0, .lower_open = false, .upper = 5e-6, .upper_open = false},
                .example = R"("0.25 um")",
                .fallback = R"("0.25 um")"},
          &Tolerance::ball_variation);
  }
};

}  // namespace strainwave
