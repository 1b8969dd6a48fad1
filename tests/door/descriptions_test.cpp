// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "door/answers.hpp"
#include "door/json_schema.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/study/scatter.hpp"

namespace strainwave {
namespace {

using test::Json;

/// Holds every field of a type to a unit that can be read and to a line that says what it is.
class FieldWitness : public TypeVisitor {
 public:
  void begin_record() override { open_.emplace_back(); }
  /// The unit may stand in a record further out: one unit for all rows.
  void end_record() override {
    const bool open = open_.back().beside && !open_.back().unit;
    open_.pop_back();
    if (open_.empty()) {
      EXPECT_FALSE(open) << field_.name << ": a number in a unit beside, and no field `unit`";
    } else {
      open_.back().beside = open_.back().beside || open;
    }
  }
  void field(const Field& field, Presence) override {
    field_ = field;
    ++n_fields;
    EXPECT_FALSE(field.doc.empty()) << field.name;
    EXPECT_EQ(field.doc.find('\n'), std::string_view::npos) << field.name;
    if (field.name == "unit" && !open_.empty()) open_.back().unit = true;
  }
  void begin_list() override {}
  void end_list() override {}
  void begin_map() override {}
  void end_map() override {}
  void begin_alternatives() override {}
  void end_alternatives() override {}
  void kind(std::string_view) override {}
  /// A column of words has no unit; UnitWitness sees the numbers of a column without one.
  void column(const Field& field) override {
    if (!field.unit.empty()) number(field);
  }
  void number(const Field& field) override {
    if (field.unit == kUnitBeside)
      open_.back().beside = true;
    else
      expect_unit(field);
  }
  void quantity(const Field& field) override {
    if (field.unit != kUnitBeside) expect_unit(field);
  }
  void whole(const Field& field) override { EXPECT_TRUE(field.unit.empty()) << field.name; }
  void flag() override { EXPECT_TRUE(field_.unit.empty()) << field_.name; }
  void text() override { EXPECT_TRUE(field_.unit.empty()) << field_.name; }
  void choice(std::span<const std::string_view>) override {
    EXPECT_TRUE(field_.unit.empty()) << field_.name;
  }

  int n_fields = 0;

 private:
  struct Open {
    bool beside = false;
    bool unit = false;
  };
  static void expect_unit(const Field& field) {
    EXPECT_FALSE(field.unit.empty()) << field.name;
    EXPECT_NO_THROW((void)parse_unit(field.unit)) << field.name << " " << field.unit;
  }
  Field field_{};
  std::vector<Open> open_;
};

TEST(Descriptions, IdentityEveryPublicNumberHasAUnitAndEveryFieldALine) {
  int n_fields = 0;
  for (const Command& row : commands())
    for (const auto& walk : {row.walk, row.options.walk}) {
      SCOPED_TRACE(row.name);
      FieldWitness witness;
      walk({}, witness);
      n_fields += witness.n_fields;
    }
  EXPECT_GT(n_fields, 300);
}

TEST(Descriptions, IdentityEveryRowSaysWhatItIs) {
  std::set<std::string_view> names;
  for (const Command& row : commands()) {
    SCOPED_TRACE(row.name);
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_FALSE(row.summary.empty());
    EXPECT_GT(row.description.size(), row.summary.size());
    EXPECT_TRUE(row.example.starts_with("strainwave " + std::string(row.name)));
    ASSERT_FALSE(row.documents.empty());
    EXPECT_TRUE(row.documents.front().option.empty());
    for (const Document& document : row.documents)
      EXPECT_EQ(document.option.empty(), document.doc.empty()) << document.name;
  }
}

std::string json_of_options(const Command& row, const void* options) {
  JsonWriter writer(JsonNumbers::as_input);
  row.options.visit(options, writer);
  return writer.document();
}

TEST(Descriptions, IdentityAFallbackIsTheDefaultOfItsMember) {
  int n_fallbacks = 0;
  for (const Command& row : commands()) {
    const OptionValues untouched(row.options);
    const Json defaults = Json::parse(json_of_options(row, untouched.get()));
    for (const Option& option : row.options.options) {
      SCOPED_TRACE(std::string(row.name) + " " + std::string(option.field.name));
      const std::string name(option.field.name);
      if (option.field.fallback.empty() || !defaults.contains(name)) continue;
      OptionValues set(row.options);
      set.set(name, option.field.fallback);
      EXPECT_EQ(json_of_options(row, set.get()), json_of_options(row, untouched.get()));
      ++n_fallbacks;
    }
  }
  EXPECT_GE(n_fallbacks, 10);
}

TEST(Descriptions, IdentityFallbacksOfTheScatterAreThoseOfTheStudy) {
  const Command& row = command_named(commands(), "sensitivity");
  OptionValues set(row.options);
  for (const Option& option : row.options.options)
    if (!option.field.fallback.empty()) set.set(option.field.name, option.field.fallback);
  const Json values = Json::parse(json_of_options(row, set.get()));
  EXPECT_EQ(values["samples"], ScatterOptions{}.samples);
  EXPECT_EQ(values["seed"], ScatterOptions{}.seed);
  EXPECT_EQ(values["threads"], ScatterOptions{}.threads);
}

TEST(Descriptions, IdentityTheSchemaRequiresTheOptionsThatTheCommandRequires) {
  for (const Command& row : commands()) {
    std::vector<std::string_view> required;
    for (const Option& option : row.options.options)
      if (option.required) required.push_back(option.field.name);
    EXPECT_EQ(Json::parse(options_schema(row))["required"], Json(required)) << row.name;
  }
}

}  // namespace
}  // namespace strainwave
