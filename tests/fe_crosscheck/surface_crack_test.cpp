// SPDX-License-Identifier: Apache-2.0
// Surface crack in the wall of a tube: finite elements against Newman and Raju's plate and the
// embedded ellipse in shear (SU-10).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/gear_fem/tube_surface_crack.hpp"
#include "strainwave/sif/tube/surface_inclined.hpp"
#include "support/mpi.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

// All modes at once, at 30 degrees, at order 2.  The closed form states 10 % of K.
TEST(FeSurfaceCrack, CrosscheckInclined) {
  test::start_mpi();
  const gear_fem::TubeWithSurfaceCrack tube{
      .material = {.youngs_modulus = 210e9, .poissons_ratio = 0.3},
      .mean_radius = 78.88e-3,
      .wall_thickness = 2.24e-3,
      .length = 160e-3,
      .depth = 1e-3,
      .half_length = 2e-3,
      .angle = pi / 6,
      .order = 2,
      .check_growth = false};
  const auto result = gear_fem::solve_tube_with_surface_crack(tube);
  const sif::TubeSurfaceInclined closed{.depth = tube.depth,
                                        .half_length = tube.half_length,
                                        .angle = tube.angle,
                                        .mean_radius = tube.mean_radius,
                                        .thickness = tube.wall_thickness,
                                        .poissons_ratio = 0.3};
  constexpr std::size_t kTorque = 1;
  const auto& stations = result.solid.fronts.at(0).stations;
  for (std::size_t i = 1; i + 1 < stations.size(); ++i) {
    const fem::FrontStation& s = stations[i];
    const double phi = std::min(s.position, 1 - s.position) * pi;
    const auto K = closed.stress_intensity(tube.depth, phi);
    const double largest = std::hypot(s.K_I, s.K_II, s.K_III);
    EXPECT_NEAR(K.I[kTorque], s.K_I, 0.1 * largest) << i;
    EXPECT_NEAR(std::abs(K.II[kTorque]), std::abs(s.K_II), 0.1 * largest) << i;
    EXPECT_NEAR(std::abs(K.III[kTorque]), std::abs(s.K_III), 0.1 * largest) << i;
  }
}

}  // namespace
}  // namespace strainwave
