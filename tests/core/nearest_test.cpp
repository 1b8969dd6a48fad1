// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/nearest.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace strainwave {
namespace {

const std::vector<std::string> kFields = {"outer_diameter", "inner_diameter", "length", "material",
                                          "crack"};

TEST(NearestWord, BehaviourAKnownWordIsNearestToItself) {
  for (const std::string& word : kFields) EXPECT_EQ(nearest_word(word, kFields), word);
}

TEST(NearestWord, BehaviourMisspellingsFindTheirWord) {
  EXPECT_EQ(nearest_word("crak", kFields), "crack");      // a letter lost
  EXPECT_EQ(nearest_word("lenghth", kFields), "length");  // a letter too many
  EXPECT_EQ(nearest_word("lenght", kFields), "length");   // two swapped
  EXPECT_EQ(nearest_word("Length", kFields), "length");   // a capital
  EXPECT_EQ(nearest_word("outer-diameter", kFields), "outer_diameter");
  EXPECT_EQ(nearest_word("outerDiameter", kFields), "outer_diameter");
  EXPECT_EQ(nearest_word("out_diameter", kFields), "outer_diameter");
  EXPECT_EQ(nearest_word("iner_diameter", kFields), "inner_diameter");
  EXPECT_EQ(nearest_word("materials", kFields), "material");
}

TEST(NearestWord, BehaviourNothingIsNearAStranger) {
  EXPECT_EQ(nearest_word("temperature", kFields), "");
  EXPECT_EQ(nearest_word("youngs_modulus", kFields), "");
  EXPECT_EQ(nearest_word("", kFields), "");
  EXPECT_EQ(nearest_word("crack", {}), "");
}

TEST(NearestWord, BehaviourTheFirstOfEquallyNearWordsIsNamed) {
  EXPECT_EQ(nearest_word("cup", std::vector<std::string>{"cap", "cut"}), "cap");
  EXPECT_EQ(nearest_word("cup", std::vector<std::string>{"cut", "cap"}), "cut");
}

TEST(NearestWord, LimitOneThirdOfTheLettersMayDiffer) {
  const std::vector<std::string> known = {"abcdefghi"};
  EXPECT_EQ(nearest_word("abcdefzzz", known), "abcdefghi");  // 3 of 9
  EXPECT_EQ(nearest_word("abcdezzzz", known), "");           // 4 of 9
  // two letters may always differ, because otherwise a short word could not be corrected
  EXPECT_EQ(nearest_word("cpu", std::vector<std::string>{"cup"}), "cup");
  EXPECT_EQ(nearest_word("cap", std::vector<std::string>{"edge"}), "");
}

TEST(NearestWord, LimitHostileLengthsResembleNothing) {
  EXPECT_EQ(nearest_word(std::string(200, 'x'), std::vector<std::string>{std::string(200, 'x')}),
            std::string(200, 'x'));
  EXPECT_EQ(nearest_word(std::string(201, 'x'), std::vector<std::string>{std::string(201, 'x')}),
            "");
  EXPECT_EQ(nearest_word(std::string(1'000'000, 'x'), kFields), "");
}

TEST(WordsBeginning, ReferenceCaseDoesNotCount) {
  const std::vector<std::string> known = {"4340 tempered 425 C", "C300", "42CrMo4 QT"};
  EXPECT_EQ(words_beginning("4340", known), std::vector<std::string>{"4340 tempered 425 C"});
  EXPECT_EQ(words_beginning("42crmo", known), std::vector<std::string>{"42CrMo4 QT"});
  EXPECT_TRUE(words_beginning("4340 tempered 425 C hard", known).empty());
  EXPECT_TRUE(words_beginning("", known).empty());
}

}  // namespace
}  // namespace strainwave
