// SPDX-License-Identifier: Apache-2.0
// The contact problem inside the torsion curve: reciprocity and energy of its tangent (TC-15).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "coupled_drive.hpp"
#include "strainwave/core/error.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

/// Size 25, circular spline in its housing.
GearSet housed_drive(double ratio) {
  GearSet gear = test::typical_drive(25, ratio);
  test::half_free(gear);
  return gear;
}

/// The drive of ratio 100, sound or with a crack in every ring.
CoupledDrive assembled(bool cracked) {
  const GearSet gear = housed_drive(100);
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
  // Maxwell and Betti: an outward displacement e_k of ball k turns the output by -dQ_k/dT per unit.
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
  // Clapeyron: the energies of all members equal the work of the torque on its rotation.
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
    EXPECT_NEAR(carried * std::cos(g.flank_angle) * g.pitch_radius / torque, 1.0, 1e-10);
  }
}

TEST(ContactProblem, IdentityAStateBetweenStepsKnowsItsRings) {
  // If the steps end too early, the closings due to the rings still agree with the forces.
  const GearSet gear = housed_drive(100);
  const CoupledDrive full = assembled(false);
  for (const int steps : {1, 3}) {
    CoupledDrive stopped(gear, coupled_geometry(gear, {}), {.max_iterations = steps});
    ASSERT_FALSE(stopped.assemble_on(full.cam_amplitude()));
    // Flanks that touch at the start let the steps leave out contacts that are far.
    const Equilibrium start = full.solve(14.0, full.assembled());
    const Equilibrium state = stopped.solve(48.0, start);
    ASSERT_FALSE(state.converged);
    const Eigen::VectorXd elastic = full.rings().closings(state.force);
    EXPECT_LT((state.elastic - elastic).cwiseAbs().maxCoeff(),
              1e-12 * elastic.cwiseAbs().maxCoeff());
    EXPECT_GT((start.elastic - elastic).cwiseAbs().maxCoeff(),
              1e-3 * elastic.cwiseAbs().maxCoeff());
  }
}

/// Expects that the flexibility of a drive is that of the modes of its rings.
void expect_flexibility_of_modes(const CoupledDrive& drive, const std::string& what) {
  const Eigen::MatrixXd& flexibility = drive.rings().flexibility();
  const double largest = flexibility.cwiseAbs().maxCoeff();
  const int drive_flanks = drive.balls();
  const int coast_flanks = drive_flanks + drive.tooth_count();
  for (const int j : {0, 5, drive.balls() - 1, drive_flanks, drive_flanks + 7, coast_flanks - 1,
                      coast_flanks, coast_flanks + 7, drive.contacts() - 1}) {
    const Eigen::VectorXd force = Eigen::VectorXd::Unit(drive.contacts(), j);
    const Eigen::VectorXd closed = drive.rings().closings_of(drive.coefficients_of(force));
    EXPECT_LT((flexibility.col(j) + closed).cwiseAbs().maxCoeff(), 1e-12 * largest)
        << what << " " << j;
  }
}

TEST(ElasticRings, IdentityFlexibilityIsThatOfTheModes) {
  // Contact to contact by a series in the angle between them and its symmetries (TC-4), against the
  // coefficients of all modes: with an even and an odd number of teeth, with and without a ball at
  // the lobe, for columns of a ball, a drive flank and a coast flank.
  for (const double ratio : {100.0, 50.5})
    for (const double cage_phase : {0.0, 0.1}) {
      const GearSet gear = housed_drive(ratio);
      const CoupledGeometry g = coupled_geometry(gear, {});
      const CoupledDrive sound(gear, g, {.cage_phase = cage_phase});
      const CoupledDrive cracked = sound.cracked(
          {.hinges = {{RingHinge::Ring::rim, 0.3, 2 * g.rim_thickness, 0.4 * g.rim_bending * 1e-3},
                      {RingHinge::Ring::spline, 0.1, 1e-2, 0.2 * g.spline_bending * 1e-2}},
           .teeth = {},
           .balls = {}});
      const std::string what = std::to_string(ratio) + " " + std::to_string(cage_phase);
      expect_flexibility_of_modes(sound, what);
      expect_flexibility_of_modes(cracked, what + " cracked");
      EXPECT_GT((cracked.rings().flexibility() - sound.rings().flexibility()).cwiseAbs().maxCoeff(),
                1e-3 * sound.rings().flexibility().cwiseAbs().maxCoeff());
    }
}

TEST(ElasticRings, IdentityFlexibilityOfFlanksOfAllDirections) {
  // Each half-path flank has its own shares in three directions.  Without a circular spline there
  // are no neighbours (TC-31), which the modes do not contain.
  GearSet gear = housed_drive(100);
  gear.circular_spline.reset();
  gear.mesh->tooth.emplace().profile = ToothProfile::half_path;
  const CoupledDrive drive(gear, coupled_geometry(gear, {}), {});
  ASSERT_NE(drive.shares_of(drive.balls()).higher, drive.shares_of(drive.balls() + 1).higher);
  expect_flexibility_of_modes(drive, "half paths");
}

TEST(ElasticRings, IdentityTheWavesOfATurnRepeat) {
  // Harmonics of multiples of half a pitch, from a table of one turn, against the functions.
  // Tolerance: rounding of the angles of the functions, up to 400 rad.
  for (const int pitches : {1, 2, 3, 23, 24, 50, 101, 202}) {
    const HalfPitches angles(pitches);
    const Waves waves = angles.waves(2 * pitches + 3, 64, [](Eigen::Index i) { return i; });
    for (Eigen::Index i = 0; i < waves.cosine.cols(); ++i)
      for (int n = 0; n <= 64; ++n) {
        const double angle = n * std::numbers::pi * static_cast<double>(i) / pitches;
        ASSERT_NEAR(waves.cosine(n, i), std::cos(angle), 3e-13) << pitches << " " << i << " " << n;
        ASSERT_NEAR(waves.sine(n, i), std::sin(angle), 3e-13) << pitches << " " << i << " " << n;
      }
  }
}

TEST(ContactProblem, IdentityAJumpOfTheLoadIsManySteps) {
  // The steps leave out contacts that are far from touching, and all contacts judge the result: one
  // jump brings contacts to bear that were far away.  Tolerance: that of the solver.
  for (const bool cracked : {false, true}) {
    CoupledDrive drive = assembled(cracked);
    for (const double torque : {200.0, -200.0}) {
      const Equilibrium jump = drive.solve(torque, drive.assembled());
      ASSERT_TRUE(jump.converged);
      Equilibrium state = drive.assembled();
      constexpr int kSteps = 20;
      for (int i = 1; i <= kSteps; ++i) state = drive.solve(torque * i / kSteps, state);
      ASSERT_TRUE(state.converged);
      const double largest = state.force.cwiseAbs().maxCoeff();
      EXPECT_LT((jump.force - state.force).cwiseAbs().maxCoeff(), 1e-9 * largest);
      EXPECT_NEAR(jump.rotation / state.rotation, 1.0, 1e-10);
      const auto touching = [&](const Equilibrium& of) { return (of.force.array() > 0).count(); };
      EXPECT_GT(touching(state), touching(drive.assembled()) + 10);
      // Back, in one jump too: contacts open.
      const Equilibrium back = drive.solve(0.05 * torque, state);
      const Equilibrium there = drive.solve(0.05 * torque, drive.assembled());
      // From its own state, which one step with the contacts that are near confirms.
      const Equilibrium again = drive.solve(torque, state);
      ASSERT_TRUE(back.converged && there.converged && again.converged);
      EXPECT_NEAR(back.rotation / there.rotation, 1.0, 1e-10);
      for (const Equilibrium& of : std::vector<Equilibrium>{jump, state, back, there, again}) {
        // Closings and forces of all contacts, also of those that the steps left out.
        const Eigen::VectorXd elastic = drive.rings().closings(of.force);
        EXPECT_LT((of.elastic - elastic).cwiseAbs().maxCoeff(),
                  1e-12 * elastic.cwiseAbs().maxCoeff());
        EXPECT_LT(of.residual, 1e-10);
      }
    }
  }
}

TEST(ContactProblem, IdentityPlayOfTheFlanks) {
  // Flanks that are far from touching at rest carry the torque after the ring has turned through
  // the play.  The play is a gap over the closing per unit of rotation.
  GearSet gear = housed_drive(100);
  gear.mesh->lobe_gap = 0.0;
  const double gap = 20e-6;  // beyond the reach of the contacts that the steps see
  CoupledDrive tight(gear, coupled_geometry(gear, {}), {});
  gear.mesh->lobe_gap = gap;
  CoupledDrive loose(gear, coupled_geometry(gear, {}), {});
  ASSERT_TRUE(tight.assemble() && loose.assemble());
  const double turn = loose.rings().model().turn(loose.shares_of(loose.balls()));
  for (const double torque : {30.0, -30.0}) {
    const Equilibrium state = loose.solve(torque, loose.assembled());
    ASSERT_TRUE(state.converged);
    EXPECT_NEAR((state.rotation - tight.solve(torque, tight.assembled()).rotation) * turn,
                torque > 0 ? gap : -gap, 1e-9);
  }
}

TEST(ContactProblem, IdentityAssemblyOfUnusualBearings) {
  // The assembly begins with forces in the shape of a typical drive (TC-12).  Other bearings reach
  // the same end: few balls, many balls, clearance, a flattened cam.
  struct Case {
    int balls;
    double clearance;
    double flattening;
  };
  for (const auto& [balls, clearance, flattening] :
       {Case{7, 0.0, 0.0}, Case{36, 0.0, 0.0}, Case{23, 60e-6, 0.0}, Case{23, 0.0, 5.5},
        Case{8, 9e-5, 6.0}}) {
    GearSet gear = housed_drive(100);
    gear.wave_generator->bearing->ball_count = balls;
    gear.wave_generator->bearing->clearance = clearance;
    gear.wave_generator->cam_flattening = flattening;
    CoupledDrive drive(gear, coupled_geometry(gear, {}), {});
    ASSERT_TRUE(drive.assemble()) << balls << " " << clearance << " " << flattening;
    const double w0 = gear.drive.radial_displacement;
    EXPECT_NEAR(drive.rings().lobe(drive.assembled().force) / w0, 1.0, 1e-9);
    CoupledDrive other(gear, drive.geometry(), {});
    ASSERT_TRUE(other.assemble_on(drive.cam_amplitude()));  // begins without forces
    const double largest = drive.assembled().force.maxCoeff();
    EXPECT_LT((other.assembled().force - drive.assembled().force).cwiseAbs().maxCoeff(),
              1e-9 * largest);
  }
}

TEST(ElasticRings, IdentityNominalWaveOfEachContact) {
  // A ball has the opposite sign; the flanks of a tooth are mirror images of each other.
  const GearSet gear = housed_drive(50.5);
  const CoupledDrive drive(gear, coupled_geometry(gear, {}), {});
  for (int k = 0; k < drive.balls(); ++k)
    EXPECT_DOUBLE_EQ(drive.rings().of_nominal_wave(k, 2e-4),
                     -2e-4 * std::cos(2 * drive.position_of(k)));
  const double up = std::sin(drive.geometry().flank_angle);
  for (int i = drive.balls(); i < drive.balls() + drive.tooth_count(); ++i)
    EXPECT_NEAR(drive.rings().of_nominal_wave(i, 1.0) +
                    drive.rings().of_nominal_wave(i + drive.tooth_count(), 1.0),
                2 * up * std::cos(2 * drive.position_of(i)), 1e-15);
}

TEST(ElasticRings, BehaviourEveryFurtherHingeSoftensItsRing) {
  // Cracks at the least distance that `check` accepts, nearly as deep as their rings.  A hinge
  // increases the closing of every contact under its own force; two overlapping hinges would reduce
  // it again.
  const GearSet gear = housed_drive(100);
  const CoupledGeometry g = coupled_geometry(gear, {});
  const CoupledDrive sound(gear, g, {});
  const auto closing = [&](const std::vector<RingHinge>& hinges) -> Eigen::VectorXd {
    return sound.cracked({.hinges = hinges, .teeth = {}, .balls = {}})
        .rings()
        .flexibility()
        .diagonal();
  };
  const double spline_thickness = 2 * (g.spline_radius - g.pitch_radius);
  for (const auto& [ring, thickness, bending, radius] :
       {std::tuple{RingHinge::Ring::rim, g.rim_thickness, g.rim_bending, g.ring_radius},
        {RingHinge::Ring::outer, g.outer_thickness, g.outer_bending, g.ring_radius},
        {RingHinge::Ring::spline, spline_thickness, g.spline_bending / g.support,
         g.spline_radius}}) {
    const double length = 2 * thickness;
    const RingHinge hinge{ring, 0.3, length, 0.99 * bending * length};
    RingHinge beside = hinge;
    beside.position += length / radius;
    const Eigen::VectorXd one = closing({hinge});
    for (const Eigen::VectorXd& more :
         {Eigen::VectorXd(one - closing({})), Eigen::VectorXd(closing({hinge, beside}) - one)}) {
      EXPECT_GE(more.minCoeff(), 0.0);
      EXPECT_GT(more.maxCoeff(), 1e-3 * one.maxCoeff());
    }
  }
}

TEST(ContactProblem, CrosscheckAShallowHingeTurnsTheRingByItsCurvature) {
  // (TC-22) to first order: eta kappa dkappa/dT less its value without torque, where no flank
  // carries a force and dkappa/dT = 0.  The tolerance, 2 % of the largest rotation, stands for
  // terms of second order and for the mode n = 0, which belongs to the curvature and not to the
  // hinge.
  const GearSet gear = housed_drive(50);
  const CoupledGeometry g = coupled_geometry(gear, {});
  CoupledDrive sound(gear, g, {});
  ASSERT_TRUE(sound.assemble());
  const double length = 1e-5;
  std::vector<std::pair<double, double>> compared;
  double largest = 0.0;
  int stiffer = 0;
  for (const double angle : {0.9, 1.15, 1.4, 1.6, 2.0}) {
    const RingHinge hinge{RingHinge::Ring::outer, angle, length, 1e-2 * g.outer_bending * 2e-3};
    CoupledDrive cracked = sound.cracked({.hinges = {hinge}, .teeth = {}, .balls = {}});
    ASSERT_TRUE(cracked.assemble_on(sound.cam_amplitude()));
    const auto curvature = [&](const Eigen::VectorXd& force) {
      return sound.rings().curvature(sound.coefficients_of(force), angle);
    };
    EXPECT_EQ(curvature(sound.tangent(sound.assembled()).force), 0.0);
    for (const double torque : {-10.0, -2.0, 2.0, 10.0}) {
      const Equilibrium state = sound.solve(torque, sound.assembled());
      const Equilibrium soft = cracked.solve(torque, cracked.assembled());
      const double turned = (soft.rotation - cracked.assembled().rotation) -
                            (state.rotation - sound.assembled().rotation);
      const double first_order = hinge.softening * curvature(state.force) *
                                 curvature(sound.tangent(state).force) * g.ring_radius;
      compared.emplace_back(turned, first_order);
      largest = std::max(largest, std::abs(turned));
      stiffer += turned * torque < 0 ? 1 : 0;
    }
  }
  for (const auto& [turned, first_order] : compared)
    EXPECT_NEAR(turned, first_order, 2e-2 * largest);
  EXPECT_GE(stiffer, 4);
}

TEST(ElasticRings, BehaviourHingesOnOneAnotherAreRefused) {
  const GearSet gear = housed_drive(100);
  const CoupledGeometry g = coupled_geometry(gear, {});
  const double length = 0.02;
  const RingHinge hinge{RingHinge::Ring::spline, 0.3, length,
                        0.9 * g.spline_bending / g.support * length};
  const CoupledDrive sound(gear, g, {});
  EXPECT_NO_THROW((void)sound.cracked({.hinges = {hinge}, .teeth = {}, .balls = {}}));
  EXPECT_THROW((void)sound.cracked({.hinges = {hinge, hinge}, .teeth = {}, .balls = {}}),
               SolverError);
}

TEST(RingShapes, IdentityEachCoefficientMovesTheRingAsItsWave) {
  // (TC-1): w = a cos n theta + b sin n theta, v = c cos n theta + d sin n theta.  The second road
  // for the curvature -(w'' + w)/R^2 and the hoop strain (w + v')/R is central differences of w and
  // v over 1e-3 of a wave.  Tolerance 1e-6 of the largest term: their truncation is 2e-7.
  const CoupledDrive drive = assembled(false);
  const ElasticRings& rings = drive.rings();
  const RingModel<double>& model = rings.model();
  const double R = model.ring_radius();
  const double theta = 0.3;
  for (const int n : {0, 1, 2, 3, model.harmonics()})
    for (int k = 0; k < (n == 0 ? 1 : 4); ++k) {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(model.coefficients());
      x[n == 0 ? 0 : model.at(n) + k] = 1.0;
      const double wave = k % 2 == 0 ? std::cos(n * theta) : std::sin(n * theta);
      EXPECT_NEAR(rings.radial(x, theta), k < 2 ? wave : 0.0, 1e-12) << n << ' ' << k;
      EXPECT_NEAR(rings.tangential(x, theta), k < 2 ? 0.0 : wave, 1e-12) << n << ' ' << k;
      const double h = 1e-3 / std::max(n, 1);
      const auto w = [&](double step) { return rings.radial(x, theta + step); };
      const auto v = [&](double step) { return rings.tangential(x, theta + step); };
      EXPECT_NEAR(-R * R * rings.curvature(x, theta), (w(h) - 2 * w(0) + w(-h)) / (h * h) + w(0),
                  1e-6 * (1 + n * n))
          << n << ' ' << k;
      EXPECT_NEAR(R * rings.hoop_strain(x, theta), w(0) + (v(h) - v(-h)) / (2 * h), 1e-6 * (1 + n))
          << n << ' ' << k;
    }
}

TEST(RingShapes, IdentityACrackTakesItsEnergyFromItsOwnRing) {
  // (TC-22): at the same displacements, a crack reduces twice the energy of its own ring by eta
  // kappa^2, and that of no other member.  For a short length, kappa is the curvature of the ring
  // without the mode n = 0.  Tolerance 1e-6: rounding of sums that are 1e5 times larger.
  const CoupledDrive drive = assembled(false);
  const Equilibrium state = drive.solve(48.0, drive.assembled());
  ASSERT_TRUE(state.converged);
  const ElasticRings& sound = drive.rings();
  const Eigen::VectorXd x = sound.coefficients_of(state.force);
  const double R = sound.model().ring_radius();
  const auto shares = [&](const ElasticRings& rings) {
    std::array<double, kCurveMembers> share{};
    rings.add_shares(x, share);
    return share;
  };
  const auto before = shares(sound);
  const double angle = 0.2;
  for (const auto& [ring, member, stiffness] :
       {std::tuple{RingHinge::Ring::rim, CurveMember::rim_bending, drive.geometry().rim_bending},
        {RingHinge::Ring::outer, CurveMember::outer_ring_bending, drive.geometry().outer_bending},
        {RingHinge::Ring::spline, CurveMember::circular_spline, drive.geometry().spline_bending}}) {
    const RingHinge hinge{ring, angle, 1e-5, 0.5 * stiffness * 1e-5};
    const ElasticRings soft = sound.softened({hinge});
    const auto after = shares(soft);
    const double kappa = ring == RingHinge::Ring::spline
                             ? soft.model().softenings().back().curvature.dot(x)
                             : sound.curvature(x, angle) + x[0] / (R * R);
    ASSERT_NE(kappa, 0.0);
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_NEAR(before[i] - after[i],
                  i == static_cast<std::size_t>(member) ? hinge.softening * kappa * kappa : 0.0,
                  1e-6 * hinge.softening * kappa * kappa)
          << i;
  }
}

TEST(RingShapes, IdentityTheLobeIsTheMeanOverBothLobes) {
  // (TC-12): the lobe displacement under contact forces is the mean of w at 0 and pi, also of
  // rings with cracks.  Tolerance 1e-10: rounding of the sums.
  for (const bool cracked : {false, true}) {
    const CoupledDrive drive = assembled(cracked);
    const Eigen::VectorXd& force = drive.assembled().force;
    const Eigen::VectorXd x = drive.rings().coefficients_of(force);
    const double mean =
        (drive.rings().radial(x, 0.0) + drive.rings().radial(x, std::numbers::pi)) / 2;
    EXPECT_NEAR(drive.rings().lobe(force) / mean, 1, 1e-10) << cracked;
  }
}

TEST(RingShapes, IdentityADiaphragmThatTapersHasItsMeanThickness) {
  // (TC-2) takes the mean thickness over the radius.  For a taper from the inner to the outer
  // diameter, the mean is that of both ends, exactly for sums over the middles of equal parts.
  // Tolerance 1e-12: rounding.
  const auto warping = [](const GearSet& gear, int n) {
    return CoupledDrive(gear, coupled_geometry(gear, {}), {}).rings().model().mode(n).diaphragm;
  };
  GearSet tapered = test::typical_drive();
  Diaphragm& diaphragm = *tapered.flexspline->diaphragm;
  const double at_outer = diaphragm.thickness;
  GearSet plain = tapered;
  plain.flexspline->diaphragm->thickness = 1.5 * at_outer;
  diaphragm.profile = {{.radius = diaphragm.inner_diameter / 2, .thickness = 2 * at_outer}};
  for (const int n : {2, 3, 8}) EXPECT_NEAR(warping(tapered, n) / warping(plain, n), 1, 1e-12) << n;
}

}  // namespace
}  // namespace strainwave
