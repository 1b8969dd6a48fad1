// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/load_cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/growth/rainflow.hpp"

namespace strainwave {
namespace {

LoadState state_of(const DriveCrack& crack, const DutyStep& step, double turned) {
  LoadState state{.torque = step.torque, .axial_force = step.axial_force};
  switch (crack.turning) {
    case TurningLoad::wave:
    case TurningLoad::wave_at_spline:
      state.assembly = turned;
      break;
    case TurningLoad::bending:
      state.bending_moment = turned * step.bending_moment;
      break;
    case TurningLoad::balls:
      if (turned < 0) state.torque = 0.0;
      break;
    case TurningLoad::none:
      break;
  }
  return state;
}

/// Refuses a torque beyond the crack's table of K over a turn.
void require_covered(const DriveCrack& crack, const DutyStep& step) {
  const TurnTable& table = *crack.turn_table;
  if (table.covers(step.torque)) return;
  throw InputError(
      crack.path + ".turn_table",
      fmt::format("\"{}\" covers torques from {} to {}, but the duty has {}; compute K "
                  "at this torque too",
                  shown(table.file), shown_quantity(table.torques.front(), "N*m", 9),
                  shown_quantity(table.torques.back(), "N*m", 9),
                  shown_quantity(step.torque, "N*m", 9)));
}

/// The loads of the steps as one value each, for counting: K along the direction in which the
/// constant loads of two steps differ most, at the point of the front where they do.
class CountedValue {
 public:
  CountedValue(const DriveCrack& crack, const CracksAtTorques& at_torque,
               const std::vector<DutyStep>& steps)
      : crack_(crack), factors_(crack, at_torque, crack.size) {
    if (factors_.has_turn())
      for (const DutyStep& step : steps) require_covered(crack, step);
    double largest = 0.0;
    for (std::size_t point = 0; point < factors_.points() && !steps.empty(); ++point) {
      const auto constant = [&](const DutyStep& step) { return constant_at(point, step); };
      const auto farthest = [&](const Modes& from) {
        Modes widest{};
        for (const DutyStep& step : steps) {
          const Modes away = difference(constant(step), from);
          if (product(away, away) > product(widest, widest)) widest = away;
        }
        return widest;
      };
      const Modes first = constant(steps.front());
      const Modes outermost = farthest(first);
      const Modes from = {first[0] + outermost[0], first[1] + outermost[1],
                          first[2] + outermost[2]};
      Modes widest = farthest(from);
      if (product(widest, widest) <= largest) continue;
      largest = product(widest, widest);
      // Toward the larger K of the two, so that a peak is a peak wherever the duty begins.
      const Modes to = {from[0] + widest[0], from[1] + widest[1], from[2] + widest[2]};
      if (open_part(to) < open_part(from))
        for (double& of_mode : widest) of_mode = -of_mode;
      direction_ = widest;
      point_ = point;
    }
  }

  [[nodiscard]] double of(const DutyStep& step, double turned) const {
    if (factors_.has_turn()) {
      double least = std::numeric_limits<double>::infinity();
      double most = -least;
      for (const Modes& K : factors_.over_turn(point_, step.torque)) {
        least = std::min(least, product(K, direction_));
        most = std::max(most, product(K, direction_));
      }
      return (most + least) / 2 + turned * (most - least) / 2;
    }
    return product(factors_.at(point_, state_of(crack_, step, turned)), direction_);
  }

  /// K under the constant loads of a step, the three modes of each point of the front.
  [[nodiscard]] std::vector<double> constant(const DutyStep& step) const {
    std::vector<double> all;
    for (std::size_t point = 0; point < factors_.points(); ++point)
      for (const double of_mode : constant_at(point, step)) all.push_back(of_mode);
    return all;
  }

 private:
  [[nodiscard]] Modes constant_at(std::size_t point, const DutyStep& step) const {
    if (factors_.has_turn()) return mean(factors_.over_turn(point, step.torque));
    LoadState state = state_of(crack_, step, 1);
    state.assembly = state.bending_moment = 0.0;
    return factors_.at(point, state);
  }
  static double product(const Modes& a, const Modes& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  /// Square of K, of which pressed faces have no mode I.
  static double open_part(Modes K) {
    K[0] = std::max(K[0], 0.0);
    return product(K, K);
  }
  static Modes mean(const std::vector<Modes>& turn) {
    Modes sum{};
    for (const Modes& K : turn)
      for (std::size_t mode = 0; mode < sum.size(); ++mode)
        sum[mode] += K[mode] / static_cast<double>(turn.size());
    return sum;
  }
  static Modes difference(const Modes& a, const Modes& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  const DriveCrack& crack_;
  CrackFactors factors_;
  Modes direction_{};
  std::size_t point_ = 0;
};

/// The loads at a share of the way from one step to another.
DutyStep between(const DutyStep& from, const DutyStep& to, double share) {
  DutyStep step = from;
  const auto mix = [&](double DutyStep::*load) { step.*load += share * (to.*load - from.*load); };
  mix(&DutyStep::torque);
  mix(&DutyStep::axial_force);
  mix(&DutyStep::bending_moment);
  return step;
}

/// A step that the counting passes over, and the loads of the line that it leaves.
struct Departure {
  std::size_t step = 0;
  DutyStep line;
};

/// The steps between two reversals whose K leaves the line between the two (GR-21), the farthest
/// one first; the lines from this one to the reversals stand for the other steps.
/// @param reversals  steps at which the counted value turns, by rising number
std::vector<Departure> departures(const CountedValue& value, const std::vector<DutyStep>& steps,
                                  const std::vector<std::size_t>& reversals) {
  constexpr double kRounding = 1e-9;
  // Under one axial force, K lies on a line.
  if (std::ranges::adjacent_find(steps, std::ranges::not_equal_to(), &DutyStep::axial_force) ==
          steps.end() ||
      reversals.empty())
    return {};
  std::vector<std::vector<double>> K;
  for (const DutyStep& step : steps) K.push_back(value.constant(step));
  std::vector<std::pair<std::size_t, std::size_t>> open;
  for (std::size_t i = 0; i + 1 < reversals.size(); ++i)
    open.emplace_back(reversals[i], reversals[i + 1]);
  open.emplace_back(reversals.back(), reversals.front() + steps.size());
  std::vector<Departure> found;
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    const std::size_t first = begin % steps.size();
    const std::size_t last = end % steps.size();
    const auto along = [&](std::size_t i) { return K[last][i] - K[first][i]; };
    double length = 0.0;  // squares of distances
    for (std::size_t i = 0; i < K[first].size(); ++i) length += along(i) * along(i);
    double farthest = 0.0;
    double share_there = 0.0;
    std::size_t there = begin;
    for (std::size_t step = begin + 1; step < end; ++step) {
      const std::vector<double>& here = K[step % steps.size()];
      double share = 0.0;
      double size = 0.0;
      for (std::size_t i = 0; i < here.size(); ++i) {
        share += (here[i] - K[first][i]) * along(i);
        size += here[i] * here[i];
      }
      share = length > 0 ? std::clamp(share / length, 0.0, 1.0) : 0.0;
      double distance = 0.0;
      for (std::size_t i = 0; i < here.size(); ++i) {
        const double off = here[i] - K[first][i] - share * along(i);
        distance += off * off;
      }
      if (distance <= std::max(farthest, kRounding * kRounding * (length + size))) continue;
      farthest = distance;
      share_there = share;
      there = step;
    }
    if (there == begin) continue;
    found.push_back(
        {.step = there % steps.size(), .line = between(steps[first], steps[last], share_there)});
    open.emplace_back(begin, there);
    open.emplace_back(there, end);
  }
  return found;
}

bool turns(const DriveCrack& crack, const DutyStep& step) {
  if (crack.turning == TurningLoad::none || step.output_speed == 0) return false;
  if (crack.turning == TurningLoad::bending) return step.bending_moment != 0;
  return crack.turning != TurningLoad::balls || step.torque != 0;
}

/// Cycles of the load that turns, in a turn of the output.
double turning_cycles(const GearSet& gear, const DriveCrack& crack) {
  const auto at = [&](DutyPlace place) {
    const std::optional<double> cycles = cycles_per_output_turn(gear, place);
    if (!cycles)
      throw InputError("wave_generator.bearing.ball_count",
                       "must be given: the balls that pass a crack of the race count");
    return *cycles;
  };
  switch (crack.turning) {
    case TurningLoad::wave:
      return at(DutyPlace::flexspline);
    case TurningLoad::wave_at_spline:
      return at(DutyPlace::circular_spline);  // (GR-39)
    case TurningLoad::bending:
      return at(DutyPlace::output_shaft);
    case TurningLoad::balls:
      return at(DutyPlace::inner_ring);
    case TurningLoad::none:
      break;
  }
  return 0.0;
}

}  // namespace

double CrackDuty::cycles() const {
  double sum = 0.0;
  for (const LoadCycle& of : cycle)
    if (!of.within_wave) sum += of.count;
  return sum;
}

CrackDuty crack_duty(const GearSet& gear, const DriveCrack& crack, const DutyHistory& history,
                     const CracksAtTorques& at_torque) {
  CrackDuty duty{.duration = history.duration, .cycle = {}};
  const double per_turn = turning_cycles(gear, crack);
  const auto turned_in = [&](const DutyStep& step) {
    if (!turns(crack, step)) return 0.0;
    return std::abs(step.output_speed) * step.duration / (2 * std::numbers::pi) * per_turn;
  };
  std::vector<double> left;            // turning cycles of each step that no other cycle uses
  std::vector<double> values;          // the extremes of each step
  std::vector<std::size_t> step_of;    // the step of each value
  std::vector<std::size_t> reversals;  // steps at which the constant load turns
  // Steps that follow on each other with the same load are one step.
  std::vector<DutyStep> steps;
  std::vector<std::size_t> number;  // of the step in the duty
  for (std::size_t b = 0; b < history.steps.size(); ++b) {
    const DutyStep& step = history.steps[b];
    const bool same = !steps.empty() && step.torque == steps.back().torque &&
                      step.axial_force == steps.back().axial_force &&
                      step.bending_moment == steps.back().bending_moment;
    if (same) {
      left.back() += turned_in(step);
      continue;
    }
    steps.push_back(step);
    number.push_back(b);
    left.push_back(turned_in(step));
  }
  const CountedValue value(crack, at_torque, steps);
  const std::vector<double> turned = left;
  std::vector<bool> joined(steps.size(), false);
  for (std::size_t b = 0; b < steps.size(); ++b) {
    const double here = value.of(steps[b], 0);
    const double one = value.of(steps[b], 1);
    const double other = value.of(steps[b], -1);
    const bool rose = here > value.of(steps[(b + steps.size() - 1) % steps.size()], 0);
    const bool rises = value.of(steps[(b + 1) % steps.size()], 0) > here;
    // The load changes from a valley to a peak or the other way, never against the wave.
    const double first = rose ? std::max(one, other) : std::min(one, other);
    const double second = rose ? std::min(one, other) : std::max(one, other);
    values.insert(values.end(), {first, second});
    if (rose != rises) {
      values.push_back(first);
      reversals.push_back(b);
    }
    step_of.resize(values.size(), b);
  }
  // (GR-21): the cycles between steps.
  const auto join = [&](std::size_t high, std::size_t low, double count) {
    if (high == low) return;
    const auto extreme = [&](const DutyStep& step, double sign) {
      const bool turned_up = value.of(step, 1) >= value.of(step, -1);
      return state_of(crack, step, turned_up ? sign : -sign);
    };
    duty.cycle.push_back({.from = extreme(steps[high], 1),
                          .to = extreme(steps[low], -1),
                          .count = count,
                          .step = number[high],
                          .rare = false});
    for (const std::size_t used : {high, low}) {
      left[used] = std::max(0.0, left[used] - count / 2);
      joined[used] = true;
    }
  };
  RainflowCounter counter;
  const auto take = [&](const CountedCycle& counted) {
    const bool down = counted.from.value > counted.to.value;
    join(step_of[(down ? counted.from : counted.to).place],
         step_of[(down ? counted.to : counted.from).place], counted.count);
  };
  counter.add(values, take);
  counter.finish(history.residue, take);
  // ... and those of steps that leave the line between the reversals.
  for (const Departure& from : departures(value, steps, reversals)) {
    if (joined[from.step]) continue;
    duty.cycle.push_back({.from = state_of(crack, steps[from.step], 1),
                          .to = state_of(crack, from.line, -1),
                          .count = 1,
                          .step = number[from.step],
                          .rare = false});
    left[from.step] = std::max(0.0, left[from.step] - 0.5);
  }
  // ... and the cycles of the load that turns.
  for (std::size_t b = 0; b < steps.size(); ++b)
    if (left[b] > 0)
      duty.cycle.push_back({.from = state_of(crack, steps[b], 1),
                            .to = state_of(crack, steps[b], -1),
                            .count = left[b],
                            .step = number[b],
                            .rare = false});
  // ... and those within a wave (GR-31).
  const auto add_within = [&](const DutyStep& step, double count, std::size_t number_of_step,
                              bool of_peak) {
    if (crack.turn_table && count > 0)
      duty.cycle.push_back({.from = state_of(crack, step, 1),
                            .to = state_of(crack, step, -1),
                            .count = count,
                            .step = number_of_step,
                            .rare = of_peak,
                            .further = of_peak,
                            .within_wave = true});
  };
  for (std::size_t b = 0; b < steps.size(); ++b) add_within(steps[b], turned[b], number[b], false);
  std::ranges::stable_sort(duty.cycle, {}, &LoadCycle::step);
  // Momentary peaks follow at the end of the repetition.
  for (const DutyMomentaryPeak& peak : history.peaks) {
    const std::size_t step = history.steps.size();
    if (crack.turn_table) require_covered(crack, peak.step);
    const auto farthest = std::ranges::max_element(
        values, {},
        [here = value.of(peak.step, 1)](double there) { return std::abs(there - here); });
    duty.cycle.push_back(
        {.from = state_of(crack, peak.step, 1),
         .to = state_of(crack, steps[step_of[static_cast<std::size_t>(farthest - values.begin())]],
                        -1),
         .count = peak.per_repetition,
         .step = step,
         .rare = true});
    if (const double more = turned_in(peak.step) - 1; more > 0)
      duty.cycle.push_back({.from = state_of(crack, peak.step, 1),
                            .to = state_of(crack, peak.step, -1),
                            .count = peak.per_repetition * more,
                            .step = step,
                            .rare = true,
                            .further = true});
    add_within(peak.step, peak.per_repetition * turned_in(peak.step), step, true);
    duty.peaks += peak.per_repetition;
  }
  return duty;
}

std::vector<double> torques_of(const DutyHistory& history, bool sizes_only) {
  constexpr std::size_t kMost = 33;
  std::vector<double> torques;
  const auto take = [&](const DutyStep& step) {
    torques.push_back(sizes_only ? std::abs(step.torque) : step.torque);
  };
  for (const DutyStep& step : history.steps) take(step);
  for (const DutyMomentaryPeak& peak : history.peaks) take(peak.step);
  std::sort(torques.begin(), torques.end());
  torques.erase(std::unique(torques.begin(), torques.end()), torques.end());
  if (torques.size() <= kMost) return torques;
  const double spacing = (torques.back() - torques.front()) / (kMost - 1);
  std::vector<double> even;
  for (std::size_t i = 0; i < kMost; ++i)
    even.push_back(torques.front() + spacing * static_cast<double>(i));
  return even;
}

}  // namespace strainwave
