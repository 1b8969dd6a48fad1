// SPDX-License-Identifier: Apache-2.0
// Rows of equal cracks round a wall: exact rows, the solver of groups, energy, derivatives, limits.
#include "strainwave/crack_group/crack_row.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/crack_group/straight_cracks.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// A crack of a row along x with pitch 1, inclined from the y axis as (FR-6) counts.
StraightCrack crack_of(double share, double angle) {
  return {.centre = 0.0, .half_length = share / 2, .angle = pi / 2 + angle};
}

/// Stress of the sheet whose normal and shear stress on the plane of the crack are N and S of
/// (CG-1).
SheetStress stress_on(double angle, double N, double S) {
  const double c = std::cos(pi / 2 + angle);
  const double s = std::sin(pi / 2 + angle);
  return {.xx = N * s * s - 2 * S * s * c,
          .yy = N * c * c + 2 * S * s * c,
          .xy = -N * s * c + S * (c * c - s * s)};
}

// Kind: reference (CG-7).  Exact: collinear cracks, K over sigma sqrt(pi a) = sqrt(tan(x)/x),
// x = pi a/p, for both modes and for pressed faces.  Tolerance: 1e-9, as stated.
TEST(CrackRow, ReferenceCollinearRow) {
  for (const double share : {0.05, 0.3, 0.6, 0.9}) {
    const double x = pi * share / 2;
    const double exact = std::sqrt(std::tan(x) / x);
    const RowFactors row = row_factors(share, pi / 2);
    test::expect_relative(row.opening_by_normal, exact, 1e-9);
    test::expect_relative(row.sliding_by_shear, exact, 1e-9);
    EXPECT_NEAR(row.sliding_by_normal, 0, 1e-12);
    EXPECT_NEAR(row.opening_by_shear, 0, 1e-12);
    test::expect_relative(pressed_row(share, pi / 2), exact, 1e-9);
    EXPECT_NEAR(pull_of_row(share, pi / 2).most, 0, 1e-12);
  }
}

// Kind: limit (CG-7).  Stacked cracks, far longer than their pitch, have the K of a strip:
// opening sigma sqrt(p/2); strips that bend alone would give more.  Tolerance: 1e-6.
TEST(CrackRow, LimitLongStackedCracks) {
  const double share = 6;
  test::expect_relative(row_factors(share, 0.0).opening_by_normal * std::sqrt(pi * share / 2),
                        std::sqrt(0.5), 1e-6);
}

// Kind: crosscheck (CG-7).  The solver of any group, with its full system and many more points.
// Tolerance: 1e-9, as stated, and absolute for factors near 0.
TEST(CrackRow, CrosscheckAgainstAnyGroup) {
  for (const double angle : {0.0, 0.3, pi / 4, 1.2, -pi / 4, -1.0})
    for (const double share : {0.1, 0.7, 1.3, 2.5}) {
      if (share > largest_row_share(angle)) continue;
      const StraightCrack crack = crack_of(share, angle);
      const double root = std::sqrt(pi * share / 2);
      const auto K = [&](double N, double S) {
        const CrackGroup group =
            crack_group(std::array{crack}, stress_on(angle, N, S), {.order = 240, .period = 1.0});
        EXPECT_TRUE(group.settled);
        return group.cracks[0].ahead;
      };
      const RowFactors row = row_factors(share, angle);
      const TipFactors opened = K(1, 0);
      // A pull keeps the sheared faces apart, and a pressure keeps them pressed.
      constexpr double kPull = 20;
      const TipFactors sheared = K(kPull, 1);
      EXPECT_NEAR(row.opening_by_normal, opened.mode_1 / root, 1e-9);
      EXPECT_NEAR(row.sliding_by_normal, -opened.mode_2 / root, 1e-9);
      EXPECT_NEAR(row.opening_by_shear, -(sheared.mode_1 - kPull * opened.mode_1) / root, 1e-8);
      EXPECT_NEAR(row.sliding_by_shear, (sheared.mode_2 - kPull * opened.mode_2) / root, 1e-8);
      EXPECT_NEAR(pressed_row(share, angle), K(-kPull, 1).mode_2 / root, 1e-9);
    }
}

// Kind: crosscheck (CG-7).  The middle one of 21 and of 41 explicit cracks.  What the missing rest
// of the row changes falls with the number of cracks, so the two are extrapolated.  Tolerance: 0.3
// %, the next order; the neighbours change K by 21 %.
TEST(CrackRow, CrosscheckAgainstAFiniteRow) {
  const double share = 1.0;
  const auto middle_of = [&](int count) {
    std::vector<StraightCrack> cracks;
    for (int i = 0; i < count; ++i) {
      cracks.push_back(crack_of(share, pi / 4));
      cracks.back().centre = i - count / 2;
    }
    const CrackGroup group = crack_group(cracks, stress_on(pi / 4, 1, 0), {.order = 24});
    return group.cracks[static_cast<std::size_t>(count / 2)].ahead.mode_1 /
           std::sqrt(pi * share / 2);
  };
  const RowFactors row = row_factors(share, pi / 4);
  test::expect_relative((41 * middle_of(41) - 21 * middle_of(21)) / 20, row.opening_by_normal,
                        0.003);
  EXPECT_GT(row.opening_by_normal, 1.2);
}

// Kind: identity (CG-7), (CG-6).  All cracks of a row grow alike, so the integral of the energy
// release rate over a is the energy by the opening of the faces.  Tolerance: 1e-8.
TEST(CrackRow, IdentityEnergyByKAndByOpening) {
  for (const double angle : {0.2, pi / 4, 1.0})
    for (const double share : {0.6, 1.2}) {
      const double N = 1.0;
      const double S = 0.4;  // of (CG-1); (FR-6) counts the opposite sense
      const auto release = [&](double x) {
        const RowFactors row = row_factors(x, angle);
        const double K_I = row.opening_by_normal * N - row.opening_by_shear * S;
        const double K_II = row.sliding_by_normal * N - row.sliding_by_shear * S;
        return 2 * pi * (x / 2) * (K_I * K_I + K_II * K_II);  // two tips, da = dx/2
      };
      const auto sum = integrate(release, 0.0, share, QuadratureOptions{});
      ASSERT_TRUE(sum.converged);
      const CrackGroup group = crack_group(std::array{crack_of(share, angle)},
                                           stress_on(angle, N, S), {.order = 120, .period = 1.0});
      test::expect_relative(sum.value, group.work, 1e-8);  // twice the energy
    }
}

// Kind: limit (CG-7).  A pitch that is long beside the cracks leaves them alone; the first order
// is (pi a/p)^2.
TEST(CrackRow, LimitFarNeighbours) {
  const RowFactors alone = row_factors(0.0, 0.7);
  EXPECT_NEAR(alone.opening_by_normal, 1, 1e-12);
  EXPECT_NEAR(alone.sliding_by_shear, 1, 1e-12);
  EXPECT_NEAR(alone.sliding_by_normal, 0, 1e-12);
  EXPECT_NEAR(pressed_row(0.0, 0.7), 1, 1e-12);
  for (const double angle : {0.0, 0.7, pi / 2}) {
    const double near = row_factors(0.02, angle).opening_by_normal - 1;
    const double far = row_factors(0.01, angle).opening_by_normal - 1;
    EXPECT_NEAR(near / far, 4, 0.01);
  }
}

// Kind: identity (CG-7).  A mirror changes the sign of what one mode causes in the other.
TEST(CrackRow, IdentityMirror) {
  const RowFactors one = row_factors(1.1, 0.6);
  const RowFactors other = row_factors(1.1, -0.6);
  test::expect_relative(one.opening_by_normal, other.opening_by_normal, 1e-11);
  test::expect_relative(one.sliding_by_shear, other.sliding_by_shear, 1e-11);
  test::expect_relative(one.sliding_by_normal, -other.sliding_by_normal, 1e-11);
  test::expect_relative(one.opening_by_shear, -other.opening_by_shear, 1e-11);
  EXPECT_NEAR(pressed_row(1.1, 0.6), pressed_row(1.1, -0.6), 1e-11);
  EXPECT_NEAR(pull_of_row(1.1, 0.6).most, -pull_of_row(1.1, -0.6).least, 1e-11);
  EXPECT_NEAR(pull_of_row(1.1, 0.6).least, -pull_of_row(1.1, -0.6).most, 1e-11);
}

// Kind: identity (CG-7).  Derivatives by dual numbers against differences with a much smaller step.
// Tolerance: 1e-6, the error of these.
TEST(CrackRow, IdentityDerivatives) {
  constexpr double kStep = 1e-5;
  CrackReal share(0.9);
  CrackReal angle(0.5);
  share.partial[0] = 2.0;
  angle.partial[1] = -3.0;
  const BasicRowFactors<CrackReal> row = row_factors(share, angle);
  const CrackReal pressed = pressed_row(share, angle);
  const auto difference = [&](auto f) {
    return std::array{2.0 * (f(0.9 + kStep, 0.5) - f(0.9 - kStep, 0.5)) / (2 * kStep),
                      -3.0 * (f(0.9, 0.5 + kStep) - f(0.9, 0.5 - kStep)) / (2 * kStep)};
  };
  const auto expect_slopes = [&](const CrackReal& of, auto f) {
    EXPECT_EQ(of.value, f(0.9, 0.5));
    const auto slopes = difference(f);
    EXPECT_NEAR(of.partial[0], slopes[0], 1e-6);
    EXPECT_NEAR(of.partial[1], slopes[1], 1e-6);
  };
  expect_slopes(row.opening_by_normal,
                [](double x, double b) { return row_factors(x, b).opening_by_normal; });
  expect_slopes(row.sliding_by_normal,
                [](double x, double b) { return row_factors(x, b).sliding_by_normal; });
  expect_slopes(row.opening_by_shear,
                [](double x, double b) { return row_factors(x, b).opening_by_shear; });
  expect_slopes(row.sliding_by_shear,
                [](double x, double b) { return row_factors(x, b).sliding_by_shear; });
  expect_slopes(pressed, [](double x, double b) { return pressed_row(x, b); });
}

// Kind: limit (CG-7).  Beside neighbours that touch, the derivative is that of sqrt(tan(x)/x), x =
// pi a/p, too.  Tolerance: 1e-5, the points of the solver at a gap of 0.003.
TEST(CrackRow, LimitDerivativeBesideTouching) {
  CrackReal share(0.9985);
  share.partial[0] = 1;
  const double x = pi * share.value / 2;
  const double F = std::sqrt(std::tan(x) / x);
  const double slope = (1 / (std::cos(x) * std::cos(x) * x) - std::tan(x) / (x * x)) / (2 * F);
  const BasicRowFactors<CrackReal> row = row_factors(share, CrackReal(pi / 2));
  test::expect_relative(row.opening_by_normal.partial[0], slope * pi / 2, 1e-5);
}

// Kind: identity (CG-7).  The gap by hand, and the share at which the gap is the least one.
TEST(CrackRow, IdentityGaps) {
  EXPECT_NEAR(row_gap(0.5, pi / 2), 2, 1e-12);  // 2 a = p/2, so p - 2 a = 2 a
  EXPECT_NEAR(row_gap(2.0, 0.0), 1, 1e-12);     // p = a
  EXPECT_NEAR(row_gap(4.0, pi / 4), 0.5 / std::sqrt(2), 1e-12);
  EXPECT_EQ(row_gap(1.0, pi / 2), 0);
  for (const double angle : {0.0, 0.4, pi / 4, 1.3, 1.45, 1.5, pi / 2, -1.5})
    for (const double gap : {kLeastRowGap, 0.5, 3.0})
      EXPECT_NEAR(row_gap(largest_row_share(angle, gap), angle), gap, 1e-9) << angle;
}

// Kind: behaviour (CG-7).  Under torsion the faces of a row stay open, and up to 1.2 rad pressed
// along their whole length, up to a share of 1.5.
TEST(CrackRow, BehaviourTorsionKeepsFaces) {
  for (double angle = 0.05; angle < pi / 2; angle += 0.05)
    for (const double share : {0.4, 0.8, 1.2, 1.5}) {
      if (share > largest_row_share(angle)) continue;
      const double N = std::sin(2 * angle);
      const double S = std::cos(2 * angle);
      const RowFactors apart = row_factors(share, angle);
      EXPECT_GT(apart.opening_by_normal * N + apart.opening_by_shear * S, 0) << angle;
      const PullOfRow pull = pull_of_row(share, angle);
      if (angle <= 1.2) {
        EXPECT_GT(N + std::min(pull.least * S, pull.most * S), 0) << angle;
      }
    }
}

// Kind: behaviour (CG-7).  Where tips pass each other, neighbours pull at parts of pressed faces.
TEST(CrackRow, BehaviourPullWhereTipsPass) {
  const double angle = 80 * pi / 180;
  const double N = std::sin(2 * angle);
  const double S = std::cos(2 * angle);
  const PullOfRow pull = pull_of_row(1.3, angle);
  EXPECT_LT(N + std::min(pull.least * S, pull.most * S), 0);
}

// Kind: input.  Neighbours that touch are refused.
TEST(CrackRow, InputTouchingNeighbours) {
  EXPECT_THROW((void)row_factors(1.0, pi / 2), InputError);
  EXPECT_THROW((void)pressed_row(1.2, pi / 2), InputError);
}

}  // namespace
}  // namespace strainwave
