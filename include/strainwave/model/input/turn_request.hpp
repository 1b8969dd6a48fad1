// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_turn.hpp"

/// @file
/// What a turn of the wave generator is asked for, by every model of a turn: a crack of the wall,
/// torques, sizes and angles.

namespace strainwave {

/// What K over a turn is asked for.
struct TurnRequest {
  /// Path of the crack; absent: the only one that the model knows
  std::optional<std::string> crack = {};
  /// T at the output [N*m]; empty: the given torque, none, and the given torque reversed
  std::vector<double> torques = {};
  std::vector<double> half_lengths = {};  ///< of a through crack [m]; empty: its own
  std::vector<double> depths = {};        ///< of a surface crack of this shape [m]; empty: its own
  int angles = 36;                        ///< over one wave, half a turn; 8 to 720
};

/// A request as the options of a command, without the crack.
struct TurnRequestOptions {
  std::vector<double> torque;
  std::vector<double> half_length;
  std::vector<double> depth;
  std::optional<int> angles;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using O = TurnRequestOptions;
    field({.name = "torque",
           .unit = "N*m",
           .doc = "torque at the output, may be repeated; if left out the file's torque, none, and "
                  "the reversed torque"},
          &O::torque);
    field({.name = "half_length",
           .unit = "m",
           .doc = "half length of a through crack, may be repeated; if left out that of the file",
           .range = kPositive},
          &O::half_length);
    field({.name = "depth",
           .unit = "m",
           .doc = "depth of a surface crack of the same shape, may be repeated; if left out that "
                  "of the file",
           .range = kPositive},
          &O::depth);
    field({.name = "angles",
           .unit = "",
           .doc = "angles over one wave, half a turn; 36 if left out",
           .range = {.lower = 8, .lower_open = false, .upper = 720, .upper_open = false}},
          &O::angles);
  }

  /// The request that the options state.
  /// @param crack  as TurnRequest::crack
  [[nodiscard]] TurnRequest request(std::optional<std::string> crack) const;
};

/// Cracks of the rim that a model of a turn knows besides the cracks of the barrel.
enum class RimCracks { none, surface };

/// A crack of the flexspline's wall.
struct CrackOfWall {
  std::string path;                                        ///< "flexspline.crack[0]"
  std::variant<WallThroughCrack, WallSurfaceCrack> crack;  ///< with the numbers of the file

  [[nodiscard]] double angle() const;         ///< beta from +z toward -theta [rad]
  [[nodiscard]] WallSection section() const;  ///< barrel or rim
  /// A surface crack whose file does not say from which surface it starts.
  [[nodiscard]] bool mouth_unknown() const;
  /// Equal cracks of the row [-]; 1 for a crack alone.
  [[nodiscard]] int count() const;
};

/// A request with all that the file and the defaults give.
struct TurnPlan {
  CrackOfWall crack;            ///< the crack that was chosen
  std::vector<double> torques;  ///< ascending [N*m]
  std::vector<TurnSize> sizes;  ///< ascending
  int angles{};                 ///< over one wave [-]
};

/// Completes a request for a drive.
/// @throws InputError  as `check` and require_turning_cup; if the wall has no crack that the model
///                     knows, or several and none is chosen; if the size is that of another kind of
///                     crack; for numbers out of range
[[nodiscard]] TurnPlan plan_turn(const GearSet& gear, const TurnRequest& request, RimCracks rim);

}  // namespace strainwave
