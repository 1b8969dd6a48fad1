// SPDX-License-Identifier: Apache-2.0
// Cracks that grow over the duty of a drive while it moves (MO-50).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/simulation.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/study/drive_joint.hpp"
#include "strainwave/study/simulation_report.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using test::expect_relative;

constexpr double kDutyHour = 3600.0;

GearSet growth_example(const std::string& name) {
  return read_gear_set_file(STRAINWAVE_EXAMPLES "/" + name + ".toml");
}

/// The growing shaft with a load that hangs on it for a second.
GearSet hanging_load() {
  GearSet gear = growth_example("growing_shaft");
  gear.drivetrain = Drivetrain{.motor_inertia = 1e-2, .load_inertia = 20, .gear_damping = 2000};
  gear.manoeuvre = {{.duration = 1.0, .input_speed = 0.0, .output_torque = 6000.0}};
  return gear;
}

/// What `grow` says at a time of duty [s].
GrowthReport grown_until(const GearSet& gear, double time) {
  GrowthOptions options;
  options.stop.time = time;
  return grow_cracks(gear, options);
}

const Note* growth_note(const SimulationReport& report, const std::string& code) {
  const auto found = std::ranges::find(report.notes, code, &Note::code);
  return found == report.notes.end() ? nullptr : &*found;
}

double softer_stiffness(const GearSet& gear) {
  const StiffnessResult of = torsional_stiffness(gear);
  return std::min(of.positive.stiffness.value, of.negative.stiffness.value);
}

std::string growth_refused(const GearSet& gear, double hours) {
  return test::broken_rule([&] {
    SimulationSettings settings;
    settings.growth = hours * kDutyHour;
    (void)simulation_report(gear, settings);
  });
}

TEST(GrowingJoint, CrosscheckTheStiffnessAtTheLastSizes) {
  // (MO-50), (GR-25): at the end the joint has the stiffness of the series model at the sizes that
  // `grow` computes, and the load hangs there.  1e-4 is the vibration that the begin of the growth
  // leaves; T^2/2 times the change of compliance is released at the constant torque.
  const GearSet gear = hanging_load();
  for (const double hours : {50.0, 200.0}) {
    SimulationSettings settings;
    settings.growth = hours * kDutyHour;
    const SimulationReport report = simulation_report(gear, settings);
    ASSERT_TRUE(report.growth && report.cracked);
    const GrowthReport growth = grown_until(gear, hours * kDutyHour);
    const GearSet& last = growth.drives.back();
    EXPECT_LT(softer_stiffness(last), (1 - 1e-4) * softer_stiffness(gear));
    expect_relative(report.growth->first_stiffness, softer_stiffness(gear), 1e-12);
    expect_relative(report.growth->last_stiffness, softer_stiffness(last), 1e-9);
    expect_relative(report.growth->pace, hours * kDutyHour, 1e-12);
    ASSERT_EQ(report.growth->cracks.size(), 1U);
    const GrowthInMotion& crack = report.growth->cracks.front();
    EXPECT_EQ(crack.path, "output_shaft.crack[0]");
    EXPECT_EQ(crack.sense, "both");
    expect_relative(crack.last_size, growth.cracks[0].series.back().size, 1e-9);
    const double added = 1 / softer_stiffness(last) - 1 / softer_stiffness(gear);
    expect_relative(crack.last_compliance - crack.first_compliance, added, 1e-6);
    const SimulationRow& row = report.rows.back();
    expect_relative(*row.cracked_output_angle - report.rows[0].cracked_output_angle.value(),
                    6000.0 * added, 0.02);
    expect_relative(*row.cracked_output_angle, 6000.0 / softer_stiffness(last), 1e-4);
    EXPECT_EQ(row.output_angle, report.rows[0].output_angle);
    expect_relative(report.cracked->released_energy.value(), 6000.0 * 6000.0 / 2 * added, 1e-3);
    EXPECT_GT(report.cracked->lost_energy, *report.cracked->released_energy);
    EXPECT_FALSE(report.intact.released_energy);
    EXPECT_LT(report.cracked->imbalance, 1e-6);
    EXPECT_EQ(report.duration, 1.0);
    EXPECT_EQ(growth_note(report, "motion.growth_ends"), nullptr);
    EXPECT_EQ(std::ranges::count(report.equations, "MO-50"), 1);
    EXPECT_EQ(std::ranges::count(report.equations, "GR-24"), 1);
  }
}

TEST(GrowingJoint, CrosscheckTheCompliancesOnTheWay) {
  // (MO-50): at half of the motion, half of the duty has passed.  The chords between the points of
  // the path make the crack too soft by less than 1e-3 of what it has grown.
  const GearSet gear = hanging_load();
  SimulationSettings settings;
  settings.growth = 200 * kDutyHour;
  const SimulationReport whole = simulation_report(gear, settings);
  const SimulationRow& middle = whole.rows[500];
  EXPECT_NEAR(middle.time, 0.5, 1e-9);
  const double expected =
      6000.0 * (1 / softer_stiffness(grown_until(gear, 100 * kDutyHour).drives.back()) -
                1 / softer_stiffness(gear));
  expect_relative(*middle.cracked_output_angle - *whole.rows[0].cracked_output_angle, expected,
                  0.02);
}

TEST(GrowingJoint, BehaviourTheMotionEndsWithTheLife) {
  // (MO-50): the shaft fails the assessment within the hours, so the motion ends at this share.
  const GearSet gear = hanging_load();
  const double life = grown_until(gear, 1e6 * kDutyHour).life.value();
  SimulationSettings settings;
  settings.growth = 2 * life;
  const SimulationReport report = simulation_report(gear, settings);
  expect_relative(report.duration, 0.5, 1e-9);
  expect_relative(report.rows.back().time, 0.5, 1e-9);
  expect_relative(report.growth->time_at_end, life, 1e-9);
  const Note* const note = growth_note(report, "motion.growth_ends");
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(note->path, "output_shaft.crack[0]");
  EXPECT_NE(note->text.find("the motion ends at 0.5 s"), std::string::npos) << note->text;
  EXPECT_TRUE(report.growth->sentence.starts_with("output_shaft.crack[0] fails the assessment"));
  EXPECT_NE(note->text.find("fails the assessment after"), std::string::npos) << note->text;
  bool said = false;
  for (const std::string& words : simulation_sentences(report))
    said = said || words.find("of duty") != std::string::npos;
  EXPECT_TRUE(said);
}

TEST(GrowingJoint, LimitACrackThatStandsStill) {
  // (GR-24): below the threshold nothing grows, so the motion is that without growth.
  GearSet gear = hanging_load();
  gear.material.at("steel").growth_bounds.emplace().threshold = 1e9;
  SimulationSettings settings;
  const SimulationReport without = simulation_report(gear, settings);
  settings.growth = 100 * kDutyHour;
  const SimulationReport report = simulation_report(gear, settings);
  ASSERT_TRUE(report.growth);
  EXPECT_TRUE(report.growth->cracks.empty());
  EXPECT_EQ(report.growth->first_stiffness, report.growth->last_stiffness);
  EXPECT_FALSE(report.cracked->released_energy);
  EXPECT_EQ(report.cracked->steps, without.cracked->steps);
  EXPECT_EQ(report.rows.back().cracked_output_angle, without.rows.back().cracked_output_angle);
  ASSERT_NE(growth_note(report, "motion.growth_stands"), nullptr);
}

TEST(GrowingJoint, CrosscheckCracksOfTheWall) {
  // (MO-14), (MO-50): a surface crack of the wall that goes through; its compliance at the end is
  // that of the joint at the last size, under the sense that opens it, and so is the stiffness of
  // the series model.  The jump becomes a steep line, across which the energy balances too.
  GearSet gear = growth_example("growing_size25");
  gear.mesh.reset();  // the sum of the members
  auto& cracks = gear.flexspline->crack;
  cracks.pop_back();
  std::get<WallSurfaceCrack>(cracks.front()).depth = 0.35e-3;
  std::get<WallSurfaceCrack>(cracks.front()).angle = 45 * units::deg;
  gear.drivetrain = Drivetrain{.motor_inertia = 1e-4, .load_inertia = 1.0, .gear_damping = 100};
  gear.manoeuvre = {{.duration = 0.05, .input_speed = 0.0, .output_torque = 40.0}};
  const GrowthReport whole = grown_until(gear, 1e6 * kDutyHour);
  EXPECT_TRUE(std::ranges::any_of(whole.cracks, [](const CrackGrowth& crack) {
    return std::ranges::find(crack.events, CrackEvent::through_wall, &GrowthEvent::event) !=
           crack.events.end();
  }));
  SimulationSettings settings;
  settings.growth = whole.time;
  const SimulationReport report = simulation_report(gear, settings);
  ASSERT_TRUE(report.growth);
  const GearSet& last = whole.drives.back();
  EXPECT_GE(report.growth->cracks.size(), 1U);
  expect_relative(report.duration, 0.05, 1e-9);
  for (const GrowthInMotion& crack : report.growth->cracks) {
    const auto sum = [&](const GearSet& of) {
      double found = 0.0;
      for (const BreathingCrack& at : joint_cracks(of))
        if (at.path == crack.path &&
            (!at.sense || crack.sense == "both" || crack.sense == enum_name(*at.sense)))
          found += at.compliance;
      return found;
    };
    expect_relative(crack.first_compliance, sum(gear), 1e-12);
    expect_relative(crack.last_compliance, sum(last), 1e-6);
    EXPECT_GT(crack.last_compliance, crack.first_compliance);
  }
  expect_relative(report.growth->first_stiffness, softer_stiffness(gear), 1e-12);
  expect_relative(report.growth->last_stiffness, softer_stiffness(last), 1e-6);
  EXPECT_LT(report.cracked->imbalance, 1e-6);
}

TEST(GrowingJoint, BehaviourCracksInTheContactsKeepTheirSize) {
  // (MO-25), (MO-50): the table of the computed curve has the crack of the race at its size in the
  // file; the crack of the shaft grows beside it.
  GearSet gear = growth_example("resonance_shift_size25");
  RaceSurfaceCrack race;
  race.depth = 1e-4;
  race.aspect_ratio = 0.5;
  gear.wave_generator->crack.emplace_back(race);
  gear.drivetrain->spring = RestoringTorque::computed;
  gear.drivetrain->curve_torque = 80.0;
  gear.manoeuvre = {{.duration = 0.01, .input_speed = 0.0, .output_torque = 48.0}};
  SimulationSettings settings;
  settings.growth = grown_until(gear, 500 * kDutyHour).time / 2;
  const SimulationReport report = simulation_report(gear, settings);
  const Note* const note = growth_note(report, "motion.keeps_size");
  ASSERT_NE(note, nullptr);
  EXPECT_TRUE(note->path.starts_with("wave_generator")) << note->path;
  ASSERT_EQ(report.growth->cracks.size(), 1U);
  EXPECT_EQ(report.growth->cracks[0].path, "output_shaft.crack[0]");
  EXPECT_LT(report.growth->last_stiffness, report.growth->first_stiffness);
}

TEST(GrowingJoint, InputEachRuleBrokenOnce) {
  GearSet gear = hanging_load();
  EXPECT_EQ(growth_refused(gear, 1.0), "no error");
  EXPECT_NE(growth_refused(gear, 0.0).find("--growth"), std::string::npos);
  EXPECT_NE(growth_refused(gear, 1e12).find("a million years"), std::string::npos);
  GearSet without = gear;
  without.duty.reset();
  EXPECT_NE(growth_refused(without, 1.0).find("duty: must be given; add [duty]"), std::string::npos)
      << growth_refused(without, 1.0);
  GearSet lawless = gear;
  lawless.material.at("steel").growth.clear();
  EXPECT_NE(growth_refused(lawless, 1.0).find("growth"), std::string::npos)
      << growth_refused(lawless, 1.0);
  GearSet broken = gear;
  broken.material.at("steel").fracture_toughness = 1e5;
  EXPECT_NE(growth_refused(broken, 1.0).find("leaves no time for a motion"), std::string::npos)
      << growth_refused(broken, 1.0);
}

}  // namespace
}  // namespace strainwave
