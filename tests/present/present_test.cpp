// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "strainwave/core/quantity_text.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/present/outputs_csv.hpp"
#include "strainwave/present/reference.hpp"
#include "strainwave/present/schema.hpp"

namespace strainwave {
namespace {

using Json = nlohmann::ordered_json;

struct Point {
  double x = 0.0;
  std::optional<double> gap;

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"x", "m", "place"}, &Point::x);
    field({"gap", "s", "may be absent"}, &Point::gap);
  }
};

struct Hole {
  static constexpr std::string_view kKind = "hole";
  double radius = 0.5;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"radius", "m", "of the hole"}, &Hole::radius);
  }
};

struct Plain {
  static constexpr std::string_view kKind = "plain";
  template <class Visitor>
  static void describe(Visitor&&) {}
};

struct Shown {
  double length = 0.003;
  double share = 0.25;
  double beside = 4.0;
  Quantity stiffness{2e4, "N*m/rad", 0.1};
  Quantity unknown{1.0, "N"};
  std::optional<double> absent;
  bool flag = true;
  int count = 3;
  std::string text = "word";
  std::vector<Point> table = {{1.0, 2.0}, {3.0, {}}};
  std::vector<std::string> names = {"a", "b"};
  std::map<std::string, Hole> holes = {{"one", {}}};
  std::variant<Hole, Plain> either = Plain{};
  double detail = 5.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using S = Shown;
    field({"length", "m", "a length"}, &S::length);
    field({"share", "1", "a share"}, &S::share);
    field({"beside", kUnitBeside, "in a unit beside"}, &S::beside);
    field({"stiffness", "N*m/rad", "with uncertainty"}, &S::stiffness);
    field({"unknown", "N", "without uncertainty"}, &S::unknown);
    field({"absent", "m", "absent"}, &S::absent);
    field({"flag", "", "a flag"}, &S::flag);
    field({.name = "count", .unit = "", .doc = "a count", .range = {.lower = 0, .upper = 9}},
          &S::count);
    field({"text", "", "a text"}, &S::text);
    field({"table", "", "a table"}, &S::table);
    field({"names", "", "names"}, &S::names);
    field({"holes", "", "by name"}, &S::holes);
    field({"either", "", "one of two"}, &S::either);
    field({.name = "detail", .unit = "m", .doc = "detail", .detail = true}, &S::detail);
  }
};

TEST(JsonWriterTest, ReferenceEveryKindHasItsForm) {
  EXPECT_EQ(Json::parse(json_of(Shown{})), Json::parse(R"({
    "length": {"value": 0.003, "unit": "m"},
    "share": {"value": 0.25, "unit": "1"},
    "beside": 4.0,
    "stiffness": {"value": 20000.0, "unit": "N*m/rad", "relative_uncertainty": 0.1},
    "unknown": {"value": 1.0, "unit": "N", "relative_uncertainty": null},
    "flag": true, "count": 3, "text": "word",
    "table": {"x": {"unit": "m", "values": [1.0, 3.0]},
              "gap": {"unit": "s", "values": [2.0, null]}},
    "names": ["a", "b"],
    "holes": {"one": {"radius": {"value": 0.5, "unit": "m"}}},
    "either": {"kind": "plain"},
    "detail": {"value": 5.0, "unit": "m"}})"));
}

TEST(JsonWriterTest, InputBytesOfAnyKindMakeAValidDocument) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text = std::string("a") + static_cast<char>(byte) + "b";
    const Json read = Json::parse(json_of(text));
    if (byte < 0x80)
      EXPECT_EQ(read.get<std::string>(), text);
    else  // one byte of a longer character: replaced
      EXPECT_EQ(read.get<std::string>(),
                "a\xEF\xBF\xBD"
                "b")
          << byte;
  }
  EXPECT_EQ(Json::parse(json_of(std::string("\xC3\xA9\"\\\n"))).get<std::string>(),
            "\xC3\xA9\"\\\n");
  const std::map<std::string, Hole> odd = {{"quote \" and \xFF", {}}};
  EXPECT_EQ(Json::parse(json_of(odd)).begin().key(), "quote \" and \xEF\xBF\xBD");
}

TEST(JsonWriterTest, LimitWhatJsonHasNoNumberForIsNull) {
  for (const double odd :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    Shown shown;
    shown.length = odd;
    shown.stiffness = {odd, "N*m/rad", odd};
    shown.table[0].x = odd;
    const Json read = Json::parse(json_of(shown));
    EXPECT_TRUE(read["length"]["value"].is_null());
    EXPECT_TRUE(read["stiffness"]["value"].is_null());
    EXPECT_TRUE(read["stiffness"]["relative_uncertainty"].is_null());
    EXPECT_TRUE(read["table"]["x"]["values"][0].is_null());
  }
}

TEST(JsonWriterTest, IdentityNumbersAsInputAreReadBackToTheLastBit) {
  for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -2.5e-7, 0.0}) {
    Shown shown;
    shown.length = value;
    shown.share = value;
    const Json read = Json::parse(json_of(shown, JsonNumbers::as_input));
    EXPECT_EQ(parse_quantity("length", read["length"].get<std::string>(), "m"), value);
    EXPECT_EQ(read["share"].get<double>(), value);
  }
}

TEST(Schema, ReferenceOfResultTellsRequiredFieldsUnitsAndAlternatives) {
  const Json schema = Json::parse(schema_of(visit_type<Shown>, SchemaOf::result));
  const Json& of = schema["properties"];
  EXPECT_EQ(schema["type"], "object");
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(of.size(), 14U);
  EXPECT_EQ(schema["required"].size(), 13U) << "all but the optional one";
  EXPECT_EQ(of["length"]["properties"]["unit"]["const"], "m");
  EXPECT_EQ(of["length"]["description"], "a length");
  EXPECT_EQ(of["beside"]["type"], Json::parse(R"(["number", "null"])"));
  EXPECT_EQ(of["stiffness"]["required"],
            Json::parse(R"(["value", "unit", "relative_uncertainty"])"));
  EXPECT_EQ(of["count"]["minimum"], 0);
  EXPECT_EQ(of["count"]["maximum"], 9);
  EXPECT_EQ(of["table"]["properties"]["gap"]["properties"]["unit"]["const"], "s");
  EXPECT_EQ(of["names"]["items"]["type"], "string");
  EXPECT_EQ(of["holes"]["additionalProperties"]["properties"].size(), 1U);
  ASSERT_EQ(of["either"]["oneOf"].size(), 2U);
  EXPECT_EQ(of["either"]["oneOf"][1]["properties"]["kind"]["const"], "plain");
}

TEST(Schema, ReferenceOfOptionsHasBareNumbers) {
  const Json of = Json::parse(schema_of(visit_type<Shown>, SchemaOf::options))["properties"];
  EXPECT_EQ(of["length"]["type"], "string");
  EXPECT_EQ(of["share"]["type"], "number");
}

TEST(FieldsReference, ReferenceOneLineForEachField) {
  const std::string table = fields_reference(visit_type<Shown>);
  for (const char* const line :
       {"| `length` | m | a length |\n",
        "| `beside` | as the field `unit` says | in a unit beside |\n",
        "| `stiffness` | N*m/rad | with uncertainty; with its uncertainty |\n",
        "| `flag` |  | a flag; true or false |\n", "| `count` |  | a count; whole number |\n",
        "| `table.gap` | s | may be absent; one value for each element |\n",
        "| `names[]` |  | names |\n", "| `holes.<name>.radius` | m | of the hole |\n",
        "| `either.kind` | | \"plain\", with: |\n", "| `either.radius` | m | of the hole |\n",
        "| `detail` | m | detail |\n"})
    EXPECT_NE(table.find(line), std::string::npos) << line << table;
}

TEST(OutputsCsv, ReferenceOneLineForEachNumberThatIsAnOutput) {
  EXPECT_EQ(outputs_csv(Shown{}),
            "path,value,unit,relative_uncertainty\n"
            "length,0.003,m,\n"
            "share,0.25,1,\n"
            "beside,4,*,\n"
            "stiffness,20000,N*m/rad,0.1\n"
            "unknown,1,N,\n"
            "holes.one.radius,0.5,m,\n");
}

}  // namespace
}  // namespace strainwave
