// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/model/input/crack.hpp"

namespace strainwave {

/// How a flexspline ends toward the output.
enum class FlexsplineShape {
  cup,       ///< diaphragm inward, to a boss
  hat,       ///< silk hat: diaphragm outward, to a clamped flange that is the output
  cylinder,  ///< no diaphragm
};
template <>
struct EnumNames<FlexsplineShape> {
  static constexpr std::array<std::string_view, 3> names = {"cup", "hat", "cylinder"};
};

/// Source of the compliance of the sound flexspline.
enum class CrackFree {
  factor,    ///< tube multiplied by an empirical factor (ST-4)
  sections,  ///< rim, barrel, diaphragm and boss in series (ST-2, ST-3)
};
template <>
struct EnumNames<CrackFree> {
  static constexpr std::array<std::string_view, 2> names = {"factor", "sections"};
};

/// The usual thickness of walls and rings [m].
inline constexpr Range kUsualThickness{.lower = 5e-5, .upper = 0.2};

/// Field of the material of one section of a flexspline.
inline constexpr Field kSectionMaterial{
    .name = "material",
    .unit = "",
    .doc = "material of this section; that of the flexspline if left out",
    .example = R"("steel")",
    .in_template = InTemplate::commented};

/// A round tube: rim or barrel of a flexspline.
struct TubeSection {
  double outer_diameter = 0.0;  ///< D [m]; > 0
  double wall_thickness = 0.0;  ///< t [m]; > 0, < D/2
  double length = 0.0;          ///< L [m]; > 0
  /// absent: that of the flexspline
  std::optional<std::string> material = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kSectionMaterial, &TubeSection::material);
    field(Field{.name = "outer_diameter",
                .unit = "m",
                .doc = "outer diameter",
                .range = kPositive,
                .example = R"("160 mm")"},
          &TubeSection::outer_diameter);
    field(Field{.name = "wall_thickness",
                .unit = "m",
                .doc = "wall thickness",
                .range = kPositive,
                .example = R"("2.24 mm")",
                .usual = kUsualThickness},
          &TubeSection::wall_thickness);
    field(Field{.name = "length",
                .unit = "m",
                .doc = "length",
                .range = kPositive,
                .example = R"("80 mm")"},
          &TubeSection::length);
  }
};

/// The hub of a cup.
struct Boss : TubeSection {
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kSectionMaterial, &Boss::material);
    field(Field{.name = "outer_diameter",
                .unit = "m",
                .doc = "outer diameter, where the diaphragm begins",
                .range = kPositive,
                .example = R"("80 mm")"},
          &Boss::outer_diameter);
    field(Field{.name = "wall_thickness",
                .unit = "m",
                .doc = "wall thickness, measured from the bore of the hub",
                .range = kPositive,
                .example = R"("20 mm")",
                .usual = kUsualThickness},
          &Boss::wall_thickness);
    field(Field{.name = "length",
                .unit = "m",
                .doc = "length",
                .range = kPositive,
                .example = R"("10 mm")"},
          &Boss::length);
  }
};

/// Thickness of a diaphragm at one radius.
struct DiaphragmStation {
  double radius = 0.0;     ///< r [m]; > 0
  double thickness = 0.0;  ///< h(r) [m]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "radius",
                .unit = "m",
                .doc = "radius, rising from station to station",
                .range = kPositive,
                .example = R"("42 mm")"},
          &DiaphragmStation::radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "thickness there",
                .range = kPositive,
                .example = R"("4 mm")"},
          &DiaphragmStation::thickness);
  }
};

/// The bottom of a cup or a hat: a flat annular plate, twisted in its plane.
struct Diaphragm {
  /// diameter at the barrel of a cup, at the flange of a hat [m]; > inner_diameter
  double outer_diameter = 0.0;
  /// diameter at the boss of a cup, at the barrel of a hat [m]; > 0
  double inner_diameter = 0.0;
  double thickness = 0.0;  ///< h, constant, or with a profile at the outer diameter [m]; > 0
  /// Law of the thickness: constant inside the first station, then linear between the stations and
  /// on to the outer diameter; empty: constant thickness.
  std::vector<DiaphragmStation> profile;
  /// absent: that of the flexspline
  std::optional<std::string> material = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kSectionMaterial, &Diaphragm::material);
    field(Field{.name = "outer_diameter",
                .unit = "m",
                .doc = "cup: diameter at which the diaphragm meets the barrel, the middle of the "
                       "barrel's wall; hat: diameter at which the flange begins",
                .range = kPositive,
                .example = R"("157.76 mm")"},
          &Diaphragm::outer_diameter);
    field(
        Field{.name = "inner_diameter",
              .unit = "m",
              .doc =
                  "cup: diameter at which the diaphragm meets the boss, the outer diameter of the "
                  "boss; hat: diameter at which the diaphragm meets the barrel, the middle of the "
                  "barrel's wall",
              .range = kPositive,
              .example = R"("80 mm")"},
        &Diaphragm::inner_diameter);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "constant thickness; with a profile, the thickness at the outer diameter",
                .range = kPositive,
                .example = R"("3 mm")",
                .usual = kUsualThickness},
          &Diaphragm::thickness);
    field(
        Field{.name = "profile",
              .unit = "",
              .doc = "thickness at several radii: constant up to the first radius, then linear to "
                     "the next radius and to the outer diameter",
              .in_template = InTemplate::commented},
        &Diaphragm::profile);
  }
};

/// Thickness of a diaphragm at a radius [m], by its profile.
[[nodiscard]] double diaphragm_thickness(const Diaphragm& diaphragm, double radius);

/// Thickness in the scalar of a lift.  At a station, the derivative is that on its inner side.
template <class Real>
[[nodiscard]] Real diaphragm_thickness(const Lift<Real>& lift, const Diaphragm& diaphragm,
                                       const Real& radius) {
  if (diaphragm.profile.empty()) return lift(diaphragm.thickness);
  struct Station {
    Real radius;
    Real thickness;
  };
  const auto station = [&](const DiaphragmStation& given) {
    return Station{lift(given.radius), lift(given.thickness)};
  };
  const auto between = [&](const Station& inside, const Station& outside) -> Real {
    const Real s = (radius - inside.radius) / (outside.radius - inside.radius);
    return inside.thickness + s * (outside.thickness - inside.thickness);
  };
  const DiaphragmStation* inside = &diaphragm.profile.front();
  if (radius <= inside->radius) return lift(inside->thickness);
  for (const DiaphragmStation& given : diaphragm.profile) {
    if (radius <= given.radius) return between(station(*inside), station(given));
    inside = &given;
  }
  const Station edge{lift(diaphragm.outer_diameter) / 2, lift(diaphragm.thickness)};
  return radius < edge.radius ? between(station(*inside), edge) : edge.thickness;
}

/// The roots of the flexspline's teeth, for their fatigue (LI-41, LI-42).
struct ToothRoot {
  double height = 0.0;                   ///< h_f, from the root up to the pitch height [m]; > 0
  double root_radius = 0.0;              ///< rho_F of the fillet at the root [m]; > 0
  std::optional<double> thickness = {};  ///< s_F of the tooth at its root [m]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "height",
                .unit = "m",
                .doc = "height of the pitch point above the root of the tooth",
                .range = kPositive,
                .example = R"("0.9 mm")"},
          &ToothRoot::height);
    field(Field{.name = "root_radius",
                .unit = "m",
                .doc = "radius of the fillet at the root",
                .range = kPositive,
                .example = R"("0.4 mm")"},
          &ToothRoot::root_radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "thickness of the tooth at its root; if left out, that of straight flanks "
                       "at mesh.flank_angle",
                .range = kPositive,
                .example = R"("1.6 mm")",
                .in_template = InTemplate::commented},
          &ToothRoot::thickness);
  }
};

/// The flexspline: cup, cylinder or hat, and its cracks.
struct Flexspline {
  std::string material;
  FlexsplineShape shape = FlexsplineShape::cup;
  /// Wall thickness delta at the tooth ring [m]; > 0. `factor` needs this field; with `sections`
  /// the rim gives the thickness.
  std::optional<double> wall_thickness = {};
  /// L [m]; > 0.  `factor` needs this field; with `sections` rim and barrel give the length.
  std::optional<double> length = {};
  CrackFree crack_free = CrackFree::factor;
  /// k of `factor` [-]; absent: 0.83 for a cup, 1 for a cylinder
  std::optional<double> shape_factor;
  double stress_nonuniformity = 1.0;   ///< K_u, multiplies the shear stress of torque [-]; > 0
  double dynamic_load = 1.0;           ///< K_d; read by the article's methods only [-]; > 0
  std::optional<TubeSection> rim;      ///< rim, for `sections`
  std::optional<TubeSection> barrel;   ///< barrel, for `sections`
  std::optional<Diaphragm> diaphragm;  ///< diaphragm, for `sections`
  std::optional<Boss> boss;            ///< boss, for `sections`
  /// compliance of boss bolts and output flange [rad/(N*m)]; >= 0
  double flange_compliance = 0.0;
  /// compliance of the joint between a rim and a barrel of two materials [rad/(N*m)]; >= 0
  double joint_compliance = 0.0;
  std::optional<ToothRoot> tooth_root = {};  ///< roots of the teeth, for their fatigue
  std::vector<FlexsplineCrack> crack;

  /// Length of the toothed and the smooth tube together [m].
  [[nodiscard]] double tube_length() const {
    return crack_free == CrackFree::factor ? *length : (rim ? rim->length : 0.0) + barrel->length;
  }
  /// Thickness of the wall that the wave generator bends, which is the rim if there is one [m].
  [[nodiscard]] const double& ring_thickness() const {
    if (crack_free == CrackFree::factor) return *wall_thickness;
    return rim ? rim->wall_thickness : wall_thickness ? *wall_thickness : barrel->wall_thickness;
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "material",
                .unit = "",
                .doc = "name of a [material], or of a record of the library",
                .example = R"("steel")"},
          &Flexspline::material);
    field(Field{.name = "shape",
                .unit = "",
                .doc = "cup, hat with the diaphragm outward to a flange (silk hat), or cylinder",
                .example = R"("cup")",
                .fallback = R"("cup")"},
          &Flexspline::shape);
    field(Field{.name = "wall_thickness",
                .unit = "m",
                .doc = "wall thickness delta at the tooth ring; not needed with sections, because "
                       "the rim gives it",
                .range = kPositive,
                .example = R"("2.24 mm")",
                .usual = kUsualThickness},
          &Flexspline::wall_thickness);
    field(Field{.name = "length",
                .unit = "m",
                .doc = "length L of the cylinder; not needed with sections, because rim and barrel "
                       "give it",
                .range = kPositive,
                .example = R"("160 mm")"},
          &Flexspline::length);
    field(Field{.name = "crack_free",
                .unit = "",
                .doc = "compliance of the sound part: from a factor, or from sections",
                .example = R"("factor")",
                .fallback = R"("factor")"},
          &Flexspline::crack_free);
    field(Field{.name = "shape_factor",
                .unit = "1",
                .doc = "k of crack_free = \"factor\"; 0.83 for a cup, 1 for a cylinder if left out",
                .range = kPositive,
                .example = "0.83",
                .in_template = InTemplate::commented},
          &Flexspline::shape_factor);
    field(Field{.name = "stress_nonuniformity",
                .unit = "1",
                .doc = "K_u, multiplies the shear stress of the torque",
                .range = kPositive,
                .example = "1.1",
                .fallback = "1"},
          &Flexspline::stress_nonuniformity);
    field(Field{.name = "dynamic_load",
                .unit = "1",
                .doc = "K_d, read by the methods as-printed and repaired only",
                .range = kPositive,
                .example = "1.2",
                .fallback = "1",
                .in_template = InTemplate::commented},
          &Flexspline::dynamic_load);
    field(Field{.name = "flange_compliance",
                .unit = "rad/(N*m)",
                .doc = "compliance of bolts and output flange, added in series",
                .range = kNonNegative,
                .example = R"x("0 rad/(N*m)")x",
                .fallback = R"x("0 rad/(N*m)")x",
                .in_template = InTemplate::commented},
          &Flexspline::flange_compliance);
    field(Field{.name = "joint_compliance",
                .unit = "rad/(N*m)",
                .doc = "compliance of the joint between rim and barrel, such as an adhesive, added "
                       "in series",
                .range = kNonNegative,
                .example = R"x("0 rad/(N*m)")x",
                .fallback = R"x("0 rad/(N*m)")x",
                .in_template = InTemplate::commented},
          &Flexspline::joint_compliance);
    field(Field{.name = "rim",
                .unit = "",
                .doc = "toothed ring, for crack_free = \"sections\"",
                .in_template = InTemplate::commented},
          &Flexspline::rim);
    field(Field{.name = "barrel",
                .unit = "",
                .doc = "smooth tube, for crack_free = \"sections\"",
                .in_template = InTemplate::commented},
          &Flexspline::barrel);
    field(Field{.name = "diaphragm",
                .unit = "",
                .doc = "bottom, for crack_free = \"sections\"",
                .in_template = InTemplate::commented},
          &Flexspline::diaphragm);
    field(Field{.name = "boss",
                .unit = "",
                .doc = "hub, for crack_free = \"sections\"",
                .in_template = InTemplate::commented},
          &Flexspline::boss);
    field(Field{.name = "tooth_root",
                .unit = "",
                .doc = "roots of the teeth, for their fatigue",
                .in_template = InTemplate::commented},
          &Flexspline::tooth_root);
    field(Field{.name = "crack", .unit = "", .doc = "cracks of wall, diaphragm and rim"},
          &Flexspline::crack);
  }
};

}  // namespace strainwave
