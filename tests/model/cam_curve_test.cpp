// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/cam_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should
using std::numbers::pi;

constexpr double kBore = 30.65 * mm;
constexpr double kMiddle = 31.02 * mm;
constexpr double kW0 = 0.32 * mm;

CamCurve curve_of(const CamShape& shape, bool exact = true, double excess = 0) {
  return {{.radial_displacement = kW0, .shape = shape, .perimeter_excess = excess},
          kBore,
          kMiddle,
          exact};
}

/// Points of a cosine of which a lobe lies w_0 outside the bore.
CamPoints cosine_points(int count) {
  CamPoints points;
  for (int i = 0; i < count; ++i) {
    const double angle = pi / 2 * i / (count - 1);
    points.push_back({angle, kW0 * std::cos(2 * angle)});
  }
  return points;
}

/// Length of the curve by short chords.
double length_of(const CamCurve& cam) {
  constexpr int kChords = 40000;
  double sum = 0;
  for (int i = 0; i < kChords; ++i) {
    const double a = 2 * pi * i / kChords;
    const double b = 2 * pi * (i + 1) / kChords;
    const double r_a = kBore + cam.at(a);
    const double r_b = kBore + cam.at(b);
    sum += std::hypot(r_b * std::cos(b) - r_a * std::cos(a), r_b * std::sin(b) - r_a * std::sin(a));
  }
  return sum;
}

// (FE-52) Kind: identity.  The perimeter of the curve, by chords, is the one asked for, and half
// the difference of the semi-axes is w_0.  Tolerance 1e-8: chords of the curve.
TEST(CamCurve, IdentityPerimeterAndAxes) {
  for (const CamShape& shape : {CamShape(FlattenedCosine{0}), CamShape(FlattenedCosine{1.5}),
                                CamShape(TwoArcs{20 * deg}), CamShape(TwoArcs{65 * deg})})
    for (const double excess : {0.0, 0.03 * mm, -0.05 * mm}) {
      const CamCurve cam = curve_of(shape, true, excess);
      EXPECT_NEAR(length_of(cam) / (2 * pi * kBore + excess), 1, 1e-8);
      EXPECT_NEAR((cam.at(0) - cam.at(pi / 2)) / (2 * kW0), 1, 1e-12);
    }
}

// Kind: closed form.  The curvature of the arcs, by differences: the arc at the lobe has one
// radius, which is smaller than that of the bore, and that between the lobes a larger one.
TEST(CamCurve, IdentityRadiiOfArcs) {
  const double gamma = 35 * deg;
  const double e = 2 * kW0 / (1 + std::tan(gamma) - 1 / std::cos(gamma));
  const CamCurve cam = curve_of(TwoArcs{gamma});
  const auto radius = [&](double angle) {
    const double h = 1e-3;
    const double r = kBore + cam.at(angle);
    const double first = cam.slope(angle);
    const double second = (cam.slope(angle + h) - cam.slope(angle - h)) / (2 * h);
    return std::pow(r * r + first * first, 1.5) / (r * r + 2 * first * first - r * second);
  };
  const double lobe = kBore + cam.at(0) - e;
  EXPECT_NEAR(radius(0.1) / lobe, 1, 1e-6);
  EXPECT_NEAR(radius(33 * deg) / lobe, 1, 1e-6);
  EXPECT_NEAR(radius(37 * deg) / (lobe + e / std::cos(gamma)), 1, 1e-6);
  EXPECT_NEAR(radius(1.4) / (lobe + e / std::cos(gamma)), 1, 1e-6);
  EXPECT_LT(lobe, kBore);
}

// Kind: closed form.  A disc passes through the points of its circle; a band round two discs has
// the length 2 pi R + 4 e, 1 % of the excess: steps of 1 deg.
TEST(CamCurve, IdentityTwoDiscs) {
  const double e = 1.1 * mm;
  const double R = kBore + kW0 - e;
  const CamCurve cam = curve_of(TwoDiscs{e});
  EXPECT_NEAR(cam.at(0), kW0, 1e-15);
  for (const double angle : {0.3, 0.9, 1.5, 2.0, 3.5}) {
    const double r = kBore + cam.at(angle);
    const double x = std::abs(r * std::cos(angle)) - e;
    EXPECT_NEAR(std::hypot(x, r * std::sin(angle)) / R, 1, 1e-12);
  }
  EXPECT_NEAR(cam.band_excess() / (2 * pi * (R - kBore) + 4 * e), 1, 0.01);
  const CamCurve loose({.radial_displacement = kW0, .shape = TwoDiscs{e}, .clearance = 0.02 * mm},
                       kBore, kMiddle, true);
  EXPECT_NEAR(loose.at(0.4), cam.at(0.4) - 0.02 * mm, 1e-15);
}

// Kind: limit.  Points of a cosine give the cosine: 0.01 w_0 between points 5 deg apart.
TEST(CamCurve, LimitPoints) {
  const CamCurve cam = curve_of(cosine_points(19));
  for (int i = 0; i <= 18; ++i)
    EXPECT_NEAR(cam.at(i * 5 * deg), kW0 * std::cos(i * 10 * deg), 1e-12);
  for (int i = 0; i < 90; ++i)
    EXPECT_NEAR(cam.at(i * deg), kW0 * std::cos(i * 2 * deg), 0.01 * kW0);
  EXPECT_NEAR(cam.at(-40 * deg), cam.at(40 * deg), 1e-15);
  EXPECT_NEAR(cam.at(140 * deg), cam.at(40 * deg), 1e-15);
  EXPECT_EQ(cam.farthest(), cam.at(0));
}

// Kind: identity.  The slope is the derivative of the height, of each shape.
TEST(CamCurve, IdentitySlope) {
  for (const CamShape& shape : {CamShape(FlattenedCosine{1.5}), CamShape(TwoArcs{30 * deg}),
                                CamShape(TwoDiscs{1.2 * mm}), CamShape(cosine_points(10))})
    for (const bool exact : {false, true}) {
      const CamCurve cam = curve_of(shape, exact);
      for (const double angle : {0.2, 0.45, 1.1, 2.0, 2.9, -0.3}) {
        const double h = 1e-5;
        EXPECT_NEAR(cam.slope(angle), (cam.at(angle + h) - cam.at(angle - h)) / (2 * h),
                    1e-6 * kW0);
      }
    }
}

// Kind: scaling.  The curve for small displacements differs by the second order.
TEST(CamCurve, ScalingSmallDisplacement) {
  const auto difference = [](const CamShape& shape, double w_0) {
    const CamFit fit{.radial_displacement = w_0, .shape = shape};
    const CamCurve exact(fit, kBore, kMiddle, true);
    const CamCurve small(fit, kBore, kMiddle, false);
    double most = 0;
    for (int i = 0; i <= 90; ++i)
      most = std::max(most, std::abs(exact.at(i * deg) - small.at(i * deg)));
    return most;
  };
  for (const double gamma : {20 * deg, 60 * deg}) {
    EXPECT_NEAR(difference(TwoArcs{gamma}, kW0) / difference(TwoArcs{gamma}, kW0 / 2), 4, 0.3);
    EXPECT_LT(difference(TwoArcs{gamma}, kW0), 0.1 * kW0);
  }
  EXPECT_NEAR(difference(TwoDiscs{1.2 * mm}, kW0) / difference(TwoDiscs{0.6 * mm}, kW0 / 2), 4,
              0.1);
}

// Kind: behaviour.  The files' profiles become shapes.
TEST(CamCurve, IdentityShapesOfAFile) {
  WaveGenerator generator;
  generator.cam_flattening = 0.7;
  EXPECT_EQ(std::get<FlattenedCosine>(cam_shape(generator)).flattening, 0.7);
  generator.cam_flattening = 0;
  generator.cam =
      Cam{.profile = CamProfile::ellipse, .arc_angle = {}, .disc_offset = {}, .point = {}};
  EXPECT_EQ(std::get<FlattenedCosine>(cam_shape(generator)).flattening, 1.5);
  generator.cam->profile = CamProfile::cosine;
  EXPECT_EQ(std::get<FlattenedCosine>(cam_shape(generator)).flattening, 0);
  generator.cam->profile = CamProfile::two_arcs;
  generator.cam->arc_angle = 0.5;
  EXPECT_EQ(cam_flattening(generator), std::nullopt);
  EXPECT_EQ(std::get<TwoArcs>(cam_shape(generator)).arc_angle, 0.5);
  generator.cam->profile = CamProfile::two_discs;
  generator.cam->disc_offset = 1 * mm;
  EXPECT_EQ(std::get<TwoDiscs>(cam_shape(generator)).offset, 1 * mm);
  generator.cam->profile = CamProfile::points;
  generator.cam->point = cosine_points(7);
  EXPECT_EQ(std::get<CamPoints>(cam_shape(generator)).size(), 7U);
}

TEST(CamCurve, InputOfRanges) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_named = [](const CamShape& shape, std::string_view field) {
    const std::string message =
        test::broken_rule([&] { check(shape, kW0, kBore, FieldPath("cam")); });
    EXPECT_NE(message.find(field), std::string::npos) << message;
  };
  expect_named(FlattenedCosine{-1}, "cam_flattening");
  expect_named(TwoArcs{4.9 * deg}, "cam.arc_angle");
  expect_named(TwoArcs{85.1 * deg}, "cam.arc_angle");
  expect_named(TwoArcs{nan}, "cam.arc_angle");
  expect_named(TwoDiscs{0.3 * mm}, "cam.disc_offset");
  expect_named(TwoDiscs{16 * mm}, "cam.disc_offset");
  const auto points = [](const auto& change) {
    CamPoints some = cosine_points(7);
    change(some);
    return some;
  };
  expect_named(points([](CamPoints& of) { of.resize(4); }), "cam.point");
  expect_named(points([](CamPoints& of) { of.resize(1001); }), "cam.point");
  expect_named(points([](CamPoints& of) { of[0].angle = 0.01; }), "cam.point[0].angle");
  expect_named(points([](CamPoints& of) { of[3].angle = of[2].angle; }), "cam.point[3].angle");
  expect_named(points([](CamPoints& of) { of[6].angle = 1.5; }), "cam.point[6].angle");
  expect_named(points([&](CamPoints& of) { of[2].height = nan; }), "cam.point[2].height");
  expect_named(points([](CamPoints& of) { of[2].height = 0.4 * mm; }), "cam.point[2].height");
  expect_named(points([](CamPoints& of) { of[0].height = 0.36 * mm; }), "cam.point[0].height");
  // An arc so small that its radius would be less than the distance of its centre from the axis
  const std::string message =
      test::broken_rule([&] { check(TwoArcs{5 * deg}, 2 * mm, kBore, {}); });
  EXPECT_NE(message.find("arc_angle"), std::string::npos) << message;
  const TubeSection rim{
      .outer_diameter = 62.8 * mm, .wall_thickness = 0.755 * mm, .length = 9 * mm};
  const std::string excess = test::broken_rule([&] {
    check({.radial_displacement = kW0, .shape = TwoDiscs{1 * mm}, .perimeter_excess = 1e-6}, rim);
  });
  EXPECT_NE(excess.find("perimeter_excess"), std::string::npos) << excess;
}

}  // namespace
}  // namespace strainwave
