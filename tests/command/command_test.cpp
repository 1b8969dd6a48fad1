// SPDX-License-Identifier: Apache-2.0
#include "strainwave/command/command.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "command/kept_journal.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

using Json = nlohmann::ordered_json;

enum class Size { small, large };

struct TestOptions {
  std::string name;
  int count = 2;
  double length = 0.5;
  double factor = 1.0;
  bool loud = false;
  Size size = Size::small;
  std::optional<int> limit;
  std::vector<std::string> set;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using T = TestOptions;
    field({.name = "name", .unit = "", .doc = "who is asked", .positional = true}, &T::name);
    field({.name = "count",
           .unit = "",
           .doc = "how often",
           .range = {.lower = 0, .lower_open = false, .upper = 10, .upper_open = false},
           .fallback = "2"},
          &T::count);
    field(
        {.name = "length", .unit = "m", .doc = "how long", .range = kPositive, .fallback = "0.5 m"},
        &T::length);
    field({.name = "factor", .unit = "1", .doc = "how much", .range = kPositive, .fallback = "1"},
          &T::factor);
    field({"loud", "", "whether to shout"}, &T::loud);
    field({.name = "size", .unit = "", .doc = "of the answer", .fallback = "small"}, &T::size);
    field({"limit", "", "at most"}, &T::limit);
    field({"set", "", "repeatable"}, &T::set);
  }
};

}  // namespace

template <>
struct EnumNames<Size> {
  static constexpr std::array<std::string_view, 2> names = {"small", "large"};
};

namespace {

struct TestResult {
  double doubled = 0.0;
  std::vector<Note> notes;
  std::string unusable_because;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"doubled", "m", "two lengths"}, &TestResult::doubled);
  }
};

Command test_command() {
  return command<TestOptions, TestResult>({
      .name = "double",
      .summary = "Twice a length",
      .description = "Doubles a length.",
      .example = "strainwave double x",
      .takes = Takes::nothing,
      .function =
          [](const Request&, const TestOptions& o) {
            TestResult result{.doubled = 2 * o.length, .notes = {}, .unusable_because = {}};
            if (o.loud)
              result.notes.push_back({.code = "test.loud",
                                      .text = "it is loud",
                                      .path = {},
                                      .equation = {},
                                      .severity = Severity::care,
                                      .next_step = "Whisper."});
            if (o.count == 0) result.unusable_because = "nobody asked";
            return result;
          },
      .documents = {{{.name = "text"},
                     [](const TestResult& r, const Rendering&) {
                       return std::to_string(r.doubled);
                     }}},
  });
}

const TestOptions& values(const OptionValues& options) {
  return *static_cast<const TestOptions*>(options.get());
}

std::string refusal(std::string_view name, std::string_view text) {
  const OptionsType type = options_type<TestOptions>();
  OptionValues options(type);
  return test::broken_rule([&] {
    options.set(name, text);
    return 0;
  });
}

std::string json_refusal(std::string_view json) {
  const OptionsType type = options_type<TestOptions>();
  OptionValues options(type);
  return test::broken_rule([&] {
    options.set_from_json(json);
    return 0;
  });
}

bool says(const std::string& message, std::string_view part) {
  return message.find(part) != std::string::npos;
}

TEST(Options, InputEveryRuleIsBrokenOnceByText) {
  EXPECT_PRED2(says, refusal("lenght", "1 m"), "did you mean length?");
  EXPECT_PRED2(says, refusal("zzzzzzzz", "1"),
               "is not an option here; known options are name, count, length");
  EXPECT_PRED2(says, refusal("count", "11"), "11 violates: >= 0 and <= 10");
  EXPECT_PRED2(says, refusal("count", "-1"), "-1 violates");
  for (const char* const text : {"1.5", "x", "", " 1", "1 "})
    EXPECT_PRED2(says, refusal("count", text), "is not a whole number");
  EXPECT_PRED2(says, refusal("count", "99999999999999999999"),
               "99999999999999999999 violates: >= 0 and <= 10");
  EXPECT_PRED2(says, refusal("length", "-1 m"), "> 0");
  EXPECT_PRED2(says, refusal("length", "1 kg"), "length");
  EXPECT_PRED2(says, refusal("length", "nan m"), "length");
  EXPECT_PRED2(says, refusal("factor", "x"), "factor");
  for (const char* const text : {"yes", "TRUE", "1", ""})
    EXPECT_PRED2(says, refusal("loud", text), "must be true or false");
  EXPECT_PRED2(says, refusal("size", "medium"), "choose one of small, large");
}

TEST(Options, InputAnOptionIsGivenOnceUnlessItMayBeRepeated) {
  const OptionsType type = options_type<TestOptions>();
  OptionValues options(type);
  options.set("count", "3");
  EXPECT_PRED2(says, test::broken_rule([&] {
                 options.set("count", "3");
                 return 0;
               }),
               "is given twice");
  options.set("set", "a=1");
  options.set("set", "b=2");
  EXPECT_EQ(values(options).set, (std::vector<std::string>{"a=1", "b=2"}));
}

TEST(Options, InputARequiredOptionMustBeGiven) {
  const OptionsType type = options_type<TestOptions>();
  OptionValues options(type);
  EXPECT_PRED2(says, test::broken_rule([&] {
                 options.require_complete();
                 return 0;
               }),
               "name: must be given (who is asked)");
  options.set("name", "x");
  EXPECT_NO_THROW(options.require_complete());
}

TEST(Options, InputJsonBreaksEveryRuleOnce) {
  for (const char* const text : {"", "[]", "3", "\"x\"", "{", "{\"count\": 1} x", "null", "\xFF"})
    EXPECT_PRED2(says, json_refusal(text), "the text must be a JSON object");
  for (const char* const text :
       {R"({"name": {"a": 1}})", R"({"name": null})", R"({"set": [["a"]]})", R"({"set": [null]})"})
    EXPECT_PRED2(says, json_refusal(text), "must be text, a number, true or false");
  EXPECT_PRED2(says, json_refusal(R"({"lenght": "1 m"})"), "did you mean length?");
  EXPECT_PRED2(says, json_refusal(R"({"count": [1, 2]})"), "is given twice");
  EXPECT_PRED2(says, json_refusal(R"({"count": 11})"), "violates");
  EXPECT_PRED2(says, json_refusal(R"({"count": 1.5})"), "whole number");
  EXPECT_PRED2(says, json_refusal(R"({"loud": 1})"), "must be true or false");
}

TEST(Options, IdentityTextAndJsonSetTheSame) {
  const OptionsType type = options_type<TestOptions>();
  OptionValues text(type);
  for (const auto& [name, value] :
       std::vector<std::pair<const char*, const char*>>{{"name", "x"},
                                                        {"count", "3"},
                                                        {"length", "20 mm"},
                                                        {"factor", "1.5"},
                                                        {"loud", "true"},
                                                        {"size", "large"},
                                                        {"limit", "4"},
                                                        {"set", "a"},
                                                        {"set", "b"}})
    text.set(name, value);
  OptionValues json(type);
  json.set_from_json(R"({"name": "x", "count": 3, "length": "20 mm", "factor": 1.5, "loud": true,
                         "size": "large", "limit": 4, "set": ["a", "b"]})");
  for (const OptionValues* const given : {&text, &json}) {
    const TestOptions& o = values(*given);
    EXPECT_EQ(o.name, "x");
    EXPECT_EQ(o.count, 3);
    EXPECT_DOUBLE_EQ(o.length, 0.02);
    EXPECT_EQ(o.factor, 1.5);
    EXPECT_TRUE(o.loud);
    EXPECT_EQ(o.size, Size::large);
    EXPECT_EQ(o.limit, 4);
    EXPECT_EQ(o.set.size(), 2U);
  }
}

TEST(CommandRow, ReferenceTheEnvelopeHasItsFieldsInOrder) {
  const Command row = test_command();
  OptionValues options(row.options);
  options.set_from_json(R"({"name": "x", "loud": true, "length": "2 m"})");
  const Answer answer = run(row, nullptr, options);
  const Json envelope = Json::parse(answer.json());
  std::vector<std::string> names;
  for (const auto& [name, value] : envelope.items()) names.push_back(name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"format", "command", "usable", "unusable_because", "verdict",
                                      "notes", "equations", "accuracies", "result", "provenance"}));
  EXPECT_EQ(envelope["format"], "strainwave-result/1");
  EXPECT_EQ(envelope["command"], "double");
  EXPECT_EQ(envelope["usable"], true);
  EXPECT_EQ(envelope["verdict"]["judgement"], "with care");
  EXPECT_EQ(envelope["verdict"]["next_step"], "Whisper.");
  EXPECT_EQ(envelope["notes"][0]["severity"], "care");
  EXPECT_EQ(envelope["result"]["doubled"], Json::parse(R"({"value": 4.0, "unit": "m"})"));
  EXPECT_EQ(envelope["provenance"]["options"]["length"], "2 m");
  EXPECT_FALSE(envelope["provenance"].contains("input")) << "the command takes no drive";
  EXPECT_EQ(answer.document("json"), answer.json());
  EXPECT_EQ(answer.document("text"), "4.000000");
  EXPECT_PRED2(says, test::broken_rule([&] { return answer.document("svg"); }),
               "double does not make svg; it makes json, text");
}

TEST(CommandRow, LimitAnUnusableAnswerCannotBeTold) {
  const Command row = test_command();
  OptionValues options(row.options);
  options.set_from_json(R"({"name": "x", "count": 0})");
  const Answer answer = run(row, nullptr, options);
  EXPECT_FALSE(answer.usable());
  const Json envelope = Json::parse(answer.json());
  EXPECT_EQ(envelope["usable"], false);
  EXPECT_EQ(envelope["unusable_because"], "nobody asked");
  EXPECT_EQ(envelope["verdict"]["judgement"], "cannot be told");
}

struct NoOptions {
  template <class Visitor>
  static void describe(Visitor&&) {}
};

TEST(CommandRow, BehaviourAJournalIsKeptAndAFolderIsNoText) {
  const Command row = command<NoOptions, TestResult>({
      .name = "keep",
      .summary = "Keeps a line",
      .description = "Adds a line to a journal.",
      .example = "strainwave keep",
      .journal = "the lines",
      .takes = Takes::nothing,
      .function =
          [](const Request& request, const NoOptions&) {
            if (!request.journal->text()) request.journal->begin("head\n");
            request.journal->append("line\n");
            request.progress.say("a line");
            return TestResult{};
          },
      .documents =
          {{Format::svg,
            [](const TestResult&, const Rendering& to) {
              return std::vector<OutputFile>{{"one.svg", "<svg/>"}, {"all.json", to.answer.json()}};
            }}},
  });
  EXPECT_TRUE(row.documents.front().folder);
  const OptionValues options(row.options);
  EXPECT_PRED2(says, test::broken_rule([&] { return run(row, nullptr, options).usable(); }),
               "journal: must be given; keep needs a journal");
  test::KeptJournal journal;
  std::string said;
  const Progress progress({}, [&](const std::string& line) { said += line; });
  for (int i = 0; i < 2; ++i) {
    const Answer answer = run(row, nullptr, options, {}, progress, {.journal = &journal});
    const std::vector<OutputFile> files = answer.files("svg");
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0].name, "one.svg");
    EXPECT_EQ(files[1].text, answer.json());
    EXPECT_PRED2(says, test::broken_rule([&] { return answer.document("svg"); }),
                 "svg of keep is a folder of files and not a text; name a folder for it");
  }
  EXPECT_EQ(journal.text(), "head\nline\nline\n");
  EXPECT_EQ(said, "a linea line");
}

TEST(CommandRow, InputARowIsFoundByItsName) {
  const std::vector<Command> table = {test_command()};
  EXPECT_EQ(&command_named(table, "double"), table.data());
  EXPECT_PRED2(says, test::broken_rule([&] { return &command_named(table, "duoble"); }),
               "did you mean double?");
  EXPECT_PRED2(says, test::broken_rule([&] { return &command_named(table, "zzzzzzzzz"); }),
               "known commands are double");
}

TEST(CommandRow, IdentityTheSchemaRequiresWhatTheCommandRequires) {
  const Command row = test_command();
  const Json schema = Json::parse(options_schema(row));
  EXPECT_EQ(schema["required"], Json::parse(R"(["name"])"));
  EXPECT_NE(options_reference(row).find("| `length` | m | how long |"), std::string::npos);
  EXPECT_NE(result_reference(row).find("| `doubled` | m | two lengths |"), std::string::npos);
}

TEST(OptionValues, IdentityACopyIsAValueOfItsOwn) {
  const Command row = test_command();
  OptionValues options(row.options);
  options.set("name", "first");
  const Answer answer = run(row, nullptr, options);
  const std::string before = answer.json();
  OptionValues other = options;
  options.set("length", "3 m");
  EXPECT_EQ(answer.json(), before);
  EXPECT_EQ(run(row, nullptr, other).json(), before);
  EXPECT_NE(run(row, nullptr, options).json(), before);
}

TEST(VerdictOf, ReferenceTheMostSevereNoteDecides) {
  const auto note = [](Severity severity, std::string text) {
    return Note{.code = "c",
                .text = std::move(text),
                .path = "p",
                .equation = {},
                .severity = severity,
                .next_step = "do"};
  };
  const Note information = note(Severity::information, "i");
  const Note care = note(Severity::care, "first");
  const Note care_too = note(Severity::care, "second");
  const Note open = note(Severity::cannot_tell, "o");
  const Note critical = note(Severity::critical, "c");
  const auto judged = [](std::vector<Note> notes) { return verdict_of("", notes); };
  EXPECT_EQ(judged({}).judgement, Judgement::good);
  EXPECT_EQ(judged({information}).judgement, Judgement::good);
  EXPECT_EQ(judged({information, care, care_too}).reason, "p: first");
  EXPECT_EQ(judged({care, open}).judgement, Judgement::cannot_be_told);
  EXPECT_EQ(judged({critical, open}).judgement, Judgement::critical);
  EXPECT_EQ(judged({critical}).next_step, "do");
  // The next step of a note does not answer the reason of an unusable result.
  const Verdict unusable = verdict_of("why", std::vector<Note>{critical});
  EXPECT_EQ(unusable.judgement, Judgement::cannot_be_told);
  EXPECT_EQ(unusable.reason, "why");
  EXPECT_PRED2(says, unusable.next_step, "change what the reason names");
}

}  // namespace
}  // namespace strainwave
