// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/ranks.hpp"
#include "strainwave/fe_study/member_run.hpp"
#include "strainwave/gear_fem/crack_turn.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// K of a crack of the flexspline over a turn of the wave generator, from the input file of a
/// drive.

namespace strainwave::fe_study {

struct TurnOptions {
  /// Path of the crack; absent: the only crack of the barrel
  std::optional<std::string> crack = {};
  /// Order p of the solid elements, 2 to 4; absent: kSolidOrder
  std::optional<int> order = {};
  /// T at the output [N*m]; empty: the given torque, none, and the given torque reversed
  std::vector<double> torques = {};
  std::vector<double> half_lengths = {};  ///< of a through crack [m]; empty: its own
  std::vector<double> depths = {};        ///< of a surface crack of this shape [m]; empty: its own
  int angles = 36;                        ///< over one wave
  gear_fem::LargeRotations large_rotations = gear_fem::LargeRotations::automatic;
  /// Called with one line after each step, on every rank; may be empty.
  std::function<void(const std::string&)> progress = {};
};

/// A turn at one size of the crack.
struct TurnAtSize {
  std::optional<double> depth;  ///< of a surface crack [m]
  double half_length{};         ///< [m]
  gear_fem::CrackTurn turn;

  /// "half length 2 mm", or "depth 0.2 mm".
  [[nodiscard]] std::string name() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"depth", "m", "depth of a surface crack"}, &TurnAtSize::depth);
    field({"half_length", "m", "half length of the crack"}, &TurnAtSize::half_length);
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

  /// The tip with the larger range of K_I, over all sizes.
  [[nodiscard]] std::string_view governing_tip() const;
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
[[nodiscard]] TurnRun plan_turn(const GearSet& gear, const TurnOptions& options);

/// Computes a turn.  Every MPI rank must call it, and gets the result.
/// @throws InputError, SolverError  as plan_turn and gear_fem::turn_crack; InputError before the
///                                  first solution if the memory does not suffice
[[nodiscard]] TurnRun run_turn(const GearSet& gear, const TurnOptions& options, const Ranks& ranks);

/// The turn as a table (GR-30) that a crack can name as its turn_table: that of the governing tip.
[[nodiscard]] std::string turn_csv(const TurnRun& run);
[[nodiscard]] std::string turn_text(const TurnRun& run, const GearSet& gear);
/// K_I over the turn: a panel for each size and torque, a line for each station.
[[nodiscard]] std::string turn_plot(const TurnRun& run, const GearSet& gear);

}  // namespace strainwave::fe_study
