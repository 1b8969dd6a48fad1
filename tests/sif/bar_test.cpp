// SPDX-License-Identifier: Apache-2.0
//
// Annular and penny-shaped cracks in round bars; cracks on one side are in bar_one_sided_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "sif/solution_support.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/bar/bar_annular.hpp"
#include "strainwave/sif/bar/hollow_annular_inner.hpp"
#include "strainwave/sif/bar/hollow_annular_outer.hpp"
#include "strainwave/sif/bar/penny_crack.hpp"
#include "strainwave/sif/evaluation.hpp"
#include "strainwave/sif/library.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave::sif {
namespace {

using test::limits_broken;
using test::Texts;

using std::numbers::pi;
constexpr double kNu = 0.3;
constexpr double kHalfPlaneEdge = 1.12152;  // edge crack of a half-plane, exact to its digits

HollowAnnularOuterCrack outer(double ratio, double alpha) {
  HollowAnnularOuterCrack crack;
  crack.outer_diameter = 2.0;
  crack.inner_diameter = 2 * ratio;
  crack.depth = alpha * (1 - ratio);
  return crack;
}
HollowAnnularInnerCrack inner(double ratio, double alpha) {
  HollowAnnularInnerCrack crack;
  crack.outer_diameter = 2.0;
  crack.inner_diameter = 2 * ratio;
  crack.depth = alpha * (1 - ratio);
  return crack;
}
BarAnnularCrack solid(double alpha) {
  BarAnnularCrack crack;
  crack.diameter = 2.0;
  crack.depth = alpha;
  return crack;
}
BarPennyCrack penny(double x) {
  BarPennyCrack crack;
  crack.diameter = 2.0;
  crack.radius = x;
  return crack;
}

/// K/(nominal stress at `radius` sqrt(pi a)) at theta = 0, written out: r_o = 1.
template <class Crack>
double factor(const Crack& crack, std::size_t load, double ratio, double radius) {
  const auto k = crack.stress_intensity(crack.size(), 0.0);
  const double fourth = 1 - std::pow(ratio, 4);
  const double root = std::sqrt(pi * crack.size());
  if (load == kForce) return k.I[kForce] * pi * (1 - ratio * ratio) / root;
  if (load == kMoment) return k.I[kMoment] * pi / 4 * fourth / radius / root;
  return k.III[kTorque] * pi / 2 * fourth / radius / root;
}

std::size_t load_of(const std::string& name) {
  return name == "tension" ? kForce : name == "bending" ? kMoment : kTorque;
}

/// Added compliance of one load for E = 1 (modes I, II) and mu = 1 (mode III).
template <class Crack>
double compliance(const Crack& crack, std::size_t load) {
  const auto added = added_compliance(crack, {.opening = 1 / (1 - kNu * kNu), .shear = 1.0});
  EXPECT_TRUE(added.converged);
  return added.matrix(load, load);
}

// (SB-1) to (SB-6) against finite elements between the nodes of the tables, which are built from
// energy derivatives of the same program: the tolerance is that of the interpolation, 0.12 %.  The
// rows ".energy" are its energies, which were not used for the tables; integrating K^2 must
// reproduce them.
TEST(BarAnnular, ReferenceFourierElements) {
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("annular_fourier")) {
    const std::string& name = row.quantity;
    const std::size_t dot = name.find('.');
    const std::string crack = name.substr(0, dot);
    const bool energy = name.ends_with(".energy");
    const std::size_t load = load_of(name.substr(dot + 1, 7));
    const double rho = row("radius_ratio");
    const double alpha = row("depth_ratio");
    const double area = pi * (1 - rho * rho);
    const double inertia = pi / 4 * (1 - std::pow(rho, 4));
    const std::array<double, 3> section{area, inertia, 2 * inertia};
    const auto check = [&](const auto& c, double radius) {
      if (energy)
        test::expect_row(compliance(c, load) * section[load] * section[load], row, 1e-3);
      else
        test::expect_row(factor(c, load, rho, radius), row, 1.2e-3);
    };
    ++seen[crack];
    if (crack == "outer") check(outer(rho, alpha), 1.0);
    if (crack == "inner") check(inner(rho, alpha), rho + alpha * (1 - rho));
    if (crack == "solid") check(solid(alpha), 1.0);
    if (crack == "penny") check(penny(alpha), alpha);
  }
  EXPECT_EQ(seen.size(), 5U);  // the strip is tested below
  EXPECT_EQ(seen["inner"], 51);
  EXPECT_EQ(seen["outer"], 17);
}

// (SB-3): the shallow crack is an edge crack, the deep one a neck between two half-spaces, whose
// pressure under a moment, 3 M x/(2 pi c^3 sqrt(c^2 - r^2)), gives K = 3 M sqrt(pi/c)/(2 pi c^2).
TEST(BarAnnular, LimitShallowAndNeck) {
  EXPECT_NEAR(BarAnnularCrack::bending_factor(1.0), kHalfPlaneEdge, 1e-5);
  for (const double c : {0.01, 0.001}) {
    const BarAnnularCrack crack = solid(1 - c);
    const double neck = 3 * std::sqrt(pi / c) / (2 * pi * c * c);
    // p_2 = 1 + x/2 + ... and sqrt(1 - x) = 1 - x/2 - ...: the next term is of order x^2.
    test::expect_relative(crack.stress_intensity(1 - c, 0.0).I[kMoment], neck, c * c);
  }
}

// (SB-3) and Tada's polynomial, which ends at 1.1243 and differs by up to 3.8 % in between.
TEST(BarAnnular, CrosscheckHandbookPolynomial) {
  for (const double x : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double tada = 1 + x / 2 + 3 * x * x / 8 + 5 * std::pow(x, 3) / 16 +
                        35 * std::pow(x, 4) / 128 + 0.537 * std::pow(x, 5);
    const double ours = BarAnnularCrack::bending_factor(x) * 8 / 3 * std::pow(x, 2.5);
    EXPECT_NEAR(ours / tada, 1.0, x < 0.4 ? 2e-3 : 0.04) << x;
  }
}

// Force and torque are those of the two-load crack of the fracture module, (FR-12) to (FR-16).
TEST(BarAnnular, IdentityTwoLoadCracks) {
  for (const double theta : {0.0, 1.0, pi}) {
    const BarAnnularCrack crack = solid(0.3);
    const sif::AnnularCrackSolid two{.depth = 0.3, .diameter = 2.0};
    const auto k = crack.stress_intensity(0.2, theta);
    const auto k2 = two.stress_intensity(0.2, 0.0);
    EXPECT_EQ(k.I[kForce], k2.I[0]);
    EXPECT_EQ(k.III[kTorque], k2.III[1]);
    const HollowAnnularOuterCrack hollow = outer(0.6, 0.5);
    const sif::AnnularCrackHollow hollow2({.depth = 0.2, .outer_radius = 1.0, .inner_radius = 0.6});
    const auto h = hollow.stress_intensity(0.1, theta);
    const auto h2 = hollow2.stress_intensity(0.1, 0.0);
    test::expect_relative(h.I[kForce], h2.I[0], 1e-14);
    test::expect_relative(h.III[kTorque], h2.III[1], 1e-14);
  }
}

// (SB-2): K_I of the moment is a first harmonic and does not couple with other loads.
TEST(BarAnnular, IdentityFirstHarmonic) {
  const auto check = [](const auto& crack) {
    const double a = crack.size();
    const double pulled = crack.stress_intensity(a, 0.0).I[kMoment];
    EXPECT_GT(pulled, 0);
    for (const double theta : {0.5, 1.5, 2.5, pi})
      test::expect_relative(crack.stress_intensity(a, theta).I[kMoment], pulled * std::cos(theta),
                            1e-14);
    const auto k = crack.stress_intensity(a, 0.4);
    EXPECT_EQ(k.III[kForce], 0);
    EXPECT_EQ(k.III[kMoment], 0);
    EXPECT_EQ(k.I[kTorque], 0);
    for (const double mode_II : k.II) EXPECT_EQ(mode_II, 0);
    const auto m = added_compliance(crack, {.opening = 1.0, .shear = 1.0}).matrix;
    const double size = std::sqrt(m(kForce, kForce) * m(kMoment, kMoment));
    EXPECT_NEAR(m(kForce, kMoment), 0.0, 1e-9 * size);
    EXPECT_EQ(m(kForce, kTorque), 0.0);
  };
  check(solid(0.3));
  check(outer(0.6, 0.4));
  check(inner(0.6, 0.4));
  check(penny(0.4));
}

// The fronts sweep rings and a disc.
TEST(BarAnnular, IdentitySweptArea) {
  const auto swept = [](const auto& crack) {
    const FrontRange front = crack.front();
    return integrate([&](double a) { return crack.swept_area(a, 0.0) * (front.end - front.begin); },
                     0.0, crack.size())
        .value;
  };
  test::expect_relative(swept(solid(0.3)), pi * (1 - 0.49), 1e-12);
  test::expect_relative(swept(outer(0.6, 0.5)), pi * (1 - 0.64), 1e-12);
  test::expect_relative(swept(inner(0.6, 0.5)), pi * (0.64 - 0.36), 1e-12);
  test::expect_relative(swept(penny(0.4)), pi * 0.16, 1e-12);
}

// (SB-4), (SB-5): shallow cracks are edge cracks, antiplane ones in torsion.
TEST(HollowAnnular, LimitShallow) {
  for (const double rho : {0.1, 0.4, 0.9}) {
    const double a = 1e-9;
    EXPECT_NEAR(factor(outer(rho, a), kMoment, rho, 1.0), kHalfPlaneEdge, 1e-5) << rho;
    EXPECT_NEAR(factor(inner(rho, a), kForce, rho, rho), kHalfPlaneEdge, 1e-5) << rho;
    EXPECT_NEAR(factor(inner(rho, a), kMoment, rho, rho), kHalfPlaneEdge, 1e-5) << rho;
    EXPECT_NEAR(factor(inner(rho, a), kTorque, rho, rho), 1.0, 1e-5) << rho;
  }
}

// (SB-5) in torsion: a thin wall is a strip under antiplane shear, exactly
// sqrt(tan(pi alpha/2)/(pi alpha/2)).  The next term is of the order of the wall over the radius.
TEST(HollowAnnular, LimitAntiplaneStrip) {
  for (const double alpha : {0.2, 0.5, 0.75}) {
    const double strip = std::sqrt(std::tan(pi * alpha / 2) / (pi * alpha / 2));
    EXPECT_NEAR(annular_inner(alpha, 1.0)[kTorque], strip, 2e-4 * strip) << alpha;
    EXPECT_NEAR(annular_inner(alpha, 0.999)[kTorque], strip, 3e-3 * strip) << alpha;
  }
}

// (SB-4), (SB-5): the limit of a thin wall under force or moment is the edge-cracked strip, free to
// rotate.  It is reached slowly, with the root of wall over radius, and from below, because hoop
// stiffness of the wall resists its rotation.  The strip values are finite elements of this
// program, and (FR-11) from other programs.
TEST(HollowAnnular, LimitFreeStrip) {
  for (const test::CsvRow& row : test::read_reference_csv("annular_fourier")) {
    if (row.quantity != "strip.tension") continue;
    const double alpha = row("depth_ratio");
    test::expect_row(annular_outer_bending(alpha, 1.0), row, 2e-3);
    test::expect_row(annular_inner(alpha, 1.0)[kForce], row, 2e-3);
    test::expect_row(annular_inner(alpha, 1.0)[kMoment], row, 2e-3);
    test::expect_relative(sif::edge_crack_factor(sif::StripLoading::tension, alpha), row.value,
                          3e-4);
  }
  for (const double alpha : {0.3, 0.6}) {
    double previous = 0.0;
    for (const double rho : {0.9, 0.97, 0.99, 0.999}) {
      const double F = annular_inner(alpha, rho)[kForce];
      EXPECT_GT(F, previous) << rho;
      EXPECT_LT(F, sif::edge_crack_factor(sif::StripLoading::tension, alpha)) << rho;
      previous = F;
      // Force and moment cause the same tension in a thin wall; the difference is proportional to
      // its thickness.
      EXPECT_NEAR(annular_inner(alpha, rho)[kMoment] / F, 1.0, 1 - rho) << rho;
      if (rho <= 0.95) {
        const double force = factor(outer(rho, alpha), kForce, rho, 1.0);
        EXPECT_NEAR(annular_outer_bending(alpha, rho) / force, 1.0, 1 - rho);
      }
    }
  }
}

// (SB-4) at r_i = 0 is the solid bar (SB-3): the tables are from the same elements but fitted
// separately.
TEST(HollowAnnular, LimitSolid) {
  for (const double alpha : {0.1, 0.3, 0.5, 0.7, 0.8})
    test::expect_relative(annular_outer_bending(alpha, 0.0),
                          BarAnnularCrack::bending_factor(1 - alpha), 1.5e-3);
}

// (SB-6): factors of the penny in an unbounded body: 2/pi, and 4/(3 pi) under a linear stress,
// normal or shear.
TEST(BarPenny, LimitSmall) {
  for (const double x : {1e-6, 0.05}) {
    EXPECT_NEAR(factor(penny(x), kForce, 0.0, x), 2 / pi, 1e-4);
    EXPECT_NEAR(factor(penny(x), kMoment, 0.0, x), 4 / (3 * pi), 1e-4);
    EXPECT_NEAR(factor(penny(x), kTorque, 0.0, x), 4 / (3 * pi), 1e-4);
  }
  // Energy of the penny, 8 (1 - nu^2) sigma^2 a^3/(3 E): half of the compliance times P^2.
  const double a = 0.02;
  test::expect_relative(compliance(penny(a), kForce) * pi * pi / 2,
                        8.0 / 3 * (1 - kNu * kNu) * a * a * a, 2e-4);
}

/// The fields whose rules are broken; all rules concern lengths.
template <class Crack>
Texts lengths_broken(const Crack& crack) {
  crack.check(
      [&](bool, std::string_view, double value, std::string_view unit, std::string_view rule) {
        EXPECT_FALSE(rule.empty());
        EXPECT_EQ(unit, "m");
        EXPECT_GT(value, 0);
      });
  return test::rules_broken(crack);
}

TEST(BarAnnular, InputRules) {
  EXPECT_EQ(lengths_broken(solid(0.99)), Texts{});
  EXPECT_EQ(lengths_broken(solid(1.0)), Texts{"depth"});
  EXPECT_EQ(lengths_broken(penny(0.99)), Texts{});
  EXPECT_EQ(lengths_broken(penny(1.0)), Texts{"radius"});
  EXPECT_EQ(lengths_broken(outer(0.5, 0.8)), Texts{});
  EXPECT_EQ(lengths_broken(outer(0.5, 0.81)), Texts{"depth"});
  EXPECT_EQ(lengths_broken(inner(0.5, 0.8)), Texts{});
  EXPECT_EQ(lengths_broken(inner(0.5, 0.81)), Texts{"depth"});
  EXPECT_EQ(lengths_broken(inner(0.09, 0.5)), Texts{"inner_diameter"});
  EXPECT_EQ(lengths_broken(outer(0.96, 0.5)), Texts{"inner_diameter"});
  HollowAnnularInnerCrack inside_out = inner(0.5, 0.5);
  inside_out.outer_diameter = 0.5;
  EXPECT_EQ(lengths_broken(inside_out), (Texts{"inner_diameter", "depth"}));
  EXPECT_EQ(lengths_broken(inner(0.05, 0.5)), Texts{"inner_diameter"});
  EXPECT_THROW(static_cast<void>(solution("bar-annular").make({{"depth", 0.02}})), InputError);
}

TEST(BarAnnular, InputValidity) {
  EXPECT_EQ(limits_broken(solid(0.95)).size(), 0U);
  EXPECT_EQ(limits_broken(solid(0.97)).size(), 1U);
  EXPECT_EQ(limits_broken(penny(0.9)).size(), 0U);
  EXPECT_EQ(limits_broken(penny(0.91)).size(), 1U);
  EXPECT_EQ(limits_broken(outer(0.0, 0.5)).size(), 0U);
  EXPECT_EQ(limits_broken(inner(0.98, 0.5)).size(), 0U);
  EXPECT_EQ(limits_broken(inner(0.985, 0.5)).size(), 1U);
}

// (SB-1): the nominal stress that Y refers to, at the surface or at the front.
TEST(BarAnnular, IdentityGrossStress) {
  const double area = pi * 0.75;
  const double inertia = pi / 4 * 0.9375;
  test::expect_relative(outer(0.5, 0.1).gross_stress(kForce), 1 / area, 1e-14);
  test::expect_relative(outer(0.5, 0.1).gross_stress(kMoment), 1 / inertia, 1e-14);
  test::expect_relative(outer(0.5, 0.1).gross_stress(kTorque), 0.5 / inertia, 1e-14);
  test::expect_relative(inner(0.5, 0.1).gross_stress(kForce), 1 / area, 1e-14);
  test::expect_relative(inner(0.5, 0.1).gross_stress(kMoment), 0.55 / inertia, 1e-14);
  test::expect_relative(inner(0.5, 0.1).gross_stress(kTorque), 0.275 / inertia, 1e-14);
  test::expect_relative(inner(0.5, 0.1).gross_stress(kTorque, 0.2), 0.35 / inertia, 1e-14);
  test::expect_relative(solid(0.1).gross_stress(kMoment), 4 / pi, 1e-14);
  test::expect_relative(penny(0.1).gross_stress(kMoment), 0.4 / pi, 1e-14);
}

// (SB-5), (SB-6): the printed Y is the factor of the manual's equation, which refers to the stress
// at the front, for every load and size.
TEST(BarAnnular, IdentityYIsTheFactorOfTheManual) {
  for (const double x : {0.05, 0.2, 0.5, 0.9}) {
    const Evaluation e =
        evaluate(solution("bar-penny"), {{"radius", x * 0.01}, {"diameter", 0.02}});
    const std::array<double, 3> F = penny_in_bar(x);
    for (const GeometryFactors& factor : e.factors) {
      if (factor.point != "pulled") continue;
      const std::size_t load = factor.load == "force"    ? kForce
                               : factor.load == "moment" ? kMoment
                                                         : kTorque;
      test::expect_relative(load == kTorque ? factor.Y_III : factor.Y_I, F[load], 1e-12);
    }
  }
  for (const double alpha : {0.1, 0.5, 0.8}) {
    const Evaluation e =
        evaluate(solution("hollow-annular-inner"),
                 {{"depth", alpha * 0.01}, {"outer_diameter", 0.04}, {"inner_diameter", 0.02}});
    const std::array<double, 3> F = annular_inner(alpha, 0.5);
    for (const GeometryFactors& factor : e.factors) {
      if (factor.point != "pulled") continue;
      const std::size_t load = factor.load == "force"    ? kForce
                               : factor.load == "moment" ? kMoment
                                                         : kTorque;
      test::expect_relative(load == kTorque ? factor.Y_III : factor.Y_I, F[load], 1e-12);
    }
  }
  // Both name the place of the stress; K is unchanged.
  for (const char* const name : {"bar-penny", "hollow-annular-inner"})
    EXPECT_NE(solution(name).info.reference_stress.find("at the front"), std::string_view::npos);
}

}  // namespace
}  // namespace strainwave::sif
