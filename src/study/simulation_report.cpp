// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/simulation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "growing_joint.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/roots.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/motion/order_spectrum.hpp"
#include "strainwave/motion/simulate.hpp"
#include "strainwave/stiff_motion/simulate_stiff.hpp"
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
constexpr double kRecordedFactor = 100;     // a recorded motion may be longer by [-]
constexpr std::uint64_t kMostRecordedSteps = 100'000'000'000;
constexpr std::size_t kErrorSignal = 0;     // of the sums of the lines
constexpr std::size_t kTorqueSignal = 1;    // likewise
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
  if (manoeuvres.front().output_speed) {
    Profile moved = input;
    for (std::size_t i = 0; i < manoeuvres.size(); ++i)
      moved.value[i + 1] = *manoeuvres[i].output_speed;
    joint.output_speed = std::move(moved);
  }
  if (by_speed && gear.drivetrain->servo)
    joint.input = ServoDrive{.servo = *gear.drivetrain->servo, .speed = std::move(input)};
  else if (by_speed)
    joint.input = GivenSpeed{std::move(input)};
  else
    joint.input = GivenTorque{std::move(input)};
}

/// Speeds of both ends that wind up the drive without bound are refused (MO-46).
void check_wind_up(const GearSet& gear, const Joint& joint) {
  if (!joint.output_speed || !gear.manoeuvre.front().input_speed) return;
  double twist = 0.0;
  double before = 0.0;  // rate of the twist
  for (std::size_t i = 0; i < gear.manoeuvre.size(); ++i) {
    const Manoeuvre& piece = gear.manoeuvre[i];
    const double rate = *piece.input_speed / joint.ratio - *piece.output_speed;
    // The twist is largest at an end, or where its rate passes zero.
    const double share = before * rate < 0 ? before / (before - rate) : 0.0;
    const double inside = twist + before * share * piece.duration / 2;
    twist += (before + rate) / 2 * piece.duration;
    before = rate;
    const double most = std::max(std::abs(inside), std::abs(twist));
    if (most > kFarTwist / 2)
      throw InputError((FieldPath("manoeuvre")[i] / "output_speed").text(),
                       fmt::format("winds up the drive by {:.4g} rad against input_speed, more "
                                   "than {:g} rad; give input_speed over {:g}, the ratio with its "
                                   "sign, or input_torque",
                                   most, kFarTwist / 2, joint.ratio));
  }
}

/// The input at the angle 0 and the load where nothing accelerates it.
JointState equilibrium(Joint joint) {
  joint.output_speed.reset();  // the motion begins where it needs no torque on the output
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
/// @param duration  of the motion [s]
std::optional<SteadyPart> steady_part(const std::vector<Manoeuvre>& manoeuvres, double duration) {
  std::optional<SteadyPart> longest;
  SteadyPart now;
  for (const Manoeuvre& piece : manoeuvres) {
    if (!piece.input_speed) return std::nullopt;
    if (now.to >= duration) break;
    const bool constant = *piece.input_speed == now.speed;
    const double end = std::min(now.to + piece.duration, duration);
    now = {.from = constant ? now.from : end, .to = end, .speed = *piece.input_speed};
    if (now.speed != 0 && (!longest || now.to - now.from > longest->to - longest->from))
      longest = now;
  }
  if (!longest) return std::nullopt;
  longest->from = (longest->from + longest->to) / 2;
  const double turns = (longest->to - longest->from) * std::abs(longest->speed) / (2 * pi);
  return turns >= kLeastTurns ? longest : std::nullopt;
}

/// The largest lines of a table, whose lines are sorted.
std::vector<ErrorOrder> main_lines(const ErrorLines& of) {
  constexpr std::size_t kMostNamed = 12;
  constexpr double kSmallest = 0.01;  // of the largest line [-]
  std::vector<ErrorOrder> lines;
  for (const ErrorOrder& line : of.orders)
    if (lines.size() < kMostNamed && line.amplitude >= kSmallest * of.orders.front().amplitude)
      lines.push_back(line);
  return lines;
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
  std::vector<ErrorOrder> of_file = gear.kinematic_error;
  if (gear.error_table) {
    const std::vector<ErrorOrder> of_table = main_lines(gear.error_table->lines);
    of_file.insert(of_file.end(), of_table.begin(), of_table.end());
  }
  for (const ErrorOrder& line : of_file) {
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

/// The lines of a motion, by rising order.
MotionOrders orders_of(const std::vector<DriveOrder>& named, const SteadyPart& part,
                       const OrderSums& sound, const OrderSums* cracked) {
  MotionOrders made{.from = part.from, .to = part.to, .speed = part.speed};
  for (const DriveOrder& of : named)
    made.lines.push_back(OrderRow{.cause = of.words, .order = of.order});
  const auto take = [&](const OrderSums& sums, std::size_t signal, auto amplitude) {
    const OrderSpectrum spectrum = sums.spectrum(signal);
    made.turns = spectrum.turns;
    for (std::size_t k = 0; k < named.size(); ++k) {
      made.lines[k].turns_needed = spectrum.lines[k].turns_needed;
      if (spectrum.lines[k].separate) made.lines[k].*amplitude = spectrum.lines[k].amplitude;
    }
    return spectrum.floor;
  };
  made.error_floor = take(sound, kErrorSignal, &OrderRow::error);
  made.torque_floor = take(sound, kTorqueSignal, &OrderRow::torque);
  if (cracked != nullptr) {
    made.cracked_error_floor = take(*cracked, kErrorSignal, &OrderRow::cracked_error);
    made.cracked_torque_floor = take(*cracked, kTorqueSignal, &OrderRow::cracked_torque);
  }
  std::ranges::sort(made.lines, {}, &OrderRow::order);
  return made;
}

/// A joint from its equilibrium on, sample by sample, with what its summary needs.
class MovedJoint {
 public:
  MovedJoint(Joint joint, MotionEngine engine, const SimulationOptions& options,
             const MotionState* from, const std::vector<double>& orders,
             const std::optional<SteadyPart>& steady)
      : ratio_(joint.ratio), steady_(steady), run_(begun(joint, engine, options, from)) {
    controlled_ = std::holds_alternative<ServoDrive>(joint.input);
    output_given_ = joint.output_speed.has_value();
    grows_ = std::ranges::any_of(
        joint.cracks, [](const BreathingCrack& crack) { return crack.growth.has_value(); });
    if (steady_) sums_.emplace(orders, std::size_t{2});
    if (from == nullptr) return;
    if (sums_) sums_->restore(from->orders);
  }

  /// Computes the next sample.
  void advance(const Progress& progress) {
    now_ = std::visit([&](auto& run) { return run.next(progress); }, run_);
  }
  /// The sample; absent: the motion has ended.
  [[nodiscard]] const std::optional<MotionSample>& now() const { return now_; }
  /// Torque that the given motion of the output needs; absent: the output is free [N*m].
  [[nodiscard]] std::optional<double> output_torque() const {
    return output_given_ ? std::optional(now_->forces.output_torque) : std::nullopt;
  }
  [[nodiscard]] double error() const {
    return now_->state.output_angle - now_->state.input_angle / ratio_;
  }

  /// Adds the sample to the sums of the lines.
  void take() {
    if (!now_ || !sums_ || now_->time < steady_->from || now_->time > steady_->to) return;
    sums_->add((now_->time - steady_->from) / (steady_->to - steady_->from),
               now_->state.input_angle, std::array{error(), now_->forces.torque});
  }

  /// State at a sample; the explicit engine has one.
  /// @param samples  those that were taken
  [[nodiscard]] MotionState state(std::uint64_t samples) const {
    MotionState made{.motion = std::get<MotionRun>(run_).checkpoint()};
    // A sample that is not taken yet comes again.
    made.motion.next_sample = std::min(made.motion.next_sample, samples);
    if (sums_) made.orders = sums_->numbers();
    return made;
  }

  [[nodiscard]] MotionSummary summary() const {
    const Motion motion = std::visit([](const auto& run) { return run.motion(); }, run_);
    MotionSummary made{.largest_torque = motion.largest.torque,
                       .largest_error = motion.largest.error,
                       .largest_input_torque = motion.largest.input_torque};
    if (controlled_) made.largest_lag = motion.largest.lag;
    if (output_given_) made.largest_output_torque = motion.largest.output_torque;
    made.last_error = motion.last.output_angle - motion.last.input_angle / ratio_;
    made.lost_energy = motion.energy.lost;
    if (grows_) made.released_energy = motion.energy.released;
    made.imbalance = motion.energy.imbalance;
    made.steps = static_cast<double>(motion.steps);
    made.events = static_cast<double>(motion.event_count);
    made.converged = motion.converged;
    made.reason = motion.reason;
    made.beyond_table = motion.beyond_table;
    made.time_reached = motion.time_reached;
    return made;
  }

  [[nodiscard]] const OrderSums* sums() const { return sums_ ? &*sums_ : nullptr; }

 private:
  using Run = std::variant<MotionRun, StiffRun>;
  static Run begun(Joint& joint, MotionEngine engine, const SimulationOptions& options,
                   const MotionState* from) {
    const JointState start = equilibrium(joint);
    hold(joint, start);
    if (engine == MotionEngine::stiff) return StiffRun(joint, start, options);
    return from != nullptr ? MotionRun(joint, from->motion, options)
                           : MotionRun(joint, start, options);
  }

  double ratio_;
  std::optional<SteadyPart> steady_;
  Run run_;
  std::optional<OrderSums> sums_ = {};
  std::optional<MotionSample> now_ = {};
  bool controlled_ = false;    ///< whether a controller drives the input
  bool output_given_ = false;  ///< whether the output moves as given
  bool grows_ = false;         ///< whether a crack grows
};

/// Progress of two motions that go side by side, which never falls.  It counts from the share at
/// which a motion goes on, so that the time left is that of the rest.
class JointProgress {
 public:
  /// @param begin  share of the motion that is already done
  JointProgress(const Progress& progress, double begin)
      : progress_(progress), both_([this, begin](double share) {
          if (begin < 1) most_ = std::max(most_, (share - begin) / (1 - begin));
          progress_.at(most_);
          return true;
        }) {}
  JointProgress(const JointProgress&) = delete;
  JointProgress& operator=(const JointProgress&) = delete;
  JointProgress(JointProgress&&) = delete;
  JointProgress& operator=(JointProgress&&) = delete;
  ~JointProgress() = default;

  [[nodiscard]] const Progress& both() const { return both_; }

 private:
  Progress progress_;
  double most_ = 0.0;
  Progress both_;
};

/// The row of a time.
SimulationRow row_of(const MovedJoint& sound, const MovedJoint* cracked) {
  const MotionSample& at = *sound.now();
  SimulationRow row{.time = at.time,
                    .input_angle = at.state.input_angle,
                    .input_speed = at.state.input_speed,
                    .output_angle = at.state.output_angle,
                    .output_speed = at.state.output_speed,
                    .output_error = sound.error(),
                    .torque = at.forces.torque,
                    .input_torque = at.forces.input_torque};
  row.output_torque = sound.output_torque();
  if (cracked == nullptr || !cracked->now()) return row;
  row.cracked_output_angle = cracked->now()->state.output_angle;
  row.cracked_output_error = cracked->error();
  row.cracked_torque = cracked->now()->forces.torque;
  row.cracked_input_torque = cracked->now()->forces.input_torque;
  row.cracked_output_torque = cracked->output_torque();
  return row;
}

}  // namespace

namespace {

Note contacts_note(const ContactLosses& of) {
  const std::string assumed =
      of.coulomb
          ? " The turning input loses the torque of the contacts, without grease and seals, as "
            "a straight line over the load; its bristles bend by 0.02 rad at the rated torque, "
            "which "
            "is assumed."
          : "";
  return {
      .code = "motion.contact_friction",
      .text =
          fmt::format("while the input stands, the twist follows the loops of the coupled "
                      "drive; while it turns, they fade over {} of the input, which is "
                      "derived from the teeth in contact and not measured. That the sense of the "
                      "turn shifts the output, by up to half of the width of a loop, is "
                      "left out.{}",
                      shown_quantity(of.memory_angle, "rad", 3), assumed),
      .path = "drivetrain.contact_friction",
      .equation = "MO-53",
      .severity = Severity::information,
      .next_step = of.coulomb ? "Give drivetrain.friction with the grease's part, for example by "
                                "strainwave calibrate --friction."
                              : ""};
}

/// Refuses what the stiff engine does not move, before anything is computed.
void refuse_for_stiff_engine(const GearSet& gear, const SimulationSettings& settings) {
  const auto refuse = [](const char* path) {
    throw InputError(path, "does not go with --engine stiff; leave out one of the two");
  };
  if (settings.growth) refuse("--growth");
  if (!gear.drivetrain) return;
  if (!gear.drivetrain->slip_element.empty()) refuse("drivetrain.slip_element");
  if (gear.drivetrain->contact_friction == ContactFriction::computed)
    refuse("drivetrain.contact_friction");
}

Note beyond_loops_note(double most) {
  return {.code = "motion.beyond_loops",
          .text = fmt::format("the torque leaves the range of the loops, which ends at {}; beyond "
                              "it their width is constant",
                              shown_quantity(most, "N*m", 4)),
          .path = "drivetrain.contact_friction",
          .equation = "MO-52",
          .severity = Severity::care,
          .next_step = "Raise drivetrain.curve_torque."};
}

/// Says which given speed the voltage of the motor does not reach.
void note_no_load_speed(const GearSet& gear, std::vector<Note>& notes) {
  const std::optional<Servo>& servo = gear.drivetrain->servo;
  if (!servo || !servo->no_load_speed) return;
  for (std::size_t i = 0; i < gear.manoeuvre.size(); ++i) {
    const double speed = std::abs(gear.manoeuvre[i].input_speed.value_or(0.0));
    if (speed <= *servo->no_load_speed) continue;
    notes.push_back({.code = "motion.no_load_speed",
                     .text = fmt::format("the given speed of {} is above the no-load speed of the "
                                         "motor, {}, which the motor passes only if the load "
                                         "drives it",
                                         shown_quantity(speed, "rad/s", 4),
                                         shown_quantity(*servo->no_load_speed, "rad/s", 4)),
                     .path = (FieldPath("manoeuvre")[i] / "input_speed").text(),
                     .equation = "MO-57",
                     .severity = Severity::care,
                     .next_step = "Give a slower input_speed, or a motor with a higher "
                                  "drivetrain.servo.no_load_speed."});
    return;
  }
}

/// Says that the motor cannot bear the load with which the motion begins.
void note_too_weak(const Joint& joint, std::vector<Note>& notes) {
  const auto* const drive = std::get_if<ServoDrive>(&joint.input);
  if (drive == nullptr) return;
  Joint held = joint;
  hold(held, equilibrium(joint));
  const double needed = std::abs(std::get<ServoDrive>(held.input).holding_torque);
  for (const auto& [name, limit] : {std::pair{"torque_limit", drive->servo.torque_limit},
                                    std::pair{"stall_torque", drive->servo.stall_torque}}) {
    if (!limit || needed <= *limit) continue;
    notes.push_back(
        {.code = "motion.weak_motor",
         .text = fmt::format("the load needs {} of the motor at the start, but the "
                             "motor has {}, so the load drives it from there",
                             shown_quantity(needed, "N*m", 4), shown_quantity(*limit, "N*m", 4)),
         .path = std::string("drivetrain.servo.") + name,
         .equation = "MO-57",
         .severity = Severity::care,
         .next_step = std::string("Raise drivetrain.servo.") + name +
                      ", or lower the load of the first piece."});
    return;
  }
}

/// Says where friction pushes for a moment.
void note_pushing_friction(const Joint& joint, std::vector<Note>& notes) {
  for (const auto& [path, friction] :
       {std::pair{"drivetrain.friction", &joint.input_friction},
        std::pair{"drivetrain.load_friction", &joint.output_friction}}) {
    if (!*friction) continue;
    const double largest = (*friction)->largest_passive_damping();
    if ((*friction)->bristle_damping <= largest) continue;
    notes.push_back(
        {.code = "motion.pushing_friction",
         .text = fmt::format("behind a breakaway the friction may push for a moment, because its "
                             "bristle_damping of {} is above {}, which is viscous over the share "
                             "by which breakaway is above coulomb",
                             shown_quantity((*friction)->bristle_damping, "N*m*s/rad", 3),
                             shown_quantity(largest, "N*m*s/rad", 3)),
         .path = std::string(path) + ".bristle_damping",
         .equation = "MO-10",
         .severity = Severity::care,
         .next_step = "Lower bristle_damping, unless the motion reverses slowly."});
  }
}

/// @param sticks  whether the load has a friction of its own
Note output_friction_note(bool sticks) {
  Note note{.code = "motion.output_friction",
            .text =
                "the friction torque of the output is a part of the torque of the turning input "
                "only; while the input stands, the loops do not contain it",
            .path = "rating.friction_torque",
            .equation = "MO-54",
            .severity = Severity::care,
            .next_step =
                "Give this torque as [drivetrain.load_friction], and leave out "
                "rating.friction_torque."};
  if (sticks) {
    note.text =
        "the friction torque of the output is a part of the torque of the turning input, and "
        "drivetrain.load_friction adds to it";
    note.next_step = "Leave out rating.friction_torque if both are the same friction.";
  }
  return note;
}

}  // namespace

SimulationReport simulation_report(const GearSet& gear, const SimulationSettings& settings,
                                   const Progress& progress, const SimulationRecord* record) {
  if (gear.manoeuvre.empty())
    throw InputError("manoeuvre",
                     "must be given for a motion; give [[manoeuvre]] with duration and "
                     "input_speed");
  if (settings.engine == MotionEngine::stiff) {
    if (record != nullptr)
      throw InputError("--engine",
                       "stiff has no checkpoints, which --record and --resume need; leave out "
                       "--engine, or the record");
    require_stiff_motion("--engine");
    refuse_for_stiff_engine(gear, settings);
  }
  // A recorded motion is long against the making of its joint, and a computed curve takes long.
  const bool computed = gear.drivetrain && gear.drivetrain->spring == RestoringTorque::computed;
  const double growth_share = settings.growth ? 0.1 : 0.0;
  const bool rubbing =
      gear.drivetrain && gear.drivetrain->contact_friction == ContactFriction::computed;
  const double contact_share = rubbing && record == nullptr ? 0.1 : 0.0;
  const double joint_share =
      (record != nullptr ? 0.01 : (computed ? 0.5 : 0.1)) + growth_share + contact_share;
  DriveJoint made = drive_joint(
      gear, progress.part(0.0, joint_share - growth_share - contact_share), {}, settings.curve);
  Joint& joint = made.joint;
  SimulationReport report;
  if (rubbing) {
    DriveContacts contacts = drive_contacts(
        gear,
        progress.part(joint_share - growth_share - contact_share, joint_share - growth_share));
    joint.loops = std::move(contacts.loops);
    if (contacts.friction) joint.input_friction = contacts.friction;
    made.notes.push_back(contacts_note(contacts.losses));
    if (gear.rating && gear.rating->friction_torque > 0)
      made.notes.push_back(output_friction_note(gear.drivetrain->load_friction.has_value()));
    report.contacts = contacts.losses;
  }
  apply(gear, joint);
  check_wind_up(gear, joint);
  report.springs = made.springs;
  report.table = made.table;
  report.signed_ratio = joint.ratio;
  report.duration = joint.output_torque.time.back();
  std::optional<GrowingJoint> growing;
  if (settings.growth) {
    growing.emplace(gear, made, *settings.growth, report.duration,
                    progress.part(joint_share - growth_share, joint_share));
    report.duration = growing->end();
    report.growth = growing->result(joint);
  }
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
  if (record == nullptr)
    require(options.output_step * kMostRows >= report.duration * (1 - 1e-9), "step",
            options.output_step, "s", "at least a millionth of the motion without --record");
  // A motion that is recorded goes on after an interruption, so it may take long.
  const double longer = record != nullptr ? kRecordedFactor : 1.0;
  if (record != nullptr) options.max_steps = kMostRecordedSteps;
  // A spectrum needs samples between the rows.
  std::optional<SteadyPart> steady = steady_part(gear.manoeuvre, report.duration);
  std::size_t samples_per_row = 1;
  std::vector<DriveOrder> named;
  std::vector<double> orders;
  if (steady) {
    named = named_orders(gear);
    double highest = 0.0;
    for (const DriveOrder& of : named) {
      orders.push_back(of.order);
      highest = std::max(highest, of.order);
    }
    // A line without a name must not fall on a named one.
    highest = std::max(highest, joint.kinematic_error.highest_order());
    const double period = 2 * pi / (std::abs(steady->speed) * highest);
    const double needed = std::ceil(options.output_step * kSamplesPerPeriod / period);
    require(needed * report.duration / options.output_step <= kMostSampled * longer, "manoeuvre",
            report.duration / period, "1",
            record != nullptr ? "at most ten thousand million periods of the highest order; give a "
                                "shorter motion"
                              : "at most a hundred million periods of the highest order without "
                                "--record; give a shorter motion");
    samples_per_row = static_cast<std::size_t>(needed);
    options.output_step /= needed;
    steady->from = std::max(steady->from, steady->to - kMostSamples * options.output_step);
  }
  const bool cracked = made.cracked();
  if (const auto* const drive = std::get_if<ServoDrive>(&joint.input);
      drive != nullptr && drive->servo.sample_time)
    require(*drive->servo.sample_time * kMostSamplings * longer >= report.duration,
            "drivetrain.servo.sample_time", *drive->servo.sample_time, "s",
            record != nullptr ? "at least a thousand millionth of the motion"
                              : "at least a ten millionth of the motion without --record");
  const SimulationCheckpoint* const from =
      record != nullptr && record->from ? &*record->from : nullptr;
  if (from != nullptr && from->cracked.has_value() != cracked)
    throw InputError("checkpoint", "has other cracks than this drive; begin the motion again");
  MovedJoint sound(made.sound(), settings.engine, options, from != nullptr ? &from->sound : nullptr,
                   orders, steady);
  std::optional<MovedJoint> with_cracks;
  if (cracked)
    with_cracks.emplace(joint, settings.engine, options,
                        from != nullptr ? &*from->cracked : nullptr, orders, steady);
  MovedJoint* const other = with_cracks ? &*with_cracks : nullptr;
  SimulationCheckpoint at;
  if (from != nullptr) at = *from;
  const auto keep = [&] {
    at.sound = sound.state(at.samples);
    if (other != nullptr) at.cracked = other->state(at.samples);
    record->keep(at);
  };
  if (record != nullptr) {
    record->begin(cracked);
    keep();
  }
  const double begin = std::min(1.0, at.sound.motion.time / report.duration);
  const JointProgress share(progress.part(joint_share, 1.0), from != nullptr ? begin : 0.0);
  while (true) {
    try {
      sound.advance(share.both());
      if (other != nullptr) other->advance(share.both());
    } catch (const Stopped&) {
      if (record != nullptr && at.samples > 0) keep();
      throw;
    }
    if (!sound.now() && (other == nullptr || !other->now())) break;
    sound.take();
    if (other != nullptr) other->take();
    // The sound drive may stop before the cracked one.
    if (at.samples++ % samples_per_row == 0 && sound.now()) {
      const SimulationRow row = row_of(sound, other);
      if (row.cracked_output_angle)
        at.largest_difference =
            std::max(at.largest_difference, std::abs(*row.cracked_output_angle - row.output_angle));
      ++at.rows;
      if (record != nullptr)
        record->write(row);
      else
        report.rows.push_back(row);
    }
    if (record != nullptr && record->due()) keep();
  }
  report.intact = sound.summary();
  if (other != nullptr) {
    report.cracked = other->summary();
    report.largest_difference = at.largest_difference;
  }
  if (record != nullptr) report.recorded_rows = static_cast<double>(at.rows);
  const bool finished = report.intact.converged && (!report.cracked || report.cracked->converged);
  const bool turns_on =
      steady && sound.sums()->turns_on() && (other == nullptr || other->sums()->turns_on());
  if (finished && turns_on)
    report.orders =
        orders_of(named, *steady, *sound.sums(), other != nullptr ? other->sums() : nullptr);
  report.notes = std::move(made.notes);
  note_no_load_speed(gear, report.notes);
  note_too_weak(joint, report.notes);
  note_pushing_friction(joint, report.notes);
  if (growing)
    for (Note& note : growing->notes())
      if (std::ranges::find(report.notes, note) == report.notes.end())
        report.notes.push_back(std::move(note));
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
    report.notes.push_back(
        {.code = "motion.not_finished",
         .text = fmt::format("the motion of the {} drive ends at {}: {}", words,
                             shown_quantity(of.time_reached, "s", 4), of.reason),
         .path = "manoeuvre",
         .equation = "MO-13",
         .severity = Severity::critical,
         .next_step = of.beyond_table ? "Raise drivetrain.curve_torque."
                                      : "Choose a larger --tolerance, or a shorter motion."});
  };
  if (steady && finished && !turns_on)
    report.notes.push_back({.code = "motion.no_orders",
                            .text = "the input stops or turns back while its given speed is "
                                    "constant, so the motion has no lines over its angle",
                            .path = "manoeuvre",
                            .equation = "MO-20",
                            .severity = Severity::information,
                            .next_step = "Give a faster input_speed, or a stiffer servo."});
  if (record != nullptr)
    report.notes.push_back(
        {.code = "motion.recorded",
         .text = fmt::format("{} rows of the motion stand in the record and not in this answer",
                             shown_number(*report.recorded_rows, 12)),
         .path = "manoeuvre",
         .equation = "MO-22",
         .severity = Severity::information});
  if (report.contacts &&
      std::max(report.intact.largest_torque,
               report.cracked ? report.cracked->largest_torque : 0.0) > largest_curve_torque(gear))
    report.notes.push_back(beyond_loops_note(largest_curve_torque(gear)));
  demand_end(report.intact, "sound");
  if (report.cracked) demand_end(*report.cracked, "cracked");
  report.equations = {"MO-1", "MO-4", "MO-5", "MO-11", "MO-12", "MO-13", "MO-14"};
  if (report.table)
    for (const char* const tag : {"MO-25", "MO-26", "MO-27"}) report.equations.emplace_back(tag);
  if (gear.error_table) report.equations.emplace_back("MO-56");
  if (report.table && report.table->teeth_range) report.equations.emplace_back("MO-58");
  if (report.orders) report.equations.emplace_back("MO-20");
  if (gear.drivetrain->servo) report.equations.emplace_back("MO-21");
  if (gear.drivetrain->servo && gear.drivetrain->servo->stall_torque)
    report.equations.emplace_back("MO-57");
  if (record != nullptr) report.equations.emplace_back("MO-22");
  if (gear.drivetrain->hysteresis) report.equations.emplace_back("MO-8");
  if (report.contacts)
    for (const char* const tag : {"MO-52", "MO-53", "MO-54"}) report.equations.emplace_back(tag);
  const auto warm = [](const std::optional<LuGre>& of) { return of && of->warming != 0; };
  if (warm(gear.drivetrain->friction) || warm(gear.drivetrain->load_friction))
    report.equations.emplace_back("MO-55");
  if (joint.input_friction || joint.output_friction) report.equations.emplace_back("MO-10");
  if (joint.input_friction && joint.input_friction->by_load())
    report.equations.emplace_back("MO-40");
  if (!gear.drivetrain->slip_element.empty())
    for (const char* const tag : {"MO-44", "MO-45"}) report.equations.emplace_back(tag);
  if (joint.output_speed) report.equations.emplace_back("MO-46");
  if (growing) {
    report.equations.emplace_back("MO-50");
    for (const std::string& tag : growing->equations())
      if (std::ranges::find(report.equations, tag) == report.equations.end())
        report.equations.push_back(tag);
  }
  return report;
}

}  // namespace strainwave
