// SPDX-License-Identifier: Apache-2.0
// Lives: of the example drive, of constant amplitude, and the plan of inspections from drawn lives.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "cracked_wall.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/drive_growth/life_trace.hpp"
#include "strainwave/growth/constant_amplitude.hpp"
#include "strainwave/inspection/inspected_risk.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/study/inspection_report.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Drawn lives of the example drive, with the draws of `strainwave inspect`.
void lives_of_the_shaft(benchmark::State& state) {
  constexpr int kDraws = 2000;
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/inspected_shaft.toml");
  InspectionOptions options;
  options.draws = kDraws;
  options.threads = static_cast<int>(state.range(0));
  double failed = 0.0;
  for (auto _ : state) failed = inspection_report(gear, options).outcomes.failed;
  state.counters["failed"] = failed;
  state.counters["lives"] = kDraws;
}

/// A life of a surface crack in a wall: depth and length, NASGRO, three blocks and a momentary
/// peak.
void life_of_a_wall(benchmark::State& state) {
  const GearSet gear = cracked_wall("", "15-5PH H900", "0.8 mm", "1.2 mm");
  double time = 0.0;
  for (auto _ : state) time = life_trace(gear).time;
  state.counters["hours"] = time / 3600;
}

/// 1e5 lives by Paris' law with a coefficient of their own, K = 1.12 * 200 MPa sqrt(pi a), from 1
/// to 10 mm, to 1e-6.
void lives_of_constant_amplitude(benchmark::State& state) {
  constexpr std::uint64_t kLives = 100'000;
  double sum = 0.0;
  for (auto _ : state) {
    sum = 0.0;
    for (std::uint64_t i = 0; i < kLives; ++i)
      sum += grow_at_constant_amplitude(
                 Paris{6.9e-12 * (1 + 1e-6 * static_cast<double>(i)), 3},
                 [](double a) { return TipCycle{.largest = 1.12 * 200e6 * std::sqrt(pi * a)}; },
                 1e-3, 1e-2, {}, 1e-6)
                 .cycles.value();
  }
  state.counters["mean"] = sum / kLives;
}

/// Both plans of inspections for a risk, from 500 kept lives of 30 steps, as `strainwave inspect`
/// makes them from its draws.
void inspection_plan(benchmark::State& state) {
  std::vector<DrawnPart> parts(500);
  for (std::uint64_t i = 0; i < parts.size(); ++i) {
    DrawnPart& part = parts[i];
    const double life = 3.6e6 * std::exp(0.4 * counter_normal(1, i, 0));
    part.failure = life;
    std::vector<double>& sizes = part.sizes.emplace_back();
    for (int k = 0; k <= 30; ++k) {
      part.times.push_back(life * (1 - std::pow(1 - k / 30.0, 2)));
      sizes.push_back(0.5e-3 * std::pow(16.0, k / 30.0));
    }
  }
  const CrackSearch search{.curve = DetectionCurve(DetectionForm::log_logistic, 1e-3, 2e-3),
                           .seen = {true},
                           .repaired_to = {}};
  std::size_t count = 0;
  for (auto _ : state) {
    const std::span<const DrawnPart> all(parts);
    const InspectionPlan equal = equal_plan(PartSample(all), 2.4e6, 1e-3, 10, search);
    const InspectionPlan least =
        least_plan(PartSample(all.first(all.size() / 2)), PartSample(all.last(all.size() / 2)),
                   2.4e6, 1e-3, 10, search);
    count = equal.times.size() + least.times.size();
  }
  state.counters["inspections"] = static_cast<double>(count);
}

BENCHMARK(lives_of_the_shaft)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kSecond);
BENCHMARK(life_of_a_wall)->Unit(benchmark::kMillisecond);
BENCHMARK(lives_of_constant_amplitude)->Unit(benchmark::kSecond);
BENCHMARK(inspection_plan)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace strainwave
