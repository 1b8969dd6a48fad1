// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "strainwave/command/exit_status.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/materials/material_library.hpp"
#include "strainwave/present/equation_titles.hpp"
#include "strainwave/present/field_list.hpp"
#include "strainwave/present/note_texts.hpp"
#include "strainwave/sif/library.hpp"

namespace strainwave {
namespace {

struct ExplainOptions {
  std::string word;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "word",
           .unit = "",
           .doc = "a field, unit, note code, equation, exit status, material, solution, output, "
                  "command or option",
           .positional = true,
           .names = "explained"},
          &ExplainOptions::word);
  }
};

/// One meaning of a word.
struct Meaning {
  std::string kind;  ///< "field of the input"
  std::string name;
  std::string text;
  std::string more;  ///< the command that tells more

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"kind", "", "the kind of thing that the word names"}, &Meaning::kind);
    field({"name", "", "in full"}, &Meaning::name);
    field({"text", "", "what it means"}, &Meaning::text);
    field({"more", "", "the command that prints more; empty if there is none"}, &Meaning::more);
  }
};

struct Explained {
  std::string word;
  std::vector<Meaning> meanings;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"word", "", "the word as it was given"}, &Explained::word);
    field({"meanings", "", "each thing of this name"}, &Explained::meanings);
  }
};

/// Collects the meanings of a word or, for an unknown word, the nearest known words.
class Search {
 public:
  explicit Search(std::string_view word) : word_(word) {}

  /// A thing with one name.
  void thing(std::string_view kind, std::string_view name, const std::string& text,
             std::string more = {}) {
    known_.emplace_back(name);
    if (name == word_ && !kind.empty()) found(kind, name, text, std::move(more));
  }
  void found(std::string_view kind, std::string_view name, std::string text, std::string more) {
    meanings_.push_back({std::string(kind), std::string(name), std::move(text), std::move(more)});
  }
  /// A field; its path may be given in part.
  void field(std::string_view kind, const ListedField& listed, std::string_view more) {
    const auto& [path, field, values, alternative] = listed;
    if (!alternative.empty()) return;
    known_.push_back(path);
    known_.emplace_back(field.name);
    if (word_ != path && word_ != field.name && !is_path(word_, path)) return;
    std::string text(field.doc);
    if (!field.unit.empty() && field.unit != "1" && field.unit != kUnitBeside)
      text += fmt::format("; in {}", field.unit);
    if (const std::string rule = rule_text(field.range, field.unit);
        field.unit != kUnitBeside && rule != "a finite number")
      text += fmt::format("; {}", rule);
    if (!values.empty()) text += fmt::format("; {}", values);
    if (!field.fallback.empty()) text += fmt::format("; default {}", field.fallback);
    if (!field.example.empty())
      text += fmt::format("; for example {} = {}", field.name, field.example);
    found(kind, path, std::move(text), std::string(more));
  }

  [[nodiscard]] std::string_view word() const { return word_; }

  /// @throws OptionError  if nothing has this name
  Explained explained() && {
    if (meanings_.empty()) {
      const std::string near = nearest_word(word_, known_);
      throw OptionError(
          "word",
          near.empty()
              ? fmt::format("{} is unknown to strainwave; strainwave --help lists the commands, "
                            "and strainwave schema --format markdown lists the fields",
                            shown(word_))
              : fmt::format("{} is unknown to strainwave; did you mean {}?", shown(word_), near));
    }
    return {std::string(word_), std::move(meanings_)};
  }

 private:
  std::string_view word_;
  std::vector<std::string> known_;
  std::vector<Meaning> meanings_;
};

/// The text of a note with dots in place of the values of a run.
std::string without_places(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find('{'), text.size());
    shown += text.substr(0, open);
    text.remove_prefix(open);
    if (text.empty()) break;
    shown += "...";
    text.remove_prefix(std::min(text.find('}'), text.size() - 1) + 1);
  }
  return shown;
}

void search_unit(Search& search, const std::vector<ListedField>& fields) {
  for (const KnownUnit& known : known_units()) search.thing({}, known.symbol, {});
  Unit unit;
  try {
    unit = parse_unit(search.word());
  } catch (const InputError&) {
    return;
  }
  const auto takes = [&](const ListedField& listed) {
    return !listed.field.unit.empty() && same_dimension(parse_unit(listed.field.unit), unit);
  };
  const auto first = std::ranges::find_if(fields, takes);
  const auto known = std::ranges::find_if(
      known_units(), [&](const KnownUnit& other) { return same_dimension(other.unit, unit); });
  std::string text = known != known_units().end() ? fmt::format("a unit of {}", known->kind)
                                                  : "a product of units";
  if (first != fields.end())
    text += fmt::format("; 1 {} = {} {}; {} and {} more fields of the input take it", search.word(),
                        unit.factor, first->field.unit, first->path,
                        std::ranges::count_if(fields, takes) - 1);
  search.found("unit", search.word(), std::move(text), "strainwave units");
}

void search_commands(Search& search, std::span<const Command> table) {
  struct Place {
    ListedField listed;
    std::vector<std::string_view> commands;
  };
  const auto add = [](std::map<std::string, Place>& to, const ListedField& listed,
                      const Command& command) {
    Place& place = to.try_emplace(listed.path + '\n' + std::string(listed.field.doc)).first->second;
    place.listed = listed;
    if (place.commands.empty() || place.commands.back() != command.name)
      place.commands.push_back(command.name);
  };
  std::map<std::string, Place> options;
  std::map<std::string, Place> outputs;
  for (const Command& command : table) {
    search.thing(
        "command", command.name,
        fmt::format("{}. {} Example: {}", command.summary, command.description, command.example),
        fmt::format("strainwave {} --help", command.name));
    for (const Option& option : command.options.options)
      add(options,
          {.path = (option.field.positional ? "" : "--") + option.spelled(),
           .field = option.field,
           .values = fmt::format("{}", fmt::join(option.choices, ", ")),
           .kind = {}},
          command);
    for (const ListedField& listed : list_of_fields(command.walk))
      if (listed.path != "text") add(outputs, listed, command);
  }
  const auto told = [&](std::string_view kind, const std::map<std::string, Place>& places,
                        std::string_view what) {
    for (const auto& [key, place] : places)
      search.field(
          fmt::format("{} of {}", kind, fmt::join(place.commands, ", ")), place.listed,
          fmt::format("strainwave {}", fmt::format(fmt::runtime(what), place.commands.front())));
  };
  told("option", options, "{} --help");
  told("output", outputs, "schema --of result --command '{}' --format markdown");
}

Explained explained(std::string_view word, std::span<const Command> table) {
  Search search(word);
  const std::vector<ListedField> fields = list_of_fields(visit_type<GearSet>);
  for (const ListedField& listed : fields)
    search.field("field of the input", listed, "strainwave schema --format markdown");
  search_unit(search, fields);
  for (const auto& [code, text] : note_texts())
    search.thing("note", code,
                 text.empty()
                     ? "The text of this note depends on the drive; a result shows the text"
                     : without_places(text));
  for (const auto& [tag, title] : equation_titles())
    search.thing("equation of the theory manual", tag, std::string(title));
  for (const auto& [status, meaning] : kExitStatuses)
    search.thing("exit status", fmt::format("{}", static_cast<int>(status)), std::string(meaning));
  for (const MaterialRecord& record : material_library()) {
    const std::string more = fmt::format("strainwave material show '{}'", record.name);
    search.thing("material", record.name, record.treatment, more);
    for (const std::string& alias : record.aliases)
      search.thing("material", alias, fmt::format("another name of {}", record.name), more);
  }
  for (const sif::Row& row : sif::library())
    search.thing("stress intensity solution", row.info.name,
                 fmt::format("{}; modes {}; accuracy {}; {}", row.info.title, row.info.modes,
                             percent(row.info.relative_uncertainty), row.info.accuracy),
                 fmt::format("strainwave sif show {}", row.info.name));
  search_commands(search, table);
  return std::move(search).explained();
}

/// One screen: where a word names many things, the first ones in full and how many follow.
std::string explained_text(const Explained& explained) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, explained.meanings.size()); ++i) {
    const auto& [kind, name, meaning, more] = explained.meanings[i];
    text += paragraph(fmt::format("{}: {}", name, kind));
    text += paragraph(meaning, 2, 0);
    if (!more.empty()) text += paragraph("More: " + more, 2, 0);
  }
  if (explained.meanings.size() > kMost)
    text += fmt::format("{} more; --format json shows all, and a longer path gives fewer\n",
                        explained.meanings.size() - kMost);
  return text;
}

}  // namespace

Command explain_command(std::span<const Command> (*table)()) {
  return command<ExplainOptions, Explained>({
      .name = "explain",
      .summary = "Explain a word: a field, a unit, a note, an equation and more",
      .description = "Explains a word on one screen. The word may be the path of an input field or "
                     "of an output, or a part of a path; a unit; the code of a note; the tag of an "
                     "equation; an exit status; a material; a stress intensity solution; a command "
                     "or an option. For an unknown word it "
                     "suggests the nearest known one.",
      .example = "strainwave explain flexspline.crack[0].half_length",
      .takes = Takes::nothing,
      .function = [table](const Request&,
                          const ExplainOptions& o) { return explained(o.word, table()); },
      .documents = {{Format::text, explained_text}},
  });
}

}  // namespace strainwave
