// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "strainwave/core/quantity_text.hpp"
#include "strainwave/io/result_writer.hpp"

namespace strainwave {
namespace {

using Json = nlohmann::ordered_json;

/// The input as it was understood: numbers with their SI unit, in the form that the reader accepts.
template <class T>
Json echo(const T& value, const Field& field) {
  if constexpr (std::is_same_v<T, double>) {
    return field.unit == "1" ? Json(value) : Json(quantity_text(value, field.unit));
  } else if constexpr (std::is_enum_v<T>) {
    return enum_name(value);
  } else if constexpr (is_optional<T>) {
    return value ? echo(*value, field) : Json();
  } else if constexpr (is_vector<T> || is_pair_of_numbers<T>) {
    Json json = Json::array();
    for (const auto& element : value) json.push_back(echo(element, field));
    return json;
  } else if constexpr (is_string_map<T>) {
    Json json = Json::object();
    for (const auto& [name, element] : value) json[name] = echo(element, field);
    return json;
  } else if constexpr (is_variant<T>) {
    return std::visit(
        [&](const auto& alternative) {
          Json json = {{"kind", std::decay_t<decltype(alternative)>::kKind}};
          json.update(echo(alternative, field));
          return json;
        },
        value);
  } else if constexpr (Described<T>) {
    Json json = Json::object();
    T::describe([&](const Field& inner, auto member) {
      Json entry = echo(value.*member, inner);
      if (!entry.is_null()) json[std::string(inner.name)] = std::move(entry);
    });
    return json;
  } else {
    return value;
  }
}

Json provenance_json(const GearSet& gear, const Provenance& provenance) {
  return {{"program", "strainwave"},
          {"version", provenance.version},
          {"revision", provenance.revision},
          {"input_file", provenance.input_file},
          {"options", {{"quadrature_tolerance", provenance.quadrature_tolerance}}},
          {"input", echo(gear, Field{})}};
}

/// Text from a file may be any bytes; JSON must be UTF-8.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string with_provenance(const std::string& json_object, const GearSet& gear,
                            const Provenance& provenance) {
  Json json = Json::parse(json_object);
  json["provenance"] = provenance_json(gear, provenance);
  return text_of(json);
}

}  // namespace strainwave
