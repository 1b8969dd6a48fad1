// SPDX-License-Identifier: Apache-2.0
// A row of through cracks round a tube: the curvature between the cracks, against solid elements
// and against the shallow shell of another program.
#include "strainwave/sif/tube/shell_row.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave::sif {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

ThroughCrackInTube row_of(const test::CsvRow& row) {
  return {.half_length = row("half_length"),
          .mean_radius = row("radius"),
          .wall_thickness = row("wall"),
          .angle = row("angle"),
          .poissons_ratio = 0.3,
          .count = static_cast<int>(row("cracks"))};
}

ShellFactors shell_row_excess(double lambda, double share, double angle) {
  return BasicShellRowAtAngle<double>(angle).at(lambda, share);
}

double per_crack(const ThroughCrackInTube& crack, std::size_t load) {
  return added_compliance(crack, {.opening = 206e9, .shear = 79e9}).matrix(load, load) /
         crack.count;
}

/// Energy release rate under the torque, mean through the wall.
double release(const ThroughCrackInTube& crack) {
  const auto [mean, slope] = crack.family().linear_stress_intensity(crack.half_length);
  const auto square = [](const UnitStressIntensity<2>& k) {
    return k.I[kTorsion] * k.I[kTorsion] + k.II[kTorsion] * k.II[kTorsion];
  };
  return square(mean) + square(slope) / 3;
}

// Kind: crosscheck (CG-8), (CG-7).  Source: tests/data/crack_rows.csv, tubes of 20-node bricks by
// CalculiX and a shallow shell of the same script; the crack alone is that of the same program.
// Tolerance: 2 % of solid elements, 2.5 % at the shell parameter 3.9; both are less than the stated
// 5 %.  1 % of the shell, whose table has fewer digits; G of bricks from two lengths: 4 %.
TEST(ShellRow, CrosscheckSolidElements) {
  int ratios = 0;
  int releases = 0;
  for (const test::CsvRow& row : test::read_reference_csv("crack_rows")) {
    const std::string quantity = row.quantity.substr(row.quantity.find('.') + 1);
    const std::size_t load = row.quantity.starts_with("axial") ? kAxial : kTorsion;
    const ThroughCrackInTube cracks = row_of(row);
    ThroughCrackInTube alone = cracks;
    alone.count = 1;
    const double ratio = per_crack(cracks, load) / per_crack(alone, load);
    if (quantity == "ratio") {
      test::expect_relative(ratio, row.value, row("shell_parameter") < 3 ? 0.02 : 0.025);
      ++ratios;
    } else if (quantity == "shell_ratio") {
      test::expect_relative(ratio, row.value, 0.01);
    } else if (quantity == "sheet_ratio" && load == kTorsion) {
      ThroughCrackInTube flat = cracks;
      ThroughCrackInTube flat_alone = alone;
      flat.shell_correction = flat_alone.shell_correction = false;
      flat.thin_sheet = flat_alone.thin_sheet = true;
      test::expect_relative(per_crack(flat, load) / per_crack(flat_alone, load), row.value, 1e-7);
    } else if (quantity == "release_ratio") {
      test::expect_relative(release(cracks) / release(alone), row.value, 0.04);
      ++releases;
    }
    if (::testing::Test::HasFailure()) FAIL() << row.place;
  }
  EXPECT_GE(ratios, 19);
  EXPECT_GE(releases, 9);
}

// Kind: limit (CG-8).  Without curvature, or with neighbours far away beside flat ones, nothing is
// added; beyond the table the values of its end stay.
TEST(ShellRow, LimitEndsOfTheTable) {
  const double end = largest_tabulated_share(0.6);
  const auto all = [](const ShellFactors& f) {
    return std::array{f.opening_by_normal.mean, f.opening_by_normal.linear,
                      f.sliding_by_normal.mean, f.sliding_by_normal.linear,
                      f.opening_by_shear.mean,  f.opening_by_shear.linear,
                      f.sliding_by_shear.mean,  f.sliding_by_shear.linear};
  };
  for (const double value : all(shell_row_excess(0.0, 0.8, 0.6))) EXPECT_NEAR(value, 0, 2e-4);
  for (const double value : all(shell_row_excess(2.0, 0.0, 0.6))) EXPECT_EQ(value, 0);
  EXPECT_EQ(all(shell_row_excess(1.0, end, 0.6)), all(shell_row_excess(1.0, 2 * end, 0.6)));
  EXPECT_EQ(all(shell_row_excess(kShellRowTableEnd, 0.5, 0.6)), all(shell_row_excess(7, 0.5, 0.6)));
  EXPECT_NEAR(largest_tabulated_share(0.0), 0.85 / std::sqrt(0.15), 1e-12);
  EXPECT_NEAR(largest_tabulated_share(kRightAngle / 2), 0.85 / std::sqrt(0.125 + 0.15 * 0.875),
              1e-12);
  EXPECT_NEAR(largest_tabulated_share(kRightAngle), 0.85, 1e-12);
}

// Kind: identity (CG-8).  A mirror changes the sign of what one mode causes in the other.
TEST(ShellRow, IdentityMirror) {
  const ShellFactors right = shell_row_excess(1.7, 0.7, 0.5);
  const ShellFactors left = shell_row_excess(1.7, 0.7, -0.5);
  const auto expect = [](const WallIntensity& one, const WallIntensity& other, double sign) {
    EXPECT_EQ(one.mean, sign * other.mean);
    EXPECT_EQ(one.linear, sign * other.linear);
    EXPECT_NE(one.mean, 0);
  };
  expect(right.opening_by_normal, left.opening_by_normal, 1);
  expect(right.sliding_by_shear, left.sliding_by_shear, 1);
  expect(right.sliding_by_normal, left.sliding_by_normal, -1);
  expect(right.opening_by_shear, left.opening_by_shear, -1);
}

// Kind: identity (CG-8).  Derivatives by dual numbers against differences.  Tolerance: 1e-6.
TEST(ShellRow, IdentityDerivatives) {
  constexpr double kStep = 1e-5;
  const std::array<double, 3> at = {1.3, 0.6, -0.4};
  std::array<CrackReal, 3> duals = {at[0], at[1], at[2]};
  for (std::size_t i = 0; i < 3; ++i) duals[i].partial[i] = 1;
  const auto exact = BasicShellRowAtAngle<CrackReal>(duals[2]).at(duals[0], duals[1]);
  for (std::size_t i = 0; i < 3; ++i) {
    auto ahead = at;
    auto behind = at;
    ahead[i] += kStep;
    behind[i] -= kStep;
    const ShellFactors more = shell_row_excess(ahead[0], ahead[1], ahead[2]);
    const ShellFactors less = shell_row_excess(behind[0], behind[1], behind[2]);
    const auto slope = [&](auto factor, auto part) {
      return (more.*factor.*part - less.*factor.*part) / (2 * kStep);
    };
    EXPECT_NEAR(exact.opening_by_normal.mean.partial[i],
                slope(&ShellFactors::opening_by_normal, &WallIntensity::mean), 1e-6);
    EXPECT_NEAR(exact.sliding_by_shear.linear.partial[i],
                slope(&ShellFactors::sliding_by_shear, &WallIntensity::linear), 1e-6);
    EXPECT_NEAR(exact.opening_by_shear.linear.partial[i],
                slope(&ShellFactors::opening_by_shear, &WallIntensity::linear), 1e-6);
  }
}

}  // namespace
}  // namespace strainwave::sif
