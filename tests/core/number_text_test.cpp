// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/number_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include "decimal_value.hpp"

namespace strainwave {
namespace {

TEST(NumberText, ReferenceLengthOfTheNumberAtTheBeginning) {
  struct Case {
    std::string_view text;
    std::size_t length;
  };
  for (const auto& [text, length] : {Case{"12.5 kN*m", 4},
                                     {"-1.5e3 mm", 6},
                                     {".5)", 2},
                                     {"5.", 2},
                                     {"1e", 1},
                                     {"1e+", 1},
                                     {"1E-3x", 4},
                                     {"0x10", 1},
                                     {"007", 3},
                                     {"", 0},
                                     {"-", 0},
                                     {".", 0},
                                     {"-.e5", 0},
                                     {"+1", 0},
                                     {" 1", 0},
                                     {"nan", 0},
                                     {"inf", 0},
                                     {"e5", 0}})
    EXPECT_EQ(number_length(text), length) << text;
}

TEST(NumberText, InputOnlyWholeNumbersWithinRange) {
  for (const std::string_view text : {"", " 1", "1 ", "+1", "1,5", "1mm", "nan", "-inf", "0x1p3",
                                      "1e999", "-1e999", "1e-400", "1e99999999999999999999"})
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  EXPECT_EQ(parse_number("0e999"), 0.0);
  EXPECT_EQ(parse_number("4.9e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number("1.7976931348623159e308"), std::nullopt);
}

void expect_both(const std::string& text, std::optional<double> value) {
  EXPECT_EQ(parse_number(text), value) << text;
  EXPECT_EQ(value_by_stream(text), value) << text;
#ifdef __cpp_lib_to_chars
  EXPECT_EQ(value_by_from_chars(text), value) << text;
#endif
}

TEST(NumberText, IdentityTheShortestTextOfAnyDoubleReadsBack) {
  std::mt19937_64 random(20261122);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    expect_both(fmt::format("{}", value), value);
    expect_both(fmt::format("{:.40e}", value), value);
  }
}

TEST(NumberText, CrosscheckTheStreamRoundsAsFromCharsDoes) {
  // A number halfway between two doubles rounds to even; one digit less rounds down, one digit more
  // rounds up.
  expect_both("9007199254740993", 9007199254740992.0);
  expect_both("9007199254740992.9999999999999999999", 9007199254740992.0);
  expect_both("9007199254740993.0000000000000000001", 9007199254740994.0);
  expect_both("2.2250738585072011e-308", 2.2250738585072011e-308);
  expect_both("2.4703282292062328e-324", std::numeric_limits<double>::denorm_min());
  expect_both("1e-400", std::nullopt);
  expect_both("1e400", std::nullopt);
  expect_both("-0", -0.0);
}

TEST(NumberText, BehaviourTheLocaleDoesNotMatter) {
  struct CommaPoint : std::numpunct<char> {
    [[nodiscard]] char do_decimal_point() const override { return ','; }
    [[nodiscard]] std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
  expect_both("1234.5", 1234.5);
  std::locale::global(before);
}

}  // namespace
}  // namespace strainwave
