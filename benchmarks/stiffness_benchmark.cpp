// SPDX-License-Identifier: Apache-2.0 Cost of one evaluation on one core.  `benchmarks/compare.py`
// runs this and a peer in numpy and scipy that computes the same numbers, and reports the ratio.
#include <benchmark/benchmark.h>

#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {
namespace {

const GearSet& article() {
  static const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  return gear;
}

/// The whole corrected result of the three-crack drive: check, members, integrals, notes.
void three_crack_drive(benchmark::State& state) {
  const GearSet& gear = article();
  double stiffness = 0.0;
  for (auto _ : state) {
    stiffness = torsional_stiffness(gear).positive.stiffness.value;
    benchmark::ClobberMemory();
  }
  state.counters["stiffness"] = stiffness;
}
BENCHMARK(three_crack_drive)->Unit(benchmark::kMicrosecond);

void surface_crack_integral(benchmark::State& state) {
  const sif::SurfaceCrack<1> crack(
      {.depth = 1e-4, .aspect_ratio = 0.52, .thickness = 0.01, .normal_stress = {1.0}});
  for (auto _ : state)
    benchmark::DoNotOptimize(added_compliance(crack, {.opening = 231e9, .shear = 80e9}));
}
BENCHMARK(surface_crack_integral)->Unit(benchmark::kMicrosecond);

void hollow_shaft_integral(benchmark::State& state) {
  for (auto _ : state) {
    const sif::AnnularCrackHollow crack(
        {.depth = 1e-4, .outer_radius = 0.035, .inner_radius = 0.0225});
    benchmark::DoNotOptimize(added_compliance(crack, {.opening = 231e9, .shear = 80e9}));
  }
}
BENCHMARK(hollow_shaft_integral)->Unit(benchmark::kMicrosecond);

void read_input_file(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml"));
}
BENCHMARK(read_input_file)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace strainwave
