// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_turn/drive_turn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/turning_cup.hpp"
#include "turning_crack.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A crack of the barrel with its path.
struct ChosenCrack {
  std::string path;
  std::variant<WallThroughCrack, WallSurfaceCrack> crack;
};

/// The crack of the barrel that a turn can compute; absent if it is of another kind or place.
std::optional<ChosenCrack> in_barrel(const std::string& path, const FlexsplineCrack& crack) {
  if (const auto* const through = std::get_if<WallThroughCrack>(&crack);
      through != nullptr && through->section == WallSection::barrel)
    return ChosenCrack{path, *through};
  if (const auto* const surface = std::get_if<WallSurfaceCrack>(&crack);
      surface != nullptr && surface->section == WallSection::barrel)
    return ChosenCrack{path, *surface};
  return std::nullopt;
}

ChosenCrack chosen(const Flexspline& flexspline, const std::optional<std::string>& asked) {
  std::vector<ChosenCrack> found;
  for (std::size_t n = 0; n < flexspline.crack.size(); ++n) {
    const std::string path = fmt::format("flexspline.crack[{}]", n);
    if (asked && *asked != path) continue;
    if (std::optional<ChosenCrack> crack = in_barrel(path, flexspline.crack[n]))
      found.push_back(std::move(*crack));
    else if (asked)
      throw InputError(path,
                       "must be a through or surface crack of the barrel; choose another crack by "
                       "--crack");
  }
  if (found.empty() && asked)
    throw InputError("--crack", fmt::format("\"{}\" is not a crack of the flexspline; give a path "
                                            "such as flexspline.crack[0]",
                                            shown(*asked)));
  if (found.empty())
    throw InputError("flexspline.crack", "must have a through or surface crack of the barrel");
  if (found.size() > 1)
    throw InputError("flexspline.crack",
                     "has several cracks of the barrel; choose one of them by --crack");
  return std::move(found.front());
}

/// Values in ascending order, each once.
std::vector<double> ascending(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  for (double& value : values)
    if (value == 0) value = 0.0;  // not -0
  return values;
}

/// The sizes of a crack: its own, or those that the options ask for.
std::vector<double> sizes_of(const WallThroughCrack& crack, const DriveTurnOptions& options) {
  if (!options.depths.empty())
    throw InputError("--depth", "is not the size of a through crack; give --half-length");
  return options.half_lengths.empty() ? std::vector{crack.half_length}
                                      : ascending(options.half_lengths);
}
std::vector<double> sizes_of(const WallSurfaceCrack& crack, const DriveTurnOptions& options) {
  if (!options.half_lengths.empty())
    throw InputError("--half-length", "is not the size of a surface crack; give --depth");
  return options.depths.empty() ? std::vector{crack.depth} : ascending(options.depths);
}

SizedTurn sized(const WallThroughCrack&, double size) {
  return {.depth = {}, .half_length = size, .torques = {}};
}
SizedTurn sized(const WallSurfaceCrack& crack, double size) {
  return {.depth = size, .half_length = crack.half_length * size / crack.depth, .torques = {}};
}

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

/// Refuses a crack whose end leaves the barrel.
void require_inside(const ChosenCrack& of, double place, double half_length,
                    const TubeSection& barrel) {
  const double angle = std::visit([](const auto& crack) { return crack.angle; }, of.crack);
  const double reach = half_length * std::abs(std::cos(angle));
  if (place - reach > 0 && place + reach < barrel.length) return;
  throw InputError(of.path,
                   fmt::format("must lie in the barrel; at a half length of {:.4g} mm it reaches "
                               "from {:.4g} to {:.4g} mm of {:.4g} mm",
                               half_length / units::mm, (place - reach) / units::mm,
                               (place + reach) / units::mm, barrel.length / units::mm));
}

/// Notes a crack that comes so near to a joint that the model was not judged there.
void note_joint(DriveTurn& turn, const TubeSection& barrel, double angle) {
  const double reach = turn.sizes.back().half_length * std::abs(std::cos(angle));
  const double left = std::min(turn.distance, barrel.length - turn.distance) - reach;
  const double edge =
      std::sqrt((barrel.outer_diameter - barrel.wall_thickness) / 2 * barrel.wall_thickness);
  if (left >= edge) return;
  turn.notes.push_back(
      {"turn.near_joint",
       fmt::format(
           "the crack comes within {:.3g} mm of an end of the barrel; nearer than {:.3g} mm "
           "the model is not judged",
           left / units::mm, edge / units::mm),
       turn.path, "IN-2", Severity::care, "Compute K by strainwave fe turn too."});
}

std::vector<Note> notes_of(const GearSet& gear, const ChosenCrack& of) {
  std::vector<Note> notes;
  notes.push_back(
      {"turn.model",
       "the crack is alone; the cam is rigid and has no friction; the torque acts evenly "
       "round the rim, not in the zones of the teeth",
       of.path, "CU-2", Severity::care});
  if (!gear.wave_generator || !gear.wave_generator->cam_perimeter_excess)
    notes.push_back({"turn.cam_perimeter", "the cam is taken to have the perimeter of the bore",
                     "wave_generator.cam_perimeter_excess", "CU-2", Severity::care,
                     "Give cam_perimeter_excess if the perimeter is known."});
  if (const auto* const surface = std::get_if<WallSurfaceCrack>(&of.crack);
      surface != nullptr && !surface->mouth)
    notes.push_back({"turn.mouth_outside",
                     "the mouth of the surface crack is assumed on the outer surface, because the "
                     "file does not state it",
                     of.path, "", Severity::care, "Give the mouth of the crack."});
  if (gear.load.axial_force != 0)
    notes.push_back({"turn.axial_force", "the axial force is not applied to the flexspline",
                     "load.axial_force", "", Severity::care});
  return notes;
}

}  // namespace

const StationTurn& DriveTurn::governing() const {
  const StationTurn* governing = nullptr;
  for (const SizedTurn& size : sizes)
    for (const LoadedTurn& torque : size.torques) {
      const StationTurn* const here = governing_station(torque.stations);
      if (governing == nullptr || here->mode_I.range > governing->mode_I.range) governing = here;
    }
  return *governing;
}

ShellCup shell_cup(const GearSet& gear) {
  const Flexspline& flexspline = *gear.flexspline;
  const ElasticConstants steel =
      elastic_constants(material_of(gear, flexspline.material, "flexspline.material"));
  return {.barrel = *flexspline.barrel,
          .rim = *flexspline.rim,
          .diaphragm = flexspline.diaphragm,
          .youngs_modulus = steel.E,
          .poissons_ratio = steel.nu};
}

DriveTurn drive_turn(const GearSet& gear, const DriveTurnOptions& options) {
  check(gear);
  require_turning_cup(gear);
  const ChosenCrack of = chosen(*gear.flexspline, options.crack);
  require(options.angles >= 8 && options.angles <= 720, "angles", options.angles, "1",
          ">= 8 and <= 720");
  const double T = gear.load.torque;
  const std::vector<double> torques =
      ascending(options.torques.empty() ? std::vector{-T, 0.0, T} : options.torques);
  for (const double torque : torques)
    require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  const ShellCup cup = shell_cup(gear);
  const OvalShell shell = oval_shell(cup, cam_fit(gear));
  DriveTurn turn;
  turn.path = of.path;
  turn.contact = shell.contact;
  turn.large_rotations = shell.large_rotations;
  std::visit(
      [&](const auto& crack) {
        turn.distance = crack.distance.value_or(cup.barrel.length / 2);
        for (const double size : sizes_of(crack, options)) {
          SizedTurn& at = turn.sizes.emplace_back(sized(crack, size));
          require_inside(of, turn.distance, at.half_length, cup.barrel);
          std::unique_ptr<TurningCrack> turning;
          try {
            turning = turning_crack(crack, shell, turn.distance, size);
          } catch (const InputError& error) {
            throw InputError(of.path, error.what());
          }
          for (const double torque : torques)
            at.torques.push_back(turn_under(torque, options.angles, *turning, turn.largest_stress));
        }
      },
      of.crack);
  turn.notes = notes_of(gear, of);
  note_joint(turn, cup.barrel, std::visit([](const auto& crack) { return crack.angle; }, of.crack));
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

TurnTable turn_table(const DriveTurn& turn) {
  TurnTable table{.file = {},
                  .size_name = turn.sizes.front().depth ? "depth" : "half_length",
                  .sizes = {},
                  .torques = {},
                  .stations = {},
                  .angles = {},
                  .K = {}};
  const std::string_view tip = turn.governing_tip();
  for (const LoadedTurn& torque : turn.sizes.front().torques)
    table.torques.push_back(torque.torque);
  for (const StationTurn& station : turn.sizes.front().torques.front().stations) {
    if (station.tip != tip) continue;
    table.stations.push_back(station.station);
    if (!table.angles.empty()) continue;
    for (const TurnFactor& K : station.factors) table.angles.push_back(K.angle);
  }
  for (const SizedTurn& size : turn.sizes) {
    table.sizes.push_back(size.depth.value_or(size.half_length));
    for (const LoadedTurn& torque : size.torques)
      for (const StationTurn& station : torque.stations)
        if (station.tip == tip)
          for (const TurnFactor& K : station.factors) table.K.push_back({K.K_I, K.K_II, K.K_III});
  }
  return table;
}

}  // namespace strainwave
