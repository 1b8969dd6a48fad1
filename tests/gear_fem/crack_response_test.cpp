// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/crack_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"
#include "support/mpi.hpp"
#include "tube_body.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

TubeWithThroughCrack short_tube() {
  test::start_mpi();
  return {.material = {.youngs_modulus = 206e9, .poissons_ratio = 0.3},
          .mean_radius = 0.031,
          .wall_thickness = 0.0006,
          .length = 0.02,
          .half_length = 0.0015,
          .angle = 50 * pi / 180,
          .torque = 40,
          .order = 3,
          .check_growth = false};
}

/// Stress of a tube under a torque, on the plane of the crack.
std::vector<fem::Point3> tractions(const fem::CrackResponse& crack, const fem::SolidLoad& load) {
  std::vector<fem::Point3> result;
  for (const fem::CrackNode& node : crack.nodes()) {
    const auto s = load.stress_without_crack(node.place);
    fem::Point3 t{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) t[i] += s[i][k] * node.normal[k];
    result.push_back(t);
  }
  return result;
}

// (FE-54) Kind: identity of two roads: a load on the end with the contact of solve_solid, and the
// stress released on the faces through weight functions.  Both read the same integrals, but only
// the second as functionals.  Tolerance 2e-3 of the largest K: the stress between the nodes.
TEST(CrackResponse, IdentityOfFarLoadAndReleasedStress) {
  const TubeWithThroughCrack tube = short_tube();
  const fem::HexMesh mesh = mesh_tube_with_through_crack(tube);
  fem::SolidProblem problem = clamped_tube(tube.material);
  problem.order = tube.order;
  problem.crack_faces = fem::CrackFaces::contact;
  const fem::CrackResponse crack(mesh, problem);
  for (const double sense : {1.0, -1.0}) {
    fem::SolidLoad load = tube_torsion(tube.mean_radius, tube.wall_thickness, sense * tube.torque);
    const fem::CrackState state = crack.state(tractions(crack, load));
    const fem::SolidResult far = fem::solve_solid(mesh, problem, load);
    load.tractions.clear();
    load.released = true;
    const fem::SolidResult near = fem::solve_solid(mesh, problem, load);
    EXPECT_NEAR(near.added_work / far.added_work, 1, 1e-3);
    EXPECT_NEAR(near.work / near.added_work, 1, 1e-9);
    EXPECT_LT(near.energy_balance, 1e-8);
    EXPECT_NEAR(state.contact_share, far.contact_share, 0.03);
    std::size_t s = 0;
    for (std::size_t f = 0; f < far.fronts.size(); ++f)
      for (std::size_t i = 0; i < far.fronts[f].stations.size(); ++i, ++s) {
        const fem::FrontStation& a = far.fronts[f].stations[i];
        const fem::FrontStation& b = near.fronts[f].stations[i];
        const fem::StationFactors& K = state.stations[s];
        const double scale = std::sqrt(a.G_of_K / a.energy_release_rate);
        const double largest = std::hypot(a.K_I, a.K_II, a.K_III);
        EXPECT_NEAR(b.energy_release_rate / a.energy_release_rate, 1, 5e-3) << s;
        EXPECT_NEAR(K.K_I, scale * a.K_I, 2e-3 * largest) << s;
        EXPECT_NEAR(K.K_II, scale * a.K_II, 2e-3 * largest) << s;
        EXPECT_NEAR(K.K_III, scale * a.K_III, 2e-3 * largest) << s;
        EXPECT_EQ(K.closed, a.closed);
        EXPECT_EQ(crack.stations()[s].front, f);
        EXPECT_DOUBLE_EQ(crack.stations()[s].position, a.position);
      }
    EXPECT_EQ(s, state.stations.size());
  }
}

}  // namespace
}  // namespace strainwave::gear_fem
