// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/validation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/layouts/validation.hpp"
#include "strainwave/present/json.hpp"
#include "support/expect.hpp"

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

// Accuracy of geometry alone against the makers' tables; the tolerances are the model form.
TEST(ValidationByGeometry, ReferenceMakersTables) {
  ASSERT_EQ(geometry().rows.size(), 35U);
  const ErrorSummary& all = errors_of(geometry(), "all rows");
  EXPECT_EQ(all.values, 103);
  EXPECT_LE(all.median, 0.20);
  EXPECT_LE(errors_of(geometry(), "size >= 17, ratio >= 50").median, 0.15);
  EXPECT_EQ(errors_of(geometry(), "size >= 17, ratio >= 50").values, 68);
  for (const ValidationRow& row : geometry().rows) {
    EXPECT_LT(row.predicted[0], row.predicted[1]) << row.catalogue.size;
    EXPECT_LT(row.predicted[1], row.predicted[2]) << row.catalogue.size;
  }
}

// One curve for all sizes of a ratio is compared with each drive solved at its own size.
TEST(ValidationByGeometry, CrosscheckDriveOfItsOwnSize) {
  for (const auto& drive : {std::pair{17, 100.0}, {58, 50.0}}) {
    const int size = drive.first;
    const double ratio = drive.second;
    GearSet gear = typical_drive_of_size(size, ratio);
    const MakersLines lines = makers_lines(gear);
    const auto row = std::ranges::find_if(geometry().rows, [&](const ValidationRow& r) {
      return r.catalogue.size == size && r.catalogue.ratio_class == ratio_class_of(ratio);
    });
    ASSERT_NE(row, geometry().rows.end());
    test::expect_relative(row->predicted[0], lines.K1, 1e-6);  // Newton's tolerance
    test::expect_relative(row->predicted[1], lines.K2, 1e-6);
    test::expect_relative(row->predicted[2], lines.K3, 1e-6);
  }
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
  const ErrorSummary& thirty = errors_of(geometry(), "ratio 30");
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
  const ErrorSummary& regular = errors_of(v, "size >= 17, ratio >= 50");
  EXPECT_LE(regular.median, 0.08);  // the model form with one factor
  EXPECT_LE(regular.worst, 0.15);
  // The two sizes are fitted to each other: the factor differs between them.
  EXPECT_NE(v.rows.front().factors.at(0), v.rows.back().factors.at(0));
}

// Three factors fit three values, so the residual is the tolerance of the fit.
TEST(ValidationByFit, IdentityPerRowMeetsTheRow) {
  const Validation v =
      validate({.mode = ValidationMode::per_row, .sizes = {80}, .coupled = {.harmonics = 8}});
  ASSERT_EQ(v.rows.size(), 2U);
  EXPECT_LE(errors_of(v, "ratio >= 50").worst, 0.02);
}

TEST(ValidationBands, IdentityReproducibleAndOrdered) {
  const ValidationOptions options{
      .draws = 5, .seed = 11, .sizes = {90}, .coupled = {.harmonics = 8}};
  const Validation one = validate(options);
  const Validation same = validate(options);
  EXPECT_EQ(json_of(one), json_of(same));
  for (const ValidationRow& row : one.rows)
    for (const auto& band : row.band) {
      ASSERT_TRUE(band.has_value());
      EXPECT_LT(band->low, band->middle);
      EXPECT_LT(band->middle, band->high);
    }
  ValidationOptions other = options;
  other.seed = 12;
  EXPECT_NE(validation_csv(one), validation_csv(validate(other)));
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
  ASSERT_EQ(ratio.size(), 35U);
  EXPECT_TRUE(ratio[7].is_null());  // size 8, ratio 50
  EXPECT_EQ(json["errors"]["values"]["values"][0], 103);
  const std::string csv = validation_csv(geometry());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 35);
  const std::string text = validation_text(geometry());
  EXPECT_NE(text.find("size >= 17, ratio >= 50"), std::string::npos);
  const std::string markdown = validation_markdown(geometry());
  EXPECT_NE(markdown.find("| 25 | 80+ | 3.1 | 5 | 5.7 |"), std::string::npos) << markdown;
}

TEST(ValidationInput, InputRefusals) {
  EXPECT_NE(broken_rule([] { return validate({.draws = -1}); }).find(">= 0"), std::string::npos);
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
              return validate({.mode = ValidationMode::leave_one_size_out, .sizes = {8}});
            }).find("must include a row"),
            std::string::npos);
  EXPECT_NE(broken_rule([] {
              return validate({.mode = ValidationMode::leave_one_size_out,
                               .factors = {Factor::clearance},
                               .sizes = {25},
                               .coupled = {.harmonics = 8}});
            }).find("two sizes of 17"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
