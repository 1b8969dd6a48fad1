// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/crack.hpp"

namespace strainwave {

/// Shape of the working flanks.  A half path is the path of the pitch point at half its size, above
/// the pitch height; the circular spline has the space that this tooth sweeps (TC-29).
enum class ToothProfile { straight, involute, half_path };
template <>
struct EnumNames<ToothProfile> {
  static constexpr std::array<std::string_view, 3> names = {"straight", "involute", "half_path"};
};

/// The tips of drawn teeth.
enum class ToothTips {
  full,      ///< flanks work up to the given heights
  relieved,  ///< the tips are relieved where the gap of a leaving tooth would become smaller again
};
template <>
struct EnumNames<ToothTips> {
  static constexpr std::array<std::string_view, 2> names = {"full", "relieved"};
};

/// The teeth as drawn (TC-29, TC-30).  All heights are those of the working flanks, without chamfer
/// and relief, over the pitch height.
struct ToothShape {
  ToothProfile profile = ToothProfile::straight;
  std::optional<double> addendum;         ///< h_a of the flexspline [m]; absent: 0.65 modules
  std::optional<double> spline_addendum;  ///< h_ac of the circular spline [m]; absent: 0.65 modules
  /// s_t of the flexspline at the pitch height [m]; absent: pi/2 modules
  std::optional<double> thickness;
  ToothTips tips = ToothTips::full;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "profile",
                .unit = "",
                .doc = "shape of the working flanks; straight and involute have the angle "
                       "mesh.flank_angle at the pitch height, half_path gives its own angles",
                .example = R"("straight")",
                .fallback = R"("straight")"},
          &ToothShape::profile);
    field(Field{.name = "addendum",
                .unit = "m",
                .doc = "working height of the flexspline's tooth above the pitch height, without "
                       "chamfer; 0.65 modules if left out",
                .range = kPositive,
                .example = R"("0.2 mm")",
                .in_template = InTemplate::commented},
          &ToothShape::addendum);
    field(Field{.name = "spline_addendum",
                .unit = "m",
                .doc = "working height of the circular spline's tooth below the pitch height, "
                       "without chamfer; 0.65 modules if left out",
                .range = kPositive,
                .example = R"("0.2 mm")",
                .in_template = InTemplate::commented},
          &ToothShape::spline_addendum);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "thickness of the flexspline's tooth at the pitch height; half a pitch if "
                       "left out",
                .range = kPositive,
                .example = R"("0.5 mm")",
                .in_template = InTemplate::commented},
          &ToothShape::thickness);
    field(Field{.name = "tips",
                .unit = "",
                .doc = "full: flanks work up to their addenda; relieved: engagement ends where the "
                       "gap of a leaving tooth is largest, which changes nothing for half_path",
                .example = R"("relieved")",
                .fallback = R"("full")"},
          &ToothShape::tips);
  }
};

/// Engagement of the teeth of flexspline and circular spline (TC-6 to TC-9).
struct ToothMesh {
  double flank_angle = 22 * std::numbers::pi / 180;  ///< alpha, working flank to radial [rad]
  double gap_factor = 1.0;  ///< k_g, multiplies the kinematic gap of the flanks [-]; >= 0
  /// chi: 1 for teeth not corrected for the cup's tilt, 0 for corrected [-]
  double coning = 1.0;
  double lobe_gap = 0.0;  ///< g_0, normal gap at the lobe; < 0 means interference [m]
  double friction_coefficient =
      0.1;  ///< mu of the flanks, for hysteresis and running torque [-]; >= 0
  /// C_tr, factor by which the teeth stiffen the rim in bending [-]; > 0
  double rim_stiffening = 1.25;
  std::optional<double> pair_stiffness;  ///< c' of a pair per width [Pa]; absent: (TC-9), (TC-30)
  /// k_w of Archard, depth of wear per pressure and sliding way [1/Pa]; > 0; absent: not known
  std::optional<double> wear_coefficient = {};
  /// The teeth as drawn; absent: gap of first order, engagement up to 45 degrees from a lobe
  /// (TC-7), stiffness of a pair by (TC-9)
  std::optional<ToothShape> tooth;
  std::vector<ToothMeshCrack> crack;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "flank_angle",
                .unit = "rad",
                .doc = "angle alpha of the working flank against the radius; not used with "
                       "mesh.tooth.profile = \"half_path\"",
                .range = {.lower = 0.0, .upper = std::numbers::pi / 3},
                .example = R"("22 deg")",
                .fallback = R"("22 deg")"},
          &ToothMesh::flank_angle);
    field(Field{.name = "gap_factor",
                .unit = "1",
                .doc = "factor k_g on the kinematic gap between the flanks",
                .range = kNonNegative,
                .example = "1",
                .fallback = "1"},
          &ToothMesh::gap_factor);
    field(Field{.name = "coning",
                .unit = "1",
                .doc = "chi: 1 for teeth not corrected for the tilt of the cup, 0 for corrected",
                .range = kNonNegative,
                .example = "1",
                .fallback = "1"},
          &ToothMesh::coning);
    field(Field{.name = "lobe_gap",
                .unit = "m",
                .doc = "normal gap of the flanks at the lobe; negative for interference",
                .example = R"("0 um")",
                .fallback = R"("0 m")"},
          &ToothMesh::lobe_gap);
    field(Field{.name = "friction_coefficient",
                .unit = "1",
                .doc = "friction coefficient mu of the flanks, for the hysteresis and the running "
                       "torque",
                .range = {.lower = 0.0, .lower_open = false, .upper = 0.5, .upper_open = false},
                .example = "0.1",
                .fallback = "0.1"},
          &ToothMesh::friction_coefficient);
    field(Field{.name = "rim_stiffening",
                .unit = "1",
                .doc = "factor C_tr by which the teeth stiffen the rim in bending",
                .range = kPositive,
                .example = "1.25",
                .fallback = "1.25",
                .in_template = InTemplate::commented},
          &ToothMesh::rim_stiffening);
    field(Field{.name = "pair_stiffness",
                .unit = "Pa",
                .doc = "stiffness c' of a pair of teeth per face width, whose neighbours carry no "
                       "load; if left out, from the teeth as drawn, or from the rim's thickness",
                .range = kPositive,
                .example = R"("19.3 GPa")",
                .in_template = InTemplate::commented},
          &ToothMesh::pair_stiffness);
    field(Field{.name = "wear_coefficient",
                .unit = "1/Pa",
                .doc = "depth of wear of a pair of flanks per pressure and sliding way; no source "
                       "gives it for these drives",
                .range = kPositive,
                .example = R"("1e-18 1/Pa")",
                .in_template = InTemplate::commented},
          &ToothMesh::wear_coefficient);
    field(Field{.name = "tooth",
                .unit = "",
                .doc = "the teeth as drawn, which give the gap of the flanks, the end of their "
                       "engagement and the stiffness of a pair"},
          &ToothMesh::tooth);
    field(Field{.name = "crack", .unit = "", .doc = "cracked teeth"}, &ToothMesh::crack);
  }
};

}  // namespace strainwave
