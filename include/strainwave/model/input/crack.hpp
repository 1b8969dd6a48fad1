// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The part of a drive that contains a crack.
enum class CrackedPart {
  inner_ring,
  outer_ring,
  barrel,
  rim,
  diaphragm,
  tooth,
  circular_spline,
  output_shaft
};

/// Shape of a crack in a cut through the axis of the drive.
enum class CrackShape {
  semi_ellipse,  ///< semi-elliptical, from a surface
  over_width,    ///< constant depth over the width of a ring
  all_round,     ///< constant depth round a shaft
  through,       ///< a crack through the wall, from surface to surface
  groove,        ///< groove all round, with a stated width
  whole          ///< the whole part, which becomes softer
};

/// Size and place of a crack, for drawings and tables, in one form for all kinds.
struct CrackPlace {
  CrackedPart part{};  ///< part that contains the crack
  CrackShape shape{};  ///< in a cut through the axis
  double depth = 0.0;  ///< depth a; 0 for a through crack [m]
  /// half length along the surface; for a groove, half its width [m]
  double half_length = 0.0;
  /// whether the crack starts at the inner surface of its part
  bool from_inside = false;
  std::optional<double> angle = {};     ///< angle beta of a crack in a wall [rad]
  std::optional<double> radius = {};    ///< radius on the diaphragm; absent: at the boss [m]
  std::optional<double> position = {};  ///< angle from the major axis [rad]
  double stiffness_loss = 0.0;          ///< lost share of the stiffness of a softer part [-]
  int count = 1;                        ///< equal cracks evenly spaced round the axis [-]
};

/// A crack that acts through the contacts of balls and teeth, and moves relative to the wave.  Only
/// the coupled drive models it.
template <class Crack>
concept ContactCrack = Crack::kActsInCoupledDrive;

/// Source of the stress on a crack in a bearing ring of the wave generator.
enum class StressDriver {
  orthogonal_shear,  ///< the article's beta/2 * sigma_max, treated as an input stress (ST-12)
  contact_edge,      ///< Hertz edge tension at the end of the minor axis of the contact (CO-7)
  ring_bending,      ///< bending of the ring under the lobe forces (ST-13)
  given,             ///< a stress at the given torque
};
template <>
struct EnumNames<StressDriver> {
  static constexpr std::array<std::string_view, 4> names = {"orthogonal_shear", "contact_edge",
                                                            "ring_bending", "given"};
};

/// Field of the depth a of a crack from a surface [m].
inline constexpr Field kCrackDepthField{.name = "depth",
                                        .unit = "m",
                                        .doc = "crack depth a",
                                        .range = kPositive,
                                        .example = R"("0.1 mm")"};

/// Semi-elliptical surface crack in the inner ring of the wave generator's bearing.
struct RaceSurfaceCrack {
  static constexpr std::string_view kKind = "surface";
  static constexpr std::string_view kMeaning =
      "semi-elliptical crack in the race of the inner ring";
  double depth = 0.0;         ///< a, into the ring [m]; > 0, < ring thickness
  double aspect_ratio = 0.0;  ///< a/c, depth per half length [-]; in (0, 1]
  StressDriver stress_driver = StressDriver::orthogonal_shear;
  std::optional<double> contact_factor;  ///< beta of orthogonal_shear [-]; absent: computed (CO-5)
  std::optional<double> stress;          ///< hoop stress at the given torque [Pa]; driver `given`
  double position = 0.0;                 ///< angle from the major axis; coupled drive only [rad]

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = CrackedPart::inner_ring,
            .shape = CrackShape::semi_ellipse,
            .depth = depth,
            .half_length = depth / aspect_ratio,
            .position = position};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepthField, &RaceSurfaceCrack::depth);
    field(Field{.name = "aspect_ratio",
                .unit = "1",
                .doc = "a/c, depth per half length; the length 2c runs along the axis, within the "
                       "ring's width",
                .range = {.lower = 0.0, .upper = 1.0, .upper_open = false},
                .example = "0.5"},
          &RaceSurfaceCrack::aspect_ratio);
    describe_driver<RaceSurfaceCrack>(field);
  }

  /// Describes the source of the stress and the position; RaceEdgeCrack shares these fields.
  template <class Crack, class Visitor>
  static void describe_driver(Visitor&& field) {
    field(Field{.name = "stress_driver",
                .unit = "",
                .doc = "source of the stress on the crack",
                .example = R"("orthogonal_shear")",
                .fallback = R"("orthogonal_shear")"},
          &Crack::stress_driver);
    field(Field{.name = "contact_factor",
                .unit = "1",
                .doc = "beta of orthogonal_shear; from b'/a' when left out",
                .range = {.lower = 0.0, .upper = 1.0, .upper_open = false},
                .example = "0.45",
                .in_template = InTemplate::commented},
          &Crack::contact_factor);
    field(Field{.name = "stress",
                .unit = "Pa",
                .doc = "hoop stress at the given torque; for stress_driver = \"given\"",
                .example = R"("5 MPa")",
                .in_template = InTemplate::commented},
          &Crack::stress);
    field(Field{.name = "position",
                .unit = "rad",
                .doc =
                    "angle from the wave generator's major axis, toward +theta; coupled drive only",
                .example = R"("0 deg")",
                .fallback = R"("0 deg")",
                .in_template = InTemplate::commented},
          &Crack::position);
  }
};

/// Edge crack through the whole width of the inner ring.
struct RaceEdgeCrack {
  static constexpr std::string_view kKind = "edge";
  static constexpr std::string_view kMeaning =
      "crack of one depth over the whole width of the inner ring";
  double depth = 0.0;  ///< a, into the ring [m]; > 0, < ring thickness
  /// Source of the stress on the crack.
  StressDriver stress_driver = StressDriver::orthogonal_shear;
  std::optional<double> contact_factor;  ///< as in RaceSurfaceCrack
  std::optional<double> stress;          ///< as in RaceSurfaceCrack
  double position = 0.0;                 ///< angle from the major axis; coupled drive only [rad]

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = CrackedPart::inner_ring,
            .shape = CrackShape::over_width,
            .depth = depth,
            .position = position};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepthField, &RaceEdgeCrack::depth);
    RaceSurfaceCrack::describe_driver<RaceEdgeCrack>(field);
  }
};

/// The field that names a table of finite elements (`strainwave fe tabulate`) with the added
/// compliance.
inline constexpr Field kComplianceTableField{
    .name = "compliance_table",
    .unit = "",
    .doc = "CSV of `strainwave fe tabulate` beside this file, in place of the closed form",
    .example = R"("table.csv")",
    .in_template = InTemplate::commented};

/// The field that names a table of K over a turn of the wave generator.
inline constexpr Field kTurnTableField{
    .name = "turn_table",
    .unit = "",
    .doc = "CSV of K over a turn beside this file, for growth and strength",
    .example = R"("turn.csv")",
    .in_template = InTemplate::commented};

/// The field of the number of equal cracks, evenly spaced round the axis unless a pitch is given.
inline constexpr Field kCrackCountField{
    .name = "count",
    .unit = "1",
    .doc =
        "equal cracks, evenly spaced round the axis; stiffness and K are those of this row; "
        "with a pitch the cracks of a group",
    .range = {.lower = 1.0, .lower_open = false, .upper = 2000.0, .upper_open = false},
    .example = "4",
    .fallback = "1",
    .in_template = InTemplate::commented};

/// The field of the angle from one crack of a group to the next.
inline constexpr Field kRoundPitchField{
    .name = "pitch",
    .unit = "rad",
    .doc =
        "angle from one crack of a group to the next, toward +theta; the first one is at "
        "position, and count says how many there are",
    .example = R"("20 deg")",
    .in_template = InTemplate::commented};

/// The field of the places of a group round the axis.
inline constexpr Field kRoundPositionsField{
    .name = "positions",
    .unit = "rad",
    .doc = "positions of the equal cracks of a group, in place of position",
    .example = R"(["0 deg", "25 deg"])",
    .in_template = InTemplate::commented};

/// A kind of crack whose table may stand for a group of equal cracks at stated places
/// (placed_group.hpp).  `kPlace` is the field that `pitch` and `positions` place, and
/// `kCountIsRow` tells whether `count` without a pitch is a row that the program treats as one
/// crack.
template <class Crack>
concept GroupableCrack = requires {
  Crack::kPlace;
  Crack::kCountIsRow;
};

/// The part of a flexspline's wall that contains a crack, if sections are given.
enum class WallSection { barrel, rim };
template <>
struct EnumNames<WallSection> {
  static constexpr std::array<std::string_view, 2> names = {"barrel", "rim"};
};
/// The part of the drive that a section of the wall is.
constexpr CrackedPart part_of(WallSection section) {
  return section == WallSection::rim ? CrackedPart::rim : CrackedPart::barrel;
}

/// The surface of a wall from which a crack starts.
enum class Mouth { outer, inner };
template <>
struct EnumNames<Mouth> {
  static constexpr std::array<std::string_view, 2> names = {"outer", "inner"};
};

/// Straight crack through the wall of the flexspline.
struct WallThroughCrack {
  static constexpr std::string_view kKind = "through";
  static constexpr std::string_view kMeaning = "straight crack through the wall";
  double half_length = 0.0;  ///< a, along the crack [m]; > 0
  double angle =
      std::numbers::pi / 4;      ///< angle beta from +z toward -theta [rad]; in (-pi/2, pi/2]
  bool shell_correction = true;  ///< A_I of the curved shell (FR-9); flat plate if false
  WallSection section = WallSection::barrel;
  /// z of the crack's middle from the section's end toward the diaphragm [m]; absent: half its
  /// length
  std::optional<double> distance = {};
  /// angle of the crack's middle round the axis [rad]; absent: far from other cracks
  std::optional<double> position = {};
  int count = 1;  ///< equal cracks, evenly spaced round the axis [-]; 1 to 2000
  /// angle from one crack of a group to the next [rad]; not 0; place_groups reads it
  std::optional<double> pitch = {};
  /// the same along z [m]
  std::optional<double> axial_pitch = {};
  std::vector<double> positions = {};  ///< of a group, in place of `position` [rad]
  static constexpr auto kPlace = &WallThroughCrack::position;  ///< as in GroupableCrack
  static constexpr bool kCountIsRow = true;                    ///< as in GroupableCrack
  /// file of a table (FE-41) that replaces the closed form
  std::optional<std::string> compliance_table = {};
  /// file of a table of K over a turn (GR-30)
  std::optional<std::string> turn_table = {};

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = part_of(section),
            .shape = CrackShape::through,
            .half_length = half_length,
            .angle = angle,
            .count = count};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "half of the crack's length, a",
                .range = kPositive,
                .example = R"("0.1 mm")"},
          &WallThroughCrack::half_length);
    describe_place<WallThroughCrack>(field);
    field(Field{.name = "shell_correction",
                .unit = "",
                .doc = "whether the curvature of the shell raises K_I",
                .example = "true",
                .fallback = "true",
                .in_template = InTemplate::commented},
          &WallThroughCrack::shell_correction);
    field(kComplianceTableField, &WallThroughCrack::compliance_table);
    field(kTurnTableField, &WallThroughCrack::turn_table);
  }

  /// Describes angle, section and place in the wall; WallSurfaceCrack shares these fields.
  template <class Crack, class Visitor>
  static void describe_place(Visitor&& field) {
    field(
        Field{
            .name = "angle",
            .unit = "rad",
            .doc =
                "angle beta from the generator (+z) toward -theta; T > 0 opens a crack at +45 deg",
            .range = {.lower = -std::numbers::pi / 2,
                      .upper = std::numbers::pi / 2,
                      .upper_open = false},
            .example = R"("45 deg")",
            .fallback = R"("45 deg")"},
        &Crack::angle);
    field(Field{.name = "section",
                .unit = "",
                .doc = "section that contains the crack; only with crack_free = \"sections\"",
                .example = R"("barrel")",
                .fallback = R"("barrel")",
                .in_template = InTemplate::commented},
          &Crack::section);
    field(Field{.name = "distance",
                .unit = "m",
                .doc = "from the section's end toward the diaphragm to the middle of the crack, "
                       "along z; half of the section if left out",
                .range = kPositive,
                .example = R"("6 mm")",
                .in_template = InTemplate::commented},
          &Crack::distance);
    field(Field{.name = "position",
                .unit = "rad",
                .doc = "angle of the crack's middle round the axis, toward +theta, from one mark "
                       "for all cracks; if left out the crack is far from the others",
                .example = R"("0 deg")",
                .in_template = InTemplate::commented},
          &Crack::position);
    field(kCrackCountField, &Crack::count);
    field(kRoundPitchField, &Crack::pitch);
    field(Field{.name = "axial_pitch",
                .unit = "m",
                .doc = "length from one crack of a group to the next along z; the first one is at "
                       "distance; with pitch or alone",
                .example = R"("4 mm")",
                .in_template = InTemplate::commented},
          &Crack::axial_pitch);
    field(kRoundPositionsField, &Crack::positions);
  }
};

/// Semi-elliptical surface crack in the wall of the flexspline.
struct WallSurfaceCrack {
  static constexpr std::string_view kKind = "surface";
  static constexpr std::string_view kMeaning = "semi-elliptical crack in the surface of the wall";
  double depth = 0.0;                         ///< a, into the wall [m]; > 0, < wall thickness
  double half_length = 0.0;                   ///< half length c along the surface [m]; >= depth
  double angle = std::numbers::pi / 4;        ///< as in WallThroughCrack
  WallSection section = WallSection::barrel;  ///< as in WallThroughCrack
  std::optional<double> distance = {};        ///< as in WallThroughCrack
  std::optional<double> position = {};        ///< as in WallThroughCrack
  int count = 1;                              ///< as in WallThroughCrack
  std::optional<double> pitch = {};           ///< as in WallThroughCrack
  std::optional<double> axial_pitch = {};     ///< as in WallThroughCrack
  std::vector<double> positions = {};         ///< as in WallThroughCrack
  static constexpr auto kPlace = &WallSurfaceCrack::position;  ///< as in GroupableCrack
  static constexpr bool kCountIsRow = true;                    ///< as in GroupableCrack
  std::optional<Mouth> mouth = {};             ///< absent: not known, taken as outer
  std::optional<std::string> turn_table = {};  ///< as in WallThroughCrack

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = part_of(section),
            .shape = CrackShape::semi_ellipse,
            .depth = depth,
            .half_length = half_length,
            .from_inside = mouth == Mouth::inner,
            .angle = angle,
            .count = count};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepthField, &WallSurfaceCrack::depth);
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "half of the length on the surface, c",
                .range = kPositive,
                .example = R"("0.2 mm")"},
          &WallSurfaceCrack::half_length);
    WallThroughCrack::describe_place<WallSurfaceCrack>(field);
    field(Field{.name = "mouth",
                .unit = "",
                .doc = "surface of the wall from which the crack starts; if left out it is not "
                       "known, and finite elements take the outer one",
                .example = R"("outer")",
                .in_template = InTemplate::commented},
          &WallSurfaceCrack::mouth);
    field(kTurnTableField, &WallSurfaceCrack::turn_table);
  }
};

/// Stress intensity solution for an annular crack in a solid shaft.
enum class AnnularSolution {
  improved,  ///< polynomials fitted to finite elements (FR-12)
  tada,      ///< the handbook's polynomials (FR-12)
};
template <>
struct EnumNames<AnnularSolution> {
  static constexpr std::array<std::string_view, 2> names = {"improved", "tada"};
};

/// Circumferential crack of uniform depth in the outer surface of a shaft.
struct AnnularCrack {
  static constexpr std::string_view kKind = "annular";
  static constexpr std::string_view kMeaning = "crack of one depth all round the shaft";
  double depth = 0.0;  ///< a, radial [m]; > 0, < wall of a hollow shaft, < radius of a solid one
  AnnularSolution solution = AnnularSolution::improved;  ///< solid shafts only
  /// From the shaft's end toward the flexspline, along z [m]; absent: far from the other cracks
  std::optional<double> distance = {};
  int count = 1;                     ///< cracks of a group [-]; place_groups reads it
  std::optional<double> pitch = {};  ///< from one crack of a group to the next, along z [m]; not 0
  std::vector<double> positions = {};  ///< of a group, in place of `distance` [m]
  static constexpr auto kPlace = &AnnularCrack::distance;  ///< as in GroupableCrack
  static constexpr bool kCountIsRow = false;               ///< as in GroupableCrack
  std::optional<std::string> compliance_table = {};        ///< as in WallThroughCrack

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = CrackedPart::output_shaft, .shape = CrackShape::all_round, .depth = depth};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepthField, &AnnularCrack::depth);
    field(Field{.name = "solution",
                .unit = "",
                .doc = "stress intensity solution of a solid shaft; a hollow shaft uses a table",
                .example = R"("improved")",
                .fallback = R"("improved")",
                .in_template = InTemplate::commented},
          &AnnularCrack::solution);
    field(Field{.name = "distance",
                .unit = "m",
                .doc =
                    "from the shaft's end toward the flexspline to the crack, along z; if left out "
                    "the crack is far from the others",
                .range = kPositive,
                .example = R"("12 mm")",
                .in_template = InTemplate::commented},
          &AnnularCrack::distance);
    field(Field{.name = "count",
                .unit = "1",
                .doc = "equal cracks of a group along the shaft; with a pitch",
                .range = kCrackCountField.range,
                .example = "1",
                .fallback = "1",
                .in_template = InTemplate::commented},
          &AnnularCrack::count);
    field(Field{.name = "pitch",
                .unit = "m",
                .doc = "length from one crack of a group to the next along z; the first one is at "
                       "distance, and count says how many there are",
                .example = R"("10 mm")",
                .in_template = InTemplate::commented},
          &AnnularCrack::pitch);
    field(Field{.name = "positions",
                .unit = "m",
                .doc = "distances of the equal cracks of a group, in place of distance",
                .range = kPositive,
                .example = R"(["12 mm", "20 mm"])",
                .in_template = InTemplate::commented},
          &AnnularCrack::positions);
    field(kComplianceTableField, &AnnularCrack::compliance_table);
  }
};

/// Semi-elliptical crack in the outer surface of a shaft, across its axis.
struct ShaftSurfaceCrack {
  static constexpr std::string_view kKind = "surface";
  static constexpr std::string_view kMeaning =
      "semi-elliptical crack in the outer surface of the shaft, across its axis";
  double depth = 0.0;  ///< a, radial [m]; > 0, < wall of a hollow shaft, < radius of a solid one
  /// c, half of the length along the arc of the surface [m]; >= depth, < half of the circumference
  double half_length = 0.0;

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = CrackedPart::output_shaft,
            .shape = CrackShape::semi_ellipse,
            .depth = depth,
            .half_length = half_length};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepthField, &ShaftSurfaceCrack::depth);
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "half of the length along the arc of the surface, c",
                .range = kPositive,
                .example = R"("0.2 mm")"},
          &ShaftSurfaceCrack::half_length);
  }
};

/// An axial crack over the whole width of a ring, from a surface under bending (TC-22).
template <CrackedPart part_, bool from_inside_>
struct RingCrack {
  /// Only the coupled drive models this crack, see ContactCrack.
  static constexpr bool kActsInCoupledDrive = true;
  double depth = 0.0;     ///< a, into the ring [m]; > 0, < its thickness
  double position = 0.0;  ///< angle from the wave generator's major axis, toward +theta [rad]

  /// Length over which the crack softens a ring of thickness t [m], l = 2t [m].
  template <class Real>
  [[nodiscard]] static Real softened_length(const Real& thickness) {
    return 2 * thickness;
  }
  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = part_,
            .shape = CrackShape::over_width,
            .depth = depth,
            .from_inside = from_inside_,
            .position = position};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "depth",
                .unit = "m",
                .doc = "crack depth a, over the whole width",
                .range = kPositive,
                .example = R"("0.3 mm")"},
          &RingCrack::depth);
    field(Field{.name = "position",
                .unit = "rad",
                .doc = "angle from the wave generator's major axis, toward +theta",
                .example = R"("20 deg")",
                .fallback = R"("0 deg")"},
          &RingCrack::position);
  }
};

/// Axial crack of the toothed rim, from a tooth root; acts in the coupled drive only.
struct RimAxialCrack : RingCrack<CrackedPart::rim, false> {
  static constexpr std::string_view kKind = "rim_axial";
  static constexpr std::string_view kMeaning =
      "axial crack of the rim from a tooth root; coupled drive only";
  int count = 1;                               ///< cracks of a group [-]; place_groups reads it
  std::optional<double> pitch = {};            ///< as in WallThroughCrack
  std::vector<double> positions = {};          ///< as in WallThroughCrack
  std::optional<std::string> turn_table = {};  ///< as in WallThroughCrack
  static constexpr auto kPlace = &RingCrack::position;  ///< as in GroupableCrack
  static constexpr bool kCountIsRow = false;            ///< as in GroupableCrack

  template <class Visitor>
  static void describe(Visitor&& field) {
    RingCrack::describe(field);
    field(Field{.name = "count",
                .unit = "1",
                .doc = "equal cracks, evenly spaced round the axis, or with a pitch the cracks of "
                       "a group",
                .range = kCrackCountField.range,
                .example = "4",
                .fallback = "1",
                .in_template = InTemplate::commented},
          &RimAxialCrack::count);
    field(kRoundPitchField, &RimAxialCrack::pitch);
    field(kRoundPositionsField, &RimAxialCrack::positions);
    field(kTurnTableField, &RimAxialCrack::turn_table);
  }
};

/// Axial crack of the wave generator bearing's outer ring; acts in the coupled drive only.
struct OuterRaceCrack : RingCrack<CrackedPart::outer_ring, true> {
  static constexpr std::string_view kKind = "outer_race";
  /// What this kind is, in words.
  static constexpr std::string_view kMeaning = "axial crack of the outer ring; coupled drive only";
};

/// Axial crack of the circular spline; acts in the coupled drive only.
struct CircularSplineRingCrack : RingCrack<CrackedPart::circular_spline, true> {
  static constexpr std::string_view kKind = "ring";
  static constexpr std::string_view kMeaning =
      "axial crack of the circular spline; coupled drive only";
};

/// A cracked tooth of the flexspline.  Its pair is softer on both flanks (TC-21); acts in the
/// coupled drive only.
struct ToothCrack {
  static constexpr std::string_view kKind = "tooth";
  /// What this kind is, in words.
  static constexpr std::string_view kMeaning = "a cracked or a missing tooth; coupled drive only";
  /// Only the coupled drive models this crack, see ContactCrack.
  static constexpr bool kActsInCoupledDrive = true;
  double stiffness_loss = 0.0;  ///< delta, lost share of the pair's stiffness [-]; in (0, 1]
  double position = 0.0;        ///< angle as in RingCrack; it selects the nearest tooth [rad]

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = CrackedPart::tooth,
            .shape = CrackShape::whole,
            .position = position,
            .stiffness_loss = stiffness_loss};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "stiffness_loss",
                .unit = "1",
                .doc = "delta, share of the tooth pair's stiffness that is lost; 1: tooth gone",
                .range = {.lower = 0.0, .upper = 1.0, .upper_open = false},
                .example = "0.5"},
          &ToothCrack::stiffness_loss);
    field(Field{.name = "position",
                .unit = "rad",
                .doc = "angle from the wave generator's major axis, toward +theta; the crack is in "
                       "the nearest tooth",
                .example = R"("10 deg")",
                .fallback = R"("0 deg")"},
          &ToothCrack::position);
  }
};

/// Circumferential crack through the diaphragm of a cup, along an arc round the boss (TC-19).
struct DiaphragmArcCrack {
  static constexpr std::string_view kKind = "diaphragm_arc";
  static constexpr std::string_view kMeaning =
      "crack through the diaphragm along an arc round the boss";
  double half_length = 0.0;      ///< a, along the arc [m]; > 0
  std::optional<double> radius;  ///< radius of the arc [m]; absent: the diaphragm's inner radius
  /// angle of the arc's middle round the axis [rad]; absent: far from other cracks
  std::optional<double> position = {};
  int count = 1;                                                ///< as in WallThroughCrack
  std::optional<double> pitch = {};                             ///< as in WallThroughCrack
  std::vector<double> positions = {};                           ///< as in WallThroughCrack
  static constexpr auto kPlace = &DiaphragmArcCrack::position;  ///< as in GroupableCrack
  static constexpr bool kCountIsRow = true;                     ///< as in GroupableCrack

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = CrackedPart::diaphragm,
            .shape = CrackShape::through,
            .half_length = half_length,
            .radius = radius,
            .count = count};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "half of the arc's length, a",
                .range = kPositive,
                .example = R"("3 mm")"},
          &DiaphragmArcCrack::half_length);
    field(Field{.name = "radius",
                .unit = "m",
                .doc = "radius of the arc; the diaphragm's inner radius if left out",
                .range = kPositive,
                .example = R"("42 mm")",
                .in_template = InTemplate::commented},
          &DiaphragmArcCrack::radius);
    field(Field{.name = "position",
                .unit = "rad",
                .doc = "angle of the arc's middle round the axis, toward +theta, from one mark for "
                       "all cracks; if left out the crack is far from the others",
                .example = R"("0 deg")",
                .in_template = InTemplate::commented},
          &DiaphragmArcCrack::position);
    field(kCrackCountField, &DiaphragmArcCrack::count);
    field(kRoundPitchField, &DiaphragmArcCrack::pitch);
    field(kRoundPositionsField, &DiaphragmArcCrack::positions);
  }
};

/// Groove all round the diaphragm of a cup, of less depth than the thickness (TC-20).
struct DiaphragmGroove {
  static constexpr std::string_view kKind = "diaphragm_groove";
  static constexpr std::string_view kMeaning = "groove all round the diaphragm";
  double depth = 0.0;   ///< into the thickness [m]; > 0, < thickness there
  double width = 0.0;   ///< radial [m]; > 0
  double radius = 0.0;  ///< radius of its middle [m]; > 0

  /// Size and place, for drawings and tables.
  [[nodiscard]] CrackPlace place() const {
    return {.part = CrackedPart::diaphragm,
            .shape = CrackShape::groove,
            .depth = depth,
            .half_length = width / 2,
            .radius = radius};
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "depth",
                .unit = "m",
                .doc = "depth into the thickness",
                .range = kPositive,
                .example = R"("0.2 mm")"},
          &DiaphragmGroove::depth);
    field(Field{.name = "width",
                .unit = "m",
                .doc = "radial width",
                .range = kPositive,
                .example = R"("0.5 mm")"},
          &DiaphragmGroove::width);
    field(Field{.name = "radius",
                .unit = "m",
                .doc = "of its middle",
                .range = kPositive,
                .example = R"("45 mm")"},
          &DiaphragmGroove::radius);
  }
};

/// A crack of the wave generator's bearing.
using WaveGeneratorCrack = std::variant<RaceSurfaceCrack, RaceEdgeCrack, OuterRaceCrack>;
/// A crack of the flexspline, apart from those of its teeth.
using FlexsplineCrack = std::variant<WallThroughCrack, WallSurfaceCrack, DiaphragmArcCrack,
                                     DiaphragmGroove, RimAxialCrack>;
/// A crack of the output shaft.
using OutputShaftCrack = std::variant<AnnularCrack, ShaftSurfaceCrack>;
/// A crack of a tooth of the flexspline.
using ToothMeshCrack = std::variant<ToothCrack>;
/// A crack of the circular spline.
using CircularSplineCrack = std::variant<CircularSplineRingCrack>;

}  // namespace strainwave
