// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/input/turn_request.hpp"
#include "strainwave/model/result/crack_turn.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/oval_shell/oval_shell.hpp"

/// @file
/// K of a crack of the flexspline's wall over a turn of the wave generator, without finite
/// elements.

namespace strainwave {

/// K over a turn, with its evidence.
struct DriveTurn {
  std::string path;         ///< of the crack in the input file
  double distance{};        ///< of its middle from its section's end toward the diaphragm [m]
  ShellContact contact;     ///< of the wave generator
  bool large_rotations{};   ///< whether large rotations of the oval were computed
  double largest_stress{};  ///< largest stress of the sound wall normal to the crack, at its middle
                            ///< [Pa]
  std::vector<SizedTurn> sizes;
  std::vector<Note> notes;             ///< on the validity of the answer
  std::vector<std::string> equations;  ///< tags of the theory manual

  /// The station with the largest Delta K of mode I, over all sizes and torques.
  [[nodiscard]] const StationTurn& governing() const { return *governing_station(sizes); }
  /// Tip of the governing station: "upper" or "lower".
  [[nodiscard]] std::string_view governing_tip() const { return governing().tip; }
  /// K_max of mode I at the governing station [Pa*m^0.5].
  [[nodiscard]] double largest() const { return governing().mode_I.largest; }
  /// Delta K of mode I at the governing station [Pa*m^0.5].
  [[nodiscard]] double range() const { return governing().mode_I.range; }
  /// R = K_min/K_max of mode I at the governing station [-]; 0 if it never opens.
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
    field({"distance", "m", "of the crack's middle from its section's end toward the diaphragm"},
          &R::distance);
    field({"wave_generator", "", "contact of the wave generator with the bore"}, &R::contact);
    field({"large_rotations", "", "whether large rotations of the oval were computed"},
          &R::large_rotations);
    field({"largest_stress", "Pa",
           "largest stress of the sound wall normal to the crack, at its middle"},
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
/// Range: one crack of the barrel, or a surface crack of the rim, whose teeth are left out.  A
/// through crack: nu from 0.25 to 0.35, R/t from 30 to 120, a/t
/// from 0.5 to 16, a to R/6.  A surface crack: a/t up to 0.8, a/c from 0.2 to 1.  No friction.
/// Accuracy: the tables of (IN-2) and (IN-3).
///
/// @throws InputError   as plan_turn; beyond the range; if the crack leaves its section, or the cam
///                      does not touch the bore
/// @throws SolverError  if a contact or the large rotations do not converge
[[nodiscard]] DriveTurn drive_turn(const GearSet& gear, const TurnRequest& request = {});

}  // namespace strainwave
