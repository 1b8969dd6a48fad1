// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "commands/method_option.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/model/input/method.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {

Command stiffness_command();

/// How a difference compares with its uncertainty.
enum class Standing { beyond, within, not_stated, same };
template <>
struct EnumNames<Standing> {
  static constexpr std::array<std::string_view, 4> names = {"beyond", "within", "not stated",
                                                            "same"};
};

namespace {

using Json = nlohmann::ordered_json;

struct DiffOptions {
  std::string first;
  std::string second;
  Method method = Method::corrected;
  double coverage = 1.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "first",
           .unit = "",
           .doc = "a drive, or a result that --format json wrote",
           .positional = true,
           .names = "attachment"},
          &DiffOptions::first);
    field({.name = "second",
           .unit = "",
           .doc = "a drive or a result to compare with the first",
           .positional = true,
           .names = "attachment"},
          &DiffOptions::second);
    field(kMethodOption, &DiffOptions::method);
    field({.name = "coverage",
           .unit = "1",
           .doc = "number of standard uncertainties that a difference must exceed",
           .range = kPositive,
           .fallback = "1"},
          &DiffOptions::coverage);
  }
};

/// A value with its unit, which the difference keeps.
struct Output {
  double value = 0.0;
  std::string unit;
  std::optional<double> relative_uncertainty;
};
using Outputs = std::map<std::string, Output>;
using Inputs = std::map<std::string, std::string>;  // text by path

/// One of the two that are compared.
struct Side {
  std::string command;
  std::string unusable_because;
  Inputs inputs;
  Outputs outputs;
  std::vector<std::string> order;  // of the outputs
  double left_out = 0.0;           // lambda_l over the sound sum (ST-18)
  Inputs tables;  // contents of the tables, by path of the field; empty for a result
};

/// Whether a field names a table beside the file.
bool names_table(std::string_view path) {
  return path.ends_with(".compliance_table") || path.ends_with(".turn_table") ||
         path.ends_with(".error_table");
}

void read_inputs(const Json& value, const std::string& path, Inputs& to) {
  if (value.is_object()) {
    for (const auto& [name, member] : value.items())
      read_inputs(member, path.empty() ? name : fmt::format("{}.{}", path, name), to);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      read_inputs(value[i], fmt::format("{}[{}]", path, i), to);
  } else {
    to[path] = value.is_string() ? value.get<std::string>() : value.dump();
  }
}

/// The path of an element of a list: the path that the element states, or its index.  The torque
/// names a state of a crack, so that states under the same load are compared.
std::string element_path(const Json& element, const std::string& list, std::size_t index) {
  if (element.is_object() && element.contains("path")) return element["path"];
  if (element.is_object() && element.contains("torque") && element.contains("with_assembly"))
    return fmt::format(
        "{}[{}, {}]", list,
        words_of(element["torque"] == enum_name(TorqueSense::negative) ? TorqueSense::negative
                                                                       : TorqueSense::positive),
        element["with_assembly"] == true ? "with the assembly" : "load alone");
  return fmt::format("{}[{}]", list, index);
}

/// The numbers of a result that stand in no column, named as for_each_quantity names them.
void read_outputs(const Json& value, const std::string& path, Side& to) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      read_outputs(value[i], element_path(value[i], path, i), to);
    }
  } else if (value.is_object() && value.contains("value") && value.contains("unit")) {
    if (!value["value"].is_number()) return;
    const auto u = value.find("relative_uncertainty");
    const bool stated = u != value.end() && u->is_number();
    to.outputs[path] = {.value = value["value"],
                        .unit = value["unit"],
                        .relative_uncertainty = stated ? std::optional<double>(*u) : std::nullopt};
    to.order.push_back(path);
  } else if (value.is_object()) {
    for (const auto& [name, member] : value.items())
      read_outputs(member, path.empty() ? name : fmt::format("{}.{}", path, name), to);
  }
}

Side side_of_result(const std::string& text, const std::string& name) {
  const Json document = Json::parse(text, nullptr, false);
  try {
    if (document.at("format") != "strainwave-result/1") throw InputError(name, "another format");
    Side side{.command = document.at("command"),
              .unusable_because = document.at("unusable_because"),
              .inputs = {},
              .outputs = {},
              .order = {},
              .left_out = 0.0,
              .tables = {}};
    if (const auto input = document.at("provenance").find("input");
        input != document.at("provenance").end())
      read_inputs(*input, "", side.inputs);
    read_outputs(document.at("result"), "", side);
    for (const Json& basis : document.at("accuracies"))
      if (basis.at("path") == "total") side.left_out = basis.at("relative_uncertainty").at("value");
    return side;
  } catch (const Json::exception&) {
  } catch (const InputError&) {
  }
  throw InputError(name,
                   "is neither a drive nor a result; strainwave stiffness FILE --format json "
                   "--output RESULT writes a result");
}

Side side_of(const std::string& name, Method method, const Request& request) {
  const auto given = request.texts.find(name);
  if (given == request.texts.end()) throw OptionError(name, "the text of this file is missing");
  const std::string& text = given->second;
  if (text.find_first_not_of(" \t\r\n") != std::string::npos &&
      std::string_view("{<").find(text[text.find_first_not_of(" \t\r\n")]) !=
          std::string_view::npos)
    return side_of_result(text, name);
  static const Command stiffness = stiffness_command();
  OptionValues options(stiffness.options);
  options.set("method", enum_name(method));
  const Attachments beside = request.beside(name);
  Side side = side_of_result(run(stiffness, read_drive(text, name, beside), options).json(), name);
  for (const auto& [path, file] : side.inputs)
    if (names_table(path)) side.tables[path] = beside.text(file, path);
  return side;
}

/// What two texts say of one input.
struct InputDifference {
  std::string path;
  std::string first;  ///< empty if absent
  std::string second;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"path", "", "field of the input"}, &InputDifference::path);
    field({"first", "", "value in the first; empty if absent"}, &InputDifference::first);
    field({"second", "", "value in the second; empty if absent"}, &InputDifference::second);
  }
};

/// An output of both sides.
struct OutputDifference {
  std::string path;
  std::string unit;
  double first = 0.0;
  double second = 0.0;
  double difference = 0.0;            ///< second - first
  std::optional<double> uncertainty;  ///< one standard, of the difference; absent: not stated
  Standing standing = Standing::same;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using D = OutputDifference;
    field({"output", "", "name of the output"}, &D::path);
    field({"unit", "", "of the numbers"}, &D::unit);
    field({"first", kUnitBeside, "of the first"}, &D::first);
    field({"second", kUnitBeside, "of the second"}, &D::second);
    field({"difference", kUnitBeside, "second less first"}, &D::difference);
    field({"uncertainty", kUnitBeside, "one standard uncertainty of the difference"},
          &D::uncertainty);
    field({"standing", "", "whether the difference is beyond its uncertainty"}, &D::standing);
  }
};

struct Difference {
  std::string first;
  std::string second;
  double coverage = 1.0;
  std::vector<InputDifference> inputs;
  std::vector<OutputDifference> stiffness;  ///< K1, K2, K3 and wind-up, even if they are the same
  std::vector<OutputDifference> outputs;    ///< beyond the uncertainty of their difference
  std::vector<OutputDifference> within;     ///< others that differ
  std::vector<OutputDifference> unstated;   ///< outputs that differ without a stated uncertainty
  std::vector<std::string> only_first;
  std::vector<std::string> only_second;
  std::size_t equal = 0;
  std::string unusable_because;
  std::vector<std::string> equations = {"ST-19", "ST-20"};

  template <class Visitor>
  static void describe(Visitor&& field) {
    using D = Difference;
    field({"first", "", "a drive or a result"}, &D::first);
    field({"second", "", "a drive or a result that is compared with the first"}, &D::second);
    field({"coverage", "1", "number of standard uncertainties that a difference must exceed"},
          &D::coverage);
    field({"inputs", "", "inputs that differ"}, &D::inputs);
    field({"stiffness", "",
           "K1, K2, K3 and wind-up for both senses of torque, even if they are the same"},
          &D::stiffness);
    field({"outputs", "", "outputs that differ by more than the uncertainty of their difference"},
          &D::outputs);
    field({"within_uncertainty", "", "outputs that differ by less"}, &D::within);
    field({"uncertainty_not_stated", "", "outputs that differ without a stated uncertainty"},
          &D::unstated);
    field({"only_first", "", "outputs that exist only in the first"}, &D::only_first);
    field({"only_second", "", "outputs that exist only in the second"}, &D::only_second);
    field({"equal", "", "number of outputs that are the same"}, &D::equal);
  }
};

constexpr std::array<std::string_view, 3> kMembers = {"wave_generator", "flexspline",
                                                      "output_shaft"};
/// The parts that have equal shares in the error of the coupled drive (ST-20).
constexpr std::array<std::string_view, 4> kCoupledParts = {"wave_generator", "flexspline.rim",
                                                           "mesh", "circular_spline"};
/// Fields of the flexspline that stand in series with the rim (TC-13).
constexpr std::array<std::string_view, 4> kInSeries = {"barrel", "diaphragm", "boss",
                                                       "flange_compliance"};
constexpr std::array<std::string_view, 3> kDrives = {"intact", "cracked.positive",
                                                     "cracked.negative"};

/// Which parts of two drives are the same, by the inputs that differ.
class SameParts {
 public:
  SameParts(const Side& first, const Side& second, const std::vector<InputDifference>& differing) {
    std::set<std::string> materials;
    for (const InputDifference& input : differing) {
      const std::string& path = input.path;
      const bool says_nothing = path == "name" || path == "format" || path.starts_with("scatter") ||
                                path.starts_with("range") || path.starts_with("article.") ||
                                path.starts_with("rating.") || path.starts_with("tolerance.");
      if (says_nothing || enters_no_model(path)) continue;
      const std::string table = path.substr(0, path.find('.'));
      if (path.starts_with(fmt::format("{}.crack[", table))) {
        changed_.insert(path.substr(0, path.find(']') + 1));
        cracks_ = false;
        continue;
      }
      body_ = false;
      if (table == "material")
        materials.insert(path.substr(9, path.rfind('.') - 9));
      else if (std::ranges::find(kMembers, table) != kMembers.end() || table == "mesh" ||
               table == "circular_spline")
        change(table, path);
      else if (table == "load")  // changes only the sum
        sum_changed_ = true;
      else
        all_changed_ = true;
    }
    for (const std::string table :
         {"wave_generator", "flexspline", "output_shaft", "circular_spline"})
      for (const Side* const side : {&first, &second})
        if (const auto used = side->inputs.find(table + ".material");
            used != side->inputs.end() && materials.contains(used->second))
          change(table, table + ".material");
  }

  /// @param part  a member, or a crack of one
  [[nodiscard]] bool same(const std::string& part) const {
    return !sum_changed_ && same_in_coupled_drive(part) &&
           !changed_.contains(part.substr(0, part.find('.')));
  }
  [[nodiscard]] bool same_in_coupled_drive(const std::string& part) const {
    return !all_changed_ && !changed_.contains(part);
  }
  /// Whether at most cracks differ.
  [[nodiscard]] bool same_body() const { return body_; }
  [[nodiscard]] bool same_cracks() const { return cracks_; }

 private:
  /// Whether no model with a stated error depends on a field: neither K, wind-up and stress
  /// intensities nor their errors change with the limits of a material, which only divide a stress
  /// intensity, and with the friction, which only the hysteresis contains.
  static bool enters_no_model(const std::string& path) {
    constexpr std::array<std::string_view, 4> kLimits = {".fracture_toughness", ".fracture_energy",
                                                         ".yield_strength", ".ultimate_strength"};
    constexpr std::array<std::string_view, 3> kFriction = {
        "mesh.friction_coefficient", "wave_generator.bearing.rolling_friction",
        "wave_generator.bearing.outer_ring.friction_coefficient"};
    return std::ranges::find(kFriction, path) != kFriction.end() ||
           (path.starts_with("material.") &&
            std::ranges::any_of(kLimits,
                                [&](std::string_view limit) { return path.ends_with(limit); }));
  }
  /// Records that a field of a part of the drive differs.
  void change(const std::string& table, const std::string& path) {
    changed_.insert(table);
    const auto is_of = [&](std::string_view field) {
      return path.starts_with(fmt::format("flexspline.{}", field));
    };
    if (table == "flexspline" && std::ranges::none_of(kInSeries, is_of))
      changed_.insert("flexspline.rim");
  }

  std::set<std::string> changed_;  // members, other parts and cracks
  bool sum_changed_ = false;
  bool all_changed_ = false;
  bool body_ = true;
  bool cracks_ = true;
};

/// How the error of each part, relative to its compliance, moves an output: by part.
using Slopes = std::map<std::string, double>;

/// Compliances of members and cracks with their uncertainties, of one sense of torque.
struct Parts {
  std::map<std::string, Output> sound;
  std::map<std::string, Output> added;
  double total = 0.0;
};

Parts parts_of(const Side& side, std::string_view drive) {
  Parts parts;
  for (const std::string_view member : kMembers)
    if (const auto found = side.outputs.find(fmt::format("intact.compliance.{}", member));
        found != side.outputs.end())
      parts.sound[std::string(member)] = found->second;
  const std::string sense(drive.substr(drive.find('.') + 1));
  const std::string ending = fmt::format(".added_compliance.{}.at_output", sense);
  if (drive != "intact")
    for (const auto& [path, output] : side.outputs)
      if (path.ends_with(ending)) parts.added[path.substr(0, path.size() - ending.size())] = output;
  for (const auto* const group : {&parts.sound, &parts.added})
    for (const auto& [part, output] : *group) parts.total += output.value;
  return parts;
}

/// The slopes of an output of the series model (ST-19); empty for any other output.
Slopes slopes_of(const Side& side, const std::string& path) {
  Slopes slopes;
  for (const std::string_view drive : kDrives) {
    if (!path.starts_with(std::string(drive) + ".")) continue;
    const std::string_view output = std::string_view(path).substr(drive.size() + 1);
    const Parts parts = parts_of(side, drive);
    const double y = side.outputs.at(path).value;
    double sound = 0.0;
    for (const auto& [part, of] : parts.sound) sound += of.value;
    const auto each = [&](const auto& slope) {
      for (const auto& [part, of] : parts.sound) slopes[part] = slope(part, of.value, false);
      for (const auto& [part, of] : parts.added) slopes[part] = slope(part, of.value, true);
    };
    if (output == "stiffness")
      each([&](const std::string&, double c, bool) { return -y * c / parts.total; });
    else if (output == "wind_up" || output == "compliance.total")
      each([&](const std::string&, double c, bool) { return y * c / parts.total; });
    else if (output == "stiffness_change")
      // Of sound/total - 1.
      each([&](const std::string&, double c, bool crack) {
        return (crack ? 0.0 : c / parts.total) - sound * c / (parts.total * parts.total);
      });
    else if (output.starts_with("compliance."))
      each([&](const std::string& part, double c, bool) {
        return part.substr(0, part.find('.')) == output.substr(11) ? c : 0.0;
      });
  }
  return slopes;
}

std::optional<double> part_uncertainty(const Side& side, const std::string& path,
                                       const std::string& part) {
  const std::string_view sense = path.starts_with("cracked.negative") ? "negative" : "positive";
  const auto found =
      side.outputs.find(part.find('.') == std::string::npos
                            ? fmt::format("intact.compliance.{}", part)
                            : fmt::format("{}.added_compliance.{}.at_output", part, sense));
  return found != side.outputs.end() ? found->second.relative_uncertainty : std::nullopt;
}

/// The values of an output of the sum in the coupled drive, which contains what the sum leaves out
/// (ST-18).
struct InDrive {
  bool coupled = false;  ///< from the coupled drive
  std::vector<double>
      values;  ///< values at K1, K2, K3, or a single value; empty for all other outputs
  double uncertainty = 0.0;  ///< relative, of these values [-]
};

InDrive in_drive(const Side& side, const std::string& path) {
  const auto value_of = [&](const std::string& name) {
    const auto found = side.outputs.find(name);
    return found != side.outputs.end() ? std::optional(found->second.value) : std::nullopt;
  };
  for (const std::string_view of : kDrives) {
    const std::string drive(of);
    if (!path.starts_with(drive + ".")) continue;
    const std::string output = path.substr(drive.size() + 1);
    const bool change = output == "stiffness_change";
    const bool softer = output == "wind_up" || output == "compliance.total";
    if (output != "stiffness" && !softer && !change) return {};
    const double y = *value_of(path);
    const std::string curve = "curve." + drive.substr(drive.find('.') + 1);
    if (value_of(curve + ".K1")) {
      const double uncertainty =
          change ? 0.0 : side.outputs.at(curve + ".K1").relative_uncertainty.value_or(0.0);
      if (const auto wind_up = value_of(curve + ".wind_up"); wind_up && output == "wind_up")
        return {.coupled = true, .values = {*wind_up}, .uncertainty = uncertainty};
      InDrive coupled{.coupled = true, .values = {}, .uncertainty = uncertainty};
      for (const std::string_view at : {"K1", "K2", "K3"}) {
        const double K_i = *value_of(fmt::format("{}.{}", curve, at));
        coupled.values.push_back(change   ? *value_of(fmt::format("{}.change.{}", curve, at))
                                 : softer ? y * *value_of(drive + ".stiffness") / K_i
                                          : K_i);
      }
      return coupled;
    }
    const double left =
        side.left_out * parts_of(side, "intact").total / parts_of(side, drive).total;
    return {.coupled = false, .values = {softer ? y * (1 + left) : y / (1 + left)}};
  }
  return {};
}

/// One standard uncertainty of second - first for an output of the coupled drive (ST-20).  All
/// parts have the same share of the variance.  A part that is the same in both has a single error,
/// which cancels; a part that differs has two independent errors.
double coupled_uncertainty(double u_a, double u_b, const SameParts& same) {
  const double share = 1 / static_cast<double>(kCoupledParts.size());  // of the variance
  double variance = 0.0;
  for (const std::string_view part : kCoupledParts)
    variance += share * (same.same_in_coupled_drive(std::string(part)) ? std::pow(u_b - u_a, 2)
                                                                       : u_a * u_a + u_b * u_b);
  return std::sqrt(variance);
}

/// Uncertainty u_l of the difference, second minus first, from what the sums leave out (ST-19).
double left_out_of(const Side& first, const Side& second, const std::string& path,
                   const SameParts& same) {
  const InDrive a = in_drive(first, path);
  const InDrive b = in_drive(second, path);
  const double y_a = first.outputs.at(path).value;
  const double y_b = second.outputs.at(path).value;
  const auto farthest = [](const InDrive& drive, double y) {
    double most = 0.0;
    for (const double value : drive.values)
      most = std::max(most, std::abs(value - y) + drive.uncertainty * std::abs(value));
    return most;
  };
  const bool one_error = a.coupled == b.coupled && a.values.size() == b.values.size() &&
                         (a.coupled || (same.same("wave_generator") && same.same("flexspline")));
  if (!one_error) return std::hypot(farthest(a, y_a), farthest(b, y_b));  // (ST-19)
  double most = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double u =
        coupled_uncertainty(a.uncertainty * a.values[i], b.uncertainty * b.values[i], same);
    most = std::max(most, std::abs(b.values[i] - a.values[i] - (y_b - y_a)) + u);  // (ST-19)
  }
  return most;
}

/// One standard uncertainty of second - first (ST-19).  A part that is the same in both has a
/// single model error, which cancels.  A part that differs has two independent errors.  A further
/// term is the effects that the sums leave out.
std::optional<double> uncertainty_of(const Side& first, const Side& second, const std::string& path,
                                     const SameParts& same) {
  const Output& a = first.outputs.at(path);
  const Output& b = second.outputs.at(path);
  if (!a.relative_uncertainty || !b.relative_uncertainty) return std::nullopt;
  const Slopes of_a = slopes_of(first, path);
  const Slopes of_b = slopes_of(second, path);
  if (of_a.empty() || of_b.empty()) {
    const std::size_t crack = path.find("].");
    const bool one = path.find(".crack[") != std::string::npos && crack != std::string::npos
                         ? same.same(path.substr(0, crack + 1))
                         : same.same_body();
    const double u_a = *a.relative_uncertainty * std::abs(a.value);
    const double u_b = *b.relative_uncertainty * std::abs(b.value);
    if (path.starts_with("curve.")) {
      if (!same.same_cracks() && !path.starts_with("curve.intact."))
        return std::nullopt;  // (ST-20)
      return coupled_uncertainty(u_a, u_b, same);
    }
    return one ? std::abs(u_b - u_a) : std::hypot(u_a, u_b);
  }
  std::set<std::string> parts;
  for (const Slopes* const slopes : {&of_a, &of_b})
    for (const auto& [part, slope] : *slopes) parts.insert(part);
  double variance = std::pow(left_out_of(first, second, path, same), 2);
  for (const std::string& part : parts) {
    const auto error = [&](const Side& side, const Slopes& slopes) {
      const auto slope = slopes.find(part);
      return slope == slopes.end()
                 ? 0.0
                 : slope->second * part_uncertainty(side, path, part).value_or(0.0);
    };
    const double e_a = error(first, of_a);
    const double e_b = error(second, of_b);
    variance += same.same(part) ? std::pow(e_b - e_a, 2) : e_a * e_a + e_b * e_b;
  }
  return std::sqrt(variance);
}

std::vector<InputDifference> differing_inputs(const Side& first, const Side& second) {
  std::vector<InputDifference> differing;
  std::set<std::string> paths;
  for (const Inputs* const inputs : {&first.inputs, &second.inputs})
    for (const auto& [path, text] : *inputs) paths.insert(path);
  const auto text_of = [](const Side& side, const std::string& path) {
    const auto found = side.inputs.find(path);
    return found != side.inputs.end() ? found->second : std::string();
  };
  for (const std::string& path : paths)
    if (text_of(first, path) != text_of(second, path))
      differing.push_back({path, text_of(first, path), text_of(second, path)});
  for (const auto& [path, text] : first.tables) {
    const auto other = second.tables.find(path);
    const std::string file = text_of(first, path);
    if (other != second.tables.end() && other->second != text && text_of(second, path) == file)
      differing.push_back({path, file, file + " with another content"});
  }
  return differing;
}

/// The fields of tables whose contents are missing on one side, so that a comparison is impossible.
std::vector<InputDifference> unknown_tables(const Side& first, const Side& second) {
  std::vector<InputDifference> unknown;
  for (const Side* const side : {&first, &second})
    for (const auto& [path, file] : side->inputs)
      if (names_table(path) && !side->tables.contains(path)) unknown.push_back({path, file, file});
  return unknown;
}

/// Whether an output is K1, K2, K3 or the wind-up of the coupled drive under either sense of
/// torque, which designers ask for first.  If the coupled drive is not solved, the sum gives these
/// outputs.
bool is_stiffness(const std::string& path, const Side& side) {
  const bool coupled = side.outputs.contains("curve.positive.K1");
  for (const std::string_view sense : {"positive", "negative"}) {
    const auto any = [&](const std::string& start, std::initializer_list<std::string_view> names) {
      return std::ranges::any_of(
          names, [&](std::string_view name) { return path == fmt::format("{}.{}", start, name); });
    };
    if (any(fmt::format("curve.{}", sense), {"K1", "K2", "K3", "wind_up"}) ||
        any(std::string(sense), {"K1", "K2", "K3"}) || any("at_load", {sense}) ||
        (!coupled && any(fmt::format("cracked.{}", sense), {"stiffness", "wind_up"})))
      return true;
  }
  return false;
}

Difference difference(const Request& request, const DiffOptions& options) {
  const Side first = side_of(options.first, options.method, request);
  const Side second = side_of(options.second, options.method, request);
  if (first.command != second.command)
    throw InputError(
        options.second,
        fmt::format(
            "is a result of {}, but {} is a result of {}; compare results of the same command",
            second.command, options.first, first.command));
  Difference difference{.first = options.first,
                        .second = options.second,
                        .coverage = options.coverage,
                        .inputs = differing_inputs(first, second),
                        .stiffness = {},
                        .outputs = {},
                        .within = {},
                        .unstated = {},
                        .only_first = {},
                        .only_second = {},
                        .unusable_because = {}};
  for (const auto& [side, name] : {std::pair(&first, &options.first), {&second, &options.second}})
    if (!side->unusable_because.empty() && difference.unusable_because.empty())
      difference.unusable_because = fmt::format("{}: {}", *name, side->unusable_because);
  std::vector<InputDifference> not_shared = unknown_tables(first, second);
  not_shared.insert(not_shared.end(), difference.inputs.begin(), difference.inputs.end());
  const SameParts same(first, second, not_shared);
  for (const std::string& path : second.order)
    if (!first.outputs.contains(path)) difference.only_second.push_back(path);
  for (const std::string& path : first.order) {
    const auto other = second.outputs.find(path);
    if (other == second.outputs.end()) {
      difference.only_first.push_back(path);
      continue;
    }
    const Output& a = first.outputs.at(path);
    const Output& b = other->second;
    if (a.unit != b.unit)
      throw InputError(
          options.second,
          fmt::format("has {} in {}, but {} has it in {}; write both results without --units", path,
                      b.unit, options.first, a.unit));
    OutputDifference differing{.path = path,
                               .unit = a.unit,
                               .first = a.value,
                               .second = b.value,
                               .difference = b.value - a.value,
                               .uncertainty = uncertainty_of(first, second, path, same)};
    const double rounding = 1e-12 * std::max(std::abs(a.value), std::abs(b.value));
    const double size = std::abs(differing.difference);
    differing.standing = size <= rounding                                   ? Standing::same
                         : !differing.uncertainty                           ? Standing::not_stated
                         : size > options.coverage * *differing.uncertainty ? Standing::beyond
                                                                            : Standing::within;
    if (is_stiffness(path, first)) difference.stiffness.push_back(differing);
    switch (differing.standing) {
      case Standing::beyond:
        difference.outputs.push_back(std::move(differing));
        break;
      case Standing::within:
        difference.within.push_back(std::move(differing));
        break;
      case Standing::not_stated:
        difference.unstated.push_back(std::move(differing));
        break;
      case Standing::same:
        ++difference.equal;
        break;
    }
  }
  return difference;
}

/// An input in its display unit, such as "0.1 mm" for "0.0001 m".
std::string shown_input(const std::string& path, const std::string& text) {
  if (text.empty()) return "-";
  const std::size_t length = number_length(text);
  const std::optional<double> value = parse_number(text.substr(0, length));
  if (!value || length + 1 >= text.size() || text[length] != ' ') return text;
  return shown_quantity(*value, text.substr(length + 1), 9, path);
}

/// The parts of the drives to which outputs belong, such as cracks; an output that belongs to no
/// part stays unchanged.
std::set<std::string> parts_with(const std::vector<std::string>& paths) {
  std::set<std::string> parts;
  for (const std::string& path : paths) {
    const std::size_t at = path.find("].");
    parts.insert(at == std::string::npos ? path : path.substr(0, at + 1));
  }
  return parts;
}

/// The outputs of a group that are not among others.
std::vector<OutputDifference> without(std::vector<OutputDifference> group,
                                      const std::vector<OutputDifference>& others) {
  std::erase_if(group, [&](const OutputDifference& output) {
    return std::ranges::find(others, output.path, &OutputDifference::path) != others.end();
  });
  return group;
}

/// "flexspline.crack[0], T > 0, load alone: reserve" for a number of a state of a crack; any other
/// path unchanged.
std::string words_of_path(const std::string& path) {
  constexpr std::string_view kStates = ".strength.states[";
  const std::size_t at = path.find(kStates);
  const std::size_t end = path.find("].", at);
  if (at == std::string::npos || end == std::string::npos) return path;
  return fmt::format("{}, {}: {}", path.substr(0, at),
                     path.substr(at + kStates.size(), end - at - kStates.size()),
                     path.substr(end + 2));
}

std::string difference_text(const Difference& difference) {
  std::string text = fmt::format("first:  {}\nsecond: {}\n", difference.first, difference.second);
  if (!difference.unusable_because.empty())
    text += paragraph("NOT USABLE: " + difference.unusable_because);
  Table inputs{.head = {"field", "first", "second"}, .align = "lll"};
  for (const auto& [path, first, second] : difference.inputs)
    inputs.rows.push_back(cells(path, shown_input(path, first), shown_input(path, second)));
  text += "\nInputs that differ\n" +
          (inputs.rows.empty() ? std::string("  none\n") : text_table(inputs));
  const auto others = [&](const std::vector<OutputDifference>& group) {
    return without(group, difference.stiffness);
  };
  const auto list = [&](std::string_view title, const std::vector<OutputDifference>& listed,
                        bool judged = false) {
    Table outputs{.head = {"output", "first", "second", "difference", "uncertainty", "unit"},
                  .align = "lrrrrl"};
    if (judged) outputs.head.emplace_back("against uncertainty");
    for (const OutputDifference& output : listed) {
      const DisplayUnit unit = display_unit(output.path, output.unit);
      const auto number = [&](double value, int digits) {
        return fmt::format("{:.{}g}", value / unit.in_si, digits);
      };
      outputs.rows.push_back(
          cells(words_of_path(output.path), number(output.first, 6), number(output.second, 6),
                number(output.difference, 3),
                output.uncertainty ? number(*output.uncertainty, 2) : std::string("not stated"),
                unit.text == "1" ? std::string_view() : unit.text));
      if (judged) outputs.rows.back().emplace_back(enum_name(output.standing));
    }
    text += fmt::format("\n{}\n{}", title,
                        outputs.rows.empty() ? std::string("  none\n") : text_table(outputs));
  };
  if (!difference.stiffness.empty()) list("Stiffness and wind-up", difference.stiffness, true);
  const std::string_view other = difference.stiffness.empty() ? "Outputs" : "Other outputs";
  list(fmt::format("{} that differ by more than the uncertainty of their difference", other),
       others(difference.outputs));
  if (const auto unstated = others(difference.unstated); !unstated.empty())
    list(fmt::format("{} that differ without a stated uncertainty", other), unstated);
  const auto only = [&](std::string_view which, const std::vector<std::string>& paths) {
    if (!paths.empty())
      text += paragraph(fmt::format("{} {} only in the {}: {}", counted(paths.size(), "output"),
                                    paths.size() == 1 ? "exists" : "exist", which,
                                    fmt::join(parts_with(paths), ", ")));
  };
  text += '\n';
  only("first", difference.only_first);
  only("second", difference.only_second);
  const auto same =
      std::ranges::count(difference.stiffness, Standing::same, &OutputDifference::standing);
  text += fmt::format("Of the other outputs, {} differ by less and {} are the same.\n",
                      others(difference.within).size(),
                      difference.equal - static_cast<std::size_t>(same));
  return text + equations_text(difference.equations);
}

std::string_view csv_word(Standing standing) {
  switch (standing) {
    case Standing::beyond:
      return "output";
    case Standing::within:
      return "within uncertainty";
    case Standing::not_stated:
      return "uncertainty not stated";
    case Standing::same:
      break;
  }
  return "same";
}

std::string difference_csv(const Difference& difference) {
  Table table{.head = {"path", "what", "first", "first_unit", "second", "second_unit", "difference",
                       "difference_unit", "uncertainty", "uncertainty_unit"}};
  for (const auto& [path, first, second] : difference.inputs)
    table.rows.push_back(cells(path, "input", first, "", second, ""));
  const auto add = [&](const OutputDifference& o) {
    table.rows.push_back(cells(o.path, csv_word(o.standing), o.first, o.unit, o.second, o.unit,
                               o.difference, o.unit, o.uncertainty, o.uncertainty ? o.unit : ""));
  };
  for (const OutputDifference& first : difference.stiffness) add(first);
  for (const auto* const outputs : {&difference.outputs, &difference.within, &difference.unstated})
    for (const OutputDifference& output : without(*outputs, difference.stiffness)) add(output);
  return csv_table(table);
}

}  // namespace

Command diff_command() {
  return command<DiffOptions, Difference>({
      .name = "diff",
      .summary = "Compare two drives or two results",
      .description =
          "Compares two drives, or two results that --format json wrote. Prints the inputs that "
          "differ, then K1, K2, K3 and the wind-up of both, and then the outputs that differ by "
          "more than the uncertainty of their difference. The model error of a member or crack "
          "cancels if its inputs are the same in both; otherwise this error counts. The error of "
          "the coupled drive belongs in equal parts to wave generator, rim, mesh and circular "
          "spline, and cancels for each part that is the same. The csv and json formats also list "
          "the outputs that differ by less. Only results of stiffness contain these uncertainties; "
          "for results of other commands, the answer gives only the differences.",
      .example = "strainwave diff examples/article.toml examples/through_crack.toml",
      .takes = Takes::nothing,
      .function = difference,
      .documents = {{Format::text, difference_text}, {Format::csv, difference_csv}},
  });
}

}  // namespace strainwave
