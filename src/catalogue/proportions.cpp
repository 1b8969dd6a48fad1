// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/proportions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "strainwave/catalogue/torque_limits.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/torsion/diaphragm_stress.hpp"
#include "wave_stresses.hpp"

namespace strainwave {
namespace {

using units::deg;
using units::mm;

constexpr Knowledge kCatalogue = Knowledge::catalogue;
constexpr Knowledge kDrawing = Knowledge::drawing;
constexpr Knowledge kStress = Knowledge::stress;
constexpr Knowledge kAssumed = Knowledge::assumed;
using Values = ProportionValues;
constexpr double kMPa = 1e6;

/// The wave of this ratio decides the walls of a blank for all ratios.
constexpr double kBlankRatio = 100;
/// No diaphragm is thinner than this share of d, whatever the stress demands.
constexpr double kLeastDiaphragm = 0.004;

// clang-format off
constexpr std::array<Proportion, 32> kProportions = {{
    {"rim_thickness", "t_r over its law", &Values::rim_thickness, 0.8, 1.2, kDrawing,
     "handbook law 1e-4 (65 + 2.5 i^(2/3)) d; 0.010 to 0.015 d in samples", ""},
    {"rim_stress", "bending stress of the rim by the wave", &Values::rim_stress, 180 * kMPa, 300 * kMPa, kStress,
     "endurance of quenched and tempered steel, 455 to 490 MPa, over 1.7 to 2 for the notch of a tooth root", "", "Pa"},
    {"barrel_thickness", "t_b/t_r", &Values::barrel_thickness, 0.5, 0.9, kDrawing,
     "handbooks; little is known about short cups", "flexspline.barrel.wall_thickness"},
    {"standard_length", "L/d, standard length", &Values::standard_length, 0.7, 1.0, kDrawing,
     "handbooks; older component sets", ""},
    {"short_length", "L/d, short length", &Values::short_length, 0.38, 0.46, kCatalogue,
     "makers of cups and hats: about half the length of the older long series", ""},
    {"flat_length", "L/d, flat length", &Values::flat_length, 0.19, 0.27, kCatalogue,
     "makers of flat hats: about half the length of the short series", ""},
    {"face_width", "b/d", &Values::face_width, 0.12, 0.20, kDrawing,
     "published samples, 0.12 to 0.17; handbooks", ""},
    {"flat_face_width", "b/d, flat length", &Values::flat_face_width, 0.09, 0.14, kAssumed,
     "in proportion to the rated torques of a maker's flat hats, 0.7 to 0.8 of the short series", ""},
    {"diaphragm_thickness", "t_d/d", &Values::diaphragm_thickness, 0.008, 0.020, kAssumed,
     "no source; one thickness in place of a plate that is thicker at the clamped edge", "flexspline.diaphragm.thickness"},
    {"diaphragm_stress", "bending stress of the diaphragm by the wave", &Values::diaphragm_stress, 250 * kMPa, 450 * kMPa, kStress,
     "endurance of quenched and tempered steel, 455 to 490 MPa, over 1.1 to 1.8 for the fillet", "flexspline.diaphragm.thickness", "Pa"},
    {"boss_diameter", "over d", &Values::boss_diameter, 0.493, 0.667, kDrawing,
     "bolt circles in a maker's drawings, 0.45 to 0.50 d, and two bolt diameters", "flexspline.diaphragm.inner_diameter"},
    {"flange_diameter", "over d", &Values::flange_diameter, 1.30, 1.50, kAssumed,
     "bolt circles of hats, about 1.6 d without a source, less two bolt diameters", "flexspline.diaphragm.outer_diameter"},
    {"dedendum", "h_f/m", &Values::dedendum, 1.1, 1.35, kDrawing,
     "published samples", ""},
    {"tooth_addendum", "h_a/m of both teeth", &Values::tooth_addendum, 0.55, 0.8, kDrawing,
     "the drawing that states all numbers of its teeth, 0.65; tooth heights of samples less the dedendum", ""},
    {"flank_angle", "alpha", &Values::flank_angle, 18 * deg, 26 * deg, kAssumed,
     "makers do not publish the working tooth; 20 degrees is traditional", "mesh.flank_angle", "rad"},
    {"coning", "chi", &Values::coning, 0.1, 1.0, kAssumed,
     "teeth not corrected for the tilt of the cup; makers may correct their teeth", "mesh.coning"},
    {"gap_factor", "k_g", &Values::gap_factor, 0.8, 1.2, kAssumed,
     "straight flanks as drawn, on their exact path; the true flank is not published", "mesh.gap_factor"},
    {"radial_displacement", "w_0/m", &Values::radial_displacement, 0.9, 1.05, kDrawing,
     "handbooks and samples; smaller in some designs of low ratio", "drive.radial_displacement"},
    {"rim_stiffening", "C_tr", &Values::rim_stiffening, 1.2, 1.3, kDrawing,
     "published finite elements of toothed rims", "mesh.rim_stiffening"},
    {"bearing_bore", "over D", &Values::bearing_bore, 0.72, 0.78, kDrawing,
     "standard series of flexible bearings, 0.71 to 0.77", ""},
    {"bearing_width", "over D", &Values::bearing_width, 0.145, 0.167, kDrawing,
     "standard series of flexible bearings", "wave_generator.bearing.outer_ring.width"},
    {"ring_stress", "bending stress of the outer ring by the wave", &Values::ring_stress, 300 * kMPa, 550 * kMPa, kStress,
     "about half the endurance of bearing steel in bending, 858 MPa, for the groove and the contacts", "", "Pa"},
    {"ball_diameter", "over the section", &Values::ball_diameter, 0.5185, 0.7015, kDrawing,
     "published samples and bearing practice", ""},
    {"ball_count", "balls", &Values::ball_count, 19, 27, kDrawing,
     "bearings of this kind have 19 to 27 balls", ""},
    {"conformity", "groove radius over ball", &Values::conformity, 0.52, 0.54, kDrawing,
     "bearing practice", ""},
    {"groove_factor", "share of the ring's bending stiffness", &Values::groove_factor, 0.7, 0.9, kAssumed,
     "estimated from the section of a grooved ring", "wave_generator.bearing.outer_ring.groove_factor"},
    {"spline_outer_diameter", "over d", &Values::spline_outer_diameter, 1.30, 1.41, kCatalogue,
     "makers' outside diameters and bolt circles", "circular_spline.outer_diameter"},
    {"spline_root", "(inner diameter - d)/m", &Values::spline_root, 4.2, 4.7, kDrawing,
     "two more teeth, and the dedendum of the flexspline", "circular_spline.inner_diameter"},
    {"spline_support", "s_h", &Values::spline_support, 0.1, 1.0, kAssumed,
     "depends on the housing; close to the middle of the plausible range", "circular_spline.support"},
    {"lobe_gap", "g_0/d", &Values::lobe_gap, -1e-3 / 63.5, 2e-3 / 63.5, kAssumed,
     "-1 to 2 um at size 25, in proportion to d; a larger gap would give lost motion above 1 arcmin", "mesh.lobe_gap"},
    {"clearance", "c/d", &Values::clearance, 0.0, 3e-3 / 63.5, kAssumed,
     "0 to 3 um at size 25, in proportion to d; lobes are fitted without play", "wave_generator.bearing.clearance"},
    {"friction", "mu", &Values::friction, 0.05, 0.15, kAssumed,
     "greased steel; affects only the hysteresis", "mesh.friction_coefficient"},
}};
// clang-format on

/// A uniform number in [0, 1) from the upper 53 bits.
double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11U) * 0x1p-53;
}

/// The number rounded to six digits, as the file shows it.
double rounded(double value, double unit, std::string_view name, std::string_view si) {
  return parse_quantity("proportion", fmt::format("{:.6g} {}", value / unit, name), si);
}

Material typical_steel() {
  Material steel;
  steel.youngs_modulus = 206 * units::GPa;
  steel.poissons_ratio = 0.3;
  return steel;
}

/// The rule that decides a wall.
enum class Decides { drawing, stress, least };

struct Wall {
  double thickness = 0.0;  // [m]
  Decides by = Decides::drawing;
};

/// The thinner of two walls.
Wall thinner(double by_drawing, double by_stress) {
  return by_stress < by_drawing ? Wall{by_stress, Decides::stress} : Wall{by_drawing};
}

/// Walls and bearing of a blank, from which the other dimensions follow.
struct TypicalWalls {
  Wall rim;
  Wall diaphragm;
  Wall outer_ring;
  double inner_ring = 0.0;     // [m]
  double ball = 0.0;           // [m]
  double bearing_width = 0.0;  // [m]
  double face_width = 0.0;     // b [m]
  double length = 0.0;         // L [m]
};

Flexspline typical_flexspline(double d, double R, const TypicalWalls& walls, FlexsplineForm form,
                              const ProportionValues& p) {
  const double t_r = walls.rim.thickness;
  const double t_b = p.barrel_thickness * t_r;
  const bool hat = form == FlexsplineForm::hat;
  Flexspline fs;
  fs.material = "steel";
  fs.shape = hat ? FlexsplineShape::hat : FlexsplineShape::cup;
  fs.wall_thickness = t_r;
  fs.length = walls.length;
  fs.crack_free = CrackFree::sections;
  fs.rim =
      TubeSection{.outer_diameter = 2 * R + t_r, .wall_thickness = t_r, .length = walls.face_width};
  fs.barrel = TubeSection{.outer_diameter = 2 * R + t_b,
                          .wall_thickness = t_b,
                          .length = walls.length - walls.face_width};
  fs.diaphragm = Diaphragm{.outer_diameter = hat ? p.flange_diameter * d : 2 * R,
                           .inner_diameter = hat ? 2 * R : p.boss_diameter * d,
                           .thickness = walls.diaphragm.thickness,
                           .profile = {}};
  return fs;
}

TypicalWalls typical_walls(double d, double ratio, const DriveType& type,
                           const ProportionValues& p) {
  const double m = d / (2 * ratio);
  const ElasticConstants steel = elastic_constants(typical_steel());
  const BentWall narrow{.modulus = steel.E, .waves = 2, .displacement = p.radial_displacement * m};
  BentWall wide = narrow;
  wide.modulus = steel.plane_strain_modulus();
  TypicalWalls walls;
  const bool flat = type.length == FlexsplineLength::flat;
  walls.face_width = (flat ? p.flat_face_width : p.face_width) * d;
  walls.length = (flat                                            ? p.flat_length
                  : type.length == FlexsplineLength::short_length ? p.short_length
                                                                  : p.standard_length) *
                 d;
  const double roots = d / 2 - p.dedendum * m;
  walls.rim = thinner(p.rim_thickness * 1e-4 * (65 + 2.5 * std::cbrt(ratio * ratio)) * d,
                      ring_thickness(wide, roots, p.rim_stress));
  const double bore = 2 * (roots - walls.rim.thickness);
  const double section = bore * (1 - p.bearing_bore) / 2;
  walls.ball = p.ball_diameter * section;
  walls.inner_ring = (section - walls.ball) / 2;
  walls.outer_ring = thinner(walls.inner_ring, ring_thickness(narrow, bore / 2, p.ring_stress));
  walls.bearing_width = p.bearing_width * bore;
  walls.diaphragm = {p.diaphragm_thickness * d};
  const auto beyond = [&](double thickness) {
    TypicalWalls tried = walls;
    tried.diaphragm.thickness = thickness;
    const double R = roots - walls.rim.thickness / 2;
    return diaphragm_wave_stress(typical_flexspline(d, R, tried, type.form, p), steel, R,
                                 wide.waves, wide.displacement) -
           p.diaphragm_stress;
  };
  const double least = kLeastDiaphragm * d;
  if (beyond(walls.diaphragm.thickness) > 0)
    walls.diaphragm =
        beyond(least) >= 0
            ? Wall{least, Decides::least}
            : Wall{bracketed_root(beyond, least, walls.diaphragm.thickness), Decides::stress};
  return walls;
}

double wall_ratio(double ratio, const DriveType& type) {
  return type.blank == Blank::size ? kBlankRatio : ratio;
}

/// @param bore  bore of the flexspline, which the bearing fills [m]
WaveGenerator typical_wave_generator(double d, double bore, const TypicalWalls& walls,
                                     const ProportionValues& p) {
  const double outer_ring = walls.outer_ring.thickness;
  const double pitch = bore / 2 - outer_ring - walls.ball / 2;  // radius of the balls' circle
  Bearing bearing;
  bearing.ball_diameter = walls.ball;
  bearing.inner_raceway_diameter = 2 * pitch - walls.ball;
  bearing.outer_raceway_diameter = 2 * pitch + walls.ball;
  bearing.inner_conformity = p.conformity;
  bearing.outer_conformity = p.conformity;
  bearing.loaded_balls = 5;
  bearing.ball_count = static_cast<int>(std::lround(p.ball_count));
  bearing.clearance = p.clearance * d;
  bearing.outer_ring = BearingRing{.mean_radius = bore / 2 - outer_ring / 2,
                                   .thickness = outer_ring,
                                   .width = walls.bearing_width,
                                   .groove_factor = p.groove_factor};
  WaveGenerator wg;
  wg.material = "steel";
  wg.force_transmission_coefficient = std::tan(p.flank_angle);
  wg.bearing = bearing;
  wg.inner_ring_thickness = walls.inner_ring;
  wg.inner_ring_width = walls.bearing_width;
  wg.inner_ring_mean_radius = pitch - walls.ball / 2 - walls.inner_ring / 2;
  return wg;
}

const Proportion& proportion(std::string_view name) {
  return *std::ranges::find(kProportions, name, &Proportion::name);
}

std::string type_text(const DriveType& type) {
  return fmt::format("{} {}{}", enum_name(type.length), enum_name(type.form),
                     type.blank == Blank::size ? ", blank of its size" : "");
}

/// The limits of a proportion as written in a comment of the file.
std::string limits_of(const Proportion& p) {
  if (p.name == "flank_angle") return fmt::format("{:g} to {:g} deg", p.lower / deg, p.upper / deg);
  if (p.name == "lobe_gap" || p.name == "clearance")
    return fmt::format("{:.2g} to {:.2g} 1e-6", 1e6 * p.lower, 1e6 * p.upper);
  if (p.knowledge == kStress)
    return fmt::format("{:g} to {:g} MPa", p.lower / kMPa, p.upper / kMPa);
  return fmt::format("{:.4g} to {:.4g}", p.lower, p.upper);
}

/// The basis of a proportion with its limits.
std::string remark(std::string_view name, std::string_view before = {}) {
  const Proportion& p = proportion(name);
  return fmt::format("{}{}: {} {}; {}", before, enum_name(p.knowledge), p.symbol, limits_of(p),
                     p.source);
}

/// The rule that decided a wall, with the stress by the wave.
/// @param drawing  the proportion that gives the wall
/// @param limit    the stress that may make it thinner
/// @param stress   of the wall as decided [Pa]
std::string remark(const Wall& wall, std::string_view drawing, std::string_view limit,
                   double stress, double of_ratio) {
  const Proportion& p = proportion(limit);
  const double most = ProportionValues{}.*p.value;
  switch (wall.by) {
    case Decides::drawing:
      return fmt::format("{}; {} {:.0f} MPa, less than its limit {:g} MPa", remark(drawing),
                         p.symbol, stress / kMPa, most / kMPa);
    case Decides::stress:
      return fmt::format("stress: limited to {:g} MPa ({}) at the deflection of ratio {:g}; {}",
                         most / kMPa, limits_of(p), of_ratio, p.source);
    case Decides::least:
      return fmt::format(
          "assumed: {:g} d, the least thickness; {} {:.0f} MPa, above its limit {:g} MPa",
          kLeastDiaphragm, p.symbol, stress / kMPa, most / kMPa);
  }
  return {};
}

/// Whether a proportion decides the number of a starting drive at its path.
bool decides(const Proportion& p, const TypicalWalls& walls, FlexsplineForm form) {
  if (p.path.empty()) return false;
  if (p.name == "diaphragm_thickness") return walls.diaphragm.by == Decides::drawing;
  if (p.name == "diaphragm_stress") return walls.diaphragm.by == Decides::stress;
  if (p.name == "boss_diameter") return form == FlexsplineForm::cup;
  if (p.name == "flange_diameter") return form == FlexsplineForm::hat;
  return true;
}

/// Rounds all numbers to six digits, as the file shows them.
void round_numbers(GearSet& gear) {
  for_each_number(gear, [](const FieldPath&, const Field& field, double& value) {
    if (field.unit == "m") value = rounded(value, mm, "mm", field.unit);
    if (field.unit == "rad") value = rounded(value, deg, "deg", field.unit);
    if (field.unit == "1") value = rounded(value, 1.0, "1", field.unit);
    if (field.unit == "N*m") value = rounded(value, 1.0, "N*m", field.unit);
  });
  // Some parts must still fit after rounding: balls between their races, sections in the cup.  They
  // are reduced by one part in 1e5, which always gives a different number of six digits.
  Bearing& bearing = *gear.wave_generator->bearing;
  const double between = (bearing.outer_raceway_diameter - bearing.inner_raceway_diameter) / 2;
  if (bearing.ball_diameter > between) bearing.ball_diameter = rounded(between, mm, "mm", "m");
  while (bearing.ball_diameter > between * (1 + 1e-12))
    bearing.ball_diameter = rounded(bearing.ball_diameter * (1 - 1e-5), mm, "mm", "m");
  Flexspline& fs = *gear.flexspline;
  fs.barrel->length = rounded(*fs.length - fs.rim->length, mm, "mm", "m");
  while (*fs.length < (fs.barrel->length + fs.rim->length) * (1 - 1e-12))
    fs.barrel->length = rounded(fs.barrel->length * (1 - 1e-5), mm, "mm", "m");
}

/// The rating of a short drive of this size and ratio; null if unknown.  Makers rate cups and hats
/// of this length alike.
const RatingRow* rating_of(int size, double ratio, const DriveType& type) {
  return type.length == FlexsplineLength::short_length ? find_rating(size, ratio) : nullptr;
}

/// Torques, speeds and life that the tables state for a drive.
void state_limits(Rating& rating, const RatingRow& rated) {
  rating.rated_torque = rated.rated;
  rating.average_torque = rated.average;
  rating.repeated_peak = rated.repeated_peak;
  rating.momentary_peak = rated.momentary_peak;
  rating.largest_speed = rated.max_input_speed;
  rating.average_speed = rated.average_input_speed;
  if (const RatedLife* const life = find_rated_life(rated.series))
    rating.bearing_life = life->ten_percent;
  if (const auto* const row = find_torque_limits(rated.series, rated.size, rated.ratio)) {
    rating.ratcheting_torque = row->ratcheting;
    rating.buckling_torque = row->buckling;
  }
}

/// Origin of each number of a starting drive, by its path.
/// @param walls  those of the drive
std::map<std::string, std::string> origins(const GearSet& gear, int size, const DriveType& type,
                                           const TypicalWalls& walls) {
  const double ratio = gear.drive.ratio;
  const double of_ratio = wall_ratio(ratio, type);
  const RatingRow* const rated = rating_of(size, ratio, type);
  // The stresses of the blank, which may be made for the wave of another ratio.
  const WaveStresses stresses =
      wave_stresses(typical_drive(gear.drive.pitch_diameter, of_ratio, type));
  const bool hat = type.form == FlexsplineForm::hat;
  std::map<std::string, std::string> comments = {
      {"drive.ratio", rated != nullptr ? fmt::format("catalogue: series {}", rated->series)
                                       : "assumed: the rating of this size and ratio is unknown"},
      {"drive.wave_number", "catalogue: all makers' drives of this kind"},
      {"drive.pitch_diameter", "catalogue: 2.54 mm times the size"},
      {"load.torque", rated != nullptr ? "catalogue: rated torque"
                                       : "catalogue: T2, because the rated torque is unknown"},
      {"material.steel.youngs_modulus", "typical: alloy steel, 2 %"},
      {"material.steel.poissons_ratio", "typical"},
      {"rating.T1", "catalogue: T1 of this size, the same for all ratios"},
      {"rating.T2", "catalogue: T2 of this size, the same for all ratios"},
      {"flexspline.wall_thickness", "as rim.wall_thickness"},
      {"flexspline.length",
       remark(type.length == FlexsplineLength::standard       ? "standard_length"
              : type.length == FlexsplineLength::short_length ? "short_length"
                                                              : "flat_length")},
      {"flexspline.rim.outer_diameter", remark("dedendum", "roots; ")},
      {"flexspline.rim.wall_thickness",
       remark(walls.rim, "rim_thickness", "rim_stress", stresses.rim, of_ratio)},
      {"flexspline.rim.length",
       remark(type.length == FlexsplineLength::flat ? "flat_face_width" : "face_width")},
      {"flexspline.barrel.outer_diameter", "same mean diameter as the rim"},
      {"flexspline.barrel.length", "flexspline.length minus the length of the rim"},
      {hat ? "flexspline.diaphragm.inner_diameter" : "flexspline.diaphragm.outer_diameter",
       "mean diameter of the barrel"},
      {"flexspline.diaphragm.thickness", remark(walls.diaphragm, "diaphragm_thickness",
                                                "diaphragm_stress", stresses.diaphragm, of_ratio)},
      {"wave_generator.force_transmission_coefficient", "tan(mesh.flank_angle)"},
      {"wave_generator.inner_ring_thickness", "half of the section outside the ball"},
      {"wave_generator.inner_ring_width", "same as the outer ring"},
      {"wave_generator.inner_ring_mean_radius", remark("bearing_bore")},
      {"wave_generator.bearing.ball_diameter", remark("ball_diameter")},
      {"wave_generator.bearing.inner_raceway_diameter", "balls inside the outer ring"},
      {"wave_generator.bearing.outer_raceway_diameter", "balls inside the outer ring"},
      {"wave_generator.bearing.inner_conformity", remark("conformity")},
      {"wave_generator.bearing.outer_conformity", remark("conformity")},
      {"wave_generator.bearing.loaded_balls",
       "assumed: five balls share the force of a lobe; not used by the torsion curve"},
      {"wave_generator.bearing.ball_count", remark("ball_count")},
      {"wave_generator.bearing.outer_ring.mean_radius", "fills the bore of the flexspline"},
      {"wave_generator.bearing.outer_ring.thickness",
       remark(walls.outer_ring, "ball_diameter", "ring_stress", stresses.outer_ring, of_ratio)},
      {"mesh.tooth.tips",
       "assumed: makers relieve the tips, because a leaving tooth would touch the next flank"},
      {"mesh.tooth.addendum", remark("tooth_addendum")},
      {"mesh.tooth.spline_addendum", remark("tooth_addendum")},
      {"circular_spline.width", "assumed: same as the face width"}};
  if (rated != nullptr) {
    comments["rating.rated_torque"] =
        fmt::format("catalogue: series {}, at an input of 2000 rpm", rated->series);
    for (const std::string_view limit :
         {"average_torque", "repeated_peak", "momentary_peak", "ratcheting_torque",
          "buckling_torque", "largest_speed", "average_speed", "bearing_life"})
      comments[fmt::format("rating.{}", limit)] =
          fmt::format("catalogue: series {}", rated->series);
  }
  for (const Proportion& p : kProportions)
    if (decides(p, walls, type.form)) comments.try_emplace(std::string(p.path), remark(p.name));
  return comments;
}

/// The density of low alloy steels [kg/m^3].
constexpr double kSteelDensity = 7850.0;
/// Assumed inertias lie within these factors.
constexpr double kLeastInertia = 0.2;
constexpr double kMostInertia = 5.0;

/// A row with the maker's inertia of the wave generator, which is the same for all ratios of a
/// size; null for a size that the table does not have.
const RatingRow* inertia_row(int size) {
  const auto row = std::ranges::find(rating_rows(), size, &RatingRow::size);
  return row != rating_rows().end() ? &*row : nullptr;
}

/// Adds motor and load to a starting drive, with ranges and comments.
void add_drivetrain(CommentedDrive& drive, int size, const DriveType& type) {
  const auto inertia = [](double value) { return rounded(value, 1.0, "kg*m^2", "kg*m^2"); };
  const bool short_cup =
      type.form == FlexsplineForm::cup && type.length == FlexsplineLength::short_length;
  const RatingRow* const catalogue = short_cup ? inertia_row(size) : nullptr;
  // Inertias of similar parts are in proportion to d^5.
  const auto by_size = [size] { return inertia_row(25)->input_inertia * std::pow(size / 25.0, 5); };
  Drivetrain of;
  of.motor_inertia = inertia(catalogue != nullptr ? catalogue->input_inertia : by_size());
  if (catalogue != nullptr) of.wave_generator_inertia = of.motor_inertia;
  const double input = of.motor_inertia + of.wave_generator_inertia.value_or(0.0);
  of.load_inertia = inertia(drive.gear.drive.ratio * drive.gear.drive.ratio * input);
  drive.gear.drivetrain = of;
  drive.gear.material.at("steel").density = kSteelDensity;
  drive.comments["material.steel.density"] = "typical: low alloy steels";
  drive.comments["drivetrain.motor_inertia"] =
      catalogue != nullptr
          ? "assumed: as large as the wave generator; give that of your motor"
          : "assumed: that of size 25 times the fifth power of the sizes' ratio; it contains the "
            "wave generator, whose inertia is not in the tables; give that of your motor";
  if (catalogue != nullptr)
    drive.comments["drivetrain.wave_generator_inertia"] = fmt::format(
        "catalogue: series {}, the wave generator without motor and coupling", catalogue->series);
  drive.comments["drivetrain.load_inertia"] =
      "assumed: ratio^2 times the inertia of the input; give that of your load";
  drive.comments["drivetrain.gear_damping"] = "not known; 0 leaves the damping out";
  for (const auto& [path, value] : {std::pair{"drivetrain.motor_inertia", of.motor_inertia},
                                    std::pair{"drivetrain.load_inertia", of.load_inertia}})
    drive.gear.range.push_back({.path = path,
                                .lower = fmt::format("{:.4g} kg*m^2", kLeastInertia * value),
                                .upper = fmt::format("{:.4g} kg*m^2", kMostInertia * value),
                                .knowledge = Knowledge::assumed,
                                .source = "depends on the machine"});
}

/// The limits of one number of a starting drive; they contain the number of the file in spite of
/// its rounding.
/// @param drawn  the drive with the proportion at a value
template <class Drawn>
InputRange range_of(const GearSet& gear, const Proportion& p, const Drawn& drawn) {
  const NumberAt at = number_at(gear, p.path);
  const auto limit = [&](double proportion) {
    const double exact = number_at(drawn(proportion), p.path).value;
    if (at.field.unit == "m")
      return std::abs(exact) < 0.01 * mm ? fmt::format("{:.4g} um", exact / (1e-3 * mm))
                                         : fmt::format("{:.4g} mm", exact / mm);
    if (at.field.unit == "rad") return fmt::format("{:.4g} deg", exact / deg);
    return fmt::format("{:.4g}", exact);
  };
  InputRange range{.path = std::string(p.path),
                   .lower = limit(p.lower),
                   .upper = limit(p.upper),
                   .knowledge = p.knowledge,
                   .source = std::string(p.source)};
  // If the value equals a limit, four digits of the limit may exclude the value.
  const auto value_of = [&](const std::string& text) {
    return parse_quantity(p.path, text, at.field.unit);
  };
  const std::string value = at.field.unit == "m" ? fmt::format("{:.6g} mm", at.value / mm)
                                                 : quantity_text(at.value, at.field.unit);
  if (value_of(range.lower) > at.value) range.lower = value;
  if (value_of(range.upper) < at.value) range.upper = value;
  return range;
}

}  // namespace

std::span<const Proportion> proportions() { return kProportions; }

ProportionValues draw_proportions(std::mt19937_64& generator) {
  ProportionValues values;
  for (const Proportion& p : kProportions)
    values.*p.value = p.lower + (p.upper - p.lower) * uniform(generator);
  return values;
}

void require_typical_ratio(double ratio) {
  require(ratio >= 30 && ratio <= 320, "ratio", ratio, "1", ">= 30 and <= 320");
  require(std::abs(2 * ratio - std::round(2 * ratio)) < 1e-9, "ratio", ratio, "1",
          "2 ratio, the teeth of the flexspline, a whole number");
}

GearSet typical_drive(double pitch_diameter, double ratio, const DriveType& type,
                      const ProportionValues& p) {
  const double d = pitch_diameter;
  require(d > 0 && std::isfinite(d), "pitch_diameter", d, "m", "> 0");
  require_typical_ratio(ratio);
  const double m = d / (2 * ratio);
  const TypicalWalls walls = typical_walls(d, wall_ratio(ratio, type), type, p);
  const double R = d / 2 - p.dedendum * m - walls.rim.thickness / 2;
  GearSet gear;
  gear.name =
      fmt::format("Typical drive, d = {:.5g} mm, ratio {:g}, {}", d / mm, ratio, type_text(type));
  gear.material["steel"] = typical_steel();
  gear.drive = {.ratio = ratio,
                .wave_number = 2,
                .pitch_diameter = d,
                .radial_displacement = p.radial_displacement * m};
  gear.load.torque = 0.187e6 * d * d * d;
  gear.flexspline = typical_flexspline(d, R, walls, type.form, p);
  gear.wave_generator = typical_wave_generator(d, 2 * R - walls.rim.thickness, walls, p);

  ToothMesh mesh;
  mesh.flank_angle = p.flank_angle;
  mesh.gap_factor = p.gap_factor;
  mesh.coning = p.coning;
  mesh.lobe_gap = p.lobe_gap * d;
  mesh.friction_coefficient = p.friction;
  mesh.rim_stiffening = p.rim_stiffening;
  mesh.tooth = ToothShape{.profile = ToothProfile::straight,
                          .addendum = p.tooth_addendum * m,
                          .spline_addendum = p.tooth_addendum * m,
                          .thickness = {},
                          .tips = ToothTips::relieved};
  gear.mesh = mesh;

  CircularSpline spline;
  spline.material = "steel";
  spline.outer_diameter = p.spline_outer_diameter * d;
  spline.inner_diameter = d + p.spline_root * m;
  spline.width = walls.face_width;
  spline.support = p.spline_support;
  gear.circular_spline = spline;
  return gear;
}

GearSet typical_drive_of_size(int size, double ratio, const DriveType& type,
                              const ProportionValues& values) {
  require_catalogue_size(size);
  GearSet gear = typical_drive(pitch_diameter_of(size), ratio, type, values);
  gear.name = fmt::format("Typical drive, size {}, ratio {:g}, {}", size, ratio, type_text(type));
  // T1 and T2 of a size are the same for all ratios.
  const StiffnessRow* const row = find_stiffness(size, ratio);
  const StiffnessRow& torques = row != nullptr ? *row : *find_stiffness(size, 50);
  Rating rating;
  rating.T1 = torques.T1;
  rating.T2 = torques.T2;
  const RatingRow* const rated = rating_of(size, ratio, type);
  if (rated != nullptr) state_limits(rating, *rated);
  gear.rating = rating;
  gear.load.torque = rated != nullptr ? rated->rated : torques.T2;
  return gear;
}

CommentedDrive starting_drive(int size, double ratio, const DriveType& type) {
  CommentedDrive drive{.gear = typical_drive_of_size(size, ratio, type), .comments = {}};
  const TypicalWalls walls =
      typical_walls(pitch_diameter_of(size), wall_ratio(ratio, type), type, {});
  drive.comments = origins(drive.gear, size, type, walls);
  round_numbers(drive.gear);
  for (const Proportion& p : kProportions)
    if (decides(p, walls, type.form))
      drive.gear.range.push_back(range_of(drive.gear, p, [&](double value) {
        ProportionValues one;
        one.*p.value = value;
        return typical_drive_of_size(size, ratio, type, one);
      }));
  add_drivetrain(drive, size, type);
  check(drive.gear);
  return drive;
}

}  // namespace strainwave
