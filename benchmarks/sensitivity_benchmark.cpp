// SPDX-License-Identifier: Apache-2.0 Cost of all derivatives of one drive, and scaling of a Monte
// Carlo study over threads.
#include <benchmark/benchmark.h>

#include "strainwave/io/gear_reader.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/study/scatter.hpp"
#include "strainwave/study/sensitivity.hpp"

namespace strainwave {
namespace {

/// All elasticities of the three-crack drive, 38 inputs.  The goal is below 2 ms.
void sensitivity_of_three_cracks(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  for (auto _ : state) benchmark::DoNotOptimize(sensitivity_of(gear).outputs.size());
}
BENCHMARK(sensitivity_of_three_cracks)->Unit(benchmark::kMicrosecond);

/// Only the numbers of the drive, as in one draw of a Monte Carlo study without its checks.
void series_compliance_of_three_cracks(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  for (auto _ : state) benchmark::DoNotOptimize(series_compliance<double>(gear).positive);
}
BENCHMARK(series_compliance_of_three_cracks)->Unit(benchmark::kMicrosecond);

/// 100 000 full evaluations over 1 and 2 threads, wall clock.  The goal is a factor of 1.9 on two
/// cores.
void monte_carlo(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article_scatter.toml");
  const Sensitivity sensitivity = sensitivity_of(gear);
  const ScatterOptions options{.samples = 100'000, .threads = static_cast<int>(state.range(0))};
  for (auto _ : state)
    benchmark::DoNotOptimize(scatter_of(gear, sensitivity, options).outputs.size());
}
BENCHMARK(monte_carlo)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace strainwave
