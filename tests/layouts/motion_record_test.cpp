// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/motion_record.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "strainwave/layouts/simulation.hpp"

namespace strainwave {
namespace {

/// A number of bytes, the lowest first.
std::uint64_t number_at(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t n = size; n-- > 0;)
    value = value << 8U | static_cast<unsigned char>(bytes.at(at + n));
  return value;
}

constexpr SimulationRow kRow{.time = 0.1,
                             .input_angle = -1e300,
                             .input_speed = std::numeric_limits<double>::denorm_min(),
                             .output_angle = 1.0 / 3,
                             .output_speed = -0.0,
                             .output_error = 5,
                             .torque = 6,
                             .input_torque = 7,
                             .cracked_output_angle = 8,
                             .cracked_output_error = 9,
                             .cracked_torque = 10,
                             .cracked_input_torque = 11};

TEST(MotionRecord, IdentityBinaryRoundTrip) {
  // (MO-22): the head describes the rows, and each number keeps its bits.
  const RecordOrigin origin{.version = "1.2.3",
                            .revision = "abc",
                            .input_file = "dr\"ive.toml",
                            .input_sha256 = "00ff",
                            .options = {{"step", "1 ms"}}};
  for (const bool cracked : {false, true}) {
    const std::string head = record_head(RecordForm::binary, origin, {.cracked = cracked});
    ASSERT_EQ(head.substr(0, 8), "swmotion");
    EXPECT_EQ(number_at(head, 8, 4), 1U);
    ASSERT_EQ(16 + number_at(head, 12, 4), head.size());
    EXPECT_EQ(head.size() % 8, 0U);
    const auto said = nlohmann::json::parse(head.substr(16));
    EXPECT_EQ(said["format"], "strainwave-motion/1");
    EXPECT_EQ(said["version"], "1.2.3");
    EXPECT_EQ(said["revision"], "abc");
    EXPECT_EQ(said["input_file"], "dr\"ive.toml");
    EXPECT_EQ(said["input_sha256"], "00ff");
    EXPECT_EQ(said["options"]["step"], "1 ms");
    const std::vector<double> expected = {
        0.1, -1e300, std::numeric_limits<double>::denorm_min(), 1.0 / 3, -0.0, 5, 6, 7, 8, 9,
        10,  11};
    ASSERT_EQ(said["columns"].size(), cracked ? 12U : 8U);
    EXPECT_EQ(said["columns"][6]["name"], "torque");
    EXPECT_EQ(said["columns"][6]["unit"], "N*m");
    std::string bytes;
    add_record_row(bytes, RecordForm::binary, kRow, {.cracked = cracked});
    ASSERT_EQ(bytes.size(), said["row_bytes"].get<std::size_t>());
    ASSERT_EQ(bytes.size(), said["columns"].size() * 8);
    for (std::size_t n = 0; 8 * n < bytes.size(); ++n)
      EXPECT_EQ(number_at(bytes, 8 * n, 8), std::bit_cast<std::uint64_t>(expected[n]));
  }
  // The cracked drive stopped before the sound one.
  std::string bytes;
  add_record_row(bytes, RecordForm::binary, {.time = 1}, {.cracked = true});
  EXPECT_TRUE(std::isnan(std::bit_cast<double>(number_at(bytes, 64, 8))));
}

TEST(MotionRecord, IdentityOfTheTableOfTheAnswer) {
  // Head and lines are those of --format csv.
  SimulationReport report;
  report.rows = {kRow, {.time = 2}};
  for (const bool cracked : {false, true}) {
    if (cracked) report.cracked.emplace();
    std::string text = record_head(RecordForm::csv, {}, {.cracked = cracked});
    EXPECT_TRUE(text.starts_with("time [s],input_angle [rad],")) << text;
    for (const SimulationRow& row : report.rows)
      add_record_row(text, RecordForm::csv, row, {.cracked = cracked});
    EXPECT_EQ(text, simulation_csv(report));
  }
  std::string line;
  add_record_row(line, RecordForm::csv, kRow, {.cracked = true});
  EXPECT_EQ(line, "0.1,-1e+300,5e-324,0.3333333333333333,-0,5,6,7,8,9,10,11\n");
  line.clear();
  add_record_row(line, RecordForm::csv, {.time = 2}, {.cracked = true});
  EXPECT_EQ(line, "2,0,0,0,0,0,0,0,,,,\n");
  // A given motion of the output adds the torque that it needs.
  SimulationRow moved = kRow;
  moved.output_torque = 12;
  line.clear();
  add_record_row(line, RecordForm::csv, moved, {.output_given = true});
  EXPECT_EQ(line, "0.1,-1e+300,5e-324,0.3333333333333333,-0,5,6,7,12\n");
  report.cracked.reset();
  report.intact.largest_output_torque = 12;
  EXPECT_TRUE(
      simulation_csv(report).starts_with(record_head(RecordForm::csv, {}, {.output_given = true})));
}

}  // namespace
}  // namespace strainwave
