// SPDX-License-Identifier: Apache-2.0
// Crack growth: a life by quadrature, a cycle of growth, and a thousand million cycles.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "cracked_wall.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/growth/constant_amplitude.hpp"
#include "strainwave/life/load_history.hpp"
#include "strainwave/materials/library_law.hpp"
#include "strainwave/materials/material_library.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Paris, C 6.9e-12, m 3, K = 1.12 * 200 MPa sqrt(pi a), 1 to 10 mm, to 1e-9.
void growth_life(benchmark::State& state) {
  double cycles = 0.0;
  for (auto _ : state) {
    cycles = grow_at_constant_amplitude(
                 Paris{6.9e-12, 3},
                 [](double a) { return TipCycle{.largest = 1.12 * 200e6 * std::sqrt(pi * a)}; },
                 1e-3, 1e-2, {}, 1e-9)
                 .cycles.value();
    benchmark::DoNotOptimize(cycles);
  }
  state.counters["error"] = cycles / 100143.6698064 - 1;
}

/// One rate of NASGRO, prepared once.
void growth_nasgro(benchmark::State& state) {
  const PreparedLaw law(rate_law(require_material("15-5PH H900")));
  double K = 20e6;
  for (auto _ : state) {
    const GrowthRate rate = growth_rate(law, {.largest = K, .ratio = 0.3}, 1e-3);
    benchmark::DoNotOptimize(rate);
    K = K < 40e6 ? K * 1.0001 : 20e6;
  }
}

GearSet wall() {
  return cracked_wall(R"([material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
yield_strength = "1172 MPa"
)",
                      "steel", "0.4 mm", "0.7 mm");
}

Interaction willenborg() { return {.rule = InteractionRule::willenborg, .zone_factor = 2.0}; }

/// A repetition of 2000 different cycles: K at both tips of a semi-ellipse, then NASGRO with
/// Willenborg cycle by cycle.
void growth_cycle(benchmark::State& state) {
  GearSet gear = wall();
  gear.duty->block.clear();
  gear.duty->peak.clear();
  std::mt19937_64 generator(1);
  for (int i = 0; i < 2000; ++i) {
    const double share = static_cast<double>(generator() >> 11) * 0x1p-53;
    // Less than half a wave a step: the changes of the torque are the cycles.
    gear.duty->block.push_back(
        {.duration = 1e-3, .output_speed = 1e-3, .torque = (i % 2 == 0 ? 9000 : -9000) * share});
  }
  const GrowingCrack crack(gear, drive_cracks(gear).front(), duty_history(gear),
                           {.mixed_mode = MixedMode::energy, .law = "15-5PH H900"});
  const CrackSize size = CrackSize::of(0.8e-3, 1.2e-3);
  double grown = 0.0;
  for (auto _ : state) {
    for (const auto& at_tip : crack.loads(size))
      grown += growth_with_interaction(crack, at_tip, size.size, willenborg(), 0.01);
    benchmark::DoNotOptimize(grown);
  }
  const auto cycles = static_cast<double>(crack.duty().cycle.size());
  state.counters["cycles"] = cycles;
  const auto inverted = benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert;
  state.counters["per_cycle"] = benchmark::Counter(cycles, inverted);
  state.counters["per_tip"] = benchmark::Counter(2 * cycles, inverted);
}

/// A thousand million cycles of a duty with momentary peaks and Willenborg.
void growth_of_1e9_cycles(benchmark::State& state) {
  GearSet gear = wall();
  gear.material.at("steel").growth = {Walker{1e-14, 3, 0.5}};
  GrowthOptions options;
  options.interaction = willenborg();
  options.stop.cycles = 1e9;
  GrowthReport report;
  for (auto _ : state) report = grow_cracks(gear, options);
  const CrackGrowth& crack = report.cracks.at(0);
  state.counters["cycles"] = crack.series.back().cycles;
  state.counters["grown"] = crack.series.back().size / crack.series.front().size - 1;
  state.counters["step_error"] = report.step_error;
}

BENCHMARK(growth_life);
BENCHMARK(growth_nasgro);
BENCHMARK(growth_cycle)->Unit(benchmark::kMicrosecond);
BENCHMARK(growth_of_1e9_cycles)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strainwave
