// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/turn_table_file.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

constexpr const char* kTurnHead =
    "# a comment\n"
    "half_length [mm],torque [N*m],station,angle [deg],K_I [MPa*m^0.5],K_II [MPa*m^0.5],"
    "K_III [MPa*m^0.5]\n";

/// Two sizes, two torques, two stations, four angles and the first one again.
std::string turn_csv() {
  std::string text = kTurnHead;
  for (const char* const size : {"1", "2"})
    for (const char* const torque : {"0", "100"})
      for (const char* const station : {"-1", "1"})
        for (const char* const row : {"0,1,2,3", "45,4,5,6", "90,7,8,9", "135,-1,0,0", "180,1,2,3"})
          text += std::string(size) + "," + torque + "," + station + "," + row + "\n";
  return text;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TurnTable turn_table_from(const std::string& text) {
  HistoryFile file(pieces_of(text), "turn.csv");
  return read_turn_table(file);
}

TEST(TurnTableFile, IdentityReadsTheGrid) {
  const TurnTable table = turn_table_from(turn_csv());
  EXPECT_EQ(table.size_name, "half_length");
  EXPECT_EQ(table.sizes, (std::vector<double>{1e-3, 2e-3}));
  EXPECT_EQ(table.torques, (std::vector<double>{0, 100}));
  EXPECT_EQ(table.stations, (std::vector<double>{-1, 1}));
  EXPECT_TRUE(table.aspect_ratios.empty());
  test::expect_relative(table.angles.back(), std::numbers::pi, 1e-14);
  ASSERT_EQ(table.K.size(), 40U);
  EXPECT_EQ(table.K[6], (std::array<double, 3>{4e6, 5e6, 6e6}));
  // Other units, other order of the columns, semicolons, other columns beside.
  const TurnTable other = turn_table_from(
      "remark;K_III [Pa*m^0.5];K_II [Pa*m^0.5];K_I [Pa*m^0.5];angle [rad];station [1];"
      "torque [kN*m];depth [m]\n"
      "a;3e6;2e6;1e6;0;0;0.1;0.001\nb;0;0;0;1;0;0.1;0.001\nc;0;0;0;2;0;0.1;0.001\n"
      "d;3e6;2e6;1e6;3;0;0.1;0.001\n");
  EXPECT_EQ(other.size_name, "depth");
  EXPECT_EQ(other.torques.front(), 100);
  EXPECT_EQ(other.K.front(), (std::array<double, 3>{1e6, 2e6, 3e6}));
}

// The remarks above the names say for which drive the table is; other remarks are comments.
TEST(TurnTableFile, IdentityReadsTheConditions) {
  const TurnTable table = turn_table_from(
      "# for whom it may concern\n# for crack.kind = through\n#for flexspline.barrel.length = 17.2 "
      "mm\n" +
      turn_csv() + "# for crack.angle = 45 deg\n");
  ASSERT_EQ(table.conditions.size(), 2U);
  EXPECT_EQ(table.conditions[0].name, "crack.kind");
  EXPECT_EQ(table.conditions[0].text, "through");
  EXPECT_EQ(table.conditions[1].name, "flexspline.barrel.length");
  EXPECT_EQ(table.conditions[1].text, "17.2 mm");
  EXPECT_TRUE(turn_table_from(turn_csv()).conditions.empty());
}

TEST(TurnTableFile, InputRulesBrokenOnce) {
  const auto refused = [](const std::string& text, const std::string& words) {
    try {
      (void)turn_table_from(text);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const std::string good = turn_csv();
  refused("", "turn.csv: is empty");
  refused(kTurnHead, "turn.csv: has no rows of numbers");
  refused("# NOT usable: the checks failed\n" + good,
          "turn.csv: says that it is not usable: the checks failed; compute a better table");
  refused(with(good, "half_length", "length"),
          "must have one of the columns depth and half_length, with its unit");
  refused(with(good, "station", "depth"),
          "must have one of the columns depth and half_length, with its unit");
  refused(with(good, "torque", "moment"), "turn.csv:2: has no column torque");
  refused(with(good, "K_II [", "K_2 ["), "turn.csv:2: has no column K_II");
  refused(with(good, "angle [deg]", "angle"), "the column angle has no unit");
  refused(with(good, "[N*m]", "[mm]"), "turn.csv:2:");
  refused(with(good, "1,0,-1,45,4,5,6\n", "1,0,-1,45,nan,5,6\n"), "turn.csv:4:");
  refused(with(good, "1,0,-1,45,4,5,6\n", "1,0,-1,45,,5,6\n"), "turn.csv:4:");
  refused(with(good, "1,0,-1,45,4,5,6\n", "1,0,-1,45,5,6\n"), "turn.csv:4: has 6 cells");
  refused(with(good, "1,0,-1,45,4,5,6\n", ""),
          "turn.csv:4: angle = 90 deg violates: a full grid; the point half_length 1 mm, torque 0 "
          "N*m, station -1, angle 45 deg is missing");
  refused(with(good, "1,0,-1,45,4,5,6\n", "1,0,-1,45,4,5,6\n1,0,-1,45,4,5,6\n"),
          "turn.csv:5: angle = 45 deg violates: a point of the table appears once");
  refused(
      with(good, "1,0,-1,45,4,5,6\n1,0,-1,90,7,8,9\n", "1,0,-1,90,7,8,9\n1,0,-1,45,4,5,6\n"),
      "turn.csv:5: angle = 45 deg violates: rows sorted by half_length, torque, station, angle, "
      "each ascending; the row before has 90");
  refused(good.substr(0, good.rfind("2,100,1,180")),
          "violates: a full grid; the point half_length 2 mm, torque 100 N*m, station 1, angle 180 "
          "deg is missing behind this row");
  refused(with(good, "1,0,-1,180,1,2,3\n", "1,0,-1,180,1,2,3.1\n"),
          "turn.csv:7: K_III = 3.1 MPa*m^0.5 violates: the value at the first angle, 3,");
  refused(with(good, "1,0,-1,0,", "-1,0,-1,0,"), "turn.csv:3: half_length = -1 mm violates: > 0");
  refused(
      "depth [mm],torque [N*m],station,angle [deg],K_I [Pa*m^0.5],K_II [Pa*m^0.5],K_III "
      "[Pa*m^0.5]\n1,0,0,0,1,1,1\n1,0,0,90,1,1,1\n1,0,0,180,1,1,1\n",
      "has 3 angles; give 4 or more");
  const std::string shaped =
      "depth [mm],aspect_ratio,torque [N*m],station,angle [deg],K_I [Pa*m^0.5],K_II [Pa*m^0.5],"
      "K_III [Pa*m^0.5]\n1,0.5,0,0,0,1,1,1\n1,0.5,0,0,60,1,1,1\n1,0.5,0,0,120,1,1,1\n"
      "1,0.5,0,0,180,1,1,1\n";
  refused(shaped, "has one aspect_ratio; give more of them, or leave the column out");
  refused(with(shaped, "1,0.5,0,0,0", "1,1.5,0,0,0"), "aspect_ratio = 1.5 violates: > 0 and <= 1");
}

TEST(TurnTableFile, BehaviourReadWithTheDrive) {
  const std::string drive =
      "format = \"strainwave-drive/1\"\n"
      "[material.steel]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\n"
      "[drive]\nratio = 100\npitch_diameter = \"160 mm\"\nradial_displacement = \"0.8 mm\"\n"
      "[load]\ntorque = \"100 N*m\"\n"
      "[flexspline]\nmaterial = \"steel\"\nshape = \"cylinder\"\nwall_thickness = \"2.24 mm\"\n"
      "length = \"160 mm\"\n"
      "[[flexspline.crack]]\nkind = \"through\"\nhalf_length = \"1.5 mm\"\n"
      "turn_table = \"tables/turn.csv\"\n";
  const GearSet gear =
      read_gear_set(drive, "d.toml", Attachments({{"tables/turn.csv", turn_csv()}}));
  ASSERT_EQ(gear.turn_tables.size(), 1U);
  EXPECT_EQ(gear.turn_tables.begin()->first, "tables/turn.csv");
  const std::string text = gear_text(gear);
  EXPECT_NE(text.find("turn_table = \"tables/turn.csv\"\n"), std::string::npos) << text;
  const auto refused = [&](const std::string& csv, const std::string& words) {
    try {
      (void)read_gear_set(drive, "d.toml",
                          csv.empty() ? Attachments() : Attachments({{"tables/turn.csv", csv}}));
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("flexspline.crack[0].turn_table"), std::string::npos) << what;
      EXPECT_NE(what.find(words), std::string::npos) << what;
      EXPECT_NE(what.find("d.toml:"), std::string::npos) << what;  // followed by its line
    }
  };
  refused("", "\"tables/turn.csv\" is not a file beside the input");
  refused(with(turn_csv(), "1,0,-1,45,4,5,6\n", "1,0,-1,45,nan,5,6\n"), "tables/turn.csv:4:");
}

}  // namespace
}  // namespace strainwave
