// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/motion/energy_table.hpp"
#include "strainwave/torsion/deviations.hpp"

/// @file
/// The computed torsion curve as the restoring torque of a motion.

namespace strainwave {

/// The table of a drive and its error against the coupled drive.
struct CurveTable {
  double most_torque = 0.0;  ///< of the table, at the output, under both senses [N*m]
  int torques = 0;           ///< points of the torque
  int cage_angles = 0;       ///< points of the cage's angle
  /// points of the angle of the flexspline, and of the circular spline, against the wave
  std::optional<int> flexspline_angles = {};
  std::optional<int> spline_angles = {};
  int triples = 0;  ///< random angles of flexspline, spline and cage at which it is checked
  double worst_difference = 0.0;  ///< largest |twist of the table - twist of the drive| [rad]
  double rms_difference = 0.0;    ///< [rad]
  /// root mean square of the twist that the cracks add there [rad]; absent: no crack in a contact
  std::optional<double> cracks_twist = {};
  /// largest error of the twist that the cracks add, over the largest such twist [-]
  std::optional<double> worst_share = {};
  /// the same as root mean squares [-]
  std::optional<double> rms_share = {};
  /// range of the place of the output that the deviations of the teeth make at the rated torque on
  /// the load, sound, over a turn of the output [rad]; absent: no tooth deviates
  std::optional<double> teeth_range = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"most_torque", "N*m", "largest torque of the table, at the output"},
          &CurveTable::most_torque);
    field({"torques", "", "points of the torque"}, &CurveTable::torques);
    field({"cage_angles", "", "points of the angle of the cage"}, &CurveTable::cage_angles);
    field({"flexspline_angles", "",
           "points of the angle of the flexspline against the wave; absent: no crack or deviation "
           "moves with it"},
          &CurveTable::flexspline_angles);
    field({"spline_angles", "",
           "points of the angle of the circular spline against the wave; absent: no crack or "
           "deviation in it"},
          &CurveTable::spline_angles);
    field({"triples", "", "random angles of flexspline, spline and cage of the check"},
          &CurveTable::triples);
    field({"worst_difference", "rad",
           "largest difference of the twist against the coupled drive at these angles"},
          &CurveTable::worst_difference);
    field({"rms_difference", "rad", "root mean square of this difference"},
          &CurveTable::rms_difference);
    field({"cracks_twist", "rad",
           "root mean square of the twist that the cracks in the contacts add at these angles"},
          &CurveTable::cracks_twist);
    field({"worst_share", "1",
           "largest error of the twist that the cracks add, over the largest such twist"},
          &CurveTable::worst_share);
    field({"rms_share", "1", "the same as root mean squares"}, &CurveTable::rms_share);
    field({"teeth_range", "rad",
           "kinematic error of the teeth from peak to valley over a turn of the output, sound, at "
           "the rated torque, or at the largest torque of the table if this is smaller; absent: "
           "no tooth deviates"},
          &CurveTable::teeth_range);
  }
};

/// The numbers of which the energies are made.
struct CurveSamples {
  std::vector<double> torques;         ///< [N*m]
  std::vector<EnergySamples> sound;    ///< by family
  std::vector<EnergySamples> cracked;  ///< by family; empty without cracks in the contacts
  double compliance = 0.0;             ///< of the sound members in series [rad/(N*m)]
  CurveTable table;                    ///< grid and error of the table that is made of the samples
};

/// The sound drive and the drive with its cracks as energies at the output, without the cracks of
/// wall and shaft.
struct ComputedCurve {
  /// energy of the sound drive, with the deviations of its teeth if there are any
  std::shared_ptr<const EnergyTable> sound;
  std::shared_ptr<const EnergyTable> cracked;  ///< `sound` itself without cracks in the contacts
  CurveTable table;                            ///< grid and error of the energies
  CurveSamples samples;  ///< the numbers from which `read_curve` makes the same energies
};

/// Most random angles at which the table is checked.
inline constexpr int kCheckedTriples = 100;

/// Largest torque of the curve of a drive, at the output: `drivetrain.curve_torque`, or else the
/// maker's momentary peak, or else twice the larger of T3 and the rated torque [N*m].
[[nodiscard]] double largest_curve_torque(const GearSet& gear);

/// Throws InputError, which names the missing fields, unless the file has each input of the coupled
/// drive.
void require_inputs_of_curve(const GearSet& gear);

/// Implements theory manual eqs. (MO-25) to (MO-27).
///
/// The families are the cage with cracks of the inner ring, the flexspline with its teeth and the
/// outer ring, and the circular spline.  The motion begins with the cracks at the positions of the
/// file and a ball at the lobe.
/// @throws InputError   if the file lacks an input of the coupled drive
/// @throws SolverError  if the coupled drive does not bear the largest torque of the table
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] ComputedCurve computed_curve(const GearSet& gear, const Progress& progress = {});

/// The computed curve of a drive whose teeth deviate, with the kinematic error that they make under
/// the torque of each time.
///
/// Implements theory manual eqs. (MO-27) and (MO-58).  Balls do not deviate.
/// @param gear      with a drivetrain and each input of the coupled drive
/// @param teeth     deviations of both parts and their gap, by `paired` or `draw_deviations`
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws  as `computed_curve`
[[nodiscard]] ComputedCurve computed_curve_of_teeth(const GearSet& gear, const Deviations& teeth,
                                                    const Progress& progress = {});

/// Makes the computed curve of a drive, or takes it from where it was kept.
using CurveSource = std::function<ComputedCurve(const GearSet& gear, const Progress& progress)>;

/// The drive without what its computed curve does not depend on: the name, the motion, the duty,
/// the kinematic error, ranges and scatter, and all of the drivetrain but the fixed member and the
/// largest torque of the curve.
[[nodiscard]] GearSet what_the_curve_depends_on(const GearSet& gear);

/// The samples as one line of text, with all bits of each number (MO-27).
[[nodiscard]] std::string curve_text(const CurveSamples& samples);
/// The curve of such a text, with the digits of the curve whose samples were written.
/// @throws InputError  if the text is not such a line
[[nodiscard]] ComputedCurve read_curve(std::string_view text);

}  // namespace strainwave
