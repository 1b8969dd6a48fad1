// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <string_view>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Proportions of cup-type drives, with what is known about each, and the drive that they make.
///
/// No maker publishes the geometry of a drive.  Handbooks, patents and measured samples give most
/// lengths as multiples of the pitch diameter d within 5 to 50 %; a few numbers nobody gives.

namespace strainwave {

enum class Cup {
  short_cup,  ///< component sets of today: length 0.42 d
  standard,   ///< the long cup of handbooks: length 0.85 d
};
template <>
struct EnumNames<Cup> {
  static constexpr std::array<std::string_view, 2> names = {"short", "standard"};
};

/// One value of each proportion; those of a member without comment are the base values.
struct ProportionValues {
  double rim_thickness = 1.0;          ///< t_r over its law, 1e-4 (65 + 2.5 i^(2/3)) d [-]
  double barrel_thickness = 0.6;       ///< t_b/t_r [-]
  double short_cup_length = 0.42;      ///< L/d of Cup::short_cup [-]
  double standard_cup_length = 0.85;   ///< L/d of Cup::standard [-]
  double face_width = 0.15;            ///< b/d [-]
  double diaphragm_thickness = 0.012;  ///< t_d/d [-]
  double boss_diameter = 0.58;         ///< over d [-]
  double dedendum = 1.1;               ///< h_f/m [-]
  double flank_angle = 22 * std::numbers::pi / 180;  ///< alpha [rad]
  double coning = 1.0;                               ///< chi [-]
  double gap_factor = 1.0;                           ///< k_g [-]
  double radial_displacement = 1.0;                  ///< w_0/m [-]
  double rim_stiffening = 1.25;                      ///< C_tr [-]
  double bearing_bore = 0.75;                        ///< over the bore D of the flexspline [-]
  double bearing_width = 0.15;                       ///< over D [-]
  double ball_diameter = 0.61;                       ///< over the bearing's section [-]
  double ball_count = 23;                            ///< rounded to a whole number [-]
  double conformity = 0.53;                          ///< of both races [-]
  double groove_factor = 0.8;                        ///< of the outer ring [-]
  double spline_outer_diameter = 1.34;               ///< over d [-]
  double spline_root = 4.2;     ///< inner diameter of the circular spline is d + this times m [-]
  double spline_support = 0.5;  ///< s_h [-]
  double lobe_gap = 0.0;        ///< normal gap over d; 16e-6 is 1 um at size 25 [-]
  double clearance = 0.0;       ///< radial play at a ball over d [-]
  double friction = 0.1;        ///< mu of the flanks [-]
};

/// What is known about one proportion.
struct Proportion {
  std::string_view name;    ///< as the member of ProportionValues
  std::string_view symbol;  ///< with what it is divided by
  double ProportionValues::*value;
  double lower = 0.0;  ///< unit of the value
  double upper = 0.0;
  Knowledge knowledge = Knowledge::typical;
  std::string_view source;
  std::string_view path;  ///< of the number in a file, if the rest may stay; else empty
};

/// All proportions, in the order of ProportionValues.
///
/// The values stood before any was compared with a catalogue; the support of the circular spline
/// is the middle of its plausible range.
[[nodiscard]] std::span<const Proportion> proportions();

/// Proportions drawn uniformly and independently between their limits.
///
/// The same seed gives the same numbers with every compiler: the generator is std::mt19937_64,
/// which the standard fixes, and its 53 upper bits become the uniform number here.
[[nodiscard]] ProportionValues draw_proportions(std::mt19937_64& generator);

/// A complete and consistent drive of a pitch diameter, without a rating: the torques T1 and T2
/// are then 0.0517 d^3 and 0.187 d^3 N/mm^2 (model/rating.hpp).
///
/// With m = d/(2 i): R = d/2 - h_f - t_r/2 is the mean radius of rim, barrel and diaphragm's edge;
/// D = 2 R - t_r the bore; the bearing fills it.
///
/// @param pitch_diameter  d [m]; > 0
/// @param ratio           i_h [-]; 30 to 320, 2 i a whole number of teeth
/// @throws InputError     if the ratio is not one of those
[[nodiscard]] GearSet typical_drive(double pitch_diameter, double ratio, Cup cup = Cup::short_cup,
                                    const ProportionValues& values = {});

/// The same for a size of the catalogue, with its T1 and T2, and its rated torque where there is
/// one for this very ratio.
/// @throws InputError  if the catalogue has no such size; sizes between its own are refused too,
///                     because their torques would be nobody's
[[nodiscard]] GearSet typical_drive_of_size(int size, double ratio, Cup cup = Cup::short_cup,
                                            const ProportionValues& values = {});

/// A drive for a file: with ranges, and a remark for each number, by its path.
struct CommentedDrive {
  GearSet gear;
  std::map<std::string, std::string> comments;
};

/// The typical drive of a size with lengths rounded to six digits, `range` for every proportion
/// that sets one number of the file, and comments that say how each number is known.
/// @throws InputError  as typical_drive_of_size
[[nodiscard]] CommentedDrive starting_drive(int size, double ratio, Cup cup = Cup::short_cup);

}  // namespace strainwave
