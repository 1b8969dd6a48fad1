// SPDX-License-Identifier: Apache-2.0 Presentation of the strength to users: text, JSON, fields,
// diagram, table.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/failure_assessment.hpp"
#include "strainwave/layouts/stiffness.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/strength/failure_assessment.hpp"
#include "strainwave/study/evaluate.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using Json = nlohmann::json;

GearSet critical() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/critical_crack.toml"); }

long occurrences(const std::string& text, const std::string& part) {
  long n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(StiffnessText, BehaviourATurnIsStated) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/breathing_crack.toml");
  const StiffnessResult result = evaluate(gear, Method::corrected, {.over_turn = true});
  EXPECT_NE(stiffness_text(result, gear, {})
                .find("over a turn at work:              K_I runs from 0 to 3.06"),
            std::string::npos);
  EXPECT_EQ(stiffness_text(evaluate(gear, Method::corrected), gear, {}).find("at work:"),
            std::string::npos);
}

TEST(StrengthReport, BehaviourACriticalCrackIsAnswered) {
  const GearSet gear = critical();
  const StiffnessResult result = evaluate(gear, Method::corrected);
  EXPECT_TRUE(result.usable());
  EXPECT_GT(result.positive.stiffness.value, 0.0);
  ASSERT_EQ(result.strength.size(), 4U);
  EXPECT_EQ(result.strength[1].path, "flexspline.crack[0]");
  EXPECT_EQ(result.strength[1].verdict, StrengthVerdict::fractures);
  EXPECT_EQ(result.strength[0].verdict, StrengthVerdict::cannot_tell);  // the cam bends the race
  for (const std::size_t i : {2U, 3U})
    EXPECT_EQ(result.strength[i].verdict, StrengthVerdict::acceptable);
  // The stiffness is that of the crack in its present state.
  EXPECT_EQ(result.positive.stiffness.value, torsional_stiffness(gear).positive.stiffness.value);
  const std::string text = stiffness_text(result, gear, {});
  const std::size_t warning = text.find("WARNING: flexspline.crack[0] fractures at this load");
  ASSERT_NE(warning, std::string::npos);
  EXPECT_LT(warning, text.find("Torsional stiffness"));
  EXPECT_EQ(occurrences(text, "WARNING"), 1);
  EXPECT_NE(text.find("Strength at the given load"), std::string::npos);
  EXPECT_NE(text.find("T > 0, with the assembly"), std::string::npos);
  EXPECT_NE(text.find("2 of 4 cracks hold, 1 fractures or collapses, 1 cannot be told"),
            std::string::npos);
  EXPECT_NE(text.find("about 457 MPa"), std::string::npos);
  // The shell couples sliding to the opening (FR-9), but not mode III, so rounding such as 6.5e-17
  // must not appear.
  EXPECT_LT(result.cracks.at(1).deepest->K_II.value, 0.0);
  EXPECT_NE(text.find("K_I = 11"), std::string::npos);
  EXPECT_NE(text.find("K_III = 0 MPa"), std::string::npos);
  EXPECT_EQ(text.find("e-17"), std::string::npos);
  // The reversed torque causes the same warning.
  GearSet reversed = gear;
  reversed.load.torque = -600;
  EXPECT_NE(stiffness_text(evaluate(reversed, Method::corrected), reversed, {})
                .find("fractures at this load under torque of the other sense (T > 0)"),
            std::string::npos);
  // A note of the strength names its cracks and its own equation.
  const auto assembly = std::ranges::find(result.notes, "FA-12", &Note::equation);
  ASSERT_NE(assembly, result.notes.end());
  EXPECT_EQ(assembly->path, "flexspline.crack[0], flexspline.crack[1]");
}

TEST(StrengthReport, BehaviourABreakingCrackIsACriticalNote) {
  GearSet gear = critical();
  gear.material["hard_steel"].fracture_toughness = 5e6;
  const StiffnessResult result = evaluate(gear, Method::corrected);
  const auto note = std::ranges::find(result.notes, "strength.breaks", &Note::code);
  ASSERT_NE(note, result.notes.end());
  EXPECT_TRUE(note->text.starts_with("fractures at this load"));
  EXPECT_EQ(note->severity, Severity::critical);
  EXPECT_TRUE(result.usable());
}

TEST(StrengthReport, BehaviourJsonAndFields) {
  const GearSet gear = critical();
  const StiffnessResult result = evaluate(gear, Method::corrected);
  const Json json = Json::parse(json_of(result));
  const Json& strength = json["cracks"][1]["strength"];
  EXPECT_EQ(strength["verdict"], "fractures");
  EXPECT_EQ(strength["governing"], 1);
  EXPECT_EQ(strength["states"].size(), 4U);
  EXPECT_EQ(strength["states"][1]["K_r"], strength["K_r"]);
  EXPECT_EQ(strength["states"][1]["with_assembly"], true);
  EXPECT_EQ(strength["states"][2]["torque"], "negative");
  int n = 0;
  for_each_quantity(result, [&](const std::string& path, const Quantity& q) {
    if (path == result.strength[1].path + ".strength.reserve") {
      EXPECT_EQ(q.value, *result.strength[1].worst()->reserve);
      EXPECT_EQ(q.value, strength["reserve"]["value"]);
      ++n;
    }
    if (path == result.strength[3].path + ".strength.critical_size") {
      EXPECT_EQ(q.unit, "m");
      ++n;
    }
  });
  EXPECT_EQ(n, 2);
}

TEST(StrengthReport, BehaviourCrackOfTheCoupledDriveIsInTheJson) {
  GearSet gear = critical();
  OuterRaceCrack outer;
  outer.depth = 1e-4;
  gear.wave_generator->bearing->outer_ring = BearingRing{0.038, 0.0015, 0.01};
  gear.wave_generator->bearing->ball_count = 21;
  gear.wave_generator->crack.emplace_back(outer);
  const StiffnessResult result = evaluate(gear, Method::corrected);
  const Json json = Json::parse(json_of(result));
  EXPECT_EQ(json["cracks"].size(), 5U);
  EXPECT_EQ(json["cracks"][4]["path"], "wave_generator.crack[1]");
  EXPECT_EQ(json["cracks"][4]["strength"]["verdict"], "cannot_tell");
  EXPECT_EQ(json["cracks"][1]["strength"]["verdict"], "fractures");
  EXPECT_NE(stiffness_text(result, gear, {}).find("acts in the coupled drive only"),
            std::string::npos);
}

TEST(StrengthReport, InputNothingIsKnown) {
  const GearSet gear = test::article_gear();
  const StiffnessResult result = evaluate(gear, Method::corrected);
  EXPECT_TRUE(result.strength.empty());
  EXPECT_EQ(test::count_notes(result.notes, "strength.cannot_tell"), 1);
  EXPECT_EQ(stiffness_text(result, gear, {}).find("Strength at"), std::string::npos);
  EXPECT_THROW((void)failure_assessment_plot(result, gear), InputError);
  EXPECT_THROW((void)failure_assessment_csv(result, gear), InputError);
  GearSet sound = gear;
  sound.flexspline->crack.clear();
  sound.wave_generator->crack.clear();
  sound.output_shaft->crack.clear();
  EXPECT_EQ(test::count_notes(evaluate(sound, Method::corrected).notes, "strength.cannot_tell"), 0);
  GearSet known = gear;
  known.material["steel"].fracture_toughness = 50e6;
  EXPECT_TRUE(evaluate(known, Method::repaired).strength.empty());
  EXPECT_EQ(evaluate(known, Method::corrected).strength.size(), 3U);
}

TEST(FailureAssessmentPlot, BehaviourLinesAndPoints) {
  const GearSet gear = critical();
  const StiffnessResult result = evaluate(gear, Method::corrected);
  const PlotPanel panel = failure_assessment_panel(result, gear);
  // There are three materials, two states of each wall crack, one state each of race and shaft, and
  // the through crack under the reversed torque.
  ASSERT_EQ(panel.series.size(), 11U);
  EXPECT_NE(std::ranges::find(panel.series, "flexspline.crack[0] +, reversed", &PlotSeries::label),
            panel.series.end());
  EXPECT_EQ(panel.series[0].label, "line, bearing_steel");
  EXPECT_EQ(panel.series[0].y.front(), 1.0);
  EXPECT_EQ(panel.series[0].y.back(), 0.0);
  EXPECT_NEAR(panel.series[0].x.back(), 3700.0 / 3400, 1e-14);
  const auto with = std::ranges::find(panel.series, "flexspline.crack[0] +", &PlotSeries::label);
  ASSERT_NE(with, panel.series.end());
  EXPECT_EQ(with->y.back(), *result.strength[1].states[1].K_r);
  EXPECT_EQ(with->x.back(), *result.strength[1].states[1].L_r);
  EXPECT_NEAR(with->y.front(), result.strength[1].states[1].K_assembly / 15e6, 1e-12);
  EXPECT_EQ(with->discs, Discs::at_end);
  const std::string svg = failure_assessment_plot(result, gear);
  EXPECT_EQ(occurrences(svg, "<circle"), 8);
  EXPECT_EQ(svg, failure_assessment_plot(result, gear));
}

TEST(FailureAssessmentTable, BehaviourRows) {
  const GearSet gear = critical();
  const StiffnessResult result = evaluate(gear, Method::corrected);
  const std::string csv = failure_assessment_csv(result, gear);
  EXPECT_TRUE(csv.starts_with("what,name,torque,with_assembly,L_r,K_r,limit,reserve,verdict\n"));
  EXPECT_EQ(occurrences(csv, "\ncrack,"), 8);
  EXPECT_NE(csv.find("\nline,hard_steel,,,0,1,,,\n"), std::string::npos);
  EXPECT_NE(csv.find("crack,flexspline.crack[0],positive,1,"), std::string::npos);
  EXPECT_EQ(occurrences(csv, ",fractures\n"), 1);
  // Every row must have the columns of the head.
  std::size_t begin = 0;
  for (std::size_t end = csv.find('\n'); end != std::string::npos; end = csv.find('\n', begin)) {
    EXPECT_EQ(std::count(csv.begin() + static_cast<long>(begin),
                         csv.begin() + static_cast<long>(end), ','),
              8);
    begin = end + 1;
  }
}

}  // namespace
}  // namespace strainwave
