// SPDX-License-Identifier: Apache-2.0 Cost of all derivatives of one drive, and scaling of a Monte
// Carlo study over threads.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"
#include "strainwave/study/scatter.hpp"
#include "strainwave/study/sensitivity.hpp"
#include "strainwave/study/varied_series.hpp"

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

/// One draw with three numbers, rules of the input included, by tables that are filled.
void draw_of_three_cracks(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  const std::vector<std::string> paths = {"output_shaft.crack[0].depth",
                                          "flexspline.crack[0].half_length",
                                          "wave_generator.radial_stiffness"};
  const std::vector<double> centres = {1e-4, 1e-4, 1.2e8};
  const auto fill = [&](std::size_t row, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = centres[i] * (1 + 0.05 * counter_normal(1, row, i));
  };
  VariedSeries varied(gear, paths, {"cracked.positive.stiffness"});
  varied.prepare(1'000'000, fill);
  VariedSeries::Evaluator evaluate(varied);
  std::vector<double> values(paths.size());
  double stiffness = 0.0;
  for (std::size_t row = 0; row < 10'000; ++row) {
    fill(row, values);
    (void)evaluate(values, {&stiffness, 1});
  }
  std::size_t row = 0;
  for (auto _ : state) {
    fill(row++ % 10'000, values);
    benchmark::DoNotOptimize(evaluate(values, {&stiffness, 1}));
  }
  (void)evaluate(centres, {&stiffness, 1});
  state.counters["stiffness"] = stiffness;
}
BENCHMARK(draw_of_three_cracks)->Unit(benchmark::kMicrosecond);

/// A million draws of eight numbers over 1 and 2 threads, wall clock.
void scatter_of_a_million(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article_scatter.toml");
  const Sensitivity sensitivity = sensitivity_of(gear);
  const ScatterOptions options{.samples = 1'000'000, .threads = static_cast<int>(state.range(0))};
  for (auto _ : state)
    benchmark::DoNotOptimize(scatter_of(gear, sensitivity, options).outputs.size());
}
BENCHMARK(scatter_of_a_million)->Arg(1)->Arg(2)->Unit(benchmark::kSecond)->UseRealTime();

/// As a study grows: 10^3 to 10^7 draws on one thread.  The time is linear in the draws if the
/// slope of its logarithm over theirs is 1.
void scatter_of_draws(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article_scatter.toml");
  const Sensitivity sensitivity = sensitivity_of(gear);
  const ScatterOptions options{.samples = static_cast<int>(state.range(0)), .threads = 1};
  for (auto _ : state)
    benchmark::DoNotOptimize(scatter_of(gear, sensitivity, options).outputs.size());
}
BENCHMARK(scatter_of_draws)
    ->RangeMultiplier(10)
    ->Range(1'000, 10'000'000)
    ->Unit(benchmark::kMillisecond);

/// As a drive has more cracks: 1 to 10^4 through cracks of the flexspline, no two of one length.
void compliance_of_cracks(benchmark::State& state) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  const auto crack = gear.flexspline->crack.front();
  gear.flexspline->crack.clear();
  for (std::int64_t n = 0; n < state.range(0); ++n) {
    gear.flexspline->crack.push_back(crack);
    std::get<WallThroughCrack>(gear.flexspline->crack.back()).half_length *=
        1 + 1e-5 * static_cast<double>(n);
  }
  for (auto _ : state) benchmark::DoNotOptimize(series_compliance<double>(gear).positive);
}
BENCHMARK(compliance_of_cracks)
    ->RangeMultiplier(10)
    ->Range(1, 10'000)
    ->Unit(benchmark::kMicrosecond);

/// The limit of a draw: as many multiplications and additions as `draw_of_three_cracks` has
/// instructions (benchmarks/instructions.csv), in chains that do not wait for each other.
void multiply_adds_of_a_draw(benchmark::State& state) {
  constexpr int kPairs = 6534 / 2;
  constexpr int kChains = 16;  // fills two pipelines of latency 4 with vectors of 2
  std::array<double, kChains> sum{};
  double factor = 1.0 - 1e-9;
  benchmark::DoNotOptimize(factor);
  for (auto _ : state) {
    for (int n = 0; n < kPairs / kChains; ++n)
      for (double& s : sum) s = s * factor + 1e-9;
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(multiply_adds_of_a_draw)->Unit(benchmark::kMicrosecond);

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
