// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/history_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

/// Pieces of a text with a given largest size.
TextPieces small_pieces(std::string text, std::size_t size) {
  return [whole = pieces_of(std::move(text)), size](std::span<char> to) {
    return whole(to.first(std::min(size, to.size())));
  };
}

std::vector<double> values_of(HistoryFile& file, std::size_t column, std::size_t most = 3) {
  std::vector<double> all;
  for (const std::array<std::size_t, 1> wanted = {column};;) {
    const std::vector<double>& block = file.read(wanted, most)[0];
    if (block.empty()) return all;
    all.insert(all.end(), block.begin(), block.end());
  }
}

/// The message on reading all values of a column, or the duty.
std::string history_fault(const std::string& text, const std::string& column) {
  try {
    HistoryFile file(pieces_of(text), "h.csv");
    (void)values_of(file, file.number_of(column));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}
std::string record_fault(const std::string& text) {
  try {
    HistoryFile file(pieces_of(text), "h.csv");
    (void)read_duty_record(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

const std::string kHistory =
    "\xEF\xBB\xBF# a record\r\n\r\ntime [s], \"Torque [N*m]\",note\r\n0,1.5,start\r\n# later\r\n"
    "1e-1, +2.25 ,\r\n\r\n.2,-3,x,\r\n0.3,1e3,end";

TEST(HistoryFile, BehaviourColumnsAndValues) {
  for (const std::size_t size : {1U, 2U, 7U, 1000U}) {
    HistoryFile file(small_pieces(kHistory, size), "h.csv");
    ASSERT_EQ(file.columns().size(), 3U);
    EXPECT_EQ(file.columns()[1].name, "Torque");
    EXPECT_EQ(file.columns()[1].unit, "N*m");
    EXPECT_EQ(file.columns()[2].unit, "");
    EXPECT_EQ(file.number_of("torque"), 1U);
    EXPECT_TRUE(file.has("NOTE"));
    EXPECT_FALSE(file.has("speed"));
    EXPECT_EQ(values_of(file, 1), (std::vector<double>{1.5, 2.25, -3, 1000}));
    EXPECT_EQ(file.rows(), 4U);
  }
  HistoryFile file(pieces_of(kHistory), "h.csv");
  EXPECT_EQ(values_of(file, 0), (std::vector<double>{0, 0.1, 0.2, 0.3}));
}

TEST(HistoryFile, BehaviourSeparatorsAndDecimalCommas) {
  for (const std::string text : {"a;b\n1,5;2\n\"2,5\";3\n", "a\tb\n1.5\t2\n2.5\t3\n",
                                 "sep=;\na;b\n1,5;2\n2,5;3\n", "a;b;\n1.5;2;\n2.5;3;\n"}) {
    HistoryFile file(pieces_of(text), "h.csv");
    EXPECT_EQ(values_of(file, file.number_of("a")), (std::vector<double>{1.5, 2.5})) << text;
  }
}

TEST(HistoryFile, BehaviourWithoutNames) {
  HistoryFile file(pieces_of("1,2\n3,4\n"), "h.csv");
  EXPECT_EQ(values_of(file, file.number_of("2")), (std::vector<double>{2, 4}));
}

TEST(HistoryFile, BehaviourLongText) {
  // More than one buffer, in pieces that cut numbers anywhere.
  std::string text = "x\n";
  std::vector<double> expected;
  for (int i = 0; i < 100000; ++i) {
    expected.push_back(i / 8.0);
    text += std::to_string(i / 8.0) + "\n";
  }
  for (const std::size_t size : {4093U, 1U << 20U}) {
    HistoryFile file(small_pieces(text, size), "h.csv");
    EXPECT_EQ(values_of(file, 0, 4096), expected);
    EXPECT_EQ(file.bytes(), text.size());
  }
}

TEST(HistoryFile, InputNamesOfColumns) {
  EXPECT_EQ(history_fault("time,torque\n1,2\n", "speed"),
            "h.csv:1: has no column speed; its columns are time, torque");
  EXPECT_EQ(history_fault("torque\n1\n", "speed"),
            "h.csv:1: has no column speed; its column is torque");
  EXPECT_EQ(history_fault("a,b,A\n1,2,3\n", "a"),
            "h.csv:1:5: names the column a twice; name it once");
  EXPECT_EQ(history_fault("", "a"), "h.csv: is empty; give rows of numbers below a row of names");
  EXPECT_EQ(history_fault("# no rows\n\n", "a"),
            "h.csv: is empty; give rows of numbers below a row of names");
  EXPECT_EQ(history_fault(std::string("a\0b\n", 4), "a"),
            "h.csv: is not CSV text in UTF-8; save the table as \"CSV UTF-8\"");
}

TEST(HistoryFile, InputRows) {
  EXPECT_EQ(history_fault("a,b\n1,2\n# c\n1,x\n", "b"),
            "h.csv:4:3: b = \"x\" is not a number; write a number such as 12.5");
  EXPECT_EQ(history_fault("a,b\n1,nan\n", "b"),
            "h.csv:2:3: b = \"nan\" is not finite; give finite numbers only");
  EXPECT_EQ(history_fault("a,b\n1,-inf\n", "b"),
            "h.csv:2:3: b = \"-inf\" is not finite; give finite numbers only");
  EXPECT_EQ(history_fault("a,b\n1,\n", "b"), "h.csv:2:3: b is empty; give a number in every row");
  EXPECT_EQ(history_fault("a,b\n1\n", "a"),
            "h.csv:2: has 1 cell, but there are 2 columns; write a cell for each column");
  EXPECT_EQ(history_fault("a,b\n1,2,3\n", "a"),
            "h.csv:2: has 3 cells, but there are 2 columns; if commas are decimal, separate the "
            "cells by semicolons");
  EXPECT_EQ(history_fault("a;b\n1.000,5;2\n", "a"),
            "h.csv:2:1: a = \"1.000,5\" is not a number; write a number such as 12.5");
  EXPECT_EQ(history_fault("a,b\n1,2e\n", "b"),
            "h.csv:2:3: b = \"2e\" is not a number; write a number such as 12.5");
  EXPECT_EQ(history_fault("a\n" + std::string(3U << 20U, '1') + "\n", "a"),
            "h.csv:2: is longer than 1 MiB; it is no row of CSV");
  // A column that nobody counts may hold anything.
  EXPECT_EQ(history_fault("a,b\n1,nan\n2,\n", "a"), "");
}

TEST(HistoryFile, BehaviourDutyRecord) {
  HistoryFile file(pieces_of("input_speed [rpm],torque [kN*m],time [min]\n60,0.5,0\n-30,-1,1\n"),
                   "h.csv");
  const DutyRecord record = read_duty_record(file);
  EXPECT_TRUE(record.of_input);
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.rows[1].time, 60.0);
  EXPECT_EQ(record.rows[1].torque, -1000.0);
  EXPECT_NEAR(record.rows[1].speed, -30 * units::rpm, 1e-15);
}

TEST(HistoryFile, BehaviourRowsWithoutANewLoad) {
  // Equal rows are one load that lasts; the last row gives the end.
  HistoryFile file(pieces_of("time [s],torque [N*m],output_speed [rad/s]\n"
                             "0,1,2\n1,1,2\n2,1,2\n3,4,2\n4,4,5\n5,4,5\n6,4,5\n"),
                   "h.csv");
  const DutyRecord record = read_duty_record(file);
  std::vector<double> times;
  for (const DutyRow& row : record.rows) times.push_back(row.time);
  EXPECT_EQ(times, (std::vector<double>{0, 3, 4, 6}));
}

TEST(HistoryFile, InputDutyRecord) {
  EXPECT_EQ(record_fault("time [s],torque [N*m]\n0,1\n"),
            "h.csv:1: has no column output_speed; its columns are time, torque");
  EXPECT_EQ(record_fault("time [s],output_speed [rpm]\n0,1\n"),
            "h.csv:1: has no column torque; its columns are time, output_speed");
  EXPECT_EQ(record_fault("time,torque [N*m],output_speed [rpm]\n0,1,2\n"),
            "h.csv:1:1: the column time has no unit; write \"time [s]\"");
  EXPECT_NE(record_fault("time [s],torque [N],output_speed [rpm]\n0,1,2\n").find("h.csv:1:10: "),
            std::string::npos);
  const std::string head = "time [s],torque [N*m],output_speed [rpm]\n";
  EXPECT_EQ(record_fault(head + "0,1,2\n1,1,2\n1,1,2\n"),
            "h.csv:4: time = 1 s violates: later than the row before, 1");
  EXPECT_EQ(record_fault(head + "0,1,2\n2,1,2\n1,1,2\n"),
            "h.csv:4: time = 1 s violates: later than the row before, 2");
  EXPECT_EQ(record_fault(head + "0,1,2\n"),
            "h.csv: has fewer than two rows of numbers; a row holds until the time of the next");
  EXPECT_EQ(record_fault("time [s],torque [N*m],output_speed [rpm],input_speed [rpm]\n0,1,2,3\n"),
            "h.csv: has the columns output_speed and input_speed; give one of them");
}

}  // namespace
}  // namespace strainwave
