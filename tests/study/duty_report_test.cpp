// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/duty_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/layouts/duty.hpp"

namespace strainwave {
namespace {

GearSet duty_gear() { return read_gear_set_file(STRAINWAVE_EXAMPLES "/duty_size25.toml"); }

DutyReport counts_in(const std::string& text, const HistoryCountOptions& options = {}) {
  HistoryFile file(pieces_of(text), "h.csv");
  return count_history(file, options);
}

bool has_note(const DutyReport& report, std::string_view code) {
  return std::ranges::any_of(report.notes, [&](const Note& note) { return note.code == code; });
}

TEST(DutyReport, ReferenceFigure6OfTheStandard) {  // GR-1
  // ASTM E1049, figure 6, with its printed counts; exact.
  const DutyReport report = counts_in("load [kN]\n-2\n1\n-3\n5\n-1\n3\n-4\n4\n-2\n");
  ASSERT_TRUE(report.history.has_value());
  const HistoryCount& count = *report.history;
  EXPECT_EQ(count.points, 9);
  EXPECT_EQ(count.reversals, 9);
  EXPECT_EQ(count.unit, "kN");
  EXPECT_EQ(count.least, -4.0);
  EXPECT_EQ(count.largest, 5.0);
  EXPECT_EQ(count.counted.largest_range, 9.0);
  EXPECT_EQ(count.counted.cycles, 4.0);
  ASSERT_EQ(count.counted.rows.size(), 7U);
  EXPECT_EQ(count.counted.rows[0].range, 9.0);
  EXPECT_EQ(count.counted.rows[0].mean, 0.5);
  EXPECT_EQ(count.counted.rows[0].count, 0.5);
}

TEST(DutyReport, BehaviourReversalsAndFlatHistories) {
  EXPECT_EQ(counts_in("x\n0\n1\n2\n2\n1\n1\n5\n").history->reversals, 4);
  EXPECT_EQ(counts_in("x\n3\n3\n").history->reversals, 0);
  EXPECT_EQ(counts_in("x\n3\n3\n").history->counted.cycles, 0.0);
  EXPECT_EQ(counts_in("x\n3\n4\n", {.residue = Residue::repeated}).history->counted.cycles, 1.0);
}

// Kind: reference (LI-20), by hand.  Two blocks of 100 and -50 N*m: in one repetition one wave has
// its peak and its valley in different blocks such that its range is larger by 150 N*m.  A jump of
// the torque within a rise or fall of the wave is no wave, and one wave is smaller.
TEST(DutyReport, ReferenceWavesBetweenTwoBlocks) {
  GearSet gear = duty_gear();
  constexpr double kSpeed = 2 * 3.14159265358979 * 20 / 60;
  gear.duty = Duty{
      .history = {}, .block = {{2, kSpeed, 100}, {1, kSpeed, -50}}, .peak = {}, .resonance = {}};
  const DutyReport report = duty_report(gear);
  const std::vector<CycleCount>& rows = report.drive->places.front().between->rows;
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NEAR(rows[0].range, 150, 1e-9);
  EXPECT_NEAR(rows[0].mean, 25, 1e-9);
  EXPECT_EQ(rows[0].count, 1);
  EXPECT_FALSE(has_note(report, "duty.vibration"));
  gear.duty->resonance = DutyResonance{.frequency_ratio = 0.9, .damping_ratio = 0.02};
  EXPECT_TRUE(has_note(duty_report(gear), "duty.vibration"));
}

TEST(DutyReport, BehaviourCyclesLeftOut) {
  std::string text = "x\n";
  for (int i = 0; i < 10500; ++i) text += "0\n" + std::to_string(i + 1) + "\n";
  const DutyReport report = counts_in(text, {.residue = Residue::repeated});
  EXPECT_TRUE(has_note(report, "duty.cycles_left_out"));
  EXPECT_EQ(report.history->counted.rows.size(), 10000U);
  EXPECT_EQ(report.history->counted.left_out, 500.0);
  EXPECT_EQ(report.history->counted.largest_left_out, 500.0);
  const DutyReport classes = counts_in(text, {.residue = Residue::repeated, .classes = 10});
  EXPECT_FALSE(has_note(classes, "duty.cycles_left_out"));
  EXPECT_EQ(classes.history->counted.class_width, 2048.0);
  EXPECT_EQ(classes.history->counted.cycles, 10500.0);
}

TEST(DutyReport, InputColumns) {
  const auto said = [](const std::string& text, const HistoryCountOptions& options) {
    try {
      (void)counts_in(text, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(said("a,b\n1,2\n", {}), "h.csv: has the columns a, b; choose one by --column");
  EXPECT_EQ(said("a,b\n1,2\n", {.column = "c"}), "h.csv:1: has no column c; its columns are a, b");
  EXPECT_EQ(said("a\n", {}),
            "h.csv: has no row of numbers; give at least one below the names of the columns");
}

TEST(DutyReport, ReferenceMakersLoadCycle) {  // LI-1, LI-21
  // A maker's load cycle for ratio 100, with the printed average torque of 89 N*m; the digits are
  // of a computation of our own.  202 waves per turn of the output.
  const DutyReport report = duty_report(duty_gear());
  ASSERT_TRUE(report.drive.has_value());
  const DriveDuty& duty = *report.drive;
  EXPECT_NEAR(duty.average_torque, 89.386829, 5e-7);
  EXPECT_NEAR(duty.average_input_speed / units::rpm, 1756.7568, 5e-5);
  ASSERT_EQ(duty.places.size(), 5U);
  EXPECT_NEAR(duty.places[0].per_output_turn, 202, 1e-12);
  EXPECT_NEAR(duty.places[0].per_repetition, 202 * 65.0 / 60, 1e-9);
  EXPECT_NEAR(duty.places[0].per_hour, 202 * 65.0 / 60 * 3600 / 3.7, 1e-6);
  double waves = 0;
  for (const PlaceLoad& load : duty.places[0].loads) waves += load.cycles;
  EXPECT_NEAR(waves, duty.places[0].per_repetition, 1e-9);
  EXPECT_TRUE(has_note(report, "duty.peaks_added"));
  ASSERT_EQ(duty.torque.rows.size(), 2U);
  EXPECT_EQ(duty.torque.rows[0].range, 380.0);
  EXPECT_NEAR(duty.torque.rows[0].count, 3.7 / 3.6e6, 1e-18);
  EXPECT_EQ(duty.torque.rows[1].range, 280.0);
  const std::string text = duty_text(report, duty_gear());
  EXPECT_NE(text.find("rainflow by four points"), std::string::npos);
}

TEST(DutyReport, BehaviourWithoutNumberOfBalls) {
  GearSet gear = duty_gear();
  gear.wave_generator->bearing->ball_count.reset();
  const DutyReport report = duty_report(gear);
  EXPECT_TRUE(has_note(report, "duty.ball_passes_unknown"));
  EXPECT_EQ(report.drive->places.size(), 4U);
  EXPECT_FALSE(duty_text(report, gear).empty());
}

TEST(DutyReport, BehaviourHistoryBesideTheDrive) {
  // The history of the example in place of the blocks: many torques give classes.
  GearSet gear = duty_gear();
  gear.duty->block.clear();
  gear.duty->peak.clear();
  gear.duty->history = "joint_history.csv";
  read_duty_record(gear, attachments_beside(STRAINWAVE_EXAMPLES "/duty_size25.toml"));
  const DutyReport report = duty_report(gear);
  const PlaceReport& place = report.drive->places[0];
  EXPECT_EQ(report.drive->steps, 240);
  EXPECT_EQ(place.class_width, 8.0);
  double waves = 0;
  for (const PlaceLoad& load : place.loads) waves += load.cycles;
  EXPECT_NEAR(waves, place.per_repetition, 1e-9 * waves);
  // The same cycles as those of the column counted alone.
  HistoryFile file(pieces_of_file(STRAINWAVE_EXAMPLES "/joint_history.csv"), "h.csv");
  const DutyReport alone = count_history(file, {.column = "torque", .residue = Residue::repeated});
  EXPECT_EQ(alone.history->counted.cycles, report.drive->torque.cycles);
  EXPECT_EQ(alone.history->counted.largest_range, report.drive->torque.largest_range);
}

}  // namespace
}  // namespace strainwave
