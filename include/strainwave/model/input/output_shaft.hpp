// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/crack.hpp"

namespace strainwave {

/// The shaft between flexspline and load, solid or hollow, and cracks in its outer surface.
struct OutputShaft {
  std::string material;
  double outer_diameter = 0.0;  ///< D [m]; > 0
  double inner_diameter = 0.0;  ///< d [m]; >= 0, < D; 0 for a solid shaft
  double length = 0.0;          ///< L_s [m]; > 0
  std::vector<OutputShaftCrack> crack;

  /// Whether the shaft has no bore.
  [[nodiscard]] bool solid() const { return inner_diameter == 0.0; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "material",
                .unit = "",
                .doc = "name of a [material], or of a record of the library",
                .example = R"("steel")"},
          &OutputShaft::material);
    field(Field{.name = "outer_diameter",
                .unit = "m",
                .doc = "outer diameter",
                .range = kPositive,
                .example = R"("70 mm")"},
          &OutputShaft::outer_diameter);
    field(Field{.name = "inner_diameter",
                .unit = "m",
                .doc = "bore; 0 is a solid shaft",
                .range = kNonNegative,
                .example = R"("45 mm")",
                .fallback = R"("0 m")"},
          &OutputShaft::inner_diameter);
    field(Field{.name = "length",
                .unit = "m",
                .doc = "length L_s",
                .range = kPositive,
                .example = R"("200 mm")"},
          &OutputShaft::length);
    field(Field{.name = "crack", .unit = "", .doc = "cracks in the outer surface"},
          &OutputShaft::crack);
  }
};

}  // namespace strainwave
