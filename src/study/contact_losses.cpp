// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/contact_losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/computed_curve.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/friction.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

constexpr int kWidthsPerSense = 24;
constexpr double kSlipAngle = 0.02;  // of the input, before the contacts slip the other way [rad]
constexpr double kStribeckSpeed = 1.0;  // without effect, because breakaway is coulomb [rad/s]

/// Widths of the loops of a drive over the torque of the flexspline, out from zero in each sense.
struct Widths {
  std::vector<double> torques;  ///< at the output of a motion, rising [N*m]
  std::vector<double> widths;   ///< at the output [rad]
};

/// @param step  torque of the flexspline over that of the output, with sign [-]
Widths widths_of(const AssembledDrive& drive, double most, double step, const Progress& progress) {
  const auto of_sense = [&](double sense, const Progress& part) {
    std::vector<double> torques;
    for (int n = 0; n <= kWidthsPerSense; ++n) {
      const double share = static_cast<double>(n) / kWidthsPerSense;
      // The torque of the drive on its load is minus that on the output (MO-14).
      torques.push_back(-step * sense * most * share * share);
    }
    std::vector<std::pair<double, double>> made;
    const SlidingCurve curve = sliding_curve(drive, torques, part);
    for (std::size_t n = 0; n < torques.size(); ++n)
      made.emplace_back(-torques[n] / step, std::abs(step) * curve.width[n].total());
    return made;
  };
  std::vector<std::pair<double, double>> all = of_sense(-1, progress.part(0.0, 0.5));
  const auto positive = of_sense(+1, progress.part(0.5, 1.0));
  all.insert(all.end(), positive.begin() + 1, positive.end());  // zero stands in both
  std::ranges::sort(all);
  Widths made;
  for (const auto& [torque, width] : all) {
    made.torques.push_back(torque);
    made.widths.push_back(width);
  }
  return made;
}

/// Turn of the wave against the flexspline in one turn of the input (DY-2) [-].
double wave_turn(const GearSet& gear) {
  const PartTurns turns = part_turns(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  return std::abs(turns.wave_generator - turns.flexspline);
}

/// Torque that the turning input loses, as a straight line over the load (MO-54).
LuGre turning_friction(const GearSet& gear, const AssembledDrive& drive, double step,
                       ContactLosses& losses) {
  // (TC-34) turns the wave by 1 + 1/i against the flexspline in a turn of the input.
  const double turn = wave_turn(gear) / (1 + 1 / gear.drive.ratio);
  const double ratio =
      std::abs(signed_ratio(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio));
  const MakersTorques makers = makers_torques(gear);
  const RunningTorque without_load = no_load_torque(drive);
  const auto lost = [&](double output_torque) {
    const double of_flexspline = std::abs(step) * output_torque;
    return turn * without_load.output + turn *
                                            (running_torque(drive, of_flexspline).total() +
                                             running_torque(drive, -of_flexspline).total()) /
                                            2;
  };
  const double idle = turn * without_load.total();
  const double rated = makers.rated / std::abs(step);
  // Least squares of the relative deviations.
  std::vector<std::pair<double, double>> points;  // load over the ratio, and torque
  double over = 0.0;
  double under = 0.0;
  for (const double torque : {makers.T1, makers.T2, makers.T3, makers.rated}) {
    const double at_output = torque / std::abs(step);
    const auto& [load, is] = points.emplace_back(at_output / ratio, lost(at_output));
    over += load * (is - idle) / (is * is);
    under += load * load / (is * is);
  }
  const double slope = std::max(0.0, over / under);  // (MO-54)
  double worst = 0.0;
  for (const auto& [load, is] : points)
    worst = std::max(worst, std::abs(idle + slope * load - is) / is);
  losses.coulomb = idle;
  losses.load_coulomb = slope;
  losses.worst_deviation = worst;
  return {.bristle_stiffness = (idle + slope * rated / ratio) / kSlipAngle,
          .coulomb = idle,
          .breakaway = idle,
          .stribeck_speed = kStribeckSpeed,
          .load_coulomb = slope};
}

}  // namespace

DriveContacts drive_contacts(const GearSet& gear, const Progress& progress) {
  if (const std::string missing = missing_for_torsion_curve(gear); !missing.empty())
    throw InputError(
        "drivetrain.contact_friction",
        fmt::format("is \"computed\", but the coupled drive lacks fields: {}", missing));
  const double step = flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  const AssembledDrive drive(without_cracks(gear));
  const double most = largest_curve_torque(gear);
  DriveContacts made;
  const auto within_reach = [&](const auto& solve) {
    try {
      return solve();
    } catch (const SolverError& error) {
      throw SolverError(
          fmt::format("the loops of the contacts up to {:.4g} N*m are not known: {}; lower "
                      "drivetrain.curve_torque, or give drivetrain.contact_friction = \"none\"",
                      most, error.what()));
    }
  };
  const Widths widths =
      within_reach([&] { return widths_of(drive, most, step, progress.part(0.0, 0.6)); });
  const double rated = makers_torques(gear).rated;
  const TorsionCurve curve =
      torsion_curve(drive, std::array{rated, -rated}, progress.part(0.6, 0.8));
  if (!curve.usable()) throw SolverError(curve.unusable_because);
  ContactLosses& losses = made.losses;
  for (const CurvePoint& point : curve.points)
    losses.teeth_in_contact += point.teeth_in_contact / 2.0;
  // A pair stays in the mesh while the wave passes the teeth of one lobe that touch, and its
  // friction began half of this angle ago on average (MO-53).
  const double passage = std::numbers::pi * losses.teeth_in_contact / curve.teeth;
  losses.memory_angle = passage / 2 / wave_turn(gear);
  made.loops =
      std::make_shared<const TwistLoops>(widths.torques, widths.widths, 1 / losses.memory_angle);
  losses.width_at_rest = made.loops->width(0.0).value;
  const double at_output = rated / std::abs(step);
  losses.width_at_rated =
      (made.loops->width(at_output).value + made.loops->width(-at_output).value) / 2;
  if (!gear.drivetrain->friction) made.friction = turning_friction(gear, drive, step, losses);
  progress.at(1.0);
  return made;
}

}  // namespace strainwave
