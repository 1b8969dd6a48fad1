// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/life_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "flexspline_fatigue.hpp"
#include "strainwave/catalogue/torque_limits.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/life/block_temperature.hpp"
#include "strainwave/life/duty.hpp"
#include "strainwave/life/flank_wear.hpp"
#include "strainwave/life/load_history.hpp"
#include "strainwave/life/survival.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/hysteresis.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kHour = 3600;
constexpr int kBallPhases = 8;
constexpr int kWavePositions = 360;  // of the wave, over a turn
constexpr double kMakersSpeed = 2000 * units::rpm;
constexpr double kIso281RollerSlope = 9.0 / 8.0;
constexpr double kFarApart = 3;  // of the maker's rule from the ratio by ball forces [-]
constexpr std::string_view kBearing = "wave generator bearing";
constexpr std::string_view kOutputBearing = "output bearing";
constexpr std::string_view kFlexspline = "flexspline";
constexpr std::string_view kPeaks = "momentary peaks";

constexpr std::size_t kTorqueClasses = 48;  // of a history with more torques, in each sense

/// All parts of a repetition of the duty with one torque.
struct TorqueLevel {
  double torque = 0.0;         // at the flexspline [N*m]
  double output_turns = 0.0;   // in both senses together [-]
  double step_duration = 0.0;  // without the momentary peaks [s]
  double step_turns = 0.0;     // of the output, without the momentary peaks [-]
  bool of_steps = false;       // false: momentary peaks only
};

/// What the computations of a life share.
struct LifeCase {
  const GearSet& gear;
  DutyHistory history;     // at the output, as the makers' rules count
  DutyHistory flexspline;  // the same with the torques at the flexspline (DY-1)
  MakersLimits limits;
  double flexspline_share = 1.0;    // torque at the flexspline over that at the output [-]
  double input_turns = 0.0;         // of the input per turn of the output [-]
  double ring_turns = 0.0;          // of the bearing's rings against each other, per input turn
  double class_width = 0.0;         // of the torques; 0: each torque by itself [N*m]
  std::vector<TorqueLevel> levels;  // in ascending order of torque

  /// The torque that stands for a torque: its own, or the end of its class that is larger in size.
  [[nodiscard]] double class_of(double torque) const {
    if (class_width == 0) return torque;
    const double size = class_width * std::ceil(std::abs(torque) / class_width - 1e-9);
    return std::copysign(size, torque) + 0.0;
  }
  [[nodiscard]] std::size_t level_of(double torque) const {
    const auto found = std::ranges::lower_bound(levels, class_of(torque), {}, &TorqueLevel::torque);
    return static_cast<std::size_t>(found - levels.begin());
  }
};

double largest_step_torque(const DutyHistory& history) {
  double most = 0.0;
  for (const DutyStep& step : history.steps) most = std::max(most, std::abs(step.torque));
  return most;
}

double largest_peak_torque(const DutyHistory& history) {
  double most = 0.0;
  for (const DutyMomentaryPeak& peak : history.peaks)
    most = std::max(most, std::abs(peak.step.torque));
  return most;
}

double largest_torque(const DutyHistory& history) {
  return std::max(largest_step_torque(history), largest_peak_torque(history));
}

LifeCase life_case(const GearSet& gear) {
  if (!gear.duty)
    throw InputError("duty",
                     "must be given for the life; give [[duty.block]] with duration, "
                     "torque and output_speed");
  const Arrangement arrangement = arrangement_of(gear.duty->fixed);
  const PartTurns turns = part_turns(arrangement, gear.drive.ratio);
  DutyHistory history = duty_history(gear);
  if (gear.duty->resonance)
    history = amplified(std::move(history), amplification(*gear.duty->resonance));  // (GR-28)
  LifeCase of{.gear = gear,
              .history = history,
              .flexspline = at_flexspline(history),
              .limits = makers_limits(gear),
              .flexspline_share = flexspline_torque(arrangement, gear.drive.ratio),
              .input_turns = std::abs(signed_ratio(arrangement, gear.drive.ratio)),
              .ring_turns = std::abs(turns.wave_generator - turns.flexspline),
              .class_width = 0.0,
              .levels = {}};
  std::map<double, TorqueLevel> levels;
  const auto take = [&](const DutyStep& step, double times, bool of_steps) {
    TorqueLevel& level = levels[of.class_of(step.torque)];
    const double output_turns = times * step.duration * std::abs(step.output_speed) / (2 * pi);
    level.output_turns += output_turns;
    if (!of_steps) return;
    level.of_steps = true;
    level.step_duration += times * step.duration;
    level.step_turns += output_turns;
  };
  const auto take_all = [&] {
    levels.clear();
    for (const DutyStep& step : of.flexspline.steps) take(step, 1.0, true);
    for (const DutyMomentaryPeak& peak : of.flexspline.peaks)
      take(peak.step, peak.per_repetition, false);
  };
  take_all();
  if (levels.size() > kTorqueClasses) {
    of.class_width = largest_torque(of.flexspline) / kTorqueClasses;
    take_all();
  }
  for (auto& [torque, level] : levels) {
    level.torque = torque;
    of.levels.push_back(level);
  }
  return of;
}

void use(LifeReport& report, std::initializer_list<const char*> tags) {
  for (const char* const tag : tags)
    if (std::ranges::find(report.equations, tag) == report.equations.end())
      report.equations.emplace_back(tag);
}

// --- the maker's rules ---------------------------------------------------------------------------

/// A rule that compares a limit with a number of the duty.
RuleAnswer compared(MakersRule rule, const std::optional<MakersLimit>& limit,
                    std::optional<double> present, std::string_view unit, std::string_view field) {
  RuleAnswer answer{.rule = rule,
                    .outcome = RuleOutcome::not_needed,
                    .allowed = {},
                    .present = {},
                    .margin = {},
                    .origin = {}};
  if (limit) {
    answer.allowed = Quantity{limit->value, unit};
    answer.origin = limit->origin;
  } else {
    answer.origin = fmt::format("give rating.{}", field);
  }
  if (!present || *present == 0) return answer;
  answer.present = Quantity{*present, unit};
  answer.outcome = RuleOutcome::not_known;
  if (!limit) return answer;
  answer.margin = limit->value / *present - 1;
  answer.outcome = *present <= limit->value * (1 + 1e-12) ? RuleOutcome::kept : RuleOutcome::broken;
  return answer;
}

double largest_input_speed(const LifeCase& of) {
  double most = 0.0;
  for (const DutyStep& step : of.history.steps) most = std::max(most, std::abs(step.output_speed));
  for (const DutyMomentaryPeak& peak : of.history.peaks)
    most = std::max(most, std::abs(peak.step.output_speed));
  return most * of.input_turns;
}

/// Momentary peaks that turn the drive, per time [1/s].
double rate_of_peaks(const LifeCase& of) {
  double rate = 0.0;
  for (const DutyMomentaryPeak& peak : of.history.peaks)
    if (peak.step.output_speed != 0) rate += peak.per_repetition / of.history.duration;
  return rate;
}

/// Time after which the momentary peaks are used up; absent if none turns the drive.
std::optional<double> end_of_peaks(const LifeCase& of) {
  double used = 0.0;  // share of N_k per time
  for (const DutyMomentaryPeak& peak : of.history.peaks) {
    const double speed = std::abs(peak.step.output_speed) * of.input_turns;
    if (speed > 0)
      used += peak.per_repetition / of.history.duration /
              allowed_momentary_peaks(speed, peak.step.duration, of.gear.drive.wave_number);
  }
  if (!(used > 0)) return std::nullopt;
  return 1 / used;
}

/// The number of momentary peaks within a time against N_k (LI-2).
RuleAnswer number_of_peaks(const LifeCase& of, const std::optional<double>& time) {
  RuleAnswer answer{.rule = MakersRule::momentary_peaks,
                    .outcome = RuleOutcome::not_needed,
                    .allowed = {},
                    .present = {},
                    .margin = {},
                    .origin = "the maker's rule, 10000 waves under the peaks"};
  const std::optional<double> end = end_of_peaks(of);
  if (!end) return answer;
  const double rate = rate_of_peaks(of);
  answer.allowed = Quantity{rate * *end, "1"};
  answer.outcome = RuleOutcome::not_known;
  if (!time) {
    answer.origin = "give rating.bearing_life and rating.rated_torque, over whose life peaks count";
    return answer;
  }
  answer.present = Quantity{rate * *time, "1"};
  answer.margin = *end / *time - 1;
  answer.outcome = *time <= *end ? RuleOutcome::kept : RuleOutcome::broken;
  answer.origin += "; over the bearing's L10";
  return answer;
}

void add_rules(LifeReport& report, const LifeCase& of) {
  const MakersLimits& limits = of.limits;
  const double blocks = largest_step_torque(of.history);
  const double peaks = largest_peak_torque(of.history);
  const double most = std::max(blocks, peaks);
  const auto add = [&](MakersRule rule, const std::optional<MakersLimit>& limit, double present,
                       std::string_view unit, std::string_view field) {
    report.rules.push_back(compared(rule, limit, present, unit, field));
    if (limit && limit->similar && report.rules.back().outcome != RuleOutcome::not_needed)
      report.notes.push_back({"life.similar_limit",
                              fmt::format("the limit of {} is that of another size: {}",
                                          enum_name(rule), limit->origin),
                              fmt::format("rating.{}", field), "LI-30", Severity::care,
                              fmt::format("Give rating.{}.", field)});
  };
  add(MakersRule::average_torque, limits.average_torque, report.average.torque, "N*m",
      "average_torque");
  add(MakersRule::repeated_peak, limits.repeated_peak, blocks, "N*m", "repeated_peak");
  add(MakersRule::momentary_peak, limits.momentary_peak, peaks, "N*m", "momentary_peak");
  report.rules.push_back(number_of_peaks(
      of, report.bearing ? std::optional(report.bearing->ten_percent) : std::nullopt));
  add(MakersRule::average_speed, limits.average_speed, report.average.input_speed, "rad/s",
      "average_speed");
  add(MakersRule::largest_speed, limits.largest_speed, largest_input_speed(of), "rad/s",
      "largest_speed");
  add(MakersRule::ratcheting, limits.ratcheting_torque, most, "N*m", "ratcheting_torque");
  add(MakersRule::buckling, limits.buckling_torque, most, "N*m", "buckling_torque");
  use(report, {"LI-1", "LI-2", "LI-30"});
  std::string unknown;
  for (const RuleAnswer& rule : report.rules) {
    if (rule.outcome == RuleOutcome::not_known)
      unknown += fmt::format("{}{}", unknown.empty() ? "" : ", ", enum_name(rule.rule));
    if (rule.outcome == RuleOutcome::broken)
      report.notes.push_back(
          {"life.rule_broken",
           fmt::format("the rule {} is broken: the maker allows {}, and the duty has {}",
                       enum_name(rule.rule),
                       shown_quantity(rule.allowed->value, rule.allowed->unit),
                       shown_quantity(rule.present->value, rule.present->unit)),
           "duty", rule.rule == MakersRule::momentary_peaks ? "LI-2" : "LI-1",
           // A limit of another size does not condemn a drive.
           rule.origin.starts_with("similar") ? Severity::cannot_tell : Severity::critical,
           "Lower the load of the duty, or choose a larger drive."});
  }
  if (!unknown.empty())
    report.notes.push_back(
        {"life.limits_not_known",
         fmt::format("the maker's limits of these rules are not known: {}", unknown), "rating",
         "LI-30", Severity::care,
         "Give the limits in [rating]; the table of the rules names them."});
}

void add_makers_bearing(LifeReport& report, const LifeCase& of) {
  const auto& life = of.limits.bearing_life;
  const auto& rated = of.limits.rated_torque;
  if (!life || !rated) {
    report.notes.push_back({"life.bearing_not_known",
                            "the maker's rated life of the wave generator's bearing is not known",
                            "rating.bearing_life", "LI-3", Severity::cannot_tell,
                            "Give rating.bearing_life and rating.rated_torque."});
    return;
  }
  if (!(report.average.torque > 0)) {
    report.notes.push_back(
        {"life.no_torque",
         "the duty turns the drive without torque, for which the maker's rule gives no life",
         "duty.block", "LI-3", Severity::care, "Give the torques of the blocks."});
    return;
  }
  const DutyAverage average{.torque = report.average.torque,
                            .output_speed = report.average.output_speed,
                            .input_speed = report.average.input_speed};
  const double L10 = bearing_life(life->value, rated->value, average);
  report.bearing = {.ten_percent = L10,
                    .fifty_percent = WeibullLife{.ten_percent = L10}.time_of(0.5),
                    .origin = life->origin};
  use(report, {"LI-3", "LI-4"});
}

// --- the coupled drive ---------------------------------------------------------------------------

/// Ball forces and rim states at the torques of a duty.
class DrivenStates {
 public:
  explicit DrivenStates(const GearSet& sound) {
    const int balls = *sound.wave_generator->bearing->ball_count;
    for (int phase = 0; phase < kBallPhases; ++phase) {
      CoupledOptions options;
      options.cage_phase = 2 * pi * phase / (balls * kBallPhases);
      drives_.emplace_back(sound, options);
    }
  }

  /// Forces of all balls at all phases of the cage [N].
  const std::vector<double>& balls(double torque) {
    auto [at, fresh] = balls_.try_emplace(torque);
    if (fresh)
      for (const AssembledDrive& drive : drives_)
        for (const ContactForce& ball : solved(drive, torque).balls)
          at->second.push_back(ball.force);
    return at->second;
  }

  /// The first phase at a torque.
  const CurvePoint& point(double torque) {
    const auto found = points_.find(torque);
    if (found != points_.end()) return found->second;
    return points_.emplace(torque, solved(drives_.front(), torque)).first->second;
  }

  const std::vector<RimState>& rim(double torque) {
    const auto found = rims_.find(torque);
    if (found != rims_.end()) return found->second;
    return rims_.emplace(torque, rim_states(drives_.front(), torque, kWavePositions)).first->second;
  }

 private:
  static CurvePoint solved(const AssembledDrive& drive, double torque) {
    const std::array torques = {torque};
    TorsionCurve curve = torsion_curve(drive, torques);
    if (!curve.usable()) throw SolverError(curve.unusable_because);
    return std::move(curve.points.front());
  }

  std::vector<AssembledDrive> drives_;
  std::map<double, std::vector<double>> balls_;
  std::map<double, CurvePoint> points_;
  std::map<double, std::vector<RimState>> rims_;
};

void add_ball_forces(LifeReport& report, const LifeCase& of, DrivenStates& states,
                     const Progress& progress) {
  const RingRatings ratings = ring_ratings(*of.gear.wave_generator->bearing);
  std::vector<BallLoads> loads;
  for (std::size_t i = 0; i < of.levels.size(); ++i) {
    const TorqueLevel& level = of.levels[i];
    progress.at(static_cast<double>(i) / static_cast<double>(of.levels.size()));
    if (level.step_duration > 0)
      loads.push_back(
          {.forces = states.balls(level.torque),
           .speed = level.step_turns * of.input_turns * of.ring_turns / level.step_duration,
           .duration = level.step_duration});
  }
  BearingByForces by{.duty = ball_bearing_life(ratings, loads),
                     .rated = {},
                     .ratio = {},
                     .by_ratio = {},
                     .cage_phases = kBallPhases};
  if (const auto& rated = of.limits.rated_torque) {
    const std::array load = {
        BallLoads{.forces = states.balls(rated->value * std::abs(of.flexspline_share)),
                  .speed = kMakersSpeed * of.ring_turns / (2 * pi),
                  .duration = 1.0}};
    by.rated = ball_bearing_life(ratings, load);
    by.ratio = by.duty.ten_percent / by.rated->ten_percent;
    if (of.limits.bearing_life) by.by_ratio = of.limits.bearing_life->value * *by.ratio;
  }
  report.bearing_by_forces = by;
  use(report, {"LI-31", "LI-32"});
  if (report.bearing && by.by_ratio && report.bearing->ten_percent > kFarApart * *by.by_ratio)
    report.notes.push_back(
        {"life.light_load",
         fmt::format("the maker's rule counts the torque alone and gives {:.3g} h; the wave loads "
                     "the balls without torque too, and the maker's rated life times the ratio of "
                     "lives by ball forces is {:.3g} h",
                     report.bearing->ten_percent / kHour, *by.by_ratio / kHour),
         "duty", "LI-3", Severity::care, "Use the smaller number at so small a torque."});
  report.notes.push_back(
      {"life.ball_forces",
       "the hours of the bearing from its ball forces are many times shorter than a maker's, and "
       "the cause is open; use their ratio to the life at the rating, not the hours",
       "wave_generator.bearing", "LI-32", Severity::information,
       "Read the chapter on life in the theory manual."});
}

/// The waves at each torque level.
std::vector<WaveStates> waves_of(const LifeCase& of, DrivenStates& states,
                                 const PlaceStresses& stresses, int side) {
  std::vector<WaveStates> waves;
  for (const TorqueLevel& level : of.levels)
    waves.push_back(stresses.over_turn(states.rim(level.torque), states.point(level.torque), side));
  return waves;
}

/// The waves of the steps alone.
std::vector<WaveStates> waves_of_steps(const LifeCase& of, const std::vector<WaveStates>& waves) {
  std::vector<WaveStates> steps;
  for (std::size_t i = 0; i < waves.size(); ++i)
    if (of.levels[i].of_steps) steps.push_back(waves[i]);
  return steps;
}

/// Cycles of a point of the flexspline: waves at each torque, and cycles of the torque (LI-37).
std::vector<WaveCycles> flexspline_cycles(const LifeCase& of) {
  std::vector<WaveCycles> cycles;
  const double waves = of.gear.drive.wave_number * of.ring_turns * of.input_turns;
  for (std::size_t i = 0; i < of.levels.size(); ++i)
    if (of.levels[i].output_turns > 0)
      cycles.push_back({.first = i, .second = i, .count = waves * of.levels[i].output_turns});
  std::map<std::pair<std::size_t, std::size_t>, double> between;
  for (const TorqueCycle& cycle : torque_cycles(of.flexspline)) {
    const std::size_t from = of.level_of(cycle.from);
    const std::size_t to = of.level_of(cycle.to);
    if (from != to) between[std::minmax(from, to)] += cycle.count;
  }
  for (const auto& [levels, count] : between)
    cycles.push_back({.first = levels.first, .second = levels.second, .count = count});
  return cycles;
}

/// Miner's lives of one side of a place; empty if the line is not known.
std::vector<MinerLife> miner_lives(const LifeCase& of, const std::vector<WaveStates>& waves,
                                   const PlaceStrength& strength) {
  std::vector<MinerLife> lives;
  const FatigueStrength& fatigue = strength.fatigue();
  if (!fatigue.cycles || !fatigue.slope) return lives;
  const std::vector<WaveCycles> cycles = flexspline_cycles(of);
  for (const MinerRule rule : {MinerRule::original, MinerRule::elementary, MinerRule::haibach}) {
    const double damage =
        plane_damage(waves, cycles, strength.plane(), *fatigue.cycles, *fatigue.slope, rule);
    MinerLife life{.rule = rule, .damage_rate = damage / of.history.duration, .life = {}};
    if (damage > 0) life.life = of.history.duration / damage;
    lives.push_back(life);
  }
  return lives;
}

/// Whether momentary peaks bring a place above its endurance limit, for a time that is not known.
bool peaks_alone_exceed(const PlaceFatigue& place) {
  return place.miner.empty() && place.reserve_with_peaks && *place.reserve_with_peaks < 1;
}

/// The shorter lives of two sides: which side it is may depend on the rule.
std::vector<MinerLife> shorter(const std::vector<MinerLife>& one,
                               const std::vector<MinerLife>& other) {
  std::vector<MinerLife> lives = one;
  for (std::size_t i = 0; i < other.size(); ++i) {
    if (i >= lives.size())
      lives.push_back(other[i]);
    else if (other[i].damage_rate > lives[i].damage_rate)
      lives[i] = other[i];
  }
  return lives;
}

PlaceFatigue place_fatigue(const LifeCase& of, DrivenStates& states, FatiguePlace place) {
  const PlaceStresses stresses(of.gear, place);
  PlaceFatigue result{.place = place,
                      .unknown_because = stresses.unknown_because(),
                      .concentration = stresses.concentration(),
                      .plane = {},
                      .reserve = {},
                      .handbook = {},
                      .miner = {}};
  if (!result.unknown_because.empty()) return result;
  const PlaceStrength strength(of.gear, place);
  result.unknown_because = strength.unknown_because();
  result.surface = strength.surface();
  result.size = strength.size();
  result.support = strength.support();
  result.sensitivity = strength.plane().sensitivity;
  result.endurance = strength.plane().normal;
  for (const int side : stresses.sides()) {
    const std::vector<WaveStates> waves = waves_of(of, states, stresses, side);
    const std::vector<WaveStates> steps = waves_of_steps(of, waves);
    double least = 0.0;
    double most = 0.0;
    double least_shear = 0.0;
    double most_shear = 0.0;
    bool first = true;
    for (const WaveStates& wave : steps)
      for (const SurfaceStress& stress : wave) {
        least = first ? stress.hoop : std::min(least, stress.hoop);
        most = first ? stress.hoop : std::max(most, stress.hoop);
        least_shear = first ? stress.shear : std::min(least_shear, stress.shear);
        most_shear = first ? stress.shear : std::max(most_shear, stress.shear);
        first = false;
      }
    const bool known = result.unknown_because.empty();
    const std::optional<CriticalPlane> plane =
        known ? std::optional(critical_plane(steps, strength.plane())) : std::nullopt;
    if (known) {
      result.miner = shorter(result.miner, miner_lives(of, waves, strength));
      const double used = critical_plane(waves, strength.plane()).utilisation;
      if (!of.history.peaks.empty() && used > 0)
        result.reserve_with_peaks =
            std::min(result.reserve_with_peaks.value_or(1 / used), 1 / used);
    }
    const bool worse =
        side == stresses.sides().front() || (plane ? plane->utilisation > result.plane->utilisation
                                                   : (most - least) / 2 > result.hoop_amplitude);
    if (!worse) continue;
    result.hoop_amplitude = (most - least) / 2;
    result.hoop_mean = (most + least) / 2;
    result.shear_least = least_shear;
    result.shear_most = most_shear;
    if (!plane) continue;
    result.plane = plane;
    if (plane->utilisation > 0) result.reserve = 1 / plane->utilisation;
    const double shear = std::max(std::abs(least_shear), std::abs(most_shear));
    result.handbook = handbook_reserve({.bending_amplitude = result.hoop_amplitude,
                                        .shear_amplitude = shear / 2,
                                        .shear_mean = shear / 2},
                                       strength.plane(), strength.specimen_shear());
  }
  return result;
}

void add_fatigue(LifeReport& report, const LifeCase& of, DrivenStates& states,
                 const Progress& progress) {
  for (const FatiguePlace place :
       {FatiguePlace::wall, FatiguePlace::rim, FatiguePlace::tooth_root}) {
    progress.at(static_cast<double>(report.fatigue.size()) / 3);
    report.fatigue.push_back(place_fatigue(of, states, place));
    const PlaceFatigue& result = report.fatigue.back();
    if (!result.unknown_because.empty())
      report.notes.push_back(
          {"life.fatigue_not_known",
           fmt::format("the fatigue of the {} cannot be told", place_words(place)), "flexspline",
           "LI-36", Severity::cannot_tell, result.unknown_because});
    else if (result.reserve && *result.reserve < 1)
      report.notes.push_back(
          {"life.finite",
           fmt::format("the {} does not endure for ever: its reserve is {:.2f}", place_words(place),
                       *result.reserve),
           "flexspline", "LI-36", result.miner.empty() ? Severity::critical : Severity::care,
           result.miner.empty() ? "Lower the load, or give cycles and slope of the material's "
                                  "fatigue for the hours."
                                : "Lower the load, or make the wall stronger."});
    else if (peaks_alone_exceed(result))
      report.notes.push_back(
          {"life.peaks_not_counted",
           fmt::format(
               "the momentary peaks load the {} above its endurance limit: its reserve with "
               "them is {:.2f}, so it does not endure for ever",
               place_words(place), *result.reserve_with_peaks),
           "flexspline", "LI-36", Severity::cannot_tell,
           "Give cycles and slope of the material's fatigue for the hours."});
  }
  use(report, {"TC-24", "LI-6", "LI-7", "LI-34", "LI-35", "LI-36", "LI-38"});
  const Material& steel = only_material(of.gear, *of.gear.flexspline);
  if (steel.fatigue && of.gear.duty)
    if (const auto unstated = unstated_temperature(
            *of.gear.duty, "the constants of fatigue of the flexspline's material",
            steel.fatigue->temperature))
      report.notes.push_back(
          {"life.temperature", unstated->text, unstated->path, "", Severity::care,
           "Give constants that hold at this temperature, and state their temperatures in "
           "fatigue.temperature."});
  if (std::ranges::any_of(report.fatigue, [](const auto& p) { return !p.miner.empty(); }))
    use(report, {"LI-8", "LI-37"});
  if (!report.fatigue.back().reserve) return;
  use(report, {"LI-41", "LI-42", "LI-43"});
  report.notes.push_back(
      {"life.root_estimate",
       "the concentration of the rim's stress between the teeth is an estimate that no finite "
       "elements confirm",
       "flexspline.tooth_root", "LI-42", Severity::information});
}

// --- the other parts -----------------------------------------------------------------------------

void add_output_bearing(LifeReport& report, const LifeCase& of) {
  if (!of.gear.output_bearing) return;
  std::vector<OutputBearingLoad> loads;
  bool loaded = false;
  for (const DutyStep& step : of.history.steps) {
    if (!(step.duration > 0)) continue;
    loads.push_back({.radial_force = step.radial_force,
                     .axial_force = step.axial_force,
                     .bending_moment = step.bending_moment,
                     .speed = std::abs(step.output_speed) / (2 * pi),
                     .duration = step.duration});
    loaded = loaded || (step.output_speed != 0 && (step.radial_force > 0 || step.axial_force != 0 ||
                                                   step.bending_moment > 0));
  }
  if (!loaded) {
    report.notes.push_back(
        {"life.output_bearing_unloaded",
         "the output bearing has no life, because no block loads it while it turns",
         "output_bearing", "LI-33", Severity::information,
         "Give radial_force, axial_force or bending_moment of the blocks."});
    return;
  }
  report.output_bearing = output_bearing_life(*of.gear.output_bearing, loads);
  use(report, {"LI-33"});
}

void add_buckling(LifeReport& report, const LifeCase& of) {
  const auto& fs = of.gear.flexspline;
  if (!fs || !fs->barrel) return;
  const Material& steel = only_material(of.gear, *fs);
  const ElasticConstants elastic = elastic_constants(steel);
  const TwistedTube tube{.radius = (fs->barrel->outer_diameter - fs->barrel->wall_thickness) / 2,
                         .thickness = fs->barrel->wall_thickness,
                         .length = fs->barrel->length,
                         .youngs_modulus = elastic.E,
                         .poissons_ratio = elastic.nu};
  BuckledBarrel buckled{.elastic = tube_buckling(tube), .plastic_torque = {}, .reserve = {}};
  use(report, {"LI-39"});
  double torque = buckled.elastic.elastic_torque;
  if (steel.yield_strength) {
    buckled.plastic_torque = tube_torque(
        tube, plastic_buckling_stress(buckled.elastic.elastic_stress, *steel.yield_strength));
    torque = *buckled.plastic_torque;
    use(report, {"LI-40"});
  } else {
    report.notes.push_back(
        {"life.buckling_elastic",
         "the buckling torque is that of an elastic wall, which is far too high for the walls of "
         "these drives",
         "flexspline.material", "LI-40", Severity::information,
         "Give yield_strength of the flexspline's material."});
  }
  const double most = largest_torque(of.flexspline);
  if (most > 0) buckled.reserve = torque / most;
  if (buckled.reserve && *buckled.reserve < 1)
    report.notes.push_back(
        {"life.buckles",
         fmt::format("the barrel buckles at {}, below the largest torque of the duty",
                     shown_quantity(torque, "N*m", 3)),
         "flexspline.barrel", "LI-40", Severity::critical,
         "Lower the largest torque, or make the barrel thicker."});
  report.buckling = buckled;
}

// --- wear of the flanks --------------------------------------------------------------------------

constexpr int kWornStates = 5;
constexpr double kUnknownLife = 10000 * kHour;  // over which wear is shown if no part ends

/// Sliding ways of a flank over a turn against the wave at a torque, for drive and coast flanks.
std::array<std::vector<SlidingStep>, 2> sliding_ways(const GearSet& gear, const CurvePoint& point,
                                                     const std::vector<RimState>& rim) {
  const double pitch = 2 * pi / (gear.drive.wave_number * gear.drive.ratio);
  const WorkingHeights heights = working_heights(gear);
  const double common = heights.addendum + heights.spline_addendum;
  const FlankForce drive(point.drive_flanks, pitch);
  const FlankForce coast(point.coast_flanks, pitch);
  constexpr double kLeastShare = 0.1;  // of the common height that carries
  std::array<std::vector<SlidingStep>, 2> ways;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const RimState& state = rim[i];
    const RimState& before = rim[(i + rim.size() - 1) % rim.size()];
    const RimState& next = rim[(i + 1) % rim.size()];
    const double engaged = std::clamp(common - (gear.drive.radial_displacement - state.radial),
                                      kLeastShare * common, common);
    const double area = engaged / std::cos(gear.mesh->flank_angle) * gear.flexspline->rim->length;
    const double way =
        std::abs(next.radial - before.radial) / (2 * std::cos(gear.mesh->flank_angle));
    ways[0].push_back({.force = drive.at(state.position), .area = area, .way = way});
    ways[1].push_back({.force = coast.at(state.position), .area = area, .way = way});
  }
  return ways;
}

void add_wear(LifeReport& report, const LifeCase& of, DrivenStates& states) {
  const auto& coefficient = of.gear.mesh->wear_coefficient;
  if (!coefficient) return;
  FlankWear wear;
  for (const TorqueLevel& level : of.levels) {
    const auto ways = sliding_ways(of.gear, states.point(level.torque), states.rim(level.torque));
    const double turns = level.output_turns * of.input_turns * of.ring_turns / of.history.duration;
    wear.drive_rate += turns * wear_depth(*coefficient, ways[0]);
    wear.coast_rate += turns * wear_depth(*coefficient, ways[1]);
  }
  use(report, {"LI-44", "TC-18"});
  const double last = report.hours.value_or(kUnknownLife);
  for (int i = 0; i < kWornStates; ++i) {
    WornState state{.time = last * i / (kWornStates - 1), .lost_motion = {}, .K1 = {}};
    state.depth = (wear.drive_rate + wear.coast_rate) / 2 * state.time;
    GearSet worn = without_cracks(of.gear);
    worn.mesh->lobe_gap += state.depth;
    try {
      const AssembledDrive drive(worn);
      state.lost_motion = lost_motion(drive);
      state.K1 = makers_lines(drive).K1;
    } catch (const Error&) {
      // The flanks of this drive no longer hold; its row has no numbers.
    }
    wear.states.push_back(state);
  }
  report.wear = std::move(wear);
}

// --- the drive as a chain ------------------------------------------------------------------------

/// The end of the flexspline by Miner and Haibach at its worst place.
LifePart flexspline_part(const LifeReport& report) {
  LifePart part{
      .name = std::string(kFlexspline), .ten_percent = {}, .slope = {}, .end = {}, .origin = {}};
  std::string unknown;
  std::optional<double> reserve;
  bool by_peaks = false;  // whether momentary peaks alone are above the endurance limit
  for (const PlaceFatigue& place : report.fatigue) {
    if (!place.reserve) {
      unknown += fmt::format("{}{}", unknown.empty() ? "" : ", ", place_words(place.place));
      continue;
    }
    reserve = std::min(reserve.value_or(*place.reserve), *place.reserve);
    by_peaks = by_peaks || peaks_alone_exceed(place);
    if (const MinerLife* const sum = governing_sum(place);
        sum != nullptr && (!part.end || *sum->life < *part.end)) {
      part.end = sum->life;
      part.origin = fmt::format("Miner's sum ({}) of the {}, without a distribution",
                                enum_name(sum->rule), place_words(place.place));
    }
  }
  if (report.fatigue.empty())
    part.origin = "not known: the coupled drive is not solved";
  else if (!part.end && reserve && *reserve < 1)
    part.origin = "not known: above the endurance limit, give cycles and slope of the fatigue";
  else if (!part.end && by_peaks)
    part.origin =
        "not known: momentary peaks are above the endurance limit, give cycles and slope of the "
        "fatigue";
  else if (!part.end && reserve)
    part.origin = fmt::format("endures for ever with a reserve of {:.2f}", *reserve);
  if (!unknown.empty() && !report.fatigue.empty())
    part.origin += fmt::format("{}not known: {}", part.origin.empty() ? "" : "; ", unknown);
  return part;
}

void add_parts(LifeReport& report, const LifeCase& of) {
  LifePart bearing{.name = std::string(kBearing),
                   .ten_percent = {},
                   .slope = {},
                   .end = {},
                   .origin = of.limits.bearing_life && of.limits.rated_torque
                                 ? "not known: the maker's rule needs a torque"
                                 : "not known: give rating.bearing_life and rating.rated_torque"};
  if (report.bearing) {
    bearing.ten_percent = report.bearing->ten_percent;
    bearing.slope = makers_weibull_slope();
    bearing.origin = fmt::format("the maker's rule, {}", report.bearing->origin);
  }
  report.parts.push_back(bearing);
  report.parts.push_back(flexspline_part(report));
  if (of.gear.output_bearing) {
    LifePart output{.name = std::string(kOutputBearing),
                    .ten_percent = {},
                    .slope = {},
                    .end = {},
                    .origin = "no load while it turns"};
    if (report.output_bearing) {
      output.ten_percent = report.output_bearing->ten_percent;
      output.slope = kIso281RollerSlope;
      output.origin = "the maker's rule for the output bearing";
    }
    report.parts.push_back(output);
  }
  if (const std::optional<double> end = end_of_peaks(of))
    report.parts.push_back({.name = std::string(kPeaks),
                            .ten_percent = {},
                            .slope = {},
                            .end = end,
                            .origin = "the maker's number N_k, without a distribution"});
  report.parts.push_back(
      {.name = "flanks",
       .ten_percent = {},
       .slope = {},
       .end = {},
       .origin = of.gear.mesh && of.gear.mesh->wear_coefficient
                     ? "wear, for which the makers state no limit"
                     : "not known: give mesh.wear_coefficient, which no source states"});
}

/// Hours in words: whole ones if they are many, else three digits.
std::string hours_words(double time) {
  const double hours = time / kHour;
  if (hours >= 1e7) return fmt::format("{:.3g} h", hours);
  return hours >= 1000 ? fmt::format("{:.0f} h", hours) : shown_number(hours, 3) + " h";
}

void add_survival(LifeReport& report) {
  std::vector<WeibullLife> distributed;
  const LifePart* ends = nullptr;  // the first part with an end that does not scatter
  for (const LifePart& part : report.parts) {
    if (part.ten_percent)
      distributed.push_back({.ten_percent = *part.ten_percent, .slope = *part.slope});
    if (part.end && (ends == nullptr || *part.end < *ends->end)) ends = &part;
  }
  bool shared = false;  // whether the parts with a distribution end first
  if (!distributed.empty()) {
    const double chain = time_of_all(distributed, 0.9);
    shared = ends == nullptr || chain < *ends->end;
    report.hours = chain;
    double most = 0.0;
    for (const LifePart& part : report.parts) {
      if (!part.ten_percent || !shared) continue;
      // The cumulative hazard of a part at the end of the chain.
      const double hazard = std::pow(chain / *part.ten_percent, *part.slope);
      if (hazard > most) report.governing = part.name;
      most = std::max(most, hazard);
    }
    const double last = time_of_all(distributed, 0.05);
    constexpr int kPoints = 60;
    for (int i = 0; i <= kPoints; ++i) {
      const double time = last * i / kPoints;
      const bool over = ends != nullptr && time > *ends->end;
      report.survival.push_back(
          {.time = time, .share = over ? 0.0 : survival_of_all(distributed, time)});
    }
    use(report, {"LI-5"});
  }
  if (ends != nullptr && !shared) {
    report.hours = ends->end;
    report.governing = ends->name;
  }
  if (report.hours)
    report.answer =
        fmt::format("ends by the {} after {}{}", report.governing, hours_words(*report.hours),
                    shared ? ", which 90 % of the drives reach" : "");
  else
    report.answer = "no end found";
}

}  // namespace

const MinerLife* governing_sum(const PlaceFatigue& place) {
  const bool by_blocks = place.reserve && *place.reserve < 1;
  const auto found = std::ranges::find(
      place.miner, by_blocks ? MinerRule::haibach : MinerRule::original, &MinerLife::rule);
  return found != place.miner.end() && found->life ? &*found : nullptr;
}

LifeReport life_report(const GearSet& gear, const Progress& progress) {
  check(gear);
  const LifeCase of = life_case(gear);
  LifeReport report;
  const DutyAverage& average = of.history.average;
  report.average = {.torque = average.torque,
                    .output_speed = average.output_speed,
                    .input_speed = average.input_speed,
                    .duration = of.history.duration};
  if (of.class_width > 0)
    report.notes.push_back(
        {"life.torque_classes",
         fmt::format("the torques of the duty are rounded up to {} classes of {}", of.levels.size(),
                     shown_quantity(of.class_width, "N*m", 3)),
         "duty", "LI-37", Severity::information});
  if (gear.duty->resonance) {
    report.notes.push_back({"life.vibration",
                            fmt::format("the vibration multiplies the loads of the duty by {}",
                                        shown_number(amplification(*gear.duty->resonance), 3)),
                            "duty.resonance", "GR-28", Severity::information});
    use(report, {"GR-28"});
  }
  add_makers_bearing(report, of);
  add_rules(report, of);
  add_output_bearing(report, of);
  add_buckling(report, of);
  progress.at(0.1);
  std::optional<DrivenStates> states;
  if (const std::string missing = missing_for_torsion_curve(gear); !missing.empty()) {
    report.notes.push_back(
        {"life.no_curve", "bearing and flexspline are judged by the maker's rules only; " + missing,
         "", "TC-1", Severity::cannot_tell, "Give these fields."});
  } else {
    try {
      states.emplace(without_cracks(gear));
      add_ball_forces(report, of, *states, progress.part(0.1, 0.4));
      add_fatigue(report, of, *states, progress.part(0.4, 0.95));
    } catch (const SolverError& error) {
      report.notes.push_back(
          {"life.no_curve", fmt::format("the coupled drive has no solution: {}", error.what()), "",
           "TC-11", Severity::cannot_tell, "Check the torques of the duty."});
      states.reset();
    }
  }
  add_parts(report, of);
  add_survival(report);
  if (states) add_wear(report, of, *states);
  progress.at(1);
  return report;
}

LifeResult life_result(const LifeReport& report) {
  LifeResult result;
  const auto number = [](const std::optional<double>& value, std::string_view unit) {
    return value ? std::optional(Quantity{*value, unit}) : std::nullopt;
  };
  result.hours = number(report.hours, "s");
  if (report.bearing) {
    result.bearing_L10 = Quantity{report.bearing->ten_percent, "s"};
    result.bearing_L50 = Quantity{report.bearing->fifty_percent, "s"};
  }
  if (report.bearing_by_forces) result.bearing_ratio = number(report.bearing_by_forces->ratio, "1");
  if (report.output_bearing)
    result.output_bearing_L10 = Quantity{report.output_bearing->ten_percent, "s"};
  result.average_torque = Quantity{report.average.torque, "N*m"};
  result.average_input_speed = Quantity{report.average.input_speed, "rad/s"};
  for (const PlaceFatigue& place : report.fatigue) {
    auto& to = place.place == FatiguePlace::wall  ? result.wall_reserve
               : place.place == FatiguePlace::rim ? result.rim_reserve
                                                  : result.tooth_root_reserve;
    to = number(place.reserve, "1");
  }
  for (const RuleAnswer& rule : report.rules)
    if (rule.margin && (!result.makers_reserve || *rule.margin + 1 < result.makers_reserve->value))
      result.makers_reserve = Quantity{*rule.margin + 1, "1"};
  return result;
}

}  // namespace strainwave
