// SPDX-License-Identifier: Apache-2.0
// The record of `simulate`.
#include <gtest/gtest.h>

#include <string>

#include "answers.hpp"
#include "command/kept_recording.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/sha256.hpp"

namespace strainwave {
namespace {

/// The JSON of `simulate` on an example with a record.
std::string simulated(Recording& recording, const std::string& options = "{}",
                      const std::string& example = "joint_size25", const Progress& progress = {}) {
  const Command& row = command_named(commands(), "simulate");
  OptionValues values(row.options);
  values.set_from_json(options);
  return run(row, test::example_drives().at(example), values, {}, progress,
             {.recording = &recording})
      .json();
}

/// The message of the error; empty if there is none.
std::string refusal_of(Recording& recording, const std::string& options = "{}",
                       const std::string& example = "joint_size25") {
  try {
    (void)simulated(recording, options, example);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SimulateRecord, IdentityTheTableOfTheAnswer) {
  test::KeptRecording recording("motion.csv");
  const std::string answer = simulated(recording);
  EXPECT_EQ(recording.bytes, test::run_on_example("simulate", "joint_size25").document("csv"));
  EXPECT_NE(answer.find("motion.recorded"), std::string::npos);
  EXPECT_NE(answer.find("\"recorded_rows\": {\"value\": 1001, \"unit\": \"1\"}"), std::string::npos)
      << answer;
}

TEST(SimulateRecord, IdentityAfterAStop) {
  // (MO-22): record and answer have the same bytes as without a stop.
  for (const std::string name : {"motion.csv", "motion.bin"}) {
    test::KeptRecording whole(name);
    const std::string expected = simulated(whole);
    for (const double share : {0.11, 0.4, 0.9}) {
      test::KeptRecording recording(name);
      EXPECT_THROW((void)simulated(recording, "{}", "joint_size25",
                                   Progress([&](double at) { return at < share; })),
                   Stopped);
      ASSERT_TRUE(recording.kept);
      EXPECT_LT(recording.bytes.size(), whole.bytes.size());
      recording.bytes += "torn";
      EXPECT_EQ(simulated(recording), expected);
      EXPECT_EQ(recording.bytes, whole.bytes);
    }
  }
}

TEST(SimulateRecord, IdentityGrowingCracksAfterAStop) {
  // (MO-22, MO-50): the compliances over time come from the file and the option again.
  const Command& row = command_named(commands(), "simulate");
  const auto drive = read_drive(
      test::contents(STRAINWAVE_EXAMPLES "/growing_shaft.toml") +
          "\n[drivetrain]\nmotor_inertia = \"1e-2 kg*m^2\"\nload_inertia = \"20 kg*m^2\"\n"
          "\n[[manoeuvre]]\nduration = \"1 s\"\ninput_speed = \"0 rpm\"\n"
          "output_torque = \"6000 N*m\"\n",
      "hanging.toml");
  const auto run_it = [&](Recording& recording, const std::string& hours,
                          const Progress& progress = {}) {
    OptionValues values(row.options);
    values.set_from_json(R"({"growth": ")" + hours + "\"}");
    return run(row, drive, values, {}, progress, {.recording = &recording}).json();
  };
  test::KeptRecording whole("motion.bin");
  const std::string expected = run_it(whole, "200 h");
  EXPECT_NE(expected.find("\"released_energy\""), std::string::npos);
  EXPECT_NE(whole.bytes.find("growth"), std::string::npos);  // the option in the head
  test::KeptRecording recording("motion.bin");
  EXPECT_THROW((void)run_it(recording, "200 h", Progress([](double at) { return at < 0.6; })),
               Stopped);
  ASSERT_TRUE(recording.kept);
  test::KeptRecording other("motion.bin");
  other.kept = recording.kept;
  other.bytes = recording.bytes;
  try {
    (void)run_it(other, "100 h");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("of other options"), std::string::npos);
  }
  EXPECT_EQ(run_it(recording, "200 h"), expected);
  EXPECT_EQ(recording.bytes, whole.bytes);
}

TEST(SimulateRecord, BehaviourARunThatWasKilledAtItsBeginBeginsAgain) {
  // The first checkpoint is kept before the record is emptied.
  struct Killed {};
  class Dying : public test::KeptRecording {
   public:
    Dying() : KeptRecording("motion.bin") { bytes = "an old record"; }
    void begin(const std::string& checkpoint) override {
      kept = checkpoint;
      if (dies) throw Killed();
      KeptRecording::begin(checkpoint);
    }
    bool dies = true;
  };
  Dying recording;
  EXPECT_THROW((void)simulated(recording), Killed);
  EXPECT_EQ(recording.bytes, "an old record");
  recording.dies = false;
  test::KeptRecording whole("motion.bin");
  EXPECT_EQ(simulated(recording), simulated(whole));
  EXPECT_EQ(recording.bytes, whole.bytes);
}

TEST(SimulateRecord, InputEachRuleBrokenOnce) {
  test::KeptRecording text("motion.txt");
  EXPECT_EQ(refusal_of(text),
            "--record: motion.txt must end in .csv or .bin, which chooses the form of the record; "
            "name another file");
  test::KeptRecording good("motion.csv");
  EXPECT_EQ(refusal_of(good), "");
  const std::string kept = *good.kept;
  const auto refused = [&](const std::string& checkpoint, const std::string& options = "{}",
                           const std::string& example = "joint_size25",
                           const std::string& name = "motion.csv") {
    test::KeptRecording recording(name);
    recording.bytes = good.bytes;
    recording.kept = checkpoint;
    return refusal_of(recording, options, example);
  };
  EXPECT_EQ(refused(kept), "");
  const std::string other =
      "--resume: the checkpoint of motion.csv is that of another drive, of other options or of "
      "another version; name another file or remove both";
  EXPECT_EQ(refused(kept, "{}", "stick_slip_size25"), other);
  EXPECT_EQ(refused(kept, R"({"step": "1 ms"})"), other);
  EXPECT_EQ(refused(kept, R"({"tolerance": "1e-8 rad"})"), other);
  EXPECT_NE(refused(kept, "{}", "joint_size25", "motion.bin").find("of other options"),
            std::string::npos);
  EXPECT_EQ(
      refused("time [s]\n"),
      "--resume: the checkpoint of motion.csv is not one of strainwave simulate; name another "
      "file");
  const std::string damaged =
      "--resume: the checkpoint of motion.csv is damaged; remove both files to begin again";
  EXPECT_EQ(refused(kept.substr(0, kept.size() - 2)), damaged);
  EXPECT_EQ(refused(kept.substr(0, kept.find('\n'))), damaged);
  std::string changed = kept;
  changed[changed.size() / 2] ^= 1;
  EXPECT_EQ(refused(changed), damaged);
  // A digest that fits to a text that does not.
  std::string lines = kept.substr(0, kept.find('\n', kept.find('\n') + 1) + 1) + "1 2\n";
  EXPECT_NE(refused(lines + sha256_hex(lines) + '\n').find("checkpoint: cannot be read"),
            std::string::npos);
  // The record lost bytes that its checkpoint counts.
  test::KeptRecording cut("motion.csv");
  cut.kept = kept;
  EXPECT_NE(refusal_of(cut).find("is shorter than its checkpoint says"), std::string::npos);
}

}  // namespace
}  // namespace strainwave
