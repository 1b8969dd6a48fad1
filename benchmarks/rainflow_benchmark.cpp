// SPDX-License-Identifier: Apache-2.0
// Rainflow of ten million points beside a plain read of the same array.
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "strainwave/growth/rainflow.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kPoints = 10'000'000;

double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

/// White noise: two thirds of the points are reversals.
const std::vector<double>& noise() {
  static const std::vector<double> history = [] {
    std::mt19937_64 generator(1);
    std::vector<double> values(kPoints);
    for (double& value : values) value = uniform(generator);
    return values;
  }();
  return history;
}

/// Straight lines of 20 points between random peaks and random valleys.
const std::vector<double>& twenty_points_a_reversal() {
  static const std::vector<double> history = [] {
    constexpr std::size_t kLine = 20;
    std::mt19937_64 generator(2);
    std::vector<double> values(kPoints);
    double from = 0.0;
    for (std::size_t i = 0; i < kPoints; i += kLine) {
      const double to = uniform(generator) - (i / kLine % 2 == 0 ? 0.0 : 1.0);
      for (std::size_t j = 0; j < kLine; ++j)
        values[i + j] = from + (to - from) * static_cast<double>(j + 1) / kLine;
      from = to;
    }
    return values;
  }();
  return history;
}

using History = const std::vector<double>& (*)();

void per_point(benchmark::State& state) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kPoints));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * kPoints * sizeof(double)));
}

void rainflow(benchmark::State& state, History make) {
  const std::vector<double>& history = make();
  double ranges = 0.0;
  for (auto _ : state) {
    ranges = 0.0;
    const auto sink = [&](const CountedCycle& cycle) { ranges += cycle.count * cycle.range(); };
    RainflowCounter counter;
    counter.add(history, sink);
    counter.finish(Residue::repeated, sink);
    benchmark::DoNotOptimize(ranges);
  }
  per_point(state);
  state.counters["ranges"] = ranges;
}

/// The sum of the array: what reading costs.
void rainflow_plain_read(benchmark::State& state, History make) {
  const std::vector<double>& history = make();
  for (auto _ : state) {
    std::array<double, 8> sum = {};
    for (std::size_t i = 0; i + sum.size() <= history.size(); i += sum.size())
      for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += history[i + j];
    benchmark::DoNotOptimize(sum);
  }
  per_point(state);
}

BENCHMARK_CAPTURE(rainflow, noise, noise)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rainflow_plain_read, noise, noise)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rainflow, twenty, twenty_points_a_reversal)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rainflow_plain_read, twenty, twenty_points_a_reversal)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strainwave
