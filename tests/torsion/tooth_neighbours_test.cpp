// SPDX-License-Identifier: Apache-2.0
// Neighbouring teeth of a thick circular spline (TC-31).
#include "tooth_neighbours.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "coupled_drive.hpp"
#include "strainwave/core/units.hpp"
#include "support/reference_csv.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using units::deg;

constexpr FlankPlace kDrive{.tooth = 0, .side = 1};

/// Distance by which one flank opens under a unit force on another; both have the same angle.
template <class Real>
Real opening(const BasicToothNeighbours<Real>& teeth, FlankPlace of, FlankPlace by,
             const Real& angle) {
  const BasicFlankContact<Real> contact{.angle = angle, .height = Real(0.0)};
  return teeth.between(of, by).opening(flank_shares(contact, of.side),
                                       flank_shares(contact, by.side));
}
double opening(const ToothNeighbours& teeth, FlankPlace of, FlankPlace by) {
  return opening(teeth, of, by, 22 * deg);
}

/// A tooth of half a pitch on a layer, lengths in modules.
template <class Real>
BasicToothOnWall<Real> tooth_on(double wall) {
  return {
      .flank_angle = 22 * deg, .thickness = pi / 2, .dedendum = 1.1, .wall = wall, .module = 1.0};
}

/// E = 1, nu = 0.3.
BasicElasticConstants<double> unit_steel() { return {.E = 1.0, .G = 1 / 2.6, .nu = 0.3}; }

/// Drawn teeth of size 25 whose flanks press on each other without torque.
GearSet pressed_drive(double ratio = 100) {
  GearSet gear = test::typical_drive(25, ratio);
  test::half_free(gear);
  gear.mesh->tooth = ToothShape{};
  gear.mesh->lobe_gap = -4e-6;
  gear.circular_spline->inner_diameter =
      gear.drive.pitch_diameter + 4.2 * gear.drive.pitch_diameter / (2 * gear.drive.ratio);
  return gear;
}

TEST(ToothNeighbours, ReferencePlaneFiniteElements) {
  // (TC-31) against tools/reference/tooth_pair.py: quadratic plane elements of 31 teeth on a smooth
  // rigid bore.  Tolerance 0.014, times 1/(E b): what an even and a linear load over the root leave
  // out, and the ends of the strip; the chapter states it.  Without the lever of the force the
  // error is 0.073.
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("tooth_pair_fe"))
    if (row.quantity.starts_with("next_")) {
      BasicToothOnWall<double> tooth = tooth_on<double>(row("wall_over_module"));
      tooth.flank_angle = row("flank_angle");
      tooth.thickness = row("thickness_over_pitch") * pi;
      tooth.dedendum = row("dedendum_over_module");
      const ToothNeighbours teeth(tooth, unit_steel(), 1.0, 320);
      EXPECT_NEAR(opening(teeth, {.tooth = row.quantity.back() - '0', .side = 1}, kDrive,
                          tooth.flank_angle),
                  row.value, 0.014)
          << row.quantity << " " << row("wall_over_module");
      ++rows;
    }
  EXPECT_EQ(rows, 9);
}

TEST(ToothNeighbours, ReferenceTheIntegralOverTheWaves) {
  // (TC-31) by the trapezoidal rule over the wave number, as it is printed.  Tolerance 2e-6: the
  // end of this integral at 700 per module, where the rest is of the order 1/(wave^2 B^2).
  const double wall = 20.0;
  const BasicToothOnWall<double> tooth = tooth_on<double>(wall);
  const ToothNeighbours teeth(tooth, unit_steel(), 1.0, 320);
  const double root = tooth.root_width();
  const double lever = 1.1 - pi / 4 * std::tan(tooth.flank_angle);
  const double c = std::cos(tooth.flank_angle);
  const double s = std::sin(tooth.flank_angle);
  constexpr double kStep = 1e-3;
  for (const int n : {1, 2, 5, 20}) {
    double like = 0.0;
    double facing = 0.0;
    for (int i = 1; i < 700000; ++i) {
      const double k = kStep * i;
      const double K = std::min(k * wall, 300.0);
      const double below = std::sinh(2 * K) + 2 * K;
      const double T = (std::cosh(2 * K) + 1) / below - 1 / (2 * K);
      const double N = (std::cosh(2 * K) - 1) / below;
      const double M = (std::sinh(2 * K) - 2 * K) / below;
      const double a = k * root / 2;
      const double even = std::sin(a) / a;
      const double turn =
          k * lever *
          (a < 0.01 ? 1 - a * a / 10 : 3 * (std::sin(a) - a * std::cos(a)) / (a * a * a));
      const double along = T * even * even + M * even * turn + N * turn * turn;
      const double wave = kStep / k * 2 * 0.91 / pi;
      like += wave * (c * c * along + s * s * N * even * even) * std::cos(k * n * pi);
      facing += wave * ((s * s * N * even * even - c * c * along) * std::cos(k * n * pi) -
                        s * c * (M * even * even + 2 * N * even * turn) * std::sin(k * n * pi));
    }
    // the point at 0 of the trapezoidal rule, where T -> K/3 and N -> K/2
    const double at_zero = kStep / 2 * 2 * 0.91 / pi * wall;
    like += at_zero * (c * c / 3 + s * s / 2);
    facing += at_zero * (s * s / 2 - c * c / 3);
    EXPECT_NEAR(opening(teeth, {.tooth = n, .side = 1}, kDrive), like, 2e-6) << n;
    // the coast flank of the tooth 0 presses one tooth of the circular spline farther back
    EXPECT_NEAR(opening(teeth, {.tooth = n - 1, .side = 1}, {.tooth = 0, .side = -1}), facing, 2e-6)
        << n;
  }
}

TEST(ToothNeighbours, ReferenceTheLayerByItsEquations) {
  // tools/reference/coupled_drive.py solves the four equations of the layer over its depth for each
  // wave number, and integrates beyond them along a contour.  Tolerance 2e-12 of the largest entry,
  // which is 1: the accuracy that the chapter states, and as much for the other program.
  const std::vector<test::CsvRow> rows = test::read_reference_csv("tooth_neighbours");
  ASSERT_EQ(rows.size(), 45U);
  for (std::size_t i = 0; i < rows.size(); i += 3) {
    const test::CsvRow& row = rows[i];  // tangential; then radial, mixed
    BasicToothOnWall<double> tooth = tooth_on<double>(row("wall_over_module"));
    tooth.flank_angle = row("flank_angle");
    tooth.dedendum = row("dedendum_over_module");
    const ToothNeighbours teeth(tooth, unit_steel(), 1.0, 320);
    const int n = static_cast<int>(row("pitches"));
    const double layer = 2 * 0.91 / pi;
    const double c = std::cos(tooth.flank_angle);
    const double s = std::sin(tooth.flank_angle);
    const double along = c * c * rows[i].value;
    const double outward = s * s * rows[i + 1].value;
    SCOPED_TRACE(std::to_string(row("wall_over_module")) + ' ' + std::to_string(n));
    const auto moved = [&](FlankPlace of, FlankPlace by) {
      return opening(teeth, of, by, tooth.flank_angle) / layer;
    };
    EXPECT_NEAR(moved({.tooth = n, .side = 1}, kDrive), along + outward, 2e-12);
    EXPECT_NEAR(moved({.tooth = n - 1, .side = 1}, {.tooth = 0, .side = -1}),
                outward - along - 2 * s * c * rows[i + 2].value, 2e-12);
  }
}

TEST(ToothNeighbours, IdentityQuadratureAndFadingWavesMeet) {
  // (TC-31): beyond half a thickness between the roots, the waves that fade along the layer take
  // the place of the quadrature over the wave numbers.  Both sides of this end, for teeth that are
  // 1 to 9 pitches apart; tolerance 2e-12, the accuracy that the chapter states.
  for (const int n : {1, 2, 3, 5, 9}) {
    const double root = tooth_on<double>(1.0).root_width();
    const double end = (n * pi - root) / 0.5;  // wall at which the roots are so far apart
    const ToothNeighbours far(tooth_on<double>(end * (1 - 1e-13)), unit_steel(), 1.0, 320);
    const ToothNeighbours near(tooth_on<double>(end * (1 + 1e-13)), unit_steel(), 1.0, 320);
    for (const int m : {n, n + 1}) {
      const FlankPlace other{.tooth = m, .side = 1};
      const FlankPlace facing{.tooth = m - 1, .side = 1};
      const FlankPlace coast{.tooth = 0, .side = -1};
      EXPECT_NEAR(opening(far, other, kDrive), opening(near, other, kDrive), 2e-12) << n;
      EXPECT_NEAR(opening(far, facing, coast), opening(near, facing, coast), 2e-12) << n;
    }
  }
}

TEST(ToothNeighbours, IdentityReciprocityAndMirror) {
  const BasicToothOnWall<double> tooth = tooth_on<double>(32);
  const ToothNeighbours teeth(tooth, unit_steel(), 1.0, 101);
  for (int n = -50; n <= 50; ++n)
    for (const int of : {1, -1})
      for (const int by : {1, -1}) {
        const FlankPlace other{.tooth = n, .side = of};
        const FlankPlace force{.tooth = 0, .side = by};
        const double moved = opening(teeth, other, force);
        EXPECT_EQ(moved, opening(teeth, force, other)) << n;
        EXPECT_EQ(moved, opening(teeth, {.tooth = -n, .side = -of}, {.tooth = 0, .side = -by}))
            << n;
        EXPECT_EQ(moved, opening(teeth, {.tooth = n < 0 ? n + 101 : n - 101, .side = of}, force))
            << n;
      }
  // Flanks of one tooth of the circular spline: its own compliance is in (TC-30).
  EXPECT_EQ(opening(teeth, kDrive, kDrive), 0.0);
  EXPECT_EQ(opening(teeth, kDrive, {.tooth = 1, .side = -1}), 0.0);
}

TEST(ToothNeighbours, LimitAThinRingHasNoNeighbours) {
  // The layer rests beyond its reach of exp(-2.1 x/t), so a ring of half a pitch moves the next
  // tooth by less than a thousandth of what a thick one does.
  const auto next = [](double wall) {
    const BasicToothOnWall<double> tooth = tooth_on<double>(wall);
    return opening(ToothNeighbours(tooth, unit_steel(), 1.0, 100), {.tooth = 2, .side = 1}, kDrive);
  };
  EXPECT_LT(std::abs(next(pi / 2)), 1e-3 * next(40));
}

TEST(ToothNeighbours, LimitOfAVeryThinRing) {
  // (TC-31): a wall of a fifth to a third of a module.  The transforms of the loads grow like
  // exp(Im K B/2) with the root's width B, here up to exp(600), and the waves fade as fast.
  for (const double wall : {0.2, 0.22, 0.25, 0.3, 0.34}) {
    const ToothNeighbours teeth(tooth_on<double>(wall), unit_steel(), 1.0, 100);
    for (const int n : {1, 2}) {
      const double moved = opening(teeth, {.tooth = n, .side = 1}, kDrive);
      EXPECT_LT(std::abs(moved), 1e-3) << wall << ", " << n;  // false for NaN too
    }
  }
}

TEST(ToothNeighbours, IdentityTheEnergyOfTheTeethIsPositive) {
  // (TC-11) has one state for each torque only if the compliance of the pairs outweighs what the
  // neighbours lack on the diagonal: the least eigenvalue of (TC-31) stays above half of the
  // negative compliance of a pair.
  for (const double ratio : {30.0, 100.0, 160.0}) {
    const CoupledGeometry g = coupled_geometry(pressed_drive(ratio), {});
    const int teeth = g.teeth / 6;
    Eigen::MatrixXd C(2 * teeth, 2 * teeth);
    const auto flank = [&](int i) {
      return FlankPlace{.tooth = i % teeth, .side = i < teeth ? 1 : -1};
    };
    for (int i = 0; i < C.rows(); ++i)
      for (int j = 0; j < C.cols(); ++j) C(i, j) = opening(*g.neighbours, flank(i), flank(j));
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(C).eigenvalues().minCoeff();
    EXPECT_LT(least, 0.0);
    EXPECT_GT(least, -0.5 / (g.flank.pair_stiffness * g.rim_width)) << ratio;
  }
}

TEST(ToothNeighbours, IdentityDerivativesAreThoseOfTheValues) {
  // Dual numbers against central differences; tolerance 1e-7 of the largest derivative: the step.
  const double wall = 25.0;
  const auto values = [&]<class Real>(const std::array<Real, 8>& x) {
    const BasicToothOnWall<Real> tooth{
        .flank_angle = x[0], .thickness = x[1], .dedendum = x[2], .wall = x[3], .module = x[4]};
    const BasicToothNeighbours<Real> teeth(tooth, {.E = x[6], .G = x[6] / 2.6, .nu = x[7]}, x[5],
                                           200);
    std::vector<Real> out;
    for (const int n : {1, 2, 9, 40}) {
      out.push_back(opening(teeth, {.tooth = n, .side = 1}, kDrive, x[0]));
      out.push_back(opening(teeth, {.tooth = n, .side = -1}, kDrive, x[0]));
    }
    return out;
  };
  const std::array<double, 8> at = {22 * deg, pi / 2, 1.1, wall, 1.0, 2.0, 2.0, 0.28};
  std::array<DualReal, 8> dual;
  for (std::size_t k = 0; k < at.size(); ++k) {
    dual[k] = at[k];
    dual[k].partial[k] = 1.0;
  }
  const std::vector<DualReal> found = values(dual);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double step = 1e-5 * at[k];
    std::array<double, 8> more = at;
    std::array<double, 8> less = at;
    more[k] += step;
    less[k] -= step;
    const std::vector<double> after = values(more);
    const std::vector<double> before = values(less);
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i].partial[k], (after[i] - before[i]) / (2 * step), 1e-7 / at[k])
          << k << " " << i;
  }
}

TEST(ToothNeighbours, IdentitySharesAndReciprocityOfTheDrive) {
  // Clapeyron and Maxwell with (TC-31), also where drive and coast flanks press at the same time
  // and where each flank has its own direction.
  for (const ToothProfile profile : {ToothProfile::straight, ToothProfile::half_path}) {
    GearSet gear = pressed_drive();
    gear.mesh->tooth->profile = profile;
    CoupledDrive drive(gear, coupled_geometry(gear, {}), {});
    ASSERT_TRUE(drive.assemble());
    ASSERT_GT(drive.largest_flank_force(drive.assembled()), 0.0);
    // tolerance 1e-12: rounding of the harmonics over the turn
    const Eigen::MatrixXd& C = drive.rings().flexibility();
    EXPECT_LT((C - C.transpose()).cwiseAbs().maxCoeff(), 1e-12 * C.cwiseAbs().maxCoeff());
    for (const double torque : {2.0, 48.0}) {
      const Equilibrium state = drive.solve(torque, drive.assembled());
      ASSERT_TRUE(state.converged);
      const CoupledDrive::Tangent tangent = drive.tangent(state);
      std::array<double, kCurveMembers> share{};
      drive.add_shares(state, tangent, share);
      const double work = tangent.rotation / drive.geometry().ring_radius;
      EXPECT_NEAR(std::accumulate(share.begin(), share.end(), 0.0) / work, 1.0, 1e-11);
      EXPECT_GT(drive.rings().neighbour_energy(tangent.force), 0.004 * work);
      for (int i = drive.balls(); i < drive.contacts(); ++i) {
        if (!(state.force[i] > 0)) continue;
        const Eigen::VectorXd push = Eigen::VectorXd::Unit(drive.contacts(), i);
        EXPECT_NEAR(drive.linear_response(state, push, 0.0).rotation / drive.geometry().ring_radius,
                    -tangent.force[i], 1e-10 * tangent.force.cwiseAbs().maxCoeff());
      }
    }
  }
}

TEST(ToothNeighbours, BehaviourWhereTheTermBelongs) {
  // To drawn teeth with a ring, whether the program computes the stiffness of a pair or not.
  const auto has = [](const auto& change) {
    GearSet gear = pressed_drive();
    change(gear);
    return coupled_geometry(gear, {}).neighbours.has_value();
  };
  EXPECT_TRUE(has([](GearSet&) {}));
  EXPECT_TRUE(has([](GearSet& g) { g.circular_spline->support = 0.0; }));
  EXPECT_TRUE(has([](GearSet& g) { g.mesh->pair_stiffness = 2e10; }));
  EXPECT_FALSE(has([](GearSet& g) { g.circular_spline.reset(); }));
  EXPECT_FALSE(has([](GearSet& g) { g.mesh->tooth.reset(); }));
}

TEST(ToothNeighbours, ScalingWithModulusAndWidth) {
  const BasicToothOnWall<double> tooth = tooth_on<double>(30);
  const auto next = [&](double E, double b) {
    return opening(ToothNeighbours(tooth, {.E = E, .G = E / 2.6, .nu = 0.3}, b, 100),
                   {.tooth = 1, .side = 1}, kDrive);
  };
  EXPECT_NEAR(next(3.0, 5.0) * 15 / next(1.0, 1.0), 1.0, 1e-14);
}

}  // namespace
}  // namespace strainwave
