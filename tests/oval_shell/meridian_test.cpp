// SPDX-License-Identifier: Apache-2.0
#include "meridian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "strainwave/core/units.hpp"

namespace strainwave::meridian {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 10 * mm reads as it should

using Unknowns = Eigen::Matrix<double, kElementUnknowns, 1>;

/// A cone with a rigid arm at its first end.
Element cone() {
  return {.r = {30 * mm, 27 * mm}, .z = {5 * mm, 9 * mm}, .thickness = 1 * mm, .arm = 0.4 * mm};
}

// (CU-1) Kind: identity.  Rigid motions strain nothing: a translation across the axis, and a
// rotation about an axis across it; both have one wave.  A rotation turns the normals by itself.
// Tolerance: rounding over the rotation.
TEST(Meridian, IdentityRigidMotions) {
  const Element element = cone();
  const double node = element.r[0] - element.arm;  // the arm carries the first node
  Unknowns shift = Unknowns::Zero();
  shift << 1, -1, 0, 0, 1, -1, 0, 0, 0, 0, 0, 0;
  Unknowns rotation = Unknowns::Zero();
  rotation << element.z[0], -element.z[0], -node, -1, element.z[1], -element.z[1], -element.r[1],
      -1, 0, 0, 0, 0;
  for (const double at : {0.0, 0.3, 1.0}) {
    const StrainRows rows = element.strains(1, at);
    EXPECT_LT((rows * shift).cwiseAbs().maxCoeff(), 1e-9);
    const Strains strains = rows * rotation;
    EXPECT_LT(strains.head<3>().cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT(strains.segment<3>(3).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(strains[6], -1, 1e-12);
    EXPECT_NEAR(strains[7], element.slope(), 1e-12);
    EXPECT_NEAR(strains[8], -element.rise(), 1e-12);
    const Eigen::Vector2d moved = element.displacement(1, at, 0) * rotation;
    EXPECT_NEAR(moved[0], element.z[0] + at * (element.z[1] - element.z[0]), 1e-14);
    EXPECT_NEAR(moved[1], -moved[0], 1e-14);
  }
}

// (CU-1) Kind: closed form.  A long cylinder with a held end under even pressure: p r^2/(E t) far
// from the ends, and the bending moment p/(2 k^2), k^4 = 3 (1 - nu^2)/(r t)^2, at the held end.
// Tolerance 0.5 %: the step of the elements, and t/r.
TEST(Meridian, LimitPressedCylinder) {
  const double r = 50 * mm;
  const double t = 0.5 * mm;
  const ShellCup cup{
      .barrel = {.outer_diameter = 2 * r + t, .wall_thickness = t, .length = 60 * mm},
      .rim = {.outer_diameter = 2 * r + t, .wall_thickness = t, .length = 10 * mm},
      .diaphragm = {},
      .youngs_modulus = 200 * GPa,
      .poissons_ratio = 0.3};
  const Meridian line = meridian_of(cup, 0);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(line.unknowns);
  for (const Element& element : line.elements)
    for (std::size_t g = 0; g < kGaussAt.size(); ++g) {
      const Eigen::Matrix<double, 1, kElementUnknowns> row =
          element.displacement(0, kGaussAt[g], 0).row(0);
      for (int i = 0; i < kElementUnknowns; ++i)
        if (const Eigen::Index at = element.unknown + place_of(i); at >= 0)
          load[at] += row[i] * kGaussWeight[g] * element.length() * r;
    }
  const Eigen::VectorXd x = Equations(line.elements, cup, 0).solve(load);
  const auto of = [&](const Element& element) {
    Unknowns part;
    for (int i = 0; i < kElementUnknowns; ++i) {
      const Eigen::Index at = element.unknown + place_of(i);
      part[i] = at >= 0 ? x[at] : 0.0;
    }
    return part;
  };
  const Element& middle = line.elements[line.elements.size() / 2];
  const double w = (middle.displacement(0, 0.5, 0) * of(middle))[0];
  EXPECT_NEAR(w / (r * r / (cup.youngs_modulus * t)), 1, 0.005);
  const Element& first = line.elements.front();
  const double k2 = std::sqrt(3 * (1 - 0.3 * 0.3)) / (r * t);
  const double D = cup.youngs_modulus * std::pow(t, 3) / (12 * (1 - 0.3 * 0.3));
  const double moment = std::abs((first.strains(0, 0) * of(first))[3]) * D;
  // The bend is linear in an element, so its end is the least exact place.
  EXPECT_NEAR(moment * 2 * k2, 1, 0.04);
}

// Kind: behaviour.  The parts of a cup follow each other; the rim hangs on its arm once, and the
// first node is held.
TEST(Meridian, BehaviourOfTheParts) {
  ShellCup cup{
      .barrel = {.outer_diameter = 62.5 * mm, .wall_thickness = 0.5 * mm, .length = 17 * mm},
      .rim = {.outer_diameter = 63.1 * mm, .wall_thickness = 0.7 * mm, .length = 9 * mm},
      .diaphragm = Diaphragm{.outer_diameter = 62 * mm,
                             .inner_diameter = 36 * mm,
                             .thickness = 0.8 * mm,
                             .profile = {}},
      .youngs_modulus = 206 * GPa,
      .poissons_ratio = 0.3};
  const Meridian whole = meridian_of(cup, 0);
  const Meridian band = meridian_of(cup, 5 * mm);
  EXPECT_EQ(whole.band_from, whole.rim_from);
  EXPECT_EQ(whole.band_to, whole.elements.size());
  EXPECT_GT(band.band_from, band.rim_from);
  EXPECT_LT(band.band_to, band.elements.size());
  for (const Meridian& line : {whole, band}) {
    EXPECT_LT(line.elements.front().unknown, 0);
    EXPECT_GT(line.barrel_from, 0U);
    EXPECT_NEAR(line.elements.front().z[0], -0.4 * mm, 1e-12);  // the middle of the diaphragm
    EXPECT_NEAR(line.elements[line.barrel_from].z[0], -0.4 * mm, 1e-12);
    int arms = 0;
    for (std::size_t e = 0; e < line.elements.size(); ++e) {
      const Element& element = line.elements[e];
      if (element.arm != 0) {
        ++arms;
        EXPECT_EQ(e, line.rim_from);
        EXPECT_NEAR(element.arm, 0.2 * mm, 1e-12);
      }
      if (e > 0) {
        EXPECT_NEAR(element.r[0] - element.arm, line.elements[e - 1].r[1], 1e-12);
      }
      if (e >= line.barrel_from) {
        EXPECT_LE(element.length(), 0.36 * std::sqrt(31.3 * mm * 0.8 * mm));
      }
    }
    EXPECT_EQ(arms, 1);
  }
  double pressed = 0;
  for (std::size_t e = band.band_from; e < band.band_to; ++e) pressed += band.elements[e].length();
  EXPECT_NEAR(pressed, 5 * mm, 1e-12);
  EXPECT_NEAR((band.elements[band.band_from].z[0] + band.elements[band.band_to - 1].z[1]) / 2,
              17 * mm + 4.5 * mm, 1e-12);
}

}  // namespace
}  // namespace strainwave::meridian
