// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "exit_code.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "strainwave/strainwave.h"
#include "support/expect.hpp"
#include "support/random_drive.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

sw_text text(std::string_view view) { return {.data = view.data(), .size = view.size()}; }

std::string_view view(sw_text text) { return {text.data, text.size}; }

/// A text that the library returned.
std::string taken(sw_text given) {
  std::string copy(view(given));
  sw_text_free(given);
  return copy;
}

struct Free {
  void operator()(sw_drive* drive) const { sw_drive_free(drive); }
  void operator()(sw_answer* answer) const { sw_answer_free(answer); }
  void operator()(sw_error* error) const { sw_error_free(error); }
};
using DriveHandle = std::unique_ptr<sw_drive, Free>;
using AnswerHandle = std::unique_ptr<sw_answer, Free>;
using ErrorHandle = std::unique_ptr<sw_error, Free>;

std::string part(const ErrorHandle& error, sw_error_part which) {
  return std::string(view(sw_error_text(error.get(), which)));
}

/// Fails the test with the message of an error.
bool succeeded(sw_error* raw) {
  const ErrorHandle error(raw);
  if (error) ADD_FAILURE() << part(error, SW_MESSAGE);
  return !error;
}

std::string file_text(const std::string& name) {
  std::ifstream stream(STRAINWAVE_EXAMPLES "/" + name, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

int open_beside(void*, sw_text name, sw_source* source) {
  std::FILE* const file =
      std::fopen((STRAINWAVE_EXAMPLES "/" + std::string(view(name))).c_str(), "rb");
  if (file == nullptr) return 1;
  *source = {.next =
                 [](void* stream, char* bytes, std::size_t size) {
                   return static_cast<std::ptrdiff_t>(
                       std::fread(bytes, 1, size, static_cast<std::FILE*>(stream)));
                 },
             .close = [](void* stream) { (void)std::fclose(static_cast<std::FILE*>(stream)); },
             .context = file};
  return 0;
}

constexpr sw_attachments kBeside = {
    .array = nullptr, .count = 0, .find = open_beside, .context = nullptr};

DriveHandle read(std::string_view toml, std::string_view name = "drive.toml") {
  sw_drive* drive = nullptr;
  EXPECT_TRUE(succeeded(sw_read(text(toml), text(name), &kBeside, &drive)));
  return DriveHandle(drive);
}

AnswerHandle answer_of(const DriveHandle& drive, std::string_view command,
                       std::string_view options = "", const OptionTexts& texts = {}) {
  sw_answer* answer = nullptr;
  std::vector<sw_attachment> given;
  for (const auto& [name, of] : texts) given.push_back({.name = text(name), .text = text(of)});
  EXPECT_TRUE(succeeded(sw_run(drive.get(), text(command), text(options), given.data(),
                               given.size(), nullptr, &answer)));
  return AnswerHandle(answer);
}

std::string document(const AnswerHandle& answer, std::string_view name) {
  sw_text given{};
  EXPECT_TRUE(succeeded(sw_answer_document(answer.get(), text(name), &given)));
  return taken(given);
}

ErrorHandle read_error(std::string_view toml, const sw_attachments* attachments = nullptr) {
  sw_drive* drive = nullptr;
  ErrorHandle error(sw_read(text(toml), text("drive.toml"), attachments, &drive));
  EXPECT_TRUE(error);
  EXPECT_EQ(drive, nullptr);
  return error;
}

ErrorHandle run_error(const DriveHandle& drive, std::string_view command, std::string_view options,
                      const sw_progress* progress = nullptr) {
  sw_answer* answer = nullptr;
  ErrorHandle error(
      sw_run(drive.get(), text(command), text(options), nullptr, 0, progress, &answer));
  EXPECT_TRUE(error) << command << options;
  EXPECT_EQ(answer, nullptr);
  return error;
}

TEST(CApi, IdentityCodesAreTheExitCodesOfTheProgram) {
  EXPECT_EQ(int{SW_OPTION}, int{cli::kUsage});
  EXPECT_EQ(int{SW_INPUT}, int{cli::kInput});
  EXPECT_EQ(int{SW_NO_ANSWER}, int{cli::kNotUsable});
  EXPECT_EQ(int{SW_INTERNAL}, int{cli::kInternal});
  EXPECT_EQ(int{SW_NO_MEMORY}, int{cli::kNoMemory});
  EXPECT_EQ(int{SW_STOPPED}, int{cli::kInterrupted});
  for (const int code :
       {cli::kOk, cli::kUsage, cli::kInput, cli::kNotUsable, cli::kNotMet, cli::kCannotTell,
        cli::kUnwritable, cli::kInternal, cli::kNoMemory, cli::kInterrupted})
    EXPECT_NE(int{SW_CALLBACK}, code);
}

TEST(CApi, InputErrorsHaveAllTheirParts) {
  const std::string article = file_text("article.toml");
  const std::size_t at = article.find("\nratio");
  ASSERT_NE(at, std::string::npos);
  const std::size_t end = article.find('\n', at + 1);
  std::string broken = article;
  broken.replace(at + 1, end - at - 1, "ratio = -3");
  const auto line =
      2 + static_cast<std::size_t>(
              std::count(article.begin(), article.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  const ErrorHandle error = read_error(broken);
  EXPECT_EQ(sw_error_code(error.get()), SW_INPUT);
  EXPECT_EQ(part(error, SW_FILE), "drive.toml");
  EXPECT_EQ(sw_error_line(error.get()), line);
  EXPECT_EQ(sw_error_column(error.get()), 9U);
  EXPECT_EQ(part(error, SW_FIELD), "drive.ratio");
  EXPECT_EQ(part(error, SW_VALUE), "-3");
  EXPECT_NE(part(error, SW_RULE), "");
  EXPECT_EQ(part(error, SW_MESSAGE), "drive.toml:" + std::to_string(line) +
                                         ":9: drive.ratio = -3 violates: " + part(error, SW_RULE));
}

TEST(CApi, InputOtherErrorsHaveTheirParts) {
  const ErrorHandle no_toml = read_error("[drive]\nratio = = 3\n");
  EXPECT_EQ(sw_error_code(no_toml.get()), SW_INPUT);
  EXPECT_EQ(part(no_toml, SW_FILE), "drive.toml");
  EXPECT_EQ(sw_error_line(no_toml.get()), 2U);
  EXPECT_EQ(part(no_toml, SW_FIELD), "");

  const ErrorHandle large = read_error(std::string(kMaxTextSize + 1, ' '));
  EXPECT_EQ(part(large, SW_FILE), "drive.toml");
  EXPECT_EQ(sw_error_line(large.get()), 0U);

  const ErrorHandle no_table = read_error(file_text("tabulated_crack.toml"));
  EXPECT_TRUE(part(no_table, SW_FIELD).ends_with(".compliance_table"));
  EXPECT_GT(sw_error_line(no_table.get()), 0U);

  const DriveHandle drive = read(file_text("article.toml"));
  for (const auto& [command, options] :
       std::map<std::string, std::string>{{"stifness", ""},
                                          {"stiffness", "{\"methd\": \"corrected\"}"},
                                          {"stiffness", "not JSON"},
                                          {"solve", "{}"}}) {
    const ErrorHandle error = run_error(drive, command, options);
    EXPECT_EQ(sw_error_code(error.get()), SW_OPTION) << command;
    EXPECT_NE(part(error, SW_FIELD), "") << command;
  }
  EXPECT_EQ(part(run_error({}, "stiffness", ""), SW_FIELD), "drive");
  const AnswerHandle answer = answer_of(drive, "stiffness");
  sw_text unknown{};
  const ErrorHandle no_document(sw_answer_document(answer.get(), text("poem"), &unknown));
  EXPECT_EQ(sw_error_code(no_document.get()), SW_OPTION);
  EXPECT_EQ(sw_error_text(no_document.get(), static_cast<sw_error_part>(7)).size, 0U);
}

TEST(CApi, InputCallbacksMayFail) {
  const sw_source broken = {.next = [](void*, char*, std::size_t) { return std::ptrdiff_t{-1}; },
                            .close = [](void* context) { ++*static_cast<int*>(context); },
                            .context = nullptr};
  int closed = 0;
  sw_source source = broken;
  source.context = &closed;
  sw_drive* drive = nullptr;
  const ErrorHandle reading(sw_read_from(source, text("drive.toml"), nullptr, &drive));
  EXPECT_EQ(sw_error_code(reading.get()), SW_CALLBACK);
  EXPECT_EQ(closed, 1);
  const AnswerHandle answer = answer_of({}, "catalogue");
  int commits = 0;
  const sw_sink sink = {.write = [](void*, const char*, std::size_t) { return 1; },
                        .commit =
                            [](void* context) {
                              ++*static_cast<int*>(context);
                              return 0;
                            },
                        .context = &commits};
  const ErrorHandle writing(sw_answer_write(answer.get(), text("json"), &sink));
  EXPECT_EQ(sw_error_code(writing.get()), SW_CALLBACK);
  EXPECT_EQ(commits, 0);
}

TEST(CApi, IdentityAttachmentsOfArrayAndCallback) {
  const std::string toml = file_text("tabulated_crack.toml");
  const std::string name = "tables/through_45.csv";
  const std::string table = file_text(name);
  const sw_attachment one = {.name = text(name), .text = text(table)};
  const sw_attachments array = {.array = &one, .count = 1, .find = nullptr, .context = nullptr};
  sw_drive* drive = nullptr;
  ASSERT_TRUE(succeeded(sw_read(text(toml), text("drive.toml"), &array, &drive)));
  const DriveHandle of_array(drive);
  EXPECT_EQ(document(answer_of(of_array, "stiffness"), "json"),
            document(answer_of(read(toml), "stiffness"), "json"));
}

/// An example of a command: file, and options.
struct Example {
  std::string file;
  std::string options;
};

const std::map<std::string, Example, std::less<>>& examples() {
  static const std::map<std::string, Example, std::less<>> all = {
      {"stiffness", {"article.toml", ""}},
      {"torsion", {"catalogue_size25.toml", ""}},
      {"duty", {"", R"({"rainflow": "joint_history.csv", "column": "torque"})"}},
      {"life", {"life_size25.toml", ""}},
      {"grow", {"growing_shaft.toml", R"({"until": "300 h"})"}},
      {"fit",
       {"",
        R"({"data": "growth_specimens.csv", "stress_range": "60 MPa", "plate_width": "100 mm", "knots": 2, "draws": 200})"}},
      {"inspect",
       {"inspected_shaft.toml",
        R"({"draws": 40, "a50": "1 mm", "a90": "2 mm", "every": "100 h"})"}},
      {"laminate", {"composite_cup.toml", ""}},
      {"modes", {"joint_size25.toml", ""}},
      {"frf", {"joint_size25.toml", ""}},
      {"accuracy", {"joint_size25.toml", ""}},
      {"oval", {"breathing_crack.toml", ""}},
      {"turn", {"breathing_crack.toml", ""}},
      {"transmission", {"cracked_size25.toml", R"({"draws": 1})"}},
      {"simulate", {"joint_size25.toml", ""}},
      {"backbone", {"joint_size25.toml", ""}},
      {"require", {"article.toml", R"({"requirements": ["intact.stiffness >= 1 N*m/rad"]})"}},
      {"report", {"article.toml", R"({"date": "2026-01-01"})"}},
      {"sensitivity", {"article_scatter.toml", R"({"scatter": true, "samples": 1000})"}},
      {"reliability",
       {"article_scatter.toml",
        R"({"require": ["intact.stiffness >= 5.8e5 N*m/rad"], "draws": 500})"}},
      {"sweep", {"article.toml", R"({"vary": ["output_shaft.crack[0].depth=1 mm..2 mm:3"]})"}},
      {"solve",
       {"article.toml",
        R"({"vary": "output_shaft.crack[0].depth=0.1 mm..8 mm", "target": "cracked.positive.stiffness_change=-1 %"})"}},
      {"sif list", {}},
      {"sif show", {"", R"({"name": "plate-surface"})"}},
      {"sif eval",
       {"",
        R"({"name": "plate-surface", "set": ["depth=1 mm", "half_length=2 mm", "thickness=10 mm", "half_width=50 mm", "tension=100 MPa"]})"}},
      {"sif plot", {"", R"({"name": "plate-surface"})"}},
      {"material list", {}},
      {"material show", {"", R"({"name": "17-4PH H900"})"}},
      {"catalogue", {"", R"({"size": 25})"}},
      {"validate", {}},
      {"calibrate", {"catalogue_size25.toml", R"({"catalogue": true, "factors": "support"})"}},
      {"audit", {}},
      {"new", {}},
      {"schema", {}},
      {"explain", {"", R"({"word": "crack.closed"})"}},
      {"units", {}},
      {"diff", {"", R"({"first": "article.toml", "second": "through_crack.toml"})"}},
  };
  return all;
}

TEST(CApi, BehaviourEveryCommandAnswersAsTheFacade) {
  EXPECT_EQ(examples().size(), commands().size());
  for (const Command& command : commands()) {
    const auto example = examples().find(command.name);
    ASSERT_NE(example, examples().end()) << command.name << " has no example here; add one";
    const auto& [file, options] = example->second;
    const std::string toml = file.empty() ? "" : file_text(file);
    const OptionTexts texts = {{"article.toml", file_text("article.toml")},
                               {"through_crack.toml", file_text("through_crack.toml")},
                               {"growth_specimens.csv", file_text("growth_specimens.csv")},
                               {"joint_history.csv", file_text("joint_history.csv")}};
    const AnswerHandle answer =
        answer_of(file.empty() ? DriveHandle() : read(toml), command.name, options, texts);
    ASSERT_TRUE(answer) << command.name;
    OptionValues values(command.options);
    if (!options.empty()) values.set_from_json(options);
    const Answer expected =
        run(command, file.empty() ? nullptr : read_drive(toml, "drive.toml"), values, texts);
    EXPECT_EQ(document(answer, "json"), expected.json()) << command.name;
    EXPECT_EQ(sw_answer_usable(answer.get()), expected.usable() ? 1 : 0);
    const std::string_view first = command.documents.front().name;
    EXPECT_EQ(document(answer, first), expected.document(first)) << command.name;
  }
}

TEST(CApi, BehaviourCommandsAreListed) {
  sw_text given{};
  ASSERT_TRUE(succeeded(sw_commands(&given)));
  const auto json = nlohmann::json::parse(taken(given));
  ASSERT_EQ(json.size(), commands().size());
  EXPECT_EQ(json[0]["name"], "stiffness");
  EXPECT_EQ(json[0]["takes"], "drive");
  EXPECT_EQ(json[0]["options"], nlohmann::json({"method"}));
  EXPECT_EQ(json[0]["documents"], nlohmann::json({"json", "text", "csv", "plot", "fad"}));
}

TEST(CApi, CrosscheckRandomDrives) {
  const Command& command = command_named(commands(), "stiffness");
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const std::string toml = gear_text(test::random_drive(seed));
    const std::string json = document(answer_of(read(toml), "stiffness"), "json");
    EXPECT_EQ(json,
              run(command, read_drive(toml, "drive.toml"), OptionValues(command.options)).json())
        << seed;
  }
}

TEST(CApiThreads, IdentityOneHandleFromEightThreads) {
  const DriveHandle drive = read(file_text("article.toml"));
  const AnswerHandle shared = answer_of(drive, "stiffness");
  const std::string expected = document(shared, "json");
  const std::string expected_text = document(shared, "text");
  std::vector<std::string> answers(8);
  std::vector<std::string> texts(8);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < answers.size(); ++i)
      threads.emplace_back([&, i] {
        for (int repeat = 0; repeat < 5; ++repeat) {
          answers[i] = document(answer_of(drive, "stiffness"), "json");
          texts[i] = document(shared, "text");
          (void)run_error(drive, "stifness", "");
        }
      });
  }
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i], expected);
    EXPECT_EQ(texts[i], expected_text);
  }
}

TEST(CApiThreads, IdentityBatchOfEightThreads) {
  const DriveHandle drive = read(file_text("article.toml"));
  const sw_text path = text("output_shaft.crack[0].depth");
  const sw_text output = text("cracked.positive.stiffness");
  std::vector<double> values;
  for (int i = 0; i < 64; ++i) values.push_back((i - 1) * 0.1e-3);
  std::vector<double> first;
  for (const int threads : {1, 8}) {
    const sw_batch_task task = {.paths = &path,
                                .n_paths = 1,
                                .values = values.data(),
                                .n_rows = values.size(),
                                .outputs = &output,
                                .n_outputs = 1,
                                .method = text("corrected"),
                                .threads = threads};
    std::vector<double> numbers(values.size());
    std::vector<int> codes(values.size());
    std::array<sw_text, SW_ROW_CODES> faults{};
    ASSERT_TRUE(succeeded(
        sw_batch(drive.get(), &task, nullptr, numbers.data(), codes.data(), faults.data())));
    EXPECT_EQ(codes[0], SW_ROW_REFUSED);
    EXPECT_EQ(codes[20], SW_ROW_OK);
    EXPECT_NE(taken(faults[SW_ROW_REFUSED]).find("output_shaft.crack[0].depth"), std::string::npos);
    for (const sw_row_code code : {SW_ROW_OK, SW_ROW_NO_ANSWER, SW_ROW_NOT_USABLE})
      sw_text_free(faults[code]);
    if (first.empty()) first = numbers;
    EXPECT_EQ(numbers, first);
  }
}

// Kind: cross-check (ST-22).  Source: single evaluations by the engine.  A long batch reads tables
// of the cracks and states their error, which bounds that of rows which it did not compare to
// within the contract of 1e-10; the numbers are those of `sw_batch`, for any number of threads.
TEST(CApi, CrosscheckErrorOfTheTablesOfABatch) {
  const DriveHandle drive = read(file_text("article.toml"));
  const sw_text path = text("output_shaft.crack[0].depth");
  const sw_text output = text("cracked.positive.stiffness");
  const std::size_t rows = test::kSanitized ? 1500 : 20'000;
  std::vector<double> values;
  for (std::size_t row = 0; row < rows; ++row)
    values.push_back(0.5e-3 + 3e-3 * static_cast<double>(row) / static_cast<double>(rows));
  sw_batch_task task = {.paths = &path,
                        .n_paths = 1,
                        .values = values.data(),
                        .n_rows = rows,
                        .outputs = &output,
                        .n_outputs = 1,
                        .method = text("corrected"),
                        .threads = 1};
  std::vector<double> numbers(rows);
  std::vector<double> plain(rows);
  std::vector<int> codes(rows);
  sw_table_evidence one{};
  sw_table_evidence two{};
  ASSERT_TRUE(succeeded(sw_batch_with_evidence(drive.get(), &task, nullptr, numbers.data(),
                                               codes.data(), nullptr, &one)));
  task.threads = 2;
  ASSERT_TRUE(succeeded(sw_batch_with_evidence(drive.get(), &task, nullptr, plain.data(),
                                               codes.data(), nullptr, &two)));
  EXPECT_EQ(plain, numbers);
  EXPECT_EQ(one.largest_error, two.largest_error);
  ASSERT_TRUE(
      succeeded(sw_batch(drive.get(), &task, nullptr, plain.data(), codes.data(), nullptr)));
  EXPECT_EQ(plain, numbers);
  if (test::kSanitized) return;
  EXPECT_GE(one.cracks, 1);
  EXPECT_EQ(one.points, 1000);
  EXPECT_GT(one.largest_error, 0.0);
  EXPECT_LT(one.largest_error, 1e-10);
  task.n_rows = 1;  // a single evaluation takes the engine
  for (std::size_t row = 0; row < rows; row += 997) {
    task.values = &values[row];
    double exact = 0.0;
    sw_table_evidence none{.cracks = 9, .points = 9, .largest_error = 9};
    ASSERT_TRUE(succeeded(
        sw_batch_with_evidence(drive.get(), &task, nullptr, &exact, codes.data(), nullptr, &none)));
    test::expect_relative(numbers[row], exact, 1e-10);
    EXPECT_EQ(none.cracks + none.points, 0);
    EXPECT_EQ(none.largest_error, 0.0);
  }
}

TEST(CApi, BehaviourStopsAtTheCallThatAsks) {
  struct Calls {
    int n = 0;
    int stop_at = 0;
  };
  const DriveHandle drive = read(file_text("article.toml"));
  for (const int stop_at : {1, 3}) {
    Calls calls{.stop_at = stop_at};
    const sw_progress progress = {.report =
                                      [](void* context, double) {
                                        auto& told = *static_cast<Calls*>(context);
                                        return ++told.n == told.stop_at ? 1 : 0;
                                      },
                                  .context = &calls};
    const ErrorHandle error = run_error(
        drive, "sweep", R"({"vary": ["output_shaft.crack[0].depth=1 mm..2 mm:500"]})", &progress);
    EXPECT_EQ(sw_error_code(error.get()), SW_STOPPED);
    EXPECT_EQ(calls.n, stop_at);
  }
}

/// Resident memory of this process [kB].
long resident() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (word == "VmRSS:") {
      long kilobytes = 0;
      status >> kilobytes;
      return kilobytes;
    }
  return 0;
}

TEST(CApi, BehaviourMemoryDoesNotGrow) {
  const std::string toml = file_text("article.toml");
  const auto repeat = [&](int n) {
    for (int i = 0; i < n; ++i) {
      const DriveHandle drive = read(toml);
      const AnswerHandle answer = answer_of(drive, "stiffness");
      (void)document(answer, "json");
      (void)read_error("[drive]\nratio = 1\n");
    }
  };
  const bool whole = std::getenv("STRAINWAVE_LONG") != nullptr;
  repeat(whole ? 2000 : 50);
  const long before = resident();
  ASSERT_GT(before, 0);
  repeat(whole ? 100'000 : 200);
  // The smallest possible leak per repetition, ten bytes of a freed handle, would add up to a
  // megabyte.  A sanitizer keeps freed memory for some time and detects leaks itself, so it is
  // excluded.
  if (!test::kSanitized) {
    EXPECT_LT(resident() - before, 512);
  }
}

}  // namespace
}  // namespace strainwave
