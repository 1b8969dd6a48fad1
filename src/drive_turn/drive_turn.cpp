// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_turn/drive_turn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>

#include "cup_notes.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/turning_cup.hpp"
#include "turning_crack.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

LoadedTurn turn_under(double torque, int angles, TurningCrack& crack, double& largest_stress) {
  LoadedTurn turn{.torque = torque, .stations = {}};
  for (const std::string_view tip : {"upper", "lower"})
    for (const double station : crack.stations())
      turn.stations.push_back({.tip = tip, .station = station, .mode_I = {}, .factors = {}});
  for (int i = 0; i < angles; ++i) {
    const double angle = pi * i / angles;
    largest_stress = std::max(largest_stress, crack.largest_stress(angle, torque));
    const std::vector<StationFactors> K = crack.at(angle, torque);
    for (std::size_t s = 0; s < K.size(); ++s)
      turn.stations[s].factors.push_back(
          {.angle = angle, .K_I = K[s][0], .K_II = K[s][1], .K_III = K[s][2]});
  }
  for (StationTurn& station : turn.stations) {
    station.factors.push_back(station.factors.front());
    station.factors.back().angle = pi;
    station.mode_I = turn_range(station.factors);
  }
  return turn;
}

/// Refuses a crack whose end leaves its section.
void require_inside(const CrackOfWall& of, double distance, double half_length,
                    const TubeSection& section) {
  const double reach = half_length * std::abs(std::cos(of.angle()));
  if (distance - reach > 0 && distance + reach < section.length) return;
  throw InputError(
      of.path,
      fmt::format("must lie in the {}; at a half length of {:.4g} mm it reaches "
                  "from {:.4g} to {:.4g} mm of {:.4g} mm",
                  enum_name(of.section()), half_length / units::mm, (distance - reach) / units::mm,
                  (distance + reach) / units::mm, section.length / units::mm));
}

/// Length of a through crack over that of the barrel, and half its length over the radius of the
/// barrel, up to which K is as good as stated [-].
constexpr double kLong = 0.4;
constexpr double kLongAroundAxis = 0.1;

/// Walls between a crack of the rim and the ends of the rim up to which the stress was judged [-].
constexpr double kClearWalls = 3;

/// Notes a crack that comes so near to an end of its section that the model was not judged there,
/// or that is so long that it opens further than in the tube of the table, whose ends are held.
void note_ends(DriveTurn& turn, const CrackOfWall& of, const TubeSection& section) {
  const SizedTurn& longest = turn.sizes.back();
  const double t = section.wall_thickness;
  const double radius = (section.outer_diameter - t) / 2;
  if (!longest.depth && (2 * longest.half_length > kLong * section.length ||
                         longest.half_length > kLongAroundAxis * radius))
    turn.notes.push_back(
        {"turn.long_crack",
         fmt::format("the crack is longer than {:g} of the barrel, or its half length exceeds {:g} "
                     "of the barrel's radius; K_max of such cracks was up to 4.2 % too small, and "
                     "K_I in the middle of the wall under torque up to 10 %",
                     kLong, kLongAroundAxis),
         turn.path, "IN-2", Severity::care, "Compute K by strainwave fe turn too."});
  const bool in_rim = of.section() == WallSection::rim;
  const double reach = longest.half_length * std::abs(std::cos(of.angle()));
  const double left = std::min(turn.distance, section.length - turn.distance) - reach;
  const double edge = in_rim ? kClearWalls * t : std::sqrt(radius * t);
  if (left >= edge) return;
  turn.notes.push_back(
      {"turn.near_joint",
       fmt::format("the crack comes within {:.3g} mm of an end of the {}; nearer than {:.3g} mm "
                   "the model is not judged",
                   left / units::mm, enum_name(of.section()), edge / units::mm),
       turn.path, "IN-2", Severity::care, in_rim ? "" : "Compute K by strainwave fe turn too."});
}

std::vector<Note> notes_of(const GearSet& gear, const CrackOfWall& of) {
  std::vector<Note> notes;
  notes.push_back(
      {"turn.model",
       "the crack is alone; the cam is rigid and has no friction; the torque acts evenly "
       "round the rim, not in the zones of the teeth",
       of.path, "CU-2", Severity::care});
  if (of.section() == WallSection::rim)
    notes.push_back(
        {"turn.rim_teeth",
         "the teeth are left out: K is that of a crack in the smooth rim, whose stress finite "
         "elements judged within 1.7 %; no model judged K there, and the notch of a tooth root "
         "raises K of a shallow crack",
         of.path, "IN-3", Severity::care,
         "Raise K by the notch factor of the tooth root if the crack is shallower than its "
         "radius."});
  if (const int count = of.count(); count > 1)
    notes.push_back({"turn.row",
                     fmt::format("K is that of one crack, although the file gives a row of {}; the "
                                 "answer of strainwave stiffness states what the neighbours change "
                                 "under torque",
                                 count),
                     of.path, "CG-7", Severity::care});
  // The wall has several cracks, and none of the others is in the model.
  if (gear.flexspline->crack.size() > 1)
    notes.push_back({"turn.other_cracks",
                     fmt::format("the other {} of the flexspline {} left out; the answer of "
                                 "strainwave stiffness states what cracks with a position change "
                                 "of each other under torque",
                                 gear.flexspline->crack.size() == 2 ? "crack" : "cracks",
                                 gear.flexspline->crack.size() == 2 ? "is" : "are"),
                     of.path, "CG-9", Severity::care});
  if (of.mouth_unknown())
    notes.push_back({"turn.mouth_outside",
                     "the mouth of the surface crack is assumed on the outer surface, because the "
                     "file does not state it",
                     of.path, "", Severity::care, "Give the mouth of the crack."});
  add_cup_notes(notes, gear);
  return notes;
}

}  // namespace

DriveTurn drive_turn(const GearSet& gear, const TurnRequest& request) {
  const TurnPlan plan = plan_turn(gear, request, RimCracks::surface);
  const CrackOfWall& of = plan.crack;
  const bool in_rim = of.section() == WallSection::rim;
  const ShellCup cup = shell_cup(gear);
  const TubeSection& section = in_rim ? cup.rim : cup.barrel;
  const OvalShell shell = oval_shell(cup, cam_fit(gear), {.whole_meridian = in_rim});
  DriveTurn turn;
  turn.path = of.path;
  turn.contact = shell.contact;
  turn.large_rotations = shell.large_rotations;
  std::visit(
      [&](const auto& crack) {
        turn.distance = crack.distance.value_or(section.length / 2);
        const double place = turn.distance + (in_rim ? cup.barrel.length : 0);
        for (const TurnSize& size : plan.sizes) {
          require_inside(of, turn.distance, size.half_length, section);
          SizedTurn& at = turn.sizes.emplace_back(SizedTurn{size, {}});
          std::unique_ptr<TurningCrack> turning;
          try {
            turning = turning_crack(crack, shell, place, size);
          } catch (const InputError& error) {
            throw InputError(of.path, error.what());
          }
          for (const double torque : plan.torques)
            at.torques.push_back(turn_under(torque, plan.angles, *turning, turn.largest_stress));
        }
      },
      of.crack);
  turn.notes = notes_of(gear, of);
  note_ends(turn, of, section);
  turn.equations = {"CU-1", "CU-2"};
  if (turn.large_rotations) turn.equations.emplace_back("CU-3");
  turn.equations.emplace_back("CU-4");
  for (const char* const tag : std::holds_alternative<WallThroughCrack>(of.crack)
                                   ? std::array{"IN-1", "IN-2"}
                                   : std::array{"IN-2", "IN-3"})
    turn.equations.emplace_back(tag);
  turn.equations.emplace_back("GR-30");
  return turn;
}

}  // namespace strainwave
