// SPDX-License-Identifier: Apache-2.0 Exit codes of a program whose command throws exceptions that
// real commands do not throw on demand.
#include "command_line.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "exit_code.hpp"
#include "files.hpp"
#include "progress_line.hpp"
#include "recording.hpp"

namespace strainwave::cli {
namespace {

struct NoOptions {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

struct NoResult {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

template <class Fault>
struct Failing {
  Fault fault;
  NoResult operator()(const Request&, const NoOptions&) const { throw fault; }
};

template <class Fault>
std::string complaint_about(const Fault& fault, ExitCode code) {
  const std::array table{command<NoOptions, NoResult>({.name = "work",
                                                       .summary = "It fails",
                                                       .description = "It fails.",
                                                       .example = "program work",
                                                       .takes = Takes::nothing,
                                                       .function = Failing<Fault>{fault},
                                                       .documents = {}})};
  const Program program{.name = "program", .summary = "A test", .table = table, .groups = {}};
  testing::internal::CaptureStderr();
  const std::array<std::string, 1> words{"work"};
  EXPECT_EQ(run_command_line(program, words), code);
  return testing::internal::GetCapturedStderr();
}

TEST(CommandLine, InputTooLittleMemorySaysWhatToLower) {
  const std::string sentence =
      "program: there is not enough memory for this computation; ask for fewer points, samples or "
      "threads, or for a coarser mesh\n";
  EXPECT_EQ(complaint_about(std::bad_alloc(), kNoMemory), sentence);
  // The exception that std::thread throws.
  const std::error_code thread = std::make_error_code(std::errc::resource_unavailable_try_again);
  EXPECT_EQ(complaint_about(std::system_error(thread), kNoMemory), sentence);
}

TEST(CommandLine, InputAJournalThatCannotBeReadBackIsRefused) {
  for (const char* const path : {"/dev/full", "/dev/zero", "/dev/null", "/dev/stdout", "/"})
    EXPECT_THROW((void)FileJournal(path), UnwritableError) << path;
  EXPECT_NO_THROW((void)FileJournal("not there yet"));
}

TEST(CommandLine, InputARecordThatCannotBeReadBackIsRefused) {
  for (const char* const path : {"/dev/full", "/dev/zero", "/dev/null", "/dev/stdout", "/"})
    EXPECT_THROW((void)FileRecording(path, false), UnwritableError) << path;
  EXPECT_NO_THROW((void)FileRecording("not there yet", false));
  EXPECT_NO_THROW((void)FileRecording("not there yet", true));
}

TEST(CommandLine, BehaviourOfARecordInAFile) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "strainwave_recording";
  std::filesystem::create_directories(folder);
  const std::string path = folder / "motion.bin";
  const std::string checkpoint = path + ".checkpoint";
  const auto clean = [&] {
    std::filesystem::remove(path);
    std::filesystem::remove(checkpoint);
  };
  clean();
  {
    FileRecording recording(path, false);
    EXPECT_FALSE(recording.can_go_on());
    EXPECT_FALSE(std::filesystem::exists(path));
    recording.begin("first");
    EXPECT_TRUE(recording.can_go_on());
    // One run at a time.
    FileRecording second(path, true);
    EXPECT_THROW(second.go_on(0), UnwritableError);
    recording.append("abc");
    recording.keep("second");
    EXPECT_FALSE(recording.due());
    EXPECT_EQ(recording.size(), 3U);
    recording.append("def");
    recording.store();
    EXPECT_EQ(text_of(path), "abcdef");
  }
  // Without a word the record of a run that was not finished is not replaced.
  EXPECT_THROW((void)FileRecording(path, false), UsageError);
  {
    FileRecording recording(path, true);
    EXPECT_EQ(recording.checkpoint(), "second");
    recording.go_on(3);
    recording.append("ghi");
    EXPECT_EQ(recording.size(), 6U);
    recording.store();
    recording.finish();
  }
  EXPECT_EQ(text_of(path), "abcghi");
  EXPECT_FALSE(std::filesystem::exists(checkpoint));
  // A finished record cannot go on, and a shorter one neither.
  EXPECT_THROW((void)FileRecording(path, true), UsageError);
  FileRecording shorter(path, false);
  EXPECT_THROW(shorter.go_on(7), InputError);
  clean();
}

TEST(CommandLine, BehaviourProgressInWords) {
  EXPECT_EQ(progress_text(0.0, 5.0), "0 %");
  EXPECT_EQ(progress_text(0.375, 15.0), "37 %, 2.5 %/s, 25 s left");
  EXPECT_EQ(progress_text(0.1, 60.0), "10 %, 0.17 %/s, 9 min left");
  EXPECT_EQ(progress_text(0.01, 600.0), "1 %, 0.0017 %/s, 16 h left");
}

TEST(CommandLine, InputAMistakeOfOursAsksForAReport) {
  EXPECT_EQ(complaint_about(std::out_of_range("index 7"), kInternal),
            "program: internal error: index 7; please report it\n");
}

}  // namespace
}  // namespace strainwave::cli
