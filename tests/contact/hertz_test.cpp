// SPDX-License-Identifier: Apache-2.0
#include "strainwave/contact/hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "support/expect.hpp"
#include "support/reference.hpp"
#include "support/reference_csv.hpp"
#include "support/scaling.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should
using std::numbers::pi;
using test::Arg;

/// Steel on steel: 1/E* = 2 (1 - nu^2)/E.
constexpr double kSteel = 210 * GPa / (2 * (1 - 0.3 * 0.3));

PointContact sphere_on_flat() {
  return {.curvature_sums = {1 / (10 * mm), 1 / (10 * mm)}, .contact_modulus = kSteel};
}

PointContact ball_on_race() {
  const double D = 12.7 * mm;
  return {.curvature_sums = {2 / D - 1 / (0.52 * D), 2 / D + 1 / (55 * mm)},
          .contact_modulus = kSteel};
}

// Kind: identity (CO-2).  Ellipses that the caller keeps change no bit, in any order, also if more
// contacts alternate than are kept.
TEST(HertzContact, IdentityKeptEllipsesChangeNoBit) {
  ContactEllipses kept;
  for (const int count : {1, 2, 4, 7})
    for (int n = 0; n < 30; ++n) {
      const double force = 10.0 + n;
      PointContact contact = ball_on_race();
      contact.curvature_sums[0] *= 1 + 0.1 * (n % count);
      const HertzContact one = hertz_contact(contact, force);
      const HertzContact other = hertz_contact(contact, force, kept);
      EXPECT_EQ(one.major_semi_axis, other.major_semi_axis);
      EXPECT_EQ(one.minor_semi_axis, other.minor_semi_axis);
      EXPECT_EQ(one.approach, other.approach);
      EXPECT_EQ(one.tangent_stiffness, other.tangent_stiffness);
    }
  PointContact wrong = ball_on_race();
  wrong.contact_modulus = 0;
  EXPECT_EQ(test::broken_rule([&] { return hertz_contact(wrong, 1.0, kept); }),
            test::broken_rule([&] { return hertz_contact(wrong, 1.0); }));
}

// --- (CO-1) to (CO-4): the contact --------------------------------------------------------------

TEST(HertzContact, ReferenceSphereOnFlat) {
  const HertzContact contact = hertz_contact(sphere_on_flat(), 100 * N);
  const auto eight_digits = [](double value, std::string_view unit) {
    return test::Reference{.value = value,
                           .unit = unit,
                           .relative_tolerance = 1e-7,
                           .source = "johnson1985 (secondary): a^3 = 3QR/(4E*), exact",
                           .tolerance_is = "eight digits printed"};
  };
  test::expect_reference(contact.major_semi_axis / mm, eight_digits(0.18662556, "mm"));
  test::expect_reference(contact.minor_semi_axis / mm, eight_digits(0.18662556, "mm"));
  test::expect_reference(contact.peak_pressure / MPa, eight_digits(1370.8791, "MPa"));
  test::expect_reference(contact.approach / mm, eight_digits(3.4829099e-3, "mm"));
}

TEST(HertzContact, ReferenceBallOnInnerRace) {
  const HertzContact contact = hertz_contact(ball_on_race(), 500 * N);
  const auto digits = [](double value, double tolerance, std::string_view unit) {
    return test::Reference{
        .value = value,
        .unit = unit,
        .relative_tolerance = tolerance,
        .source = "johnson1985 (secondary), evaluated by two roads: ball 12.7 mm, race 55 mm",
        .tolerance_is = "digits printed"};
  };
  test::expect_reference(contact.major_semi_axis / mm, digits(1.2066143, 1e-7, "mm"));
  test::expect_reference(contact.minor_semi_axis / mm, digits(0.13875997, 1e-7, "mm"));
  test::expect_reference(contact.peak_pressure / MPa, digits(1425.866, 4e-7, "MPa"));
}

TEST(HertzContact, ReferencePalmgrenApproach) {
  // Contacts with both races of that ball, by Palmgren's rule for steel balls, 4.36e-4 Q^(2/3)
  // D^(-1/3), in N, mm.
  const double D = 12.7 * mm;
  const PointContact outer{.curvature_sums = {2 / D - 1 / (0.52 * D), 2 / D - 1 / (67.7 * mm)},
                           .contact_modulus = kSteel};
  const double approach =
      hertz_contact(ball_on_race(), 500 * N).approach + hertz_contact(outer, 500 * N).approach;
  test::expect_reference(
      approach / mm,
      {.value = 1.1772e-2,
       .unit = "mm",
       .relative_tolerance = 0.03,
       .source = "harris2001 (secondary), Palmgren's rule for both races together",
       .tolerance_is = "model form: one rule for all conformities of ball bearings"});
  test::expect_relative(approach / mm, 1.2083e-2, 5e-5);  // five digits of an earlier evaluation
}

TEST(HertzContact, ReferenceTable) {
  // Rounding of the axis ratio's root and of elliptic integrals close to their limits: 1e-12.
  constexpr double kRounding = 2e-12;
  std::map<std::string, int> seen;
  for (const test::CsvRow& row : test::read_reference_csv("hertz_contact")) {
    const std::size_t dot = row.quantity.find('.');
    if (dot == std::string::npos) continue;
    const HertzContact contact = hertz_contact(
        {.curvature_sums = {row("relative_curvature_min"), row("relative_curvature_max")},
         .contact_modulus = row("contact_modulus")},
        row("load"));
    const std::map<std::string, double> actual = {{"semi_axis_major", contact.major_semi_axis},
                                                  {"semi_axis_minor", contact.minor_semi_axis},
                                                  {"peak_pressure", contact.peak_pressure},
                                                  {"approach", contact.approach}};
    test::expect_row(actual.at(row.quantity.substr(dot + 1)), row, kRounding);
    ++seen[row.quantity.substr(dot + 1)];
  }
  EXPECT_EQ(seen.size(), 4U);
  for (const auto& [quantity, n] : seen) EXPECT_GE(n, 5) << quantity;
}

TEST(HertzContact, IdentityPressureCarriesTheForce) {
  for (const double force : {1.0, 250.0, 8000.0}) {
    const HertzContact contact = hertz_contact(ball_on_race(), force);
    // Volume under a semi-ellipsoid of pressure (CO-3).
    test::expect_relative(
        2.0 / 3 * pi * contact.major_semi_axis * contact.minor_semi_axis * contact.peak_pressure,
        force, 1e-14);
  }
}

TEST(HertzContact, IdentityStiffnessIsTheSlopeOfForceOverApproach) {
  const double Q = 500 * N;
  const double h = 1e-4 * Q;
  const HertzContact contact = hertz_contact(ball_on_race(), Q);
  const double slope = 2 * h /
                       (hertz_contact(ball_on_race(), Q + h).approach -
                        hertz_contact(ball_on_race(), Q - h).approach);
  // (CO-4); central difference: (h/Q)^2 and rounding 1e-16 Q/h.
  test::expect_relative(contact.tangent_stiffness, slope, 1e-8);
  test::expect_relative(contact.secant_stiffness, Q / contact.approach, 1e-15);
  test::expect_relative(contact.tangent_stiffness / contact.secant_stiffness, 1.5, 1e-15);
}

TEST(HertzContact, IdentityCubeRootOfTheForce) {
  const HertzContact one = hertz_contact(ball_on_race(), 100 * N);
  const HertzContact eight = hertz_contact(ball_on_race(), 800 * N);
  test::expect_relative(eight.major_semi_axis / one.major_semi_axis, 2, 1e-14);
  test::expect_relative(eight.minor_semi_axis / one.minor_semi_axis, 2, 1e-14);
  test::expect_relative(eight.peak_pressure / one.peak_pressure, 2, 1e-14);
  test::expect_relative(eight.approach / one.approach, 4, 1e-14);
}

TEST(HertzContact, IdentityOrderOfTheCurvaturesDoesNotMatter) {
  PointContact contact = ball_on_race();
  const HertzContact one = hertz_contact(contact, 500 * N);
  std::swap(contact.curvature_sums[0], contact.curvature_sums[1]);
  const HertzContact other = hertz_contact(contact, 500 * N);
  EXPECT_EQ(one.major_semi_axis, other.major_semi_axis);
  EXPECT_EQ(one.minor_semi_axis, other.minor_semi_axis);
  EXPECT_EQ(one.approach, other.approach);
  EXPECT_GE(one.major_semi_axis, one.minor_semi_axis);
}

TEST(HertzContact, IdentityAxisRatioSolvesItsEquation) {
  // The textbook's form of (CO-2), with complete elliptic integrals by the arithmetic-geometric
  // mean: [(kappa^2+1)E - 2K]/[(kappa^2-1)E] = (B-A)/(B+A).
  for (const double upper : {1.001, 1.5, 7.0, 120.0, 5000.0}) {
    const HertzContact contact =
        hertz_contact({.curvature_sums = {1.0, upper}, .contact_modulus = 1.0}, 1.0);
    const double kappa = contact.major_semi_axis / contact.minor_semi_axis;
    double a = 1;
    double g = 1 / kappa;
    double sum = (1 - 1 / (kappa * kappa)) / 2;
    for (double power = 1; a - g > 1e-16 * a; power *= 2) {
      const double c = (a - g) / 2;
      const double mean = (a + g) / 2;
      g = std::sqrt(a * g);
      a = mean;
      sum += power * c * c;
    }
    const double K = pi / (2 * a);
    const double E = K * (1 - sum);
    const double k2 = kappa * kappa;
    EXPECT_NEAR(((k2 + 1) * E - 2 * K) / ((k2 - 1) * E), (upper - 1) / (upper + 1),
                // The form in the textbook is inaccurate near a circle.
                4e-15 / (1 - 1 / kappa))
        << upper;
  }
}

TEST(HertzContact, LimitNearlyCircular) {
  // F = (B-A)/(B+A) -> 3/4 (1 - b/a) for b/a -> 1, so b/a = 1 - 4F/3 + O(F^2).
  const double F = 1e-4;
  const HertzContact contact =
      hertz_contact({.curvature_sums = {1 - F, 1 + F}, .contact_modulus = kSteel}, 1.0);
  EXPECT_NEAR((1 - contact.minor_semi_axis / contact.major_semi_axis) / F, 4.0 / 3, 2 * F);
}

TEST(HertzContact, LimitFlatterThanALineIsALine) {
  // b/a stops at 1e-7: beyond, (B-A)/(B+A) is 1 to rounding.
  const HertzContact contact =
      hertz_contact({.curvature_sums = {1e-13, 1.0}, .contact_modulus = kSteel}, 1.0);
  test::expect_relative(contact.minor_semi_axis / contact.major_semi_axis, 1e-7, 1e-14);
  const HertzContact nearly =
      hertz_contact({.curvature_sums = {1e-10, 1.0}, .contact_modulus = kSteel}, 1.0);
  EXPECT_GT(nearly.minor_semi_axis / nearly.major_semi_axis, 1e-6);
}

TEST(HertzContact, ScalingAllResults) {
  const auto expect = [](std::string_view unit, double HertzContact::*result) {
    test::expect_dimensionally_consistent(
        unit,
        [=](double A, double B, double modulus, double force) {
          return hertz_contact({.curvature_sums = {A, B}, .contact_modulus = modulus}, force).*
                 result;
        },
        Arg{6.0, "1/m"}, Arg{175.0, "1/m"}, Arg{1.15e11, "Pa"}, Arg{500.0, "N"});
  };
  expect("m", &HertzContact::major_semi_axis);
  expect("m", &HertzContact::minor_semi_axis);
  expect("Pa", &HertzContact::peak_pressure);
  expect("m", &HertzContact::approach);
  expect("N/m", &HertzContact::secant_stiffness);
  expect("N/m", &HertzContact::tangent_stiffness);
}

TEST(HertzContact, InputRulesBrokenOnce) {
  const auto broken = [](double A, double B, double modulus, double force) -> std::string {
    try {
      (void)hertz_contact({.curvature_sums = {A, B}, .contact_modulus = modulus}, force);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(broken(0, 5, 1, 1), "curvature_sums = 0 1/m violates: both curvature sums > 0");
  EXPECT_EQ(broken(5, 0, 1, 1), "curvature_sums = 0 1/m violates: both curvature sums > 0");
  EXPECT_EQ(broken(5, 6, 0, 1), "contact_modulus = 0 Pa violates: contact_modulus > 0");
  EXPECT_EQ(broken(5, 6, nan, 1), "contact_modulus = nan Pa violates: contact_modulus > 0");
  EXPECT_EQ(broken(5, 6, 1, 0), "force = 0 N violates: force > 0");
  EXPECT_EQ(broken(5, 6, 1, -2), "force = -2 N violates: force > 0");
  EXPECT_EQ(broken(5, 6, 1, nan), "force = nan N violates: force > 0");
  EXPECT_EQ(broken(nan, 6, 1, 1), "curvature_sums = nan 1/m violates: both curvature sums > 0");
  EXPECT_EQ(broken(5, nan, 1, 1), "curvature_sums = nan 1/m violates: both curvature sums > 0");
  EXPECT_EQ(broken(5, 6, 1, 1), "no error");
}

TEST(HertzContact, InputNothingUnlessGiven) {
  const HertzContact nothing;
  for (const auto result : {&HertzContact::major_semi_axis, &HertzContact::minor_semi_axis,
                            &HertzContact::peak_pressure, &HertzContact::approach,
                            &HertzContact::secant_stiffness, &HertzContact::tangent_stiffness})
    EXPECT_EQ(nothing.*result, 0.0);
  EXPECT_EQ(PointContact{}.contact_modulus, 0.0);
  EXPECT_EQ(EdgeTension{}.major_end, 0.0);
  EXPECT_EQ(EdgeTension{}.minor_end, 0.0);
}

// --- (CO-3): the peak pressure of given axes -----------------------------------------------------

TEST(PeakPressure, ReferenceArticle) {
  test::expect_reference(
      peak_pressure(500 * N, 5 * mm, 2 * mm) / MPa,
      {.value = 23.873241,
       .unit = "MPa",
       .relative_tolerance = 2.1e-8,
       .source = "the article's 3F/(2 pi a b) with its F = 500 N, a' = 5 mm, b' = 2 mm",
       .tolerance_is = "eight digits printed"});
}

TEST(PeakPressure, ScalingIsAPressure) {
  test::expect_dimensionally_consistent(
      "Pa", [](double Q, double a, double b) { return peak_pressure(Q, a, b); }, Arg{500, "N"},
      Arg{5e-3, "m"}, Arg{2e-3, "m"});
}

// --- (CO-5), (CO-6): orthogonal shear
// --------------------------------------------------------------

TEST(OrthogonalShear, ReferenceCircleEllipseLine) {
  const auto reference = [](double value) {
    return test::Reference{
        .value = value,
        .unit = "1",
        .relative_tolerance = 1.2e-8,
        .source = "harris2001 (secondary), Lundberg and Palmgren; root of a cubic",
        .tolerance_is = "eight digits printed"};
  };
  test::expect_reference(orthogonal_shear_factor(1.0), reference(0.42778180));
  test::expect_reference(orthogonal_shear_factor(0.4), reference(0.48255370));
  test::expect_reference(orthogonal_shear_factor(1e-6), reference(0.5));
}

TEST(OrthogonalShear, ReferenceTable) {
  // At a line the root t -> 1 makes t - 1 small: b/a = 1e-3 must not reduce the accuracy of beta
  // and z0.
  constexpr double kRounding = 1e-13;
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("hertz_contact")) {
    if (row.quantity == "orthogonal_shear_factor")
      test::expect_row(orthogonal_shear_factor(row("semi_axis_ratio")), row, kRounding);
    else if (row.quantity == "orthogonal_shear_depth_ratio")
      test::expect_row(orthogonal_shear_depth(row("semi_axis_ratio")), row, kRounding);
    else
      continue;
    ++n;
  }
  EXPECT_GE(n, 10);
}

TEST(OrthogonalShear, IdentityExactCircle) {
  // t = (1 + sqrt 17)/4 solves t (2 t^2 - t - 2) = 0.
  const double t = (1 + std::sqrt(17.0)) / 4;
  test::expect_relative(orthogonal_shear_factor(1), std::sqrt(2 * t - 1) / (t * (t + 1)), 1e-14);
  test::expect_relative(orthogonal_shear_depth(1), 1 / ((t + 1) * std::sqrt(2 * t - 1)), 1e-14);
}

TEST(OrthogonalShear, LimitLineContact) {
  // t = 1 + (b/a)^2/2 + ..., so beta = 1/2 - (b/a)^2/8 + ... and z0/b = 1/2 - 3/8 (b/a)^2 + ...
  const double ratio = 1e-3;
  EXPECT_NEAR((0.5 - orthogonal_shear_factor(ratio)) / (ratio * ratio), 1.0 / 8, 1e-5);
  EXPECT_NEAR((0.5 - orthogonal_shear_depth(ratio)) / (ratio * ratio), 3.0 / 8, 1e-5);
}

TEST(OrthogonalShear, IdentityFallsFromLineToCircle) {
  for (double ratio = 0.05; ratio < 1; ratio += 0.05) {
    EXPECT_GT(orthogonal_shear_factor(ratio), orthogonal_shear_factor(ratio + 0.05));
    EXPECT_GT(orthogonal_shear_depth(ratio), orthogonal_shear_depth(ratio + 0.05));
  }
}

// --- (CO-7): tension at the edge of the contact
// -----------------------------------------------------

TEST(EdgeTension, ReferenceEllipse) {
  const EdgeTension tension = edge_tension(0.4, 0.3);
  const auto reference = [](double value) {
    return test::Reference{
        .value = value,
        .unit = "1",
        .relative_tolerance = 1e-7,
        .source = "johnson1985 (secondary), ends of the axes of a contact ellipse",
        .tolerance_is = "eight digits printed"};
  };
  test::expect_reference(tension.major_end, reference(0.13514631));
  test::expect_reference(tension.minor_end, reference(0.094104563));
}

TEST(EdgeTension, ReferenceTable) {
  // Differences of nearly equal numbers towards the circle; b/a = 0.7 loses one digit.
  constexpr double kRounding = 1e-13;
  int n = 0;
  for (const test::CsvRow& row : test::read_reference_csv("hertz_contact")) {
    if (!row.quantity.starts_with("edge_tension")) continue;
    const EdgeTension tension = edge_tension(row("semi_axis_ratio"), row("poissons_ratio"));
    test::expect_row(
        row.quantity == "edge_tension_major_end" ? tension.major_end : tension.minor_end, row,
        kRounding);
    ++n;
  }
  EXPECT_GE(n, 20);
}

TEST(EdgeTension, LimitCircle) {
  const EdgeTension circle = edge_tension(1.0, 0.3);
  test::expect_relative(circle.major_end, 0.4 / 3, 1e-15);
  test::expect_relative(circle.minor_end, 0.4 / 3, 1e-15);
  // (1-2nu)/3 (1 +- e^2/10 + ...): both ends meet there, and no digit cancels on the way.
  for (const double e2 : {1e-12, 1.005e-7, 1e-6, 1e-4}) {
    const EdgeTension tension = edge_tension(std::sqrt(1 - e2), 0.3);
    const double rounding = 1e-15;
    EXPECT_NEAR(tension.major_end * 3 / 0.4 - 1, 0.1 * e2, e2 * e2 + rounding);
    EXPECT_NEAR(tension.minor_end * 3 / 0.4 - 1, -0.1 * e2, e2 * e2 + rounding);
  }
  const EdgeTension first = edge_tension(std::sqrt(1 - 1e-12), 0.3);
  EXPECT_GT(first.major_end, first.minor_end);
}

TEST(EdgeTension, CrosscheckSeriesMeetsTheClosedForm) {
  // Series below e^2 = 0.01, closed form above: the remaining step is the rounding of the closed
  // form, a difference of nearly equal numbers, 1e-16/e^2.
  const double ratio = std::sqrt(1 - 0.01);
  const EdgeTension series = edge_tension(ratio * (1 + 1e-14), 0.3);
  const EdgeTension closed = edge_tension(ratio * (1 - 1e-14), 0.3);
  test::expect_relative(series.major_end, closed.major_end, 1e-13);
  test::expect_relative(series.minor_end, closed.minor_end, 1e-13);
}

TEST(EdgeTension, LimitIncompressibleHasNone) {
  EXPECT_EQ(edge_tension(0.3, 0.5).major_end, 0.0);
  EXPECT_EQ(edge_tension(0.3, 0.5).minor_end, 0.0);
}

TEST(EdgeTension, IdentityLinearInOneMinusTwoNu) {
  for (const double ratio : {0.05, 0.4, 1.0}) {
    const EdgeTension one = edge_tension(ratio, 0.0);
    const EdgeTension other = edge_tension(ratio, 0.25);
    test::expect_relative(other.major_end / one.major_end, 0.5, 1e-15);
    test::expect_relative(other.minor_end / one.minor_end, 0.5, 1e-15);
  }
}

}  // namespace
}  // namespace strainwave
