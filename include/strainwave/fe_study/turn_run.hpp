// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/command/command.hpp"
#include "strainwave/core/ranks.hpp"
#include "strainwave/fe_study/member_run.hpp"
#include "strainwave/gear_fem/crack_turn.hpp"
#include "strainwave/model/input/turn_request.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// K of a crack of the flexspline over a turn of the wave generator, from the input file of a
/// drive.

namespace strainwave::fe_study {

struct TurnOptions {
  TurnRequest request = {};
  /// Order p of the solid elements, 2 to 4; absent: kSolidOrder
  std::optional<int> order = {};
  LargeRotations large_rotations = LargeRotations::automatic;
  /// Whether TurnRun::fields is filled in; each state is then also solved in full.
  bool fields = false;
  /// Called with one line after each step, on every rank; may be empty.
  std::function<void(const std::string&)> progress = {};
};

/// A turn at one size of the crack.
struct TurnAtSize : TurnSize {
  gear_fem::CrackTurn turn;

  template <class Visitor>
  static void describe(Visitor&& field) {
    TurnSize::describe(field);
    field({"turn", "", "K over a turn, with its checks"}, &TurnAtSize::turn);
  }
};

struct TurnRun {
  std::string path;             ///< of the crack in the input file
  std::vector<RunSize> plan;    ///< estimates made before the run
  bool calculated = false;      ///< false: only the plan exists
  std::string refused;          ///< reason why this machine cannot compute the plan
  int angles{};                 ///< over one wave
  std::vector<double> torques;  ///< ascending [N*m]
  std::vector<TurnAtSize> sizes;
  std::vector<Note> notes;
  /// The fields over the turn as VTU files of this rank, with a PVD file for each series; not a
  /// part of the answer.
  std::vector<OutputFile> fields;

  /// The turns without their checks.  The station of a surface crack next to the surface counts as
  /// that at the surface, 0, where K is not defined.
  [[nodiscard]] std::vector<SizedTurn> turns() const;
  /// The first reason why the result must not be used; empty if it may be used.
  [[nodiscard]] std::string reason() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "path of the crack in the input file"}, &TurnRun::path);
    field({"plan", "", "estimates made before the run"}, &TurnRun::plan);
    field({"calculated", "", "false for a dry run"}, &TurnRun::calculated);
    field({"angles", "", "angles over one wave, half a turn"}, &TurnRun::angles);
    field({"sizes", "", "the turn at each size of the crack"}, &TurnRun::sizes);
  }
};

[[nodiscard]] ResultEvidence evidence_of(const TurnRun& result);

/// Plans a turn: fills a result except for the computed parts.
/// @throws InputError  if the drive has no crack of the barrel in a cup with a rim, or several and
///                     none is chosen; if a size does not fit; for numbers out of range
[[nodiscard]] TurnRun planned_turn(const GearSet& gear, const TurnOptions& options);

/// Computes a turn.  Every MPI rank must call it, and gets the result.
/// @throws InputError, SolverError  as planned_turn and gear_fem::turn_crack; InputError before the
///                                  first solution if the memory does not suffice
[[nodiscard]] TurnRun run_turn(const GearSet& gear, const TurnOptions& options, const Ranks& ranks);

/// The turn as a table (GR-30) that a crack can name as its turn_table: that of the governing tip.
[[nodiscard]] std::string turn_csv(const TurnRun& run, const GearSet& gear);
[[nodiscard]] std::string turn_text(const TurnRun& run, const GearSet& gear);
/// K_I over the turn: a panel for each size and torque, a line for each station.
[[nodiscard]] std::string turn_plot(const TurnRun& run, const GearSet& gear);

/// Pictures as SVG of at most 2 MB each, for each size of the crack: the opening through the wall
/// under each torque at the angle of its largest opening; and for each torque an animation (SMIL)
/// of the oval wall, the opening and K over one wave.  Without scripts or other files.
[[nodiscard]] std::vector<OutputFile> turn_pictures(const TurnRun& run);

}  // namespace strainwave::fe_study
