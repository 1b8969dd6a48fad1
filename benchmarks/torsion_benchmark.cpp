// SPDX-License-Identifier: Apache-2.0 Cost of a torsion curve on one core: setup, assembly, and
// loading point by point.
#include <benchmark/benchmark.h>

#include <vector>

#include "strainwave/io/gear_reader.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

/// Size 25, ratio 100, drawn teeth and a rigid circular spline as in the peer.
GearSet drive() {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
  gear.circular_spline->support = 0.0;
  gear.range.clear();
  gear.rating.reset();
  return gear;
}

void torsion_curve_points(benchmark::State& state) {
  const GearSet gear = drive();
  const auto points = state.range(0);
  std::vector<double> torques;
  for (int i = 1; i <= points; ++i)
    torques.push_back(makers_torques(gear).T3 * i / static_cast<double>(points));
  double twist = 0.0;
  for (auto _ : state) {
    twist = torsion_curve(gear, torques).points.back().twist;
    benchmark::ClobberMemory();
  }
  state.counters["twist"] = twist;
}
BENCHMARK(torsion_curve_points)->Arg(11)->Arg(200)->Unit(benchmark::kMillisecond);

/// With the circular spline in its housing, as in the file.
void torsion_curve_with_spline(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
  std::vector<double> torques;
  for (int i = 1; i <= 11; ++i) torques.push_back(makers_torques(gear).T3 * i / 11.0);
  for (auto _ : state) benchmark::DoNotOptimize(torsion_curve(gear, torques).points.back().twist);
}
BENCHMARK(torsion_curve_with_spline)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strainwave
