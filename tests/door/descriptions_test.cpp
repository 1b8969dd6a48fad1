// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "command/field_witness.hpp"
#include "door/answers.hpp"
#include "door/json_schema.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/study/scatter.hpp"

namespace strainwave {
namespace {

using test::Json;

TEST(Descriptions, IdentityEveryPublicNumberHasAUnitAndEveryFieldALine) {
  int n_fields = 0;
  for (const Command& row : commands())
    for (const auto& walk : {row.walk, row.options.walk}) {
      SCOPED_TRACE(row.name);
      test::FieldWitness witness;
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
