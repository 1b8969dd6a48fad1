// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/proportions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

using units::deg;
using units::mm;

constexpr Knowledge kTypical = Knowledge::typical;
constexpr Knowledge kAssumed = Knowledge::assumed;
using Values = ProportionValues;

// clang-format off
constexpr std::array<Proportion, 25> kProportions = {{
    {"rim_thickness", "t_r over its law", &Values::rim_thickness, 0.8, 1.2, kTypical,
     "handbook law 1e-4 (65 + 2.5 i^(2/3)) d; 0.010 to 0.015 d in samples", ""},
    {"barrel_thickness", "t_b/t_r", &Values::barrel_thickness, 0.5, 0.9, kTypical,
     "handbooks; little is known about short cups", "flexspline.barrel.wall_thickness"},
    {"short_cup_length", "L/d, short cup", &Values::short_cup_length, 0.38, 0.46, kTypical,
     "makers: about half the length of older long cups", ""},
    {"standard_cup_length", "L/d, standard cup", &Values::standard_cup_length, 0.7, 1.0, kTypical,
     "handbooks; older component sets", ""},
    {"face_width", "b/d", &Values::face_width, 0.12, 0.20, kTypical,
     "published samples, 0.12 to 0.17; handbooks", ""},
    {"diaphragm_thickness", "t_d/d", &Values::diaphragm_thickness, 0.008, 0.020, kTypical,
     "mean of a few samples, mostly tapered", "flexspline.diaphragm.thickness"},
    {"boss_diameter", "over d", &Values::boss_diameter, 0.493, 0.667, kTypical,
     "bolt circles in a maker's drawings, 0.45 to 0.50 d, and two bolt diameters", "flexspline.diaphragm.inner_diameter"},
    {"dedendum", "h_f/m", &Values::dedendum, 1.1, 1.35, kTypical,
     "published samples", ""},
    {"flank_angle", "alpha", &Values::flank_angle, 18 * deg, 26 * deg, kAssumed,
     "makers do not publish the working tooth; 20 degrees is traditional", "mesh.flank_angle"},
    {"coning", "chi", &Values::coning, 0.1, 1.0, kAssumed,
     "teeth not corrected for the tilt of the cup; makers may correct their teeth", "mesh.coning"},
    {"gap_factor", "k_g", &Values::gap_factor, 0.8, 1.2, kAssumed,
     "straight flanks on the tooth path; the true flank is not published", "mesh.gap_factor"},
    {"radial_displacement", "w_0/m", &Values::radial_displacement, 0.9, 1.05, kTypical,
     "handbooks and samples; smaller in some designs of low ratio", "drive.radial_displacement"},
    {"rim_stiffening", "C_tr", &Values::rim_stiffening, 1.2, 1.3, kTypical,
     "published finite elements of toothed rims", "mesh.rim_stiffening"},
    {"bearing_bore", "over D", &Values::bearing_bore, 0.72, 0.78, kTypical,
     "standard series of flexible bearings, 0.71 to 0.77", ""},
    {"bearing_width", "over D", &Values::bearing_width, 0.145, 0.167, kTypical,
     "standard series of flexible bearings", "wave_generator.bearing.outer_ring.width"},
    {"ball_diameter", "over the section", &Values::ball_diameter, 0.5185, 0.7015, kTypical,
     "published samples and bearing practice", ""},
    {"ball_count", "balls", &Values::ball_count, 19, 27, kTypical,
     "bearings of this kind have 19 to 27 balls", ""},
    {"conformity", "groove radius over ball", &Values::conformity, 0.52, 0.54, kTypical,
     "bearing practice", ""},
    {"groove_factor", "share of the ring's bending stiffness", &Values::groove_factor, 0.7, 0.9, kAssumed,
     "estimated from the section of a grooved ring", "wave_generator.bearing.outer_ring.groove_factor"},
    {"spline_outer_diameter", "over d", &Values::spline_outer_diameter, 1.30, 1.41, kTypical,
     "makers' outside diameters and bolt circles", "circular_spline.outer_diameter"},
    {"spline_root", "(inner diameter - d)/m", &Values::spline_root, 4.2, 4.7, kTypical,
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

/// The toothed ring, from which the other dimensions follow.
struct TypicalRim {
  double radius = 0.0;     // radius R of the mean line [m]
  double thickness = 0.0;  // t_r [m]
  double width = 0.0;      // b [m]
};

TypicalRim typical_rim(double d, double ratio, const ProportionValues& p) {
  const double m = d / (2 * ratio);
  const double t_r = p.rim_thickness * 1e-4 * (65 + 2.5 * std::cbrt(ratio * ratio)) * d;
  return {.radius = d / 2 - p.dedendum * m - t_r / 2, .thickness = t_r, .width = p.face_width * d};
}

Flexspline typical_flexspline(double d, const TypicalRim& rim, Cup cup, const ProportionValues& p) {
  const auto& [R, t_r, b] = rim;
  const double t_b = p.barrel_thickness * t_r;
  const double L = (cup == Cup::standard ? p.standard_cup_length : p.short_cup_length) * d;
  Flexspline fs;
  fs.material = "steel";
  fs.wall_thickness = t_r;
  fs.length = L;
  fs.crack_free = CrackFree::sections;
  fs.rim = TubeSection{.outer_diameter = 2 * R + t_r, .wall_thickness = t_r, .length = b};
  fs.barrel = TubeSection{.outer_diameter = 2 * R + t_b, .wall_thickness = t_b, .length = L - b};
  fs.diaphragm = Diaphragm{.outer_diameter = 2 * R,
                           .inner_diameter = p.boss_diameter * d,
                           .thickness = p.diaphragm_thickness * d,
                           .profile = {}};
  return fs;
}

/// @param bore  bore of the flexspline, which the bearing fills [m]
WaveGenerator typical_wave_generator(double d, double bore, const ProportionValues& p) {
  const double section = bore * (1 - p.bearing_bore) / 2;
  const double ball = p.ball_diameter * section;
  const double pitch = bore / 2 - section / 2;  // radius of the balls' circle
  const double ring = (section - ball) / 2;
  Bearing bearing;
  bearing.ball_diameter = ball;
  bearing.inner_raceway_diameter = 2 * pitch - ball;
  bearing.outer_raceway_diameter = 2 * pitch + ball;
  bearing.inner_conformity = p.conformity;
  bearing.outer_conformity = p.conformity;
  bearing.loaded_balls = 5;
  bearing.ball_count = static_cast<int>(std::lround(p.ball_count));
  bearing.clearance = p.clearance * d;
  bearing.outer_ring = BearingRing{.mean_radius = bore / 2 - ring / 2,
                                   .thickness = ring,
                                   .width = p.bearing_width * bore,
                                   .groove_factor = p.groove_factor};
  WaveGenerator wg;
  wg.material = "steel";
  wg.force_transmission_coefficient = std::tan(p.flank_angle);
  wg.bearing = bearing;
  wg.inner_ring_thickness = ring;
  wg.inner_ring_width = p.bearing_width * bore;
  wg.inner_ring_mean_radius = bore / 2 - section + ring / 2;
  return wg;
}

/// The limits of a proportion as written in a comment of the file.
std::string limits_of(const Proportion& p) {
  if (p.name == "flank_angle") return fmt::format("{:g} to {:g} deg", p.lower / deg, p.upper / deg);
  if (p.name == "lobe_gap" || p.name == "clearance")
    return fmt::format("{:.2g} to {:.2g} 1e-6", 1e6 * p.lower, 1e6 * p.upper);
  return fmt::format("{:.4g} to {:.4g}", p.lower, p.upper);
}

/// The basis of a proportion with its limits.
std::string remark(std::string_view name, std::string_view before = {}) {
  const auto p = std::ranges::find(kProportions, name, &Proportion::name);
  return fmt::format("{}{}: {} {}; {}", before, enum_name(p->knowledge), p->symbol, limits_of(*p),
                     p->source);
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

/// Origin of each number of a starting drive, by its path.
std::map<std::string, std::string> origins(int size, double ratio, Cup cup) {
  const RatingRow* const rated = find_rating(size, ratio);
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
       remark(cup == Cup::standard ? "standard_cup_length" : "short_cup_length")},
      {"flexspline.rim.outer_diameter", remark("dedendum", "roots; ")},
      {"flexspline.rim.wall_thickness", remark("rim_thickness")},
      {"flexspline.rim.length", remark("face_width")},
      {"flexspline.barrel.outer_diameter", "same mean diameter as the rim"},
      {"flexspline.barrel.length", "flexspline.length minus the length of the rim"},
      {"flexspline.diaphragm.outer_diameter", "mean diameter of the barrel"},
      {"wave_generator.force_transmission_coefficient", "tan(mesh.flank_angle)"},
      {"wave_generator.inner_ring_thickness", "same as the outer ring"},
      {"wave_generator.inner_ring_width", "same as the outer ring"},
      {"wave_generator.inner_ring_mean_radius", remark("bearing_bore")},
      {"wave_generator.bearing.ball_diameter", remark("ball_diameter")},
      {"wave_generator.bearing.inner_raceway_diameter", "balls in the middle of the section"},
      {"wave_generator.bearing.outer_raceway_diameter", "balls in the middle of the section"},
      {"wave_generator.bearing.inner_conformity", remark("conformity")},
      {"wave_generator.bearing.outer_conformity", remark("conformity")},
      {"wave_generator.bearing.loaded_balls",
       "assumed: five balls share the force of a lobe; not used by the torsion curve"},
      {"wave_generator.bearing.ball_count", remark("ball_count")},
      {"wave_generator.bearing.outer_ring.mean_radius", "fills the bore of the flexspline"},
      {"wave_generator.bearing.outer_ring.thickness", "half of the section outside the ball"},
      {"circular_spline.width", "assumed: same as the face width"}};
  if (rated != nullptr)
    comments["rating.rated_torque"] =
        fmt::format("catalogue: series {}, at an input of 2000 rpm", rated->series);
  for (const Proportion& p : kProportions)
    if (!p.path.empty()) comments.try_emplace(std::string(p.path), remark(p.name));
  return comments;
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

GearSet typical_drive(double pitch_diameter, double ratio, Cup cup, const ProportionValues& p) {
  const double d = pitch_diameter;
  require(d > 0 && std::isfinite(d), "pitch_diameter", d, "m", "> 0");
  require_typical_ratio(ratio);
  const double m = d / (2 * ratio);
  const TypicalRim rim = typical_rim(d, ratio, p);
  GearSet gear;
  gear.name = fmt::format("Typical drive, d = {:.5g} mm, ratio {:g}, {} cup", d / mm, ratio,
                          enum_name(cup));
  Material steel;
  steel.youngs_modulus = 206 * units::GPa;
  steel.poissons_ratio = 0.3;
  gear.material["steel"] = steel;
  gear.drive = {.ratio = ratio,
                .wave_number = 2,
                .pitch_diameter = d,
                .radial_displacement = p.radial_displacement * m};
  gear.load.torque = 0.187e6 * d * d * d;
  gear.flexspline = typical_flexspline(d, rim, cup, p);
  gear.wave_generator = typical_wave_generator(d, 2 * rim.radius - rim.thickness, p);

  ToothMesh mesh;
  mesh.flank_angle = p.flank_angle;
  mesh.gap_factor = p.gap_factor;
  mesh.coning = p.coning;
  mesh.lobe_gap = p.lobe_gap * d;
  mesh.friction_coefficient = p.friction;
  mesh.rim_stiffening = p.rim_stiffening;
  gear.mesh = mesh;

  CircularSpline spline;
  spline.material = "steel";
  spline.outer_diameter = p.spline_outer_diameter * d;
  spline.inner_diameter = d + p.spline_root * m;
  spline.width = rim.width;
  spline.support = p.spline_support;
  gear.circular_spline = spline;
  return gear;
}

GearSet typical_drive_of_size(int size, double ratio, Cup cup, const ProportionValues& values) {
  require_catalogue_size(size);
  GearSet gear = typical_drive(pitch_diameter_of(size), ratio, cup, values);
  gear.name =
      fmt::format("Typical drive, size {}, ratio {:g}, {} cup", size, ratio, enum_name(cup));
  // T1 and T2 of a size are the same for all ratios.
  const StiffnessRow* const row = find_stiffness(size, ratio);
  const StiffnessRow& torques =
      row != nullptr ? *row : nearest_stiffness(pitch_diameter_of(size), 50);
  Rating rating;
  rating.T1 = torques.T1;
  rating.T2 = torques.T2;
  const RatingRow* const rated = find_rating(size, ratio);
  if (rated != nullptr) rating.rated_torque = rated->rated;
  gear.rating = rating;
  gear.load.torque = rated != nullptr ? rated->rated : torques.T2;
  return gear;
}

CommentedDrive starting_drive(int size, double ratio, Cup cup) {
  CommentedDrive drive{.gear = typical_drive_of_size(size, ratio, cup),
                       .comments = origins(size, ratio, cup)};
  round_numbers(drive.gear);
  for (const Proportion& p : kProportions)
    if (!p.path.empty())
      drive.gear.range.push_back(range_of(drive.gear, p, [&](double value) {
        ProportionValues one;
        one.*p.value = value;
        return typical_drive_of_size(size, ratio, cup, one);
      }));
  check(drive.gear);
  return drive;
}

}  // namespace strainwave
