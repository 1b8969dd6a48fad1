// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/ring_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/io/gear_reader.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

GearSet energy_drive() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/cracked_size25.toml"); }

TEST(RingEnergy, IdentityRotationIsTheDerivativeOfTheEnergy) {
  // (MO-27): dW/dT = c_0/R, by a central difference of 1 mN*m; 1e-9 is its rounding.
  const AssembledDrive drive = AssembledDrive(energy_drive()).moved(0.3, 0.1);
  constexpr double h = 1e-3;
  for (const double torque : {-60.0, -5.0, 2.0, 40.0}) {
    const std::vector<double> torques = {torque - h, torque, torque + h};
    const std::vector<RingEnergy> at = ring_energies(drive, torques);
    EXPECT_NEAR((at[2].energy - at[0].energy) / (2 * h), at[1].rotation, 1e-9);
  }
}

TEST(RingEnergy, CrosscheckTheTorsionCurve) {
  // (MO-27), (TC-14): differences of the rotation, with the members in series, are those of the
  // twist of the curve.
  const AssembledDrive drive(without_cracks(energy_drive()));
  const std::vector<double> torques = {10.0, 60.0};
  const std::vector<RingEnergy> ring = ring_energies(drive, torques);
  const std::vector<double> curve = twists(drive, torques);
  EXPECT_NEAR(ring[1].rotation - ring[0].rotation + 50 * sound_series_compliance(drive),
              curve[1] - curve[0], 1e-14);
}

TEST(RingEnergy, IdentityPeriodsOfTheFamilies) {
  // (MO-27): with an odd number of balls the sound drive repeats at half of the angle between two
  // balls, because the other lobe then meets a ball as the first lobe did before.  The mean over
  // both phases of a crack repeats after half a turn, and each phase alone does not.
  const GearSet gear = energy_drive();
  const double pitch = 2 * pi / *gear.wave_generator->bearing->ball_count;
  const std::vector<double> torque = {40.0};
  const auto rotation = [&](const GearSet& of, double phase, double flexspline) {
    CoupledOptions options;
    options.cage_phase = phase;
    return ring_energies(AssembledDrive(of, options).moved(flexspline, 0.0), torque)[0].rotation;
  };
  const GearSet sound = without_cracks(gear);
  for (const double phase : {0.0, pitch / 8})
    EXPECT_NEAR(rotation(sound, phase, 0.0), rotation(sound, phase + pitch / 2, 0.0), 1e-12);
  EXPECT_GT(std::abs(rotation(sound, 0.0, 0.0) - rotation(sound, pitch / 4, 0.0)), 1e-7);
  GearSet tooth = sound;
  tooth.mesh->crack = gear.mesh->crack;
  const double place = 2 * pi / 100;  // a whole tooth
  const double first = rotation(tooth, 0.0, place);
  const double second = rotation(tooth, pitch / 2, place);
  const double first_after = rotation(tooth, 0.0, place + pi);
  const double second_after = rotation(tooth, pitch / 2, place + pi);
  EXPECT_NEAR(first + second, first_after + second_after, 1e-12);
  EXPECT_GT(std::abs(first - first_after), 1e-10);
}

TEST(AssembledDrive, IdentityMovedByTheAnglesOfATurn) {
  // (TC-28): a turn moves flexspline and circular spline by their own angles.
  const AssembledDrive drive(energy_drive());
  const std::vector<double> torque = {30.0};
  const double angle = 0.7;
  EXPECT_EQ(ring_energies(drive.turned(angle), torque)[0].rotation,
            ring_energies(drive.moved(flexspline_turn(drive.gear().drive, angle), angle), torque)[0]
                .rotation);
}

}  // namespace
}  // namespace strainwave
