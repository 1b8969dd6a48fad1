// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/plate_edge.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "strainwave/core/error.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"
#include "support/scaling.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;
using test::Arg;

constexpr ClampedPlate kPlate{.outer_radius = 31.02e-3,
                              .inner_radius = 18.415e-3,
                              .thickness = 0.762e-3,
                              .youngs_modulus = 2.06e11,
                              .poissons_ratio = 0.3};

double bending(const ClampedPlate& plate) {
  return plate.youngs_modulus * std::pow(plate.thickness, 3) /
         (12 * (1 - plate.poissons_ratio * plate.poissons_ratio));
}

// --- Rayleigh and Ritz in Legendre polynomials (TC-3) -------------------------------------------

TEST(PlateEdge, ReferenceTable) {
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("coupled_drive_laws")) {
    if (!row.quantity.starts_with("plate_edge_stiffness")) continue;
    const ClampedPlate plate{
        .outer_radius = row("outer_radius"),
        .inner_radius = row("inner_radius"),
        .thickness = row("thickness"),
        .youngs_modulus = row("youngs_modulus"),
        .poissons_ratio = row("poissons_ratio"),
        .clamped = row.quantity.ends_with("of_hat") ? ClampedEdge::outer : ClampedEdge::inner,
        .corner = row("corner")};
    const int n = static_cast<int>(row("harmonics_or_harmonic"));
    test::expect_row(plate_edge_stiffness(plate, n), row, 1e-10);  // rounding of a 4x4 solve
    ++rows;
  }
  EXPECT_EQ(rows, 28);
}

TEST(PlateEdge, ReferenceTableOfDrives) {
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("coupled_drive_members")) {
    if (row.quantity != "plate_edge_stiffness") continue;
    const test::DriveInputs& in = test::drive_inputs(static_cast<int>(row("size")), row("ratio"));
    const ClampedPlate plate{.outer_radius = in.at("diaphragm_outer_radius"),
                             .inner_radius = in.at("diaphragm_inner_radius"),
                             .thickness = in.at("diaphragm_thickness"),
                             .youngs_modulus = in.at("youngs_modulus"),
                             .poissons_ratio = in.at("poissons_ratio")};
    const int n = static_cast<int>(row("harmonic"));
    test::expect_row(plate_edge_stiffness(plate, n), row, 1e-10);
    ++rows;
  }
  EXPECT_EQ(rows, 77);
}

// --- limits -------------------------------------------------------------------------------------

TEST(PlateEdge, LimitShortWavesForgetTheInnerEdge) {
  // Free edge of a half plane against u cos(k x), k = n/r_o, no moment:
  // pi r_o D k^3 (1 - nu) (3 + nu)/2... from w = (A + B y) e^{-ky}.  The next term is 1/n.
  const double D = bending(kPlate);
  const double nu = kPlate.poissons_ratio;
  double last = 1.0;
  for (const int n : {32, 64, 128}) {
    const double k = n / kPlate.outer_radius;
    const double half_plane = pi * kPlate.outer_radius * D * k * k * k * (1 - nu) * (3 + nu) / 2;
    const double off = std::abs(plate_edge_stiffness(kPlate, n) / half_plane - 1);
    EXPECT_LT(off, 3.0 / n) << n;
    EXPECT_LT(off, last);
    last = off;
  }
}

TEST(PlateEdge, LimitNarrowPlateIsACantilever) {
  // A strip of length l, clamped, its end free of moment: 3 D/l^3 per width, pi r_o in all for
  // cos^2; next term l/r_o.
  for (const double l : {1e-4, 1e-5}) {
    ClampedPlate narrow = kPlate;
    narrow.inner_radius = narrow.outer_radius - l;
    const double strip = pi * narrow.outer_radius * 3 * bending(narrow) / (l * l * l);
    for (const int n : {2, 3, 5})
      EXPECT_NEAR(plate_edge_stiffness(narrow, n) / strip, 1, 3 * l / narrow.outer_radius);
  }
}

TEST(PlateEdge, LimitClampedCurvatureOfANarrowPlate) {
  // A beam of length l, clamped at one end and moved by u at the other: its curvature is 3 u/l^2 if
  // the other end is hinged, and 6 u/l^2 if it cannot turn.  The next term is of the order l/R.
  for (const ClampedEdge clamped : {ClampedEdge::inner, ClampedEdge::outer}) {
    ClampedPlate narrow = kPlate;
    narrow.clamped = clamped;
    const double l = 1e-3 * narrow.outer_radius;
    narrow.inner_radius = narrow.outer_radius - l;
    EXPECT_NEAR(std::abs(clamped_edge_curvature(narrow, 2)) * l * l, 3.0, 5e-3);
    narrow.corner = 1e5 * bending(narrow) / l;
    EXPECT_NEAR(std::abs(clamped_edge_curvature(narrow, 2)) * l * l, 6.0, 1e-2);
  }
}

TEST(PlateEdge, LimitPointLikeBossIsAFullPlate) {
  // Without a hole only r^n and r^(n+2) remain: D pi/r_o^2 times 2 (1 - nu)... evaluated from the
  // two powers here; the boss matters as rho^(2n - 2).
  const double nu = kPlate.poissons_ratio;
  ClampedPlate full = kPlate;
  full.inner_radius = 1e-4 * full.outer_radius;
  for (const int n : {3, 5, 8}) {
    // w = A r^n + B r^(n+2) over r_o, A + B = 1, M_r = 0.
    const auto moment = [&](double p) { return p * (p - 1) + nu * (p - n * n); };
    const auto shear = [&](double p) {
      return -((p * p - n * n) * (p - 2) - (1 - nu) * n * n * (p - 1));
    };
    const double B = -moment(n) / (moment(n + 2) - moment(n));
    const double expected = pi * bending(full) / (full.outer_radius * full.outer_radius) *
                            ((1 - B) * shear(n) + B * shear(n + 2));
    EXPECT_NEAR(plate_edge_stiffness(full, n) / expected, 1, 1e-6) << n;
  }
}

TEST(PlateEdge, IdentityGrowsWithBossThicknessAndHarmonic) {
  const double k = plate_edge_stiffness(kPlate, 2);
  for (int n = 3; n <= 64; ++n)
    EXPECT_GT(plate_edge_stiffness(kPlate, n), plate_edge_stiffness(kPlate, n - 1)) << n;
  ClampedPlate other = kPlate;
  other.inner_radius *= 1.1;
  EXPECT_GT(plate_edge_stiffness(other, 2), k);
  other = kPlate;
  other.thickness *= 2;
  test::expect_relative(plate_edge_stiffness(other, 2), 8 * k, 1e-13);
}

TEST(PlateEdge, IdentityFiniteUpToTheLargestHarmonic) {
  ClampedPlate small_boss = kPlate;
  small_boss.inner_radius = 1e-3 * small_boss.outer_radius;
  for (const ClampedPlate& plate : {kPlate, small_boss}) {
    const double k = plate_edge_stiffness(plate, 128);
    EXPECT_TRUE(std::isfinite(k));
    EXPECT_GT(k, 0.0);
  }
}

TEST(PlateEdge, IdentityDerivativesAreThoseOfTheValues) {
  // Dual numbers against central differences of relative steps of 1e-5, for a cup and a hat.
  // Tolerance 1e-8 of the stiffness: the steps' truncation, and rounding over the step.
  const auto stiffness = []<class Real>(const std::array<Real, 6>& x, ClampedEdge clamped) {
    return plate_edge_stiffness(BasicClampedPlate<Real>{.outer_radius = x[0],
                                                        .inner_radius = x[1],
                                                        .thickness = x[2],
                                                        .youngs_modulus = x[3],
                                                        .poissons_ratio = x[4],
                                                        .clamped = clamped,
                                                        .corner = x[5]},
                                3);
  };
  const std::array<double, 6> at = {31e-3, 18e-3, 0.76e-3, 2.06e11, 0.28, 2500.0};
  std::array<DualReal, 6> dual;
  for (std::size_t k = 0; k < at.size(); ++k) {
    dual[k] = at[k];
    dual[k].partial[k] = at[k];
  }
  for (const ClampedEdge clamped : {ClampedEdge::inner, ClampedEdge::outer}) {
    const DualReal found = stiffness(dual, clamped);
    for (std::size_t k = 0; k < at.size(); ++k) {
      constexpr double kStep = 1e-5;
      std::array<double, 6> more = at;
      std::array<double, 6> less = at;
      more[k] *= 1 + kStep;
      less[k] *= 1 - kStep;
      EXPECT_NEAR(found.partial[k],
                  (stiffness(more, clamped) - stiffness(less, clamped)) / (2 * kStep),
                  1e-8 * found.value)
          << k;
    }
  }
}

TEST(PlateEdge, ScalingIsForcePerLength) {
  for (const int n : {2, 7})
    test::expect_dimensionally_consistent(
        "N/m",
        [=](double r_o, double r_i, double h, double E) {
          return plate_edge_stiffness(ClampedPlate{.outer_radius = r_o,
                                                   .inner_radius = r_i,
                                                   .thickness = h,
                                                   .youngs_modulus = E,
                                                   .poissons_ratio = 0.3},
                                      n);
        },
        Arg{kPlate.outer_radius, "m"}, Arg{kPlate.inner_radius, "m"}, Arg{kPlate.thickness, "m"},
        Arg{kPlate.youngs_modulus, "Pa"});
}

// --- input --------------------------------------------------------------------------------------

TEST(PlateEdge, InputRulesBrokenOnce) {
  const auto field = [](const ClampedPlate& plate, int n) -> std::string {
    try {
      (void)plate_edge_stiffness(plate, n);
    } catch (const InputError& error) {
      return error.field();
    }
    return "accepted";
  };
  EXPECT_EQ(field(kPlate, 2), "accepted");
  for (const int n : {1, 0, -2}) EXPECT_EQ(field(kPlate, n), "harmonic");
  ClampedPlate plate = kPlate;
  for (const double r : {0.0, -1e-3, kPlate.outer_radius, 1.0}) {
    plate.inner_radius = r;
    EXPECT_EQ(field(plate, 2), "inner_radius") << r;
  }
  plate = kPlate;
  for (const double h : {0.0, -1e-3}) {
    plate.thickness = h;
    EXPECT_EQ(field(plate, 2), "thickness") << h;
  }
}

TEST(PlateEdge, InputDefaults) {
  const ClampedPlate plate;
  EXPECT_EQ(plate.outer_radius, 0.0);
  EXPECT_EQ(plate.inner_radius, 0.0);
  EXPECT_EQ(plate.thickness, 0.0);
  EXPECT_EQ(plate.youngs_modulus, 0.0);
  EXPECT_EQ(plate.poissons_ratio, 0.3);
}

}  // namespace
}  // namespace strainwave
