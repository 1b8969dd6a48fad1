// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/schema.hpp"

#include <nlohmann/json.hpp>
#include <vector>

namespace strainwave {
namespace {

using Json = nlohmann::ordered_json;

/// Builds a schema from the inside out: the schema of the innermost type is completed first.
class SchemaWriter : public TypeVisitor {
 public:
  explicit SchemaWriter(SchemaOf what) : what_(what) {}
  [[nodiscard]] const Json& schema() const { return done_; }

  void begin_record() override {
    open_.push_back({{"type", "object"},
                     {"properties", Json::object()},
                     {"required", Json::array()},
                     {"additionalProperties", false}});
    fields_.emplace_back();
  }
  void end_record() override {
    fields_.pop_back();
    close();
  }
  void field(const Field& field, Presence presence) override {
    fields_.back() = field;
    // The command determines which options are required; flags and lists may always be left out.
    if (what_ == SchemaOf::result && presence == Presence::always)
      open_.back()["required"].push_back(field.name);
  }
  void begin_list() override { open_.push_back({{"type", "array"}}); }
  void end_list() override { close(); }
  void begin_map() override { open_.push_back({{"type", "object"}}); }
  void end_map() override { close(); }
  void begin_alternatives() override { open_.push_back({{"oneOf", Json::array()}}); }
  void end_alternatives() override { close(); }
  void kind(std::string_view kind) override {
    open_.back()["properties"]["kind"] = {{"const", kind}};
    open_.back()["required"].push_back("kind");
  }
  void column(const Field& field) override {
    if (what_ == SchemaOf::options) {
      place({{"type", "array"},
             {"items", {{"type", field.unit == "1" ? Json("number") : Json("string")}}}});
      return;
    }
    Json properties = Json::object();
    if (!field.unit.empty() && field.unit != kUnitBeside)
      properties["unit"] = {{"const", field.unit}};
    properties["values"] = {{"type", "array"}};
    Json required = Json::array();
    for (const auto& [name, value] : properties.items()) required.push_back(name);
    place({{"type", "object"},
           {"properties", std::move(properties)},
           {"required", std::move(required)},
           {"additionalProperties", false}});
  }
  void number(const Field& field) override {
    if (field.unit == kUnitBeside)
      place({{"type", {"number", "null"}}});
    else if (what_ == SchemaOf::options)
      place({{"type", field.unit == "1" ? Json("number") : Json("string")}});
    else
      place(quantity_schema(field, Json::array({"value", "unit"})));
  }
  void quantity(const Field& field) override {
    Json schema = quantity_schema(field, Json::array({"value", "unit", "relative_uncertainty"}));
    schema["properties"]["relative_uncertainty"] = {{"type", {"number", "null"}}};
    place(std::move(schema));
  }
  void whole(const Field& field) override {
    Json schema = {{"type", "integer"}};
    if (field.range.lower > -1e300) schema["minimum"] = static_cast<long long>(field.range.lower);
    if (field.range.upper < 1e300) schema["maximum"] = static_cast<long long>(field.range.upper);
    place(std::move(schema));
  }
  void flag() override { place({{"type", "boolean"}}); }
  void text() override { place({{"type", "string"}}); }
  void choice(std::span<const std::string_view> names) override { place({{"enum", names}}); }

 private:
  [[nodiscard]] static Json quantity_schema(const Field& field, Json required) {
    const Json unit =
        field.unit == kUnitBeside ? Json({{"type", "string"}}) : Json({{"const", field.unit}});
    return {{"type", "object"},
            {"properties", {{"value", {{"type", {"number", "null"}}}}, {"unit", unit}}},
            {"required", std::move(required)},
            {"additionalProperties", false}};
  }
  void close() {
    Json schema = std::move(open_.back());
    open_.pop_back();
    place(std::move(schema));
  }
  /// Inserts a schema into the innermost open schema.
  void place(Json schema) {
    if (open_.empty()) {
      done_ = std::move(schema);
      return;
    }
    Json& outer = open_.back();
    if (outer.contains("oneOf")) {
      outer["oneOf"].push_back(std::move(schema));
    } else if (outer["type"] == "array") {
      outer["items"] = std::move(schema);
    } else if (!outer.contains("properties")) {
      outer["additionalProperties"] = std::move(schema);
    } else {
      const Field& field = fields_.back();
      if (!field.doc.empty()) schema["description"] = field.doc;
      outer["properties"][std::string(field.name)] = std::move(schema);
    }
  }

  SchemaOf what_;
  std::vector<Json> open_;
  std::vector<Field> fields_;  // for each open record, the field whose type comes next
  Json done_;
};

}  // namespace

std::string schema_of(TypeWalk walk, SchemaOf what) {
  SchemaWriter writer(what);
  walk({}, writer);
  return writer.schema().dump(2);
}

}  // namespace strainwave
