// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "strainwave/model/input/turning_cup.hpp"

/// @file
/// What the stress of the oval is asked for, by every model of the oval.

namespace strainwave {

/// What the stress of the oval is asked for.
struct OvalRequest {
  std::vector<double> torques = {};  ///< T at the output [N*m]; empty: that of the file
  /// Whether large rotations are computed.
  LargeRotations large_rotations = LargeRotations::automatic;
};

/// The option of every command that bends the flexspline oval.
struct NonlinearOption {
  std::optional<LargeRotations> nonlinear;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"nonlinear", "",
           "large rotations of the oval: auto if they matter, on or off; auto if left out"},
          &NonlinearOption::nonlinear);
  }

  /// The choice of the option; automatic if it is left out.
  [[nodiscard]] LargeRotations large_rotations() const {
    return nonlinear.value_or(LargeRotations::automatic);
  }
};

/// A request as the options of a command.
struct OvalRequestOptions : NonlinearOption {
  std::vector<double> torque;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "torque",
           .unit = "N*m",
           .doc = "torque at the output, may be repeated; if left out that of the file"},
          &OvalRequestOptions::torque);
    NonlinearOption::describe(field);
  }

  /// The request that the options state.
  [[nodiscard]] OvalRequest request() const {
    return {.torques = torque, .large_rotations = large_rotations()};
  }
};

/// The torques of a request, ascending [N*m].
/// @throws InputError  as `check` and require_turning_cup; for a torque that is not finite
[[nodiscard]] std::vector<double> plan_oval(const GearSet& gear, const OvalRequest& request);

}  // namespace strainwave
