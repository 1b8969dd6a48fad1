// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/compliance_table_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/gear_writer.hpp"

namespace strainwave {
namespace {

TableHead shaft_head() {
  TableHead head;
  head.kind = "annular";
  head.crack = "output_shaft.crack[0]";
  head.program = "a test";
  head.input = "shaft.toml";
  head.digest = "0123";
  head.order = 6;
  head.equations = "FE-8";
  head.held = "alone";
  head.ranges = {{{"depth", "m", 0.0},
                  {.path = "output_shaft.crack[0].depth",
                   .from = 1e-3,
                   .to = 8e-3,
                   .n_points = 4,
                   .spacing = Spacing::logarithmic}}};
  head.fixed = {{"outer_diameter", "m", 0.06},
                {"inner_diameter", "m", 0.0},
                {"length", "m", 0.24},
                {"youngs_modulus", "Pa", 210e9},
                {"poissons_ratio", "1", 0.3}};
  head.columns = {{"added_compliance_torsion", "rad/(N*m)"}, {"added_compliance_tension", "m/N"}};
  return head;
}

TablePoint row_at(double depth) {
  return {.at = {depth},
          .values = {1e-4 * depth * depth, 1e-6 * depth * depth},
          .relative_error = 1e-4 + depth * 0.01,
          .usable = true,
          .unknowns = 5592,
          .seconds = 2.25,
          .reason = {}};
}

std::string shaft_table() {
  std::string text = table_head_text(shaft_head());
  for (const double depth : {1e-3, 2e-3, 4e-3, 8e-3}) text += table_row_text(row_at(depth));
  return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ComplianceTableFile, IdentityWrittenAndRead) {
  const TableFile file = parse_table_file(shaft_table(), "t.csv");
  EXPECT_EQ(file.head, table_head_text(shaft_head()));
  EXPECT_FALSE(file.torn);
  EXPECT_EQ(file.whole, shaft_table().size());
  ASSERT_EQ(file.rows.size(), 4U);
  EXPECT_EQ(file.rows[2].at, row_at(4e-3).at);
  EXPECT_EQ(file.rows[2].values, row_at(4e-3).values);
  EXPECT_EQ(file.rows[2].unknowns, 5592U);
  EXPECT_EQ(file.rows[2].seconds, 2.25);
  // A reason may have commas and quotes; a point without numbers leaves them empty.
  TablePoint bad = row_at(8e-3);
  bad.usable = false;
  bad.reason = "rings, \"1 %\" apart";
  bad.values = {std::nullopt, 0.1};
  bad.relative_error.reset();
  const TableFile again =
      parse_table_file(table_head_text(shaft_head()) + table_row_text(bad), "t");
  EXPECT_EQ(again.rows.at(0).reason, bad.reason);
  EXPECT_EQ(again.rows[0].values, bad.values);
  EXPECT_FALSE(again.rows[0].relative_error);
  EXPECT_FALSE(again.rows[0].usable);

  const ComplianceTable table = parse_compliance_table(shaft_table(), "t.csv");
  EXPECT_EQ(table.kind, "annular");
  ASSERT_EQ(table.axes.size(), 1U);
  EXPECT_EQ(table.axes[0].nodes, (std::vector{1e-3, 2e-3, 4e-3, 8e-3}));
  EXPECT_TRUE(table.axes[0].logarithmic);
  EXPECT_EQ(table.positive.values, table.negative.values);
  EXPECT_EQ(table.positive.values[1], 1e-4 * 2e-3 * 2e-3);
  EXPECT_EQ(table.axial.values[3], 1e-6 * 8e-3 * 8e-3);
  EXPECT_EQ(table.point_error, 1e-4 + 8e-3 * 0.01);
  ASSERT_EQ(table.fixed.size(), 5U);
  EXPECT_EQ(table.fixed[3].unit, "Pa");
  EXPECT_EQ(table.fixed[3].value, 210e9);
  EXPECT_EQ(table.fixed[4].value, 0.3);
  EXPECT_EQ(table.made_by, "a test, order 6");
}

// The order of the points does not matter: a family may have been run from the large end.
TEST(ComplianceTableFile, IdentityPointsInAnyOrder) {
  std::string text = table_head_text(shaft_head());
  for (const double depth : {8e-3, 4e-3, 1e-3, 2e-3}) text += table_row_text(row_at(depth));
  EXPECT_EQ(parse_compliance_table(text, "t").positive.values,
            parse_compliance_table(shaft_table(), "t").positive.values);
}

// An unfinished table over one number is a table with a shorter range.
TEST(ComplianceTableFile, BehaviourUnfinishedIsShorter) {
  const std::string text = replaced(shaft_table(), "4 points", "7 points");
  EXPECT_EQ(parse_compliance_table(text, "t").axes[0].nodes.back(), 8e-3);
}

TEST(ComplianceTableFile, BehaviourTornLineIsSeen) {
  const std::string text = shaft_table();
  const TableFile file = parse_table_file(text.substr(0, text.size() - 3), "t.csv");
  EXPECT_TRUE(file.torn);
  EXPECT_EQ(file.rows.size(), 3U);
  EXPECT_EQ(text.substr(file.whole), table_row_text(row_at(8e-3)));
}

TEST(ComplianceTableFile, InputFaultsByName) {
  const auto refused = [](const std::string& text, const std::string& words) {
    try {
      (void)parse_compliance_table(text, "t.csv");
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const std::string good = shaft_table();
  const std::string last = table_row_text(row_at(8e-3));
  refused("", "t.csv:1: must begin with");
  refused(replaced(good, "table/1", "table/2"), "must begin with");
  refused(replaced(good, "# over: ", "# past: "), "no line \"# over: ...\"");
  refused(good.substr(0, good.find("depth [m],")), "ends before the names of the columns");
  refused(replaced(good, "# kind: annular\n", ""), "one line \"# kind: ...\"");
  refused(replaced(good, "# order: 6\n", "# order: 6\n# order: 5\n"), "one line \"# order: ...\"");
  refused(replaced(good, "length = 0.24 m", "length: 0.24 m"), "must be NAME = VALUE");
  refused(replaced(good, "\ndepth [m],", "\ndepth,"), "must be a name and a unit in brackets");
  refused(replaced(good, "added_compliance_torsion", "added_compliance_twist"), "has no column");
  refused(good.substr(0, good.size() - 3), "ends within a line");
  refused(replaced(good, last, ""), "has 3 values of depth; interpolation needs 4");
  refused(good + last, "point 5 appears twice; remove one of them");
  refused(
      replaced(good, last, "0.008,1,2,3\n"),
      "t.csv:20: has 4 cells, but the head names 8 columns; separate cells by commas, and write "
      "numbers with a decimal point");
  refused(replaced(good, last, "0,008" + last.substr(5)),
          "t.csv:20: has 9 cells, but the head names 8 columns");
  refused(replaced(good, "true,5592", "yes,5592"), "\"yes\" is not true or false");
  refused(replaced(good, "true,5592", "true,many"), "\"many\" is not a number");
  refused(replaced(good, "true,5592,2.25,", "false,5592,2.25,\"closed\""),
          "point 1 is not usable: closed");
  TablePoint empty = row_at(8e-3);
  empty.values[0].reset();
  refused(replaced(good, last, table_row_text(empty)), "point 4 has no added_compliance_torsion");
  TablePoint zero = row_at(0.0);
  refused(replaced(good, last, table_row_text(zero)), "depth must be > 0 on a logarithmic axis");
  // Two axes: a grid with a hole.
  TableHead two = shaft_head();
  two.ranges.push_back({{"length", "m", 0.0}, {.path = "x", .from = 1, .to = 2, .n_points = 4}});
  std::string holes = table_head_text(two);
  for (int i = 0; i < 4; ++i) {
    TablePoint row = row_at(1e-3 * (i + 1));
    row.at.push_back(0.1 * (i + 1));
    holes += table_row_text(row);
  }
  refused(holes, "has 4 of 16 points");
}

// A drive with a table from a folder is read, written and read again.
class TableFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("strainwave tables " + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_ / "tables");
    std::ofstream(folder_ / "tables/shaft.csv") << shaft_table();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] GearSet read(const std::string& table) const {
    return read_gear_set(
        "format = \"strainwave-drive/1\"\n"
        "[material.steel]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\n"
        "[drive]\nratio = 100\npitch_diameter = \"160 mm\"\nradial_displacement = \"0.8 mm\"\n"
        "[load]\ntorque = \"100 N*m\"\n"
        "[output_shaft]\nmaterial = \"steel\"\nouter_diameter = \"60 mm\"\nlength = \"240 mm\"\n"
        "[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"3 mm\"\ncompliance_table = \"" +
            table + "\"\n",
        (folder_ / "shaft.toml").string(), attachments_beside(folder_ / "shaft.toml"));
  }

  std::filesystem::path folder_;
};

TEST_F(TableFolder, BehaviourReadBesideTheDriveOrAttached) {
  const GearSet gear = read("tables/shaft.csv");
  ASSERT_EQ(gear.compliance_tables.size(), 1U);
  EXPECT_EQ(gear.compliance_tables.begin()->first, "tables/shaft.csv");
  const std::string text = gear_text(gear);
  EXPECT_NE(text.find("compliance_table = \"tables/shaft.csv\"\n"), std::string::npos) << text;
  const GearSet again =
      read_gear_set(text, "again", Attachments({{"tables/shaft.csv", shaft_table()}}));
  EXPECT_EQ(gear_text(again), text);
  EXPECT_EQ(again.compliance_tables.at("tables/shaft.csv").positive.values,
            gear.compliance_tables.at("tables/shaft.csv").positive.values);
}

TEST_F(TableFolder, InputFaultsNameTheCrack) {
  const auto refused = [&](const std::string& table, const std::string& words) {
    try {
      (void)read(table);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("output_shaft.crack[0].compliance_table"), std::string::npos) << what;
      EXPECT_NE(what.find(words), std::string::npos) << what;
      EXPECT_NE(what.find("shaft.toml:"), std::string::npos) << what;  // followed by its line
    }
  };
  refused("shaft.csv", "\"shaft.csv\" is not a file beside the input");
  refused("tables", "\"tables\" is not a file beside the input");
  std::ofstream(folder_ / "half.csv") << shaft_table().substr(0, shaft_table().size() - 9);
  refused("half.csv", "half.csv: ends within a line");
  std::ofstream(folder_ / "large.csv") << std::string(kMaxTextSize + 1, '#');
  refused("large.csv", "is larger than 1 MiB");
  std::ofstream(folder_ / "other.csv") << replaced(shaft_table(), "0.06 m", "0.07 m");
  refused("other.csv", "was made with outer_diameter = 70 mm, but the drive has 60 mm");
}

}  // namespace
}  // namespace strainwave
