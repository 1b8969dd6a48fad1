// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/error.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include "support/not_finite.hpp"

namespace strainwave {
namespace {

using test::kInfinity;
using test::kNaN;

static_assert(std::is_base_of_v<std::runtime_error, Error>);
static_assert(std::is_base_of_v<Error, InputError>);
static_assert(std::is_base_of_v<Error, SolverError>);
static_assert(!std::is_base_of_v<InputError, SolverError>);

TEST(Error, InputBrokenRuleIsOneSentence) {
  const InputError error("output_shaft.crack[0].depth", 0.01, "m", "depth < wall");
  EXPECT_STREQ(error.what(), "output_shaft.crack[0].depth = 0.01 m violates: depth < wall");
  EXPECT_EQ(error.field(), "output_shaft.crack[0].depth");
  EXPECT_EQ(error.rule(), "depth < wall");
}

TEST(Error, InputPureNumbersShowNoUnit) {
  EXPECT_STREQ(InputError("drive.ratio", -1, "1", "> 0").what(), "drive.ratio = -1 violates: > 0");
  EXPECT_STREQ(InputError("drive.ratio", -1, "", "> 0").what(), "drive.ratio = -1 violates: > 0");
}

TEST(Error, InputValuesShowNineDigits) {
  EXPECT_STREQ(InputError("x", 1.0 / 3, "m", "> 1").what(), "x = 0.333333333 m violates: > 1");
  EXPECT_STREQ(InputError("x", kNaN, "m", "> 1").what(), "x = nan m violates: > 1");
  EXPECT_STREQ(InputError("x", -kInfinity, "m", "> 1").what(), "x = -inf m violates: > 1");
}

TEST(Error, InputOtherFaultsHaveNoRule) {
  const InputError error("flexspline.material", "must be given");
  EXPECT_STREQ(error.what(), "flexspline.material: must be given");
  EXPECT_EQ(error.field(), "flexspline.material");
  EXPECT_EQ(error.rule(), "");
}

TEST(Error, InputPlaceAndValueAsWritten) {
  const InputError broken("shaft.depth", 0.01, "m", "depth < wall");
  const InputError in_file = broken.located({"gear.toml", 3, 9}, "\"10 mm\"");
  EXPECT_STREQ(in_file.what(), "gear.toml:3:9: shaft.depth = \"10 mm\" violates: depth < wall");
  EXPECT_EQ(in_file.field(), "shaft.depth");
  EXPECT_EQ(in_file.rule(), "depth < wall");
  EXPECT_STREQ(broken.located({"gear.toml", 3, 9}, "").what(),
               "gear.toml:3:9: shaft.depth = 0.01 m violates: depth < wall");
  const InputError missing =
      InputError("shaft.depth", "must be given").located({"gear.toml", 1, 1}, "");
  EXPECT_STREQ(missing.what(), "gear.toml:1:1: shaft.depth: must be given");
  EXPECT_EQ(missing.field(), "shaft.depth");
  EXPECT_EQ(missing.rule(), "");
  // The written value is empty if no rule is broken.
  EXPECT_STREQ(InputError("shaft.depth", "must be given").located({"g", 1, 1}, "7").what(),
               "g:1:1: shaft.depth: must be given");
}

TEST(Error, InputPartsAreKeptApart) {
  const InputError broken("shaft.depth", 0.01, "m", "depth < wall");
  EXPECT_EQ(broken.value(), "0.01 m");
  EXPECT_EQ(broken.place().file, "");
  EXPECT_EQ(broken.place().line, 0U);
  const InputError in_file = broken.located({"gear.toml", 3, 9}, "\"10 mm\"");
  EXPECT_EQ(in_file.value(), "\"10 mm\"");
  EXPECT_EQ(in_file.place().file, "gear.toml");
  EXPECT_EQ(in_file.place().line, 3U);
  EXPECT_EQ(in_file.place().column, 9U);
  EXPECT_EQ(broken.located({"gear.toml", 3, 9}, "").value(), "0.01 m");
  const InputError of_line(TextPlace{.file = "table.csv", .line = 7}, "has too few columns");
  EXPECT_STREQ(of_line.what(), "table.csv:7: has too few columns");
  EXPECT_EQ(of_line.field(), "");
  EXPECT_EQ(of_line.place().line, 7U);
  EXPECT_STREQ(InputError(TextPlace{.file = "big.toml"}, "is too large").what(),
               "big.toml: is too large");
}

TEST(Error, InputRequireThrowsUnlessTheConditionHolds) {
  EXPECT_NO_THROW(require(true, "x", 1, "m", "x > 0"));
  EXPECT_THROW(require(false, "x", -1, "m", "x > 0"), InputError);
  EXPECT_THROW(require(kNaN > 0, "x", kNaN, "m", "x > 0"), InputError);
}

TEST(Error, InputMessagesStayOnOneLine) {
  const InputError error("a\nb\x1b[31m", "is\r\nnot known");
  EXPECT_STREQ(
      error.what(),
      "a\\nb\\u001B[31m: is\r\nnot known");  // the problem is our own text and is not escaped
  EXPECT_EQ(error.field(), "a\nb\x1b[31m");
  EXPECT_STREQ(InputError("a\tb", 1, "m", "> 2").what(), "a\\tb = 1 m violates: > 2");
  EXPECT_STREQ(InputError("a\tb", 1, "m", "> 2").located({"f\n", 1, 1}, "").what(),
               "f\\n:1:1: a\\tb = 1 m violates: > 2");
}

TEST(Error, BehaviourHarmlessTextIsShownUnchanged) {
  for (const std::string_view text :
       {"", "flexspline", "\"2.24 mm\"", "12 \u00B5m", "\u03B2 = 45\u00B0"})
    EXPECT_EQ(shown(text), text);
}

TEST(Error, InputForeignTextIsEscaped) {
  using std::string_view_literals::operator""sv;
  EXPECT_EQ(shown("a\0b"sv), "a\\u0000b");
  EXPECT_EQ(shown("\x7f"), "\\u007F");
  EXPECT_EQ(shown("1\r\n2\t3"), "1\\u000D\\n2\\t3");
}

TEST(Error, LimitForeignTextIsCutBetweenCharacters) {
  EXPECT_EQ(shown(std::string(200, 'x')), std::string(200, 'x'));
  EXPECT_EQ(shown(std::string(201, 'x')), std::string(200, 'x') + "...");
  EXPECT_EQ(shown("abcdef", 3), "abc...");
  EXPECT_EQ(shown("ab\u00B5def", 3), "ab\u00B5...");  // two bytes, kept together
  EXPECT_EQ(shown("ab\u20ACdef", 3), "ab\u20AC...");  // three bytes
  EXPECT_EQ(shown("ab\u20AC", 3), "ab\u20AC");
}

}  // namespace
}  // namespace strainwave
