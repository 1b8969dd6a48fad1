// SPDX-License-Identifier: Apache-2.0
#include "table_commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "files.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::cli {
namespace {

/// What the command line says for one command.
struct Given {
  std::string file;
  std::string format;
  std::string output;
  std::map<std::string_view, std::vector<std::string>> texts;  // of the options, by name
  std::map<std::string_view, bool> flags;
  std::map<std::string_view, std::string> beside;  // paths of the documents beside the main one
};

std::string help_of(const Option& option) {
  std::string text(option.field.doc);
  if (!option.field.fallback.empty()) text += fmt::format("; default {}", option.field.fallback);
  return text;
}

void add_option(CLI::App* sub, const Option& option, Given& given) {
  const std::string_view name = option.field.name;
  if (option.kind == OptionKind::flag) {
    sub->add_flag("--" + option.spelled(), given.flags[name], help_of(option));
    return;
  }
  std::string upper = option.spelled();
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  CLI::Option* const added =
      sub->add_option(option.field.positional ? upper : "--" + option.spelled(), given.texts[name],
                      help_of(option))
          ->required(option.required)
          ->type_name(option.choices.empty() ? "TEXT"
                                             : fmt::format("{}", fmt::join(option.choices, "|")));
  if (option.repeatable)
    added->allow_extra_args(false)->take_all();  // or it would swallow what follows
  else
    added->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
}

void add_documents(CLI::App* sub, const Command& command, Given& given) {
  std::vector<std::string> formats;
  bool output_taken = false;
  for (const Document& document : command.documents) {
    if (document.option.empty()) {
      formats.emplace_back(document.name);
      continue;
    }
    output_taken = output_taken || document.option == "output";
    sub->add_option(
           fmt::format("{}--{}", document.option == "output" ? "-o," : "", document.option),
           given.beside[document.name], std::string(document.doc))
        ->type_name("PATH");
  }
  formats.emplace_back("json");
  given.format = formats.front();
  sub->add_option("--format", given.format, fmt::format("{}", fmt::join(formats, ", ")))
      ->check(CLI::IsMember(formats))
      ->capture_default_str();
  if (!output_taken)
    sub->add_option("-o,--output", given.output, "write to this file instead of standard output")
        ->type_name("PATH");
}

ExitCode exit_code_of(RequirementOutcome outcome) {
  switch (outcome) {
    case RequirementOutcome::met:
      return kOk;
    case RequirementOutcome::not_met:
      return kNotMet;
    case RequirementOutcome::cannot_be_told:
      break;
  }
  return kCannotTell;
}

ExitCode run_command(const Command& command, const Given& given, ReadDrive read_drive) {
  OptionValues options(command.options);
  for (const auto& [name, texts] : given.texts)
    for (const std::string& text : texts) options.set(name, text);
  for (const auto& [name, flag] : given.flags)
    if (flag) options.set(name, "true");
  const auto drive =
      command.takes == Takes::drive
          ? read_drive(text_of(given.file), shown_name(given.file), attachments_beside(given.file))
          : std::make_shared<const Drive>();
  OptionTexts texts;
  for (const Option& option : command.options.options)
    if (option.field.names == "attachment")
      for (const std::string& file : given.texts.at(option.field.name)) texts[file] = text_of(file);
  const Answer answer(command, drive, options, texts, {});
  // All documents are made before any file is written: a failure leaves nothing behind.
  const std::string main = answer.document(given.format);
  std::vector<std::pair<std::string, std::string>> beside;
  for (const auto& [name, path] : given.beside)
    if (!path.empty()) beside.emplace_back(path, answer.document(name));
  for (const auto& [path, text] : beside) deliver(text, path);
  deliver(main, given.output);
  if (!answer.usable()) {
    std::cerr << "strainwave: " << answer.evidence().unusable_because << '\n';
    return kNotUsable;
  }
  return exit_code_of(answer.evidence().requirement.value_or(RequirementOutcome::met));
}

ExitCode complain(std::string_view program, std::string_view message, ExitCode code) {
  std::cerr << program << ": " << message << '\n';
  return code;
}

}  // namespace

void add_commands(CLI::App& app, std::span<const Command> table, std::span<const Group> groups,
                  ReadDrive read_drive, const Choose& choose) {
  for (const Command& command : table) {
    CLI::App* parent = &app;
    std::string_view word = command.name;
    if (const std::size_t space = word.find(' '); space != std::string_view::npos) {
      const std::string group(word.substr(0, space));
      word.remove_prefix(space + 1);
      parent = app.get_subcommand_no_throw(group);
      if (parent == nullptr) {
        const auto summary = std::ranges::find(groups, group, &Group::name)->summary;
        parent = app.add_subcommand(group, std::string(summary))->require_subcommand(1);
      }
    }
    CLI::App* const sub = parent->add_subcommand(std::string(word), std::string(command.summary));
    sub->footer(fmt::format("Example:\n  {}", command.example));
    const auto given = std::make_shared<Given>();
    if (command.takes == Takes::drive)
      sub->add_option("FILE", given->file, "input file, or - for standard input")->required();
    for (const Option& option : command.options.options) add_option(sub, option, *given);
    add_documents(sub, command, *given);
    sub->callback([&command, given, read_drive, choose] {
      choose([&command, given, read_drive] { return run_command(command, *given, read_drive); });
    });
  }
}

int guarded(std::string_view program, const std::function<ExitCode()>& work) {
  try {
    return work();
  } catch (const UsageError& error) {
    return complain(program, error.message, kUsage);
  } catch (const OptionError& error) {
    return complain(program, error.what(), kUsage);
  } catch (const InputError& error) {
    return complain(program, error.what(), kInput);
  } catch (const SolverError& error) {
    return complain(program, error.what(), kNotUsable);
  } catch (const std::exception& error) {
    return complain(program, error.what(), kInternal);
  }
}

}  // namespace strainwave::cli
