// SPDX-License-Identifier: Apache-2.0
//
// Surface cracks of an output shaft.
#include "strainwave/sif/member/shaft_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_cracks/reference_stress.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should
using std::numbers::pi;

DriveCrack surface_of_shaft(double inner_diameter, double depth, double half_length,
                            double axial_force = 0.0) {
  GearSet gear = test::article_gear(1 * mm);
  gear.load.axial_force = axial_force;
  gear.output_shaft->inner_diameter = inner_diameter;
  gear.output_shaft->crack = {ShaftSurfaceCrack{.depth = depth, .half_length = half_length}};
  return drive_cracks(gear).back();
}

TEST(ShaftSurfaceCrack, CrosscheckFrontAndMoment) {  // FR-22, GR-34, GR-35
  const DriveCrack crack = surface_of_shaft(0.0, 5 * mm, 8 * mm);
  EXPECT_EQ(crack.kind, "surface");
  EXPECT_EQ(crack.turning, TurningLoad::bending);
  EXPECT_TRUE(crack.reverses);
  EXPECT_TRUE(crack.unknown.empty());
  test::expect_relative(crack.range_end, 35 * mm, 1e-5);
  test::expect_relative(crack.ligament, 65 * mm, 1e-12);
  // At another size: from near the surface to the deepest point.
  const CrackSize size = CrackSize::of(9 * mm, 11 * mm);
  const sif::ShaftSurfaceSolid there(
      {.depth = 9 * mm, .half_length = 11 * mm, .diameter = 70 * mm});
  const auto front = crack.front(size, Faces::open);
  const auto bent = crack.bending(size);
  ASSERT_EQ(front.size(), bent.size());
  for (const auto& [i, s] : {std::pair{std::size_t{0}, 0.1}, std::pair{front.size() - 1, 1.0}}) {
    const auto K = there.stress_intensity(9 * mm, s);
    test::expect_relative(front[i].load.I[kAxial], K.I[kAxial], 1e-12);
    test::expect_relative(front[i].load.III[kTorsion], K.III[kTorsion], 1e-12);
    test::expect_relative(bent[i][0], there.turning_bending(9 * mm, s), 1e-12);
    EXPECT_EQ(bent[i][1], 0.0);
  }
  EXPECT_EQ(front.back().load.II[kTorsion], 0.0);
  EXPECT_EQ(crack.front(size, Faces::pressed).front().load.I[kAxial], 0.0);
  const DriveCrack hollow = surface_of_shaft(45 * mm, 5 * mm, 8 * mm);
  test::expect_relative(hollow.range_end, 0.6 * 12.5 * mm, 1e-12);
  EXPECT_GT(hollow.front(hollow.size, Faces::open).front().load.II[kTorsion], 0.0);
}

TEST(ShaftSurfaceCrack, BehaviourForceDecidesTheFaces) {  // FR-17
  for (const double inner : {0.0, 45 * mm})
    for (const double P : {-1e3, 0.0, 1e3}) {
      const DriveCrack crack = surface_of_shaft(inner, 3 * mm, 4 * mm, P);
      const Faces expected = P > 0 ? Faces::open : P < 0 ? Faces::pressed : Faces::touching;
      EXPECT_EQ(crack.faces.positive, expected);
      EXPECT_EQ(crack.faces.negative, expected);
    }
}

/// Plastic torque and axial force of a section per unit of strength, by sums over a grid: the sand
/// heap with a roof over the bore, and the axial force without a moment.
struct GridSection {
  double moment = 0.0;
  double area = 0.0;
};
GridSection on_a_grid(double r_o, double r_i, double h) {
  constexpr int kGrid = 1400;
  const double step = 2 * r_o / kGrid;
  GridSection sum;
  double first_moment = 0.0;  // of the tension side, from the far side on
  double total = 0.0;
  std::vector<std::pair<double, double>> strips;  // x, width
  for (int i = 0; i < kGrid; ++i) {
    const double x = -r_o + (i + 0.5) * step;
    double width = 0.0;
    for (int j = 0; j < kGrid; ++j) {
      const double y = -r_o + (j + 0.5) * step;
      const double r = std::hypot(x, y);
      if (r > r_o || x > r_o - h) continue;
      const double roof = r_o - r_i - h;
      if (r < r_i) {
        sum.moment += 2 * roof * step * step;
        continue;
      }
      width += step;
      sum.moment += 2 * std::min({r_o - r, r_o - h - x, roof + r - r_i}) * step * step;
    }
    strips.emplace_back(x, width);
    total += x * width * step;
  }
  // Reverse the strips of the far side until the moment vanishes.
  first_moment = total;
  for (const auto& [x, width] : strips) {
    const bool reversed = first_moment < 0;
    if (reversed) first_moment -= 2 * x * width * step;
    sum.area += (reversed ? -1 : 1) * width * step;
  }
  return sum;
}

TEST(ShaftSurfaceCrack, CrosscheckPlasticSectionOnAGrid) {  // FA-15
  // Tolerance: the grid.
  struct Case {
    double inner, depth;
  };
  for (const Case& c : {Case{0.0, 0.1}, Case{0.0, 0.5}, Case{0.0, 0.9}, Case{0.5, 0.1},
                        Case{0.5, 0.3}, Case{0.8, 0.1}}) {
    const OneSidedSection section{
        .outer_radius = 1.0, .inner_radius = c.inner, .depth = c.depth, .chord_depth = c.depth};
    const GridSection grid = on_a_grid(1.0, c.inner, c.depth);
    test::expect_relative(std::sqrt(3.0) / one_sided_reference_stress(section, 0.0, 1.0),
                          grid.moment, 2e-3);
    test::expect_relative(1 / one_sided_reference_stress(section, 1.0, 0.0), grid.area, 5e-3);
  }
}

TEST(ShaftSurfaceCrack, LimitReferenceStress) {  // FA-15, FA-7
  for (const double inner : {0.0, 0.3, 0.8}) {
    const NetRing whole{.outer_radius = 1.0, .inner_radius = inner};
    const OneSidedSection sound{
        .outer_radius = 1.0, .inner_radius = inner, .depth = 0.0, .chord_depth = 0.0};
    for (const auto& [P, T] : {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{2.0, -1.0}})
      test::expect_relative(one_sided_reference_stress(sound, P, T),
                            ring_reference_stress(whole, P, T), 1e-7);
    // A crack on one side never weakens more than one all round, and always more than none.
    for (const double a : {0.02, 0.1, 0.19}) {
      const OneSidedSection cracked{
          .outer_radius = 1.0, .inner_radius = inner, .depth = a, .chord_depth = 1.5 * a};
      const NetRing ring{.outer_radius = 1.0 - a, .inner_radius = inner};
      EXPECT_LE(one_sided_reference_stress(cracked, 1.0, 1.0),
                ring_reference_stress(ring, 1.0, 1.0) * (1 + 1e-9));
      EXPECT_GT(one_sided_reference_stress(cracked, 1.0, 1.0),
                ring_reference_stress(whole, 1.0, 1.0));
    }
  }
  // A chord that reaches the bore leaves the ring.
  const OneSidedSection deep{
      .outer_radius = 1.0, .inner_radius = 0.8, .depth = 0.15, .chord_depth = 0.3};
  test::expect_relative(
      one_sided_reference_stress(deep, 1.0, 2.0),
      ring_reference_stress({.outer_radius = 0.85, .inner_radius = 0.8}, 1.0, 2.0), 1e-12);
}

TEST(ShaftSurfaceCrack, InputReferenceStress) {  // FA-15
  const OneSidedSection good{
      .outer_radius = 1.0, .inner_radius = 0.5, .depth = 0.1, .chord_depth = 0.1};
  const auto refused = [](OneSidedSection section) {
    EXPECT_THROW((void)one_sided_reference_stress(section, 1.0, 1.0), InputError);
  };
  OneSidedSection bad = good;
  bad.inner_radius = -0.1;
  refused(bad);
  bad = good;
  bad.depth = 0.5;
  refused(bad);
  bad = good;
  bad.chord_depth = 0.09;
  refused(bad);
}

TEST(ShaftSurfaceCrack, CrosscheckPlasticSectionBySums) {  // FA-15
  // Finer than the grid: the axial force by strips of the tension side and of the far side that
  // balances its moment, the torque by sums in polar coordinates.
  struct Case {
    double inner, depth;
  };
  for (const Case& c : {Case{0.0, 0.1}, Case{0.0, 0.6}, Case{0.5, 0.2}, Case{0.8, 0.1}}) {
    const OneSidedSection section{
        .outer_radius = 1.0, .inner_radius = c.inner, .depth = c.depth, .chord_depth = c.depth};
    constexpr int kStrips = 400000;
    const double step = (2 - c.depth) / kStrips;
    const auto width_at = [&](int i) {
      const double x = -1 + (i + 0.5) * step;
      return std::pair{
          x, 2 * (std::sqrt(1 - x * x) - std::sqrt(std::max(c.inner * c.inner - x * x, 0.0)))};
    };
    double area = 0.0;
    double moment = 0.0;
    for (int i = 0; i < kStrips; ++i) {
      const auto [x, width] = width_at(i);
      area += width * step;
      moment += x * width * step;
    }
    for (int i = 0; moment < 0; ++i) {
      const auto [x, width] = width_at(i);
      area -= 2 * width * step;
      moment -= 2 * x * width * step;
    }
    test::expect_relative(1 / one_sided_reference_stress(section, 1.0, 0.0), area, 3e-5);
    constexpr int kRays = 1500;
    const double roof = 1 - c.inner - c.depth;
    double volume = roof * pi * c.inner * c.inner;
    const double dr = (1 - c.inner) / kRays;
    for (int j = 0; j < kRays; ++j)
      for (int i = 0; i < kRays; ++i) {
        const double cosine = std::cos((j + 0.5) * pi / kRays);
        const double r = c.inner + (i + 0.5) * dr;
        const double height = std::min({1 - r, 1 - c.depth - r * cosine, roof + r - c.inner});
        volume += 2 * std::max(height, 0.0) * r * dr * pi / kRays;
      }
    test::expect_relative(std::sqrt(3.0) / one_sided_reference_stress(section, 0.0, 1.0),
                          2 * volume, 2e-6);
  }
  // Under a long shallow crack the ring of the same depth carries more than what a chord leaves.
  const OneSidedSection flat{
      .outer_radius = 1.0, .inner_radius = 0.0, .depth = 0.01, .chord_depth = 0.5};
  const NetRing ring{.outer_radius = 0.99, .inner_radius = 0.0};
  test::expect_relative(one_sided_reference_stress(flat, 1.0, 0.0),
                        ring_reference_stress(ring, 1.0, 0.0), 1e-12);
}

}  // namespace
}  // namespace strainwave
