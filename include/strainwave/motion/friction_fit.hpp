// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/motion/joint.hpp"

/// @file
/// Friction of the input fitted to four values that makers state, and the bench that measures them
/// on a simulated joint.

namespace strainwave {

/// The four values of a maker's catalogue.
struct FrictionTargets {
  double no_load_torque = 0.0;       ///< of the input that turns at `speed` without load [N*m]; > 0
  double starting_torque = 0.0;      ///< that starts the input without load [N*m]; > 0
  double back_driving_torque = 0.0;  ///< on the output, that starts the free input [N*m]; > 0
  double efficiency = 0.0;           ///< with `torque` on the load at `speed` [-]; > 0 and < 1
  double speed = 0.0;                ///< of the input [rad/s]; > 0
  double torque = 0.0;               ///< on the load for the efficiency [N*m]; > 0
};

/// What a fit takes as given, because the four values do not determine it.
struct FrictionAssumptions {
  double stribeck_speed = 2.0;         ///< w_s [rad/s]; > 0 and at most a fifth of the speed
  double breakaway_deflection = 1e-3;  ///< F_s/sigma_0 of the bristles [rad]; > 0
};

/// Which of the four values a number is.
enum class FrictionQuantity { no_load_torque, starting_torque, back_driving_torque, efficiency };
template <>
struct EnumNames<FrictionQuantity> {
  static constexpr std::array<std::string_view, 4> names = {"no-load torque", "starting torque",
                                                            "back-driving torque", "efficiency"};
};

/// One of the four values, as wanted, by the formula of the model, and by simulation.
struct FrictionValue {
  FrictionQuantity quantity = FrictionQuantity::no_load_torque;
  double wanted = 0.0;                   ///< [N*m], or [-] for the efficiency
  double fitted = 0.0;                   ///< by (MO-41) to (MO-43)
  std::optional<double> simulated = {};  ///< on the bench; absent: the bench did not measure it
  std::string reason = {};               ///< why the bench did not measure it

  /// Unit of the values: "1" for the efficiency, else "N*m".
  [[nodiscard]] std::string_view unit() const {
    return quantity == FrictionQuantity::efficiency ? "1" : "N*m";
  }
  /// Of the fitted value [-].
  [[nodiscard]] double residual() const { return fitted / wanted - 1; }
  /// Of the simulated value [-].
  [[nodiscard]] std::optional<double> error() const {
    return simulated ? std::optional(*simulated / wanted - 1) : std::nullopt;
  }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"quantity", "", "which of the four values"}, &FrictionValue::quantity);
    field({"unit", "", "unit of the values"},
          [](const FrictionValue& v) { return std::string(v.unit()); });
    field({"wanted", "*", "the given value"}, &FrictionValue::wanted);
    field({"fitted", "*", "value of the fitted friction by its formula"}, &FrictionValue::fitted);
    field({"residual", "1", "fitted over wanted, less 1"},
          [](const FrictionValue& v) { return v.residual(); });
    field({"simulated", "*", "value that a simulated test of the fitted drive measures"},
          &FrictionValue::simulated);
    field({"error", "1", "simulated over wanted, less 1"},
          [](const FrictionValue& v) { return v.error(); });
    field({"reason", "", "why the simulated test has no value"}, &FrictionValue::reason);
  }
};

/// Friction of the input that is fitted to four values, and its evidence.
struct FrictionFit {
  LuGre friction;
  FrictionTargets targets;  ///< what was wanted, with speed and torque of the efficiency
  double ratio = 0.0;       ///< magnitude [-]
  bool converged = false;   ///< whether the friction returns all four by simulation
  std::vector<FrictionValue> values = {};  ///< in the order of FrictionQuantity

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"friction", "", "the fitted friction, as in drivetrain.friction"},
          &FrictionFit::friction);
    field({"speed", "rad/s", "speed of the input for the no-load torque and the efficiency"},
          [](const FrictionFit& f) { return f.targets.speed; });
    field({"torque", "N*m", "torque on the load for the efficiency"},
          [](const FrictionFit& f) { return f.targets.torque; });
    field({"ratio", "1", "turns of the input per turn of the output"}, &FrictionFit::ratio);
    field({"converged", "", "whether the simulated friction returns all four values"},
          &FrictionFit::converged);
    field({"values", "", "the four values: wanted, fitted and simulated"}, &FrictionFit::values);
  }
};

/// The four values of a friction by the formulas (MO-41) to (MO-43), in the order of
/// FrictionQuantity.  The back-driving torque is infinite if the drive locks itself.
/// @param friction  with numbers in their range (require_constants)
/// @param ratio     turns of the input per turn of the output [-]; not 0; its magnitude counts
/// @param targets   for the speed and the torque of the efficiency
[[nodiscard]] std::vector<double> four_values(const LuGre& friction, double ratio,
                                              const FrictionTargets& targets);

/// Friction that has the four values (MO-41) to (MO-43), without the bench.
///
/// Breakaway is the starting torque.  The load's share of it follows from the back-driving torque,
/// that of the turning input from the efficiency.  The no-load torque gives the sum of coulomb and
/// viscous friction only: coulomb is assumed to be breakaway, or the no-load torque if this is
/// less.  A share that would be negative is 0, and its value keeps a residual.
/// @throws InputError  if a number is out of range
[[nodiscard]] FrictionFit fit_friction(const FrictionTargets& targets, double ratio,
                                       const FrictionAssumptions& assumed = {});

/// Measures the four values on a joint by `simulate` and adds them to the fit.
///
/// The bench takes the joint's inertias, spring, damping and hysteresis, and the fitted friction.
/// It leaves out cracks, kinematic error, gravity, the damping of motor and load, and the friction
/// of the output.  Without load: a run at the given speed, and a ramp of the input's torque until
/// the input turns.  With load: a run at the given speed and torque, and a ramp of the output's
/// torque until the input turns.  The ramps are so slow that inertia adds 5e-4 to the torque.
/// @throws Stopped  if the caller requests a stop
void measure(FrictionFit& fit, const Joint& joint, const Progress& progress = {});

}  // namespace strainwave
