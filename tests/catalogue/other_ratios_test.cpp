// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/other_ratios.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "strainwave/catalogue/calibration.hpp"
#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/layouts/calibration.hpp"
#include "strainwave/present/json.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using test::broken_rule;

const CoupledOptions kCoarse{.harmonics = 8};

/// A drive fitted to its row of the catalogue by its coning.
Calibration fitted_drive(const GearSet& gear) {
  return calibrate(gear, catalogue_target(gear), {Factor::coning}, kCoarse);
}

const Calibration& fitted_size25() {
  static const Calibration c = fitted_drive(typical_drive_of_size(25, 50));
  return c;
}

/// All ratios of the tables and one that no table states, with the calibrated ratio first.
const OtherRatios& others_of_size25() {
  static const OtherRatios others = predict_other_ratios(
      fitted_size25(), {50, 30, 80, 100, 120, 160, 90, 200}, Blank::ratio, kCoarse);
  return others;
}

// At the calibrated ratio the prediction is the fitted drive, and the typical drive with the fitted
// factors is the same drive.  1e-9: `after` is an exponential of a residual.
TEST(OtherRatios, IdentityTheCalibratedRatioReturnsTheFit) {
  const OtherRatios& others = others_of_size25();
  const auto& fit = fitted_size25().stiffnesses;
  ASSERT_EQ(others.predictions.size(), 24U);
  for (std::size_t k = 0; k < 3; ++k) {
    const RatioPrediction& p = others.predictions[k];
    EXPECT_EQ(p.ratio, 50);
    EXPECT_EQ(p.name, fit[k].target.name);
    test::expect_relative(p.predicted, fit[k].after, 1e-9);
    test::expect_relative(p.stated.value(), fit[k].target.stiffness, 1e-12);
    test::expect_relative(p.to_torque, fit[k].target.to_torque, 1e-12);
    EXPECT_TRUE(p.same_row);
    EXPECT_FALSE(p.usual_error.has_value());
  }
  EXPECT_EQ(others.geometry_difference, 0.0);
}

// Two roads: the typical drive of ratio 80, changed by hand, under the maker's lines.
TEST(OtherRatios, CrosscheckAnotherRatioIsTheTypicalDriveWithTheFactor) {
  GearSet gear = typical_drive_of_size(25, 80);
  gear.mesh->coning = fitted_size25().factors[0].value;
  const MakersLines lines = makers_lines(gear, +1, kCoarse);
  const auto& predictions = others_of_size25().predictions;
  ASSERT_EQ(predictions[6].ratio, 80);
  EXPECT_EQ(predictions[6].predicted, lines.K1);
  EXPECT_EQ(predictions[7].predicted, lines.K2);
  EXPECT_EQ(predictions[8].predicted, lines.K3);
  test::expect_relative(predictions[8].to_torque, 1.6 * 48, 1e-12);
}

// The row of size 25, 80 and more, is K = 3.1, 5.0, 5.7e4 N*m/rad at T1 = 14, T2 = 48 N*m.
TEST(OtherRatios, BehaviourErrorsAreThoseOfTheStatedValues) {
  const OtherRatios& others = others_of_size25();
  EXPECT_EQ(others.size, 25);
  EXPECT_EQ(others.from, 50);
  std::vector<double> errors;
  for (const RatioPrediction& p : others.predictions) {
    const bool stated = p.ratio != 90 && p.ratio != 200;
    ASSERT_EQ(p.stated.has_value(), stated) << p.ratio;
    EXPECT_EQ(p.series.empty(), !stated);
    ASSERT_EQ(p.error().has_value(), stated);
    EXPECT_EQ(p.same_row, p.ratio == 50);
    if (!stated) continue;
    EXPECT_EQ(*p.error(), p.predicted / *p.stated - 1);
    if (p.ratio >= 80) {
      EXPECT_EQ(*p.stated, p.name == "K1" ? 3.1e4 : p.name == "K2" ? 5e4 : 5.7e4);
    }
    if (p.ratio != 50) errors.push_back(std::abs(*p.error()));
  }
  ASSERT_EQ(errors.size(), 15U);  // five other ratios; the calibrated ratio is no prediction
  std::ranges::sort(errors);
  EXPECT_EQ(others.median.value(), errors[7]);
  EXPECT_EQ(others.worst.value(), errors[14]);
}

// A ratio without a stated value has the error of its class; no class reaches beyond ratio 160.
TEST(OtherRatios, BehaviourUsualErrorIsThatOfTheClass) {
  const OtherRatios& others = others_of_size25();
  ASSERT_EQ(others.transfer.classes.size(), 2U);  // a class of one ratio has no other ratio
  const TransferError& thirty = others.transfer.classes[0];
  const TransferError& eighty = others.transfer.classes[1];
  EXPECT_EQ(thirty.to, RatioClass::thirty);
  EXPECT_EQ(eighty.to, RatioClass::eighty_up);
  EXPECT_EQ(thirty.sizes, 4);  // 17, 20, 25, 32
  EXPECT_EQ(thirty.values, 12);
  EXPECT_EQ(eighty.sizes, 11);  // 17 to 90
  EXPECT_EQ(eighty.values, 3 * (3 + 10 * 4));
  EXPECT_EQ(others.transfer.left_out, 0);
  for (const RatioPrediction& p : others.predictions) {
    if (p.ratio == 50 || p.ratio == 200) {
      EXPECT_FALSE(p.usual_error || p.worst_error) << p.ratio;
      continue;
    }
    const TransferError& of_class = p.ratio == 30 ? thirty : eighty;
    EXPECT_EQ(p.usual_error.value(), of_class.median) << p.ratio;
    EXPECT_EQ(p.worst_error.value(), of_class.worst) << p.ratio;
  }
}

// Two roads: the prediction of each size by itself gives the errors that the summary contains.
TEST(OtherRatios, CrosscheckTransferErrorsAreThoseOfEachSize) {
  std::vector<double> errors;
  for (const int size : {17, 20, 25, 32}) {
    const Calibration c = fitted_drive(typical_drive_of_size(size, 50));
    GearSet gear = typical_drive_of_size(size, 30);
    gear.mesh->coning = c.gear.mesh->coning;
    const MakersLines lines = makers_lines(gear, +1, kCoarse);
    const StiffnessRow* const row = find_stiffness(size, 30);
    ASSERT_NE(row, nullptr);
    for (const double ratio :
         {lines.K1 / row->K1.value(), lines.K2 / row->K2.value(), lines.K3 / row->K3.value()})
      errors.push_back(std::abs(ratio - 1));
  }
  std::ranges::sort(errors);
  const TransferError& thirty = others_of_size25().transfer.classes[0];
  test::expect_relative(thirty.median, (errors[5] + errors[6]) / 2, 1e-12);
  test::expect_relative(thirty.worst, errors[11], 1e-12);
}

/// A drive fitted by its coning to stiffnesses of its own, times 1.05, which no table states.
Calibration fitted_to_a_bench(const GearSet& gear) {
  const MakersTorques at = makers_torques(gear);
  const MakersLines lines = makers_lines(gear, +1, kCoarse);
  return calibrate(
      gear,
      {.source = "made up",
       .values = {{"K1", 0, at.T1, 1.05 * lines.K1}, {"K2", at.T1, at.T2, 1.05 * lines.K2}},
       .relative_uncertainty = 0.01},
      {Factor::coning}, kCoarse);
}

std::set<double> ratios_of(const OtherRatios& others) {
  std::set<double> ratios;
  for (const RatioPrediction& p : others.predictions) ratios.insert(p.ratio);
  return ratios;
}

std::set<std::string> note_codes_of(Calibration c, const OtherRatios& others) {
  c.other_ratios = others;
  std::set<std::string> codes;
  for (const Note& note : evidence_of(c).notes) codes.insert(note.code);
  return codes;
}

// The row of 80 and more holds for four ratios.  A fit to it at ratio 100 has read the values of
// the other three, so these judge nothing, neither here nor over the catalogue.
TEST(OtherRatios, BehaviourTheFittedRowJudgesNothing) {
  const Calibration c = fitted_drive(typical_drive_of_size(17, 100));
  const OtherRatios others = predict_other_ratios(c, {}, Blank::ratio, kCoarse);
  EXPECT_EQ(ratios_of(others), (std::set<double>{30, 50, 80, 120}));
  std::vector<double> errors;
  for (const RatioPrediction& p : others.predictions) {
    const bool same_row = p.ratio >= 80;
    EXPECT_EQ(p.same_row, same_row) << p.ratio;
    EXPECT_TRUE(p.error().has_value()) << p.ratio;
    EXPECT_EQ(p.usual_error.has_value(), !same_row) << p.ratio;
    EXPECT_EQ(p.worst_error.has_value(), !same_row) << p.ratio;
    if (!same_row) errors.push_back(std::abs(*p.error()));
  }
  ASSERT_EQ(errors.size(), 6U);
  std::ranges::sort(errors);
  test::expect_relative(others.median.value(), (errors[2] + errors[3]) / 2, 1e-12);
  EXPECT_EQ(others.worst.value(), errors[5]);
  ASSERT_EQ(others.transfer.classes.size(), 2U);
  EXPECT_EQ(others.transfer.classes[0].to, RatioClass::thirty);
  EXPECT_EQ(others.transfer.classes[1].to, RatioClass::fifty);
  EXPECT_FALSE(note_codes_of(c, others).contains("calibration.unknown_error"));

  // No value of a table entered the fit to a measured curve, so all judge.
  const OtherRatios measured = predict_other_ratios(
      fitted_to_a_bench(typical_drive_of_size(17, 100)), {80}, Blank::ratio, kCoarse);
  EXPECT_FALSE(measured.predictions[0].same_row);
  EXPECT_TRUE(measured.median.has_value());
}

// Without a list, the tables decide: rows of other series judge hats of their size and length.  The
// catalogue shows errors of predictions for short cups of size 17 and more; a note says that those
// of any other drive are not known.
TEST(OtherRatios, BehaviourDrivesWhoseErrorsAreNotKnown) {
  const DriveType flat_hat{.form = FlexsplineForm::hat, .length = FlexsplineLength::flat};
  const Calibration hat = fitted_to_a_bench(typical_drive_of_size(20, 100, flat_hat));
  const OtherRatios of_hat = predict_other_ratios(hat, {}, Blank::ratio, kCoarse);
  EXPECT_EQ(of_hat.type.form, flat_hat.form);
  EXPECT_EQ(of_hat.type.length, flat_hat.length);
  EXPECT_EQ(ratios_of(of_hat), (std::set<double>{50, 160}));
  EXPECT_TRUE(of_hat.median.has_value());

  const Calibration small = fitted_to_a_bench(typical_drive_of_size(14, 100));
  const OtherRatios of_small = predict_other_ratios(small, {50}, Blank::ratio, kCoarse);

  for (const auto& [c, others] : {std::pair(hat, of_hat), std::pair(small, of_small)}) {
    EXPECT_FALSE(errors_are_known(others));
    EXPECT_TRUE(others.transfer.classes.empty());
    for (const RatioPrediction& p : others.predictions)
      EXPECT_FALSE(p.usual_error || p.worst_error) << p.ratio;
    EXPECT_TRUE(note_codes_of(c, others).contains("calibration.unknown_error"));
    Calibration with = c;
    with.other_ratios = others;
    EXPECT_EQ(evidence_of(with).verdict.judgement, Judgement::with_care);
    EXPECT_EQ(calibration_text(with).find("Usual and worst error"), std::string::npos);
  }
}

// Cracks, shaft and flange are no part of a catalogue's drive; a drive of other geometry is told.
TEST(OtherRatios, BehaviourGeometryOfTheDriveIsJudgedAtItsRatio) {
  GearSet gear = typical_drive_of_size(25, 50);
  gear.flexspline->flange_compliance = 1e-6;
  const Calibration with_flange = fitted_drive(gear);
  const OtherRatios same = predict_other_ratios(with_flange, {80}, Blank::ratio, kCoarse);
  EXPECT_EQ(same.geometry_difference, 0.0);
  EXPECT_EQ(same.predictions[0].predicted, others_of_size25().predictions[6].predicted);

  gear.flexspline->barrel->wall_thickness *= 0.4;
  const OtherRatios thinner = predict_other_ratios(fitted_drive(gear), {80}, Blank::ratio, kCoarse);
  EXPECT_GT(thinner.geometry_difference, kTypicalDrive);

  EXPECT_FALSE(note_codes_of(with_flange, same).contains("calibration.other_geometry"));
  EXPECT_TRUE(note_codes_of(with_flange, thinner).contains("calibration.other_geometry"));
}

TEST(OtherRatios, IdentityTheSameCalibrationGivesTheSameNumbers) {
  const OtherRatios again = predict_other_ratios(
      fitted_size25(), {50, 30, 80, 100, 120, 160, 90, 200}, Blank::ratio, kCoarse);
  EXPECT_EQ(json_of(again), json_of(others_of_size25()));
}

// The blank of size changes walls at ratios other than 100 only.
TEST(OtherRatios, BehaviourBlankOfTheOtherDrives) {
  const OtherRatios blank = predict_other_ratios(fitted_size25(), {80, 100}, Blank::size, kCoarse);
  const auto& own = others_of_size25().predictions;
  EXPECT_NE(blank.predictions[0].predicted, own[6].predicted);
  EXPECT_EQ(blank.predictions[3].predicted, own[9].predicted);
}

TEST(OtherRatios, InputRefusals) {
  EXPECT_EQ(parse_ratios("all"), std::vector<double>());
  EXPECT_EQ(parse_ratios("50,80,100.5"), (std::vector<double>{50, 80, 100.5}));
  for (const auto& row : std::map<std::string, std::string>{
           {"", "\"\" is not a ratio; write ratios such as 50,80,100, or all"},
           {"50,", "\"\" is not a ratio"},
           {"50,many", "\"many\" is not a ratio"},
           {"29", "predict-ratios: 29 violates: >= 30 and <= 320"},
           {"321", "predict-ratios: 321 violates: >= 30 and <= 320"},
           {"50.3", "2 ratio, the teeth of the flexspline, a whole number"},
           {"50,80,50", "50 is named twice; name it once"}})
    EXPECT_NE(broken_rule([&] { return parse_ratios(row.first); }).find(row.second),
              std::string::npos)
        << row.first << ": " << broken_rule([&] { return parse_ratios(row.first); });

  const auto refusal = [](const GearSet& gear, const std::vector<double>& ratios) {
    Calibration c;
    c.gear = gear;
    return broken_rule([&] { return predict_other_ratios(c, ratios); });
  };
  EXPECT_NE(refusal(typical_drive(0.064, 100), {80}).find("a size of the catalogue, 8, 11, 14"),
            std::string::npos);
  EXPECT_NE(refusal(typical_drive_of_size(25, 100), {20}).find(">= 30"), std::string::npos);
  EXPECT_NE(refusal(typical_drive_of_size(25, 100, {.length = FlexsplineLength::standard}), {})
                .find("no table states another ratio of a standard cup of size 25"),
            std::string::npos);
  GearSet cylinder = typical_drive_of_size(25, 100);
  cylinder.flexspline->shape = FlexsplineShape::cylinder;
  EXPECT_NE(refusal(cylinder, {80}).find("must be cup or hat"), std::string::npos);
  EXPECT_NE(broken_rule([] { return transfer_errors(50, {}); }).find("one to three"),
            std::string::npos);
  EXPECT_NE(broken_rule([] {
              return transfer_errors(
                  50, {Factor::support, Factor::coning, Factor::gap_factor, Factor::structure});
            }).find("one to three"),
            std::string::npos);
}

TEST(OtherRatiosProgress, BehaviourAStopEndsIt) {
  int told = 0;
  EXPECT_THROW((void)predict_other_ratios(fitted_size25(), {80}, Blank::ratio, kCoarse,
                                          Progress([&](double) { return ++told < 3; })),
               Stopped);
  EXPECT_EQ(told, 3);
}

TEST(OtherRatiosOutput, BehaviourTextAndJson) {
  Calibration c = fitted_size25();
  EXPECT_EQ(calibration_text(c).find("Other ratios"), std::string::npos);
  c.other_ratios = others_of_size25();
  const std::string text = calibration_text(c);
  for (const char* const words :
       {"Other ratios of a short cup of size 25, from the calibration at ratio 50",
        "only the factors are those of the calibration", "From ratio 50 to 80 and more: median ",
        "over 11 of the catalogue's sizes", "From ratio 50 to 30: median ", "same row as the fit",
        "Error against the stated values that entered no fit: median "})
    EXPECT_NE(text.find(words), std::string::npos) << words << '\n' << text;
  // A difference that comes from rounding is shown as none; a larger one has its digits.
  Calibration rounded = c;
  rounded.other_ratios->geometry_difference = 1.2e-7;
  EXPECT_NE(calibration_text(rounded).find("drive by 0 % at most"), std::string::npos);
  rounded.other_ratios->geometry_difference = 0.012;
  EXPECT_NE(calibration_text(rounded).find("drive by 1.2 % at most"), std::string::npos);
  const auto json = nlohmann::json::parse(json_of(c))["other_ratios"];
  EXPECT_EQ(json["from"]["value"], 50);
  EXPECT_EQ(json["median"]["value"], *c.other_ratios->median);
  EXPECT_EQ(json["worst"]["value"], *c.other_ratios->worst);
  const auto& predictions = json["predictions"];
  EXPECT_EQ(predictions["ratio"]["values"][6], 80);
  EXPECT_EQ(predictions["same_row"]["values"][0], true);
  EXPECT_EQ(predictions["same_row"]["values"][6], false);
  EXPECT_EQ(predictions["stated"]["values"][6], 31000);
  EXPECT_EQ(predictions["error"]["values"][6], *c.other_ratios->predictions[6].error());
  EXPECT_TRUE(predictions["error"]["values"][18].is_null());  // no table states ratio 90
  EXPECT_EQ(json["transfer_errors"]["worst"]["values"][1],
            c.other_ratios->transfer.classes[1].worst);
}

}  // namespace
}  // namespace strainwave
