// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/gear_fem/tube_through_crack.hpp"
#include "support/mpi.hpp"

namespace strainwave::gear_fem {
namespace {

using fem::Point3;

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Area of a small quadrilateral, from its diagonals.
double area(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Point3 p{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const Point3 q{d[0] - b[0], d[1] - b[1], d[2] - b[2]};
  return std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                    p[0] * q[1] - p[1] * q[0]) /
         2;
}

// (FE-39): the opening over the crack is the crack's volume, which the solver integrates separately
// from the displacement of each face.  Its largest value is that of a crack in a plate, 4 tau a/E,
// increased by the bulging of the wall.
TEST(TubeFields, CrosscheckOpeningOfAThroughCrack) {
  test::start_mpi();
  constexpr double kHalfLength = 0.01;
  const TubeCrackResult result =
      solve_tube_with_through_crack({.material = {.youngs_modulus = 210e9, .poissons_ratio = 0.3},
                                     .mean_radius = 0.07888,
                                     .wall_thickness = 0.00224,
                                     .length = 0.16,
                                     .half_length = kHalfLength,
                                     .angle = std::numbers::pi / 4,
                                     .torque = 100,
                                     .order = 2,
                                     .check_growth = false,
                                     .fields = {.divisions = 4}});
  const fem::SampledFields& fields = result.solid.fields;
  EXPECT_EQ(fields.cells.size(), result.solid.cells);
  double whole = 0.0;
  double volume = 0.0;
  double largest = 0.0;
  for (const fem::CrackFacePatch& patch : fields.crack_faces)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i) {
        const fem::CrackFacePoint& a = patch.points[j * 5 + i];
        const fem::CrackFacePoint& b = patch.points[j * 5 + i + 1];
        const fem::CrackFacePoint& c = patch.points[j * 5 + i + 6];
        const fem::CrackFacePoint& d = patch.points[j * 5 + i + 5];
        const double piece = area(a.place, b.place, c.place, d.place);
        whole += piece;
        volume += piece * (a.opening + b.opening + c.opening + d.opening) / 4;
        largest = std::max(largest, a.opening);
        EXPECT_LE(std::abs(a.opening), distance(a.upper, a.lower) * (1 + 1e-12));
      }
  EXPECT_NEAR(whole / (2 * kHalfLength * 0.00224), 1, 1e-3);  // straight pieces approximate a curve
  EXPECT_NEAR(volume / result.solid.crack_volume, 1, 0.02);   // the trapezoidal rule
  const double plate = 4 * result.nominal_shear * kHalfLength / 210e9;
  EXPECT_GT(largest, plate);
  EXPECT_LT(largest, 1.6 * plate);
}

}  // namespace
}  // namespace strainwave::gear_fem
