// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/load_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/growth/rainflow.hpp"
#include "strainwave/life/duty.hpp"

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

}  // namespace

double CrackDuty::cycles() const {
  double sum = 0.0;
  for (const LoadCycle& of : cycle) sum += of.count;
  return sum;
}

std::vector<DutyStep> duty_steps(const GearSet& gear) {
  if (!gear.duty)
    throw InputError("duty", "must be given: the growth of a crack needs a duty of the drive");
  std::vector<DutyStep> steps;
  for (const DutyBlock& block : gear.duty->block)
    steps.push_back({.duration = block.duration * block.repetitions,
                     .output_speed = output_speed(block, gear.drive.ratio, gear.duty->fixed),
                     .torque = block.torque,
                     .axial_force = block.axial_force,
                     .bending_moment = block.bending_moment});
  return steps;
}

double turning_cycles(const GearSet& gear, const DriveCrack& crack) {
  const double i = gear.drive.ratio;
  const bool flexspline_turns = gear.duty->fixed == FixedMember::circular_spline;
  const double relative = flexspline_turns ? 1 + 1 / i : 1.0;  // wave over flexspline
  switch (crack.turning) {
    case TurningLoad::wave:
      return gear.drive.wave_number * relative;
    case TurningLoad::bending:
      return 1 / input_turns(i, gear.duty->fixed);
    case TurningLoad::balls: {
      const auto& bearing = gear.wave_generator->bearing;
      if (!bearing || !bearing->ball_count)
        throw InputError("wave_generator.bearing.ball_count",
                         "must be given: the balls that pass a crack of the race count");
      const double pitch = (bearing->inner_raceway_diameter + bearing->outer_raceway_diameter) / 2;
      return *bearing->ball_count / 2.0 * (1 + bearing->ball_diameter / pitch) * relative;
    }
    case TurningLoad::none:
      break;
  }
  return 0.0;
}

CrackDuty crack_duty(const GearSet& gear, const DriveCrack& crack,
                     const std::vector<DutyStep>& steps) {
  CrackDuty duty;
  const double input_per_output = input_turns(gear.drive.ratio, gear.duty->fixed);
  const double per_input_turn = turning_cycles(gear, crack);
  const auto turned_in = [&](const DutyStep& step) {
    if (!turns(crack, step)) return 0.0;
    return std::abs(step.output_speed) * step.duration / (2 * std::numbers::pi) * input_per_output *
           per_input_turn;
  };
  const SteadyValue value(crack);
  std::vector<double> left;  // turning cycles of each step that no other cycle uses
  std::vector<double> history;
  for (const DutyStep& step : steps) {
    duty.duration += step.duration;
    left.push_back(turned_in(step));
    history.push_back(value.of(step));
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
  counter.add(history, take);
  counter.finish(gear.duty->residue, take);
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
  for (const DutyPeak& peak : gear.duty->peak) {
    const double count = duty.duration / peak.interval;
    const DutyStep at{.duration = peak.duration,
                      .output_speed = output_speed(peak, gear.drive.ratio, gear.duty->fixed),
                      .torque = peak.torque};
    const std::size_t step = steps.size();
    const auto farthest = std::ranges::max_element(
        history, {}, [&, here = value.of(at)](double there) { return std::abs(there - here); });
    if (farthest != history.end())
      duty.cycle.push_back(
          {.from = state_of(crack, at, 1),
           .to = state_of(crack, steps[static_cast<std::size_t>(farthest - history.begin())], -1),
           .count = count,
           .step = step,
           .rare = true});
    if (const double turned = turned_in(at) - 1; turned > 0)
      duty.cycle.push_back({.from = state_of(crack, at, 1),
                            .to = state_of(crack, at, -1),
                            .count = count * turned,
                            .step = step,
                            .rare = true});
    duty.peaks += count;
  }
  return duty;
}

}  // namespace strainwave
