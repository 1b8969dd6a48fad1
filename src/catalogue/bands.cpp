// SPDX-License-Identifier: Apache-2.0
#include "bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "strainwave/core/quantile.hpp"
#include "strainwave/core/roots.hpp"

namespace strainwave {
namespace {

constexpr double kLow = 0.05;
constexpr double kHigh = 0.95;

/// Similar sizes form one class.
double size_class(const StiffnessRow& row) { return std::min(row.size, kLeastSimilarSize); }
double ratio_class(const StiffnessRow& row) { return static_cast<double>(row.ratio_class); }

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double variance(std::span<const double> values) {
  const double middle = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return sum / static_cast<double>(values.size());
}

/// Share of all draws with their discrepancy below a value.
double share_below(std::span<const double> drawn, double discrepancy, double value) {
  double sum = 0.0;
  for (const double one : drawn)
    sum += discrepancy > 0
               ? std::erfc((one - value) / (discrepancy * std::numbers::sqrt2)) / 2
               : static_cast<double>(one < value) + static_cast<double>(one == value) / 2;
  return sum / static_cast<double>(drawn.size());
}

bool inside(const DrawnValue& value, double discrepancy) {
  const double share = share_below(value.drawn, discrepancy, value.stated);
  return share >= kLow && share <= kHigh;
}

}  // namespace

bool makes_bands(const StiffnessRow& row) {
  return row.origin == RowOrigin::catalogue && row.form == FlexsplineForm::cup &&
         row.length == FlexsplineLength::short_length;
}

BandFit fit_band(std::span<const DrawnValue* const> values) {
  std::map<std::pair<double, double>, std::vector<const DrawnValue*>> classes;
  for (const DrawnValue* value : values)
    classes[{size_class(*value->row), ratio_class(*value->row)}].push_back(value);
  const auto n = static_cast<double>(classes.size());
  double between = 0.0;
  double within = 0.0;
  double draws = 0.0;
  for (const auto& of_class : classes) {
    std::vector<double> errors;
    std::vector<double> spreads;
    for (const DrawnValue* value : of_class.second) {
      errors.push_back(value->stated - mean(value->drawn));
      spreads.push_back(variance(value->drawn));
    }
    between += mean(errors) * mean(errors) / n;
    within += variance(errors) * static_cast<double>(errors.size());
    draws += mean(spreads) / n;
  }
  const double freedom = static_cast<double>(values.size()) - n;
  within = freedom > 0 ? within / freedom : 0.0;
  const double widened = boost::math::quantile(boost::math::students_t(n), kHigh) /
                         boost::math::quantile(boost::math::normal(), kHigh);  // (CV-3)
  const double more = widened * widened * (between + within) - draws;
  return {.classes = static_cast<int>(classes.size()),
          .values = static_cast<int>(values.size()),
          .between = std::sqrt(between),
          .within = std::sqrt(within),
          .draws = std::sqrt(draws),
          .discrepancy = std::sqrt(std::max(0.0, more))};
}

double band_quantile(std::span<const double> drawn, double discrepancy, double p) {
  if (!(discrepancy > 0)) {
    std::vector<double> sorted(drawn.begin(), drawn.end());
    return quantile(sorted, p);
  }
  const auto [least, most] = std::ranges::minmax(drawn);
  constexpr double kFar = 8;  // beyond, the normal distribution is 0 or 1
  return bracketed_root([&](double value) { return share_below(drawn, discrepancy, value) - p; },
                        least - kFar * discrepancy, most + kFar * discrepancy);
}

std::vector<BandTest> band_tests(std::span<const DrawnValue> values, const BandFit& fit) {
  std::vector<BandTest> tests;
  const auto test_each = [&](double (*class_of)(const StiffnessRow&), const std::string& whole,
                             const auto& name_of) {
    std::set<double> classes;
    for (const DrawnValue& value : values) classes.insert(class_of(*value.row));
    if (classes.size() < 2) return;
    BandTest sum{.of = whole};
    for (const double one : classes) {
      std::vector<const DrawnValue*> others;
      for (const DrawnValue& value : values)
        if (class_of(*value.row) != one) others.push_back(&value);
      const double discrepancy = fit_band(others).discrepancy;
      BandTest test{.of = name_of(one), .discrepancy = discrepancy};
      for (const DrawnValue& value : values) {
        if (class_of(*value.row) != one) continue;
        ++test.values;
        test.in_band += static_cast<int>(inside(value, fit.discrepancy));
        test.left_out += static_cast<int>(inside(value, discrepancy));
      }
      sum.values += test.values;
      sum.in_band += test.in_band;
      sum.left_out += test.left_out;
      tests.push_back(std::move(test));
    }
    tests.push_back(std::move(sum));
  };
  test_each(size_class, "each class of size", [](double size) {
    return fmt::format("size {:g}{}", size, size == kLeastSimilarSize ? " and more" : "");
  });
  test_each(ratio_class, "each class of ratio", [](double ratio) {
    return fmt::format("ratio {}", enum_name(static_cast<RatioClass>(static_cast<int>(ratio))));
  });
  return tests;
}

}  // namespace strainwave
