// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/layouts/catalogue.hpp"
#include "strainwave/present/json.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using test::broken_rule;

constexpr double kRpm = 2 * 3.141592653589793 / 60;  // [rad/s]

// Spot checks, typed from the sources a second time; they must be equal, because both are printed
// digits.
TEST(StiffnessTable, ReferenceSpotChecks) {
  ASSERT_EQ(stiffness_rows().size(), 35U);
  struct Spot {
    int size;
    double ratio, T1, T2, K1, K2, K3;
  };
  for (const Spot& spot :
       {Spot{14, 30, 2.0, 6.9, 1900, 2400, 3400}, Spot{25, 50, 14, 48, 25000, 34000, 44000},
        Spot{32, 100, 29, 108, 67000, 110000, 120000},
        Spot{58, 120, 168, 598, 400000, 610000, 710000},
        Spot{90, 80, 618, 2260, 1450000, 2300000, 2630000}}) {
    const StiffnessRow* const row = find_stiffness(spot.size, spot.ratio);
    ASSERT_NE(row, nullptr) << spot.size;
    EXPECT_EQ(row->T1, spot.T1) << spot.size;
    EXPECT_EQ(row->T2, spot.T2) << spot.size;
    EXPECT_EQ(row->K1, spot.K1) << spot.size;
    EXPECT_EQ(row->K2, spot.K2) << spot.size;
    EXPECT_EQ(row->K3.value_or(0), spot.K3) << spot.size;
  }
  EXPECT_EQ(find_stiffness(8, 50)->K3, std::nullopt);
  EXPECT_EQ(find_stiffness(100, 50)->K3, std::nullopt);
  EXPECT_EQ(find_stiffness(100, 100), nullptr);
  EXPECT_EQ(std::ranges::count_if(stiffness_rows(), [](const auto& row) { return !row.K3; }), 2);
}

TEST(RatingTable, ReferenceSpotChecks) {
  ASSERT_EQ(rating_rows().size(), 36U);
  const RatingRow* const row = find_rating(25, 100);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->series, "CSG");
  EXPECT_EQ(row->rated, 87);
  EXPECT_EQ(row->average, 140);
  EXPECT_EQ(row->repeated_peak, 204);
  EXPECT_EQ(row->momentary_peak, 369);
  test::expect_relative(row->max_input_speed, 5600 * kRpm, 1e-14);  // rounding
  test::expect_relative(row->input_inertia, 0.413e-4, 1e-14);       // rounding
  EXPECT_EQ(find_rating(90, 50)->rated, 590);
  EXPECT_EQ(find_rating(90, 50)->series, "HFUC");
  EXPECT_EQ(find_rating(25, 120), nullptr);
}

TEST(StiffnessTable, BehaviourRowsAreOnceAndRise) {
  std::set<std::pair<double, RatioClass>> seen;
  for (const StiffnessRow& row : stiffness_rows()) {
    EXPECT_TRUE(seen.insert({row.size, row.ratio_class}).second) << row.size;
    EXPECT_LT(row.T1, row.T2) << row.size;
    EXPECT_LT(row.K1, row.K2) << row.size;
    if (row.K3) {
      EXPECT_LT(row.K2, *row.K3) << row.size;
    }
    EXPECT_FALSE(row.sources.empty()) << row.size;
  }
  for (const RatingRow& row : rating_rows()) {
    EXPECT_LT(row.rated, row.repeated_peak) << row.size;
    EXPECT_LT(row.repeated_peak, row.momentary_peak) << row.size;
  }
}

// Typed from the manuals a second time.
TEST(OtherSeries, ReferenceSpotChecks) {
  ASSERT_EQ(other_series_rows().size(), 8U);
  const StiffnessRow& cup = other_series_rows()[1];
  EXPECT_EQ(cup.size, 8);
  EXPECT_EQ(cup.ratios, std::vector<double>{100});
  EXPECT_EQ(cup.T2, 0.75);
  EXPECT_EQ(cup.K1, 910);
  EXPECT_EQ(cup.K2, 1000);
  EXPECT_EQ(cup.K3, 1200);
  const StiffnessRow& hat = other_series_rows()[7];
  EXPECT_EQ(hat.size, 40);
  EXPECT_EQ(hat.ratios, std::vector<double>{160});
  EXPECT_EQ(hat.form, FlexsplineForm::hat);
  EXPECT_EQ(hat.length, FlexsplineLength::flat);
  EXPECT_EQ(hat.T1, 54);
  EXPECT_EQ(hat.K1, 110000);
  EXPECT_EQ(hat.K2, std::nullopt);
}

// The row that is marked as a repeat is one of the catalogue, and no other row is.
TEST(OtherSeries, IdentityOneRowRepeatsTheCatalogue) {
  for (const StiffnessRow& row : other_series_rows()) {
    const StiffnessRow* const known = find_stiffness(static_cast<int>(row.size), row.ratios[0]);
    const bool same = known != nullptr && known->T1 == row.T1 && known->T2 == row.T2 &&
                      known->K() == row.K() && known->form == row.form;
    EXPECT_EQ(row.origin, same ? RowOrigin::repeat : RowOrigin::other_series) << row.size;
  }
}

// Every rating of 80 and more is at a ratio for which the size's stiffness row holds.
TEST(StiffnessTable, CrosscheckRatiosOfTheRatings) {
  for (const RatingRow& rating : rating_rows()) {
    const StiffnessRow* const row = find_stiffness(rating.size, rating.ratio);
    ASSERT_NE(row, nullptr) << rating.size;
    EXPECT_NE(std::ranges::find(row->ratios, rating.ratio), row->ratios.end())
        << rating.size << ' ' << rating.ratio;
  }
}

// The conventions of model/rating.hpp.  The makers' torques have two digits and their own steps: T1
// agrees within 7 % from size 17 on, T2 within 8 % from size 20 on; T2 of size 17 is a fifth lower.
TEST(StiffnessTable, ReferenceTorquesFollowTheCubeOfTheDiameter) {
  for (const StiffnessRow& row : stiffness_rows()) {
    if (row.size < 17 || row.ratio_class == RatioClass::thirty) continue;
    const double d3 = std::pow(pitch_diameter_of(row.size), 3);
    test::expect_relative(row.T1 / d3, 0.0517e6, 0.07);
    test::expect_relative(row.T2 / d3, 0.187e6, row.size == 17 ? 0.21 : 0.08);
  }
}

TEST(RatioClasses, LimitMeansOfNeighbours) {
  EXPECT_EQ(ratio_class_of(30), RatioClass::thirty);
  EXPECT_EQ(ratio_class_of(38.7), RatioClass::thirty);
  EXPECT_EQ(ratio_class_of(38.8), RatioClass::fifty);
  EXPECT_EQ(ratio_class_of(63.2), RatioClass::fifty);
  EXPECT_EQ(ratio_class_of(63.3), RatioClass::eighty_up);
  EXPECT_EQ(ratio_class_of(320), RatioClass::eighty_up);
}

// Sizes are tenths of an inch, so size 32 is 81.28 mm.  The tolerance is rounding.
TEST(Sizes, ReferencePitchDiameter) {
  test::expect_relative(pitch_diameter_of(32), 81.28e-3, 1e-14);
  EXPECT_EQ(catalogue_sizes().size(), 15U);
  EXPECT_EQ(catalogue_sizes().front(), 8);
  EXPECT_EQ(catalogue_sizes().back(), 100);
}

TEST(NearestStiffness, BehaviourClassBeforeSize) {
  EXPECT_EQ(nearest_stiffness(0.0635, 120)->size, 25);
  EXPECT_EQ(nearest_stiffness(0.0635, 120)->ratio_class, RatioClass::eighty_up);
  EXPECT_EQ(nearest_stiffness(0.16, 100)->size, 65);
  EXPECT_EQ(nearest_stiffness(1.0, 30)->size, 32);  // the largest of ratio 30
}

// The row of size 11, 80 and more, is that of a hat.
TEST(NearestStiffness, BehaviourFormAndLengthBeforeSize) {
  EXPECT_EQ(nearest_stiffness(0.028, 100)->size, 14);
  EXPECT_EQ(nearest_stiffness(0.028, 100, FlexsplineForm::hat)->size, 11);
  EXPECT_EQ(nearest_stiffness(0.0635, 100, FlexsplineForm::hat)->size, 11);
  EXPECT_EQ(nearest_stiffness(0.028, 50, FlexsplineForm::hat), nullptr);
  EXPECT_EQ(nearest_stiffness(0.0635, 100, FlexsplineForm::cup, FlexsplineLength::standard),
            nullptr);
}

TEST(CatalogueInput, InputRefusals) {
  const std::string unknown = broken_rule([] { return catalogue_rows({.size = 22, .ratio = {}}); });
  EXPECT_NE(unknown.find("22 is not a size"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("8, 11, 14"), std::string::npos) << unknown;
  EXPECT_NE(broken_rule([] { return catalogue_rows({.size = {}, .ratio = 0.0}); }).find("> 0"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return catalogue_rows({.size = 100, .ratio = 30}); }).find("no row"),
            std::string::npos);
  EXPECT_NE(broken_rule([] { return nearest_stiffness(-1, 100); }).find("> 0"), std::string::npos);
  EXPECT_NE(broken_rule([] { return nearest_stiffness(1, 0); }).find("> 0"), std::string::npos);
}

TEST(CatalogueOutput, BehaviourFormatsAgree) {
  const CatalogueRows one = catalogue_rows({.size = 25, .ratio = 100});
  const auto json = nlohmann::json::parse(json_of(one));
  EXPECT_EQ(json["stiffness"]["K3"]["values"], nlohmann::json({57000}));
  EXPECT_EQ(json["ratings"]["rated"]["values"], nlohmann::json({87}));
  const auto small = nlohmann::json::parse(json_of(catalogue_rows({.size = 8, .ratio = 50})));
  EXPECT_TRUE(small["stiffness"]["K3"]["values"][0].is_null());
  const std::string csv = catalogue_csv(catalogue_rows());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 35 + 8);
  EXPECT_NE(csv.find("25,80+,14,48,31000,50000,57000,B+C,CSF/CSG/HFUC,cup,short,catalogue,80 100 "
                     "120 160\n"),
            std::string::npos);
  // Rows of other series state their ratio, so a ratio selects them exactly.
  EXPECT_EQ(catalogue_rows({.size = 20, .ratio = 160}).stiffness.size(), 2U);
  EXPECT_EQ(catalogue_rows({.size = 20, .ratio = 120}).stiffness.size(), 1U);
  const std::string text = catalogue_text(one);
  EXPECT_NE(text.find("80+"), std::string::npos);
  EXPECT_NE(text.find("87"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
