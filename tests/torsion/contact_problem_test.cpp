// SPDX-License-Identifier: Apache-2.0
// The contact problem inside the torsion curve: reciprocity and energy of its tangent (TC-15).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "coupled_drive.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

/// Size 25, ratio 100, circular spline in its housing; sound, or with a crack in every ring.
CoupledDrive assembled(bool cracked) {
  GearSet gear = test::typical_drive(25, 100);
  test::half_free(gear);
  const CoupledGeometry g = coupled_geometry(gear, {});
  ContactCracks cracks;
  if (cracked) {
    cracks.hinges = {{RingHinge::Ring::rim, 0.3, 2 * g.rim_thickness, 0.4 * g.rim_bending * 1e-3},
                     {RingHinge::Ring::outer, -0.2, 2e-3, 0.3 * g.outer_bending * 1e-3},
                     {RingHinge::Ring::spline, 0.1, 1e-2, 0.2 * g.spline_bending * 1e-2}};
    cracks.teeth = {{0.05, 0.5}};
    cracks.balls = {{0.3, 2e-8}};
  }
  CoupledDrive drive = CoupledDrive(gear, g, {}).cracked(cracks);
  EXPECT_TRUE(drive.assemble());
  return drive;
}

TEST(ContactProblem, IdentityReciprocityOfBallsAndTorque) {
  // Maxwell and Betti: an outward push e_k of ball k turns the output by -dQ_k/dT per unit.
  for (const bool cracked : {false, true}) {
    CoupledDrive drive = assembled(cracked);
    for (const double torque : {14.0, 48.0, -48.0}) {
      const Equilibrium state = drive.solve(torque, drive.assembled());
      ASSERT_TRUE(state.converged);
      const CoupledDrive::Tangent loaded = drive.tangent(state);
      int carrying = 0;
      for (int k = 0; k < drive.balls(); ++k) {
        if (!(state.force[k] > 0)) continue;
        ++carrying;
        Eigen::VectorXd push = Eigen::VectorXd::Zero(drive.contacts());
        push[k] = 1.0;
        const double turned =
            drive.linear_response(state, push, 0.0).rotation / drive.geometry().ring_radius;
        EXPECT_NEAR(turned, -loaded.force[k], 1e-10 * loaded.force.cwiseAbs().maxCoeff()) << k;
      }
      EXPECT_GT(carrying, 8);
    }
  }
}

TEST(ContactProblem, IdentityEnergyOfTheTangentIsItsWork) {
  // Clapeyron: the energies of all members are the work of the torque on its rotation.
  for (const bool cracked : {false, true}) {
    CoupledDrive drive = assembled(cracked);
    const Equilibrium state = drive.solve(30.0, drive.assembled());
    const CoupledDrive::Tangent tangent = drive.tangent(state);
    std::array<double, kCurveMembers> share{};
    drive.add_shares(state, tangent, share);
    const double work = tangent.rotation / drive.geometry().ring_radius;
    EXPECT_NEAR(std::accumulate(share.begin(), share.end(), 0.0) / work, 1.0, 1e-11);
    for (const double energy : share) EXPECT_GE(energy, 0.0);
  }
}

TEST(ContactProblem, IdentityTangentIsTheSlope) {
  // Central differences: second order, and rounding of the difference.
  CoupledDrive drive = assembled(true);
  const double h = 1e-3;
  const Equilibrium state = drive.solve(30.0, drive.assembled());
  const Equilibrium more = drive.solve(30.0 + h, state);
  const Equilibrium less = drive.solve(30.0 - h, state);
  const CoupledDrive::Tangent tangent = drive.tangent(state);
  EXPECT_NEAR((more.rotation - less.rotation) / (2 * h) / tangent.rotation, 1.0, 1e-6);
  const double largest = tangent.force.cwiseAbs().maxCoeff();
  for (int i = 0; i < drive.contacts(); ++i)
    EXPECT_NEAR((more.force[i] - less.force[i]) / (2 * h), tangent.force[i], 1e-5 * largest);
}

TEST(ContactProblem, IdentityFlanksCarryTheTorque) {
  CoupledDrive drive = assembled(true);
  const CoupledGeometry& g = drive.geometry();
  for (const double torque : {5.0, -60.0}) {
    const Equilibrium state = drive.solve(torque, drive.assembled());
    double carried = 0.0;
    for (int i = drive.balls(); i < drive.contacts(); ++i)
      carried += (i < drive.balls() + drive.tooth_count() ? 1 : -1) * state.force[i];
    EXPECT_NEAR(carried * std::cos(g.force_angle) * g.pitch_radius / torque, 1.0, 1e-10);
  }
}

}  // namespace
}  // namespace strainwave
