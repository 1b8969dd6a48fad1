// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/require.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <tuple>

#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/requirements.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/outputs.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

const std::string kStiffness = "cracked.positive.stiffness";
const std::string kStiffnessChange = "cracked.positive.stiffness_change";

RequirementReport asked(const std::vector<std::string>& texts, double coverage = 1.0,
                        Method method = Method::corrected) {
  return require_outputs(evaluate(test::article_gear(), method), texts, coverage);
}

RequirementOutcome outcome(const std::string& text, double coverage = 1.0,
                           Method method = Method::corrected) {
  return asked({text}, coverage, method).outcome;
}

Quantity value_of(const std::string& output, Method method = Method::corrected) {
  return output_named(evaluate(test::article_gear(), method), output).value();
}

std::string bound(const std::string& output, const char* op, double value) {
  return fmt::format("{} {} {} {}", output, op, value, value_of(output).unit);
}

std::string refusal_of(const std::string& text) {
  return test::broken_rule([&] { return asked({text}); });
}

/// The uncertainty of the sum by its members alone (ST-16) [N*m/rad].
double uncertainty_of_members() {
  const Quantity K = value_of(kStiffness);
  double variance = 0.0;
  for (const char* const member : {"wave_generator", "flexspline", "output_shaft"}) {
    const Quantity c = value_of(std::string("cracked.positive.compliance.") + member);
    variance += std::pow(*c.relative_uncertainty * c.value, 2);
  }
  return K.value * K.value * std::sqrt(variance);
}

TEST(Require, ReferenceMetNotMetAndBetween) {
  // (ST-18): the stated uncertainty counts below the value, and that of the members alone above it.
  const Quantity K = value_of(kStiffness);
  const double u = K.relative_uncertainty.value() * K.value;
  const double above = uncertainty_of_members();
  ASSERT_GT(above, 0);
  ASSERT_GT(u, 1.1 * above);
  for (const char* const op : {">=", ">"}) {
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value - 1.01 * u)), RequirementOutcome::met);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value - 0.99 * u)),
              RequirementOutcome::cannot_be_told);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value + 0.99 * above)),
              RequirementOutcome::cannot_be_told);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value + 1.01 * above)), RequirementOutcome::not_met);
  }
  for (const char* const op : {"<=", "<"}) {
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value + 1.01 * above)), RequirementOutcome::met);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value + 0.99 * above)),
              RequirementOutcome::cannot_be_told);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value - 1.01 * u)), RequirementOutcome::not_met);
  }
}

TEST(Require, LimitOnTheBoundItselfEqualityDecides) {
  const RequirementReport report = asked({bound(kStiffness, ">=", 1)});
  const double low = report.answers[0].low.value();
  EXPECT_EQ(outcome(bound(kStiffness, ">=", low)), RequirementOutcome::met);
  EXPECT_EQ(outcome(bound(kStiffness, ">", low)), RequirementOutcome::cannot_be_told);
  EXPECT_EQ(outcome(bound(kStiffness, "<", low)), RequirementOutcome::not_met);
  EXPECT_EQ(outcome(bound(kStiffness, "<=", low)), RequirementOutcome::cannot_be_told);
}

TEST(Require, ScalingCoverageWidensTheBand) {
  const Quantity K = value_of(kStiffness);
  const double u = K.relative_uncertainty.value() * K.value;
  const std::string text = bound(kStiffness, ">=", K.value - 1.5 * u);
  EXPECT_EQ(outcome(text, 1.0), RequirementOutcome::met);
  EXPECT_EQ(outcome(text, 2.0), RequirementOutcome::cannot_be_told);
  const RequirementAnswer answer = asked({text}, 2.0).answers[0];
  test::expect_relative(K.value - *answer.low, 2 * u, 1e-9);
  test::expect_relative(*answer.high - K.value, 2 * uncertainty_of_members(), 1e-9);
}

TEST(Require, IdentityUnitsOfTheBoundAreConverted) {
  const RequirementReport report =
      asked({kStiffness + " >= 1 kN*m/rad", kStiffnessChange + " > -50 %"});
  EXPECT_DOUBLE_EQ(report.answers[0].requirement.bound, 1000.0);
  EXPECT_DOUBLE_EQ(report.answers[1].requirement.bound, -0.5);
  EXPECT_EQ(report.answers[0].requirement.output, kStiffness);
  // Blanks do not matter.
  EXPECT_DOUBLE_EQ(asked({kStiffness + ">=1 kN*m/rad"}).answers[0].requirement.bound, 1000.0);
}

TEST(Require, ReferenceAChangeHasAnUncertaintyOfItsOwn) {
  const Quantity change = value_of(kStiffnessChange);
  const Quantity K = value_of(kStiffness);
  const RequirementAnswer answer = asked({kStiffnessChange + " >= -99 %"}).answers[0];
  const double band = *answer.high - *answer.low;
  test::expect_relative(band, 2 * *change.relative_uncertainty * std::abs(change.value), 1e-6);
  EXPECT_LT(band / 2, *K.relative_uncertainty) << "not that of the stiffnesses it compares";
  EXPECT_EQ(answer.outcome, RequirementOutcome::met);
}

TEST(Require, BehaviourWithoutUncertaintyTheValueDecides) {
  ASSERT_FALSE(value_of(kStiffness, Method::as_printed).relative_uncertainty);
  for (const auto& [text, expected, code] :
       {std::tuple{" >= 1 N*m/rad", RequirementOutcome::met, "require.by_value"},
        {" <= 1 N*m/rad", RequirementOutcome::not_met, "require.not_met"}}) {
    const RequirementReport report = asked({kStiffness + text}, 1.0, Method::as_printed);
    EXPECT_EQ(report.outcome, expected);
    EXPECT_FALSE(report.answers[0].low);
    ASSERT_EQ(test::note_codes(report.notes), std::vector<std::string>{code});
    EXPECT_EQ(report.notes[0].equation, "") << "no equation says that the value decides";
    EXPECT_NE(report.notes[0].text.find("no uncertainty of this output is stated"),
              std::string::npos);
    EXPECT_NE(requirements_text(report).find("not stated"), std::string::npos);
  }
  EXPECT_EQ(
      evidence_of(asked({kStiffness + " >= 1 N*m/rad"}, 1.0, Method::as_printed)).verdict.judgement,
      Judgement::with_care);
}

/// The note of a requirement that lies inside the interval of an output.
Note note_inside(const GearSet& gear, const std::string& output, double share) {
  const StiffnessResult result = evaluate(gear, Method::corrected);
  const std::string text =
      fmt::format("{} <= {} {}", output, share * output_named(result, output)->value,
                  output_named(result, output)->unit);
  return require_outputs(result, {text}, 1.0).notes.at(0);
}

TEST(Require, BehaviourWhatTheSumLeavesOutActsOnItsSofterSide) {
  const auto says = [](const Note& note, std::string_view what) {
    return note.text.find(what) != std::string::npos && note.equation == "ST-18";
  };
  const char* const softer = "on the softer side only";
  const GearSet gear = test::article_gear();
  EXPECT_TRUE(says(note_inside(gear, "intact.stiffness", 0.9), softer));
  EXPECT_TRUE(says(note_inside(gear, "intact.compliance.total", 1.1), softer));
  EXPECT_TRUE(says(note_inside(gear, "cracked.negative.wind_up", 1.1), softer));
  EXPECT_TRUE(says(note_inside(gear, kStiffnessChange, 1.0), "on both sides"));
  // A member, and a sum that leaves out nothing, get no such text.
  EXPECT_FALSE(says(note_inside(gear, "intact.compliance.flexspline", 1.001), "side"));
  GearSet shaft = gear;
  shaft.wave_generator.reset();
  EXPECT_FALSE(says(note_inside(shaft, "intact.stiffness", 1.001), "side"));
  // The interval of a compliance is the mirror image of that of the stiffness.
  const RequirementReport report =
      asked({"cracked.positive.compliance.total >= 0 rad/(N*m)", kStiffness + " >= 0 N*m/rad"});
  const auto reach = [](const RequirementAnswer& a, double end) {
    return std::abs(end / a.value.value - 1);
  };
  EXPECT_LT(reach(report.answers[0], *report.answers[0].low),
            reach(report.answers[0], *report.answers[0].high));
  EXPECT_GT(reach(report.answers[1], *report.answers[1].low),
            reach(report.answers[1], *report.answers[1].high));
}

TEST(Require, BehaviourASumThatIsSofterThanTheCoupledDriveHasBothSides) {
  StiffnessResult result =
      evaluate(read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml"), Method::corrected);
  const auto answer = [&] {
    return require_outputs(result, {"intact.stiffness >= 0 N*m/rad"}, 1.0).answers.at(0);
  };
  const Quantity K = result.intact.stiffness;
  EXPECT_LT(*answer().high - K.value, 0.5 * (K.value - *answer().low));
  result.curve->intact.K3.value = 1.001 * K.value;
  test::expect_relative(*answer().high - K.value, K.value - *answer().low, 1e-9);
}

/// The size 25 of the catalogue with a crack of the outer race 90 degrees from the lobe, which acts
/// in contacts only.
StiffnessResult with_crack_in_contacts() {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/catalogue_size25.toml");
  OuterRaceCrack crack;
  crack.depth = 0.7e-3;
  crack.position = 90 * units::deg;
  gear.wave_generator->crack.emplace_back(crack);
  return evaluate(gear, Method::corrected);
}

TEST(Require, BehaviourAChangeThatTheSumDoesNotSeeCannotBeTold) {
  // (ST-18): the crack changes the coupled drive, but not the sum.
  const StiffnessResult result = with_crack_in_contacts();
  ASSERT_EQ(result.positive.stiffness_change.value, 0.0);
  ASSERT_LT(result.curve->positive.change.K1.value, -0.013);
  for (const std::string sense : {"positive", "negative"})
    for (const char* const bound : {" >= -0.1 %", " <= -0.1 %"}) {
      const RequirementReport report =
          require_outputs(result, {"cracked." + sense + ".stiffness_change" + bound}, 1.0);
      EXPECT_EQ(report.outcome, RequirementOutcome::cannot_be_told) << sense << bound;
      EXPECT_FALSE(report.answers[0].low);
      ASSERT_EQ(test::note_codes(report.notes), std::vector<std::string>{"require.cannot_be_told"});
      const Note& note = report.notes[0];
      EXPECT_EQ(note.equation, "ST-18");
      EXPECT_EQ(note.next_step, "Require curve." + sense + ".change.K1 instead.");
      EXPECT_NE(note.text.find("can contain the change of the coupled drive"), std::string::npos)
          << note.text;
      // The next step is an output, which tells.
      EXPECT_EQ(require_outputs(result, {"curve." + sense + ".change.K1 >= -0.1 %"}, 1.0).outcome,
                RequirementOutcome::not_met);
    }
}

TEST(Require, IdentityTheSumIsNeverMoreCertainThanTheCoupledDrive) {
  // (ST-18): the softer end of the sum lies beyond that of each line of the coupled drive.
  const StiffnessResult result =
      evaluate(read_gear_set_file(STRAINWAVE_EXAMPLES "/cracked_size25.toml"), Method::corrected);
  for (const double coverage : {1.0, 2.0}) {
    const auto answer = [&](const std::string& output) {
      return require_outputs(result, {output}, coverage).answers.at(0);
    };
    for (const std::string line : {"K1", "K2", "K3"}) {
      EXPECT_LE(*answer("intact.stiffness >= 0 N*m/rad").low,
                *answer("curve.intact." + line + " >= 0 N*m/rad").low);
      EXPECT_LE(*answer("cracked.negative.stiffness >= 0 N*m/rad").low,
                *answer("curve.negative." + line + " >= 0 N*m/rad").low);
    }
    EXPECT_GE(*answer("cracked.positive.wind_up >= 0 rad").high,
              *answer("curve.positive.wind_up >= 0 rad").high);
  }
  // A bound below K1 and above its softer end, 26307 and 22361 N*m/rad.
  for (const std::string output : {"intact.stiffness", "curve.intact.K1"}) {
    const RequirementReport report = require_outputs(result, {output + " >= 26000 N*m/rad"}, 1.0);
    EXPECT_EQ(report.outcome, RequirementOutcome::cannot_be_told) << output;
    // No value of the file improves the accuracy of the coupled drive; a calibration does.
    EXPECT_EQ(report.notes.at(0).next_step.find("strainwave calibrate") != std::string::npos,
              output.starts_with("curve."))
        << report.notes.at(0).next_step;
  }
}

TEST(Require, IdentityAllTogetherAreAsGoodAsTheWorst) {
  const Quantity K = value_of(kStiffness);
  const std::string met = bound(kStiffness, ">=", 0.4 * K.value);
  const std::string open = bound(kStiffness, ">=", K.value);
  const std::string broken = bound(kStiffness, ">=", 2 * K.value);
  EXPECT_EQ(asked({met, met}).outcome, RequirementOutcome::met);
  EXPECT_EQ(asked({met, open}).outcome, RequirementOutcome::cannot_be_told);
  EXPECT_EQ(asked({broken, open, met}).outcome, RequirementOutcome::not_met);
  const auto judgement = [&](const std::vector<std::string>& texts) {
    return evidence_of(asked(texts)).verdict.judgement;
  };
  EXPECT_EQ(judgement({met}), Judgement::good);
  EXPECT_EQ(judgement({met, open}), Judgement::cannot_be_told);
  EXPECT_EQ(judgement({open, broken}), Judgement::critical);
  EXPECT_EQ(test::note_codes(asked({met, open, broken}).notes),
            (std::vector<std::string>{"require.cannot_be_told", "require.not_met"}));
  EXPECT_EQ(evidence_of(asked({broken})).requirement, RequirementOutcome::not_met);
  EXPECT_NE(requirements_text(asked({met, open})).find("All together: cannot be told\n"),
            std::string::npos);
  EXPECT_NE(requirements_text(asked({met}, 2.0)).find("standard uncertainty times 2"),
            std::string::npos);
}

TEST(Require, InputEveryRuleIsBrokenOnce) {
  const auto contains = [](const std::string& message, const char* part) {
    return message.find(part) != std::string::npos;
  };
  EXPECT_PRED2(contains, refusal_of("cracked.positive.stiffness 2e4"), "write OUTPUT OP VALUE");
  EXPECT_PRED2(contains, refusal_of("cracked.positive.stifness >= 1 N*m/rad"),
               "cracked.positive.stiffness");
  EXPECT_PRED2(contains, refusal_of("nothing >= 1"), "nothing");
  EXPECT_PRED2(contains, refusal_of(kStiffness + " >= 1 kg"), "kg");
  EXPECT_PRED2(contains, refusal_of(kStiffness + " >= "), kStiffness.c_str());
  EXPECT_PRED2(contains, refusal_of(kStiffness + " == 3 N*m/rad"), "write OUTPUT OP VALUE");
  EXPECT_PRED2(contains, test::broken_rule([] { return asked({}); }), "at least one");
  EXPECT_PRED2(contains, test::broken_rule([] { return asked({kStiffness + " > 1 N*m/rad"}, 0); }),
               "coverage");
}

}  // namespace
}  // namespace strainwave
