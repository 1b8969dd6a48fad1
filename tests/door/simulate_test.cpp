// SPDX-License-Identifier: Apache-2.0
// The record and the kept curve of `simulate`.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
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
  test::KeptRecording untouched("motion.csv");
  EXPECT_EQ(refusal_of(untouched, R"({"engine": "stiff"})"),
            "--engine: stiff has no checkpoints, which --record and --resume need; leave out "
            "--engine, or the record");
  EXPECT_FALSE(untouched.kept);
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

/// A text that is kept in memory.
class KeptInMemory : public KeptText {
 public:
  [[nodiscard]] std::string name() const override { return "drive.curve"; }
  [[nodiscard]] std::optional<std::string> text() const override { return kept; }
  void keep(const std::string& text) override {
    kept = text;
    ++times;
  }

  std::optional<std::string> kept = {};
  int times = 0;
};

/// The example of a computed curve without cracks and with a short motion.
std::shared_ptr<const Drive> curve_drive(const std::string& from = {}, const std::string& to = {}) {
  std::string text = test::example_drives().at("tooth_crack_orders_size25")->text;
  const auto cut = [&](const std::string& begin, const std::string& end) {
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin)) {
      const std::size_t rest = text.find(end, at + begin.size());
      text.erase(at, rest == std::string::npos ? std::string::npos : rest - at);
    }
  };
  cut("[[mesh.crack", "\n[");
  cut("[[flexspline.crack", "\n[");
  cut("[[wave_generator.crack", "\n[");
  cut("[[manoeuvre]]", "\n[[none");
  text += "\n[[manoeuvre]]\nduration = \"10 ms\"\ninput_speed = \"100 rpm\"\n";
  if (!from.empty()) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  return read_drive(text, "drive.toml");
}

std::string with_table(KeptText* kept, const std::shared_ptr<const Drive>& drive) {
  const Command& row = command_named(commands(), "simulate");
  return run(row, drive, OptionValues(row.options), {}, {}, {.kept = kept}).json();
}

std::string refusal_of_table(KeptText& kept, const std::shared_ptr<const Drive>& drive) {
  try {
    (void)with_table(&kept, drive);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SimulateCurveTable, IdentityOfKeptAndNewTables) {
  // (MO-27): all digits of the answer are the same without a table, with the run that writes it,
  // and with one that reads it; another motion reads it too.
  const auto drive = curve_drive();
  KeptInMemory kept;
  const std::string expected = with_table(nullptr, drive);
  EXPECT_EQ(with_table(&kept, drive), expected);
  EXPECT_EQ(kept.times, 1);
  const std::string first = kept.kept.value();
  EXPECT_EQ(with_table(&kept, drive), expected);
  const auto faster = curve_drive("100 rpm", "200 rpm");
  EXPECT_EQ(with_table(&kept, faster), with_table(nullptr, faster));
  EXPECT_EQ(kept.times, 1);
  EXPECT_EQ(kept.kept, first);
}

TEST(SimulateCurveTable, InputTablesThatAreRefused) {
  KeptInMemory good;
  (void)with_table(&good, curve_drive());
  const std::string text = good.kept.value();
  const auto refused = [&](const std::string& kept, const std::shared_ptr<const Drive>& drive) {
    KeptInMemory of;
    of.kept = kept;
    const std::string message = refusal_of_table(of, drive);
    EXPECT_EQ(of.times, 0) << "the table of another run stays";
    EXPECT_EQ(of.kept, kept);
    return message;
  };
  const auto drive = curve_drive();
  // Another spelling of a number is the same drive.
  EXPECT_EQ(refused(text, curve_drive("flank_angle = \"22 deg", "flank_angle = \"22.0 deg")), "");
  EXPECT_EQ(refused(text, curve_drive("flank_angle = \"22 deg", "flank_angle = \"23 deg")),
            "--curve-table: drive.curve belongs to another drive, or to this drive before it was "
            "edited; name another file, or remove this one to compute the table again");
  std::string torn = text;
  torn[torn.size() / 2] = torn[torn.size() / 2] == '1' ? '2' : '1';
  const std::string damaged =
      "--curve-table: drive.curve is damaged; remove the file to compute the table again";
  EXPECT_EQ(refused(torn, drive), damaged);
  EXPECT_EQ(refused(text.substr(0, text.size() - 1), drive), damaged);
  EXPECT_EQ(refused(text.substr(0, text.find('\n') + 1), drive), damaged);
  EXPECT_EQ(refused("", drive),
            "--curve-table: drive.curve is not a curve table of this version of strainwave "
            "simulate; name another file");
  // The text of another revision, with its own digest.
  std::string older = text.substr(0, text.rfind('\n', text.size() - 2) + 1);
  older.replace(older.find('\n') + 1, 1, "older ");
  EXPECT_EQ(refused(older + sha256_hex(older) + '\n', drive),
            "--curve-table: drive.curve was made by another version of the program; remove the "
            "file to compute the table again");
  KeptInMemory none;
  EXPECT_EQ(refusal_of_table(none, test::example_drives().at("joint_size25")),
            "--curve-table: keeps the table of a computed curve, and the spring of this drive has "
            "none; leave it out, or give drivetrain.spring = \"computed\"");
  EXPECT_FALSE(none.kept);
}

}  // namespace
}  // namespace strainwave
