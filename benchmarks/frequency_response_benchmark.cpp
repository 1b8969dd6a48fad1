// SPDX-License-Identifier: Apache-2.0
// Frequency responses of a drive between motor and load at 10^4 frequencies.
#include <benchmark/benchmark.h>

#include <array>

#include "strainwave/dynamics/frequency_response.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/study/frf_report.hpp"

namespace strainwave {
namespace {

constexpr int kFrequencies = 10'000;

/// All six responses of a sound and a cracked drive, with their extrema and the torsion curves that
/// give the springs.
void frf_of_a_cracked_drive(benchmark::State& state) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/joint_size25.toml");
  for (auto _ : state) benchmark::DoNotOptimize(frf_report(gear, {.points = kFrequencies}));
}
BENCHMARK(frf_of_a_cracked_drive)->Unit(benchmark::kMillisecond);

/// Three responses of a chain of four inertias.
void responses_of_a_chain(benchmark::State& state) {
  const TorsionalChain chain = {
      .inertias = {{"wave generator", 46.8e-4}, {"rim", 0.02}, {"cup", 0.03}, {"load", 20.0}},
      .springs = {{"wave generator", 3.407e-7, 3.0, {-0.01, -1, 0, 0}},
                  {"flexspline", 2.359e-7, 4.0, {0, 1, -1, 0}},
                  {"output shaft", 6.906e-7, 1.5, {0, 0, 1, -1}}}};
  const std::array paths = {ChainPath{.at = 0, .inertia = 0}, ChainPath{.at = 0, .inertia = 3},
                            ChainPath{.by = ShakenBy::twist, .at = 0, .inertia = 3}};
  const std::vector<double> frequencies = logarithmic_frequencies(1, 1e4, kFrequencies);
  for (auto _ : state) benchmark::DoNotOptimize(frequency_responses(chain, paths, frequencies));
}
BENCHMARK(responses_of_a_chain)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strainwave
