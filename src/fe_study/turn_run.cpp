// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/turn_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "cup_notes.hpp"
#include "field_writer.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/fe_study/memory.hpp"
#include "strainwave/fem/mesh_size.hpp"
#include "strainwave/fem/vtu.hpp"
#include "strainwave/model/input/turning_cup.hpp"
#include "turn_files.hpp"
#include "wall_tubes.hpp"

namespace strainwave::fe_study {
namespace {

/// Solutions of one size, in terms of time: the crack's response, and a smaller crack that judges
/// it.
constexpr std::size_t kTurnSolutions = 2;

/// Memory of the responses of the crack's nodes, over that of one solution [-].
constexpr double kResponseMemory = 1.3;

/// States of a turn that take the time of one solution, where each is solved in full.
constexpr double kStatesOfASolution = 10;

/// Divisions of a cell in the fields over a turn; a folder has a hundred states.
constexpr int kFrameDivisions = 2;
/// Text of one state for each cell of the mesh [byte], measured.
constexpr double kFrameBytes = 3300;

gear_fem::TubeWithThroughCrack body_of(const GearSet& gear, const WallThroughCrack& crack,
                                       const TurnSize& size, int order) {
  gear_fem::TubeWithThroughCrack tube = tube_of(gear, crack, order, Surroundings::as_given);
  tube.half_length = size.half_length;
  tube.layers = gear_fem::kTurnLayers;
  return tube;
}
gear_fem::TubeWithSurfaceCrack body_of(const GearSet& gear, const WallSurfaceCrack& crack,
                                       const TurnSize& size, int order) {
  gear_fem::TubeWithSurfaceCrack tube = tube_of(gear, crack, order);
  tube.depth = *size.depth;
  tube.half_length = size.half_length;
  return tube;
}

/// The files of all states of one size.
class FrameFiles {
 public:
  FrameFiles(std::vector<OutputFile>& files, std::string stem, const Ranks& ranks)
      : files_(files), stem_(std::move(stem)), ranks_(ranks) {}

  void add(const gear_fem::TurnFrame& frame) {
    const std::string stem = torque_stem(stem_, frame.torque);
    FieldWriter writer(files_, ranks_);
    using Pieces = std::vector<std::string>;
    const auto series = [&](const std::string& kind) -> Series& {
      return series_[stem + kind];  // the frames come in the sequence of the angles
    };
    const auto named = [&](const std::string& kind) {
      return fmt::format("{}{}_{:03}", stem, kind, frame.number);
    };
    series("").push_back({frame.angle, writer.add(
                                           named(""), [&] { return fem::vtu_text(frame.fields); },
                                           [&](const Pieces& pieces) {
                                             return fem::pvtu_text(pieces, frame.fields);
                                           })});
    series("_faces").push_back(
        {frame.angle,
         writer.add(
             named("_faces"), [&] { return fem::crack_faces_vtu_text(frame.fields); },
             [&](const Pieces& pieces) { return fem::crack_faces_pvtu_text(pieces); })});
    if (!ranks_.first()) return;
    files_.push_back({named("_fronts") + ".vtu", fem::fronts_vtu_text(frame.fronts)});
    series("_fronts").push_back({frame.angle, files_.back().name});
  }

  /// Adds the files that list the series.
  void finish() {
    if (!ranks_.first()) return;
    for (const auto& [stem, files] : series_)
      files_.push_back({stem + ".pvd", fem::pvd_text(files)});
  }

 private:
  using Series = std::vector<fem::SeriesFile>;
  std::vector<OutputFile>& files_;
  std::string stem_;
  const Ranks& ranks_;
  std::map<std::string, Series> series_;
};

struct TurnWork {
  TurnRun run;
  std::vector<gear_fem::TurningCrack> sizes;
};

TurnWork work_of(const GearSet& gear, const TurnOptions& options) {
  const TurnPlan plan = plan_turn(gear, options.request, RimCracks::none);
  const Flexspline& flexspline = *gear.flexspline;
  const int order = options.order.value_or(kSolidOrder);
  require(order >= 2 && order <= 4, "order", order, "1", ">= 2 and <= 4 for a turn");
  TurnWork work;
  TurnRun& run = work.run;
  run.path = plan.crack.path;
  run.angles = plan.angles;
  run.torques = plan.torques;
  for (const TurnSize& size : plan.sizes) {
    run.sizes.push_back({size, {}});
    gear_fem::TurningCrack& turning = work.sizes.emplace_back();
    turning.ends = {
        .rim = flexspline.rim, .diaphragm = flexspline.diaphragm, .boss = flexspline.boss};
    turning.fit = cam_fit(gear);
    turning.torques = run.torques;
    turning.angles = plan.angles;
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
            if (options.fields) {
              const auto states =
                  static_cast<double>(plan.torques.size()) * static_cast<double>(plan.angles);
              planned.memory += kFrameBytes * states * static_cast<double>(mesh.cells.size());
              planned.seconds *= 1 + states / (kStatesOfASolution * kTurnSolutions);
              planned.solutions += plan.torques.size() * static_cast<std::size_t>(plan.angles);
            }
            run.plan.push_back(planned);
          } catch (const InputError& error) {
            throw InputError(run.path, error.what());
          }
          turning.tube = std::move(tube);
        },
        plan.crack.crack);
  }
  run.notes.push_back({"fe.turn_model",
                       "the crack is alone; the cam is rigid and has no friction; the torque acts "
                       "evenly round the rim, not in the zones of the teeth",
                       run.path, "FE-52", Severity::care});
  require(plan.crack.count() == 1, run.path + ".count", plan.crack.count(), "1",
          "1, because the mesh contains one crack");
  if (plan.crack.mouth_unknown())
    run.notes.push_back({"fe.mouth_outside",
                         "the mouth of the surface crack is assumed on the outer surface, because "
                         "the file does not state it",
                         run.path, "", Severity::care, "Give the mouth of the crack."});
  add_oval_notes(run.notes, gear);
  return work;
}

}  // namespace

std::vector<SizedTurn> TurnRun::turns() const {
  std::vector<SizedTurn> turns;
  for (const TurnAtSize& size : sizes) {
    SizedTurn& sized = turns.emplace_back(SizedTurn{size, {}});
    for (const gear_fem::TorqueTurn& torque : size.turn.torques) {
      std::vector<StationTurn>& stations =
          sized.torques.emplace_back(LoadedTurn{torque.torque, torque.stations}).stations;
      for (std::size_t i = 0; size.depth && i < stations.size(); ++i)
        if (i == 0 || stations[i].tip != stations[i - 1].tip) stations[i].station = 0;
    }
  }
  return turns;
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

TurnRun planned_turn(const GearSet& gear, const TurnOptions& options) {
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
    FrameFiles files(run.fields, size_stem(run, n), ranks);
    if (options.fields) {
      work.sizes[n].fields = {.divisions = kFrameDivisions};
      work.sizes[n].frame = [&files](const gear_fem::TurnFrame& frame) { files.add(frame); };
    }
    size.turn = gear_fem::turn_crack(work.sizes[n]);
    files.finish();
  }
  return std::move(work.run);
}

}  // namespace strainwave::fe_study
