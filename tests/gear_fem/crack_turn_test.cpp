// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/crack_turn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "strainwave/core/error.hpp"
#include "support/mpi.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

BarrelEnds ends_of_size25() {
  return {
      .rim = TubeSection{.outer_diameter = 62.801e-3, .wall_thickness = 0.755e-3, .length = 9.5e-3},
      .diaphragm = Diaphragm{.outer_diameter = 62.046e-3,
                             .inner_diameter = 36.8e-3,
                             .thickness = 0.762e-3,
                             .profile = {}}};
}

TubeWithThroughCrack through_crack() {
  return {.material = {.youngs_modulus = 206e9, .poissons_ratio = 0.3},
          .mean_radius = 31.023e-3,
          .wall_thickness = 0.453e-3,
          .length = 17.2e-3,
          .half_length = 2e-3,
          .angle = pi / 4,
          .order = 2};
}

TurningCrack size25_turn(const TubeWithThroughCrack& tube = through_crack()) {
  test::start_mpi();
  return {.tube = tube,
          .ends = ends_of_size25(),
          .fit = {.radial_displacement = 0.3175e-3, .band_width = 9.2e-3},
          .torques = {-48, 0, 48}};
}

const StationTurn& station(const TorqueTurn& turn, std::string_view tip, double at) {
  for (const StationTurn& one : turn.stations)
    if (one.tip == tip && std::abs(one.station - at) < 1e-9) return one;
  throw InputError("station", "is missing");
}

// Kind: two roads.  Without an oval, K over a turn is constant and that of the cup under torque:
// the stress of the body of revolution released on the faces, against the torque on the end of the
// solid.  Tolerance 1.5 % of the largest K: order 2, and K that is not rescaled to G.
TEST(CrackTurn, CrosscheckCupUnderTorqueWithoutOval) {
  TubeWithThroughCrack still = through_crack();
  still.layers = 1;
  TurningCrack turning = size25_turn(still);
  turning.fit.radial_displacement = 1e-12;
  turning.torques = {48};
  turning.angles = 8;
  turning.check_growth = false;
  const CrackTurn turn = turn_crack(turning);
  EXPECT_FALSE(turn.usable);  // not compared with neighbouring sizes
  still.ends = ends_of_size25();
  still.torque = 48;
  still.check_growth = false;
  const TubeCrackResult cup = solve_tube_with_through_crack(still);
  ASSERT_EQ(turn.torques.size(), 1U);
  std::size_t s = 0;
  for (const fem::CrackFront& front : cup.solid.fronts)
    for (const fem::FrontStation& place : front.stations) {
      const StationTurn& over = turn.torques[0].stations.at(s++);
      EXPECT_NEAR(over.mode_I.range, 0, 1e-6 * place.K_I);
      EXPECT_NEAR(over.mode_I.largest / place.K_I, 1, 0.015);
      EXPECT_NEAR(over.factors[3].K_II, place.K_II, 0.01 * place.K_I);
      EXPECT_NEAR(over.factors[3].K_III, place.K_III, 0.01 * place.K_I);
      EXPECT_EQ(over.mode_I.open_share, 1);
    }
  EXPECT_EQ(s, turn.torques[0].stations.size());
}

// Kind: symmetry.  A mirror through the axis and the crack turns the torque and the crack's angle
// and the angle from the lobe: the upper tip remains the upper one.  Tolerance 1 % of the largest
// K: the mesh is not a mirror image of itself.
TEST(CrackTurn, IdentityMirroredDrive) {
  TubeWithThroughCrack one_way = through_crack();
  one_way.layers = 1;
  TurningCrack turning = size25_turn(one_way);
  turning.large_rotations = LargeRotations::off;
  turning.torques = {30};
  turning.angles = 12;
  turning.check_growth = false;
  TurningCrack mirrored = turning;
  TubeWithThroughCrack other_way = one_way;
  other_way.angle = -other_way.angle;
  mirrored.tube = other_way;
  mirrored.torques = {-30};
  const CrackTurn one = turn_crack(turning);
  const CrackTurn two = turn_crack(mirrored);
  for (const StationTurn& place : one.torques[0].stations) {
    const StationTurn& other = station(two.torques[0], place.tip, place.station);
    for (std::size_t i = 0; i < place.factors.size(); ++i) {
      const TurnFactor& a = place.factors[i];
      const TurnFactor& b = other.factors[place.factors.size() - 1 - i];
      EXPECT_NEAR(a.K_I, b.K_I, 0.01 * 3e6) << place.station << ' ' << i;
      EXPECT_NEAR(std::abs(a.K_II), std::abs(b.K_II), 0.01 * 3e6);
    }
  }
}

// (FE-55) Kind: regression, with the checks of the solution itself (dC/dA over the working energy,
// G of K). A trial with a plain barrel and an end free to warp found, for a crack near the rim, 0
// to 3.8 inside and 1.4 to 1.9 outside.  Tolerance 2 %: order 2 against order 3.
TEST(CrackTurn, RegressionSize25AtWork) {
  const TurningCrack turning = size25_turn();
  const CrackTurn turn = turn_crack(turning);
  EXPECT_TRUE(turn.usable) << turn.reason;
  EXPECT_EQ(turn.states, 108U);
  ASSERT_EQ(turn.torques.size(), 3U);
  const auto K = [&](std::size_t torque, double at) {
    return station(turn.torques[torque], "upper", at).mode_I;
  };
  EXPECT_NEAR(K(2, -1).largest, 3.07e6, 0.02 * 3e6);
  EXPECT_EQ(K(2, -1).least, 0);
  EXPECT_NEAR(K(2, 1).largest, 2.98e6, 0.02 * 3e6);
  EXPECT_NEAR(K(2, 1).least, 0.40e6, 0.02 * 3e6);
  EXPECT_NEAR(K(1, -1).largest, 1.54e6, 0.02 * 3e6);
  EXPECT_NEAR(K(1, 1).largest, 1.10e6, 0.02 * 3e6);
  EXPECT_LT(K(0, -1).largest, 0.4e6);
  EXPECT_GT(turn.torques[1].largest_contact_share, 0.5);  // one face shuts
  EXPECT_NEAR(turn.torques[2].checks.growth_check.value(), 0, 0.005);
  EXPECT_NEAR(turn.torques[1].checks.growth_check.value(), 0, 0.03);
  // What mode I says in numbers agrees with its own list.
  const StationTurn& inner = station(turn.torques[2], "upper", -1);
  EXPECT_EQ(inner.factors.size(), 37U);
  EXPECT_EQ(inner.factors.front().K_I, inner.factors.back().K_I);
  EXPECT_NEAR(inner.mode_I.range, inner.mode_I.largest - inner.mode_I.least, 1e-3);
  EXPECT_NEAR(inner.mode_I.ratio, inner.mode_I.least / inner.mode_I.largest, 1e-12);
  EXPECT_GT(inner.mode_I.open_share, 0.7);
  EXPECT_LT(inner.mode_I.open_share, 0.95);

  // The plane of the crack: 4 mm along, the wall through.
  const double wall = 0.453e-3;
  std::array along = {0.0, 0.0};
  std::array through = {0.0, 0.0};
  for (const CrackPlane::Node& node : turn.plane.nodes) {
    along[0] = std::min(along[0], node.along);
    along[1] = std::max(along[1], node.along);
    through[0] = std::min(through[0], node.through);
    through[1] = std::max(through[1], node.through);
  }
  EXPECT_NEAR(along[0], -2e-3, 0.01 * 2e-3);  // lengths are true at the middle surface
  EXPECT_NEAR(along[1], 2e-3, 0.01 * 2e-3);
  EXPECT_NEAR(through[0], -wall / 2, 1e-8);
  EXPECT_NEAR(through[1], wall / 2, 1e-8);
  EXPECT_NEAR(turn.plane.half_wall, wall / 2, 1e-12);
  for (const TorqueTurn& torque : turn.torques) {
    ASSERT_EQ(torque.faces.size(), 36U);
    double largest = 0;
    double share = 0;
    for (const FacesAtAngle& faces : torque.faces) {
      ASSERT_EQ(faces.opening.size(), turn.plane.nodes.size());
      for (std::size_t n = 0; n < faces.opening.size(); ++n) {
        largest = std::max(largest, faces.opening[n]);
        // Where the faces press on each other, they are no distance apart.
        EXPECT_TRUE(!faces.touching[n] || std::abs(faces.opening[n]) < 1e-12);
      }
      share = std::max(share, faces.contact_share);
    }
    EXPECT_EQ(torque.largest_opening, largest);
    EXPECT_EQ(torque.largest_contact_share, share);
    const auto at = static_cast<std::size_t>(std::lround(torque.at_opening / pi * 36));
    EXPECT_EQ(*std::max_element(torque.faces[at].opening.begin(), torque.faces[at].opening.end()),
              largest);
  }
  // The opening of a plate under tension is 4 sigma a/E; a face of this wall sees the bending of
  // the oval too, and the bulge adds up to a quarter.
  const double sheet = 4 * turn.largest_stress * 2e-3 / 206e9;
  EXPECT_LT(turn.torques[2].largest_opening, sheet);
  EXPECT_GT(turn.torques[2].largest_opening, 0.5 * sheet);
}

// Kind: closed forms of the sound wall at the height of the crack.  The oval of an inextensional
// cone, w = w_0 z/L cos 2 phi (3 %: the corner at the diaphragm); its stress turns over after a
// quarter turn; a torque adds T r sin(2 beta)/J to the stress normal to the crack (2 %).
TEST(CrackTurn, LimitRingOfTheSoundWall) {
  TubeWithThroughCrack crack = through_crack();
  crack.layers = 1;
  TurningCrack turning = size25_turn(crack);
  turning.torques = {0, 48};
  turning.angles = 8;
  turning.check_growth = false;
  turning.large_rotations = LargeRotations::off;
  const CrackTurn turn = turn_crack(turning);
  const SoundRing& ring = turn.ring;
  ASSERT_EQ(ring.radii.size(), 5U);
  ASSERT_EQ(ring.outward.size(), ring.angles.size());
  EXPECT_EQ(ring.angles.front(), 0);
  EXPECT_NEAR(ring.angles.back(), pi, 1e-12);
  EXPECT_NEAR(ring.radii.back() - ring.radii.front(), 0.453e-3, 1e-12);
  const std::size_t quarter = (ring.angles.size() - 1) / 2;
  const double w = 0.3175e-3 * 8.6e-3 / (17.2e-3 + 4.75e-3);
  EXPECT_NEAR((ring.outward[0] - ring.outward[quarter]) / (2 * w), 1, 0.03);
  EXPECT_NEAR(ring.outward.back(), ring.outward.front(), 1e-12);
  const double r = 31.023e-3;
  const double t = 0.453e-3;
  const double J = pi / 2 * (std::pow(r + t / 2, 4) - std::pow(r - t / 2, 4));
  const std::vector<double>& still = turn.torques[0].ring_stress;
  const std::vector<double>& loaded = turn.torques[1].ring_stress;
  ASSERT_EQ(still.size(), ring.angles.size() * ring.radii.size());
  for (std::size_t i = 0; i < ring.angles.size(); ++i)
    for (std::size_t k = 0; k < ring.radii.size(); ++k) {
      const double added = loaded[i * 5 + k] - still[i * 5 + k];
      EXPECT_NEAR(added / (48 * ring.radii[k] / J), 1, 0.02) << i << ' ' << k;
    }
  // At a lobe the wall bends further: tension outside, pressure inside.
  EXPECT_GT(still[4], 0);
  EXPECT_LT(still[0], 0);
  EXPECT_LT(still[quarter * 5 + 4], 0);
  EXPECT_GT(still[quarter * 5], 0);
}

// (FE-55) Kind: closed form, with the checks of the solution itself.  A shallow surface crack at 45
// degrees under torque and oval: where it is open, K at the deepest point follows the stress normal
// to it in the surface, K_I = Y sigma sqrt(pi a).  Y is that of a half-circle in tension, times the
// ratio of bending to tension of Newman and Raju at the deepest point, 1 - 1.34 a/t - 0.03 (a/t)^2
// at a/c = 1 (5 % at that place).  Tolerance 10 % of K under torque alone.
TEST(CrackTurn, LimitSurfaceCrackFollowsTheStressOfTheSurface) {
  TurningCrack turning = size25_turn();
  turning.tube = TubeWithSurfaceCrack{.material = through_crack().material,
                                      .mean_radius = 31.023e-3,
                                      .wall_thickness = 0.453e-3,
                                      .length = 17.2e-3,
                                      .depth = 0.09e-3,
                                      .half_length = 0.09e-3,
                                      .angle = pi / 4,
                                      .order = 2};
  turning.torques = {0, 48};
  turning.angles = 12;
  const CrackTurn turn = turn_crack(turning);
  EXPECT_TRUE(turn.usable) << turn.reason;
  const StationTurn& still = station(turn.torques[0], "upper", 1);
  const StationTurn& loaded = station(turn.torques[1], "upper", 1);
  const OvalCup cup(
      {.barrel = {.outer_diameter = 62.499e-3, .wall_thickness = 0.453e-3, .length = 17.2e-3},
       .rim = turning.ends.rim,
       .diaphragm = turning.ends.diaphragm},
      through_crack().material, turning.fit);
  const OvalPlace surface = cup.at(31.023e-3 + 0.2265e-3 - 1e-7, 0.762e-3 + 8.6e-3);
  // Normal to a crack at 45 degrees from +z toward -theta: (e_theta + e_z)/sqrt 2.
  const auto normal = [&](double angle, double torque) {
    const auto s = cup.field(surface, angle, torque).stress;
    return (s[1] + s[2]) / 2 + s[3];
  };
  const double Y = 0.66;  // of a half-circle in tension, at its deepest point
  const double share = 0.09 / 0.453;
  const double bending = 1 - 1.34 * share - 0.03 * share * share;
  std::size_t open = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const double angle = pi * static_cast<double>(i) / 12;
    const double oval = normal(angle, 0);
    const double torque = normal(angle, 48) - oval;
    const double root = Y * std::sqrt(pi * 0.09e-3);
    EXPECT_NEAR(loaded.factors[i].K_I, std::max(0.0, root * (torque + bending * oval)),
                0.1 * root * torque)
        << i;
    EXPECT_NEAR(still.factors[i].K_I, std::max(0.0, root * bending * oval), 0.1 * root * torque)
        << i;
    open += still.factors[i].K_I > 0 ? 1 : 0;
  }
  EXPECT_GT(open, 3U);  // the surface breathes
  EXPECT_LT(open, 9U);
  EXPECT_EQ(still.mode_I.least, 0);
  // The list runs from the surface to the deepest point, on both sides.
  EXPECT_EQ(turn.torques[0].stations.size(), 8U);
  EXPECT_LT(turn.torques[0].stations[0].station, turn.torques[0].stations[1].station);
  EXPECT_EQ(turn.torques[0].stations[3].station, 1);
  EXPECT_EQ(turn.torques[0].stations[7].station, 1);
}

TEST(CrackTurn, InputRefused) {
  TurningCrack turning = size25_turn();
  turning.torques = {};
  EXPECT_THROW((void)turn_crack(turning), InputError);
  turning = size25_turn();
  turning.angles = 7;
  EXPECT_THROW((void)turn_crack(turning), InputError);
  turning = size25_turn();
  turning.ends.rim.reset();
  EXPECT_THROW((void)turn_crack(turning), InputError);
  turning = size25_turn();
  turning.torques = {std::nan("")};
  EXPECT_THROW((void)turn_crack(turning), InputError);
}

}  // namespace
}  // namespace strainwave::gear_fem
