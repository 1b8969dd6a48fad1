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

/// Strength of a layer under a stress of one kind, all > 0 [Pa].
struct PlyStrength {
  double fibre_tension = 0.0;
  double fibre_compression = 0.0;
  double transverse_tension = 0.0;
  double transverse_compression = 0.0;
  double shear = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto stress = [&](std::string_view name, std::string_view doc, std::string_view example,
                            auto member) {
      field(Field{.name = name,
                  .unit = "Pa",
                  .doc = doc,
                  .range = kPositive,
                  .example = example,
                  .usual = {.lower = 1e6, .upper = 1e10}},
            member);
    };
    stress("fibre_tension", "tensile strength along the fibres", R"("1500 MPa")",
           &PlyStrength::fibre_tension);
    stress("fibre_compression", "compressive strength along the fibres, as a positive number",
           R"("1500 MPa")", &PlyStrength::fibre_compression);
    stress("transverse_tension", "tensile strength across the fibres", R"("40 MPa")",
           &PlyStrength::transverse_tension);
    stress("transverse_compression", "compressive strength across the fibres, as a positive number",
           R"("246 MPa")", &PlyStrength::transverse_compression);
    stress("shear", "strength in shear along the fibres", R"("68 MPa")", &PlyStrength::shear);
  }
};

}  // namespace strainwave
