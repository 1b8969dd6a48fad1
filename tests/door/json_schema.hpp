// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace strainwave::test {

using Json = nlohmann::ordered_json;

inline bool has_json_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "number") return value.is_number();
  if (type == "integer")
    return value.is_number() && value.get<double>() == std::floor(value.get<double>());
  throw std::runtime_error("no type of JSON Schema: " + type);
}

/// Places at which a value breaks a schema, one line each; empty if it is valid.
/// @throws std::runtime_error  if the schema has a keyword that this reader does not support
inline std::vector<std::string> schema_faults(const Json& schema, const Json& value,
                                              const std::string& path = "") {
  std::vector<std::string> faults;
  const auto fault = [&](const std::string& what) { faults.push_back(path + ": " + what); };
  const auto go_on = [&](const Json& inner, const Json& part, const std::string& step) {
    for (std::string& deeper : schema_faults(inner, part, path + step))
      faults.push_back(std::move(deeper));
  };
  for (const auto& [keyword, rule] : schema.items()) {
    if (keyword == "$schema" || keyword == "title" || keyword == "description") continue;
    if (keyword == "type") {
      const std::vector<std::string> types = rule.is_array() ? rule.get<std::vector<std::string>>()
                                                             : std::vector{rule.get<std::string>()};
      if (std::ranges::none_of(types, [&](const auto& type) { return has_json_type(value, type); }))
        fault("is no " + rule.dump());
    } else if (keyword == "const") {
      if (value != rule) fault("is not " + rule.dump());
    } else if (keyword == "enum") {
      if (std::ranges::find(rule, value) == rule.end()) fault("is none of " + rule.dump());
    } else if (keyword == "minimum") {
      if (value.is_number() && value < rule) fault("is below " + rule.dump());
    } else if (keyword == "maximum") {
      if (value.is_number() && value > rule) fault("is above " + rule.dump());
    } else if (keyword == "required") {
      for (const std::string name : rule)
        if (!value.contains(name)) fault("lacks " + name);
    } else if (keyword == "properties") {
      for (const auto& [name, inner] : rule.items())
        if (value.contains(name)) go_on(inner, value[name], "." + name);
    } else if (keyword == "additionalProperties") {
      if (!value.is_object()) continue;
      const Json known = schema.value("properties", Json::object());
      for (const auto& [name, part] : value.items()) {
        if (known.contains(name)) continue;
        if (rule.is_boolean() && !rule.get<bool>())
          fault("has " + name + " beside what is described");
        else if (rule.is_object())
          go_on(rule, part, "." + name);
      }
    } else if (keyword == "items") {
      for (std::size_t i = 0; i < value.size(); ++i)
        go_on(rule, value[i], "[" + std::to_string(i) + "]");
    } else if (keyword == "oneOf") {
      if (std::ranges::count_if(
              rule, [&](const Json& one) { return schema_faults(one, value, path).empty(); }) != 1)
        fault("keeps not exactly one of the alternatives");
    } else {
      throw std::runtime_error("a keyword of JSON Schema that is not read here: " + keyword);
    }
  }
  return faults;
}

}  // namespace strainwave::test
