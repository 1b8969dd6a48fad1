// SPDX-License-Identifier: Apache-2.0
// Elliptical cracks in plates and bodies: (SP-1) to (SP-3), (SP-16) to (SP-21).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <type_traits>

#include "sif/solution_support.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/newman_raju.hpp"
#include "strainwave/sif/plate/body_ellipse.hpp"
#include "strainwave/sif/plate/body_penny.hpp"
#include "strainwave/sif/plate/corner_crack.hpp"
#include "strainwave/sif/plate/embedded_ellipse.hpp"
#include "strainwave/sif/plate/plate_surface.hpp"
#include "strainwave/sif/plate/strip_factors.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"

namespace strainwave::sif {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;
using test::limits_broken;
using test::rules_broken;
using test::Texts;

/// A crack of depth 1 with the given shape and relative depth, in a plate with the given c/b.
PlateSurfaceCrack surface(double rho, double alpha, double c_b) {
  return {.depth = 1, .half_length = 1 / rho, .thickness = 1 / alpha, .half_width = 1 / rho / c_b};
}
PlateCornerCrack corner(double rho, double alpha, double c_b) {
  return {.depth = 1, .length = 1 / rho, .thickness = 1 / alpha, .width = 1 / rho / c_b};
}
PlateEllipse embedded(double rho, double alpha, double c_b) {
  return {
      .half_depth = 1, .half_length = 1 / rho, .thickness = 2 / alpha, .half_width = 1 / rho / c_b};
}

// --- finite elements: every branch -----------------------------------------------------------

/// K_I/(sigma sqrt(pi a)) of tension and bending, for the crack with a given name in the table.
std::array<double, 2> factors(const std::string& quantity, double rho, double alpha, double c_b,
                              double phi) {
  const double root = std::sqrt(pi);
  if (quantity.starts_with("embedded"))
    return {embedded(rho, alpha, c_b).stress_intensity(1, phi).I[0] / root, 0.0};
  const auto k = quantity.starts_with("surface")
                     ? surface(rho, alpha, c_b).stress_intensity(1, phi).I
                     : corner(rho, alpha, c_b).stress_intensity(1, phi).I;
  return {k[0] / root, k[1] / root};
}

TEST(PlateSolid, ReferenceNewmanRaju) {
  // (SP-1), (SP-2), (SP-3), (SP-16), (SP-17), (SP-18) as printed in the report (secondary), both
  // branches, from tools/reference/newman_raju.py.
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("newman_raju")) {
    const auto [tension, bending] = factors(row.quantity, row("aspect_ratio"), row("depth_ratio"),
                                            row("width_ratio"), row("front_angle"));
    // The tolerance is rounding; the terms of bending cancel to a tenth.
    EXPECT_NEAR(row.quantity.ends_with("tension") ? tension : bending, row.value, 1e-13 * tension)
        << row.place;
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen.size(), 5U);
  for (const auto& [name, n] : seen) EXPECT_EQ(n, 60) << name;
}

/// Model form: difference of Newman and Raju's fits from finite elements (which are 1 % low),
/// relative to the tension at the same point.
double difference_allowed(const std::string& quantity, double rho, double alpha, double phi) {
  const bool bending = quantity.ends_with("bending");
  const bool vertex = phi < 0.1 || phi > 1.5;  // where K does not exist except by symmetry
  if (quantity.starts_with("embedded")) return rho < 0.3 ? 0.09 : 0.035;
  if (quantity.starts_with("surface")) {
    if (phi < 0.1) return bending ? 0.065 : 0.035;
    if (bending) return 0.055;
    return alpha > 0.7 && phi > 1.1 ? 0.105 : 0.05;
  }
  if (rho < 0.3 || alpha > 0.7) return bending ? 0.17 : 0.25;  // outside the validity range
  if (bending) return 0.08;
  return vertex ? 0.15 : 0.10;
}

TEST(PlateSolid, CrosscheckFiniteElements) {
  // tools/reference/cracked_block.py, c/b = 0.2: four shapes, a/c = 0.25, 0.5, 1 and 2, and three
  // depths, a/t = 0.2, 0.5 and 0.8.
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("cracked_block")) {
    const double rho = row("aspect_ratio");
    const double alpha = row("depth_ratio");
    const double phi = row("front_angle");
    const auto [tension, bending] = factors(row.quantity, rho, alpha, 0.2, phi);
    const bool bent = row.quantity.ends_with("bending");
    EXPECT_NEAR(bent ? bending : tension, row.value,
                difference_allowed(row.quantity, rho, alpha, phi) * (bent ? tension : row.value))
        << row.quantity << " rho " << rho << " alpha " << alpha << " phi " << phi;
    ++seen[row.quantity];
  }
  EXPECT_EQ(seen.size(), 5U);
  for (const auto& [name, n] : seen) EXPECT_EQ(n, 60) << name;
}

// --- (SP-1) to (SP-3): surface crack ---------------------------------------------------------

TEST(PlateSurface, LimitBranchesMeetAtTheSemicircle) {
  // M_2 and M_3 are rounded differently in the two branches: 0.0017 a^2/t^2, 0.0039 a^4/t^4.
  const NewmanRajuPlate shallow(1.0);
  const NewmanRajuPlate deep(1.0 + 1e-12);
  for (double alpha = 0; alpha < 0.85; alpha += 0.1)
    for (double phi = 0; phi < 1.6; phi += pi / 16) {
      const double rounding = 0.002 * alpha * alpha + 0.004 * std::pow(alpha, 4);
      EXPECT_NEAR(deep.tension(alpha, phi) / shallow.tension(alpha, phi), 1, rounding + 1e-11);
      EXPECT_NEAR(deep.bending_ratio(alpha, phi), shallow.bending_ratio(alpha, phi), 1e-11);
    }
}

TEST(PlateSurface, LimitHalfSpaceSemicircle) {
  // 1.04 times the penny at the deepest point, 1.1 times that at the surface.
  for (const double rho : {1.0, 1.0 + 1e-12}) {
    const NewmanRajuPlate fit(rho);
    EXPECT_NEAR(fit.tension(0, pi / 2), 1.04 / std::sqrt(2.464), 1e-10);
    EXPECT_NEAR(fit.tension(0, 0), 1.1 * 1.04 / std::sqrt(2.464), 1e-10);
    EXPECT_EQ(fit.bending_ratio(0, 0.3), 1.0);  // a crack of zero depth has no gradient
  }
}

TEST(PlateSurface, LimitEdgeCrack) {
  // A long shallow crack is an edge crack at its deepest point; the fit is stated for a/c >= 0.2.
  const NewmanRajuPlate slit(1e-9);
  for (const double alpha : {0.0, 0.05, 0.1, 0.2}) {
    const double tension = slit.tension(alpha, pi / 2);
    EXPECT_NEAR(tension / sif::edge_crack_factor(sif::StripLoading::tension, alpha), 1, 0.05);
    EXPECT_NEAR(tension * slit.bending_ratio(alpha, pi / 2) /
                    sif::edge_crack_factor(sif::StripLoading::bending, alpha),
                1, 0.05);
  }
}

TEST(PlateSurface, LimitNarrowDeepCrack) {
  // c << a: the crack has the K of a slit of half length c; at the surface about 1.1 times as much.
  const double rho = 1e6;
  const NewmanRajuPlate narrow(rho);
  EXPECT_NEAR(narrow.tension(0.5, 0) * std::sqrt(rho), 1.1, 1e-5);
  EXPECT_NEAR(narrow.tension(0.5, pi / 2) * rho, 1.0, 1e-5);
}

TEST(PlateSurface, ReferenceWidth) {
  // sqrt(sec(pi c/(2 b) sqrt(a/t))): sec 60 deg = 2, sec 45 deg = sqrt 2.
  EXPECT_NEAR(NewmanRaju::width_factor(4.0 / 3, 0.25), std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(NewmanRaju::width_factor(0.5, 1), std::pow(2.0, 0.25), 1e-14);
  const auto wide = surface(0.5, 0.5, 1e-9).stress_intensity(1, 1.0).I;
  const auto narrow = surface(0.5, 0.5, 0.5).stress_intensity(1, 1.0).I;
  const double width = 1 / std::sqrt(std::cos(pi / 4 * std::sqrt(0.5)));
  test::expect_relative(narrow[0] / wide[0], width, 1e-12);
  test::expect_relative(narrow[1] / wide[1], width, 1e-12);
}

TEST(PlateSurface, IdentityShallowBranchIsTheEnginesCrack) {
  const sif::NewmanRaju fit(0.4);
  const auto k = surface(0.4, 0.3, 1e-9).stress_intensity(1, 0.7).I;
  test::expect_relative(k[0], fit.factor(0.3, 0.7) * std::sqrt(pi), 1e-12);
}

TEST(PlateSurface, InputRulesAndLimits) {
  EXPECT_EQ(rules_broken(surface(1, 1, 0.1)), Texts{"depth"});
  EXPECT_EQ(rules_broken(surface(1, 0.5, 1)), Texts{"half_length"});
  EXPECT_EQ(rules_broken(surface(1, 0.98, 0.99)), Texts{});
  EXPECT_EQ(limits_broken(surface(1, 0.81, 0.1)), Texts{"a/t <= 0.8"});
  EXPECT_EQ(limits_broken(surface(0.24, 0.5, 0.1)), Texts{"0.25 <= a/c <= 2"});
  EXPECT_EQ(limits_broken(surface(2.1, 0.5, 0.1)), Texts{"0.25 <= a/c <= 2"});
  EXPECT_EQ(limits_broken(surface(1, 0.5, 0.51)), Texts{"c/b <= 0.5"});
  EXPECT_EQ(limits_broken(surface(1.9, 0.79, 0.49)), Texts{});
  EXPECT_EQ(limits_broken(surface(0.26, 0.79, 0.49)), Texts{});
  test::expect_refused("plate-surface", {{"depth", 0.02}}, "depth");
  test::expect_refused("plate-surface", {{"half_length", 1e-6}}, "half_length");
  test::expect_refused("plate-surface", {{"half_length", 0.2}}, "half_length");
}

// --- (SP-16), (SP-17): corner crack --------------------------------------------------------------

TEST(PlateCorner, LimitBranchesMeetAtTheQuarterCircle) {
  for (double alpha = 0; alpha < 0.85; alpha += 0.1)
    for (double phi = 0; phi < 1.6; phi += pi / 16) {
      EXPECT_NEAR(PlateCornerCrack::tension(1 + 1e-12, alpha, phi) /
                      PlateCornerCrack::tension(1, alpha, phi),
                  1, 0.0005 * alpha * alpha + 1e-11);  // M_2 is rounded: 0.0004 a^2/t^2
      EXPECT_NEAR(PlateCornerCrack::bending_ratio(1 + 1e-12, alpha, phi),
                  PlateCornerCrack::bending_ratio(1, alpha, phi), 1e-11);
    }
}

TEST(PlateCorner, IdentitySmallCrackDoesNotKnowWhichLegIsWhich) {
  // Without thickness and width, a and c are interchangeable: F(rho, phi) sqrt(a).
  for (const double rho : {0.3, 0.7})
    for (const double phi : {0.0, 0.4, 1.1, pi / 2})
      test::expect_relative(PlateCornerCrack::tension(1 / rho, 0, pi / 2 - phi) / std::sqrt(rho),
                            PlateCornerCrack::tension(rho, 0, phi), 1e-12);
}

TEST(PlateCorner, LimitQuarterCircleOfAQuarterSpace) {
  // The factor is 1.05 times that of the penny, and at each face 1.08 times more.
  EXPECT_NEAR(PlateCornerCrack::tension(1, 0, 0) * std::sqrt(2.464), 1.05 * 1.08, 1e-12);
  EXPECT_NEAR(PlateCornerCrack::tension(1, 0, pi / 2) * std::sqrt(2.464), 1.05 * 1.08, 1e-12);
  EXPECT_EQ(PlateCornerCrack::bending_ratio(1, 0, 0.3), 1.0);
}

TEST(PlateCorner, LimitEdgeCrackAcrossTheWidth) {
  // (SP-16): when the crack reaches through the plate, f_w gives the edge crack in a strip of width
  // b.
  for (double x = 0.05; x <= 0.5; x += 0.05)
    EXPECT_NEAR(PlateCornerCrack::width_factor(x, 1.0) *
                    sif::edge_crack_factor(sif::StripLoading::tension, 0) /
                    sif::edge_crack_factor(sif::StripLoading::tension, x),
                1, 0.01);
  EXPECT_EQ(PlateCornerCrack::width_factor(0, 0.5), 1.0);
  EXPECT_EQ(PlateCornerCrack::width_factor(0.2, 0.25), PlateCornerCrack::width_factor(0.1, 1));
}

TEST(PlateCorner, LimitEdgeCrackAcrossTheThickness) {
  // A long shallow crack at its deepest point; the fit is stated for a/c >= 0.2.
  for (const double alpha : {0.0, 0.1, 0.2})
    EXPECT_NEAR(PlateCornerCrack::tension(1e-9, alpha, pi / 2) /
                    sif::edge_crack_factor(sif::StripLoading::tension, alpha),
                1, 0.05);
}

TEST(PlateCorner, InputRulesAndLimits) {
  EXPECT_EQ(rules_broken(corner(1, 1, 0.1)), Texts{"depth"});
  EXPECT_EQ(rules_broken(corner(1, 0.5, 1)), Texts{"length"});
  EXPECT_EQ(rules_broken(corner(1, 0.98, 0.99)), Texts{});
  EXPECT_EQ(limits_broken(corner(1, 0.51, 0.1)), Texts{"a/t <= 0.5"});
  EXPECT_EQ(limits_broken(corner(0.49, 0.4, 0.1)), Texts{"0.5 <= a/c <= 2"});
  EXPECT_EQ(limits_broken(corner(2.1, 0.4, 0.1)), Texts{"0.5 <= a/c <= 2"});
  EXPECT_EQ(limits_broken(corner(1, 0.4, 0.21)), Texts{"c/b <= 0.2"});
  EXPECT_EQ(limits_broken(corner(1.9, 0.49, 0.19)), Texts{});
  EXPECT_EQ(limits_broken(corner(0.51, 0.49, 0.19)), Texts{});
  test::expect_refused("plate-corner", {{"depth", 0.02}}, "depth");
  test::expect_refused("plate-corner", {{"length", 1e-6}}, "length");
  test::expect_refused("plate-corner", {{"length", 0.06}}, "length");
}

// --- (SP-18): ellipse in a plate
// ------------------------------------------------------------------

TEST(PlateEllipse, LimitThickPlate) {
  // The result is the exact ellipse (SP-19) except for Q, which is accurate to 0.15 %.
  for (const double rho : {0.2, 0.5, 1.0, 1.0 + 1e-12, 2.0, 5.0})
    for (const double phi : {0.0, 0.5, 1.2, pi / 2}) {
      const double q = std::min(rho, 1 / rho);
      const BodyEllipse body{.semi_minor = q, .semi_major = 1, .poissons_ratio = 0.3};
      // For a > c the axes are exchanged, and the shorter one is c.
      const double exact = body.stress_intensity(q, rho <= 1 ? phi : pi / 2 - phi).I[0] /
                           std::sqrt(pi * (rho <= 1 ? q : 1.0));
      EXPECT_NEAR(PlateEllipse::factor(rho, 0, phi) / exact, 1, 0.0008);
    }
}

TEST(PlateEllipse, LimitBranchesMeetAtTheCircle) {
  for (double alpha = 0; alpha < 0.85; alpha += 0.1)
    for (double phi = 0; phi < 1.6; phi += pi / 16)
      test::expect_relative(PlateEllipse::factor(1 + 1e-12, alpha, phi),
                            PlateEllipse::factor(1, alpha, phi), 1e-11);
}

TEST(PlateEllipse, LimitCentreCrackThroughTheWidth) {
  // The tolerance 3 % is the model form of the fit, which is stated for a/c >= 0.2.
  for (double alpha = 0; alpha < 0.85; alpha += 0.1)
    EXPECT_NEAR(PlateEllipse::factor(1e-9, alpha, pi / 2) / strip_centre_tension(alpha), 1, 0.03);
}

TEST(PlateEllipse, ReferenceWidth) {
  const double wide = embedded(0.5, 0.5, 1e-9).stress_intensity(1, 1.0).I[0];
  const double narrow = embedded(0.5, 0.5, 0.5).stress_intensity(1, 1.0).I[0];
  test::expect_relative(narrow / wide, 1 / std::sqrt(std::cos(pi / 4 * std::sqrt(0.5))), 1e-12);
  test::expect_relative(wide, PlateEllipse::factor(0.5, 0.5, 1.0) * std::sqrt(pi), 1e-12);
}

TEST(PlateEllipse, InputRulesAndLimits) {
  EXPECT_EQ(rules_broken(embedded(1, 1, 0.1)), Texts{"half_depth"});
  EXPECT_EQ(rules_broken(embedded(1, 0.5, 1)), Texts{"half_length"});
  EXPECT_EQ(rules_broken(embedded(1, 0.98, 0.99)), Texts{});
  EXPECT_EQ(limits_broken(embedded(1, 0.81, 0.1)).size(), 1U);
  EXPECT_EQ(limits_broken(embedded(0.19, 0.5, 0.1)), Texts{"0.2 <= a/c <= 2"});
  EXPECT_EQ(limits_broken(embedded(2.1, 0.5, 0.1)), Texts{"0.2 <= a/c <= 2"});
  EXPECT_EQ(limits_broken(embedded(1, 0.5, 0.51)), Texts{"c/b <= 0.5"});
  EXPECT_EQ(limits_broken(embedded(1.9, 0.79, 0.49)), Texts{});
  EXPECT_EQ(limits_broken(embedded(0.21, 0.79, 0.49)), Texts{});
  test::expect_refused("plate-ellipse", {{"half_depth", 0.005}}, "half_depth");
  test::expect_refused("plate-ellipse", {{"half_length", 1e-6}}, "half_length");
  test::expect_refused("plate-ellipse", {{"half_length", 0.1}}, "half_length");
}

// --- areas
// ----------------------------------------------------------------------------------------

TEST(PlateSolid, IdentitySweptAreas) {
  const auto area = [](const auto& crack) {
    const FrontRange front = crack.front();
    return crack.swept_area(crack.size(), 0) * (front.end - front.begin) * crack.size() / 2;
  };
  const double ac = 2 * mm * 5 * mm;
  test::expect_relative(
      area(PlateSurfaceCrack{
          .depth = 2 * mm, .half_length = 5 * mm, .thickness = 9 * mm, .half_width = 90 * mm}),
      pi / 2 * ac, 1e-14);
  test::expect_relative(
      area(PlateCornerCrack{
          .depth = 2 * mm, .length = 5 * mm, .thickness = 9 * mm, .width = 90 * mm}),
      pi / 4 * ac, 1e-14);
  test::expect_relative(
      area(PlateEllipse{
          .half_depth = 2 * mm, .half_length = 5 * mm, .thickness = 9 * mm, .half_width = 90 * mm}),
      pi * ac, 1e-14);
  test::expect_relative(area(BodyEllipse{.semi_minor = 2 * mm, .semi_major = 5 * mm}), pi * ac,
                        1e-14);
  test::expect_relative(area(BodyPenny{.radius = 5 * mm}), pi * 25 * mm * mm, 1e-14);
}

TEST(PlateSolid, IdentityNominalStressIsTheLoad) {
  // Every load here is a remote stress of 1 Pa per unit.
  const auto all_one = [](const auto& crack) {
    for (std::size_t load = 0; load < std::decay_t<decltype(crack)>::kLoads; ++load)
      EXPECT_EQ(crack.gross_stress(load), 1.0);
    for (const FrontPoint& point : std::decay_t<decltype(crack)>::kPoints) {
      EXPECT_GE(point.s, crack.front().begin);
      EXPECT_LE(point.s, crack.front().end);
    }
  };
  all_one(surface(0.5, 0.5, 0.1));
  all_one(corner(0.5, 0.5, 0.1));
  all_one(embedded(0.5, 0.5, 0.1));
  all_one(BodyEllipse{.semi_minor = 1, .semi_major = 2});
  all_one(BodyPenny{.radius = 1});
}

// --- (SP-19) to (SP-21), (FR-10): bodies
// -----------------------------------------------------------

TEST(BodyEllipse, ReferenceShearAlongTheMajorAxisAndTension) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("elliptical_crack_shear")) {
    const double a = row("depth");
    const double nu = row("poissons_ratio");
    const BodyEllipse crack{
        .semi_minor = a, .semi_major = a / row("aspect_ratio"), .poissons_ratio = nu};
    if (row.quantity == "K_II_per_stress" || row.quantity == "K_III_per_stress") {
      const auto k = crack.stress_intensity(a, row("front_angle"));
      // sin and cos of a rounded angle: cos(pi/2) is 6e-17
      const double actual = row.quantity == "K_II_per_stress" ? k.II[1] : -k.III[1];
      EXPECT_NEAR(actual, row.value, 1e-13 * std::sqrt(pi * a));
    } else if (row.quantity.ends_with("energy_per_stress_squared")) {
      const double E = row("youngs_modulus");
      const auto m =
          added_compliance(crack, {.opening = E / (1 - nu * nu), .shear = E / (2 * (1 + nu))})
              .matrix;
      const bool shear = row.quantity.starts_with("shear");
      if (!shear && !row.quantity.starts_with("tension")) continue;
      test::expect_row(m(shear ? 1 : 0, shear ? 1 : 0) / 2, row, 1e-9);  // (SP-19), (FR-10)
    } else {
      continue;
    }
    ++n;
  }
  EXPECT_GE(n, 90);
}

TEST(BodyEllipse, ReferenceShearAlongTheMinorAxis) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("body_cracks")) {
    if (!row.quantity.starts_with("minor_shear")) continue;
    const double a = row("semi_minor");
    const double nu = row("poissons_ratio");
    const BodyEllipse crack{
        .semi_minor = a, .semi_major = a / row("aspect_ratio"), .poissons_ratio = nu};
    if (row.quantity == "minor_shear.mu_energy") {
      // mu = 1: E' = 2/(1 - nu).
      const auto m = added_compliance(crack, {.opening = 2 / (1 - nu), .shear = 1}).matrix;
      test::expect_row(m(2, 2) / 2, row, 1e-9);
    } else {
      const auto k = crack.stress_intensity(a, row("front_angle"));
      const double actual = row.quantity == "minor_shear.K_II" ? k.II[2] : k.III[2];
      EXPECT_NEAR(actual, row.value, 1e-13 * std::sqrt(pi * a));  // (SP-20)
    }
    ++n;
  }
  EXPECT_EQ(n, 2 * 4 * 7);
}

TEST(BodyEllipse, LimitPenny) {
  const double nu = 0.3;
  const BodyEllipse round{.semi_minor = 3 * mm, .semi_major = 3 * mm, .poissons_ratio = nu};
  const BodyPenny penny{.radius = 3 * mm, .poissons_ratio = nu};
  for (const double phi : {0.0, 0.4, 1.3, 2.5, 4.0, 6.0}) {
    const auto k = round.stress_intensity(2 * mm, phi);
    const auto p = penny.stress_intensity(2 * mm, phi);
    const double scale = 1e-13 * p.I[0];
    EXPECT_NEAR(k.I[0], p.I[0], scale);
    EXPECT_NEAR(k.II[1], p.II[1], scale);
    EXPECT_NEAR(k.III[1], p.III[1], scale);
    // Shear along the other axis gives the same result after a quarter turn.
    const auto turned = penny.stress_intensity(2 * mm, phi - pi / 2);
    EXPECT_NEAR(k.II[2], turned.II[1], scale);
    EXPECT_NEAR(k.III[2], turned.III[1], scale);
  }
}

TEST(BodyEllipse, LimitSlit) {
  // At the end of the minor axis of a slender ellipse: K of a straight crack, sqrt(pi a), in mode
  // I, in mode II under shear along the minor axis, and in mode III under shear along the major
  // axis.
  for (const double nu : {0.0, 0.3}) {
    const BodyEllipse slit{.semi_minor = 1e-9, .semi_major = 1, .poissons_ratio = nu};
    const auto k = slit.stress_intensity(1e-9, pi / 2);
    const double root = std::sqrt(pi * 1e-9);
    test::expect_relative(k.I[0], root, 1e-12);
    test::expect_relative(k.II[2], root, 1e-12);
    test::expect_relative(k.III[1], -root, 1e-12);
    EXPECT_NEAR(k.III[2] / root, 0, 1e-12);
  }
}

TEST(BodyEllipse, IdentityShearsDoNotCouple) {
  const BodyEllipse crack{.semi_minor = 2 * mm, .semi_major = 5 * mm, .poissons_ratio = 0.3};
  const auto m = added_compliance(crack, {.opening = 2 / 0.7, .shear = 1}).matrix;
  const double scale = 1e-9 * m(1, 1);
  EXPECT_NEAR(m(0, 1), 0, scale);
  EXPECT_NEAR(m(0, 2), 0, scale);
  EXPECT_NEAR(m(1, 2), 0, scale);
  EXPECT_GT(m(1, 1), 0.9 * m(2, 2));
}

TEST(BodyEllipse, InputRules) {
  EXPECT_EQ(rules_broken(BodyEllipse{.semi_minor = 1.1, .semi_major = 1}), Texts{"semi_minor"});
  EXPECT_EQ(rules_broken(BodyEllipse{.semi_minor = 1, .semi_major = 1}), Texts{});
  test::expect_refused("body-ellipse", {{"semi_minor", 0.006}}, "semi_minor");
  test::expect_refused("body-ellipse", {{"poissons_ratio", 0.5}}, "poissons_ratio");
  test::expect_refused("body-penny", {{"poissons_ratio", -1.0}}, "poissons_ratio");
}

TEST(BodyPenny, IdentityEnergy) {
  // Sneddon's 8 (1 - nu^2) a^3/(3 E) of energy in tension, 16 (1 - nu^2) a^3/(3 (2 - nu) E) in
  // shear; torsion 16 a^3/(45 mu).  The loads do not couple.
  const double a = 4 * mm;
  const double nu = 0.3;
  const double E = 2.0;
  const double mu = E / (2 * (1 + nu));
  const BodyPenny penny{.radius = a, .poissons_ratio = nu};
  const auto m = added_compliance(penny, {.opening = E / (1 - nu * nu), .shear = mu}).matrix;
  const double a3 = a * a * a;
  test::expect_relative(m(0, 0) / 2, 8 * (1 - nu * nu) * a3 / (3 * E), 1e-9);
  test::expect_relative(m(1, 1) / 2, 16 * (1 - nu * nu) * a3 / (3 * (2 - nu) * E), 1e-9);
  test::expect_relative(m(2, 2) / 2, 16 * a3 / (45 * mu), 1e-9);
  EXPECT_NEAR(m(0, 1), 0, 1e-9 * m(0, 0));
  EXPECT_NEAR(m(0, 2), 0, 1e-9 * m(0, 0));
  EXPECT_NEAR(m(1, 2), 0, 1e-9 * m(0, 0));
}

TEST(BodyPenny, ReferenceTorsion) {
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("body_cracks")) {
    if (!row.quantity.starts_with("penny.torsion")) continue;
    const double a = row("semi_minor");
    const BodyPenny penny{.radius = a, .poissons_ratio = 0.3};
    if (row.quantity == "penny.torsion.K_III")
      test::expect_row(penny.stress_intensity(a, 1.0).III[2], row, 1e-14);
    else
      test::expect_row(added_compliance(penny, test::kUnitModuli).matrix(2, 2) / 2, row, 1e-9);
    ++n;
  }
  EXPECT_EQ(n, 2);
}

}  // namespace
}  // namespace strainwave::sif
