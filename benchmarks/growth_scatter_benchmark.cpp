// SPDX-License-Identifier: Apache-2.0
// Scatter of crack growth: the likelihood of 44 records of 163 steps, and its maximum.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/growth_scatter/fit.hpp"

namespace strainwave {
namespace {

/// Records about a law of Paris, with a level of each specimen and a deviation of each step.
std::vector<GrowthSpecimen> records() {
  constexpr std::uint64_t kSpecimens = 44;
  constexpr std::size_t kSizes = 164;
  const PlateTest test{.stress_range = 48e6, .width = 0.1524};
  std::vector<GrowthSpecimen> specimens;
  for (std::uint64_t s = 0; s < kSpecimens; ++s) {
    std::vector<double> sizes = {9e-3};
    std::vector<double> cycles = {0.0};
    const double level = 0.08 * counter_normal(1, s, 0);
    for (std::uint64_t i = 1; i < kSizes; ++i) {
      sizes.push_back(sizes.back() + 0.25e-3);
      const double range = plate_range(test, sizes.back() - 0.125e-3) / 1e6;
      const double deviation = level + 0.2 * counter_normal(1, s, i);
      cycles.push_back(cycles.back() +
                       0.25e-3 / (9e-11 * std::pow(range, 2.9) * std::exp(deviation)));
    }
    specimens.push_back(specimen_of(std::to_string(s), sizes, cycles, test));
  }
  return specimens;
}

void growth_likelihood(benchmark::State& state) {
  const GrowthData data(records());
  const MeanGrowth mean{
      .knots = {data.lowest(), data.highest()}, .rates = {}, .pivot = data.lowest()};
  const ScatterParameters parameters{0.08, 0.1, 0.05, 0.15, -2.7, 0.07};
  for (auto _ : state) benchmark::DoNotOptimize(data.likelihood(mean, parameters).value);
}
BENCHMARK(growth_likelihood)->Unit(benchmark::kMillisecond);

void growth_fit(benchmark::State& state) {
  const std::vector<GrowthSpecimen> specimens = records();
  for (auto _ : state) benchmark::DoNotOptimize(fit_growth(specimens).log_likelihood);
}
BENCHMARK(growth_fit)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strainwave
