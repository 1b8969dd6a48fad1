// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/crack.hpp"

namespace strainwave {

/// Circular spline: a ring in a housing; flank forces deform the ring to an oval (TC-10).
struct CircularSpline {
  std::string material;
  double outer_diameter = 0.0;  ///< [m]; > inner_diameter
  double inner_diameter = 0.0;  ///< diameter at the roots of the teeth [m]; > drive.pitch_diameter
  double width = 0.0;           ///< axial [m]; > 0
  /// Support s_h [-]: share of the free ring's compliance that remains in the housing; 0 rigid, 1
  /// free.
  double support = 0.0;
  std::vector<CircularSplineCrack> crack;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "material",
                .unit = "",
                .doc = "name of a [material], or of a record of the library",
                .example = R"("steel")"},
          &CircularSpline::material);
    field(Field{.name = "outer_diameter",
                .unit = "m",
                .doc = "outer diameter",
                .range = kPositive,
                .example = R"("214 mm")"},
          &CircularSpline::outer_diameter);
    field(Field{.name = "inner_diameter",
                .unit = "m",
                .doc = "diameter at the roots of the teeth",
                .range = kPositive,
                .example = R"("163.4 mm")"},
          &CircularSpline::inner_diameter);
    field(Field{.name = "width",
                .unit = "m",
                .doc = "axial width",
                .range = kPositive,
                .example = R"("25 mm")"},
          &CircularSpline::width);
    field(
        Field{
            .name = "support",
            .unit = "1",
            .doc =
                "s_h, share of the free ring's compliance that remains in the housing; 0 is rigid",
            .range = {.lower = 0.0, .lower_open = false, .upper = 1.0, .upper_open = false},
            .example = "0.5"},
        &CircularSpline::support);
    field(Field{.name = "crack", .unit = "", .doc = "cracks in the ring"}, &CircularSpline::crack);
  }
};

}  // namespace strainwave
