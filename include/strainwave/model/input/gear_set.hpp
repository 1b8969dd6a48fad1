// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/correlated_normals.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/core/shape.hpp"
#include "strainwave/model/input/circular_spline.hpp"
#include "strainwave/model/input/compliance_table.hpp"
#include "strainwave/model/input/drivetrain.hpp"
#include "strainwave/model/input/duty.hpp"
#include "strainwave/model/input/flexspline.hpp"
#include "strainwave/model/input/inspection.hpp"
#include "strainwave/model/input/manoeuvre.hpp"
#include "strainwave/model/input/material.hpp"
#include "strainwave/model/input/output_bearing.hpp"
#include "strainwave/model/input/output_shaft.hpp"
#include "strainwave/model/input/rating.hpp"
#include "strainwave/model/input/scatter.hpp"
#include "strainwave/model/input/tolerance.hpp"
#include "strainwave/model/input/tooth_mesh.hpp"
#include "strainwave/model/input/wave_generator.hpp"
#include "strainwave/motion/kinematic_error.hpp"

namespace strainwave {

struct TurnTable;

/// The format that this version reads and writes.
inline constexpr std::string_view kDriveFormat = "strainwave-drive/1";

/// Transmission data of the drive as a whole.
struct Transmission {
  double ratio = 0.0;                ///< i_h, circular spline fixed [-]; > 0
  int wave_number = 2;               ///< U, number of lobes of the wave generator [-]; 1 to 8
  double pitch_diameter = 0.0;       ///< d_1, of the flexspline [m]; > 0
  double radial_displacement = 0.0;  ///< w_0, amplitude of the flexspline's deflection [m]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "ratio",
                .unit = "1",
                .doc = "transmission ratio i_h with fixed circular spline",
                .range = kPositive,
                .example = "100",
                .usual = {.lower = 10.0, .upper = 1000.0}},
          &Transmission::ratio);
    field(Field{.name = "wave_number",
                .unit = "1",
                .doc = "U, number of lobes of the wave generator",
                .range = {.lower = 1.0, .lower_open = false, .upper = 8.0, .upper_open = false},
                .example = "2",
                .fallback = "2"},
          &Transmission::wave_number);
    field(Field{.name = "pitch_diameter",
                .unit = "m",
                .doc = "d_1, of the flexspline",
                .range = kPositive,
                .example = R"("160 mm")",
                .usual = {.lower = 2e-3, .upper = 2.0}},
          &Transmission::pitch_diameter);
    field(Field{.name = "radial_displacement",
                .unit = "m",
                .doc = "w_0, amplitude of the flexspline's deflection",
                .range = kPositive,
                .example = R"("0.8 mm")",
                .usual = {.lower = 5e-6, .upper = 0.05}},
          &Transmission::radial_displacement);
  }
};

/// The static load at the output.
struct Load {
  double torque = 0.0;       ///< T [N*m]; not 0. Both senses are always computed
  double axial_force = 0.0;  ///< P, tension > 0 [N]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "torque",
                .unit = "N*m",
                .doc = "torque T at the output, right-handed about +z; both senses are computed",
                .example = R"("100 N*m")"},
          &Load::torque);
    field(Field{.name = "axial_force",
                .unit = "N",
                .doc = "axial force P at the output, tension > 0",
                .example = R"("0 N")",
                .fallback = R"("0 N")"},
          &Load::axial_force);
  }
};

/// Printed intermediate values of the article that do not follow from its inputs.  Only the method
/// as-printed reads them.
struct ArticleOverrides {
  std::optional<double> radial_load;                ///< F_r [N]
  std::optional<double> flaw_parameter;             ///< Q [-]
  std::optional<double> mean_radius;                ///< r_m [m]
  std::optional<double> equivalent_shaft_diameter;  ///< d_s [m]
  std::optional<double> M_p;                        ///< geometry factor of K_I [-]
  std::optional<double> M_M;                        ///< geometry factor of K_III [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto add = [&](std::string_view name, std::string_view unit, std::string_view doc,
                         std::string_view example, auto member) {
      field(Field{.name = name,
                  .unit = unit,
                  .doc = doc,
                  .range = kPositive,
                  .example = example,
                  .in_template = InTemplate::commented},
            member);
    };
    add("radial_load", "N", "F_r", R"("500 N")", &ArticleOverrides::radial_load);
    add("flaw_parameter", "1", "Q", "1.5", &ArticleOverrides::flaw_parameter);
    add("mean_radius", "m", "r_m", R"("79.88 mm")", &ArticleOverrides::mean_radius);
    add("equivalent_shaft_diameter", "m", "d_s", R"("60 mm")",
        &ArticleOverrides::equivalent_shaft_diameter);
    add("M_p", "1", "geometry factor of K_I", "0.85", &ArticleOverrides::M_p);
    add("M_M", "1", "geometry factor of K_III", "0.42", &ArticleOverrides::M_M);
  }
};

/// Path of a crack, such as "flexspline.crack[0]"; its text is built where it is needed.
struct CrackPath {
  std::string_view member;  ///< part of the drive that carries the crack: "flexspline"
  std::size_t index = 0;    ///< among the cracks of that part

  /// The text of the path.  Implicit, so that a walk may take the text.
  operator std::string() const {  // NOLINT(google-explicit-constructor)
    return std::string(member) + ".crack[" + std::to_string(index) + "]";
  }
};

/// Equal cracks that one table of the file gives (placed_group.hpp).
struct PlacedGroup {
  std::string_view member;     ///< part of the drive that carries the cracks: "flexspline"
  std::size_t index = 0;       ///< of the table, and of the first crack, among those of the part
  std::size_t first_copy = 0;  ///< index of the second crack; the others follow
  std::size_t count = 0;       ///< cracks of the group; 2 or more

  /// The path of a crack of the group.
  /// @param number  from 0 to count - 1
  [[nodiscard]] CrackPath crack(std::size_t number) const {
    return {member, number == 0 ? index : first_copy + number - 1};
  }
};

/// A strain wave gear with its cracks, material and load: the content of an input file.
///
/// An absent member adds no compliance.
struct GearSet {
  std::string format{kDriveFormat};
  std::string name;
  std::map<std::string, Material> material;
  Transmission drive;
  Load load;
  std::optional<WaveGenerator> wave_generator;
  std::optional<Flexspline> flexspline;
  std::optional<OutputShaft> output_shaft;
  std::optional<ToothMesh> mesh;                  ///< teeth of the coupled drive
  std::optional<CircularSpline> circular_spline;  ///< ring of the coupled drive; absent: rigid
  std::optional<OutputBearing> output_bearing;    ///< bearing that carries the output
  std::optional<Duty> duty;                       ///< what the drive does, for its life
  std::optional<Drivetrain> drivetrain;           ///< motor and load, for the vibration
  std::vector<ErrorOrder> kinematic_error;        ///< of the gear, by order
  std::vector<Manoeuvre> manoeuvre;               ///< a motion, piece by piece
  std::optional<Rating> rating;                   ///< the maker's torques, for K1, K2, K3
  std::optional<Tolerance> tolerance;             ///< tolerances of the parts; absent: defaults
  std::vector<InputRange> range;                  ///< inputs that are known only within limits
  std::vector<InputScatter> scatter;              ///< inputs that scatter, for combined uncertainty
  std::vector<InputCorrelation> correlation;      ///< of inputs that scatter
  std::optional<Inspection> inspection = {};      ///< how cracks are looked for
  std::optional<ArticleOverrides> article;
  /// The tables that cracks name, by name; the reader of the file fills them
  /// (io/compliance_table_file.hpp).
  std::map<std::string, ComplianceTable> compliance_tables;
  /// The tables of K over a turn that cracks name, by name; the reader of the file fills them
  /// (io/turn_table_file.hpp).  Copies of the drive share them.
  std::map<std::string, std::shared_ptr<const TurnTable>> turn_tables;
  /// The kinematic error that `drivetrain` names; the reader of the file fills it
  /// (io/error_table_file.hpp).  Copies of the drive share it.
  std::shared_ptr<const ErrorTable> error_table;
  /// The history that `duty` names; the reader of the file fills it (io/history_file.hpp).  Copies
  /// of the drive share it.
  std::shared_ptr<const DutyRecord> duty_record;
  /// The groups whose cracks place_groups has made, in the order of their tables; for messages.
  std::vector<PlacedGroup> placed_groups;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "format",
                .unit = "",
                .doc = "always \"strainwave-drive/1\"",
                .example = R"("strainwave-drive/1")"},
          &GearSet::format);
    field(Field{.name = "name",
                .unit = "",
                .doc = "one line for reports",
                .example = R"("My drive")",
                .fallback = R"("")"},
          &GearSet::name);
    field(Field{.name = "material",
                .unit = "",
                .doc = "materials by name; steels of the library need no entry"},
          &GearSet::material);
    field(Field{.name = "drive", .unit = "", .doc = "the drive as a whole"}, &GearSet::drive);
    field(Field{.name = "load", .unit = "", .doc = "static load at the output"}, &GearSet::load);
    field(Field{.name = "wave_generator", .unit = "", .doc = "cam and bearing"},
          &GearSet::wave_generator);
    field(Field{.name = "flexspline", .unit = "", .doc = "cup, cylinder or hat"},
          &GearSet::flexspline);
    field(Field{.name = "output_shaft", .unit = "", .doc = "solid or hollow"},
          &GearSet::output_shaft);
    field(Field{.name = "mesh",
                .unit = "",
                .doc = "tooth engagement, for the torsion curve",
                .in_template = InTemplate::commented},
          &GearSet::mesh);
    field(Field{.name = "circular_spline",
                .unit = "",
                .doc = "ring in its housing, for the torsion curve; rigid if left out",
                .in_template = InTemplate::commented},
          &GearSet::circular_spline);
    field(Field{.name = "output_bearing",
                .unit = "",
                .doc = "bearing that carries the output, for its life",
                .in_template = InTemplate::commented},
          &GearSet::output_bearing);
    field(Field{.name = "duty",
                .unit = "",
                .doc = "what the drive does, for its life",
                .in_template = InTemplate::commented},
          &GearSet::duty);
    field(Field{.name = "drivetrain",
                .unit = "",
                .doc = "motor and load, for the vibration",
                .in_template = InTemplate::commented},
          &GearSet::drivetrain);
    field(Field{.name = "kinematic_error",
                .unit = "",
                .doc = "kinematic error of the gear, by order",
                .in_template = InTemplate::commented},
          &GearSet::kinematic_error);
    field(Field{.name = "manoeuvre",
                .unit = "",
                .doc = "a motion of motor and load, piece by piece",
                .in_template = InTemplate::commented},
          &GearSet::manoeuvre);
    field(Field{.name = "rating",
                .unit = "",
                .doc = "the maker's torques, speeds and life",
                .in_template = InTemplate::commented},
          &GearSet::rating);
    field(Field{.name = "tolerance",
                .unit = "",
                .doc = "tolerances of the parts, for torsion --tolerances",
                .in_template = InTemplate::commented},
          &GearSet::tolerance);
    field(Field{.name = "range",
                .unit = "",
                .doc = "inputs that are known only within limits, for the torsion curve and for "
                       "accuracy",
                .in_template = InTemplate::commented},
          &GearSet::range);
    field(Field{.name = "scatter",
                .unit = "",
                .doc = "inputs that scatter, for sensitivity --scatter and for accuracy",
                .in_template = InTemplate::commented},
          &GearSet::scatter);
    field(Field{.name = "correlation",
                .unit = "",
                .doc = "rank correlations of inputs that scatter",
                .in_template = InTemplate::commented},
          &GearSet::correlation);
    field(Field{.name = "inspection",
                .unit = "",
                .doc = "how cracks are looked for, and what a find leads to",
                .in_template = InTemplate::commented},
          &GearSet::inspection);
    field(Field{.name = "article",
                .unit = "",
                .doc = "printed values of the article; read by the method as-printed only",
                .in_template = InTemplate::commented},
          &GearSet::article);
  }
};

/// Calls f(name, member) for each member that carries cracks, such as "wave_generator".
template <class Gear, class F>
void for_each_cracked_member(Gear& gear, const F& f) {
  if (gear.wave_generator) f("wave_generator", *gear.wave_generator);
  if (gear.flexspline) f("flexspline", *gear.flexspline);
  if (gear.mesh) f("mesh", *gear.mesh);
  if (gear.circular_spline) f("circular_spline", *gear.circular_spline);
  if (gear.output_shaft) f("output_shaft", *gear.output_shaft);
}

/// Calls f(path, crack) for each crack of a member.
template <class Cracks, class F>
void for_each_crack(std::string_view member, Cracks& cracks, const F& f) {
  for (std::size_t i = 0; i < cracks.size(); ++i)
    std::visit([&](auto& crack) { f(CrackPath{member, i}, crack); }, cracks[i]);
}

/// Calls f(path, crack) for each crack of a drive, in the order of their numbers.
template <class Gear, class F>
void for_each_crack(Gear& gear, const F& f) {
  for_each_cracked_member(
      gear, [&](std::string_view name, auto& member) { for_each_crack(name, member.crack, f); });
}

/// Calls f(name, entries) for each list of the drive whose entries name numbers by their `paths`.
template <class Gear, class F>
void for_each_path_list(Gear& gear, const F& f) {
  f("range", gear.range);
  f("scatter", gear.scatter);
  f("correlation", gear.correlation);
}

/// Removes the entries of the lists of for_each_path_list whose numbers are no longer in the drive
/// or have changed their values, and places of the inspection without a crack; the last takes it
/// along.
/// @param gear    the drive as it is now; its lists are changed
/// @param before  the drive for which the lists were written
void drop_lost_paths(GearSet& gear, const GearSet& before);

/// The material that a member names.  A laminate whose plies all have the same isotropic elastic
/// constants is a solid wall, so it counts as the material of its first ply.
/// @param gear         drive with its materials
/// @param name         name of the material in `material`
/// @param field        field that holds the name, for messages
/// @throws InputError  if no material has that name
[[nodiscard]] const Material& material_of(const GearSet& gear, std::string_view name,
                                          std::string_view field);
/// The same with a path, whose text is built only for a message.
[[nodiscard]] const Material& material_of(const GearSet& gear, std::string_view name,
                                          const FieldPath& field);
/// The name in `material` of what material_of finds: `name`, or the first ply of a solid wall.
[[nodiscard]] std::string_view solid_name(const GearSet& gear, std::string_view name);

/// The standard normal variables of the inputs that scatter, in the order of the file, with the
/// correlations that the file gives.
///
/// Implements theory manual eq. (UQ-8).
/// @throws InputError  if no numbers can have these correlations
[[nodiscard]] CorrelatedNormals scattering_normals(const GearSet& gear);

/// A part of the scatter of growth of a material that is a number of the drive: the level or the
/// exponent of its specimen.
struct GrowthLevel {
  std::string material;   ///< name in `material`
  bool exponent = false;  ///< whether the part is that of the exponent alone
  std::string path;       ///< of the field that gives the deviation
};
/// The levels and exponents of the materials whose growth scatters, in the order of the materials.
[[nodiscard]] std::vector<GrowthLevel> growth_levels(const GearSet& gear);

/// The standard normal variables of the inputs that scatter, as of scattering_normals, followed by
/// those of growth_levels.
/// @throws InputError  if no numbers can have these correlations
[[nodiscard]] CorrelatedNormals life_normals(const GearSet& gear);

/// The kinematic error of a drive: the orders of the file, and the lines of its table (MO-56).
[[nodiscard]] KinematicError kinematic_error_of(const GearSet& gear);

/// Throws InputError for the first number outside its range, or for the first broken rule between
/// fields: inner diameter < outer, crack shallower than the wall, one source of the radial
/// stiffness, ...  Every computation calls it first.
void check(const GearSet& gear);

/// Sets the number at `path`, such as "output_shaft.crack[0].depth" [unit of the field].  A path is
/// plain text, so "material.17-4PH H900.yield_strength" needs no quotes.  The origin of a material
/// records which of its numbers were changed.  The range, the scatter and the correlations of the
/// number are removed, because its value is now known.
/// @throws InputError  if no number has the path; the message names near paths
void set_number(GearSet& gear, std::string_view path, double value);

/// The shapes of a drive and of a material are made in gear_set.cpp.
/// @{
extern template const Shape& shape_of<Material>();
extern template const Shape& shape_of<GearSet>();
/// @}

/// A number of the gear by its path.
struct NumberAt {
  std::string path;    ///< such as "output_shaft.crack[0].depth"
  Field field;         ///< unit, meaning and range of the number
  double value = 0.0;  ///< [unit of the field]
};
/// The number at a path.
/// @throws InputError  on the same conditions as set_number
[[nodiscard]] NumberAt number_at(const GearSet& gear, std::string_view path);

}  // namespace strainwave
