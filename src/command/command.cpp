// SPDX-License-Identifier: Apache-2.0
#include "strainwave/command/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/present/reference.hpp"
#include "strainwave/present/schema.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kEnvelope = "strainwave-result/1";

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

Answer run(const Command& command, const std::shared_ptr<const Drive>& drive,
           const OptionValues& options, const OptionTexts& texts, const Progress& progress,
           const Host& host) {
  const auto require = [&](bool given, std::string_view what) {
    if (!given)
      throw OptionError(what, fmt::format("must be given; {} needs a {}", command.name, what));
  };
  require(drive || command.takes == Takes::nothing, "drive");
  require(host.journal != nullptr || command.journal.empty(), "journal");
  static const auto no_drive = std::make_shared<const Drive>();
  return {command, drive ? drive : no_drive, options, texts, progress, host};
}

Answer::Answer(const Command& command, std::shared_ptr<const Drive> drive,
               const OptionValues& options, const OptionTexts& texts, const Progress& progress,
               const Host& host)
    : command_(&command), drive_(std::move(drive)), options_(options), ranks_(&host.ranks) {
  options_.require_complete();
  result_ = command.run(command,
                        {.drive = *drive_,
                         .texts = texts,
                         .progress = progress,
                         .ranks = host.ranks,
                         .journal = host.journal},
                        options_.get());
  evidence_ = command.evidence(result_.get());
}

std::string Answer::json() const {
  JsonWriter to;
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
    if (command_->takes == Takes::drive) {
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
    throw OptionError("document",
                      fmt::format("{} of {} is a folder of files, not a text; write it to a folder",
                                  shown(name), command_->name));
  return std::move(made.front().text);
}

std::vector<OutputFile> Answer::files(std::string_view name) const {
  const auto found = std::ranges::find(command_->documents, name, &Document::name);
  if (found == command_->documents.end()) {
    std::vector<std::string_view> names = {"json"};
    for (const Document& document : command_->documents) names.push_back(document.name);
    throw OptionError("document", fmt::format("{} does not make {}; it makes {}", command_->name,
                                              shown(name), fmt::join(names, ", ")));
  }
  return command_->write(
      *command_, static_cast<std::size_t>(found - command_->documents.begin()), result_.get(),
      {.drive = *drive_, .provenance = provenance_of(*drive_), .ranks = *ranks_, .answer = *this});
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
  const std::string near = nearest_word(name, names);
  throw OptionError("command",
                    near.empty()
                        ? fmt::format("{} is not a command; known commands are {}", shown(name),
                                      fmt::join(names, ", "))
                        : fmt::format("{} is not a command; did you mean {}?", shown(name), near));
}

}  // namespace strainwave
