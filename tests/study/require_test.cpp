// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/require.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

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

TEST(Require, ReferenceMetNotMetAndBetween) {
  const Quantity K = value_of(kStiffness);
  const double u = K.relative_uncertainty.value() * K.value;
  ASSERT_GT(u, 0);
  for (const char* const op : {">=", ">"}) {
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value - 1.01 * u)), RequirementOutcome::met);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value - 0.99 * u)),
              RequirementOutcome::cannot_be_told);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value + 0.99 * u)),
              RequirementOutcome::cannot_be_told);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value + 1.01 * u)), RequirementOutcome::not_met);
  }
  for (const char* const op : {"<=", "<"}) {
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value + 1.01 * u)), RequirementOutcome::met);
    EXPECT_EQ(outcome(bound(kStiffness, op, K.value + 0.99 * u)),
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
  test::expect_relative(*answer.high - *answer.low, 4 * u, 1e-9);
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

TEST(Require, LimitWithoutUncertaintyItCannotBeTold) {
  ASSERT_FALSE(value_of(kStiffness, Method::as_printed).relative_uncertainty);
  for (const char* const text : {" >= 1 N*m/rad", " <= 1 N*m/rad"}) {
    const RequirementReport report = asked({kStiffness + text}, 1.0, Method::as_printed);
    EXPECT_EQ(report.outcome, RequirementOutcome::cannot_be_told);
    EXPECT_FALSE(report.answers[0].low);
    EXPECT_NE(requirements_text(report).find("unknown"), std::string::npos);
  }
}

TEST(Require, BehaviourTheNoteSaysThatWhatIsLeftOutActsToOneSide) {
  // The bound lies above the stiffness of the sum; the drive is softer, but the uncertainty has two
  // sides.
  const auto says = [](const GearSet& gear, const std::string& output, double share) {
    const StiffnessResult result = evaluate(gear, Method::corrected);
    const std::string text = bound(output, "<=", share * output_named(result, output)->value);
    const Note note = require_outputs(result, {text}, 1.0).notes.at(0);
    return note.text.find("equally to both sides") != std::string::npos && note.equation == "ST-18";
  };
  const GearSet gear = test::article_gear();
  EXPECT_TRUE(says(gear, "intact.stiffness", 1.1));
  EXPECT_TRUE(says(gear, "intact.compliance.total", 1.1));
  // The text shows the note below the table.
  EXPECT_NE(
      requirements_text(asked({"intact.stiffness <= 7e5 N*m/rad"})).find("equally to both sides"),
      std::string::npos);
  // A requirement that is not met, a member, and a sum that leaves out nothing get no such note.
  EXPECT_FALSE(says(gear, "intact.stiffness", 0.001));
  EXPECT_FALSE(says(gear, "intact.compliance.flexspline", 1.001));
  GearSet shaft = gear;
  shaft.wave_generator.reset();
  EXPECT_FALSE(says(shaft, "intact.stiffness", 1.001));
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
}

TEST(Require, InputEveryRuleIsBrokenOnce) {
  const auto contains = [](const std::string& message, const char* part) {
    return message.find(part) != std::string::npos;
  };
  EXPECT_PRED2(contains, refusal_of("cracked.positive.stiffness 2e4"), "must be OUTPUT OP VALUE");
  EXPECT_PRED2(contains, refusal_of("cracked.positive.stifness >= 1 N*m/rad"),
               "cracked.positive.stiffness");
  EXPECT_PRED2(contains, refusal_of("nothing >= 1"), "nothing");
  EXPECT_PRED2(contains, refusal_of(kStiffness + " >= 1 kg"), "kg");
  EXPECT_PRED2(contains, refusal_of(kStiffness + " >= "), kStiffness.c_str());
  EXPECT_PRED2(contains, refusal_of(kStiffness + " == 3 N*m/rad"), "must be OUTPUT OP VALUE");
  EXPECT_PRED2(contains, test::broken_rule([] { return asked({}); }), "at least one");
  EXPECT_PRED2(contains, test::broken_rule([] { return asked({kStiffness + " > 1 N*m/rad"}, 0); }),
               "coverage");
}

}  // namespace
}  // namespace strainwave
