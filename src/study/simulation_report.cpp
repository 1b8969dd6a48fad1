// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/simulation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/motion/order_spectrum.hpp"
#include "strainwave/motion/simulate.hpp"
#include "strainwave/study/drive_joint.hpp"
#include "strainwave/study/drive_orders.hpp"

namespace strainwave {

using std::numbers::pi;

namespace {

constexpr double kRowsByDefault = 1000;
constexpr double kFirstTwist = 1e-3;        // half of the first bracket of the equilibrium [rad]
constexpr double kFarTwist = 1.0;           // beyond it the equilibrium is not looked for [rad]
constexpr double kLargestTolerance = 1e-5;  // [rad]
constexpr double kSamplesPerPeriod = 8;     // of the highest order [-]
constexpr double kLeastTurns = 4;           // of the input, for a spectrum [-]
constexpr double kMostSamples = 400'000;    // of a spectrum [-]
constexpr double kMostSampled = 8e8;        // of a motion, for a spectrum [-]
constexpr double kMostSamplings = 1e7;      // of a controller [-]
constexpr double kSameOrder = 1e-9;         // of the order [-]
constexpr double kLargestImbalance = 1e-4;  // of the energy of a usable motion [-]

/// Input and load of a joint over the manoeuvres of a drive.
void apply(const GearSet& gear, Joint& joint) {
  const std::vector<Manoeuvre>& manoeuvres = gear.manoeuvre;
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
  if (by_speed && gear.drivetrain->servo)
    joint.input = ServoDrive{.servo = *gear.drivetrain->servo, .speed = std::move(input)};
  else if (by_speed)
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

/// Begins a given torque, or a controller, with the torque that holds the load.
void hold(Joint& joint, const JointState& start) {
  const double torque = -joint_rate(joint, 0.0, start).forces.reaction;
  if (auto* const given = std::get_if<GivenTorque>(&joint.input))
    given->torque.value.front() = torque;
  if (auto* const drive = std::get_if<ServoDrive>(&joint.input)) drive->holding_torque = torque;
}

/// Part of a motion with a constant given speed.
struct SteadyPart {
  double from = 0.0;   ///< [s]
  double to = 0.0;     ///< [s]
  double speed = 0.0;  ///< [rad/s]
};

/// The second half of the longest part with a constant given speed; the first half is left to the
/// vibration that the change of speed began.
std::optional<SteadyPart> steady_part(const std::vector<Manoeuvre>& manoeuvres) {
  std::optional<SteadyPart> longest;
  SteadyPart now;
  for (const Manoeuvre& piece : manoeuvres) {
    if (!piece.input_speed) return std::nullopt;
    const bool constant = *piece.input_speed == now.speed;
    const double end = now.to + piece.duration;
    now = {.from = constant ? now.from : end, .to = end, .speed = *piece.input_speed};
    if (now.speed != 0 && (!longest || now.to - now.from > longest->to - longest->from))
      longest = now;
  }
  if (!longest) return std::nullopt;
  longest->from = (longest->from + longest->to) / 2;
  const double turns = (longest->to - longest->from) * std::abs(longest->speed) / (2 * pi);
  return turns >= kLeastTurns ? longest : std::nullopt;
}

/// Orders of the file, of the drive, and of a crack together with the kinematic error, each once.
std::vector<DriveOrder> named_orders(const GearSet& gear) {
  std::vector<DriveOrder> named;
  const auto add = [&](const std::string& words, double order) {
    for (DriveOrder& known : named)
      if (std::abs(known.order - order) <= kSameOrder * order) {
        known.words += "; " + words;
        return;
      }
    named.push_back({words, order});
  };
  for (const DriveOrder& of : drive_orders(gear)) add(of.words, of.order);
  for (const ErrorOrder& line : gear.kinematic_error) {
    const bool known = std::ranges::any_of(named, [&](const DriveOrder& of) {
      return std::abs(of.order - line.order) <= kSameOrder * line.order;
    });
    if (!known) add("kinematic error of the file", line.order);
  }
  const double wave =
      wave_orders(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio, gear.drive.wave_number)
          .flexspline;
  constexpr double kMainOrder = 2.0;  // of the kinematic error
  const std::string words = "crack of the flexspline with the kinematic error";
  add(words, wave + kMainOrder);
  if (std::abs(wave - kMainOrder) > kSameOrder) add(words, std::abs(wave - kMainOrder));
  return named;
}

/// What a spectrum needs of a motion.
struct SteadySignal {
  std::vector<double> angle;
  std::vector<double> error;
  std::vector<double> torque;

  [[nodiscard]] bool turns_on() const {
    for (std::size_t n = 1; n < angle.size(); ++n)
      if (angle[n] == angle[n - 1] || (angle[n] > angle[n - 1]) != (angle[1] > angle[0]))
        return false;
    return !angle.empty();
  }
};

/// The lines of a motion, by rising order.
MotionOrders orders_of(const GearSet& gear, const SteadyPart& part, const SteadySignal& sound,
                       const std::optional<SteadySignal>& cracked) {
  const std::vector<DriveOrder> named = named_orders(gear);
  std::vector<double> orders;
  for (const DriveOrder& of : named) orders.push_back(of.order);
  MotionOrders made{.from = part.from, .to = part.to, .speed = part.speed};
  for (const DriveOrder& of : named)
    made.lines.push_back(OrderRow{.cause = of.words, .order = of.order});
  const auto take = [&](const SteadySignal& signal, const std::vector<double>& values,
                        auto amplitude) {
    const OrderSpectrum spectrum = order_spectrum(signal.angle, values, orders);
    made.turns = spectrum.turns;
    for (std::size_t k = 0; k < orders.size(); ++k) {
      made.lines[k].turns_needed = spectrum.lines[k].turns_needed;
      if (spectrum.lines[k].separate) made.lines[k].*amplitude = spectrum.lines[k].amplitude;
    }
    return spectrum.floor;
  };
  made.error_floor = take(sound, sound.error, &OrderRow::error);
  made.torque_floor = take(sound, sound.torque, &OrderRow::torque);
  if (cracked) {
    made.cracked_error_floor = take(*cracked, cracked->error, &OrderRow::cracked_error);
    made.cracked_torque_floor = take(*cracked, cracked->torque, &OrderRow::cracked_torque);
  }
  std::ranges::sort(made.lines, {}, &OrderRow::order);
  return made;
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
  const auto* const drive = std::get_if<ServoDrive>(&joint.input);
  if (drive != nullptr) summary.largest_lag = 0.0;
  const Motion motion = simulate(
      joint, start, options,
      [&](const MotionSample& sample) {
        const auto raise = [](double& most, double value) {
          most = std::max(most, std::abs(value));
        };
        raise(summary.largest_torque, sample.forces.torque);
        raise(summary.largest_error, output_error(joint, sample.state));
        raise(summary.largest_input_torque, sample.forces.input_torque);
        if (drive != nullptr)
          raise(*summary.largest_lag,
                drive->speed.integral(sample.time) - sample.state.input_angle);
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
  apply(gear, joint);
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
  // A spectrum needs samples between the rows.
  std::optional<SteadyPart> steady = steady_part(gear.manoeuvre);
  std::size_t samples_per_row = 1;
  if (steady) {
    double highest = 0.0;
    for (const DriveOrder& of : named_orders(gear)) highest = std::max(highest, of.order);
    const double period = 2 * pi / (std::abs(steady->speed) * highest);
    const double needed = std::ceil(options.output_step * kSamplesPerPeriod / period);
    require(needed * report.duration / options.output_step <= kMostSampled, "manoeuvre",
            report.duration / period, "1",
            "at most a hundred million periods of the highest order; give a shorter motion");
    samples_per_row = static_cast<std::size_t>(needed);
    options.output_step /= needed;
    steady->from = std::max(steady->from, steady->to - kMostSamples * options.output_step);
  }
  const auto keep = [&](SteadySignal& signal, const MotionSample& at) {
    if (!steady || at.time < steady->from || at.time > steady->to) return;
    signal.angle.push_back(at.state.input_angle);
    signal.error.push_back(output_error(joint, at.state));
    signal.torque.push_back(at.forces.torque);
  };
  const bool cracked = !joint.cracks.empty();
  if (const auto* const drive = std::get_if<ServoDrive>(&joint.input);
      drive != nullptr && drive->servo.sample_time)
    require(*drive->servo.sample_time * kMostSamplings >= report.duration,
            "drivetrain.servo.sample_time", *drive->servo.sample_time, "s",
            "at least a ten millionth of the motion");
  SteadySignal sound_signal;
  std::size_t sample = 0;
  const auto take_sound = [&](const MotionSample& at) {
    keep(sound_signal, at);
    if (sample++ % samples_per_row != 0) return;
    report.rows.push_back({.time = at.time,
                           .input_angle = at.state.input_angle,
                           .input_speed = at.state.input_speed,
                           .output_angle = at.state.output_angle,
                           .output_speed = at.state.output_speed,
                           .output_error = output_error(joint, at.state),
                           .torque = at.forces.torque,
                           .input_torque = at.forces.input_torque});
  };
  report.intact =
      moved(made.sound(), options, take_sound, progress.part(0.1, cracked ? 0.55 : 1.0));
  std::optional<SteadySignal> cracked_signal;
  if (cracked) {
    cracked_signal.emplace();
    double most = 0.0;
    std::size_t n = 0;
    sample = 0;
    const auto take = [&](const MotionSample& at) {
      keep(*cracked_signal, at);
      if (sample++ % samples_per_row != 0 || n == report.rows.size())
        return;  // the sound drive may have stopped before
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
  const bool finished = report.intact.converged && (!report.cracked || report.cracked->converged);
  const bool turns_on = sound_signal.turns_on() && (!cracked_signal || cracked_signal->turns_on());
  if (steady && finished && turns_on)
    report.orders = orders_of(gear, *steady, sound_signal, cracked_signal);
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
  if (steady && finished && !turns_on)
    report.notes.push_back({.code = "motion.no_orders",
                            .text = "the input stops or turns back while its given speed is "
                                    "constant, so the motion has no lines over its angle",
                            .path = "manoeuvre",
                            .equation = "MO-20",
                            .severity = Severity::information,
                            .next_step = "Give a faster input_speed, or a stiffer servo."});
  demand_end(report.intact, "sound");
  if (report.cracked) demand_end(*report.cracked, "cracked");
  report.equations = {"MO-1", "MO-4", "MO-5", "MO-11", "MO-12", "MO-13", "MO-14"};
  if (report.orders) report.equations.emplace_back("MO-20");
  if (gear.drivetrain->servo) report.equations.emplace_back("MO-21");
  if (gear.drivetrain->hysteresis) report.equations.emplace_back("MO-8");
  if (gear.drivetrain->friction) report.equations.emplace_back("MO-10");
  return report;
}

}  // namespace strainwave
