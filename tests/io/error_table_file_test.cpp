// SPDX-License-Identifier: Apache-2.0
// The file of a kinematic error (MO-56).
#include "strainwave/io/error_table_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// An error of order 2 and 1 arcmin over one turn from an angle on, every 10 degrees.
std::string error_csv(double from = 0.0,
                      const std::string& head = "input_angle [deg],error [arcmin]") {
  std::string text = "# measured\n" + head + "\n";
  for (int n = 0; n <= 36; ++n) {
    const double angle = from + 10 * n;
    text += std::to_string(angle) + "," + std::to_string(std::sin(2 * angle * pi / 180)) + "\n";
  }
  return text;
}

ErrorTable error_table_from(const std::string& text) {
  HistoryFile file(pieces_of(text), "error.csv");
  return read_error_table(file);
}

TEST(ErrorTableFile, ReferenceAnOrder) {
  // The digits of the file bound the lines: six behind the point.
  for (const double from : {0.0, 35.0}) {
    const ErrorTable table = error_table_from(error_csv(from));
    test::expect_relative(table.turns, 1, 1e-12);
    EXPECT_EQ(table.values.size(), 36U);
    ASSERT_EQ(table.lines.orders.size(), 1U);
    EXPECT_EQ(table.lines.orders[0].order, 2.0);
    test::expect_relative(table.lines.orders[0].amplitude, pi / 180 / 60, 1e-6);
    EXPECT_NEAR(table.lines.orders[0].phase, 0.0, 1e-6);
  }
}

TEST(ErrorTableFile, InputRulesBrokenOnce) {
  const auto refused = [](const std::string& text, const std::string& words) {
    try {
      (void)error_table_from(text);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = error_csv();
    return text.replace(text.find(from), from.size(), to);
  };
  refused(error_csv(0, "angle [deg],error [arcmin]"), "input_angle");
  refused(error_csv(0, "input_angle [deg],error [mm]"), "mm");
  refused(error_csv(0, "input_angle,error [arcmin]"), "unit");
  refused(with("20.000000", "21.000000"), "even angles, here 20");
  refused(with("20.000000", "9.000000"), "above the angle before, 10");
  refused(with("360.000000,-0.000000", "360.000000,0.5"),
          "the last row is the first one a period later");
  refused(with("10.000000,0.342020", "10.000000,31"),
          "less than 0.5 deg from the mean of the errors, 0.8");
  refused("input_angle [deg],error [arcmin]\n0,0\n180,1\n360,0\n", "has 3 rows; give 4 to 8192");
  std::string many = "input_angle [deg],error [arcmin]\n";
  for (int n = 0; n <= 8192; ++n) many += std::to_string(n) + ",0\n";
  refused(many, "has more than 8192 rows; give 4 to 8192");
  refused("input_angle [deg],error [arcmin]\n0,0\n", "has 1 row; give 4 to 8192 rows");
  // Degrees that were meant: 0.36 deg is less than a period of order 1000.
  refused("input_angle [deg],error [arcmin]\n0,0\n.1,1\n.2,0\n.3,-1\n.35,0\n", "even angles");
  refused("input_angle [deg],error [arcmin]\n0,0\n.08,1\n.16,0\n.24,-1\n.32,0\n",
          "an angle at least 1/1000 of a turn above the first one");
}

TEST(ErrorTableFile, InputOfADrive) {
  // The drive names the file; a fault names field, file and line.
  std::string text = read_text_file(STRAINWAVE_EXAMPLES "/joint_size25.toml");
  const std::string section = "[drivetrain]\n";
  text.replace(text.find(section), section.size(), section + "error_table = \"error.csv\"\n");
  const auto attached = [](const std::string& csv) {
    return Attachments(Attachments::Texts{{"error.csv", csv}});
  };
  const GearSet gear = read_gear_set(text, "drive.toml", attached(error_csv()));
  const KinematicError error = kinematic_error_of(gear);
  ASSERT_EQ(error.orders().size(), gear.kinematic_error.size() + 1);
  EXPECT_EQ(error.orders().back().order, 2.0);
  try {
    (void)read_gear_set(text, "drive.toml", Attachments());
    ADD_FAILURE() << "accepted a drive without its table";
  } catch (const InputError& fault) {
    EXPECT_NE(std::string(fault.what()).find("drivetrain.error_table"), std::string::npos);
  }
  try {
    (void)read_gear_set(text, "drive.toml", attached("input_angle [deg],error [arcmin]\n0,x\n"));
    ADD_FAILURE() << "accepted a wrong table";
  } catch (const InputError& fault) {
    EXPECT_NE(std::string(fault.what()).find("drivetrain.error_table"), std::string::npos);
    EXPECT_NE(std::string(fault.what()).find("error.csv:2"), std::string::npos);
  }
  // The table is needed where the drive is built in code too.
  GearSet without = gear;
  without.error_table.reset();
  EXPECT_NE(test::broken_rule([&] { check(without); }).find("has not been read"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
