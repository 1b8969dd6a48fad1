// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "strainwave/catalogue/factors.hpp"
#include "strainwave/command/exit_status.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/io/input_format.hpp"
#include "strainwave/materials/material_library.hpp"
#include "strainwave/model/input/vary_option.hpp"
#include "strainwave/present/equation_titles.hpp"
#include "strainwave/present/field_list.hpp"
#include "strainwave/present/glossary.hpp"
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
           .doc = "a term, table, kind of crack, field, unit, note code, equation, exit status, "
                  "material, solution, output, command, or option without its dashes",
           .positional = true,
           .names = "explained"},
          &ExplainOptions::word);
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

/// The word in lower case, without the dashes of an option, and with _ for each - and blank.
std::string folded(std::string_view word) {
  while (word.size() > 1 && word.starts_with('-')) word.remove_prefix(1);
  std::string letters(word);
  for (char& c : letters)
    c = c == '-' || c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

/// The parts of a text between separators, without the blanks around them.
std::vector<std::string_view> split_at(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    parts.push_back(without_blanks(text.substr(0, end)));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Collects the meanings of a word or, for an unknown word, the nearest known words.
class Search {
 public:
  explicit Search(std::string_view word) : word_(word), folded_(folded(word)) {}

  /// Whether the word means this name, which becomes a known name.
  bool is(std::string_view name) {
    if (name.empty()) return false;
    known_.emplace_back(name);
    // With its dashes, a word is an option and nothing else.
    const bool option = word_.size() > 1 && word_.starts_with('-');
    return name == word_ || (folded(name) == folded_ && (!option || name.starts_with('-')));
  }
  /// A thing with one name.
  void thing(std::string_view kind, std::string_view name, const std::string& text,
             std::string more = {}) {
    if (is(name)) found(kind, name, text, std::move(more));
  }
  void found(std::string_view kind, std::string_view name, std::string text, std::string more) {
    meanings_.push_back({std::string(kind), std::string(name), std::move(text), std::move(more)});
  }
  /// A field; its path may be given in part.
  void field(std::string_view kind, const ListedField& listed, std::string_view more) {
    const auto& [path, field, values, alternative] = listed;
    if (!alternative.empty()) return;
    const bool is_path_of_it = is(path);
    if (!is(field.name) && !is_path_of_it && !is_path(word_, path)) {
      if (values.find(", ") != std::string::npos)
        for (const std::string_view value : split_at(values, ","))
          thing(fmt::format("value of {}", path), value, fmt::format("{}: {}", field.doc, values),
                std::string(more));
      return;
    }
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
    if (!meanings_.empty()) return {std::string(word_), std::move(meanings_)};
    if (without_blanks(word_).empty())
      throw OptionError("word", "is empty; give a word, such as torque");
    const std::vector<std::string> near = near_words();
    throw OptionError(
        "word",
        near.empty()
            ? fmt::format("{} is unknown to strainwave; strainwave --help lists the commands, and "
                          "strainwave schema --format markdown lists the fields",
                          shown(word_))
            : fmt::format("{} is unknown to strainwave; did you mean {}?", shown(word_),
                          fmt::join(near, " or ")));
  }

 private:
  /// The nearest known word.  If no word is near, the shortest known words that contain the word.
  [[nodiscard]] std::vector<std::string> near_words() const {
    constexpr std::size_t kMost = 3;
    std::vector<std::string> near;
    std::vector<std::string> known = known_;
    std::ranges::sort(known);
    known.erase(std::unique(known.begin(), known.end()), known.end());
    if (const std::string nearest = nearest_word(word_, known); !nearest.empty()) return {nearest};
    if (folded_.size() < 3) return {};
    std::ranges::stable_sort(known, {}, [](const std::string& name) { return name.size(); });
    for (const std::string& name : known)
      if (near.size() < kMost && folded(name).find(folded_) != std::string::npos)
        near.push_back(name);
    return near;
  }

  std::string_view word_;
  std::string folded_;
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
  for (const KnownUnit& known : known_units()) (void)search.is(known.symbol);
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

void search_glossary(Search& search) {
  for (const auto& [term, meaning, symbol, unit] : glossary()) {
    std::vector<std::string_view> words = split_at(term, ",");
    words.push_back(term);
    for (const std::string_view one : split_at(symbol, ",;")) words.push_back(one);
    bool is = false;
    for (const std::string_view one : words) is = search.is(one) || is;
    if (!is) continue;
    std::string text(meaning);
    if (!symbol.empty()) text += fmt::format("; symbol {}", symbol);
    if (!unit.empty() && unit != "1") text += fmt::format("; in {}", unit);
    search.found("term of the glossary", term, std::move(text), {});
  }
}

void search_tables(Search& search) {
  for (const InputTable& table : input_tables()) {
    const std::string fields = fmt::format("fields: {}", fmt::join(table.fields, ", "));
    constexpr std::string_view kMore = "strainwave schema --format markdown";
    if (search.is(table.kind))
      search.found(fmt::format("kind of {}", table.head), table.kind,
                   fmt::format("{}; {}", table.meaning, fields), std::string(kMore));
    bool is = search.is(table.head);
    is = search.is(table.path) || is;
    is = search.is(table.path.substr(table.path.rfind('.') + 1)) || is;
    if (is || is_path(search.word(), table.path))
      search.found("table of the input", table.head,
                   table.kind.empty() ? fmt::format("{}; {}", table.doc, fields)
                                      : fmt::format("{}; kind = \"{}\": {}; {}", table.doc,
                                                    table.kind, table.meaning, fields),
                   std::string(kMore));
  }
}

/// The steps that follow each proper prefix of the paths, by prefix.
std::map<std::string, std::vector<std::string>> groups_of(const std::vector<ListedField>& fields) {
  std::map<std::string, std::vector<std::string>> groups;
  for (const ListedField& listed : fields)
    for (std::size_t dot = listed.path.find('.'); dot != std::string::npos;) {
      const std::size_t next = listed.path.find('.', dot + 1);
      std::vector<std::string>& group = groups[listed.path.substr(0, dot)];
      const std::string step = listed.path.substr(dot + 1, next - dot - 1);
      if (std::ranges::find(group, step) == group.end()) group.push_back(step);
      dot = next;
    }
  return groups;
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
  using Group = std::pair<std::string, std::string>;  // path, and the fields below it
  std::map<Group, std::vector<std::string_view>> groups;
  for (const Command& command : table) {
    search.thing(
        "command", command.name,
        fmt::format("{}. {} Example: {}", command.summary, command.description, command.example),
        fmt::format("strainwave {} --help", command.name));
    if (const std::size_t blank = command.name.find(' '); blank != std::string_view::npos)
      search.thing("first word of commands", command.name.substr(0, blank),
                   fmt::format("{}: {}", command.name, command.summary),
                   fmt::format("strainwave {} --help", command.name));
    for (const Option& option : command.options.options)
      add(options,
          {.path = (option.field.positional ? "" : "--") + option.spelled(),
           .field = option.field,
           .values = fmt::format("{}", fmt::join(option.choices, ", ")),
           .kind = {}},
          command);
    const std::vector<ListedField> listed_outputs = list_of_fields(command.walk);
    for (const ListedField& listed : listed_outputs)
      if (listed.path != "text") add(outputs, listed, command);
    for (const auto& [path, fields] : groups_of(listed_outputs))
      groups[{path, fmt::format("fields: {}", fmt::join(fields, ", "))}].push_back(command.name);
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
  for (const auto& [group, commands] : groups)
    if (search.is(group.first) || is_path(search.word(), group.first))
      search.found(fmt::format("group of outputs of {}", fmt::join(commands, ", ")), group.first,
                   group.second,
                   fmt::format("strainwave schema --of result --command '{}' --format markdown",
                               commands.front()));
}

Explained explained(std::string_view word, std::span<const Command> table,
                    const std::vector<Meaning>& own) {
  Search search(word);
  search_glossary(search);
  search_tables(search);
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
  for (const std::string_view name : EnumNames<Factor>::names)
    search.thing("factor of calibrate --factors", name,
                 std::string(factor_info(*enum_value<Factor>(name)).meaning),
                 "strainwave calibrate --help");
  search_commands(search, table);
  for (const auto& [kind, name, text, more] : own) search.thing(kind, name, text, more);
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

Command explain_command(std::span<const Command> (*table)(), std::vector<Meaning> (*own)()) {
  return command<ExplainOptions, Explained>({
      .name = "explain",
      .summary = "Explain a word: a field, a unit, a note, an equation and more",
      .description =
          "Explains a word on one screen. The word may be a term of the glossary or its symbol; a "
          "table of the input or a kind of crack; the path of an input field, of an output or of a "
          "group of outputs, or a part of a path; a value of a field or of an option; a unit; the "
          "code of a note; the tag of an equation; an exit status; a material; a stress intensity "
          "solution; a factor of a calibration; a command or an option. The search ignores case "
          "and treats - and _ alike. For an unknown word, the command suggests the nearest known "
          "word.",
      .example = "strainwave explain flexspline.crack[0].half_length",
      .takes = Takes::nothing,
      .function =
          [table, own](const Request&, const ExplainOptions& o) {
            return explained(o.word, table(), own == nullptr ? std::vector<Meaning>() : own());
          },
      .documents = {{Format::text, explained_text}},
  });
}

}  // namespace strainwave
