// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/simulation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/motion/simulate.hpp"
#include "strainwave/study/drive_joint.hpp"

namespace strainwave {
namespace {

constexpr double kRowsByDefault = 1000;
constexpr double kFirstTwist = 1e-3;        // half of the first bracket of the equilibrium [rad]
constexpr double kFarTwist = 1.0;           // beyond it the equilibrium is not looked for [rad]
constexpr double kLargestTolerance = 1e-5;  // [rad]
constexpr double kLargestImbalance = 1e-4;  // of the energy of a usable motion [-]

/// Input and load of a joint over the manoeuvres of a drive.
void apply(const std::vector<Manoeuvre>& manoeuvres, Joint& joint) {
  const bool by_speed = manoeuvres.front().input_speed.has_value();
  Profile input{.time = {0.0}, .value = {0.0}};
  double output = 0.0;
  for (const Manoeuvre& piece : manoeuvres)
    if (piece.output_torque) {
      output = *piece.output_torque;
      break;
    }
  Profile load{.time = {0.0}, .value = {output}};
  double time = 0.0;
  for (const Manoeuvre& piece : manoeuvres) {
    time += piece.duration;
    input.time.push_back(time);
    input.value.push_back(by_speed ? *piece.input_speed : *piece.input_torque);
    output = piece.output_torque.value_or(output);
    load.time.push_back(time);
    load.value.push_back(output);
  }
  joint.output_torque = std::move(load);
  if (by_speed)
    joint.input = GivenSpeed{std::move(input)};
  else
    joint.input = GivenTorque{std::move(input)};
}

/// The input at the angle 0 and the load where nothing accelerates it.
JointState equilibrium(const Joint& joint) {
  const auto accelerates = [&](double angle) {
    return joint_rate(joint, 0.0, {.output_angle = angle}).output_acceleration;
  };
  double far = kFirstTwist;
  while (far < kFarTwist && !(accelerates(-far) > 0 && accelerates(far) < 0)) far *= 2;
  if (far >= kFarTwist)
    throw InputError("manoeuvre[0].output_torque",
                     fmt::format("twists the drive at rest by more than {:g} rad, together with "
                                 "gravity; give a torque that the drive can bear",
                                 kFarTwist / 2));
  return {.output_angle = bracketed_root(accelerates, -far, far)};
}

/// Begins a given torque with the one that holds the load.
void hold(Joint& joint, const JointState& start) {
  if (auto* const given = std::get_if<GivenTorque>(&joint.input))
    given->torque.value.front() = -joint_rate(joint, 0.0, start).forces.reaction;
}

/// Angle of the output beyond that of an ideal stiff gear [rad].
double output_error(const Joint& joint, const JointState& state) {
  return state.output_angle - state.input_angle / joint.ratio;
}

/// Moves a joint from its equilibrium and hands each sample on.
MotionSummary moved(Joint joint, const SimulationOptions& options, const SampleSink& sink,
                    const Progress& progress) {
  const JointState start = equilibrium(joint);
  hold(joint, start);
  MotionSummary summary;
  const Motion motion = simulate(
      joint, start, options,
      [&](const MotionSample& sample) {
        const auto raise = [](double& most, double value) {
          most = std::max(most, std::abs(value));
        };
        raise(summary.largest_torque, sample.forces.torque);
        raise(summary.largest_error, output_error(joint, sample.state));
        raise(summary.largest_input_torque, sample.forces.input_torque);
        sink(sample);
      },
      progress);
  summary.last_error = output_error(joint, motion.last);
  summary.lost_energy = motion.energy.lost;
  summary.imbalance = motion.energy.imbalance;
  summary.steps = static_cast<double>(motion.steps);
  summary.events = static_cast<double>(motion.event_count);
  summary.converged = motion.converged;
  summary.reason = motion.reason;
  summary.time_reached = motion.time_reached;
  return summary;
}

}  // namespace

SimulationReport simulation_report(const GearSet& gear, const SimulationSettings& settings,
                                   const Progress& progress) {
  if (gear.manoeuvre.empty())
    throw InputError("manoeuvre",
                     "must be given for a motion; give [[manoeuvre]] with duration and "
                     "input_speed");
  DriveJoint made = drive_joint(gear, progress.part(0.0, 0.1));
  Joint& joint = made.joint;
  apply(gear.manoeuvre, joint);
  SimulationReport report;
  report.springs = made.springs;
  report.signed_ratio = joint.ratio;
  report.duration = joint.output_torque.time.back();
  require(settings.output_step >= 0 && std::isfinite(settings.output_step), "step",
          settings.output_step, "s", "> 0");
  SimulationOptions options{.duration = report.duration,
                            .output_step = settings.output_step > 0
                                               ? settings.output_step
                                               : report.duration / kRowsByDefault,
                            .tolerance = settings.tolerance};
  require(settings.tolerance > 0 && settings.tolerance <= kLargestTolerance, "--tolerance",
          settings.tolerance, "rad", "> 0 and <= 1e-5 rad");
  require(options.output_step <= report.duration, "step", options.output_step, "s",
          "at most the time of the motion");
  require(options.output_step * kMostRows >= report.duration * (1 - 1e-9), "step",
          options.output_step, "s", "at least a millionth of the motion");
  const bool cracked = !joint.cracks.empty();
  report.intact = moved(
      made.sound(), options,
      [&](const MotionSample& at) {
        report.rows.push_back({.time = at.time,
                               .input_angle = at.state.input_angle,
                               .input_speed = at.state.input_speed,
                               .output_angle = at.state.output_angle,
                               .output_speed = at.state.output_speed,
                               .output_error = output_error(joint, at.state),
                               .torque = at.forces.torque,
                               .input_torque = at.forces.input_torque});
      },
      progress.part(0.1, cracked ? 0.55 : 1.0));
  if (cracked) {
    double most = 0.0;
    std::size_t n = 0;
    const auto take = [&](const MotionSample& at) {
      if (n == report.rows.size()) return;  // the sound drive stopped before
      SimulationRow& row = report.rows[n++];
      row.cracked_output_angle = at.state.output_angle;
      row.cracked_output_error = output_error(joint, at.state);
      row.cracked_torque = at.forces.torque;
      row.cracked_input_torque = at.forces.input_torque;
      most = std::max(most, std::abs(at.state.output_angle - row.output_angle));
    };
    report.cracked = moved(joint, options, take, progress.part(0.55, 1.0));
    report.largest_difference = most;
  }
  report.notes = std::move(made.notes);
  const auto demand_end = [&](const MotionSummary& of, std::string_view words) {
    if (of.converged) {
      if (of.imbalance <= kLargestImbalance) return;
      report.notes.push_back(
          {.code = "motion.imbalance",
           .text = fmt::format("the energy of the {} drive does not balance: {} of what was "
                               "exchanged is missing",
                               words, shown_number(of.imbalance, 2)),
           .path = "manoeuvre",
           .equation = "MO-12",
           .severity = Severity::critical,
           .next_step = "Choose a smaller --tolerance."});
      return;
    }
    report.notes.push_back({.code = "motion.not_finished",
                            .text = fmt::format("the motion of the {} drive ends at {}: {}", words,
                                                shown_quantity(of.time_reached, "s", 4), of.reason),
                            .path = "manoeuvre",
                            .equation = "MO-13",
                            .severity = Severity::critical,
                            .next_step = "Choose a larger --tolerance, or a shorter motion."});
  };
  demand_end(report.intact, "sound");
  if (report.cracked) demand_end(*report.cracked, "cracked");
  report.equations = {"MO-1", "MO-4", "MO-5", "MO-11", "MO-12", "MO-13", "MO-14"};
  if (gear.drivetrain->hysteresis) report.equations.emplace_back("MO-8");
  if (gear.drivetrain->friction) report.equations.emplace_back("MO-10");
  return report;
}

}  // namespace strainwave
