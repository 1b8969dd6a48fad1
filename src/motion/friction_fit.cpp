// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/friction_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/motion/simulate.hpp"

namespace strainwave {
namespace {

constexpr double kLeastSpeed = 5.0;      // of a run, over w_s [-]
constexpr double kByInertia = 5e-4;      // that inertia adds to a ramp's torque [-]
constexpr double kRampFrom = 0.97;       // of the torque that the formula expects [-]
constexpr double kRampTo = 1 + 6e-3;     // of the same [-]
constexpr double kTurned = 10.0;         // of the bristles' deflection: the input turns [-]
constexpr double kRampSamples = 20'000;  // of a ramp [-]
constexpr double kRunSamples = 200;      // of a run at constant speed [-]
// Bristles creep under a torque below their limit if the error of the steps shakes them.
constexpr double kBenchTolerance = 1e-13;  // [rad]
constexpr double kReturned = 2e-3;         // of a value that the bench returns [-]
constexpr std::uint64_t kMostFitSteps = 20'000'000;

/// The joint on the bench.
Joint on_bench(const Joint& joint, const LuGre& friction) {
  Joint bench = joint;
  bench.cracks.clear();
  bench.kinematic_error = {};
  bench.gravity_torque = 0.0;
  bench.input_damping = 0.0;
  bench.output_damping = 0.0;
  bench.input_friction = friction;
  bench.output_friction.reset();
  bench.output_speed.reset();
  bench.output_torque = {.value = {0.0}};
  return bench;
}

/// Angle of the output at which an external torque on it is held by an input at the angle 0.
double held_angle(const Joint& joint, double torque) {
  const auto left = [&](double angle) {
    return joint_rate(joint, 0.0, {.output_angle = angle}).forces.torque + torque;
  };
  if (torque == 0) return 0.0;
  double far = torque / tangent_stiffness(joint.spring, 0.0);
  while ((left(far) > 0) == (torque > 0)) far *= 2;
  return bracketed_root(left, std::min(0.0, far), std::max(0.0, far));
}

/// A mean over the second half of a run.
struct RunMeans {
  double input_torque = 0.0;  ///< [N*m]
  double efficiency = 0.0;    ///< [-]
  std::string reason = {};    ///< empty: measured
};

/// The drive at a constant speed of the input, with a torque against the output.
RunMeans run_at(Joint bench, const FrictionTargets& targets, double torque,
                const Progress& progress) {
  const double output_speed = targets.speed / bench.ratio;
  const double against = -std::copysign(torque, output_speed);
  bench.input = GivenSpeed{{.value = {targets.speed}}};
  bench.output_torque = {.value = {against}};
  const double duration = 4 * std::numbers::pi / targets.speed;
  RunMeans means;
  double supplied = 0.0;
  double used = 0.0;
  double count = 0.0;
  const Motion motion = simulate(
      bench, {.output_angle = held_angle(bench, against), .output_speed = output_speed},
      {.duration = duration,
       .output_step = duration / kRunSamples,
       .tolerance = kBenchTolerance,
       .max_steps = kMostFitSteps},
      [&](const MotionSample& at) {
        if (at.time < duration / 2) return;
        supplied += at.forces.input_torque * at.state.input_speed;
        used -= at.forces.output_torque * at.state.output_speed;
        means.input_torque += at.forces.input_torque;
        count += 1;
      },
      progress);
  means.reason = motion.reason;
  means.input_torque /= count;
  means.efficiency = used / supplied;
  return means;
}

/// A ramp of the torque at one end until the input turns.
/// @param expected  torque by the formula [N*m]
/// @param driven    whether the torque acts on the input; else on the output
/// @return          the torque [N*m], or nothing with the reason
std::optional<double> breaking_torque(Joint bench, double expected, bool driven,
                                      std::string& reason, const Progress& progress) {
  if (!std::isfinite(expected)) {
    reason = "the drive locks itself";
    return std::nullopt;
  }
  const LuGre& friction = *bench.input_friction;
  const double i = std::abs(bench.ratio);
  const double load = driven ? 0.0 : expected / i;
  const double turned = kTurned * friction.sliding(0.0, load) / friction.bristle_stiffness;
  // The input accelerates by the torque beyond the one that starts it: theta = F_s q t^3/(6 J)
  // where the torque rises by q of itself in a second.
  const double inertia = bench.input_inertia + bench.output_inertia / (i * i);
  const double rise =
      std::sqrt(std::pow(kByInertia, 3) * friction.breakaway / (6 * inertia * turned));
  const double duration = (kRampTo - kRampFrom) / rise;
  const Profile ramp{.time = {0.0, duration}, .value = {kRampFrom * expected, kRampTo * expected}};
  JointState start;
  if (driven) {
    bench.input = GivenTorque{ramp};
    start.bristle = kRampFrom * expected / friction.bristle_stiffness;
  } else {
    bench.input = GivenTorque{{.value = {0.0}}};
    bench.output_torque = ramp;
    start.output_angle = held_angle(bench, kRampFrom * expected);
    start.bristle = kRampFrom * expected / (bench.ratio * friction.bristle_stiffness);
  }
  std::optional<double> torque;
  double before = 0.0;
  double time_before = 0.0;
  const Motion motion = simulate(
      bench, start,
      {.duration = duration,
       .output_step = duration / kRampSamples,
       .tolerance = kBenchTolerance,
       .max_steps = kMostFitSteps},
      [&](const MotionSample& at) {
        const double angle = std::abs(at.state.input_angle);
        if (!torque && angle >= turned)
          torque =
              ramp.at(time_before + (at.time - time_before) * (turned - before) / (angle - before));
        before = angle;
        time_before = at.time;
      },
      progress);
  if (!torque)
    reason = motion.converged
                 ? fmt::format("the input does not turn up to {:.4g} N*m", kRampTo * expected)
                 : motion.reason;
  return torque;
}

}  // namespace

std::vector<double> four_values(const LuGre& friction, double ratio,
                                const FrictionTargets& targets) {
  const double i = std::abs(ratio);
  const double load = targets.torque / i;
  const double standing = friction.load_breakaway.value_or(friction.load_coulomb);
  const double back = standing < 1 ? i * friction.breakaway / (1 - standing)
                                   : std::numeric_limits<double>::infinity();  // (MO-42)
  return {friction.steady(targets.speed),                                      // (MO-41)
          friction.breakaway,                                                  // (MO-41)
          back, load / (load + friction.steady(targets.speed, load))};         // (MO-43)
}

FrictionFit fit_friction(const FrictionTargets& targets, double ratio,
                         const FrictionAssumptions& assumed) {
  const auto positive = [](const char* field, double value, const char* unit) {
    require(value > 0 && std::isfinite(value), field, value, unit, "> 0");
  };
  positive("no_load_torque", targets.no_load_torque, "N*m");
  positive("starting_torque", targets.starting_torque, "N*m");
  positive("back_driving_torque", targets.back_driving_torque, "N*m");
  require(targets.efficiency > 0 && targets.efficiency < 1, "efficiency", targets.efficiency, "1",
          "> 0 and < 1");
  positive("at_speed", targets.speed, "rad/s");
  positive("at_torque", targets.torque, "N*m");
  positive("breakaway_deflection", assumed.breakaway_deflection, "rad");
  positive("stribeck_speed", assumed.stribeck_speed, "rad/s");
  require(targets.speed >= kLeastSpeed * assumed.stribeck_speed, "at_speed", targets.speed, "rad/s",
          "at least five times the Stribeck speed, which is assumed to be 2 rad/s");
  require(ratio != 0 && std::isfinite(ratio), "ratio", ratio, "1", "not 0");
  FrictionFit fit{
      .friction = {.bristle_stiffness = targets.starting_torque / assumed.breakaway_deflection,
                   .coulomb = std::min(targets.starting_torque, targets.no_load_torque),
                   .breakaway = targets.starting_torque,
                   .stribeck_speed = assumed.stribeck_speed},
      .targets = targets,
      .ratio = std::abs(ratio)};
  LuGre& friction = fit.friction;
  // Behind five Stribeck speeds, breakaway has 1e-11 of its part, so each value gives one number.
  friction.viscous =
      std::max(0.0, targets.no_load_torque - friction.sliding(targets.speed)) / targets.speed;
  const double load = targets.torque / fit.ratio;
  const double back = targets.back_driving_torque;
  friction.load_breakaway =
      std::max(0.0, 1 - fit.ratio * targets.starting_torque / back);  // (MO-42)
  friction.load_coulomb =
      std::max(0.0, 1 / targets.efficiency - 1 - friction.steady(targets.speed) / load);  // (MO-43)
  const std::vector<double> fitted = four_values(friction, ratio, targets);
  const double wanted[] = {targets.no_load_torque, targets.starting_torque,
                           targets.back_driving_torque, targets.efficiency};
  for (std::size_t n = 0; n < fitted.size(); ++n)
    fit.values.push_back(
        {.quantity = static_cast<FrictionQuantity>(n), .wanted = wanted[n], .fitted = fitted[n]});
  return fit;
}

void measure(FrictionFit& fit, const Joint& joint, const Progress& progress) {
  const Joint bench = on_bench(joint, fit.friction);
  const auto value = [&](FrictionQuantity of) -> FrictionValue& {
    return fit.values[static_cast<std::size_t>(of)];
  };
  const auto take = [](FrictionValue& of, const std::string& reason, double measured) {
    of.reason = reason;
    if (reason.empty()) of.simulated = measured;
  };
  const RunMeans idle = run_at(bench, fit.targets, 0.0, progress.part(0.0, 0.05));
  take(value(FrictionQuantity::no_load_torque), idle.reason, idle.input_torque);
  const RunMeans loaded = run_at(bench, fit.targets, fit.targets.torque, progress.part(0.05, 0.1));
  take(value(FrictionQuantity::efficiency), loaded.reason, loaded.efficiency);
  FrictionValue& starting = value(FrictionQuantity::starting_torque);
  starting.simulated =
      breaking_torque(bench, starting.fitted, true, starting.reason, progress.part(0.1, 0.5));
  FrictionValue& back = value(FrictionQuantity::back_driving_torque);
  back.simulated = breaking_torque(bench, back.fitted, false, back.reason, progress.part(0.5, 1.0));
  fit.converged = std::ranges::all_of(fit.values, [](const FrictionValue& of) {
    return of.error() && std::abs(*of.error()) <= kReturned;
  });
}

}  // namespace strainwave
