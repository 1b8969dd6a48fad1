// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "strainwave/study/scatter.hpp"
#include "strainwave/study/sensitivity.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/example_gear.hpp"

namespace strainwave {
namespace {

/// K1, K2, K3 of the sound drive, then cracked under both senses.
std::array<double, 9> lines_of(const GearSet& gear) {
  CoupledOptions options;
  options.tolerance = 1e-14;  // so that differences over small steps mean something
  const AssembledDrive drive(gear, options);
  std::array<double, 9> K{};
  std::size_t i = 0;
  const auto add = [&](const MakersLines& lines) {
    for (const double line : {lines.K1, lines.K2, lines.K3}) K[i++] = line;
  };
  add(makers_lines(drive.without_cracks(), +1));
  add(makers_lines(drive, +1));
  add(makers_lines(drive, -1));
  return K;
}

constexpr std::array<const char*, 9> kNames = {
    "curve.intact.K1",   "curve.intact.K2",   "curve.intact.K3",
    "curve.positive.K1", "curve.positive.K2", "curve.positive.K3",
    "curve.negative.K1", "curve.negative.K2", "curve.negative.K3"};

/// Derivatives to ln x, or to x where it is 0, by central differences of two steps and one step of
/// Richardson's extrapolation.
std::array<double, 9> difference(const GearSet& gear, const std::string& path, double step) {
  const double x = number_at(gear, path).value;
  const auto central = [&](double h) {
    const auto at = [&](double change) {
      GearSet moved = gear;
      set_number(moved, path, x == 0 ? change * 1e-3 : x * (1 + change));
      return lines_of(moved);
    };
    const std::array<double, 9> above = at(+h);
    const std::array<double, 9> below = at(-h);
    std::array<double, 9> slope{};
    for (std::size_t i = 0; i < 9; ++i) slope[i] = (above[i] - below[i]) / (2 * h);
    return slope;
  };
  const std::array<double, 9> wide = central(step);
  std::array<double, 9> slope = central(step / 2);
  for (std::size_t i = 0; i < 9; ++i) slope[i] += (slope[i] - wide[i]) / 3;
  return slope;
}

void expect_differences(const GearSet& gear, double step, double tolerance) {
  const Sensitivity s = sensitivity_of(gear);
  ASSERT_TRUE(s.usable()) << s.unusable_because;
  const std::array<double, 9> K = lines_of(gear);
  std::size_t compared = 0;
  for (const SensitivityInput& input : s.inputs) {
    if (std::ranges::find(s.not_differentiated, input.path, &CurveStep::path) !=
        s.not_differentiated.end())
      continue;
    const std::array<double, 9> slope = difference(gear, input.path, step);
    for (std::size_t i = 0; i < 9; ++i) {
      const auto output = std::ranges::find(s.outputs, kNames[i], &SensitivityOutput::name);
      if (output == s.outputs.end()) continue;
      const Influence& exact =
          input.influence[static_cast<std::size_t>(output - s.outputs.begin())];
      const double by_log =
          input.value == 0 ? exact.derivative * 1e-3 / K[i] : exact.elasticity;
      EXPECT_NEAR(by_log, slope[i] / K[i], tolerance) << input.path << ' ' << kNames[i];
      ++compared;
    }
  }
  EXPECT_GT(compared, 100U);
}

// Kind: crosscheck of derivatives of the equilibrium (TC-27) with central differences of the whole
// model.  Tolerance 1e-7 of an elasticity: rounding of the differences.  No contact opens or closes
// within the steps.
TEST(CoupledSensitivity, CrosscheckDifferencesOfASoundDrive) {
  expect_differences(test::example_gear("catalogue_size25"), 2e-5, 1e-7);
}
TEST(CoupledSensitivity, CrosscheckDifferencesOfADriveWithEveryCrack) {
  expect_differences(test::example_gear("cracked_size25"), 2e-5, 1e-7);
}

}  // namespace
}  // namespace strainwave
