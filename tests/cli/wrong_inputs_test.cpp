// SPDX-License-Identifier: Apache-2.0
// A table of wrong inputs: what is typed, how the program ends and what it says.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/sanitized.hpp"

namespace strainwave {
namespace {

using test::contents;
using test::Outcome;
using test::quoted;

/// Two lines of the table: "$ " and a command line, then the exit code and the message.
struct Row {
  std::string command;
  std::string outcome;
};

const std::string kTable = STRAINWAVE_TEST_DATA "/wrong_inputs.txt";

std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      result += text[i];
      continue;
    }
    const char c = text[++i];
    if (c == 'x') {
      result += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      result += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
    }
  }
  return result;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\\n" : c == '\\' ? "\\\\" : std::string(1, c);
  return result;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

std::vector<Row> rows_of(const std::string& table) {
  std::vector<Row> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    if (line.starts_with("$ "))
      rows.push_back({line.substr(2), {}});
    else
      rows.back().outcome = line;
  }
  return rows;
}

class WrongInputs : public test::ProgramTest {
 protected:
  /// Writes the file that "{example | from | to ...}", "{drive | text}" or "{csv | text}" stands
  /// for; a word of the command line.
  [[nodiscard]] std::string file_of(const std::string& braces) const {
    std::vector<std::string> parts;
    std::string rest = braces;
    for (std::size_t at = 0; (at = rest.find(" | ")) != std::string::npos; rest.erase(0, at + 3))
      parts.push_back(unescaped(rest.substr(0, at)));
    parts.push_back(unescaped(rest));
    if (parts[0] == "csv") return write("table.csv", parts.at(1));
    if (parts[0] == "drive") return write("drive.toml", parts.at(1));
    std::string text = contents(STRAINWAVE_EXAMPLES "/" + parts[0] + ".toml");
    EXPECT_FALSE(text.empty()) << braces;
    for (std::size_t i = 1; i + 1 < parts.size(); i += 2) {
      const std::size_t at = parts[i] == "END" ? text.size() : text.find(parts[i]);
      EXPECT_NE(at, std::string::npos) << braces << ": " << parts[i];
      if (at != std::string::npos)
        text.replace(at, parts[i] == "END" ? 0 : parts[i].size(), parts[i + 1]);
    }
    return write("drive.toml", text);
  }

  /// The exit code and the message of the program, with names of files as FILE.
  [[nodiscard]] std::string outcome_of(const Row& row) const {
    static const std::regex kBraces(R"(\{([a-z_0-9]+( \| .*?)?)\})");
    std::string words = row.command;
    for (std::smatch match; std::regex_search(words, match, kBraces);)
      words = match.prefix().str() + file_of(match[1].str()) + match.suffix().str();
    const Outcome outcome = execute(quoted(STRAINWAVE_CLI) + " " + words + " </dev/null");
    std::string said = outcome.err;
    for (const char* const name : {"drive.toml", "table.csv"})
      replace_all(said, in_folder(name).string(), "FILE");
    if (said.ends_with('\n')) said.pop_back();
    return std::to_string(outcome.exit_code) + " " + escaped(said);
  }
};

TEST_F(WrongInputs, ReferenceTable) {
  std::string table = contents(kTable);
  const bool renew = std::getenv("STRAINWAVE_RENEW") != nullptr;
  const std::vector<Row> rows = rows_of(table);
  EXPECT_GE(rows.size(), 300U);
  std::set<std::string> commands;
  std::string renewed;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    EXPECT_TRUE(commands.insert(row.command).second) << "twice: " << row.command;
    if (test::kSanitized && !renew && i % 4 != 0) continue;
    const std::string outcome = outcome_of(row);
    renewed += "\n$ " + row.command + "\n" + outcome + "\n";
    if (!renew) {
      EXPECT_EQ(outcome, row.outcome) << row.command;
    }
    // Wrong input must give neither an internal error nor success.
    EXPECT_TRUE(outcome[0] >= '2' && outcome[0] <= '7' && outcome[1] == ' ') << row.command << '\n'
                                                                             << outcome;
    EXPECT_EQ(outcome.find("internal error"), std::string::npos) << row.command;
  }
  if (renew)
    std::ofstream(kTable)
        << "# Wrong inputs: a command line, then the exit code and what is said.\n"
           "# {example | from | to} is a changed example, {drive | text} and {csv | "
           "text} are whole files.\n# STRAINWAVE_RENEW=1 tests/test_cli "
           "--gtest_filter='WrongInputs*' writes the answers again: read the "
           "difference.\n"
        << renewed;
}

}  // namespace
}  // namespace strainwave
