// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/turn_table.hpp"
#include "strainwave/model/result/crack_turn.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/oval_shell/oval_shell.hpp"

/// @file
/// K of a crack of the flexspline's barrel over a turn of the wave generator, without finite
/// elements.

namespace strainwave {

struct DriveTurnOptions {
  /// Path of the crack; absent: the only crack of the barrel
  std::optional<std::string> crack = {};
  /// T at the output [N*m]; empty: the given torque, none, and the given torque reversed
  std::vector<double> torques = {};
  std::vector<double> half_lengths = {};  ///< of a through crack [m]; empty: its own
  std::vector<double> depths = {};        ///< of a surface crack of this shape [m]; empty: its own
  int angles = 36;                        ///< over one wave, half a turn; 8 to 720
};

/// A turn under one torque.
struct LoadedTurn {
  double torque{};                    ///< T [N*m]
  std::vector<StationTurn> stations;  ///< of the upper tip, then of the lower tip

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque at the output"}, &LoadedTurn::torque);
    field({"stations", "", "places of the fronts"}, &LoadedTurn::stations);
  }
};

/// A turn at one size of the crack.
struct SizedTurn {
  std::optional<double> depth;  ///< of a surface crack [m]
  double half_length{};         ///< [m]
  std::vector<LoadedTurn> torques;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"depth", "m", "depth of a surface crack"}, &SizedTurn::depth);
    field({"half_length", "m", "half length of the crack"}, &SizedTurn::half_length);
    field({"torques", "", "the turn under each torque"}, &SizedTurn::torques);
  }
};

/// K over a turn, with its evidence.
struct DriveTurn {
  std::string path;         ///< of the crack in the input file
  double distance{};        ///< of its middle from the barrel's end toward the diaphragm [m]
  ShellContact contact;     ///< of the wave generator
  bool large_rotations{};   ///< whether large rotations of the oval were computed
  double largest_stress{};  ///< largest stress of the sound wall normal to the crack [Pa]
  std::vector<SizedTurn> sizes;
  std::vector<Note> notes;
  std::vector<std::string> equations;

  /// The station with the largest Delta K of mode I, over all sizes and torques.
  [[nodiscard]] const StationTurn& governing() const;
  [[nodiscard]] std::string_view governing_tip() const { return governing().tip; }
  [[nodiscard]] double largest() const { return governing().mode_I.largest; }
  [[nodiscard]] double range() const { return governing().mode_I.range; }
  [[nodiscard]] double ratio() const { return governing().mode_I.ratio; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = DriveTurn;
    field({.name = "largest",
           .unit = "Pa*m^0.5",
           .doc = "K_max of mode I where its range over a turn is largest",
           .headline = true},
          &R::largest);
    field({.name = "range", .unit = "Pa*m^0.5", .doc = "Delta K of mode I there", .headline = true},
          &R::range);
    field({.name = "ratio", .unit = "1", .doc = "R = K_min/K_max there", .headline = true},
          &R::ratio);
    field({"governing_tip", "", "the tip with the largest range"}, &R::governing_tip);
    field({"path", "", "path of the crack in the input file"}, &R::path);
    field({"distance", "m", "of the crack's middle from the barrel's end toward the diaphragm"},
          &R::distance);
    field({"wave_generator", "", "contact of the wave generator with the bore"}, &R::contact);
    field({"large_rotations", "", "whether large rotations of the oval were computed"},
          &R::large_rotations);
    field({"largest_stress", "Pa", "largest stress of the sound wall normal to the crack"},
          &R::largest_stress);
    field({"sizes", "", "the turn at each size of the crack"}, &R::sizes);
  }
};

/// Computes K over a turn.
///
/// Implements theory manual eqs. (CU-1) to (CU-4), (IN-1) to (IN-3).  The sound cup is a thin shell
/// under the wave generator.  The crack releases the stress of the shell on its faces.  The faces
/// of a through crack may touch, also over a part of the wall; a station of a surface crack is
/// closed or open.
///
/// Range: one crack of the barrel.  A through crack: nu from 0.25 to 0.35, R/t from 30 to 120, a/t
/// up to 16.  A surface crack: a/t up to 0.8, a/c from 0.2 to 1.  No friction.
/// Accuracy: the tables of (IN-2) and (IN-3).
///
/// @throws InputError   as require_turning_cup; if no crack of the barrel is there, or several and
///                      none is chosen; for values out of range; if the crack leaves the barrel, or
///                      the cam does not touch the bore
/// @throws SolverError  if a contact or the large rotations do not converge
[[nodiscard]] DriveTurn drive_turn(const GearSet& gear, const DriveTurnOptions& options = {});

/// The turn of the governing tip as a table (GR-30).
[[nodiscard]] TurnTable turn_table(const DriveTurn& turn);

/// The flexspline of a drive as a shell.
/// @param gear  passes require_turning_cup
[[nodiscard]] ShellCup shell_cup(const GearSet& gear);

}  // namespace strainwave
