// SPDX-License-Identifier: Apache-2.0
// K over a turn of the wave generator without finite elements: 36 angles, under the given number of
// torques; and the stress of the sound flexspline.
#include <benchmark/benchmark.h>

#include "strainwave/drive_turn/drive_oval.hpp"
#include "strainwave/drive_turn/drive_turn.hpp"
#include "strainwave/io/gear_reader.hpp"

namespace strainwave {
namespace {

void drive_turn_of_through_crack(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_crack.toml");
  TurnRequest asked{.torques = {48, 0, -48}};
  asked.torques.resize(static_cast<std::size_t>(state.range(0)));
  (void)drive_turn(gear);  // reads the table
  double K = 0;
  for (auto _ : state) {
    const DriveTurn turn = drive_turn(gear, asked);
    K = turn.range();
    benchmark::DoNotOptimize(&K);
  }
  state.counters["range"] = K;
}
BENCHMARK(drive_turn_of_through_crack)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

void drive_turn_of_surface_crack(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_surface_crack.toml");
  double K = 0;
  for (auto _ : state) {
    const DriveTurn turn = drive_turn(gear);
    K = turn.range();
    benchmark::DoNotOptimize(&K);
  }
  state.counters["range"] = K;
}
BENCHMARK(drive_turn_of_surface_crack)->Unit(benchmark::kMillisecond);

/// Stress of the sound flexspline over a turn, under one torque.
void drive_oval_of_a_cup(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_crack.toml");
  double stress = 0;
  for (auto _ : state) {
    stress = drive_oval(gear).largest();
    benchmark::DoNotOptimize(&stress);
  }
  state.counters["largest"] = stress;
}
BENCHMARK(drive_oval_of_a_cup)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strainwave
