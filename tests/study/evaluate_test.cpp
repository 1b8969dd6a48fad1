// SPDX-License-Identifier: Apache-2.0
// The coupled drive beside the sum of the members.
#include "strainwave/study/evaluate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/drive_turn/drive_turn.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/stiffness.hpp"
#include "strainwave/study/outputs.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

GearSet drive_of(const char* name) {
  return read_gear_set_file(std::string(STRAINWAVE_EXAMPLES "/") + name + ".toml");
}

const Note& note_of(const StiffnessResult& result, const char* code) {
  return *std::ranges::find(result.notes, code, &Note::code);
}

TEST(Evaluate, CrosscheckTheCoupledDriveIsThatOfTheModule) {
  const GearSet gear = drive_of("cracked_size25");
  const StiffnessResult result = evaluate(gear, Method::corrected);
  ASSERT_TRUE(result.curve);
  const AssembledDrive drive(gear);
  for (const int sense : {+1, -1}) {
    const CrackedCurve& curve = sense > 0 ? result.curve->positive : result.curve->negative;
    const MakersLines lines = makers_lines(drive, sense);
    const MakersLines sound = makers_lines(drive.without_cracks(), sense);
    EXPECT_EQ(curve.K1.value, lines.K1);
    EXPECT_EQ(curve.K2.value, lines.K2);
    EXPECT_EQ(curve.K3.value, lines.K3);
    EXPECT_EQ(curve.wind_up_at_T1.value, lines.phi1);
    EXPECT_EQ(curve.wind_up_at_T3.value, lines.phi3);
    // The load of the example is T2, so this is the same state on another path of the torque.
    test::expect_relative(curve.wind_up.value().value, lines.phi2, 1e-8);
    test::expect_relative(curve.change.K1.value, lines.K1 / sound.K1 - 1, 1e-12);
    test::expect_relative(curve.change.K3.value, lines.K3 / sound.K3 - 1, 1e-12);
    EXPECT_LT(curve.change.K2.value, 0);
    EXPECT_GT(curve.change.wind_up->value, 0);
  }
  EXPECT_EQ(*result.curve->intact.K1.relative_uncertainty, curve_uncertainty(gear));
  // Twists and lines agree: K1 is a secant, and K2 and K3 are slopes between the torques.
  const CurveStiffness& sound = result.curve->intact;
  const MakersTorques& at = result.curve->torques;
  test::expect_relative(at.T1 / sound.wind_up_at_T1.value, sound.K1.value, 1e-14);
  test::expect_relative((at.T3 - at.T2) / (sound.wind_up_at_T3.value - sound.wind_up_at_T2.value),
                        sound.K3.value, 1e-12);
}

/// A drive with one crack of the outer ring at an angle from the lobe [deg], and with the teeth of
/// (TC-7) and (TC-9), for which the numbers below hold.
GearSet with_outer_race_crack(double degrees) {
  GearSet gear = drive_of("catalogue_size25");
  gear.mesh->tooth.reset();
  OuterRaceCrack crack;
  crack.depth = 0.7e-3;
  crack.position = degrees * units::deg;
  gear.wave_generator->crack.emplace_back(crack);
  return gear;
}

TEST(Evaluate, CrosscheckTheTurnIsThatOfTheComparison) {
  // At 65 degrees the crack raises K1.  The result states this, and the changes over a turn.
  const GearSet gear = with_outer_race_crack(65);
  const StiffnessResult result = evaluate(gear, Method::corrected, {.over_turn = true});
  const CurveComparison compared = compare_curves(gear);
  for (const bool positive : {true, false}) {
    const CrackedCurve& curve = positive ? result.curve->positive : result.curve->negative;
    const ChangesOverTurn& turn = positive ? compared.positive : compared.negative;
    ASSERT_TRUE(curve.over_turn);
    const CurveStiffness& sound = result.curve->intact;
    test::expect_relative(curve.over_turn->mean.K1.value, sound.K1.value * (1 + turn.mean.K1),
                          1e-9);
    test::expect_relative(curve.over_turn->softest.K2.value, sound.K2.value * (1 + turn.worst.K2),
                          1e-9);
    test::expect_relative(curve.over_turn->softest.K3.value, sound.K3.value * (1 + turn.worst.K3),
                          1e-9);
    EXPECT_LE(curve.over_turn->softest.K1.value, curve.K1.value * (1 + 1e-12));
    EXPECT_EQ(curve.over_turn->mean.K1.relative_uncertainty, curve.K1.relative_uncertainty);
  }
  EXPECT_GT(result.curve->positive.change.K1.value, 0.015);
  EXPECT_LT(result.curve->positive.over_turn->softest.K1.value,
            0.985 * result.curve->intact.K1.value);
  const Note& note = note_of(result, "curve.one_angle");
  EXPECT_EQ(note.severity, Severity::care);
  for (const char* const said : {"wave_generator.crack[0] at 65 degrees", "+1.53", "-1.52"})
    EXPECT_NE(note.text.find(said), std::string::npos) << note.text;
  EXPECT_NE(note.next_step.find("strainwave torsion --compare"), std::string::npos);
  const std::string text = stiffness_text(result, gear, {});
  EXPECT_NE(text.find("K1, softest over a turn"), std::string::npos) << text;
}

TEST(Evaluate, BehaviourATurnIsComputedWhereItIsAskedForAndCracksTurn) {
  const StiffnessResult alone = evaluate(with_outer_race_crack(65), Method::corrected);
  EXPECT_FALSE(alone.curve->positive.over_turn);
  EXPECT_EQ(note_of(alone, "curve.one_angle").severity, Severity::care);
  // Cracks in series have no angle.
  const StiffnessResult sound =
      evaluate(drive_of("catalogue_size25"), Method::corrected, {.over_turn = true});
  EXPECT_FALSE(sound.curve->positive.over_turn);
  EXPECT_EQ(std::ranges::find(sound.notes, "curve.one_angle", &Note::code), sound.notes.end());
  // A crack with a small effect at every angle needs no care.
  GearSet shallow = with_outer_race_crack(65);
  std::get<OuterRaceCrack>(shallow.wave_generator->crack[0]).depth = 1e-5;
  const StiffnessResult small = evaluate(shallow, Method::corrected, {.over_turn = true});
  EXPECT_EQ(note_of(small, "curve.one_angle").severity, Severity::information);
}

// K over a turn is that of the shell, or that of the table that the crack names; it is not computed
// unasked, and a drive that the shell does not model has none.
TEST(Evaluate, CrosscheckKOverATurn) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_crack.toml");
  EXPECT_FALSE(evaluate(gear, Method::corrected).cracks.at(0).at_work.has_value());
  const StiffnessResult result = evaluate(gear, Method::corrected, {.over_turn = true});
  const DriveTurn turn = drive_turn(gear, {.torques = {gear.load.torque}});
  EXPECT_EQ(result.cracks.at(0).at_work.value().range, turn.range());
  EXPECT_EQ(result.cracks.at(0).at_work.value().ratio, turn.ratio());
  const auto note = std::ranges::find(result.notes, "turn.at_work", &Note::code);
  ASSERT_NE(note, result.notes.end());
  for (const Note& assumption : turn.notes)
    EXPECT_NE(note->text.find(assumption.text), std::string::npos) << assumption.text;
  EXPECT_NE(std::ranges::find(result.equations, "IN-2"), result.equations.end());

  TurnTable table =
      turn_table(drive_turn(gear).sizes, turn_conditions(gear, "flexspline.crack[0]"));
  for (auto& K : table.K) K[0] *= 2;
  table.file = "turn.csv";
  std::get<WallThroughCrack>(gear.flexspline->crack.at(0)).turn_table = table.file;
  gear.turn_tables[table.file] = std::make_shared<const TurnTable>(table);
  const StiffnessResult tabulated = evaluate(gear, Method::corrected, {.over_turn = true});
  test::expect_relative(tabulated.cracks.at(0).at_work.value().range, 2 * turn.range(), 1e-12);
  EXPECT_EQ(test::count_notes(tabulated.notes, "turn.at_work"), 0);

  const GearSet other = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  for (const CrackReport& crack : evaluate(other, Method::corrected, {.over_turn = true}).cracks)
    EXPECT_FALSE(crack.at_work.has_value());
}

TEST(Evaluate, BehaviourAnAngleWithoutSolutionLeavesTheCurveOfTheFile) {
  // The assembly presses the crack at 5 degrees, so the drive holds the torque T3 of a sound one.
  // At other angles the crack turns the ring further, and at the largest T3 the flanks do not hold.
  GearSet gear = with_outer_race_crack(5);
  const auto with_T3 = [&](double T3, bool over_turn) {
    gear.rating->T3 = T3;
    return evaluate(gear, Method::corrected, {.over_turn = over_turn});
  };
  double held = *gear.rating->rated_torque;
  double lost = 1e4 * held;
  while (lost > held * (1 + 1e-6)) {
    const double between = std::sqrt(held * lost);
    (with_T3(between, false).curve ? held : lost) = between;
  }
  EXPECT_EQ(with_T3(lost, true).notes.front().code, "curve.none");
  const StiffnessResult result = with_T3(held, true);
  ASSERT_TRUE(result.curve);
  EXPECT_GT(result.curve->positive.K3.value, 0);
  EXPECT_FALSE(result.curve->positive.over_turn);
  EXPECT_FALSE(result.curve->negative.over_turn);
  const Note& note = note_of(result, "curve.one_angle");
  EXPECT_EQ(note.severity, Severity::care);
  EXPECT_NE(note.text.find("an angle of the turn has no solution: at "), std::string::npos)
      << note.text;
  EXPECT_NE(note.text.find("the flanks do not hold"), std::string::npos) << note.text;
  EXPECT_NE(note.next_step.find("other positions"), std::string::npos);
  const auto missing = [&] {
    try {
      refuse_output(result, "curve.positive.over_turn.softest.K1", "--target");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(missing().find("exist only for cracks"), std::string::npos) << missing();
}

TEST(Evaluate, BehaviourAPressedCrackIsNoted) {
  // At the lobe the assembly raises the curvature of the ring and presses a crack of the raceway.
  const StiffnessResult at_lobe = evaluate(with_outer_race_crack(5), Method::corrected);
  EXPECT_EQ(at_lobe.curve->positive.change.K1.value, 0);
  EXPECT_EQ(note_of(at_lobe, "crack.pressed_ring").severity, Severity::information);
  const StiffnessResult beside = evaluate(with_outer_race_crack(90), Method::corrected);
  EXPECT_LT(beside.curve->positive.change.K1.value, -0.01);
  EXPECT_EQ(std::ranges::find(beside.notes, "crack.pressed_ring", &Note::code), beside.notes.end());
}

TEST(Evaluate, IdentityTheAccuracyOfTheSumContainsTheCoupledDrive) {
  for (const char* const name : {"catalogue_size25", "cracked_size25", "calibrated_size25"}) {
    const StiffnessResult result = evaluate(drive_of(name), Method::corrected);
    ASSERT_TRUE(result.curve) << name;
    const auto contains = [](const Quantity& sum, const Quantity& coupled) {
      return std::abs(sum.value - coupled.value) <=
             *sum.relative_uncertainty * std::abs(sum.value) * (1 + 1e-12);
    };
    const auto expect_contained = [&](const auto& sum, const CurveStiffness& coupled) {
      for (const Quantity& K : {coupled.K1, coupled.K2, coupled.K3})
        EXPECT_TRUE(contains(sum.stiffness, K)) << name;
      EXPECT_TRUE(contains(sum.wind_up, coupled.wind_up.value())) << name;
    };
    expect_contained(result.intact, result.curve->intact);
    expect_contained(result.positive, result.curve->positive);
    expect_contained(result.negative, result.curve->negative);
  }
}

TEST(Evaluate, BehaviourNotesOnWhatTheCoupledDriveContainsAreInformation) {
  const StiffnessResult coupled = evaluate(drive_of("cracked_size25"), Method::corrected);
  const StiffnessResult sum =
      evaluate(drive_of("cracked_size25"), Method::corrected, {.coupled_drive = false});
  EXPECT_FALSE(sum.curve);
  for (const char* const code :
       {"sum.left_out", "wave_generator.hertz", "wave_generator.held_ring", "crack.contact_path"}) {
    EXPECT_EQ(note_of(coupled, code).severity, Severity::information) << code;
    EXPECT_EQ(note_of(sum, code).severity, Severity::care) << code;
  }
  // The members are the same with and without the coupled drive.
  EXPECT_EQ(coupled.intact.stiffness.value, sum.intact.stiffness.value);
  EXPECT_EQ(coupled.positive.compliance.flexspline, sum.positive.compliance.flexspline);
}

TEST(Evaluate, BehaviourWhatIsMissingForTheCoupledDriveIsListed) {
  const StiffnessResult result = evaluate(drive_of("article"), Method::corrected);
  EXPECT_FALSE(result.curve);
  ASSERT_EQ(test::count_notes(result.notes, "curve.missing"), 1);
  const Note& note = note_of(result, "curve.missing");
  EXPECT_EQ(note.severity, Severity::information);
  for (const char* const field : {"wave_generator.bearing", "flexspline.crack_free",
                                  "flexspline.rim", "flexspline.diaphragm", "mesh"})
    EXPECT_NE(note.text.find(field), std::string::npos) << note.text;
  EXPECT_NE(note.next_step.find("strainwave new"), std::string::npos);
}

TEST(Evaluate, InputALoadBeyondTheFlanksHasNoWindUp) {
  GearSet gear = drive_of("catalogue_size25");
  gear.load.torque = 1e5;
  const StiffnessResult result = evaluate(gear, Method::corrected);
  ASSERT_TRUE(result.curve);
  EXPECT_FALSE(result.curve->intact.wind_up);
  EXPECT_GT(result.curve->intact.K1.value, 0);
  EXPECT_EQ(test::count_notes(result.notes, "curve.no_wind_up", "load.torque"), 1);
}

TEST(Evaluate, BehaviourTheCoupledDriveComesFirstInTheText) {
  const GearSet gear = drive_of("cracked_size25");
  const std::string text = stiffness_text(evaluate(gear, Method::corrected), gear, Provenance{});
  const std::size_t verdict = text.find("Verdict: ");
  const std::size_t coupled = text.find("Coupled drive: balls, teeth");
  const std::size_t sum = text.find("Sum of the members, without contacts");
  EXPECT_LT(verdict, coupled);
  EXPECT_LT(coupled, sum);
  EXPECT_NE(sum, std::string::npos);
  EXPECT_NE(text.find("K1, up to T1 = 14 N*m [N*m/rad]"), std::string::npos) << text;
  EXPECT_NE(text.find("wind-up at 48 N*m [arcmin]"), std::string::npos);
}

TEST(Evaluate, BehaviourOutputsOfTheCoupledDriveHaveNames) {
  const StiffnessResult result = evaluate(drive_of("cracked_size25"), Method::corrected);
  for (const char* const output : {"curve.intact.K1", "curve.positive.wind_up",
                                   "curve.negative.change.K3", "curve.torques.T3"}) {
    EXPECT_TRUE(output_named(result, output)) << output;
    EXPECT_TRUE(is_of_coupled_drive(output));
  }
  EXPECT_FALSE(is_of_coupled_drive("intact.stiffness"));
}

TEST(Evaluate, BehaviourHoursOfADriveWithCracks) {
  // A crack that fails the assessment ends the drive at the time that `grow` states.
  const GearSet shaft = drive_of("growing_shaft");
  const StiffnessResult failing = evaluate(shaft, Method::corrected);
  const double life = grow_cracks(shaft).life.value();
  test::expect_relative(failing.life->cracks->value, life, 1e-14);
  test::expect_relative(failing.life->hours->value, life, 1e-14);
  EXPECT_FALSE(evaluate(shaft, Method::corrected, {.life = false}).life.has_value());
  // A crack that stands still leaves the hours of the bearing.
  GearSet joint = drive_of("life_size25");
  const double bearing = evaluate(joint, Method::corrected).life->hours->value;
  const GearSet resting = drive_of("resting_size25");
  WallThroughCrack small = std::get<WallThroughCrack>(resting.flexspline->crack[1]);
  joint.flexspline->crack = {small};
  Material& steel = joint.material.at("steel");
  const auto hours = [&] { return evaluate(joint, Method::corrected).life->hours; };
  // Without a law nobody can tell what the crack does, so there are no hours.
  EXPECT_FALSE(hours().has_value());
  steel.growth = {Paris{6.9e-12, 3}};
  GrowthBounds bounds;
  bounds.threshold = 60e6;
  steel.growth_bounds = bounds;
  ASSERT_TRUE(hours().has_value());
  EXPECT_EQ(hours()->value, bearing);
  // A crack of the rim rests too; without the shape of its tooth root a part of its stress is
  // unknown, so there are no hours.
  RimAxialCrack rim;
  rim.depth = 0.05e-3;
  joint.flexspline->crack = {rim};
  ASSERT_TRUE(hours().has_value());
  EXPECT_EQ(hours()->value, bearing);
  joint.flexspline->tooth_root.reset();
  EXPECT_FALSE(hours().has_value());
  EXPECT_TRUE(evaluate(joint, Method::corrected).life->bearing_L10.has_value());
}

}  // namespace
}  // namespace strainwave
