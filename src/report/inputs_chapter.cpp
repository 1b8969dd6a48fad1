// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/described.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/io/input_remarks.hpp"
#include "strainwave/materials/material_library.hpp"

namespace strainwave::report {
namespace {

/// Origin of a value.
enum class Giver { file, catalogue, drawing, stress, typical, assumed, fallback, library };
constexpr std::array<std::string_view, 8> kGivers = {"in the file", "catalogue",       "drawing",
                                                     "stress",      "typical",         "assumed",
                                                     "default",     "material library"};

/// The origin that a file states.
Giver giver_of(Knowledge knowledge) {
  return static_cast<Giver>(static_cast<int>(knowledge) + static_cast<int>(Giver::catalogue));
}

struct Entry {
  std::string path;
  std::string meaning;
  std::string value;
  Giver giver = Giver::file;
  std::string remark;
};

/// A TOML value of a field's description without its quotes.
std::string unquoted(std::string_view toml) {
  if (toml.size() > 1 && toml.front() == '"' && toml.back() == '"')
    toml = toml.substr(1, toml.size() - 2);
  return std::string(toml);
}

/// Confidence of a number in the material library, and its source there.
std::string library_evidence(std::string_view material, std::string_view property) {
  std::string text = "see the validity notes";
  const MaterialRecord* const record = find_material(material);
  if (record == nullptr) return text;
  for_each_property(*record, [&](std::string_view name, std::string_view, const auto& number) {
    if (name == property)
      text = fmt::format("{}, source {}", enum_name(number.confidence), number.source);
  });
  return text;
}

template <class T>
inline constexpr bool is_table = Described<T> || is_variant<T> || is_string_map<T> ||
                                 (is_vector<T> && !is_array_of_numbers<T>);
template <class T>
inline constexpr bool is_table<std::optional<T>> = is_table<T>;

class Collector {
 public:
  Collector(const GearSet& gear, const std::string& text)
      : gear_(gear), remarks_(input_remarks(text)) {}

  /// Groups of entries by table, in the order of the file's description.
  std::vector<std::pair<std::string, std::vector<Entry>>> collect() && {
    walk(gear_, FieldPath(), Field{});
    return std::move(groups_);
  }

 private:
  template <class T>
  void walk(const T& value, const FieldPath& path, const Field& field) {
    if constexpr (is_optional<T>) {
      if (value) walk(*value, path, field);
    } else if constexpr (is_vector<T>) {
      for (std::size_t i = 0; i < value.size(); ++i) walk(value[i], path[i], field);
    } else if constexpr (is_string_map<T>) {
      for (const auto& [name, element] : value) {
        key_ = name;
        walk(element, path / name, field);
      }
    } else if constexpr (is_variant<T>) {
      if (of_another_table(path.text())) return;
      std::visit(
          [&](const auto& alternative) {
            group_ = path.text();
            add(path / "kind", Field{.name = "kind", .unit = "", .doc = "kind of crack"}, {});
            walk(alternative, path, field);
          },
          value);
    } else if constexpr (Described<T>) {
      // Plain fields come first, because a table below begins its own group.
      T::describe([&](const Field& inner, auto member) {
        using Value = std::decay_t<decltype(value.*member)>;
        if constexpr (!is_table<Value>) {
          group_ = path.text();
          std::string taken;
          if constexpr (std::is_same_v<T, Material>) {
            if constexpr (std::is_convertible_v<Value, std::optional<double>>) {
              const std::optional<double> number = value.*member;
              if (number && !value.origin.empty()) taken = shown_quantity(*number, inner.unit, 6);
            }
            record_ = value.based_on.value_or(key_);
          }
          add(path / inner.name, inner, taken);
        }
      });
      T::describe([&](const Field& inner, auto member) {
        using Value = std::decay_t<decltype(value.*member)>;
        if constexpr (is_table<Value>)
          if (path.text().empty() && (inner.name == "range" || inner.name == "scatter")) return;
        if constexpr (is_table<Value>) walk(value.*member, path / inner.name, inner);
      });
    }
  }

  /// Whether the table of a group gives a crack, and the file no table of its own.
  [[nodiscard]] bool of_another_table(const std::string& crack) const {
    for (const PlacedGroup& group : gear_.placed_groups)
      for (std::size_t i = 1; i < group.count; ++i)
        if (crack == std::string(group.crack(i))) return true;
    return false;
  }

  /// @param taken  value from the material library; empty if the value has another origin
  void add(const FieldPath& path, const Field& field, const std::string& taken) {
    if (path.text() == "format" || path.text() == "name") return;
    Entry entry{.path = path.text(), .meaning = std::string(field.doc), .value = {}, .remark = {}};
    const auto found = remarks_.find(path.text());
    if (found != remarks_.end()) {
      entry.value = found->second.written;
      entry.remark = found->second.comment;
      for (std::size_t k = 0; k < EnumNames<Knowledge>::names.size(); ++k) {
        const std::string_view word = EnumNames<Knowledge>::names[k];
        if (!entry.remark.starts_with(word)) continue;
        entry.giver = giver_of(static_cast<Knowledge>(k));
        entry.remark.erase(0, word.size());
        entry.remark.erase(0,
                           std::min(entry.remark.find_first_not_of(":;, "), entry.remark.size()));
      }
    } else if (!taken.empty()) {
      entry.value = taken;
      entry.giver = Giver::library;
      entry.remark = library_evidence(record_, field.name);
    } else if (!field.fallback.empty()) {
      entry.value = unquoted(field.fallback);
      entry.giver = Giver::fallback;
    } else {
      return;  // neither given nor filled in
    }
    for (const InputRange& range : gear_.range) {
      if (range.path != entry.path) continue;
      entry.giver = giver_of(range.knowledge);
      const std::string between = fmt::format("{} to {}", range.lower, range.upper);
      if (entry.remark.find(range.source) == std::string::npos && !range.source.empty())
        entry.remark += (entry.remark.empty() ? "" : "; ") + range.source;
      entry.remark = between + (entry.remark.empty() ? "" : "; " + entry.remark);
    }
    for (const InputScatter& scatter : gear_.scatter)
      if (scatter.path == entry.path)
        entry.remark +=
            fmt::format("{}scatters by {}{}{}", entry.remark.empty() ? "" : "; ",
                        scatter.relative_standard_deviation
                            ? fmt::format("{:.3g} %", 100 * *scatter.relative_standard_deviation)
                            : "a table of quantiles",
                        scatter.source.empty() ? "" : ": ", scatter.source);
    if (groups_.empty() || groups_.back().first != group_) groups_.push_back({group_, {}});
    groups_.back().second.push_back(std::move(entry));
  }

  const GearSet& gear_;
  std::map<std::string, InputRemark> remarks_;
  std::string group_;
  std::string key_;     ///< key of the walked table, if it is one of many
  std::string record_;  ///< library record of the walked material
  std::vector<std::pair<std::string, std::vector<Entry>>> groups_;
};

}  // namespace

ReportSection inputs_chapter(Draft& draft) {
  std::array<int, kGivers.size()> counts{};
  std::vector<RowGroup> groups;
  int total = 0;
  for (const auto& [title, entries] : Collector(draft.gear, draft.input_text).collect()) {
    RowGroup& group = groups.emplace_back();
    group.title = title;
    for (const Entry& entry : entries) {
      const auto giver = static_cast<std::size_t>(entry.giver);
      ++counts[giver];
      ++total;
      const std::string name = entry.path.substr(title.size() + (title.empty() ? 0 : 1));
      group.rows.push_back(
          {{fmt::format("<code data-field=\"{}\">{}</code>", escaped(entry.path), escaped(name)),
            escaped(entry.value),
            fmt::format("<span class=\"giver g{}\">{}</span>", giver, kGivers[giver]),
            escaped(entry.meaning), escaped(entry.remark)},
           {}});
    }
  }
  std::string summary = fmt::format("{} values: ", total);
  bool first = true;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    summary += fmt::format("{}{} {}", first ? "" : ", ", counts[i], kGivers[i]);
    first = false;
  }
  draft.inputs_summary = summary;
  summary +=
      ". “In the file” means that the file gives the value without its origin. “Default” means "
      "that strainwave uses its default, because the file leaves the value out. For a typical or "
      "assumed value, the remark gives the limits and their origin.";
  return {"inputs", "Inputs",
          paragraph(summary) + table("Inputs, as the file writes them",
                                     {"field", "value", "given by", "meaning", "remark"}, groups,
                                     {.style = "inputs", .numbers = 99})};
}

}  // namespace strainwave::report
