// SPDX-License-Identifier: Apache-2.0
// Groups of straight cracks in a sheet.
#include <benchmark/benchmark.h>

#include <complex>
#include <vector>

#include "strainwave/crack_group/straight_cracks.hpp"

namespace strainwave {
namespace {

/// Cracks of half length 1 in rows of ten, 3 apart, each turned by 0.1 rad more than the one
/// before.
std::vector<StraightCrack> cracks_of(int count) {
  std::vector<StraightCrack> cracks;
  for (int i = 0; i < count; ++i)
    cracks.push_back({{3.0 * (i % 10), 3.0 * (i / 10)}, 1.0, 0.1 * i});
  return cracks;
}

/// K at all tips of a group under equal tension, with 40 points on each crack.
void crack_groups(benchmark::State& state) {
  const std::vector<StraightCrack> cracks = cracks_of(static_cast<int>(state.range(0)));
  double K = 0.0;
  for (auto _ : state)
    K = crack_group(cracks, {.xx = 1, .yy = 1}, {.order = 40}).cracks[0].ahead.mode_1;
  state.counters["K"] = K;
}

/// A row of cracks under 45 degrees, which costs one crack.
void crack_of_a_row(benchmark::State& state) {
  const std::vector<StraightCrack> one = {{{0.0, 0.0}, 1.0, 0.785}};
  double K = 0.0;
  for (auto _ : state)
    K = crack_group(one, {.yy = 1}, {.order = 40, .period = 3.0}).cracks[0].ahead.mode_1;
  state.counters["K"] = K;
}

BENCHMARK(crack_groups)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(crack_groups)->Arg(100)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(crack_of_a_row)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strainwave
