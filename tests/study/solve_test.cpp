// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/solve.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/solve.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/outputs.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

SolveResult solved(const GearSet& gear, const char* unknown, const char* target,
                   Method method = Method::corrected) {
  return solve(gear, method, parse_unknown(gear, unknown), parse_target(gear, method, target));
}

constexpr const char* kDepth = "output_shaft.crack[0].depth";
constexpr const char* kChange = "cracked.positive.stiffness_change";

/// A solid shaft, so that a crack may be deep, and no other crack.
GearSet solid_shaft() {
  GearSet gear = test::article_gear();
  gear.wave_generator->crack.clear();
  gear.flexspline->crack.clear();
  gear.output_shaft->outer_diameter = 60e-3;
  gear.output_shaft->inner_diameter = 0;
  return gear;
}

std::string fault(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(Solve, ReferenceShaftCrackThatCostsWhatTheArticleClaims) {
  // An independent implementation found 3.660 mm in advance by root finding, for a crack of the
  // shaft alone.  Cracks of 0.1 mm in the other members do not affect the given digits; three
  // cracks of equal size would need only 3.54 mm.
  GearSet gear = test::article_gear();
  const SolveResult result = solved(gear, kDepth, "cracked.positive.stiffness_change=-1.2 %");
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_NEAR(result.solutions[0].value.value, 3.660e-3, 5e-7);
  EXPECT_EQ(result.reason, "");
  gear.wave_generator->crack.clear();
  gear.flexspline->crack.clear();
  const SolveResult alone = solved(gear, kDepth, "cracked.positive.stiffness_change=-1.2 %");
  ASSERT_EQ(alone.solutions.size(), 1U);
  EXPECT_NEAR(alone.solutions[0].value.value, 3.660e-3, 5e-7);
  EXPECT_GT(
      evaluate(test::article_gear(3.53e-3), Method::corrected).positive.stiffness_change.value,
      -0.012);
  EXPECT_LT(
      evaluate(test::article_gear(3.55e-3), Method::corrected).positive.stiffness_change.value,
      -0.012);
}

TEST(Solve, LimitARootCloseToTheWallIsFound) {
  // A deep annular crack leaves two half-spaces joined over a disc: lambda -> 3/(mu d_e^3).  The
  // last accepted point of the scan alone is at a depth of 29.8 mm of 30 mm.
  const GearSet gear = solid_shaft();
  const SolveResult result = solved(gear, kDepth, "cracked.positive.stiffness_change=-99.9999 %");
  ASSERT_EQ(result.solutions.size(), 1U) << result.reason;
  const Solution& found = result.solutions[0];
  const double d_e = 60e-3 - 2 * found.value.value;
  const double added = found.result.cracks[0].positive.at_output.value;
  EXPECT_LT(d_e, 0.3e-3);
  EXPECT_NEAR(added * 80e9 * std::pow(d_e, 3), 3.0, 1e-5);
  EXPECT_NEAR(found.output.value, -0.999999, 1e-12);
}

TEST(Solve, LimitTwoRootsCloseToATurningPointAreFound) {
  // As a function of the angle, the compliance of an open crack in a shell has a maximum.  For a
  // target just below it, two roots lie much closer together than the spacing of the scan, 0.45
  // deg.
  GearSet gear = test::article_gear();
  set_number(gear, "flexspline.crack[0].half_length", 5e-3);
  const Unknown angle{.path = "flexspline.crack[0].angle", .range = {}};
  Target target{.output = "flexspline.crack[0].added_compliance.positive.at_output",
                .unit = "rad/(N*m)",
                .value = 1.0};
  const SolveResult above = solve(gear, Method::corrected, angle, target);
  ASSERT_TRUE(!above.usable() && above.greatest);
  target.value = *above.greatest * (1 - 1e-8);
  const SolveResult result = solve(gear, Method::corrected, angle, target);
  ASSERT_EQ(result.solutions.size(), 2U) << result.reason;
  const double degree = std::acos(-1.0) / 180;
  const double apart = result.solutions[1].value.value - result.solutions[0].value.value;
  EXPECT_GT(apart / degree, 1e-3);
  EXPECT_LT(apart / degree, 0.1);
  for (const Solution& s : result.solutions) EXPECT_NEAR(s.output.value / target.value, 1, 1e-12);
}

TEST(Solve, IdentityUncertaintyIsCarriedOver) {
  // The compliance of a shallow crack grows with the square of its depth: half the uncertainty.
  const SolveResult result =
      solved(solid_shaft(), "output_shaft.crack[0].depth=1 um..100 um",
             "output_shaft.crack[0].added_compliance.positive.at_output=1e-12 rad/(N*m)");
  ASSERT_EQ(result.solutions.size(), 1U) << result.reason;
  const Solution& found = result.solutions[0];
  ASSERT_TRUE(found.value.relative_uncertainty && found.output.relative_uncertainty);
  EXPECT_NEAR(*found.value.relative_uncertainty / *found.output.relative_uncertainty, 0.5, 1e-3);
}

TEST(Solve, BehaviourNoAccuracyAboveAHundredPercent) {
  // The uncertainty of the stiffness exceeds its change by the crack.
  const SolveResult result =
      solved(test::article_gear(), "output_shaft.crack[0].depth=0.1 mm..8 mm",
             "cracked.positive.stiffness=6e5 N*m/rad");
  ASSERT_EQ(result.solutions.size(), 1U) << result.reason;
  EXPECT_FALSE(result.solutions[0].value.relative_uncertainty);
  const ResultEvidence evidence = evidence_of(result);
  const auto note = std::ranges::find(evidence.notes, "solve.accuracy", &Note::code);
  ASSERT_NE(note, evidence.notes.end());
  EXPECT_EQ(note->severity, Severity::cannot_tell);
  EXPECT_EQ(note->path, kDepth);
  EXPECT_TRUE(
      note->text.starts_with("the accuracy of this solution cannot be told, because to first order "
                             "a change of the field by 100 % changes "
                             "cracked.positive.stiffness by less than the uncertainty of "))
      << note->text;
  EXPECT_EQ(evidence.verdict.judgement, Judgement::cannot_be_told);
  const std::string text = solve_text(result);
  EXPECT_NE(text.find("the accuracy of this solution cannot be told"), std::string::npos) << text;
  EXPECT_EQ(text.find("depth = 5.18 mm (accuracy"), std::string::npos) << text;
  // An output that the crack alone determines keeps its accuracy and has no such note.
  EXPECT_EQ(test::count_notes(
                evidence_of(solved(solid_shaft(), "output_shaft.crack[0].depth=1 um..100 um",
                                   "output_shaft.crack[0].added_compliance.positive.at_output="
                                   "1e-12 rad/(N*m)"))
                    .notes,
                "solve.accuracy"),
            0);
}

TEST(Solve, LimitAJumpIsNoSolution) {
  // As printed, K_G = K_G0 - Delta K_G passes through zero: the stiffness of the drive has a pole.
  const GearSet gear = test::article_gear();
  const SolveResult result = solved(gear, "wave_generator.crack[0].depth=1 mm..1.1 mm",
                                    "cracked.positive.stiffness=0 N*m/rad", Method::as_printed);
  EXPECT_NE(result.reason.find("jumps over"), std::string::npos) << result.reason;
  // K = 0 occurs together with K_G = 0, at 1.0930 mm.
  for (const Solution& s : result.solutions) EXPECT_NEAR(s.value.value, 1.0930e-3, 1e-7);
}

TEST(Solve, LimitAClosingCrackJumpsUnderAxialForce) {
  // At -45 deg the torque presses the crack together and tension opens it.  The two balance at P/(4
  // pi r t) = K_u T/(2 pi r^2 t), so P = 2 K_u T/r; there the compliance jumps.
  GearSet gear = test::article_gear();
  set_number(gear, "flexspline.crack[0].angle", -std::acos(-1.0) / 4);
  const char* const added = "flexspline.crack[0].added_compliance.positive.at_output";
  const SolveResult result = solved(gear, "load.axial_force=-10 kN..10 kN",
                                    (std::string(added) + "=5e-14 rad/(N*m)").c_str());
  EXPECT_FALSE(result.usable());
  EXPECT_NE(result.reason.find("jumps over 5e-14 rad/(N*m) at load.axial_force = 2789.05 N"),
            std::string::npos)
      << result.reason;
  EXPECT_EQ(*result.least, 0.0);
  EXPECT_GT(*result.greatest, 9e-14);
}

TEST(Solve, InputAResultThatMayNotBeUsedIsNoSolution) {
  const SolveResult result =
      solved(test::article_gear(), kDepth, "cracked.positive.stiffness_change=-50 %");
  EXPECT_FALSE(result.usable());
  EXPECT_NE(result.reason.find("may not be used"), std::string::npos) << result.reason;
  ASSERT_EQ(result.excluded.size(), 2U);
  EXPECT_FALSE(result.excluded[0].refused);  // beyond the table of the hollow shaft
  EXPECT_TRUE(result.excluded[1].refused);   // beyond the wall
  EXPECT_NEAR(result.excluded[0].from, 0.8 * 12.5e-3, 1e-12);
  EXPECT_NEAR(result.excluded[1].from, 12.5e-3, 1e-12);
  const std::string text = solve_text(result);
  EXPECT_NE(text.find("NO SOLUTION"), std::string::npos);
  EXPECT_NE(text.find("12.5 mm to 100 mm: refused"), std::string::npos) << text;
  EXPECT_NE(text.find("10 mm to 12.5 mm: not usable"), std::string::npos) << text;

  const SolveResult nowhere =
      solved(test::article_gear(), "output_shaft.crack[0].depth=11 mm..14 mm",
             "cracked.positive.stiffness_change=-50 %");
  EXPECT_FALSE(nowhere.usable());
  EXPECT_FALSE(nowhere.least);
  EXPECT_NE(nowhere.reason.find("no value gives a result"), std::string::npos) << nowhere.reason;
}

TEST(Solve, BehaviourAnOutputThatDoesNotDependOnTheNumber) {
  const GearSet gear = test::article_gear();
  const SolveResult missed = solved(gear, kDepth, "intact.stiffness=1e5 N*m/rad");
  EXPECT_FALSE(missed.usable());
  EXPECT_NE(missed.reason.find("does not depend on"), std::string::npos) << missed.reason;
  const Target present{.output = "intact.stiffness",
                       .unit = "N*m/rad",
                       .value = evaluate(gear, Method::corrected).intact.stiffness.value};
  const SolveResult met = solve(gear, Method::corrected, parse_unknown(gear, kDepth), present);
  EXPECT_FALSE(met.usable());
  EXPECT_NE(met.reason.find("over the whole range from"), std::string::npos) << met.reason;
}

TEST(Solve, BehaviourRangeIsChosenFromTheField) {
  const GearSet gear = test::article_gear();
  const auto searched = [&](const char* path) {
    const SolveResult result = solved(gear, path, "intact.stiffness=6e5 N*m/rad");
    return std::pair(result.searched.from, result.searched.to);
  };
  const auto [angle_from, angle_to] = searched("flexspline.crack[0].angle");  // two bounds
  EXPECT_DOUBLE_EQ(angle_from, -std::acos(0.0));
  EXPECT_DOUBLE_EQ(angle_to, std::acos(0.0));
  const auto [length_from, length_to] = searched("output_shaft.length");  // > 0
  EXPECT_DOUBLE_EQ(length_from, 0.2e-3);
  EXPECT_DOUBLE_EQ(length_to, 200);
  const auto [bore_from, bore_to] = searched("output_shaft.inner_diameter");  // >= 0
  EXPECT_EQ(bore_from, 0.0);
  EXPECT_DOUBLE_EQ(bore_to, 45);
  const auto [torque_from, torque_to] = searched("load.torque");  // any sign
  EXPECT_DOUBLE_EQ(torque_from, -1e5);
  EXPECT_DOUBLE_EQ(torque_to, 1e5);
  const auto [given_from, given_to] = searched("output_shaft.length=300 mm..100 mm");
  EXPECT_DOUBLE_EQ(given_from, 0.1);
  EXPECT_DOUBLE_EQ(given_to, 0.3);
}

TEST(Solve, CrosscheckTheSolutionGivesTheTarget) {
  const GearSet gear = test::article_gear();
  const struct {
    const char* path;
    const char* target;
  } cases[] = {{"output_shaft.crack[0].depth", "cracked.positive.stiffness_change=-1 %"},
               {"flexspline.wall_thickness", "intact.stiffness=6.3e5 N*m/rad"},
               {"output_shaft.length", "intact.stiffness=150 N*m/arcmin"},
               {"flexspline.crack[0].half_length=0.1 mm..9 mm",
                "cracked.positive.stiffness_change=-0.02 %"}};
  for (const auto& c : cases) {
    const SolveResult result = solved(gear, c.path, c.target);
    ASSERT_EQ(result.solutions.size(), 1U) << c.path << ' ' << result.reason;
    GearSet at = gear;
    set_number(at, result.path, result.solutions[0].value.value);
    const StiffnessResult there = evaluate(at, Method::corrected);
    const double output = result.target.output == "intact.stiffness"
                              ? there.intact.stiffness.value
                              : there.positive.stiffness_change.value;
    EXPECT_NEAR(output / result.target.value, 1, 1e-9) << c.path;
  }
}

TEST(Solve, LimitNoSolutionIsSaidWithTheRangeOfTheOutput) {
  const SolveResult result = solved(test::article_gear(), "output_shaft.crack[0].depth",
                                    "cracked.positive.stiffness_change=1 %");
  EXPECT_FALSE(result.usable());
  EXPECT_FALSE(result.reason.empty());
  ASSERT_TRUE(result.least && result.greatest);
  EXPECT_LT(*result.greatest, 0.01);
  EXPECT_NE(solve_text(result).find("output_shaft.crack[0].depth"), std::string::npos);
}

TEST(Solve, BehaviourSeveralSolutionsAreAllListed) {
  // The compliance of an open crack in a flat wall does not depend on the angle from 0 to 90
  // degrees, but that of a shell does.
  GearSet gear = test::article_gear();
  std::get<WallThroughCrack>(gear.flexspline->crack[0]).half_length = 5e-3;
  GearSet at_30 = gear;
  set_number(at_30, "flexspline.crack[0].angle", std::acos(-1.0) / 6);
  const double K = evaluate(at_30, Method::corrected).positive.stiffness.value;
  const std::string target = "cracked.positive.stiffness=" + std::to_string(K) + " N*m/rad";
  const SolveResult result = solved(gear, "flexspline.crack[0].angle", target.c_str());
  ASSERT_GE(result.solutions.size(), 2U) << result.reason;
  EXPECT_NE(result.reason.find("2 values"), std::string::npos) << result.reason;
  EXPECT_EQ(test::count_notes(evidence_of(result).notes, "solve.remark"), 1);
  bool found = false;
  for (const Solution& s : result.solutions)
    found = found || std::abs(s.value.value - std::acos(-1.0) / 6) < 1e-4;
  EXPECT_TRUE(found);
}

TEST(Solve, InputEveryFaultIsRefused) {
  const GearSet gear = test::article_gear();
  for (const char* const text :
       {"", "output_shaft.crack[0].dept", "output_shaft.crack[0].depth=1 mm",
        "output_shaft.crack[0].depth=1 mm..1 mm", "output_shaft.crack[0].depth=1..2"})
    EXPECT_THROW((void)parse_unknown(gear, text), InputError) << text;
  for (const char* const text :
       {"", "stiffness", "cracked.positive.stiffness", "cracked.positive.stiffness=",
        "cracked.positive.stiffness=5", "cracked.positive.stiffness=5 N*m",
        "cracked.positive.stifness=5 N*m/rad", "cracked.positive.stiffness=nan N*m/rad"})
    EXPECT_THROW((void)parse_target(gear, Method::corrected, text), InputError) << text;
}

TEST(Solve, InputMessagesNameOptionValueAndWayOut) {
  const GearSet gear = test::article_gear();
  const auto target_fault = [&](const char* text) {
    return fault([&] { (void)parse_target(gear, Method::corrected, text); });
  };
  const std::string kWhere =
      " strainwave stiffness FILE --format csv lists its outputs, and strainwave explain OUTPUT "
      "explains an output";
  EXPECT_EQ(target_fault("stiffness_change=-1 %"),
            "--target: \"stiffness_change\" is not an output of this drive; did you mean "
            "cracked.positive.stiffness_change or cracked.negative.stiffness_change?" +
                kWhere);
  EXPECT_EQ(target_fault("cracked.positive.stifness=1 N*m/rad"),
            "--target: \"cracked.positive.stifness\" is not an output of this drive; did you mean "
            "cracked.positive.stiffness?" +
                kWhere);
  EXPECT_EQ(target_fault("intact.stiffness=5"),
            "--target intact.stiffness: \"5\" has no unit; it must be convertible to N*m/rad");
  // A range cannot be chosen from the value zero.
  EXPECT_EQ(fault([&] { (void)solved(gear, "load.axial_force", "intact.stiffness=1 N*m/rad"); }),
            "--vary load.axial_force: is 0, from which no range can be chosen; give one: "
            "load.axial_force=FROM..TO");
}

TEST(Solve, InputEveryRuleOfTheFunctionItself) {
  const GearSet gear = test::article_gear();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Unknown depth{.path = kDepth, .range = {}};
  const Target target{.output = kChange, .unit = "1", .value = -0.01};
  const auto refused = [&](const Unknown& unknown, const Target& wanted,
                           const SolveOptions& options = {}) {
    return fault([&] { (void)solve(gear, Method::corrected, unknown, wanted, options); });
  };
  EXPECT_EQ(refused(depth, target), "no fault");
  EXPECT_NE(refused({.path = "output_shaft", .range = {}}, target).find("--vary"),
            std::string::npos);
  EXPECT_NE(refused({.path = kDepth, .range = {{nan, 1.0}}}, target).find("finite"),
            std::string::npos);
  EXPECT_NE(refused({.path = kDepth, .range = {{1e-3, 1e-3}}}, target).find("different"),
            std::string::npos);
  EXPECT_NE(refused(depth, {.output = kChange, .unit = "1", .value = nan}).find("finite"),
            std::string::npos);
  EXPECT_NE(refused(depth, {.output = "nothing", .unit = "1", .value = 1}).find("not an output"),
            std::string::npos);
  EXPECT_NE(refused(depth, target, {.n_scan = 1}).find("n_scan"), std::string::npos);
  // If every point is refused, the message is that of the method.
  EXPECT_NE(refused({.path = kDepth, .range = {{13e-3, 20e-3}}}, target).find("violates: depth <"),
            std::string::npos);
}

TEST(Solve, BehaviourARangeEndsWhereTheCrackNoLongerFits) {
  // A crack 0.1 mm deep in a ring 20 mm wide is as long as the ring is wide at a/c = 0.01.
  GearSet gear = test::article_gear();
  gear.wave_generator->inner_ring_width = 0.02;
  const SolveResult result = solved(gear, "wave_generator.crack[0].aspect_ratio",
                                    "cracked.positive.stiffness_change=-50 %");
  EXPECT_TRUE(result.solutions.empty());
  ASSERT_FALSE(result.excluded.empty());
  EXPECT_TRUE(result.excluded.front().refused);
  EXPECT_NEAR(result.excluded.front().to, 0.01, 1e-9);
}

TEST(Solve, BehaviourJsonCarriesTheSolution) {
  const SolveResult result = solved(test::article_gear(), "output_shaft.crack[0].depth",
                                    "cracked.positive.stiffness_change=-1 %");
  const nlohmann::json json = nlohmann::json::parse(json_of(result));
  EXPECT_EQ(json.at("solutions").size(), 1U);
  const nlohmann::json& solution = json.at("solutions")[0];
  EXPECT_EQ(solution.at("value").at("value").get<double>(), result.solutions[0].value.value);
  EXPECT_EQ(solution.at("value").at("unit"), "m");
  EXPECT_EQ(solution.at("result").at("cracked").at("positive").at("stiffness_change"),
            solution.at("output"));
  EXPECT_EQ(solution.at("result").at("cracks").size(), 3U);
  EXPECT_EQ(json.at("path"), kDepth);
  EXPECT_EQ(json.at("target").at("value").get<double>(), -0.01);
  EXPECT_EQ(json.at("searched").at("to").get<double>(), 0.1);
  EXPECT_EQ(json.at("excluded").size(), 2U);
  const ResultEvidence evidence = evidence_of(result);
  EXPECT_EQ(evidence.unusable_because, "");
  EXPECT_FALSE(evidence.notes.empty());
}

TEST(Solve, BehaviourTextCarriesTheSolution) {
  const std::string text =
      solve_text(solved(test::article_gear(), kDepth, "cracked.positive.stiffness_change=-1.2 %"));
  EXPECT_NE(text.find("output_shaft.crack[0].depth = 3.66 mm"), std::string::npos) << text;
  EXPECT_EQ(text.find("NO SOLUTION"), std::string::npos) << text;
}

TEST(Solve, CrosscheckATargetOfTheCoupledDrive) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
  const double K2 = evaluate(gear, Method::corrected).curve->intact.K2.value;
  GearSet thin = gear;
  thin.range.clear();
  const SolveResult found = solve(
      thin, Method::corrected, parse_unknown(thin, "mesh.gap_factor=0.5..2"),
      parse_target(thin, Method::corrected, fmt::format("curve.intact.K2={:.17g} N*m/rad", K2)),
      {.n_scan = 7});
  ASSERT_EQ(found.solutions.size(), 1U) << found.reason;
  // The value in the file gives this stiffness; the curve is solved to 1e-11.
  EXPECT_NEAR(found.solutions[0].value.value, gear.mesh->gap_factor, 1e-7);
  EXPECT_TRUE(found.solutions[0].result.curve);
}

TEST(Solve, CrosscheckATargetOverATurn) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
  gear.range.clear();
  OuterRaceCrack crack;
  crack.depth = 0.7e-3;
  gear.wave_generator->crack.emplace_back(crack);
  const std::string output = "curve.positive.over_turn.softest.K1";
  const std::string depth = "wave_generator.crack[0].depth";
  const double K1 =
      output_named(evaluate(gear, Method::corrected, {.over_turn = true}), output).value().value;
  const SolveResult found =
      solve(gear, Method::corrected, parse_unknown(gear, depth + "=0.6 mm..0.74 mm"),
            parse_target(gear, Method::corrected, fmt::format("{}={:.17g} N*m/rad", output, K1)),
            {.n_scan = 2});
  ASSERT_EQ(found.solutions.size(), 1U) << found.reason;
  // The depth in the file gives this stiffness; the curve is solved to 1e-11, and 0.1 mm of depth
  // changes it by 1e-2.
  EXPECT_NEAR(found.solutions[0].value.value, 0.7e-3, 1e-10);
  EXPECT_EQ(found.solutions[0].output.value,
            output_named(found.solutions[0].result, output).value().value);
  // Without a crack that turns relative to the lobes there is no such output.
  gear.wave_generator->crack.clear();
  EXPECT_EQ(
      fault([&] { (void)parse_target(gear, Method::corrected, output + "=1e4 N*m/rad"); })
          .rfind("--target: \"" + output +
                     "\" is not an output of this drive; outputs over a turn exist only for cracks "
                     "of teeth, rim, outer ring or circular spline. strainwave stiffness",
                 0),
      0U);
}

}  // namespace
}  // namespace strainwave
