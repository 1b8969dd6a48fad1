// SPDX-License-Identifier: Apache-2.0
#include "door/answers.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "door/json_schema.hpp"
#include "report/svg_document.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/units.hpp"
#include "support/expect.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

using test::Json;

/// Checks that each quantity of a value has the unit that its field states.
class UnitWitness : public ValueVisitor {
 public:
  void begin_record() override { open_.push_back(field_); }
  void end_record() override { open_.pop_back(); }
  bool field(const Field& field) override {
    field_ = field;
    open_.back() = field;
    return true;
  }
  void begin_list() override {}
  void end_list() override {}
  void begin_column(const Field& field) override { field_ = field; }
  void end_column() override {}
  void number(double, const Field& field) override {
    if (field.unit != kUnitBeside) {
      EXPECT_NO_THROW((void)parse_unit(field.unit)) << field.name;
    }
  }
  void quantity(const Quantity& value) override {
    ++n_quantities;
    EXPECT_NO_THROW((void)parse_unit(value.unit)) << field_.name;
    if (field_.unit != kUnitBeside) {
      EXPECT_EQ(value.unit, field_.unit) << field_.name;
    }
  }
  void whole(std::int64_t) override {}
  void flag(bool) override {}
  void text(std::string_view) override {}
  void nothing() override {}

  int n_quantities = 0;

 private:
  Field field_{};
  std::vector<Field> open_;
};

/// Cells of each line of a CSV text without its remarks; a cell in quotes may hold commas and line
/// feeds.
std::vector<std::size_t> cells_of_lines(std::string_view csv) {
  while (csv.starts_with('#')) csv.remove_prefix(csv.find('\n') + 1);
  std::vector<std::size_t> cells;
  std::size_t n = 1;
  bool quoted = false;
  for (const char c : csv) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ',') ++n;
    if (c == '\n') {
      cells.push_back(n);
      n = 1;
    }
  }
  return cells;
}

void expect_well_formed(Format format, const std::string& text) {
  EXPECT_FALSE(text.empty());
  switch (format) {
    case Format::json:
      EXPECT_FALSE(Json::parse(text, nullptr, false).is_discarded());
      break;
    case Format::csv: {
      const auto cells = cells_of_lines(text);
      ASSERT_FALSE(cells.empty());
      for (const std::size_t n : cells) EXPECT_EQ(n, cells.front()) << text.substr(0, 400);
      break;
    }
    case Format::svg:
    case Format::html: {
      const std::size_t begin = format == Format::html ? text.find("<html") : text.find("<svg");
      ASSERT_NE(begin, std::string::npos);
      EXPECT_NO_THROW((void)test::parse_xml(std::string_view(text).substr(begin)));
      break;
    }
    case Format::toml: {
      // A law of growth is a part of a drive file.
      const bool whole =
          text.find("\nformat = ") != std::string::npos || text.starts_with("format");
      const std::string drive =
          whole ? text : test::contents(STRAINWAVE_EXAMPLES "/solid_shaft.toml") + text;
      EXPECT_NO_THROW((void)read_drive(drive, "written.toml")) << text.substr(0, 400);
      break;
    }
    case Format::text:
    case Format::vtu:
    case Format::markdown:
      EXPECT_EQ(text.find('\0'), std::string::npos);
      break;
  }
}

void expect_keeps(const std::string& schema, const Json& value) {
  const std::vector<std::string> faults = test::schema_faults(Json::parse(schema), value);
  EXPECT_TRUE(faults.empty()) << faults.size() << " faults, the first: " << faults.front();
}

/// The examples for a command, in the order in which the test takes them.
///
/// Their number times that of the commands is large, and the sanitizers make each answer ten times
/// slower.  Under them a command takes every sixth example, each command others, and goes on only
/// until one example has been answered.  The release build takes all.
struct ExamplesOfCommand {
  std::map<std::string, std::shared_ptr<const Drive>> first;
  std::map<std::string, std::shared_ptr<const Drive>> until_one_is_answered;
};

ExamplesOfCommand examples_of(const Command& row) {
  ExamplesOfCommand of;
  if (row.takes != Takes::nothing) of.first = test::example_drives();
  constexpr std::size_t kEvery = test::kSanitized ? 6 : 1;
  std::size_t n = std::hash<std::string_view>()(row.name);
  for (const auto& [name, drive] : test::example_drives())
    if (n++ % kEvery != 0)
      if (auto moved = of.first.extract(name)) of.until_one_is_answered.insert(std::move(moved));
  if (row.takes != Takes::drive) of.first["no drive"] = nullptr;
  return of;
}

class Answers : public testing::TestWithParam<std::string_view> {};

TEST_P(Answers, IdentityEveryAnswerKeepsItsSchemaItsUnitsAndItsDocuments) {
  const Command& row = command_named(commands(), GetParam());
  const std::string result = result_schema(row);
  const std::string options = options_schema(row);
  const ExamplesOfCommand examples = examples_of(row);
  const auto [begin, end] = test::trial_options().equal_range(row.name);
  ASSERT_NE(begin, end) << "a new command needs a trial here";
  for (auto trial = begin; trial != end; ++trial) {
    int n_answers = 0;
    const auto answer_one = [&](const std::string& name,
                                const std::shared_ptr<const Drive>& drive) {
      SCOPED_TRACE(name + " " + std::string(trial->second));
      double last = 0.0;
      const Progress progress([&](double share) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1.0 + 1e-12);
        last = share;
        return true;
      });
      try {
        const Answer answer =
            test::run_command(row.name, drive, trial->second, test::trial_texts(), progress);
        ++n_answers;
        const Json envelope = Json::parse(answer.json());
        expect_keeps(result, envelope);
        expect_keeps(options, envelope["provenance"]["options"]);
        UnitWitness units;
        answer.visit(units);
        for (const Document& document : row.documents) {
          SCOPED_TRACE(document.name);
          try {
            expect_well_formed(document.format, answer.document(document.name));
          } catch (const InputError& error) {  // such as a diagram of cracks without cracks
            EXPECT_FALSE(document.option.empty() && answer.usable()) << error.what();
          }
        }
      } catch (const Error& error) {
        EXPECT_GT(std::string_view(error.what()).size(), 10U);
      }
    };
    for (const auto& [name, drive] : examples.first) answer_one(name, drive);
    for (const auto& [name, drive] : examples.until_one_is_answered)
      if (n_answers == 0) answer_one(name, drive);
    EXPECT_GE(n_answers, 1) << trial->second;
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachCommand, Answers, testing::ValuesIn([] {
                           std::vector<std::string_view> names;
                           for (const Command& row : commands()) names.push_back(row.name);
                           return names;
                         }()),
                         [](const auto& tested) {
                           std::string name(tested.param);
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

TEST(AnswersOfExamples, ReferenceMostExamplesAreAnswered) {
  int n_torsion = 0;
  for (const auto& [name, drive] : test::example_drives()) {
    EXPECT_NO_THROW((void)test::run_on_example("stiffness", name)) << name;
    try {
      (void)test::run_on_example("torsion", name, R"({"draws": 0})");
      ++n_torsion;
    } catch (const InputError&) {  // the drive lacks the geometry
    }
  }
  EXPECT_GE(n_torsion, 3);
}

class Stops : public testing::TestWithParam<std::pair<std::string_view, std::string_view>> {};

TEST_P(Stops, IdentityALongCommandStopsWhenAsked) {
  const auto& [command, options] = GetParam();
  int calls = 0;
  const Progress progress([&](double) { return ++calls < 2; });
  const auto drive = test::example_drives().at(command == "sensitivity" || command == "reliability"
                                                   ? "article_scatter"
                                                   : "catalogue_size25");
  EXPECT_THROW((void)test::run_command(command, drive, options, {}, progress), Stopped);
  EXPECT_EQ(calls, 2) << "it goes on after it was asked to stop";
}

INSTANTIATE_TEST_SUITE_P(
    OfEachCommand, Stops,
    testing::Values(std::pair("torsion", R"({"draws": 5})"), std::pair("report", "{}"),
                    std::pair("sensitivity", R"({"scatter": true, "samples": 100000})"),
                    std::pair("reliability", R"({"require": ["intact.stiffness > 1 N*m/rad"]})"),
                    std::pair("sweep", R"({"vary": ["load.torque=1 N*m..20 N*m:30"]})"),
                    std::pair("solve", R"({"vary": "load.torque=1 N*m..20 N*m",
                                           "target": "intact.stiffness=2e4 N*m/rad"})"),
                    std::pair("validate", R"({"mode": "per-row"})"),
                    std::pair("calibrate", R"({"catalogue": true})")),
    [](const auto& tested) { return std::string(tested.param.first); });

TEST(Facade, InputATextThatTheDriveNamesMustBeAttached) {
  const std::string text = test::contents(STRAINWAVE_EXAMPLES "/tabulated_crack.toml");
  const std::string table = test::contents(STRAINWAVE_EXAMPLES "/tables/through_45.csv");
  // The working directory contains the table, but the facade must not look there.
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(STRAINWAVE_EXAMPLES);
  EXPECT_NE(
      test::broken_rule([&] { return read_drive(text, "x.toml"); }).find("tables/through_45.csv"),
      std::string::npos);
  std::filesystem::current_path(before);
  const auto drive =
      read_drive(text, "x.toml", Attachments(Attachments::Texts{{"tables/through_45.csv", table}}));
  EXPECT_TRUE(test::run_command("stiffness", drive).usable());
}

TEST(Facade, InputATextThatAnOptionNamesMustBeGiven) {
  const auto drive = test::example_drives().at("catalogue_size25");
  for (const auto& tested : {std::pair("calibrate", R"({"measured": "table.csv"})"),
                             std::pair("validate", R"({"data": "table.csv"})"),
                             std::pair("duty", R"({"rainflow": "table.csv"})")}) {
    const auto said = [&](const OptionTexts& texts) {
      return test::broken_rule([&] {
        const bool alone = std::string_view(tested.first) == "duty";
        return test::run_command(tested.first, alone ? nullptr : drive, tested.second, texts);
      });
    };
    EXPECT_NE(said({}).find("names a text that is not attached"), std::string::npos)
        << tested.first;
    EXPECT_NE(said({{"table.csv", "no csv"}}).find("table.csv"), std::string::npos)
        << tested.first << ": the given text is read";
  }
}

}  // namespace
}  // namespace strainwave
