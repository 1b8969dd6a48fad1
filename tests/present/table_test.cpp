// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/table.hpp"

#include <gtest/gtest.h>

namespace strainwave {
namespace {

Table sample() {
  return {.head = {"name", "K", "why"},
          .align = "lrl",
          .rows = {{"a", "1", "x, \"y\""}, {"a line across both"}, {"long one", "12.5"}}};
}

TEST(Table, BehaviourTextHasAlignedColumns) {
  EXPECT_EQ(text_table(sample()),
            "  name         K  why\n"
            "  a            1  x, \"y\"\n"
            "  a line across both\n"
            "  long one  12.5\n");
  EXPECT_EQ(text_table({.head = {"", ""}, .rows = {{"a", "b"}}}), "  a  b\n");
}

TEST(Table, BehaviourMarkdownEscapesBars) {
  EXPECT_EQ(markdown_table({.head = {"", "b"}, .rows = {{"x|y"}}}),
            "|  | b |\n|---|---|\n| x\\|y |  |\n");
}

TEST(Table, BehaviourCsvQuotesAndFillsUp) {
  EXPECT_EQ(csv_table(sample()),
            "name,K,why\na,1,\"x, \"\"y\"\"\"\na line across both,,\nlong one,12.5,\n");
}

// Remarks above the head stay, whatever becomes of the columns.
TEST(Table, BehaviourRemarksAboveACsvTable) {
  const std::string csv = "# a, \"remark\n# b\nlength [m],what\n0.5,x\n";
  EXPECT_EQ(csv_in_units(csv, AskedUnits("mm")), "# a, \"remark\n# b\nlength [mm],what\n500,x\n");
  EXPECT_EQ(csv_columns(csv, {"what"}), "# a, \"remark\n# b\nwhat\nx\n");
  EXPECT_EQ(csv_columns("what\nx\n", {"what"}), "what\nx\n");
}

TEST(Cells, BehaviourAllDigitsAndNothingForWhatIsAbsent) {
  EXPECT_EQ(cells(0.1, 3, std::optional<double>(), true, "text"),
            (std::vector<std::string>{"0.1", "3", "", "true", "text"}));
}

}  // namespace
}  // namespace strainwave
