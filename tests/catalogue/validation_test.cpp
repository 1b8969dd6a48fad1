// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/validation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/layouts/validation.hpp"
#include "strainwave/present/json.hpp"
#include "support/expect.hpp"
#include "support/kept_rows.hpp"

namespace strainwave {
namespace {

using test::broken_rule;

const ErrorSummary& errors_of(const Validation& validation, const std::string& rows) {
  const auto found = std::ranges::find(validation.errors, rows, &ErrorSummary::of);
  EXPECT_NE(found, validation.errors.end()) << rows;
  return *found;
}

/// Validation of all rows without a fit.
const Validation& geometry() {
  static const Validation validation = validate();
  return validation;
}

/// The judgement of a size at one ratio in a table.
const ValidationRow& row_of(const Validation& validation, double size, double ratio) {
  const auto found = std::ranges::find_if(validation.each_ratio, [&](const ValidationRow& row) {
    return row.catalogue.origin == RowOrigin::catalogue && row.catalogue.size == size &&
           row.ratios.front() == ratio;
  });
  EXPECT_NE(found, validation.each_ratio.end()) << size << ' ' << ratio;
  return *found;
}

// Accuracy of geometry alone against the makers' tables; the tolerances are the model form.
TEST(ValidationByGeometry, ReferenceMakersTables) {
  ASSERT_EQ(geometry().rows.size(), 35U + 8U);
  const ErrorSummary& all = errors_of(geometry(), "catalogue");
  EXPECT_EQ(all.values, 103);
  EXPECT_LE(all.median, 0.20);
  EXPECT_LE(errors_of(geometry(), "catalogue, size >= 17, ratio >= 50").median, 0.15);
  EXPECT_EQ(errors_of(geometry(), "catalogue, size >= 17, ratio >= 50").values, 68);
  for (const ValidationRow& row : geometry().each_ratio) {
    EXPECT_LT(row.predicted[0], row.predicted[1]) << row.catalogue.size;
    EXPECT_LT(row.predicted[1], row.predicted[2]) << row.catalogue.size;
  }
}

// A row of 80 and more is judged at each ratio that the maker offers: 80, 100, 120, 160 from size
// 20 on, without 160 for size 17, 80 and 100 for 14, 100 for 11.
TEST(ValidationByGeometry, BehaviourAClassIsJudgedAtEachOfItsRatios) {
  EXPECT_EQ(geometry().each_ratio.size(), 7U + 15U + (1 + 2 + 3 + 10 * 4) + 8U);
  for (const double ratio : {80.0, 100.0, 120.0, 160.0})
    EXPECT_EQ(row_of(geometry(), 25, ratio).catalogue.K2, 50000) << ratio;
  // The mean of the class is that of its ratios, and the limits are their extremes.
  const auto& rows = geometry().rows;
  const auto of_class = std::ranges::find_if(rows, [](const ValidationRow& row) {
    return row.catalogue.size == 25 && row.ratios.size() == 4;
  });
  ASSERT_NE(of_class, rows.end());
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0.0;
    for (const double ratio : {80.0, 100.0, 120.0, 160.0})
      sum += row_of(geometry(), 25, ratio).predicted.at(k);
    test::expect_relative(of_class->predicted.at(k), sum / 4, 1e-15);  // rounding
    EXPECT_EQ(of_class->least.at(k), row_of(geometry(), 25, 80).predicted.at(k));
    EXPECT_EQ(of_class->most.at(k), row_of(geometry(), 25, 160).predicted.at(k));
  }
  // Groups: each ratio has its own, whose values are counted by hand from the table.
  const auto values_at = [](const std::string& of) {
    const auto found = std::ranges::find(geometry().errors_at_each_ratio, of, &ErrorSummary::of);
    return found == geometry().errors_at_each_ratio.end() ? 0 : found->values;
  };
  EXPECT_EQ(values_at("catalogue, ratio 80"), 3 * 12);
  EXPECT_EQ(values_at("catalogue, ratio 100"), 3 * 13);
  EXPECT_EQ(values_at("catalogue, ratio 120"), 3 * 11);
  EXPECT_EQ(values_at("catalogue, ratio 160"), 3 * 10);
  EXPECT_EQ(errors_of(geometry(), "catalogue, ratio 80+").values, 3 * 13);
  EXPECT_EQ(errors_of(geometry(), "catalogue, size < 17").values, 3 * 3 + (2 + 3 + 3) + 2 * 3);
  EXPECT_FALSE(errors_of(geometry(), "catalogue, ratio 50").spread_of[0].has_value());
}

// Hats are groups of their own, and a row that repeats the catalogue counts nowhere.
TEST(ValidationByGeometry, BehaviourOtherSeriesAreGroupsOfTheirOwn) {
  EXPECT_EQ(errors_of(geometry(), "other series").values, 12);
  EXPECT_EQ(errors_of(geometry(), "other series, flat hat").values, 9);
  EXPECT_FALSE(errors_of(geometry(), "other series, flat hat").median_of[2].has_value());
  EXPECT_EQ(errors_of(geometry(), "other series, short cup").rows, 1);
  EXPECT_EQ(errors_of(geometry(), "catalogue, short hat").values, 3);
  EXPECT_EQ(errors_of(geometry(), "all rows").values, 103 + 12);
  const std::string text = validation_text(geometry());
  EXPECT_NE(text.find("shown but not counted"), std::string::npos) << text;
}

// One curve for all sizes of a ratio is compared with each drive solved at its own size.
TEST(ValidationByGeometry, CrosscheckDriveOfItsOwnSize) {
  for (const auto& drive : {std::pair{17, 120.0}, {58, 50.0}, {40, 160.0}}) {
    const MakersLines lines = makers_lines(typical_drive_of_size(drive.first, drive.second));
    const ValidationRow& row = row_of(geometry(), drive.first, drive.second);
    test::expect_relative(row.predicted[0], lines.K1, 1e-6);  // Newton's tolerance
    test::expect_relative(row.predicted[1], lines.K2, 1e-6);
    test::expect_relative(row.predicted[2], lines.K3, 1e-6);
  }
}

// A hat is predicted as a hat, and a flat one as flat.
TEST(ValidationByGeometry, CrosscheckFlatHat) {
  const MakersLines lines = makers_lines(typical_drive_of_size(
      40, 160, {.form = FlexsplineForm::hat, .length = FlexsplineLength::flat}));
  const auto flat = std::ranges::find_if(geometry().rows, [](const ValidationRow& row) {
    return row.catalogue.length == FlexsplineLength::flat && row.catalogue.size == 40 &&
           row.ratios.front() == 160;
  });
  ASSERT_NE(flat, geometry().rows.end());
  test::expect_relative(flat->predicted[0], lines.K1, 1e-6);  // Newton's tolerance
  test::expect_relative(flat->predicted[1], lines.K2, 1e-6);
}

// One blank for all ratios has the walls of ratio 100, where the prediction is the same.
TEST(ValidationByGeometry, BehaviourOneBlankOfASize) {
  const ValidationOptions own{.sizes = {25}, .coupled = {.harmonics = 8}};
  ValidationOptions shared = own;
  shared.blank = Blank::size;
  const Validation by_ratio = validate(own);
  const Validation by_size = validate(shared);
  EXPECT_EQ(row_of(by_size, 25, 100).predicted, row_of(by_ratio, 25, 100).predicted);
  EXPECT_GT(row_of(by_size, 25, 80).predicted[2], row_of(by_ratio, 25, 80).predicted[2]);
  EXPECT_LT(row_of(by_size, 25, 160).predicted[2], row_of(by_ratio, 25, 160).predicted[2]);
  EXPECT_NE(validation_text(by_size).find("One blank serves"), std::string::npos);
}

// Median and worst error are computed by hand from the rows.
TEST(ValidationByGeometry, CrosscheckSummaries) {
  std::vector<double> errors;
  for (const ValidationRow& row : geometry().rows)
    if (row.catalogue.ratio_class == RatioClass::thirty)
      for (const auto& ratio : row.ratio())
        if (ratio) errors.push_back(std::abs(*ratio - 1));
  std::ranges::sort(errors);
  ASSERT_EQ(errors.size(), 21U);
  const ErrorSummary& thirty = errors_of(geometry(), "catalogue, ratio 30");
  EXPECT_EQ(thirty.median, errors[10]);
  EXPECT_EQ(thirty.worst, errors[20]);
  EXPECT_EQ(thirty.rows, 7);
}

TEST(ValidationByFit, ReferenceLeaveOneSizeOut) {
  const Validation v = validate({.mode = ValidationMode::leave_one_size_out,
                                 .factors = {Factor::coning},
                                 .sizes = {25, 58},
                                 .coupled = {.harmonics = 8}});
  ASSERT_EQ(v.rows.size(), 5U);
  EXPECT_EQ(v.trials.size(), 1U);
  const ErrorSummary& regular = errors_of(v, "catalogue, size >= 17, ratio >= 50");
  EXPECT_LE(regular.median, 0.08);  // the model form with one factor
  EXPECT_LE(regular.worst, 0.15);
  // Each size is predicted by a fit to the other, so the two factors differ.
  EXPECT_NE(v.rows.front().factors.at(0), v.rows.back().factors.at(0));
}

// Each class of ratio is predicted by a fit to the others, so the factor differs between 50 and
// 80+, and class 30, which no fit uses, gets the factor of all.
TEST(ValidationByFit, BehaviourLeaveOneClassOut) {
  const Validation v = validate({.mode = ValidationMode::leave_one_class_out,
                                 .factors = {Factor::support},
                                 .sizes = {25},
                                 .coupled = {.harmonics = 8}});
  ASSERT_EQ(v.rows.size(), 3U);
  ASSERT_EQ(v.trials.size(), 1U);
  EXPECT_EQ(v.trials[0].fitted, 6);
  EXPECT_EQ(v.rows[0].factors, v.trials[0].values);
  EXPECT_NE(v.rows[1].factors, v.rows[2].factors);
  // The fit to class 80+ alone, which predicts class 50, follows from a fit to one row.
  const Validation of_row = validate({.mode = ValidationMode::per_row,
                                      .factors = {Factor::support},
                                      .sizes = {25},
                                      .coupled = {.harmonics = 8}});
  test::expect_relative(v.rows[1].factors.at(0), of_row.rows[2].factors.at(0), 1e-3);  // of the fit
}

// Rows of other series and of a file judge only: with nonsense in a file, every fit is the same to
// the last bit, although the sizes 20 and 40 have rows of other series that would be regular.
TEST(ValidationByFit, BehaviourNoFitReadsRowsThatJudge) {
  ValidationOptions options{.mode = ValidationMode::leave_one_size_out,
                            .factors = {Factor::coning},
                            .sizes = {20, 40},
                            .coupled = {.harmonics = 8}};
  const Validation plain = validate(options);
  EXPECT_EQ(plain.trials.at(0).fitted, 12);  // two classes of two sizes, three values each
  options.data = parse_stiffness_rows(
      "size,ratio,T1 [N*m],T2 [N*m],K1 [N*m/rad],K2 [N*m/rad],K3 [N*m/rad]\n"
      "20,100,7,25,1,1,1\n40,50,54,196,1e9,1e9,1e9\n",
      "nonsense.csv");
  const Validation judged = validate(options);
  EXPECT_EQ(judged.rows.size(), plain.rows.size() + 2);
  EXPECT_EQ(judged.trials[0].values, plain.trials[0].values);
  for (std::size_t i = 0; i < plain.rows.size(); ++i)
    EXPECT_EQ(judged.rows[i].factors, plain.rows[i].factors) << i;
  for (const StiffnessRow& row : other_series_rows()) EXPECT_FALSE(is_regular(row)) << row.size;
  for (const StiffnessRow& row : options.data) EXPECT_FALSE(is_regular(row)) << row.size;
}

// Three factors fit three values, so the residual is the tolerance of the fit.
TEST(ValidationByFit, IdentityPerRowMeetsTheRow) {
  const Validation v =
      validate({.mode = ValidationMode::per_row, .sizes = {80}, .coupled = {.harmonics = 8}});
  ASSERT_EQ(v.rows.size(), 2U);
  EXPECT_LE(errors_of(v, "catalogue").worst, 0.02);
}

TEST(ValidationBands, IdentityReproducibleAndOrdered) {
  const ValidationOptions options{
      .draws = 5, .seed = 11, .sizes = {90}, .coupled = {.harmonics = 8}};
  const Validation one = validate(options);
  const Validation same = validate(options);
  EXPECT_EQ(json_of(one), json_of(same));
  for (const auto* const rows : {&one.rows, &one.each_ratio})
    for (const ValidationRow& row : *rows)
      for (const auto& band : row.band) {
        ASSERT_TRUE(band.has_value());
        EXPECT_LT(band->low, band->middle);
        EXPECT_LT(band->middle, band->high);
      }
  ValidationOptions other = options;
  other.seed = 12;
  EXPECT_NE(validation_csv(one), validation_csv(validate(other)));
}

// Kind: cross-check.  The rows are the draws: a drive made from the proportions of a row, and
// solved at its own size, has the K1, K2 and K3 of the row.  Tolerance: that of Newton's method.
// Rows of one drive have different names.
TEST(ValidationBands, CrosscheckRowsAreDrawnDrives) {
  StiffnessRow own = stiffness_rows().front();
  own.origin = RowOrigin::file;
  const ValidationOptions options{.draws = 3, .seed = 5, .sizes = {17}, .data = {own, own}};
  test::KeptRows rows;
  const Validation v = validate(options, {}, nullptr, &rows);
  ASSERT_EQ(rows.numbers.size(), 3U);
  EXPECT_EQ(rows.head.seed, 5U);
  EXPECT_EQ(rows.head.columns.size(), proportions().size() + 3 * v.each_ratio.size());
  std::set<std::string> names;
  for (const RowColumn& column : rows.head.columns) names.insert(column.name);
  EXPECT_EQ(names.size(), rows.head.columns.size());
  EXPECT_EQ(rows.head.columns[rows.column("rim_stress")].unit, "Pa");
  EXPECT_EQ(rows.head.columns[rows.column("flank_angle")].unit, "rad");
  EXPECT_EQ(rows.head.columns[rows.column("coning")].unit, "1");
  const ValidationRow& of = row_of(v, 17, 50);
  const std::string name = fmt::format("{} 17 ratio 50 short cup", of.catalogue.series);
  for (std::size_t n = 0; n < 3; ++n) {
    ProportionValues values;
    for (const Proportion& p : proportions()) {
      values.*p.value = rows.at(n, p.name);
      EXPECT_GE(values.*p.value, p.lower) << p.name;
      EXPECT_LE(values.*p.value, p.upper) << p.name;
    }
    const MakersLines lines = makers_lines(typical_drive_of_size(17, 50, {}, values));
    test::expect_relative(rows.at(n, "K1 of " + name), lines.K1, 1e-6);
    test::expect_relative(rows.at(n, "K2 of " + name), lines.K2, 1e-6);
    test::expect_relative(rows.at(n, "K3 of " + name), lines.K3, 1e-6);
  }
}

// The ends of a 90 % band of less than 20 drives are those of one drive, so a note asks for care.
TEST(ValidationBands, BehaviourFewDrawsAreNoted) {
  for (const int draws : {2, 19, 20}) {
    const Validation v =
        validate({.draws = draws, .seed = 11, .sizes = {90}, .coupled = {.harmonics = 8}});
    ASSERT_EQ(v.failed_draws, 0);
    EXPECT_EQ(test::count_notes(v.notes, "validation.few_draws"), draws < 20 ? 1 : 0) << draws;
    EXPECT_EQ(validation_text(v).find("Draw at least 100 drives") != std::string::npos, draws < 20);
    EXPECT_EQ(evidence_of(v).verdict.judgement,
              draws < 20 ? Judgement::with_care : Judgement::good);
  }
  EXPECT_TRUE(geometry().notes.empty());
}

// Bands say what they were made from, and which rows differ from it.
TEST(ValidationBands, BehaviourRowsOutsideAreNamed) {
  ValidationOptions options{.draws = 3, .sizes = {11, 20}, .coupled = {.harmonics = 8}};
  options.data = parse_stiffness_rows(
      "size,ratio,T1 [N*m],T2 [N*m],K1 [N*m/rad],K2 [N*m/rad],K3 [N*m/rad],length\n"
      "25,200,14,48,31000,50000,57000,standard\n",
      "own.csv");
  const Validation v = validate(options);
  const auto outside = [&](RowOrigin origin, double size, double ratio) {
    for (const ValidationRow& row : v.each_ratio)
      if (row.catalogue.origin == origin && row.catalogue.size == size &&
          row.ratios.front() == ratio)
        return row.outside;
    return std::string("no such row");
  };
  EXPECT_EQ(outside(RowOrigin::catalogue, 20, 160), "");
  EXPECT_EQ(outside(RowOrigin::catalogue, 11, 100), "hat");
  EXPECT_EQ(outside(RowOrigin::other_series, 20, 50), "hat, flat");
  EXPECT_EQ(outside(RowOrigin::file, 25, 200), "standard, size, ratio");
  ASSERT_TRUE(v.band_fit.has_value());
  EXPECT_EQ(v.band_fit->classes, 5);  // size 11 at 30 and 50, size 20 at 30, 50 and 80+
  EXPECT_EQ(v.band_fit->values, 15);
  EXPECT_EQ(v.band_tests.size(), 2U + 1U + 3U + 1U);
  const std::string text = validation_text(v);
  EXPECT_NE(text.find("a fit of the\nbands, never of a prediction"), std::string::npos) << text;
  EXPECT_NE(text.find("each class of ratio"), std::string::npos) << text;
}

TEST(ValidationProgress, BehaviourSharesGrowToOneAndAStopEndsIt) {
  const ValidationOptions options{.sizes = {90}, .coupled = {.harmonics = 8}};
  std::vector<double> shares;
  (void)validate(options, Progress([&](double share) {
                   shares.push_back(share);
                   return true;
                 }));
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_DOUBLE_EQ(shares.back(), 1.0);
  int told = 0;
  EXPECT_THROW((void)validate(options, Progress([&](double) { return ++told < 2; })), Stopped);
  EXPECT_EQ(told, 2);
}

TEST(ValidationOutput, BehaviourFormatsAgree) {
  const auto json = nlohmann::json::parse(json_of(geometry()));
  const auto& ratio = json["rows"]["ratio_K3"]["values"];
  ASSERT_EQ(ratio.size(), 43U);
  EXPECT_TRUE(ratio[7].is_null());  // size 8, ratio 50
  EXPECT_EQ(json["each_ratio"]["ratio_K3"]["values"].size(), 76U);
  EXPECT_EQ(json["rows"]["form"]["values"][42], "hat");
  EXPECT_EQ(json["rows"]["length"]["values"][42], "flat");
  EXPECT_EQ(json["rows"]["series"]["values"][42], "FHA-C");
  EXPECT_EQ(json["rows"]["origin"]["values"][42], "other-series");
  EXPECT_EQ(json["errors"]["values"]["values"][1], 103);
  EXPECT_EQ(json["errors_at_each_ratio"]["values"]["values"][1], 103 + 3 * (46 - 13));
  const std::string csv = validation_csv(geometry());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 76);
  EXPECT_NE(csv.find("40,80+,160,FHA-C,hat,flat,other-series,K1,110000,"), std::string::npos);
  const std::string text = validation_text(geometry());
  EXPECT_NE(text.find("catalogue, size >= 17, ratio >= 50"), std::string::npos);
  const std::string markdown = validation_markdown(geometry());
  EXPECT_NE(markdown.find("| 25 | 80+ | 3.1 | 5 | 5.7 |"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("| 25 | 160 | 3.1 | 5 | 5.7 |"), std::string::npos) << markdown;
}

constexpr std::string_view kHead =
    "size,ratio,T1 [N*m],T2 [N*m],K1 [N*m/rad],K2 [N*m/rad],K3 [N*m/rad]\n";

// A row of the catalogue that is given as a file in other units, by its diameter and in a dialect
// of spreadsheets gets the same judgement; 1e-10 is the tolerance of the forces, which rounding of
// the units moves.
TEST(OwnRows, IdentityARowOfTheCatalogueInOtherUnits) {
  const auto rows = parse_stiffness_rows(
      "\xEF\xBB\xBFSeries;ratio;pitch_diameter [mm];t1 [Nm];T2 [kN*m];K1 [kN*m/rad];K2 [N*m/rad];"
      "K3 [N*m/rad];remark\r\n"
      "Own;160;63,5;14;0,048;31;50000;57000;x\r\n"
      "Own;100;63,5;14;0,048;;50000;;\r\n",
      "own.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].series, "Own");
  EXPECT_EQ(rows[0].form, FlexsplineForm::cup);
  EXPECT_EQ(rows[0].length, FlexsplineLength::short_length);
  EXPECT_EQ(rows[0].origin, RowOrigin::file);
  EXPECT_EQ(rows[0].sources, "own.csv:2");
  EXPECT_EQ(rows[1].K1, std::nullopt);
  const Validation v = validate({.sizes = {25}, .data = rows});
  ASSERT_EQ(v.rows.size(), 5U);
  const ValidationRow& same = row_of(v, 25, 160);
  for (std::size_t k = 0; k < 3; ++k)
    test::expect_relative(v.rows[3].ratio().at(k).value_or(0), same.ratio().at(k).value_or(0),
                          1e-10);
  EXPECT_EQ(errors_of(v, "FILE").values, 4);
  EXPECT_EQ(errors_of(v, "all rows").values, errors_of(v, "catalogue").values + 4);
}

// A diameter of 50.8 mm is size 20 of the catalogue, in spite of rounding, so a fit that leaves
// this size out leaves it out for both rows.
TEST(OwnRows, IdentityADiameterIsTheSizeOfTheCatalogue) {
  const auto rows = parse_stiffness_rows(
      "pitch_diameter [mm],ratio,T1 [N*m],T2 [N*m],K1 [N*m/rad],K2 [N*m/rad],K3 [N*m/rad]\n"
      "50.8,100,7,25,16000,25000,29000\n101.6,100,54,196,130000,200000,230000\n",
      "own.csv");
  EXPECT_EQ(rows.at(0).size, 20.0);
  EXPECT_EQ(rows.at(1).size, 40.0);
}

// The length of a row decides which cup predicts it: a standard cup is longer, so it is softer.
TEST(OwnRows, BehaviourTheLengthOfARowCounts) {
  const auto rows = parse_stiffness_rows("length," + std::string(kHead) +
                                             "short,25,100,14,48,31000,50000,57000\n" +
                                             "standard,25,100,14,48,31000,50000,57000\n",
                                         "own.csv");
  const Validation v = validate({.sizes = {90}, .data = rows});
  EXPECT_LT(v.rows.back().predicted[1], 0.95 * v.rows[v.rows.size() - 2].predicted[1]);
}

TEST(OwnRows, InputRefusalsNameLineAndColumn) {
  const std::string head(kHead);
  for (const auto& [text, said] : {
           std::pair<std::string, std::string>{"", "own.csv: is empty"},
           {head, "own.csv: has no row; give at least one"},
           {"size,T1 [N*m]\n", "own.csv:1:1: must name the columns of the rows"},
           {"T1,T2\n", "own.csv:1:1: the column T1 has no unit; write T1 [N*m]"},
           {head + "20,25,7,25,1,,\n", "own.csv:2:4: ratio = 25 violates: >= 30 and <= 320"},
           {head + "20,100.3,7,25,1,,\n", "own.csv:2:4: ratio = 100.3 violates: 2 ratio"},
           {head + "20,,7,25,1,,\n", "own.csv:2:4: ratio = \"\" is not a number"},
           {head + "20,100,7,5,1,,\n", "own.csv:2:10: T2 = 5 violates: > T1"},
           {head + "20,100,0,5,1,,\n", "own.csv:2:8: T1 = 0 violates: > 0"},
           {head + "20,100,7,25,,,\n", "own.csv:2:13: must give one of K1, K2, K3"},
           {head + "20,100,7,25,1,-2,\n", "own.csv:2:15: K2 = -2 violates: > 0"},
           {head + ",100,7,25,1,,\n", "own.csv:2: must give either size or pitch_diameter [mm]"},
           {"form," + head + "bowl,20,100,7,25,1,,\n",
            "own.csv:2:1: form = \"bowl\" is not one of cup, hat"},
           {"length," + head + "long,20,100,7,25,1,,\n",
            "own.csv:2:1: length = \"long\" is not one of standard, short, flat"},
       }) {
    std::string refusal;
    try {
      (void)parse_stiffness_rows(text, "own.csv");
    } catch (const InputError& error) {
      refusal = error.what();
    }
    EXPECT_EQ(refusal.rfind(said, 0), 0U) << refusal << "\nwanted: " << said;
  }
}

// A torque that no drive holds is reported with the row that states it.
TEST(OwnRows, InputATorqueThatNoDriveHolds) {
  const auto rows =
      parse_stiffness_rows(std::string(kHead) + "20,100,7,25000,16000,,\n", "own.csv");
  std::string said;
  try {
    (void)validate({.sizes = {25}, .data = rows});
  } catch (const SolverError& error) {
    said = error.what();
  }
  EXPECT_NE(said.find("size 20 with T2 = 25000 N*m (own.csv:2)"), std::string::npos) << said;
}

TEST(ValidationInput, InputRefusals) {
  for (const int draws : {-1, 1, 100001})
    EXPECT_NE(broken_rule([&] { return validate({.draws = draws}); }).find("2 to 100000"),
              std::string::npos)
        << draws;
  EXPECT_NE(broken_rule([] { return validate({.sizes = {22}}); }).find("not a size"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return validate({.factors = {Factor::coning}}); }).find("geometry"),
            std::string::npos);
  EXPECT_NE(broken_rule([] {
              return validate({.mode = ValidationMode::per_row,
                               .factors = {Factor::coning, Factor::support, Factor::structure,
                                           Factor::clearance}});
            }).find("at most three"),
            std::string::npos);
  EXPECT_NE(broken_rule([] {
              return validate({.mode = ValidationMode::per_row, .all_sets = true});
            }).find("leave-one-size-out"),
            std::string::npos);
  EXPECT_NE(broken_rule([] {
              return validate({.mode = ValidationMode::per_row,
                               .data = parse_stiffness_rows(
                                   std::string(kHead) + "20,100,7,25,1,,\n", "own.csv")});
            }).find("rows of a file only judge"),
            std::string::npos);
  EXPECT_NE(broken_rule([] {
              return validate({.mode = ValidationMode::leave_one_size_out, .sizes = {8}});
            }).find("must include a row"),
            std::string::npos);
  EXPECT_NE(broken_rule([] {
              return validate({.mode = ValidationMode::leave_one_size_out,
                               .factors = {Factor::clearance},
                               .sizes = {25},
                               .coupled = {.harmonics = 8}});
            }).find("more of another size"),
            std::string::npos);
  EXPECT_NE(broken_rule([] {
              return validate({.mode = ValidationMode::leave_one_class_out,
                               .factors = {Factor::clearance},
                               .sizes = {100},
                               .coupled = {.harmonics = 8}});
            }).find("more of another class of ratio"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
