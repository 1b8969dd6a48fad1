// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/turn_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/fe_study/memory.hpp"
#include "strainwave/fem/mesh_size.hpp"
#include "strainwave/model/input/turning_cup.hpp"
#include "wall_tubes.hpp"

namespace strainwave::fe_study {
namespace {

/// Solutions of one size, in terms of time: the crack's response, and three sizes of the checks.
constexpr std::size_t kTurnSolutions = 4;

/// Memory of the responses of the crack's nodes, over that of one solution [-].
constexpr double kResponseMemory = 1.3;

std::string path_of(std::size_t n) { return fmt::format("flexspline.crack[{}]", n); }

/// Values in ascending order, each once.
std::vector<double> ascending(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// The crack to turn, with its number in the file.
struct ChosenCrack {
  std::size_t number;
  std::variant<WallThroughCrack, WallSurfaceCrack> crack;
};

/// The crack of the barrel that a turn can compute; absent if it is of another kind or place.
std::optional<ChosenCrack> in_barrel(std::size_t number, const FlexsplineCrack& crack) {
  if (const auto* const through = std::get_if<WallThroughCrack>(&crack);
      through != nullptr && through->section == WallSection::barrel)
    return ChosenCrack{number, *through};
  if (const auto* const surface = std::get_if<WallSurfaceCrack>(&crack);
      surface != nullptr && surface->section == WallSection::barrel)
    return ChosenCrack{number, *surface};
  return std::nullopt;
}

ChosenCrack chosen(const GearSet& gear, const TurnOptions& options) {
  std::vector<ChosenCrack> found;
  const auto& cracks = gear.flexspline->crack;
  for (std::size_t n = 0; n < cracks.size(); ++n) {
    const bool asked = options.crack && *options.crack == path_of(n);
    const std::optional<ChosenCrack> crack = in_barrel(n, cracks[n]);
    if (asked && !crack)
      throw InputError(path_of(n),
                       "must be a through or surface crack of the barrel; choose "
                       "another crack by --crack");
    if (crack && (asked || !options.crack)) found.push_back(*crack);
  }
  if (found.empty() && options.crack)
    throw InputError("--crack",
                     fmt::format("\"{}\" is not a crack of the flexspline", shown(*options.crack)));
  if (found.empty())
    throw InputError("flexspline.crack", "must have a through or surface crack of the barrel");
  if (found.size() > 1)
    throw InputError("flexspline.crack",
                     "has several cracks of the barrel; choose one of them by --crack");
  return found.front();
}

/// The sizes of a crack: its own, or those that the options ask for.
/// @param unread  the option for the other kind of crack
std::vector<double> sizes_of(const std::vector<double>& asked, double own, const char* unread,
                             const std::vector<double>& other) {
  if (!other.empty()) throw InputError(unread, "is not the size of this kind of crack");
  return asked.empty() ? std::vector{own} : ascending(asked);
}

/// The crack at each of its sizes.
std::vector<TurnAtSize> sizes_of(const WallThroughCrack& crack, const TurnOptions& options) {
  std::vector<TurnAtSize> sizes;
  for (const double half_length :
       sizes_of(options.half_lengths, crack.half_length, "--depth", options.depths))
    sizes.push_back({.depth = {}, .half_length = half_length, .turn = {}});
  return sizes;
}
std::vector<TurnAtSize> sizes_of(const WallSurfaceCrack& crack, const TurnOptions& options) {
  std::vector<TurnAtSize> sizes;
  for (const double depth :
       sizes_of(options.depths, crack.depth, "--half-length", options.half_lengths))
    sizes.push_back(
        {.depth = depth, .half_length = crack.half_length * depth / crack.depth, .turn = {}});
  return sizes;
}

gear_fem::TubeWithThroughCrack body_of(const GearSet& gear, const WallThroughCrack& crack,
                                       const TurnAtSize& size, int order) {
  gear_fem::TubeWithThroughCrack tube = tube_of(gear, crack, order, Surroundings::as_given);
  tube.half_length = size.half_length;
  tube.layers = gear_fem::kTurnLayers;
  return tube;
}
gear_fem::TubeWithSurfaceCrack body_of(const GearSet& gear, const WallSurfaceCrack& crack,
                                       const TurnAtSize& size, int order) {
  gear_fem::TubeWithSurfaceCrack tube = tube_of(gear, crack, order);
  tube.depth = *size.depth;
  tube.half_length = size.half_length;
  return tube;
}

fem::HexMesh mesh_of(const gear_fem::TubeWithThroughCrack& tube) {
  return gear_fem::mesh_tube_with_through_crack(tube);
}
fem::HexMesh mesh_of(const gear_fem::TubeWithSurfaceCrack& tube) {
  return gear_fem::mesh_tube_with_surface_crack(tube);
}

struct TurnWork {
  TurnRun run;
  std::vector<gear_fem::TurningCrack> sizes;
};

TurnWork work_of(const GearSet& gear, const TurnOptions& options) {
  check(gear);
  require_turning_cup(gear);
  const ChosenCrack of = chosen(gear, options);
  const Flexspline& flexspline = *gear.flexspline;
  const int order = options.order.value_or(kSolidOrder);
  require(order >= 2 && order <= 4, "order", order, "1", ">= 2 and <= 4 for a turn");
  TurnWork work;
  TurnRun& run = work.run;
  run.path = path_of(of.number);
  run.angles = options.angles;
  const double T = gear.load.torque;
  run.torques = ascending(options.torques.empty() ? std::vector{-T, 0.0, T} : options.torques);
  for (double& torque : run.torques)
    if (torque == 0) torque = 0.0;  // not -0
  run.sizes = std::visit([&](const auto& crack) { return sizes_of(crack, options); }, of.crack);
  for (const TurnAtSize& size : run.sizes) {
    gear_fem::TurningCrack& turning = work.sizes.emplace_back();
    turning.ends = {
        .rim = flexspline.rim, .diaphragm = flexspline.diaphragm, .boss = flexspline.boss};
    turning.fit = cam_fit(gear);
    turning.torques = run.torques;
    turning.angles = options.angles;
    turning.large_rotations = options.large_rotations;
    std::visit(
        [&](const auto& crack) {
          auto tube = body_of(gear, crack, size, order);
          tube.torque = 1;
          try {
            const fem::HexMesh mesh = mesh_of(tube);
            (void)fem::check_jacobians(mesh);
            RunSize planned =
                size_of_solid(run.path, fem::count_unknowns(mesh, order), kTurnSolutions);
            planned.memory *= kResponseMemory;
            run.plan.push_back(planned);
          } catch (const InputError& error) {
            throw InputError(run.path, error.what());
          }
          turning.tube = std::move(tube);
        },
        of.crack);
  }
  run.notes.push_back({"fe.turn_model",
                       "the crack is alone; the cam is rigid and has no friction; the torque acts "
                       "evenly round the rim, not in the zones of the teeth",
                       run.path, "FE-52", Severity::care});
  if (!gear.wave_generator || !gear.wave_generator->cam_perimeter_excess)
    run.notes.push_back({"fe.cam_perimeter",
                         "the cam is taken to have the perimeter of the bore",
                         "wave_generator.cam_perimeter_excess", "FE-52", Severity::care,
                         "Give cam_perimeter_excess if the perimeter is known."});
  if (const auto* const surface = std::get_if<WallSurfaceCrack>(&of.crack);
      surface != nullptr && !surface->mouth)
    run.notes.push_back({"fe.mouth_outside",
                         "the mouth of the surface crack is assumed on the outer surface, because "
                         "the file does not state it",
                         run.path, "", Severity::care, "Give the mouth of the crack."});
  if (gear.load.axial_force != 0)
    run.notes.push_back({"fe.axial_force", "the axial force is not applied to the flexspline",
                         "load.axial_force", "", Severity::care});
  if (flexspline.stress_nonuniformity != 1)
    run.notes.push_back({"fe.stress_nonuniformity",
                         "flexspline.stress_nonuniformity is not applied, because finite "
                         "elements compute the stress distribution",
                         "flexspline.stress_nonuniformity", "", Severity::information});
  return work;
}

}  // namespace

std::string TurnAtSize::name() const {
  return depth ? fmt::format("depth {:.6g} mm", *depth / units::mm)
               : fmt::format("half length {:.6g} mm", half_length / units::mm);
}

std::string_view TurnRun::governing_tip() const {
  double largest = -1;
  std::string_view tip;
  for (const TurnAtSize& size : sizes)
    for (const gear_fem::TorqueTurn& torque : size.turn.torques)
      for (const StationTurn& station : torque.stations)
        if (station.mode_I.range > largest) {
          largest = station.mode_I.range;
          tip = station.tip;
        }
  return tip;
}

std::string TurnRun::reason() const {
  if (!calculated) return {};
  for (const TurnAtSize& size : sizes)
    if (!size.turn.usable) return fmt::format("{}: {}", size.name(), size.turn.reason);
  return {};
}

ResultEvidence evidence_of(const TurnRun& result) {
  ResultEvidence evidence{
      .unusable_because = result.refused.empty() ? result.reason() : result.refused,
      .refused = !result.refused.empty(),
      .verdict = {},
      .notes = result.notes,
      .equations = {"FE-51", "FE-52", "FE-53", "FE-54", "FE-55", "GR-30"},
      .accuracies = {},
      .requirement = {}};
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

TurnRun plan_turn(const GearSet& gear, const TurnOptions& options) {
  return work_of(gear, options).run;
}

TurnRun run_turn(const GearSet& gear, const TurnOptions& options, const Ranks& ranks) {
  TurnWork work = work_of(gear, options);
  TurnRun& run = work.run;
  require_memory(run.plan, ranks);
  run.calculated = true;
  for (std::size_t n = 0; n < work.sizes.size(); ++n) {
    TurnAtSize& size = run.sizes[n];
    if (options.progress)
      work.sizes[n].done = [&](const std::string& step, double seconds) {
        options.progress(fmt::format("{}, {}: {}, {:.1f} s", run.path, size.name(), step, seconds));
      };
    size.turn = gear_fem::turn_crack(work.sizes[n]);
  }
  return std::move(work.run);
}

}  // namespace strainwave::fe_study
