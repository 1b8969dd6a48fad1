// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "strainwave/core/quantity_text.hpp"
#include "strainwave/io/result_writer.hpp"
#include "strainwave/model/result/result_fields.hpp"

namespace strainwave {
namespace {

using Json = nlohmann::ordered_json;

/// "cracks[0].utilisation" -> "/cracks/0/utilisation"
Json::json_pointer pointer(std::string path) {
  std::string text = "/";
  for (const char c : path) {
    if (c == '.' || c == '[')
      text += '/';
    else if (c != ']')
      text += c;
  }
  return Json::json_pointer(text);
}

Json quantity_json(const Quantity& q) {
  Json json = {{"value", q.value}, {"unit", q.unit}};
  json["relative_uncertainty"] = q.relative_uncertainty ? Json(*q.relative_uncertainty) : Json();
  return json;
}

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

Json critical_json(const std::optional<CriticalSize>& critical) {
  if (!critical) return {};
  if (critical->size) return quantity_json({*critical->size, "m"});
  return {{"none", critical->text}};
}

Json state_json(const StrengthState& state) {
  Json json = {{"torque", enum_name(state.sense)},
               {"with_assembly", state.with_assembly},
               {"verdict", enum_name(state.verdict)}};
  if (!state.unknown.empty()) json["unknown"] = state.unknown;
  const auto number = [&](const char* name, const std::optional<double>& value,
                          std::string_view unit,
                          const std::optional<double>& uncertainty = std::nullopt) {
    if (value) json[name] = quantity_json({*value, unit, uncertainty});
  };
  constexpr std::string_view kIntensity = "Pa*m^0.5";
  number("K_load", state.K_load, kIntensity, state.relative_uncertainty);
  number("K_assembly", state.K_assembly, kIntensity);
  number("K", state.K, kIntensity, state.relative_uncertainty);
  number("utilisation", state.utilisation, "1", state.relative_uncertainty);
  number("L_r", state.L_r, "1");
  number("interaction", state.interaction, "1");
  number("K_r", state.K_r, "1");
  number("line", state.line, "1");
  number("reserve", state.reserve, "1");
  number("plastic_zone", state.plastic_zone, "m");
  if (state.brittle_size) json["brittle_size"] = critical_json(state.brittle_size);
  if (state.critical_size) json["critical_size"] = critical_json(state.critical_size);
  return json;
}

/// What is said of a crack's strength besides the numbers of its worst state.
Json strength_json(const CrackStrength& crack) {
  Json json = {{"verdict", enum_name(crack.verdict)},
               {"sentence", crack.sentence},
               {"size_name", crack.size_name},
               {"material", crack.material}};
  if (!crack.states.empty()) json["governing"] = crack.governing;
  json["states"] = Json::array();
  for (const StrengthState& state : crack.states) json["states"].push_back(state_json(state));
  json["notes"] = Json::array();
  for (const StrengthNote& note : crack.notes) json["notes"].push_back(note.text);
  json["equations"] = crack.equations;
  return json;
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

std::string result_json(const StiffnessResult& result, const GearSet& gear,
                        const Provenance& provenance) {
  Json json;
  json["name"] = gear.name;
  json["method"] = enum_name(result.method);
  json["usable"] = result.usable();
  if (!result.usable()) json["unusable_because"] = result.unusable_because;
  json["intact"] = Json::object();
  json["cracked"] = Json::object();
  json["cracks"] = Json::array();
  for (const CrackReport& crack : result.cracks)
    json["cracks"].push_back({{"path", crack.path},
                              {"kind", crack.kind},
                              {"opens_under", enum_name(crack.opens_under)}});
  for_each_quantity(result, [&](const std::string& path, const Quantity& q) {
    json[pointer(path)] = quantity_json(q);
  });
  // A crack of the coupled drive has no report: it stands by its path.
  for (const CrackStrength& crack : result.strength) {
    const auto report = std::ranges::find(result.cracks, crack.path, &CrackReport::path);
    if (report == result.cracks.end())
      json["cracks"].push_back(
          {{"path", crack.path}, {"kind", crack.kind}, {"strength", strength_json(crack)}});
    else
      json["cracks"][static_cast<std::size_t>(report - result.cracks.begin())]["strength"].update(
          strength_json(crack));
  }
  json["notes"] = Json::array();
  for (const Note& note : result.notes)
    json["notes"].push_back({{"code", note.code},
                             {"text", note.text},
                             {"path", note.path},
                             {"equation", note.equation}});
  json["accuracies"] = Json::array();
  for (const AccuracyBasis& basis : result.accuracies)
    json["accuracies"].push_back({{"path", basis.path},
                                  {"relative_uncertainty", basis.relative_uncertainty},
                                  {"source", basis.source}});
  json["equations"] = result.equations;
  json["provenance"] = provenance_json(gear, provenance);
  return text_of(json);
}

std::string with_provenance(const std::string& json_object, const GearSet& gear,
                            const Provenance& provenance) {
  Json json = Json::parse(json_object);
  json["provenance"] = provenance_json(gear, provenance);
  return text_of(json);
}

std::string result_csv(const StiffnessResult& result) {
  std::string csv = "path,value,unit,relative_uncertainty\n";
  for_each_quantity(result, [&](const std::string& path, const Quantity& q) {
    csv += fmt::format("{},{},{},{}\n", path, q.value, q.unit,
                       q.relative_uncertainty ? fmt::format("{}", *q.relative_uncertainty) : "");
  });
  return csv;
}

}  // namespace strainwave
