// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/flank.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "strainwave/core/quadrature.hpp"
#include "strainwave/core/units.hpp"
#include "support/expect.hpp"
#include "support/reference.hpp"
#include "support/reference_csv.hpp"
#include "support/scaling.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 22 * deg reads as it should
using std::numbers::pi;
using test::Arg;

// --- gap of the flanks (TC-7) --------------------------------------------------------------------

TEST(FlankGap, ReferenceTable) {
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("coupled_drive_laws")) {
    if (row.quantity != "gap_over_radial_displacement") continue;
    // Rounding: two differences of numbers of about 1 leave a gap of 0.005 at 5 degrees.
    test::expect_row(flank_gap(row("angle"), 0.4 * mm, 22 * deg, 1.0) / (0.4 * mm), row, 1e-13);
    ++rows;
  }
  EXPECT_EQ(rows, 9);
}

TEST(FlankGap, ReferenceThirtyDegreesByHand) {
  // (1 - 1/2) sin 22 -+ (pi/6 - sqrt(3)/4) cos 22, with a desk calculator.
  for (const auto& [t, gap] : {std::pair{30 * deg, 0.1033134}, {-30 * deg, 0.2712932}})
    test::expect_reference(flank_gap(t, 1.0, 22 * deg, 1.0),
                           {.value = gap,
                            .unit = "w_0",
                            .relative_tolerance = 5e-7,
                            .source = "design note, verification case 11",
                            .tolerance_is = "seven digits printed"});
}

TEST(FlankGap, IdentityFactorAndDisplacementMultiply) {
  for (const double t : {-0.7, -0.2, 0.1, 0.5}) {
    const double gap = flank_gap(t, 1.0, 22 * deg, 1.0);
    test::expect_relative(flank_gap(t, 0.3, 22 * deg, 1.0), 0.3 * gap, 1e-15);
    test::expect_relative(flank_gap(t, 1.0, 22 * deg, 1.7), 1.7 * gap, 1e-15);
    EXPECT_EQ(flank_gap(t, 1.0, 22 * deg, 0.0), 0.0);
  }
}

TEST(FlankGap, IdentityHalfSumAndHalfDifferenceOfTheSides) {
  // The lift is even about the lobe, and the drift is odd.
  const double alpha = 25 * deg;
  for (const double t : {0.1, 0.3, 0.6}) {
    const double drive = flank_gap(t, 1.0, alpha, 1.0);
    const double coast = flank_gap(-t, 1.0, alpha, 1.0);
    test::expect_relative((coast + drive) / 2, 2 * std::pow(std::sin(t), 2) * std::sin(alpha),
                          1e-14);
    test::expect_relative((coast - drive) / 2, (t - std::sin(t) * std::cos(t)) * std::cos(alpha),
                          1e-13);
  }
}

TEST(FlankGap, LimitNearTheLobe) {
  EXPECT_EQ(flank_gap(0.0, 1.0, 22 * deg, 1.0), 0.0);
  // 2 t^2 sin(alpha) - (2/3) t^3 cos(alpha), the next term is of order t^4.
  for (const double t : {-0.02, -0.01, 0.01, 0.02}) {
    const double two_terms =
        2 * t * t * std::sin(22 * deg) - 2.0 / 3 * t * t * t * std::cos(22 * deg);
    EXPECT_NEAR(flank_gap(t, 1.0, 22 * deg, 1.0), two_terms, std::pow(t, 4));
  }
}

TEST(FlankGap, LimitNeverNegative) {
  // For flanks that are steeper than the path, the gap is cut off at zero on the drive side and
  // open on the other.
  for (const double t : {0.2, 0.5, 0.78}) {
    EXPECT_EQ(flank_gap(t, 1.0, 1 * deg, 1.0), 0.0);
    EXPECT_GT(flank_gap(-t, 1.0, 1 * deg, 1.0), 0.0);
  }
}

TEST(FlankGap, ScalingIsALength) {
  test::expect_dimensionally_consistent(
      "m", [](double w0) { return flank_gap(0.3, w0, 22 * deg, 1.0); }, Arg{4e-4, "m"});
}

// --- flank angle that the path needs (TC-25) -----------------------------------------------------

TEST(LeastFlankAngle, ReferenceTable) {
  int rows = 0;
  for (const test::CsvRow& row : test::read_reference_csv("coupled_drive_laws")) {
    const std::string name = "least_flank_angle_";
    if (!row.quantity.starts_with(name)) continue;
    test::expect_row(least_flank_angle(std::stod(row.quantity.substr(name.size()))), row, 2e-15);
    ++rows;
  }
  EXPECT_EQ(rows, 3);
}

TEST(LeastFlankAngle, ReferencePrintedDegrees) {
  for (const auto& [kappa, degrees] : {std::pair{0.6, 33.69}, {0.7, 27.03}, {0.8, 20.56}})
    EXPECT_NEAR(least_flank_angle(kappa) / deg, degrees, 0.005);  // digits printed
}

TEST(LeastFlankAngle, CrosscheckSteepestTangentOfThePath) {
  // Path of a tooth tip over the wave, in modules: 2 kappa cos^2 on top of a drift of (kappa - 1)
  // per radian; the flank angle must be at least that of the steepest tangent against the radius.
  for (const double kappa : {0.6, 0.75, 0.9}) {
    double least = pi / 2;
    for (int i = 1; i < 20000; ++i) {
      const double t = pi / 2 * i / 20000;
      const double across = 1 - kappa * std::cos(2 * t);  // d(tangential)/dt, over the module
      const double radial = 2 * kappa * std::sin(2 * t);
      least = std::min(least, std::atan(across / radial));
    }
    EXPECT_NEAR(least_flank_angle(kappa), least, 1e-7);  // grid of the search
  }
}

TEST(LeastFlankAngle, LimitFullPath) {
  EXPECT_EQ(least_flank_angle(1.0), 0.0);
  EXPECT_EQ(least_flank_angle(1.2), 0.0);
  // Below kappa = 1 the angle is sqrt(2 (1 - kappa))/2; the next term is of relative order 1 -
  // kappa.
  const double e = 1e-6;
  EXPECT_NEAR(least_flank_angle(1 - e) / (std::sqrt(2 * e) / 2), 1, 2 * e);
}

// --- stiffness of a pair (TC-9) ------------------------------------------------------------------

TEST(ToothPair, ReferenceTableOfDrives) {
  int rows = 0;
  std::map<std::pair<double, double>, std::map<std::string, double>> drives;
  for (const test::CsvRow& row : test::read_reference_csv("coupled_drive_members")) {
    auto& drive = drives[{row("size"), row("ratio")}];
    if (row.quantity.starts_with("input.")) drive[row.quantity.substr(6)] = row.value;
    if (row.quantity != "pair_stiffness") continue;
    test::expect_row(tooth_pair_stiffness(drive.at("youngs_modulus"),
                                          drive.at("pitch_diameter") / (2 * drive.at("ratio")),
                                          drive.at("rim_thickness")),
                     row, 1e-14);
    ++rows;
  }
  EXPECT_EQ(rows, 11);
}

TEST(ToothPair, CrosscheckFiniteElementsOfATooth) {
  // The tooth of the flexspline alone, plane strain, E = 206 GPa: 2.10, 2.91, 4.45e-5 mm^2/N at
  // t_r/m = 2.4, 1.0, 0.53.  The remaining terms of the pair, 3.605 + 2.472, are the same in all
  // three cases; the fit claims 2 %.
  const double E = 206 * GPa;
  for (const auto& [ratio, compliance] :
       {std::pair{2.4, 2.10e-5}, {1.0, 2.91e-5}, {0.53, 4.45e-5}}) {
    const double pair = E / tooth_pair_stiffness(E, 1.0, ratio);
    EXPECT_NEAR((pair - 3.605 - 2.472) / (206e3 * compliance), 1, 0.08) << ratio;
  }
}

TEST(ToothPair, LimitThickRim) {
  EXPECT_NEAR(tooth_pair_stiffness(1.0, 1.0, 1e9) * 9.373, 1, 1e-9);  // next term m/t_r
}

TEST(ToothPair, ScalingIsAModulus) {
  test::expect_dimensionally_consistent(
      "Pa", [](double E, double m, double t) { return tooth_pair_stiffness(E, m, t); },
      Arg{2.06e11, "Pa"}, Arg{3e-4, "m"}, Arg{7e-4, "m"});
}

// --- force of a pair (TC-8) ----------------------------------------------------------------------

constexpr FlankLaw kLaw{.pair_stiffness = 19e9, .face_width = 9.5e-3, .slope = 5.4e-3};
// closing at which the whole face touches, 51 um
constexpr double kWhole = kLaw.slope * kLaw.face_width;

TEST(FlankLaw, IdentityNothingBeforeItTouches) {
  for (const double u : {-1.0, -1e-6, -0.0, 0.0}) {
    EXPECT_EQ(kLaw.force(u), 0.0);
    EXPECT_EQ(kLaw.stiffness(u), 0.0);
    EXPECT_EQ(kLaw.energy(u), 0.0);
  }
}

TEST(FlankLaw, IdentityContinuousWhereTheWholeFaceTouches) {
  // The limits are c' s b^2/2, c' b, c' s^2 b^3/6 from both sides.
  const double c = kLaw.pair_stiffness;
  const double b = kLaw.face_width;
  const double s = kLaw.slope;
  for (const double u : {kWhole * (1 - 1e-14), kWhole, kWhole * (1 + 1e-14)}) {
    test::expect_relative(kLaw.force(u), c * s * b * b / 2, 1e-13);
    test::expect_relative(kLaw.stiffness(u), c * b, 1e-13);
    test::expect_relative(kLaw.energy(u), c * s * s * b * b * b / 6, 1e-13);
  }
}

TEST(FlankLaw, CrosscheckSlicesOfTheFace) {
  // A slice of the face at distance y closes by u - s y.
  for (const double share : {0.1, 0.5, 0.999, 1.5, 4.0}) {
    const double u = share * kWhole;
    const double touching = std::min(kLaw.face_width, u / kLaw.slope);
    const auto slices = [&](auto f) { return integrate(f, 0.0, touching, {}).value; };
    test::expect_relative(
        kLaw.force(u), kLaw.pair_stiffness * slices([&](double y) { return u - kLaw.slope * y; }),
        1e-12);
    test::expect_relative(kLaw.energy(u), kLaw.pair_stiffness / 2 * slices([&](double y) {
                                            return std::pow(u - kLaw.slope * y, 2);
                                          }),
                          1e-12);
    test::expect_relative(kLaw.stiffness(u), kLaw.pair_stiffness * touching, 1e-14);
  }
}

TEST(FlankLaw, IdentityDerivatives) {
  // Both laws are cubics at most and smooth on either side: the error of a central difference is
  // h^2/6 times the third derivative, plus rounding 1e-16/h.
  for (const double share : {0.2, 0.7, 1.3, 3.0}) {
    const double u = share * kWhole;
    const double h = 1e-4 * kWhole;
    test::expect_relative((kLaw.force(u + h) - kLaw.force(u - h)) / (2 * h), kLaw.stiffness(u),
                          1e-11);
    test::expect_relative((kLaw.energy(u + h) - kLaw.energy(u - h)) / (2 * h), kLaw.force(u), 1e-7);
  }
}

TEST(FlankLaw, LimitNoSlope) {
  FlankLaw flat = kLaw;
  flat.slope = 0.0;
  FlankLaw almost = kLaw;
  almost.slope = 1e-12;
  for (const double u : {1e-7, 1e-5, 1e-3}) {
    const double k = kLaw.pair_stiffness * kLaw.face_width;
    test::expect_relative(flat.force(u), k * u, 1e-15);
    EXPECT_EQ(flat.stiffness(u), k);
    test::expect_relative(flat.energy(u), k * u * u / 2, 1e-15);
    // The next term is s b/(2u) for the force and s b/u for the energy.
    const double next = almost.slope * kLaw.face_width / u;
    EXPECT_NEAR(almost.force(u) / flat.force(u), 1, next);
    EXPECT_NEAR(almost.energy(u) / flat.energy(u), 1, 1.1 * next);
  }
  EXPECT_EQ(flat.force(0.0), 0.0);
  EXPECT_EQ(flat.stiffness(-1e-9), 0.0);
}

TEST(FlankLaw, ScalingForceStiffnessEnergy) {
  for (const double u : {0.4 * kWhole, 2 * kWhole}) {
    const auto with = [](auto f) {
      return [f](double c, double b, double closing) {
        return f(FlankLaw{.pair_stiffness = c, .face_width = b, .slope = kLaw.slope}, closing);
      };
    };
    const auto check = [&](std::string_view unit, auto f) {
      test::expect_dimensionally_consistent(unit, with(f), Arg{kLaw.pair_stiffness, "Pa"},
                                            Arg{kLaw.face_width, "m"}, Arg{u, "m"});
    };
    check("N", [](const FlankLaw& law, double x) { return law.force(x); });
    check("N/m", [](const FlankLaw& law, double x) { return law.stiffness(x); });
    check("J", [](const FlankLaw& law, double x) { return law.energy(x); });
  }
}

TEST(FlankLaw, InputDefaults) {
  const FlankLaw law;
  EXPECT_EQ(law.pair_stiffness, 0.0);
  EXPECT_EQ(law.face_width, 0.0);
  EXPECT_EQ(law.slope, 0.0);
}

}  // namespace
}  // namespace strainwave
