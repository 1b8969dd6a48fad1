// SPDX-License-Identifier: Apache-2.0
#include "manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "strainwave/command/exit_status.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/io/input_format.hpp"

namespace strainwave::cli {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
      result += fmt::format("\\&{}", c);
    else
      result += c;
  }
  return result;
}

std::string head(std::string page, std::string_view summary, int section = 1) {
  const std::string name = escaped(page);
  std::ranges::transform(page, page.begin(), [](unsigned char c) { return std::toupper(c); });
  return fmt::format(
      ".TH {} {} \"\" \"strainwave {}\" \"strainwave manual\"\n.SH NAME\n{} \\- {}\n", page,
      section, version(), name, escaped(summary));
}

/// An argument as shown in the synopsis and the list of options: "--method TEXT".
std::string usage(const Argument& argument) {
  if (argument.positional())
    return fmt::format("\\fI{}\\fR{}", escaped(argument.name), argument.repeatable ? " ..." : "");
  const std::string name = fmt::format("\\fB{}\\fR", escaped(argument.name));
  return argument.type.empty() ? name : fmt::format("{} \\fI{}\\fR", name, escaped(argument.type));
}

std::string synopsis(const Program& program, const Command& command) {
  std::string line = fmt::format("\\fB{} {}\\fR", program.name, command.name);
  for (const Argument& argument : arguments_of(command))
    line += argument.required ? " " + usage(argument) : " [" + usage(argument) + "]";
  return line + '\n';
}

std::string options(const Command& command) {
  std::string list;
  for (const Argument& argument : arguments_of(command))
    list += fmt::format(".TP\n{}{}\n{}\n", argument.short_output ? "\\fB\\-o\\fR, " : "",
                        usage(argument), escaped(description_of(argument)));
  return list;
}

/// The documents that a command can make, with the option that requests each.
std::string documents(const Command& command) {
  std::string list;
  for (const Document& document : command.documents)
    list += fmt::format(".TP\n{}\n{}\n", escaped(enum_name(document.format)),
                        escaped(document.option.empty()
                                    ? fmt::format("by --format {}", document.name)
                                    : fmt::format("by --{}: {}", document.option, document.doc)));
  return list.empty() ? list
                      : list +
                            ".TP\njson\nby \\-\\-format json: all digits, in the envelope "
                            "of all results\n";
}

std::string exit_status() {
  std::string section = ".SH EXIT STATUS\n";
  for (const auto& [status, meaning] : kExitStatuses)
    section += fmt::format(".TP\n{}\n{}\n", static_cast<int>(status), meaning);
  return section;
}

}  // namespace

std::string program_page(const Program& program) {
  std::string page = head(std::string(program.name), program.summary);
  page +=
      fmt::format(".SH SYNOPSIS\n\\fB{}\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR ...]\n.SH COMMANDS\n",
                  program.name);
  for (const Command& command : program.table)
    page += fmt::format(".TP\n\\fB{} {}\\fR\n{}\n", program.name, command.name,
                        escaped(command.summary));
  page +=
      ".SH OPTIONS\n.TP\n\\fB\\-\\-help\\fR\nprint help; after a command, print the help of this "
      "command\n"
      ".TP\n\\fB\\-\\-version\\fR\nprint version and revision\n";
  page += exit_status();
  std::vector<std::string> pages;
  for (const std::string_view word : first_words(program))
    pages.push_back(fmt::format(".BR {}\\-{} (1)", program.name, word));
  return page + fmt::format(".SH SEE ALSO\n{}\n", fmt::join(pages, ",\n"));
}

std::string format_page() {
  return head(std::string(kFormatPage),
              "input file of strainwave: a strain wave gear with its cracks", 5) +
         ".SH DESCRIPTION\n" +
         escaped(
             "A drive is a text file in TOML. Quantities are text with any unit that can be "
             "converted, such as \"2.24 mm\"; pure numbers are bare. Every field is addressed "
             "by its path, such as output_shaft.crack[0].depth. Members that are left out add "
             "no compliance. The command strainwave new prints a file to begin with.\n") +
         ".SH FIELDS\n" + input_manual() + ".SH EDITORS\n" +
         escaped(
             "The command strainwave schema prints a JSON Schema. An editor uses this schema if "
             "the first line of a drive names its file:\n") +
         ".PP\n.nf\n#:schema ./strainwave\\-drive\\-1.schema.json\n.fi\n" +
         ".SH SEE ALSO\n.BR strainwave (1),\n.BR strainwave\\-new (1),\n.BR strainwave\\-schema "
         "(1)\n";
}

std::string command_page(const Program& program, std::string_view first_word) {
  const auto commands = commands_of(program, first_word);
  if (commands.empty())
    throw OptionError("command",
                      fmt::format("{} has no manual page; {} man --list prints all pages",
                                  shown(first_word), program.name));
  const Command& first = *commands.front();
  const bool group = !second_word(first).empty();
  std::string synopses;
  std::string lists;
  std::string made;
  std::string examples;
  for (const Command* const command : commands) {
    const std::string title =
        group ? fmt::format(".SS {}\n{}\n", second_word(*command), escaped(command->summary)) : "";
    synopses += (synopses.empty() ? "" : ".br\n") + synopsis(program, *command);
    lists += title + options(*command);
    if (!command->documents.empty()) made += title + documents(*command);
    examples += escaped(command->example) + '\n';
  }
  std::string page =
      head(fmt::format("{}-{}", program.name, first_word), summary_of(program, first_word));
  page += ".SH SYNOPSIS\n" + synopses;
  page += ".SH DESCRIPTION\n" + escaped(first.description) + '\n';
  page += ".SH OPTIONS\n" + lists;
  if (!made.empty()) page += ".SH DOCUMENTS\n" + made;
  page += exit_status();
  page += ".SH EXAMPLE\n.nf\n" + examples + ".fi\n";
  return page + fmt::format(".SH SEE ALSO\n.BR {} (1)\n", program.name);
}

}  // namespace strainwave::cli
