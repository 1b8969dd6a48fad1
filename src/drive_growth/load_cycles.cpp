// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/load_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "strainwave/core/error.hpp"
#include "strainwave/growth/rainflow.hpp"

namespace strainwave {
namespace {

/// One value of the constant load of a step, for counting: the mode of the torque that is largest.
class SteadyValue {
 public:
  explicit SteadyValue(const DriveCrack& crack) {
    const std::vector<FrontIntensity> front = crack.front(crack.size, Faces::open);
    double largest = 0.0;
    for (const FrontIntensity& at : front)
      for (const auto mode : {&UnitStressIntensity<2>::I, &UnitStressIntensity<2>::II,
                              &UnitStressIntensity<2>::III}) {
        const double size = std::abs((at.load.*mode)[kTorsion]);
        if (size <= largest) continue;
        largest = size;
        axial_ = (at.load.*mode)[kAxial];
        torsion_ = (at.load.*mode)[kTorsion];
      }
    reverses_ = crack.reverses;
  }
  [[nodiscard]] double of(const DutyStep& step) const {
    const double T = reverses_ ? step.torque : std::abs(step.torque);
    return axial_ * step.axial_force + torsion_ * T;
  }

 private:
  double axial_ = 0.0;
  double torsion_ = 1.0;
  bool reverses_ = true;
};

LoadState state_of(const DriveCrack& crack, const DutyStep& step, double turned) {
  LoadState state{.torque = step.torque, .axial_force = step.axial_force};
  switch (crack.turning) {
    case TurningLoad::wave:
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

bool turns(const DriveCrack& crack, const DutyStep& step) {
  if (crack.turning == TurningLoad::none || step.output_speed == 0) return false;
  if (crack.turning == TurningLoad::bending) return step.bending_moment != 0;
  return crack.turning == TurningLoad::wave || step.torque != 0;
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
  for (const LoadCycle& of : cycle) sum += of.count;
  return sum;
}

CrackDuty crack_duty(const GearSet& gear, const DriveCrack& crack, const DutyHistory& history) {
  CrackDuty duty{.duration = history.duration, .cycle = {}};
  const double per_turn = turning_cycles(gear, crack);
  const auto turned_in = [&](const DutyStep& step) {
    if (!turns(crack, step)) return 0.0;
    return std::abs(step.output_speed) * step.duration / (2 * std::numbers::pi) * per_turn;
  };
  const SteadyValue value(crack);
  std::vector<double> left;  // turning cycles of each step that no other cycle uses
  std::vector<double> values;
  const std::vector<DutyStep>& steps = history.steps;
  for (const DutyStep& step : steps) {
    left.push_back(turned_in(step));
    values.push_back(value.of(step));
  }
  // (GR-21): the cycles between steps.
  const auto join = [&](std::size_t high, std::size_t low, double count) {
    if (high == low) return;
    duty.cycle.push_back({.from = state_of(crack, steps[high], 1),
                          .to = state_of(crack, steps[low], -1),
                          .count = count,
                          .step = high,
                          .rare = false});
    for (const std::size_t used : {high, low}) left[used] = std::max(0.0, left[used] - count / 2);
  };
  RainflowCounter counter;
  const auto take = [&](const CountedCycle& counted) {
    const bool down = counted.from.value > counted.to.value;
    join((down ? counted.from : counted.to).place, (down ? counted.to : counted.from).place,
         counted.count);
  };
  counter.add(values, take);
  counter.finish(history.residue, take);
  // ... and the cycles of the load that turns.
  for (std::size_t b = 0; b < steps.size(); ++b)
    if (left[b] > 0)
      duty.cycle.push_back({.from = state_of(crack, steps[b], 1),
                            .to = state_of(crack, steps[b], -1),
                            .count = left[b],
                            .step = b,
                            .rare = false});
  std::ranges::stable_sort(duty.cycle, {}, &LoadCycle::step);
  // Momentary peaks follow at the end of the repetition.
  for (const DutyMomentaryPeak& peak : history.peaks) {
    const std::size_t step = steps.size();
    const auto farthest = std::ranges::max_element(
        values, {}, [here = value.of(peak.step)](double there) { return std::abs(there - here); });
    duty.cycle.push_back(
        {.from = state_of(crack, peak.step, 1),
         .to = state_of(crack, steps[static_cast<std::size_t>(farthest - values.begin())], -1),
         .count = peak.per_repetition,
         .step = step,
         .rare = true});
    if (const double turned = turned_in(peak.step) - 1; turned > 0)
      duty.cycle.push_back({.from = state_of(crack, peak.step, 1),
                            .to = state_of(crack, peak.step, -1),
                            .count = peak.per_repetition * turned,
                            .step = step,
                            .rare = true});
    duty.peaks += peak.per_repetition;
  }
  return duty;
}

}  // namespace strainwave
