// SPDX-License-Identifier: Apache-2.0
#include "completion.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "files.hpp"

namespace strainwave::cli {
namespace {

/// A command line up to the word to complete.
struct Line {
  std::vector<std::string> before;  // options and their values as separate words
  std::string current;
  std::string kept;  // part of the completed word in front of `current`: "--method="
};

Line line_of(std::span<const std::string> words) {
  Line line;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    const bool last = i + 1 == words.size();
    const bool value = !line.before.empty() && line.before.back().starts_with("--");
    if (word == "=" && value) {
      if (last)
        word.clear();
      else
        continue;
    }
    const std::size_t equals = word.find('=');
    if (word.starts_with("--") && equals != std::string::npos) {
      line.before.push_back(word.substr(0, equals));
      if (last) line.kept = word.substr(0, equals + 1);
      word.erase(0, equals + 1);
    }
    if (last)
      line.current = word;
    else
      line.before.push_back(word);
  }
  return line;
}

/// The candidates that begin with `current`, as whole words.
std::vector<std::string> matching(const std::vector<std::string>& known, const Line& line) {
  std::vector<std::string> found;
  for (const std::string& word : known)
    if (word.starts_with(line.current)) found.push_back(line.kept + word);
  return found;
}

const Argument* argument_named(const std::vector<Argument>& arguments, std::string_view name) {
  const auto found = std::ranges::find_if(arguments, [&](const Argument& argument) {
    return argument.name == name || (argument.short_output && name == "-o");
  });
  return found == arguments.end() ? nullptr : &*found;
}

/// All names that an argument can take.
std::vector<std::string> names_of(const Program& program, std::string_view what,
                                  const std::string& file) {
  std::vector<std::string> names;
  if (what == "command") {
    for (const Command& command : program.table) names.emplace_back(command.name);
  } else if (what != "field path") {
    if (program.names != nullptr) names = program.names(what, file);
  } else if (!file.empty() && file != "-") {  // standard input is reserved for the command itself
    const auto drive = read_drive(text_of(file), file, attachments_beside(file));
    for_each_number(drive->gear, [&](const FieldPath& path, const Field&, const double&) {
      names.push_back(path.text());
    });
  }
  return names;
}

/// Candidates for the value of an argument.
std::vector<std::string> values(const Program& program, const Argument& argument,
                                const std::string& file, Line line) {
  if (argument.type == "PATH") return {std::string(kFiles)};
  std::vector<std::string> known(argument.choices.begin(), argument.choices.end());
  if (!argument.names.empty()) {
    known = names_of(program, argument.names, file);
    // In a list with commas, complete the last name.
    if (argument.names == "factor" || argument.names == "unit")
      if (const std::size_t comma = line.current.rfind(','); comma != std::string::npos) {
        line.kept += line.current.substr(0, comma + 1);
        line.current.erase(0, comma + 1);
      }
  }
  return matching(known, line);
}

}  // namespace

std::vector<std::string> completions(const Program& program, std::span<const std::string> words) {
  const Line line = line_of(words);
  auto word = line.before.begin();
  if (word == line.before.end()) {
    std::vector<std::string> known = {"--help", "--version"};
    for (const std::string_view first : first_words(program)) known.emplace_back(first);
    std::vector<std::string> found = matching(known, line);
    if (!found.empty() || program.unnamed.empty()) return found;
  }
  const bool named = word != line.before.end() && !means_unnamed(program, *word);
  const auto commands = commands_of(program, named ? *word++ : program.unnamed);
  if (commands.empty()) return {};
  const Command* command = commands.front();
  if (!second_word(*command).empty()) {
    if (word == line.before.end()) {
      std::vector<std::string> known = {"--help"};
      for (const Command* const one : commands) known.emplace_back(second_word(*one));
      return matching(known, line);
    }
    const auto found = std::ranges::find_if(
        commands, [&](const Command* one) { return second_word(*one) == *word; });
    if (found == commands.end()) return {};
    command = *found;
    ++word;
  }

  // Read the words before: the input, the filled places, and the option whose value comes next.
  const std::vector<Argument> arguments = arguments_of(*command);
  std::vector<const Argument*> places;
  for (const Argument& argument : arguments)
    if (argument.positional()) places.push_back(&argument);
  std::string file;
  const Argument* awaits = nullptr;
  for (; word != line.before.end(); ++word) {
    if (awaits != nullptr) {
      awaits = nullptr;
    } else if (word->starts_with('-') && *word != "-") {
      awaits = argument_named(arguments, *word);
      if (awaits != nullptr && awaits->type.empty()) awaits = nullptr;
    } else if (!places.empty()) {
      if (places.front()->role == Role::input) file = *word;
      if (!places.front()->repeatable) places.erase(places.begin());
    }
  }
  if (awaits != nullptr) return values(program, *awaits, file, line);
  if (!line.current.starts_with('-') && !places.empty())
    return values(program, *places.front(), file, line);
  std::vector<std::string> known = {"--help"};
  for (const Argument& argument : arguments)
    if (!argument.positional()) known.push_back(argument.name);
  return matching(known, line);
}

std::string completion_script(const Program& program, Shell shell) {
  // In each script, PROGRAM is replaced by the program's name.
  static constexpr std::array<std::string_view, 3> kScripts = {
      R"sh(# bash completion of PROGRAM
_PROGRAM() {
  local word line quote=
  local -a words=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
    case $word in [\'\"]*) quote=1 ;; *) quote= ;; esac
    word=${word//\\/}
    word=${word#[\'\"]}
    words+=("${word%[\'\"]}")
  done
  COMPREPLY=()
  while IFS= read -r line; do
    if [[ $line == :files ]]; then
      mapfile -t COMPREPLY < <(compgen -f -- "$word")
      compopt -o filenames 2>/dev/null
    elif [[ $quote ]]; then
      COMPREPLY+=("$line")
    else
      COMPREPLY+=("$(printf %q "$line")")
    fi
  done < <("${COMP_WORDS[0]}" completion words -- "${words[@]}" 2>/dev/null)
}
complete -F _PROGRAM PROGRAM
)sh",
      R"sh(#compdef PROGRAM
_PROGRAM() {
  local -a answers
  answers=("${(@f)$("${words[1]}" completion words -- "${(@Q)words[2,CURRENT]}" 2>/dev/null)}")
  if [[ $answers[1] == :files ]]; then
    _files
  else
    compadd -- ${answers:#}
  fi
}
if [[ $funcstack[1] == _PROGRAM ]]; then
  _PROGRAM "$@"
else
  compdef _PROGRAM PROGRAM
fi
)sh",
      R"sh(# fish completion of PROGRAM
function __PROGRAM_answers
  set -l words (commandline -opc)
  set -l answers ($words[1] completion words -- $words[2..-1] (commandline -ct) 2>/dev/null)
  if test "$answers[1]" = ":files"
    __fish_complete_path (commandline -ct)
  else
    printf '%s\n' $answers
  end
end
complete -c PROGRAM -f -a '(__PROGRAM_answers)'
)sh"};
  constexpr std::string_view kStandsFor = "PROGRAM";
  std::string script(kScripts[static_cast<std::size_t>(shell)]);
  for (std::size_t at = 0; (at = script.find(kStandsFor, at)) != std::string::npos;)
    script.replace(at, kStandsFor.size(), program.name);
  return script;
}

}  // namespace strainwave::cli
