// SPDX-License-Identifier: Apache-2.0
// Moments, hoop forces and stresses of the outer ring and of the circular spline.
#include "strainwave/torsion/ring_states.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "assembled_drive_contents.hpp"
#include "solved_drive.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "support/expect.hpp"
#include "support/reference_csv.hpp"
#include "torsion/typical_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr std::array kBending = {BendingRing::outer_ring, BendingRing::circular_spline};

std::vector<RingState> states_of(const GearSet& gear, BendingRing ring, double torque, int n,
                                 const CoupledOptions& options = {}) {
  return ring_states(AssembledDrive(gear, options), ring, torque, n);
}

double largest_moment(const std::vector<RingState>& states) {
  double most = 0.0;
  for (const RingState& state : states) most = std::max(most, std::abs(state.bending_moment));
  return most;
}

double largest_hoop_force(const std::vector<RingState>& states) {
  double most = 0.0;
  for (const RingState& state : states) most = std::max(most, std::abs(state.hoop_force));
  return most;
}

/// Forces on a thin ring of radius R that does not stretch, whose harmonics 0 and 1 something else
/// carries: closed forms of the sums over all other harmonics.
struct ThinRing {
  double moment = 0.0;
  double hoop = 0.0;

  /// @param angle  from the force to the place
  void add(double R, double angle, double outward, double along, double couple) {
    const double p = std::fmod(std::fmod(angle, 2 * pi) + 2 * pi, 2 * pi);
    const double half = (pi - p) / 2;  // sum of sin(n p)/n
    moment += R / pi *
              (outward * (0.5 + std::cos(p) / 4 - half * std::sin(p)) +
               along * (half * (std::cos(p) - 1) + 0.75 * std::sin(p)) +
               couple * (half * std::cos(p) - std::sin(p) / 4));
    hoop -= along / pi * (half - std::sin(p));
  }
};

/// Of the circular spline under the flanks of a drive with straight flanks, by statics.
ThinRing spline_by_statics(const GearSet& gear, const CurvePoint& point, double theta) {
  const CircularSpline& spline = *gear.circular_spline;
  const double R = (spline.outer_diameter + spline.inner_diameter) / 4;
  const double lever = (gear.drive.pitch_diameter / 2 - R) / R;
  ThinRing ring;
  for (const double side : {+1.0, -1.0})
    for (const ContactForce& flank : side > 0 ? point.drive_flanks : point.coast_flanks) {
      const double along = side * flank.force * std::cos(gear.mesh->flank_angle);
      ring.add(R, theta - flank.position, flank.force * std::sin(gear.mesh->flank_angle),
               along * (1 + lever), -along * lever);
    }
  ring.moment *= spline.support;
  ring.hoop *= spline.support;
  return ring;
}

TEST(RingStates, ReferenceFourierCoefficients) {  // TC-38, TC-39
  // tools/reference/coupled_drive.py solves the drive without condensation, takes the curvatures
  // from the shapes on a grid, and the hoop force from a staircase.  Tolerance: digits of the
  // table.
  const GearSet gear = [] {
    GearSet drive = test::typical_drive(25, 100);
    test::half_free(drive);
    return drive;
  }();
  const AssembledDrive drive(gear);
  constexpr int kCount = 256;
  int rows = 0;
  for (const double torque : {14.0, 48.0, 76.8, -14.0, -48.0, -76.8}) {
    const auto outer = ring_states(drive, BendingRing::outer_ring, torque, kCount);
    const auto spline = ring_states(drive, BendingRing::circular_spline, torque, kCount);
    for (const test::CsvRow& row : test::read_reference_csv("ring_states")) {
      if (row("torque") != torque) continue;
      ++rows;
      const auto i = static_cast<std::size_t>(std::lround(row("position") * kCount / (2 * pi)));
      if (row.quantity == "outer_ring.moment")
        EXPECT_NEAR(outer.at(i).bending_moment, row.value, 1e-8 * largest_moment(outer));
      else if (row.quantity == "circular_spline.moment")
        EXPECT_NEAR(spline.at(i).bending_moment, row.value, 1e-8 * largest_moment(spline));
      else
        EXPECT_NEAR(spline.at(i).hoop_force, row.value, 1e-8 * largest_hoop_force(spline));
    }
  }
  EXPECT_EQ(rows, 252);
}

TEST(RingStates, ReferenceRingUnderTwoOppositeForces) {  // TC-39
  // M = P R (1/pi - |sin theta|/2) of a thin ring pulled outward at 0 and pi, and no hoop force
  // beside that of the harmonics 0 and 1.  128 harmonics leave 1/(2 128^2 ...) of P R.
  GearSet gear = test::supported_drive();
  gear.circular_spline->support = 1;
  const AssembledDrive drive(gear, {.harmonics = 128});
  const CoupledDrive& contacts = drive.contents().drive;
  const double pitch = 2 * pi / 100;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(contacts.contacts());
  for (const double at : {pitch / 2, pi + pitch / 2}) {
    const int flank = contacts.drive_flank_at(at).value();
    ASSERT_NEAR(contacts.position_of(flank), at, 1e-12);
    force[flank] = force[flank + contacts.tooth_count()] = 100.0;  // their tangents cancel
  }
  const double P = 200 * std::sin(gear.mesh->flank_angle);
  const double R = drive.contents().geometry.spline_radius;
  const ElasticRings& rings = contacts.rings();
  const Eigen::VectorXd x = rings.coefficients_of(force);
  const auto hoop = rings.spline_hoop_force(force);
  for (const double theta : {0.0, 0.2, 0.7, 1.3, pi / 2, 2.5, 4.0}) {
    const double moment =
        drive.contents().geometry.spline_bending * rings.spline_curvature(x, theta + pitch / 2);
    EXPECT_NEAR(moment / (P * R), 1 / pi - std::abs(std::sin(theta)) / 2, theta == 0 ? 3e-3 : 1e-4)
        << theta;
    EXPECT_NEAR(hoop.at(theta), 0.0, 1e-12 * P);
  }
}

TEST(RingStates, CrosscheckCircularSplineByStatics) {  // TC-39
  // Closed forms under all flanks of the solved drive.  Tolerance: the harmonics beyond 128.
  for (const double T : {14.0, 48.0, -48.0}) {
    const GearSet gear = test::supported_drive();
    const CoupledOptions fine{.harmonics = 128};
    const CurvePoint point = test::point_at(gear, T, fine);
    const auto states = states_of(gear, BendingRing::circular_spline, T, 50, fine);  // at gaps
    const double section =
        gear.circular_spline->width *
        (gear.circular_spline->outer_diameter - gear.circular_spline->inner_diameter) / 2;
    const double modulus =
        section * (gear.circular_spline->outer_diameter - gear.circular_spline->inner_diameter) /
        12;
    for (const RingState& state : states) {
      const ThinRing thin = spline_by_statics(gear, point, state.position);
      EXPECT_NEAR(state.bending_moment, thin.moment, 3e-3 * largest_moment(states));
      EXPECT_NEAR(state.hoop_force, thin.hoop, 2e-2 * largest_hoop_force(states));
      // Navier's stresses of the section.
      EXPECT_NEAR(state.outside_stress, state.hoop_force / section + state.bending_moment / modulus,
                  1e-3);
      EXPECT_NEAR(state.inside_stress, state.hoop_force / section - state.bending_moment / modulus,
                  1e-3);
    }
  }
}

TEST(RingStates, IdentityOuterRingBendsWithTheRim) {  // TC-38
  // Curvature by differences of the rim's shape; their error is (32 h)^2/12 of the highest mode.
  const GearSet gear = test::supported_drive();
  const BearingRing& ring = *gear.wave_generator->bearing->outer_ring;
  const double R =
      (gear.flexspline->rim->outer_diameter - gear.flexspline->rim->wall_thickness) / 2;
  constexpr int kCount = 2048;
  const double h = 2 * pi / kCount;
  const auto rim = rim_states(gear, 30.0, kCount);
  const auto states = states_of(gear, BendingRing::outer_ring, 30.0, kCount);
  const double E = 206 * units::GPa;
  for (std::size_t i = 1; i + 1 < kCount; i += 41) {
    const double w = rim[i].radial;
    const double kappa = -((rim[i + 1].radial - 2 * w + rim[i - 1].radial) / (h * h) + w) / (R * R);
    const double section = ring.width * std::pow(ring.thickness, 3) / 12;
    EXPECT_NEAR(states[i].bending_moment, ring.groove_factor * E * section * kappa,
                2e-3 * largest_moment(states));
    EXPECT_NEAR(states[i].outside_stress, E / 0.91 * ring.thickness / 2 * kappa, 1e6);
    EXPECT_EQ(states[i].inside_stress, -states[i].outside_stress);
    EXPECT_EQ(states[i].hoop_force, 0.0);
    EXPECT_EQ(states[i].position, rim[i].position);
  }
}

TEST(RingStates, IdentityMirroredTorque) {
  const AssembledDrive drive(test::supported_drive());
  constexpr std::size_t kCount = 180;
  for (const BendingRing ring : kBending) {
    const auto one = ring_states(drive, ring, 40.0, kCount);
    const auto other = ring_states(drive, ring, -40.0, kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
      const RingState& mirrored = other[(kCount - i) % kCount];
      EXPECT_NEAR(one[i].inside_stress, mirrored.inside_stress, 1.0);  // of some 10 MPa
      EXPECT_NEAR(one[i].hoop_force, mirrored.hoop_force, 1e-6);
    }
  }
}

TEST(RingStates, ScalingSimilarDrives) {
  constexpr double s = 1.7;
  const GearSet gear = test::supported_drive();
  GearSet larger = gear;
  for_each_number(larger, [&](const FieldPath&, const Field& field, double& x) {
    if (field.unit == "m") x *= s;
  });
  for (const BendingRing ring : kBending) {
    const auto one = states_of(gear, ring, 40.0, 90);
    const auto two = states_of(larger, ring, 40.0 * s * s * s, 90);
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_NEAR(two[i].outside_stress, one[i].outside_stress, 1.0);  // of some 10 MPa
      EXPECT_NEAR(two[i].bending_moment, one[i].bending_moment * s * s * s, 1e-6);
      EXPECT_NEAR(two[i].hoop_force, one[i].hoop_force * s * s, 1e-5);
    }
  }
}

TEST(RingStates, LimitStiffRings) {
  // A circular spline of great stiffness takes the flanks of a drive with a rigid one; its moment
  // is that of statics, and its curvature vanishes.  128 harmonics, as above.
  const CoupledOptions fine{.harmonics = 128};
  GearSet stiff = test::supported_drive();
  stiff.material["rigid"] = stiff.material["steel"];
  *stiff.material["rigid"].youngs_modulus *= 1e7;
  stiff.circular_spline->material = "rigid";
  const GearSet rigid = test::typical_drive();
  const CurvePoint point = test::point_at(rigid, 48.0, fine);
  const auto states = states_of(stiff, BendingRing::circular_spline, 48.0, 50, fine);
  for (const RingState& state : states)
    EXPECT_NEAR(state.bending_moment, spline_by_statics(stiff, point, state.position).moment,
                3e-3 * largest_moment(states));
  // A housing that leaves nothing to the ring takes the whole load off it.
  GearSet held = test::supported_drive();
  held.circular_spline->support = 1e-7;
  EXPECT_LT(largest_moment(states_of(held, BendingRing::circular_spline, 48.0, 50)),
            1e-6 * largest_moment(states));
}

TEST(RingStates, ReferenceStressOfTheWave) {  // TC-38
  // A ring bent to w_0 cos 2 theta has E' t/2 3 w_0/R^2 outside at the lobes and less inside; on
  // the cam it is flatter at the lobe and rounder beside it.  The tolerance is this model form, 25
  // %.
  const GearSet gear = test::typical_drive();
  const TubeSection& rim = *gear.flexspline->rim;
  const double R = (rim.outer_diameter - rim.wall_thickness) / 2;
  const double wave = 206 * units::GPa / 0.91 *
                      gear.wave_generator->bearing->outer_ring->thickness / 2 * 3 *
                      gear.drive.radial_displacement / (R * R);
  const auto states = states_of(gear, BendingRing::outer_ring, 0.0, 4);
  EXPECT_NEAR(states[0].outside_stress / wave, 1, 0.25);
  EXPECT_NEAR(states[1].inside_stress / wave, 1, 0.25);
}

TEST(RingStates, InputWhatTheyNeed) {
  const AssembledDrive drive(test::supported_drive());
  for (const BendingRing ring : kBending) {
    EXPECT_THROW((void)ring_states(drive, ring, 1.0, 0), InputError);
    for (const double torque :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      EXPECT_THROW((void)ring_states(drive, ring, torque, 4), InputError);
    EXPECT_TRUE(bends(test::supported_drive(), ring));
    EXPECT_THROW((void)states_of(test::supported_drive(), ring, 1.0, 4, {.max_iterations = 1}),
                 SolverError);
  }
  // A rigid circular spline and an absent one do not bend.
  GearSet rigid = test::typical_drive();
  EXPECT_FALSE(bends(rigid, BendingRing::circular_spline));
  EXPECT_THROW((void)states_of(rigid, BendingRing::circular_spline, 1.0, 4), InputError);
  rigid.circular_spline.reset();
  EXPECT_FALSE(bends(rigid, BendingRing::circular_spline));
  EXPECT_THROW((void)states_of(rigid, BendingRing::circular_spline, 1.0, 4), InputError);
  EXPECT_NO_THROW((void)states_of(rigid, BendingRing::outer_ring, 1.0, 4));
}

}  // namespace
}  // namespace strainwave
