// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/shown_text.hpp"

#include <gtest/gtest.h>

namespace strainwave {
namespace {

TEST(ShownQuantity, BehaviourUnitsOfPeople) {
  EXPECT_EQ(shown_quantity(-0.0, "N*m", 4), "0 N*m");
  EXPECT_EQ(shown_quantity(196e9, "Pa", 4), "196 GPa");
  EXPECT_EQ(shown_quantity(1e10, "Pa"), "10 GPa");
  EXPECT_EQ(shown_quantity(2241e6, "Pa"), "2241 MPa");
  EXPECT_EQ(shown_quantity(54.94e6, "Pa*m^0.5"), "54.94 MPa*m^0.5");
  EXPECT_EQ(shown_quantity(1.25e-3, "m", 2), "1.2 mm");
  EXPECT_EQ(shown_quantity(0.272, "1"), "0.272");
  EXPECT_EQ(shown_quantity(-0.012, "1", 5, "cracked.positive.stiffness_change"), "-1.2 %");
}

TEST(Percent, BehaviourDigitsAndSigns) {
  EXPECT_EQ(percent(0.05), "5 %");
  EXPECT_EQ(percent(0.03456), "3.5 %");
  EXPECT_EQ(percent(0.03456, 3), "3.46 %");
  EXPECT_EQ(percent(0.996), "100 %");
  EXPECT_EQ(percent(2.0249), "202 %");
  EXPECT_EQ(percent(-0.0), "0 %");
  EXPECT_EQ(percent(-0.5), "-50 %");
  EXPECT_EQ(percent_change(-0.01234), "-1.23 %");
  EXPECT_EQ(percent_change(1.176), "+118 %");
  EXPECT_EQ(percent_change(-1e-12), "0 %");
  // Values too large for per cent.
  EXPECT_EQ(percent(99.9), "9990 %");
  EXPECT_EQ(percent(123.4), "123 times");
  EXPECT_EQ(percent_change(99.0), "+9900 %");
  EXPECT_EQ(percent_change(990476189.47), "9.9e+08 times as much");
}

TEST(WarrantedDigits, BehaviourTwoMoreThanTheUncertainty) {
  EXPECT_EQ(warranted_digits({123456.7, "1", 0.05}), "1.235e+05");
  EXPECT_EQ(warranted_digits({123.4567, "1", 0.2}), "123");
  EXPECT_EQ(warranted_digits({123.4567, "1", {}}), "123.457");
  EXPECT_EQ(accuracy_text({1.0, "1", 0.15}), "15 %");
  EXPECT_EQ(accuracy_text({0.0, "1", 0.15}), "-");
  EXPECT_EQ(accuracy_text({1.0, "1", {}}), "none");
}

TEST(Paragraph, BehaviourHangsAndBreaksAtBlanks) {
  const std::string text = paragraph(std::string(60, 'a') + ' ' + std::string(60, 'b'), 2);
  EXPECT_EQ(text, "  " + std::string(60, 'a') + "\n    " + std::string(60, 'b') + '\n');
  EXPECT_EQ(wrapped("a b c", 3, 1), "a b\n c");
}

TEST(TypesetUnit, BehaviourPointsAndRoots) {
  EXPECT_EQ(typeset_unit("N*m/arcmin"), "N·m/arcmin");
  EXPECT_EQ(typeset_unit("MPa*m^0.5"), "MPa·√m");
  EXPECT_EQ(typeset_unit("1"), "");
}

}  // namespace
}  // namespace strainwave
