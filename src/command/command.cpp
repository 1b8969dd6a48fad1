// SPDX-License-Identifier: Apache-2.0
#include "strainwave/command/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "strainwave/core/nearest.hpp"
#include "strainwave/core/number_text.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/model/input/vary_option.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/present/reference.hpp"
#include "strainwave/present/schema.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kEnvelope = "strainwave-result/1";

/// Asks for the unit of "PATH=FROM..TO:N" or "OUTPUT >= VALUE", if the text has a unit.  What
/// is wrong with the text, the command says.
void ask_as_typed(AskedUnits& units, std::string_view text) {
  const std::size_t sign = text.find_first_of("<>");
  const std::size_t at = sign != std::string_view::npos ? sign : text.rfind('=');
  if (at == std::string_view::npos) return;
  const std::string_view name = without_blanks(text.substr(0, at));
  std::string_view value = text.substr(at + 1);
  if (value.starts_with('=')) value.remove_prefix(1);
  value = value.substr(0, value.find(':'));
  if (const std::size_t dots = value.rfind(".."); dots != std::string_view::npos)
    value.remove_prefix(dots + 2);
  value = without_blanks(value);
  if (value.starts_with('+')) value.remove_prefix(1);
  const std::string_view unit = without_blanks(value.substr(number_length(value)));
  try {
    if (!unit.empty()) units.ask_for(name, unit);
  } catch (const InputError&) {
  }
}

Field named(std::string_view name) { return {.name = name, .unit = {}, .doc = {}}; }

}  // namespace

Provenance provenance_of(const Drive& drive) {
  return {.version = std::string(version()),
          .revision = std::string(git_revision()),
          .input_file = drive.name,
          .quadrature_tolerance = QuadratureOptions{}.relative_tolerance};
}

std::shared_ptr<const Drive> read_drive(std::string text, std::string name,
                                        const Attachments& attachments) {
  auto drive = std::make_shared<Drive>();
  drive->gear = read_gear_set(text, name, attachments);
  drive->text = std::move(text);
  drive->name = std::move(name);
  return drive;
}

TextPieces Request::pieces(std::string_view option, const std::string& name) const {
  if (const auto text = texts.find(name); text != texts.end()) return pieces_of(text->second);
  if (!open) throw OptionError(option, "names a text that is not attached");
  return from_option([&] { return open(name); });
}

Answer run(const Command& command, const std::shared_ptr<const Drive>& drive,
           const OptionValues& options, const OptionTexts& texts, const Progress& progress,
           const Host& host) {
  const auto require = [&](bool given, std::string_view what) {
    if (!given)
      throw OptionError(what, fmt::format("must be given; {} needs a {}", command.name, what));
  };
  require(drive || command.takes != Takes::drive, "drive");
  require(host.journal != nullptr || command.journal.empty() || !command.journal_option.empty(),
          "journal");
  if (command.instead) {
    options.require_complete();
    return command.instead(options, texts, progress, host);
  }
  static const auto no_drive = std::make_shared<const Drive>();
  return {command, drive ? drive : no_drive, options, texts, progress, host};
}

Answer::Answer(const Command& command, std::shared_ptr<const Drive> drive,
               const OptionValues& options, const OptionTexts& texts, const Progress& progress,
               const Host& host)
    : command_(&command),
      drive_(std::move(drive)),
      options_(options),
      ranks_(&host.ranks),
      units_(host.units),
      json_units_(host.units),
      columns_(host.columns) {
  options_.require_complete();
  for (const auto& [name, text] : options_.texts())
    for (const Option& option : command.options.options)
      if (option.field.name == name &&
          (option.field.names == "output" || option.field.names == "field path"))
        ask_as_typed(units_, text);
  const AskedUnitsScope scope(units_);
  try {
    result_ = command.run(command,
                          {.drive = *drive_,
                           .texts = texts,
                           .progress = progress,
                           .ranks = host.ranks,
                           .journal = host.journal,
                           .beside = host.beside,
                           .open = host.open,
                           .recording = host.recording,
                           .kept = host.kept,
                           .shared = host.shared,
                           .rows = host.rows},
                          options_.get());
  } catch (const OptionError&) {
    throw;
  } catch (const InputError& fault) {
    if (drive_->text.empty()) throw;
    throw located(fault, drive_->text, drive_->name);
  }
  evidence_ = command.evidence(result_.get());
}

std::string Answer::json() const {
  JsonWriter to;
  to.write_units(json_units_);
  const auto part = [&](std::string_view name, const auto& value) {
    if (to.field(named(name))) visit_value(value, {}, to);
  };
  to.begin_record();
  to.member("format", kEnvelope);
  to.member("command", command_->name);
  to.member("usable", usable());
  to.member("unusable_because", evidence_.unusable_because);
  part("verdict", evidence_.verdict);
  part("notes", evidence_.notes);
  part("equations", evidence_.equations);
  part("accuracies", evidence_.accuracies);
  if (to.field(named("result"))) visit(to);
  if (to.field(named("provenance"))) {
    to.begin_record();
    to.member("program", command_->program);
    to.member("version", version());
    to.member("revision", git_revision());
    to.write_numbers(JsonNumbers::as_input);
    if (to.field(named("options"))) command_->options.visit(options_.get(), to);
    if (command_->takes == Takes::drive || !drive_->name.empty()) {
      to.member("input_file", drive_->name);
      part("input", drive_->gear);
    }
    to.end_record();
  }
  to.end_record();
  return to.document();
}

std::string Answer::document(std::string_view name) const {
  if (name == "json") return json();
  std::vector<OutputFile> made = files(name);
  if (made.size() != 1 || !made.front().name.empty())
    throw OptionError(
        "document",
        fmt::format("{} of {} is a folder of files and not a text; name a folder for it",
                    shown(name), command_->name));
  return std::move(made.front().text);
}

std::vector<OutputFile> Answer::files(std::string_view name) const {
  const auto found = name == kDefaultDocument
                         ? command_->documents.begin()
                         : std::ranges::find(command_->documents, name, &Document::name);
  if (found == command_->documents.end()) {
    std::vector<std::string_view> names = {"json"};
    for (const Document& document : command_->documents) names.push_back(document.name);
    throw OptionError("document", fmt::format("{} does not make {}; it makes {}", command_->name,
                                              shown(name), fmt::join(names, ", ")));
  }
  const AskedUnitsScope scope(units_);
  std::vector<OutputFile> made = command_->write(
      *command_, static_cast<std::size_t>(found - command_->documents.begin()), result_.get(),
      {.drive = *drive_, .provenance = provenance_of(*drive_), .ranks = *ranks_, .answer = *this});
  if (found->format == Format::csv)
    for (OutputFile& file : made) {
      if (!units_.empty()) file.text = csv_in_units(file.text, units_);
      if (!columns_.empty() && found->option.empty())
        file.text = from_option([&] { return csv_columns(file.text, columns_); });
    }
  return made;
}

std::string result_schema(const Command& command) {
  using Json = nlohmann::ordered_json;
  const auto of = [](TypeWalk walk) { return Json::parse(schema_of(walk, SchemaOf::result)); };
  const Json text = {{"type", "string"}};
  Json provenance = {{"type", "object"},
                     {"properties",
                      {{"program", {{"const", command.program}}},
                       {"version", text},
                       {"revision", text},
                       {"options", {{"type", "object"}}},
                       {"input_file", text},
                       {"input", {{"type", "object"}}}}},
                     {"required", {"program", "version", "revision", "options"}},
                     {"additionalProperties", false}};
  Json properties = {{"format", {{"const", kEnvelope}}},
                     {"command", {{"const", command.name}}},
                     {"usable", {{"type", "boolean"}}},
                     {"unusable_because", text},
                     {"verdict", of(visit_type<Verdict>)},
                     {"notes", of(visit_type<std::vector<Note>>)},
                     {"equations", of(visit_type<std::vector<std::string>>)},
                     {"accuracies", of(visit_type<std::vector<AccuracyBasis>>)},
                     {"result", of(command.walk)},
                     {"provenance", std::move(provenance)}};
  Json schema = {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", fmt::format("{} {}: {}", command.program, command.name, command.summary)},
      {"type", "object"}};
  Json required = Json::array();
  for (const auto& [name, value] : properties.items()) required.push_back(name);
  schema["properties"] = std::move(properties);
  schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  return schema.dump(2) + '\n';
}

std::string options_schema(const Command& command) {
  using Json = nlohmann::ordered_json;
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", fmt::format("Options of {} {}", command.program, command.name)}};
  schema.update(Json::parse(schema_of(command.options.walk, SchemaOf::options)));
  for (const Option& option : command.options.options)
    if (option.required) schema["required"].push_back(option.field.name);
  return schema.dump(2) + '\n';
}

std::string options_reference(const Command& command) {
  return fmt::format("# Options of `{} {}`\n\n{}\n\n{}", command.program, command.name,
                     command.summary, fields_reference(command.options.walk));
}

std::string result_reference(const Command& command) {
  return fmt::format("# Result of `{} {}`\n\n{}\n\n{}", command.program, command.name,
                     command.summary, fields_reference(command.walk));
}

const Command& command_named(std::span<const Command> table, std::string_view name) {
  const auto found = std::ranges::find(table, name, &Command::name);
  if (found != table.end()) return *found;
  std::vector<std::string> names;
  for (const Command& command : table) names.emplace_back(command.name);
  throw OptionError(
      "command",
      not_a_command(name, names, "", fmt::format("known commands are {}", fmt::join(names, ", "))));
}

std::string not_a_command(std::string_view word, std::span<const std::string> known,
                          std::string_view before, std::string_view otherwise) {
  const std::string near = nearest_word(word, known);
  return fmt::format(
      "{} is not a command; {}", shown(word),
      near.empty() ? std::string(otherwise) : fmt::format("did you mean {}{}?", before, near));
}

}  // namespace strainwave
