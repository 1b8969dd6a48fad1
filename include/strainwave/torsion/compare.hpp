// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/core/shared_rows.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/torsion/assembled_drive.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

/// @file
/// Comparison of the torsion curves of a drive with its cracks and of the sound drive.

namespace strainwave {

/// Relative changes of the maker's stiffnesses, cracked/sound - 1 [-].
struct LineChanges {
  double K1 = 0.0;
  double K2 = 0.0;
  double K3 = 0.0;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"K1", "1", "cracked/sound - 1 of K1"}, &LineChanges::K1);
    field({"K2", "1", "cracked/sound - 1 of K2"}, &LineChanges::K2);
    field({"K3", "1", "cracked/sound - 1 of K3"}, &LineChanges::K3);
  }
};

/// Changes over a turn of the wave generator, under one sense of torque.
struct ChangesOverTurn {
  LineChanges as_given;  ///< changes at the positions of the file
  LineChanges mean;
  LineChanges worst;  ///< most negative change of each
  LineChanges best;
  LineChanges ripple;    ///< best minus worst
  int ripple_order = 0;  ///< periods of K1 per turn against the cracked part; 0: no ripple
  std::vector<LineChanges> at_angle;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"as_given", "", "changes at the positions of the file"}, &ChangesOverTurn::as_given);
    field({"mean", "", "mean over a turn"}, &ChangesOverTurn::mean);
    field({"worst", "", "most negative change of each"}, &ChangesOverTurn::worst);
    field({"best", "", "least negative change of each"}, &ChangesOverTurn::best);
    field({"ripple", "", "best minus worst"}, &ChangesOverTurn::ripple);
    field({"ripple_order", "",
           "periods of K1 per turn of the wave generator against the cracked part; 0: no ripple"},
          &ChangesOverTurn::ripple_order);
    field({"at_angle", "", "changes at each position of the wave generator"},
          &ChangesOverTurn::at_angle);
  }
};

/// Kind of member that contains the cracks, inferred from the change of the curve.
enum class CrackClass {
  none,          ///< no change above rounding
  series,        ///< barrel, diaphragm, shaft: all three lines gain the same compliance
  contact_path,  ///< teeth and rings: K1 changes most, or the change varies over a turn
  undecided,     ///< inner race, or several kinds of members
};
template <>
struct EnumNames<CrackClass> {
  static constexpr std::array<std::string_view, 4> names = {"none", "series", "contact_path",
                                                            "undecided"};
};

/// Comparison of the sound and the cracked drive.
struct CurveComparison {
  MakersTorques torques;
  MakersLines sound;
  std::vector<double> angles;  ///< angles by which the wave generator has turned [rad]
  ChangesOverTurn positive;    ///< torque about +z
  ChangesOverTurn negative;
  double lost_motion_sound = 0.0;    ///< [rad]
  double lost_motion_cracked = 0.0;  ///< value at the positions of the file [rad]
  double hysteresis_sound = 0.0;     ///< largest width of the loop at rated torque [rad]
  double hysteresis_cracked = 0.0;   ///< [rad]
  CrackClass crack_class = CrackClass::none;
  double class_ratio = 0.0;  ///< mean dK1/dK3 of the sense that changes more [-]
  std::string evidence;      ///< reason of the class, one sentence

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torques", "", "the maker's torques"}, &CurveComparison::torques);
    field({"sound", "", "the maker's lines without cracks"}, &CurveComparison::sound);
    field({"angles", "rad", "angles by which the wave generator has turned"},
          &CurveComparison::angles);
    field({"positive", "", "changes under torque about +z"}, &CurveComparison::positive);
    field({"negative", "", "changes under torque about -z"}, &CurveComparison::negative);
    field({"lost_motion_sound", "rad", "lost motion without cracks"},
          &CurveComparison::lost_motion_sound);
    field({"lost_motion_cracked", "rad", "lost motion with cracks, at the positions of the file"},
          &CurveComparison::lost_motion_cracked);
    field({"hysteresis_sound", "rad", "largest width of the loop without cracks"},
          &CurveComparison::hysteresis_sound);
    field({"hysteresis_cracked", "rad", "largest width of the loop with cracks"},
          &CurveComparison::hysteresis_cracked);
    field({"crack_class", "", "kind of member that contains the cracks"},
          &CurveComparison::crack_class);
    field({"class_ratio", "1", "mean change of K1 over that of K3"}, &CurveComparison::class_ratio);
    field({"evidence", "", "reason of the class"}, &CurveComparison::evidence);
  }
};

/// The drive without its cracks, and without ranges and scatters of their numbers
/// (drop_lost_paths).
[[nodiscard]] GearSet without_cracks(const GearSet& gear);

/// The drive with some of its cracks (drop_lost_paths).
/// @param gear  the drive with all of its cracks; not changed
/// @param keep  called with the name of the member and the crack; whether the crack stays
template <class Keep>
[[nodiscard]] GearSet with_cracks_where(const GearSet& gear, const Keep& keep) {
  GearSet made = gear;
  for_each_cracked_member(made, [&](std::string_view name, auto& member) {
    std::erase_if(member.crack, [&](const auto& crack) {
      return !std::visit([&](const auto& kind) { return keep(name, kind); }, crack);
    });
  });
  drop_lost_paths(made, gear);
  return made;
}

/// Whether any member has a crack.
[[nodiscard]] bool has_cracks(const GearSet& gear);

/// Whether a crack moves relative to the wave, that is, whether it lies in rim, teeth, outer ring
/// or circular spline.
[[nodiscard]] bool has_moving_cracks(const GearSet& gear);

/// Angle by which flexspline, teeth and outer ring move against the wave when the wave generator
/// turns by an angle and the circular spline is fixed, (1 + 1/i_h) times the angle (TC-28) [rad].
/// The circular spline itself moves by the angle.
[[nodiscard]] double flexspline_turn(const Transmission& drive, double angle);

/// Position of a point that has moved against the wave by an angle, measured from the major axis
/// [rad].
[[nodiscard]] double turned_position(double position, double angle);

/// The drive after the wave generator has turned by an angle [rad]: cracks of flexspline, teeth,
/// outer ring and circular spline move against the wave, each by its own angle (TC-28).  Cracks of
/// the inner race do not move, and the cage keeps its phase.  Ranges and scatters of moved
/// positions are removed (drop_lost_paths).
[[nodiscard]] GearSet after_turn(const GearSet& gear, double angle);
/// The drive after flexspline and circular spline have moved against the wave, each by its own
/// angle [rad]; as `after_turn`.
[[nodiscard]] GearSet after_moves(const GearSet& gear, double flexspline, double spline);

/// The changes of the maker's stiffnesses over a turn, under both senses of torque.
struct TurnChanges {
  std::vector<double> angles;  ///< angles by which the wave generator has turned [rad]
  ChangesOverTurn positive;    ///< of the curve under positive torque
  ChangesOverTurn negative;    ///< of the curve under negative torque
};

/// Changes of the maker's stiffnesses by the cracks, over a turn of the wave generator (TC-26).
/// @param drive     the drive with its cracks; the turn begins at their positions
/// @param angles    as in `compare_curves`
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @param shared    null, or the part of the positions that this process computes or reads
/// @throws InputError, SolverError, Stopped, ShareDone, BrokenRecord  as `compare_curves`
[[nodiscard]] TurnChanges changes_over_turn(const AssembledDrive& drive, int angles = 0,
                                            const Progress& progress = {},
                                            SharedRows* shared = nullptr);

/// The maker's stiffnesses at one phase of the cage [N*m/rad].
struct LineStiffnesses {
  double K1 = 0.0;
  double K2 = 0.0;
  double K3 = 0.0;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"K1", "N*m/rad", "T1/phi(T1)"}, &LineStiffnesses::K1);
    field({"K2", "N*m/rad", "slope from T1 to T2"}, &LineStiffnesses::K2);
    field({"K3", "N*m/rad", "slope from T2 to T3"}, &LineStiffnesses::K3);
  }
};

/// The maker's stiffnesses under torque about +z over the phases of the cage, which cover the angle
/// between two balls from the phase of the drive on (TC-5).  A sound drive has this ripple too.
struct LinesOverCage {
  std::vector<double> phases;  ///< angles of the first ball from the major axis [rad]
  LineStiffnesses mean;
  LineStiffnesses softest;   ///< lowest value of each
  LineStiffnesses stiffest;  ///< highest value of each
  std::vector<LineStiffnesses> at_phase;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"phases", "rad", "angles of the first ball from the major axis"},
          &LinesOverCage::phases);
    field({"mean", "", "mean over the phases"}, &LinesOverCage::mean);
    field({"softest", "", "lowest value of each"}, &LinesOverCage::softest);
    field({"stiffest", "", "highest value of each"}, &LinesOverCage::stiffest);
    field({"at_phase", "", "values at each phase"}, &LinesOverCage::at_phase);
  }
};

/// Implements theory manual eqs. (TC-5), (TC-12): the balls stand at other places on the same cam.
///
/// @param drive     gives the first phase; its cracks and deviations keep their places
/// @param phases    evenly spaced phases over the angle between two balls [-]; >= 1
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if `phases` is below 1
/// @throws SolverError  if a curve is not usable
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] LinesOverCage lines_over_cage(const AssembledDrive& drive, int phases = 12,
                                            const Progress& progress = {});

/// Compares the maker's stiffnesses of a drive with and without its cracks (TC-26).
///
/// @param drive     the drive with its cracks; the turn begins at their positions
/// @param angles    positions of the wave generator over a turn [-], adjusted to whole teeth; 0 for
///                  every tooth, the only choice that is certain to find the worst position.  A
///                  number above that of the teeth counts as every tooth too.  One position is
///                  used if no crack moves
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @param shared    null, or the part of the positions that this process computes or reads
/// @throws InputError    if `angles` is negative
/// @throws SolverError   if a curve is not usable
/// @throws Stopped       if the caller requests a stop
/// @throws ShareDone     after the positions of a share were computed and kept
/// @throws BrokenRecord  if positions that are read are not those of this study
[[nodiscard]] CurveComparison compare_curves(const AssembledDrive& drive, int angles = 0,
                                             const Progress& progress = {},
                                             SharedRows* shared = nullptr);
/// Compares the curves of a drive that is not assembled yet.
[[nodiscard]] inline CurveComparison compare_curves(const GearSet& gear, int angles = 0,
                                                    const CoupledOptions& options = {},
                                                    const Progress& progress = {}) {
  return compare_curves(AssembledDrive(gear, options), angles, progress);
}

}  // namespace strainwave
