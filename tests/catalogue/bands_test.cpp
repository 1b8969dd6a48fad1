// SPDX-License-Identifier: Apache-2.0
#include "bands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "support/expect.hpp"

namespace strainwave {
namespace {

StiffnessRow row_of_class(double size, RatioClass ratio) {
  StiffnessRow row;
  row.size = size;
  row.ratio_class = ratio;
  return row;
}

std::vector<const DrawnValue*> pointers(const std::vector<DrawnValue>& values) {
  std::vector<const DrawnValue*> all;
  for (const DrawnValue& value : values) all.push_back(&value);
  return all;
}

// Two classes with errors of 0.3, 0.5 and -0.1, 0.1 and draws of variance 0.01, by hand (CV-3):
// between 0.08, within 0.04/2, Student's 95 % quantile for two degrees of freedom 2.919986.  Size
// 40 and size 25 belong to one class.
TEST(BandFit, ReferenceTwoClassesByHand) {
  const StiffnessRow small = row_of_class(8, RatioClass::thirty);
  const StiffnessRow large = row_of_class(25, RatioClass::fifty);
  const StiffnessRow larger = row_of_class(40, RatioClass::fifty);
  const std::vector<double> drawn = {-0.1, 0.1};
  const std::vector<DrawnValue> values = {
      {&small, 0.3, drawn}, {&small, 0.5, drawn}, {&large, -0.1, drawn}, {&larger, 0.1, drawn}};
  const BandFit fit = fit_band(pointers(values));
  EXPECT_EQ(fit.classes, 2);
  EXPECT_EQ(fit.values, 4);
  test::expect_relative(fit.between, std::sqrt(0.08), 1e-12);
  test::expect_relative(fit.within, std::sqrt(0.02), 1e-12);
  test::expect_relative(fit.draws, 0.1, 1e-12);
  test::expect_relative(fit.discrepancy, 0.5523969, 1e-6);  // digits of the quantiles
}

// Three classes with errors of 0.2, 0.4, of 0.0, 0.2, 0.4 and of -0.3, and draws of the variances
// 0.01, 0.01 and 0.04, by hand (CV-3): between (0.09 + 0.04 + 0.09)/3, within (0.02 + 0.08)/(6 -
// 3), draws 0.06/3.  Student's 95 % quantile for three degrees of freedom is 2.353363.  Equal sizes
// of other ratios are other classes, and a class counts once however many values it has.
TEST(BandFit, ReferenceThreeClassesByHand) {
  const StiffnessRow a = row_of_class(8, RatioClass::fifty);
  const StiffnessRow b = row_of_class(25, RatioClass::fifty);
  const StiffnessRow c = row_of_class(25, RatioClass::eighty_up);
  const std::vector<double> drawn = {-0.1, 0.1};
  const std::vector<double> wide = {-0.2, 0.2};
  const std::vector<DrawnValue> values = {{&a, 0.2, drawn}, {&b, 0.0, drawn}, {&c, -0.3, wide},
                                          {&b, 0.4, drawn}, {&a, 0.4, drawn}, {&b, 0.2, drawn}};
  const BandFit fit = fit_band(pointers(values));
  EXPECT_EQ(fit.classes, 3);
  EXPECT_EQ(fit.values, 6);
  test::expect_relative(fit.between, std::sqrt(0.22 / 3), 1e-12);
  test::expect_relative(fit.within, std::sqrt(0.1 / 3), 1e-12);
  test::expect_relative(fit.draws, std::sqrt(0.02), 1e-12);
  test::expect_relative(fit.discrepancy,
                        std::sqrt(std::pow(2.353363 / 1.644854, 2) * (0.22 / 3 + 0.1 / 3) - 0.02),
                        1e-6);
}

// If the draws cover the errors, the band is that of the draws.
TEST(BandFit, LimitDrawsCoverTheErrors) {
  const StiffnessRow row = row_of_class(25, RatioClass::fifty);
  const std::vector<double> drawn = {-0.5, -0.2, 0.0, 0.2, 0.5};
  const std::vector<DrawnValue> values = {{&row, 0.01, drawn}};
  const BandFit fit = fit_band(pointers(values));
  EXPECT_EQ(fit.discrepancy, 0);
  EXPECT_EQ(band_quantile(drawn, 0, 0.5), 0.0);
  EXPECT_EQ(band_quantile(drawn, 0, 0.25), -0.2);
}

// One draw has the quantiles of the normal distribution; the tolerance is their digits.
TEST(BandQuantile, LimitOneDraw) {
  test::expect_relative(band_quantile(std::vector{2.0}, 0.1, 0.95), 2 + 0.1 * 1.644854, 1e-6);
  test::expect_relative(band_quantile(std::vector{2.0}, 0.1, 0.05), 2 - 0.1 * 1.644854, 1e-6);
  // Two draws far apart: the median of the upper half is its own.
  test::expect_relative(band_quantile(std::vector{0.0, 9.0}, 0.1, 0.75), 9.0, 1e-9);
}

// The bands of a class left out do not read its values.
TEST(BandTests, IdentityAClassLeftOutIsNotRead) {
  const StiffnessRow a = row_of_class(8, RatioClass::fifty);
  const StiffnessRow b = row_of_class(25, RatioClass::fifty);
  const StiffnessRow c = row_of_class(25, RatioClass::eighty_up);
  const std::vector<double> drawn = {-0.05, 0.0, 0.05};
  std::vector<DrawnValue> values = {{&a, 0.2, drawn}, {&b, 0.05, drawn}, {&c, -0.1, drawn}};
  const auto tested = [&] { return band_tests(values, fit_band(pointers(values))); };
  const std::vector<BandTest> before = tested();
  values[0].stated = 3;
  const std::vector<BandTest> after = tested();
  ASSERT_EQ(before.size(), 2U + 1U + 2U + 1U);
  EXPECT_EQ(before[0].of, "size 8");
  EXPECT_EQ(before[1].of, "size 17 and more");
  EXPECT_EQ(before[2].of, "each class of size");
  EXPECT_EQ(before[3].of, "ratio 50");
  EXPECT_EQ(before[0].discrepancy, after[0].discrepancy);
  EXPECT_NE(before[1].discrepancy, after[1].discrepancy);
  EXPECT_EQ(before[0].left_out, 1);
  EXPECT_EQ(after[0].left_out, 0);
  EXPECT_EQ(before[2].values, 3);
  EXPECT_EQ(before[2].left_out, before[0].left_out + before[1].left_out);
  EXPECT_FALSE(before[2].discrepancy.has_value());
}

// Invented classes whose errors are normal: 90 % bands from seven classes hold 90 % of the values
// of an eighth.  The tolerance is three standard errors of 600 classes, and 1 % for the form of
// (CV-3).
TEST(BandTests, ConvergenceInventedClasses) {
  std::mt19937_64 generator(42);
  const auto normal = [&](double deviation) {
    const double u = (static_cast<double>(generator() >> 11U) + 0.5) * 0x1p-53;
    const double v = static_cast<double>(generator() >> 11U) * 0x1p-53;
    return deviation * std::sqrt(-2 * std::log(u)) * std::cos(2 * 3.14159265358979 * v);
  };
  const std::vector<double> sizes = {8, 11, 14, 25};
  std::vector<double> drawn;
  for (int n = 0; n < 40; ++n) drawn.push_back(normal(0.1));
  double held = 0;
  double values_left_out = 0;
  for (int trial = 0; trial < 75; ++trial) {
    std::vector<StiffnessRow> rows;
    for (const double size : sizes)
      for (const RatioClass ratio : {RatioClass::fifty, RatioClass::eighty_up})
        rows.push_back(row_of_class(size, ratio));
    std::vector<DrawnValue> values;
    for (const StiffnessRow& row : rows) {
      const double error = normal(0.25);
      for (int k = 0; k < 3; ++k) values.push_back({&row, error + normal(0.1), drawn});
    }
    for (const StiffnessRow& row : rows) {
      std::vector<const DrawnValue*> others;
      for (const DrawnValue& value : values)
        if (value.row != &row) others.push_back(&value);
      const double discrepancy = fit_band(others).discrepancy;
      const double low = band_quantile(drawn, discrepancy, 0.05);
      const double high = band_quantile(drawn, discrepancy, 0.95);
      for (const DrawnValue& value : values)
        if (value.row == &row) {
          held += value.stated >= low && value.stated <= high;
          ++values_left_out;
        }
    }
  }
  EXPECT_NEAR(held / values_left_out, 0.90, 3 * std::sqrt(0.9 * 0.1 / 600) + 0.01);
}

}  // namespace
}  // namespace strainwave
