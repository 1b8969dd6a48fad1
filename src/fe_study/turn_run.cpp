// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/turn_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/fe_study/memory.hpp"
#include "strainwave/fem/mesh_size.hpp"
#include "wall_tubes.hpp"

namespace strainwave::fe_study {
namespace {

/// Solutions of one size, in terms of time: the crack's response, and three sizes of the checks.
constexpr std::size_t kTurnSolutions = 4;

/// Memory of the responses of the crack's nodes, over that of one solution [-].
constexpr double kResponseMemory = 1.3;

std::string path_of(std::size_t n) { return fmt::format("flexspline.crack[{}]", n); }

/// The crack to turn, with its number in the file.
struct ChosenCrack {
  std::size_t number;
  const WallThroughCrack* crack;
};

ChosenCrack chosen(const GearSet& gear, const TurnOptions& options) {
  if (!gear.flexspline) throw InputError("flexspline", "must be given to be computed");
  std::vector<ChosenCrack> found;
  const auto& cracks = gear.flexspline->crack;
  for (std::size_t n = 0; n < cracks.size(); ++n) {
    const auto* const through = std::get_if<WallThroughCrack>(&cracks[n]);
    const bool fits = through != nullptr && through->section == WallSection::barrel;
    if (options.crack && *options.crack == path_of(n) && !fits)
      throw InputError(path_of(n),
                       "must be a through crack of the barrel; choose another crack by --crack");
    if (fits && (!options.crack || *options.crack == path_of(n))) found.push_back({n, through});
  }
  if (found.empty() && options.crack)
    throw InputError("--crack",
                     fmt::format("\"{}\" is not a crack of the flexspline", shown(*options.crack)));
  if (found.empty())
    throw InputError("flexspline.crack", "must have a through crack of the barrel");
  if (found.size() > 1)
    throw InputError("flexspline.crack",
                     "has several through cracks of the barrel; choose one of them by --crack");
  return found.front();
}

gear_fem::OvalFit fit_of(const GearSet& gear) {
  gear_fem::OvalFit fit{.radial_displacement = gear.drive.radial_displacement};
  if (!gear.wave_generator) return fit;
  fit.flattening = gear.wave_generator->cam_flattening;
  if (const auto& bearing = gear.wave_generator->bearing) {
    fit.clearance = bearing->clearance;
    if (bearing->outer_ring) fit.band_width = bearing->outer_ring->width;
  }
  return fit;
}

/// Values in ascending order, each once.
std::vector<double> ascending(std::vector<double> values) {
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values);
  values.erase(repeated.begin(), repeated.end());
  return values;
}

struct TurnWork {
  TurnRun run;
  std::vector<gear_fem::TurningCrack> sizes;
};

TurnWork work_of(const GearSet& gear, const TurnOptions& options) {
  check(gear);
  const ChosenCrack of = chosen(gear, options);
  const Flexspline& flexspline = *gear.flexspline;
  if (flexspline.crack_free != CrackFree::sections)
    throw InputError("flexspline.crack_free",
                     "must be \"sections\" for a turn, which needs barrel, rim and bottom");
  if (flexspline.shape == FlexsplineShape::hat)
    throw InputError("flexspline.shape", "must be \"cup\" or \"cylinder\" for a turn");
  if (!flexspline.rim)
    throw InputError("flexspline.rim",
                     "must be given, because the wave generator presses on the bore of the rim");
  if (has_other_rim(flexspline))
    throw InputError("flexspline.rim",
                     "must have a wall that covers the barrel's, inside and outside");
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
  std::vector<double> half_lengths = ascending(options.half_lengths);
  if (half_lengths.empty()) half_lengths.push_back(of.crack->half_length);
  for (const double half_length : half_lengths) {
    gear_fem::TurningCrack turning;
    turning.tube = tube_of(gear, *of.crack, order, Surroundings::as_given);
    turning.tube.torque = 1;
    turning.tube.half_length = half_length;
    turning.tube.layers = gear_fem::kTurnLayers;
    turning.fit = fit_of(gear);
    turning.torques = run.torques;
    turning.angles = options.angles;
    turning.large_rotations = options.large_rotations;
    try {
      const fem::HexMesh mesh = gear_fem::mesh_tube_with_through_crack(turning.tube);
      (void)fem::check_jacobians(mesh);
      RunSize size = size_of_solid(run.path, fem::count_unknowns(mesh, order), kTurnSolutions);
      size.memory *= kResponseMemory;
      run.plan.push_back(size);
    } catch (const InputError& error) {
      throw InputError(run.path, error.what());
    }
    work.sizes.push_back(std::move(turning));
  }
  run.notes.push_back(
      {"fe.turn_model",
       "the crack is alone, in the middle of the barrel; the cam is rigid, has the perimeter of "
       "the "
       "bore and no friction; the torque acts evenly round the rim, not in the zones of the teeth",
       run.path, "FE-52", Severity::care});
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

std::string_view TurnRun::governing_tip() const {
  double largest = -1;
  std::string_view tip;
  for (const TurnAtSize& size : sizes)
    for (const gear_fem::TorqueTurn& torque : size.turn.torques)
      for (const gear_fem::StationTurn& station : torque.stations)
        if (station.mode_I.range > largest) {
          largest = station.mode_I.range;
          tip = station.tip;
        }
  return tip;
}

std::string TurnRun::reason() const {
  for (const TurnAtSize& size : sizes)
    if (!size.turn.usable)
      return fmt::format("half length {:.6g} mm: {}", size.half_length / units::mm,
                         size.turn.reason);
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
  for (gear_fem::TurningCrack& turning : work.sizes) {
    const double half_length = turning.tube.half_length;
    if (options.progress)
      turning.done = [&](const std::string& step, double seconds) {
        options.progress(fmt::format("{}, half length {:.6g} mm: {}, {:.1f} s", run.path,
                                     half_length / units::mm, step, seconds));
      };
    run.sizes.push_back({.half_length = half_length, .turn = gear_fem::turn_crack(turning)});
  }
  return std::move(work.run);
}

}  // namespace strainwave::fe_study
