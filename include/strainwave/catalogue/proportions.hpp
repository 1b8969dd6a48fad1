// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <string_view>

#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Proportions of drives with the knowledge about each, and typical drives made from them.
///
/// No maker publishes the geometry of a drive.  Handbooks, patents and measured samples give most
/// lengths as multiples of the pitch diameter d within 5 to 50 %.  Stress limits its walls where
/// the wave would break them.  A few numbers are not published anywhere.

namespace strainwave {

/// The wave for which the walls of a typical drive are made.
enum class Blank {
  ratio,  ///< that of the drive's own ratio
  size,  ///< that of ratio 100: one blank for all ratios of a size, with its teeth cut to the ratio
};
template <>
struct EnumNames<Blank> {
  static constexpr std::array<std::string_view, 2> names = {"ratio", "size"};
};

/// The kind of a typical drive.
struct DriveType {
  FlexsplineForm form = FlexsplineForm::cup;                 ///< shape of the flexspline
  FlexsplineLength length = FlexsplineLength::short_length;  ///< length class of the flexspline
  Blank blank = Blank::ratio;  ///< the wave for which the walls are made

  /// Order by form, then length, then blank.
  friend auto operator<=>(const DriveType&, const DriveType&) = default;
};

/// One value of each proportion.  The initial values are the base values.
struct ProportionValues {
  double rim_thickness = 1.0;          ///< t_r over 1e-4 (65 + 2.5 i^(2/3)) d [-]
  double rim_stress = 220e6;           ///< limit of (CV-1) in the rim [Pa]
  double barrel_thickness = 0.6;       ///< t_b/t_r [-]
  double standard_length = 0.85;       ///< L/d of FlexsplineLength::standard [-]
  double short_length = 0.42;          ///< L/d of FlexsplineLength::short_length [-]
  double flat_length = 0.21;           ///< L/d of FlexsplineLength::flat [-]
  double face_width = 0.15;            ///< b/d, but of a flat flexspline [-]
  double flat_face_width = 0.11;       ///< b/d of a flat flexspline [-]
  double diaphragm_thickness = 0.012;  ///< t_d/d, unless the stress limits it [-]
  double diaphragm_stress = 350e6;     ///< limit of (CV-2) in the diaphragm [Pa]
  double boss_diameter = 0.58;         ///< outer diameter of a cup's boss over d [-]
  double flange_diameter = 1.42;       ///< where the clamped flange of a hat begins, over d [-]
  double dedendum = 1.1;               ///< h_f/m [-]
  double tooth_addendum = 0.65;        ///< h_a/m and h_ac/m of the teeth as drawn [-]
  double flank_angle = 22 * std::numbers::pi / 180;  ///< alpha [rad]
  double coning = 1.0;                               ///< chi [-]
  double gap_factor = 1.0;                           ///< k_g [-]
  double radial_displacement = 1.0;                  ///< w_0/m [-]
  double rim_stiffening = 1.25;                      ///< C_tr [-]
  /// bearing bore over the bore D of the flexspline, unless the stress of the ring limits it [-]
  double bearing_bore = 0.75;
  double bearing_width = 0.15;  ///< bearing width over D [-]
  double ring_stress = 400e6;   ///< limit of (CV-1) in the bearing's outer ring [Pa]
  /// ball diameter over the height of the bearing's section [-]
  double ball_diameter = 0.61;
  /// number of balls, rounded to a whole number [-]
  double ball_count = 23;
  double conformity = 0.53;    ///< conformity of both races [-]
  double groove_factor = 0.8;  ///< groove factor of the outer ring [-]
  /// outer diameter of the circular spline over d [-]
  double spline_outer_diameter = 1.34;
  double spline_root = 4.2;     ///< (inner diameter of the circular spline - d)/m [-]
  double spline_support = 0.5;  ///< s_h, support of the circular spline [-]
  double lobe_gap = 0.0;        ///< normal gap over d; 16e-6 is 1 um at size 25 [-]
  double clearance = 0.0;       ///< radial play at a ball over d [-]
  double friction = 0.1;        ///< mu of the flanks [-]
};

/// The knowledge about one proportion.
struct Proportion {
  std::string_view name;                     ///< name of the member of ProportionValues
  std::string_view symbol;                   ///< symbol with its divisor
  double ProportionValues::*value;           ///< the member of ProportionValues
  double lower = 0.0;                        ///< lower limit [unit of the value]
  double upper = 0.0;                        ///< upper limit [unit of the value]
  Knowledge knowledge = Knowledge::drawing;  ///< kind of the source of the limits
  std::string_view source;                   ///< what the limits rest on, in words
  /// path of the number in a file; empty if several numbers depend on the proportion
  std::string_view path;
  std::string_view unit = "1";  ///< SI unit of the value
};

/// All proportions, in the order of ProportionValues.
///
/// All values were fixed before their first comparison with a catalogue, with three exceptions. The
/// support of the circular spline is close to the middle of its plausible range, but an earlier
/// study of the same drives had shown that such a value fits.  Relieved tips became the rule after
/// a first run of the tables with full tips, and (CV-2) was corrected after this run.
[[nodiscard]] std::span<const Proportion> proportions();

/// Proportions drawn uniformly and independently between their limits.
///
/// The same seed gives the same numbers with every compiler: the generator is std::mt19937_64,
/// which the standard fixes, and the code here makes the uniform number from its 53 upper bits.
[[nodiscard]] ProportionValues draw_proportions(std::mt19937_64& generator);

/// Throws InputError unless typical_drive accepts the ratio.
void require_typical_ratio(double ratio);

/// Largest bending stresses by which the nominal wave loads the walls of a sound drive [Pa].
struct WaveStresses {
  double outer_ring = 0.0;  ///< outer ring of the bearing
  double rim = 0.0;         ///< rim of the flexspline
  double diaphragm = 0.0;   ///< at its clamped edge
};

/// Implements theory manual eqs. (CV-1) and (CV-2): thin rings that the wave bends, and a plate
/// that the mouth of the barrel bends.
/// @param gear  a drive with bearing and outer ring, and a flexspline of sections with a diaphragm
[[nodiscard]] WaveStresses wave_stresses(const GearSet& gear);

/// A complete and consistent drive with a given pitch diameter.  It has no rating, so the torques
/// T1 and T2 are 0.0517 d^3 and 0.187 d^3 N/mm^2 (model/rating.hpp).
///
/// With m = d/(2 i), the mean radius of rim, barrel and diaphragm edge is R = d/2 - h_f - t_r/2.
/// The bore is D = 2 R - t_r, and the bearing fills the bore.  The stress limits of (CV-1, CV-2)
/// make outer ring, rim and diaphragm thinner where the wave demands it.  The teeth are drawn with
/// straight flanks (TC-29).
///
/// @param pitch_diameter  d [m]; > 0
/// @param ratio           i_h [-]; 30 to 320, 2 i a whole number of teeth
/// @param type            form, length and blank; {}: a short cup with the blank of its own ratio
/// @param values          one of each proportion; {}: the base values
/// @throws InputError     if the ratio breaks this rule
[[nodiscard]] GearSet typical_drive(double pitch_diameter, double ratio, const DriveType& type = {},
                                    const ProportionValues& values = {});

/// The typical drive of a catalogue size, with T1 and T2 of that size.  The rated torque is set if
/// the catalogue states one for exactly this ratio and the flexspline is short.
/// @throws InputError  if the catalogue lacks the size.  Sizes between two rows are refused too,
///                     because no maker states their torques
[[nodiscard]] GearSet typical_drive_of_size(int size, double ratio, const DriveType& type = {},
                                            const ProportionValues& values = {});

/// A drive to be written as a file: with ranges, and a remark for each number by its path.
struct CommentedDrive {
  GearSet gear;  ///< the drive, with ranges
  /// remark for each number, by the path of the number
  std::map<std::string, std::string> comments;
};

/// The typical drive of a size as a file to start from.  Lengths are rounded to six digits.  Every
/// proportion that sets one number of the file gets a `range`, and comments state the origin of
/// each number.  Motor and load are assumed; the inertia of the wave generator is the maker's.
/// @throws InputError  on the same conditions as typical_drive_of_size
[[nodiscard]] CommentedDrive starting_drive(int size, double ratio, const DriveType& type = {});

}  // namespace strainwave
