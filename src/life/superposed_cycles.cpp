// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/superposed_cycles.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/growth/rainflow.hpp"

namespace strainwave {
namespace {

void check_step(const OscillatingStep& step, std::size_t i) {
  const auto field = [&](const char* name) { return fmt::format("steps[{}].{}", i, name); };
  require(std::isfinite(step.mean), field("mean"), step.mean, "", "a finite number");
  require(std::isfinite(step.amplitude), field("amplitude"), step.amplitude, "", "a finite number");
  require(std::isfinite(step.cycles) && step.cycles >= 0, field("cycles"), step.cycles, "1",
          ">= 0");
}

/// The value at a phase.  Whole and half phases are exact.
double value_at(const OscillatingStep& step, double phase) {
  if (phase == 0) return step.mean + step.amplitude;
  if (phase == 0.5) return step.mean - step.amplitude;
  return step.mean + step.amplitude * std::cos(2 * std::numbers::pi * phase);
}

}  // namespace

std::vector<StepCycle> superposed_cycles(std::span<const OscillatingStep> steps, Residue residue) {
  std::vector<StepCycle> cycles;
  superposed_cycles(steps, residue, [&](const StepCycle& cycle) { cycles.push_back(cycle); });
  return cycles;
}

void superposed_cycles(std::span<const OscillatingStep> steps, Residue residue,
                       const std::function<void(const StepCycle&)>& to) {
  std::vector<std::size_t> step_of;  // of each value that the counter took
  const auto sink = [&](const CountedCycle& cycle) {
    to({.from = cycle.from.value,
        .to = cycle.to.value,
        .count = cycle.count,
        .from_step = step_of[cycle.from.place],
        .to_step = step_of[cycle.to.place]});
  };
  RainflowCounter counter;
  double phase = 0.0;  // 0 <= phase < 1
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const OscillatingStep& step = steps[i];
    check_step(step, i);
    std::array<double, 5> values;
    std::size_t number = 0;
    values[number++] = value_at(step, phase);
    const double end = phase + step.cycles;
    // Extremes stand at whole and half phases behind the beginning and before the end.
    const double first = std::floor(2 * phase) + 1;
    const double extremes = std::max(0.0, std::ceil(2 * end) - first);
    // Pairs of extremes that follow on equal ones close cycles of their own, whatever surrounds
    // them, as long as one pair and the direction to the next step stay.
    const double shown = extremes <= 3 ? extremes : 2 + std::fmod(extremes, 2);
    const double pairs = (extremes - shown) / 2;  // (LI-20)
    for (double k = 0; k < shown; ++k)
      values[number++] = value_at(step, std::fmod(first + k, 2) / 2);
    phase = end - std::floor(end);
    if (step.cycles > 0) values[number++] = value_at(step, phase);
    step_of.insert(step_of.end(), number, i);
    counter.add(std::span(values).first(number), sink);
    if (pairs > 0 && step.amplitude != 0)
      to({.from = values[1], .to = values[2], .count = pairs, .from_step = i, .to_step = i});
  }
  counter.finish(residue, sink);
}

}  // namespace strainwave
