// SPDX-License-Identifier: Apache-2.0
#include "fields_at_load.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace strainwave::fe_study {
namespace {

using std::numbers::pi;

constexpr double kTorque = -300;   // N*m
constexpr double kForce = 2000;    // N
constexpr double kRadius = 0.03;   // m, of the point
constexpr double kHeight = 0.012;  // m

GearSet loaded(double torque, double force) {
  GearSet gear;
  gear.load.torque = torque;
  gear.load.axial_force = force;
  return gear;
}

fem::SampledFields one_point(const fem::FieldPoint& point) {
  fem::SampledFields fields;
  fields.cells.resize(1);
  fields.cells[0].points = {point};
  return fields;
}

/// One point of a hollow shaft, 70 and 45 mm, with made-up fields per unit of load.
ShaftCrackRun made_up() {
  ShaftCrackRun run{.path = "output_shaft.crack[0]",
                    .section = {.outer_diameter = 0.07,
                                .inner_diameter = 0.045,
                                .length = 0.2,
                                .crack = gear_fem::ShaftCrack{.depth = 4e-3, .position = 0.1}},
                    .result = {},
                    .elasticity = {.youngs_modulus = 200e9, .poissons_ratio = 0.25}};
  run.result.torsion.fields = one_point({.place = {kRadius, 0, kHeight},
                                         .displacement = {0, 2e-9, 0},
                                         .stress = {0, 0, 0, 5e3, 0, 7e3},
                                         .energy_density = 3e-4});
  run.result.tension.fields = one_point({.place = {kRadius, 0, kHeight},
                                         .displacement = {1e-12, 0, 3e-12},
                                         .stress = {10, 20, 400, 0, 30, 0},
                                         .energy_density = 6e-7});
  run.result.torsion.tip = {.energy_release_rate = 2e-6, .K_III = 400};
  run.result.tension.tip = {.energy_release_rate = 5e-10, .K_I = 90, .K_II = -3};
  return run;
}

void expect_same(const fem::FieldPoint& point, const std::array<double, 3>& u,
                 const std::array<double, 6>& stress) {
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(point.displacement[i], u[i], 1e-12 * std::abs(u[i])) << i;
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(point.stress[i], stress[i], 1e-12 * std::abs(stress[i])) << i;
}

const double kArea = pi * (0.035 * 0.035 - 0.0225 * 0.0225);
const double kPolar = pi / 2 * (std::pow(0.035, 4) - std::pow(0.0225, 4));

// Fields add, and energies add too, because torsion and tension cause different components (FE-38).
TEST(FieldsAtLoad, IdentityFieldsOfAShaftAdd) {
  const auto fields = fields_at_load(made_up(), loaded(kTorque, kForce));
  EXPECT_TRUE(fields.without_crack);
  const fem::FieldPoint& point = fields.cells.at(0).points.at(0);
  expect_same(point, {2e-9, -6e-7, 6e-9}, {2e4, 4e4, 8e5, -1.5e6, 6e4, -2.1e6});
  EXPECT_NEAR(point.energy_density, 9e4 * 3e-4 + 4e6 * 6e-7, 1e-9);
  const double shear = kTorque * kRadius / kPolar;
  const double pull = kForce / kArea;
  const double sound = shear * shear / (2 * 80e9) + pull * pull / (2 * 200e9);
  EXPECT_NEAR(point.energy_density_without_crack / sound, 1, 1e-12);
}

// Any tension opens the crack, however small.
TEST(FieldsAtLoad, LimitSmallPull) {
  const auto fields = fields_at_load(made_up(), loaded(0, 0.5));
  expect_same(fields.cells.at(0).points.at(0), {5e-13, 0, 1.5e-12}, {5, 10, 200, 0, 15, 0});
}

// A pressing force passes through the closed crack as through the sound shaft.
TEST(FieldsAtLoad, IdentityPressedShaftIsSoundInTension) {
  const auto fields = fields_at_load(made_up(), loaded(kTorque, -kForce));
  const fem::FieldPoint& point = fields.cells.at(0).points.at(0);
  const double push = -kForce / kArea;
  expect_same(point, {-0.25 * push / 200e9 * kRadius, -6e-7, push / 200e9 * kHeight},
              {0, 0, push, -1.5e6, 0, -2.1e6});
  EXPECT_NEAR(point.energy_density / (9e4 * 3e-4 + push * push / (2 * 200e9)), 1, 1e-12);
}

TEST(FieldsAtLoad, ScalingFieldsOfACup) {
  gear_fem::CupResult cup;
  cup.solution.fields = made_up().result.torsion.fields;
  const auto fields = fields_at_load(cup, loaded(kTorque, kForce));
  EXPECT_FALSE(fields.without_crack);
  const fem::FieldPoint& point = fields.cells.at(0).points.at(0);
  expect_same(point, {0, -6e-7, 0}, {0, 0, 0, -1.5e6, 0, -2.1e6});
  EXPECT_NEAR(point.energy_density, 9e4 * 3e-4, 1e-9);
}

TEST(FieldsAtLoad, IdentityFrontIsACircle) {
  ShaftCrackRun run = made_up();
  for (const bool outside : {true, false}) {
    run.section.crack->surface =
        outside ? gear_fem::ShaftCrack::Surface::outer : gear_fem::ShaftCrack::Surface::inner;
    const double radius = outside ? 0.031 : 0.0265;
    const auto front = front_at_load(run, loaded(kTorque, kForce));
    EXPECT_NEAR(front.length, 2 * pi * radius, 1e-14);
    ASSERT_GT(front.stations.size(), 9U);
    EXPECT_EQ(front.stations.front().position, 0);
    EXPECT_EQ(front.stations.back().position, 1);
    for (const auto& station : front.stations) {
      const double angle = 2 * pi * station.position;
      EXPECT_NEAR(station.place[0], radius * std::cos(angle), 1e-15);
      EXPECT_NEAR(station.place[1], radius * std::sin(angle), 1e-15);
      EXPECT_EQ(station.place[2], 0.1);
      EXPECT_NEAR(station.energy_release_rate, 9e4 * 2e-6 + 4e6 * 5e-10, 1e-12);
      EXPECT_NEAR(station.K_I, 1.8e5, 1e-9);
      EXPECT_NEAR(station.K_II, -6e3, 1e-9);
      EXPECT_NEAR(station.K_III, -1.2e5, 1e-9);
    }
    const auto pressed = front_at_load(run, loaded(kTorque, -kForce));  // closed
    EXPECT_EQ(pressed.stations[0].K_I, 0);
    EXPECT_NEAR(pressed.stations[0].energy_release_rate, 9e4 * 2e-6, 1e-12);
  }
}

}  // namespace
}  // namespace strainwave::fe_study
