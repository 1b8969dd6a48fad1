// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "strainwave/core/fields.hpp"

/// @file
/// The layers of a laminate, as an input file describes them.

namespace strainwave {

/// A layer of a laminate.
struct Ply {
  std::string material;    ///< a [material] or a record of the library: isotropic, or a layer
  double angle = 0.0;      ///< of the fibres, measured like the angle of a crack [rad]
  double thickness = 0.0;  ///< [m]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "material",
                .unit = "",
                .doc = "name of a [material] with transverse_modulus, of an isotropic one, or of a "
                       "record of the library",
                .example = R"("T300/5208")"},
          &Ply::material);
    field(Field{.name = "angle",
                .unit = "rad",
                .doc = "direction of the fibres, measured like the angle of a crack",
                .range = {.lower = -1.5707963267948966,
                          .lower_open = false,
                          .upper = 1.5707963267948966,
                          .upper_open = false},
                .example = R"("45 deg")"},
          &Ply::angle);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "thickness of the layer; the plies share the wall in proportion to it",
                .range = kPositive,
                .example = R"("0.125 mm")",
                .usual = {.lower = 1e-5, .upper = 0.05}},
          &Ply::thickness);
  }
};

/// How the list of plies fills the wall.
enum class Stacking {
  as_listed,  ///< from the inner face to the outer one
  symmetric,  ///< the list, and once more in reverse
};
template <>
struct EnumNames<Stacking> {
  static constexpr std::array<std::string_view, 2> names = {"as_listed", "symmetric"};
};

}  // namespace strainwave
