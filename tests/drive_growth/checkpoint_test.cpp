// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/checkpoint.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "growth_support.hpp"
#include "strainwave/drive_growth/grow_cracks.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

GearSet drive_to_resume() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_size25.toml"); }

/// The report of a run that goes on from lines, and all lines that it then has.
struct Resumed {
  GrowthReport report;
  std::string lines;
};
Resumed resumed(const std::string& from) {
  Resumed run{.report = {}, .lines = from};
  GrowthCheckpoint checkpoint(from, [&](const std::string& line) { run.lines += line; });
  run.report = grow_cracks(drive_to_resume(), {}, {}, &checkpoint);
  return run;
}

TEST(Checkpoint, IdentityOfARunStoppedAnywhere) {
  const Resumed whole = resumed("");
  const GrowthReport alone = grow_cracks(drive_to_resume());
  EXPECT_EQ(alone.time, whole.report.time);
  EXPECT_EQ(alone.step_error, whole.report.step_error);
  std::size_t stops = 0;
  for (std::size_t cut = 0; cut < whole.lines.size(); cut += 8009) {
    // A run that is killed while it writes a line leaves a part of the line.
    const std::size_t end = whole.lines.rfind('\n', cut);
    const std::string kept = end == std::string::npos ? "" : whole.lines.substr(0, end + 1);
    const Resumed again = resumed(kept);
    EXPECT_EQ(again.lines, whole.lines) << cut;
    EXPECT_EQ(again.report.time, whole.report.time);
    EXPECT_EQ(again.report.steps, whole.report.steps);
    EXPECT_EQ(again.report.step_error, whole.report.step_error);
    ASSERT_EQ(again.report.cracks[1].series.size(), whole.report.cracks[1].series.size());
    for (std::size_t i = 0; i < again.report.cracks[1].series.size(); ++i) {
      EXPECT_EQ(again.report.cracks[1].series[i].size, whole.report.cracks[1].series[i].size);
      EXPECT_EQ(again.report.cracks[1].series[i].rate, whole.report.cracks[1].series[i].rate);
    }
    ++stops;
  }
  EXPECT_GT(stops, 2U);
}

TEST(Checkpoint, IdentityOfARunThatGoesThroughTheWall) {
  // A step behind the wall belongs to another set of cracks.
  GearSet gear = test::cracked_wall(R"(
kind = "surface"
depth = "1.2 mm"
half_length = "3 mm"
angle = "45 deg"
)");
  const auto run = [&](const std::string& from, std::string& lines) {
    lines = from;
    GrowthCheckpoint checkpoint(from, [&](const std::string& line) { lines += line; });
    return grow_cracks(gear, {}, {}, &checkpoint);
  };
  std::string whole;
  const GrowthReport expected = run("", whole);
  ASSERT_EQ(expected.cracks[0].events.front().event, CrackEvent::through_wall);
  ASSERT_GT(expected.time, 1.01 * expected.cracks[0].events.front().time);
  std::size_t stops = 0;
  for (std::size_t end = whole.find('\n'); end != std::string::npos;
       end = whole.find('\n', end + 1)) {
    if (++stops % 31 != 0 && end + 1 != whole.size()) continue;
    std::string lines;
    const GrowthReport resumed = run(whole.substr(0, end + 1), lines);
    EXPECT_EQ(lines, whole) << "cut behind line " << stops;
    EXPECT_EQ(resumed.time, expected.time) << "cut behind line " << stops;
    EXPECT_EQ(resumed.step_error, expected.step_error) << "cut behind line " << stops;
  }
  EXPECT_GT(stops, 50U);
}

TEST(Checkpoint, InputLinesThatCannotBeRead) {
  const auto message = [](const std::string& lines) {
    return test::broken_rule([&] { return GrowthCheckpoint(lines, {}); });
  };
  EXPECT_EQ(message(""), "no error");
  EXPECT_EQ(message("0p+0 1p+0 1p+0 1p+0"), "no error");  // without its end: left out
  EXPECT_NE(
      message(
          "0p+0 0p+0 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0\nx 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0\n")
          .find("step 2"),
      std::string::npos);
  EXPECT_NE(message("0p+0 1p+0\n").find("step 1"), std::string::npos);
  const auto other_drive = [] {
    GrowthCheckpoint checkpoint("0p+0 0p+0 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0 1p+0\n",
                                {});
    return grow_cracks(drive_to_resume(), {}, {}, &checkpoint);
  };
  EXPECT_NE(test::broken_rule(other_drive).find("another drive"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
