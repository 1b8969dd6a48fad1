// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/command/command.hpp"

namespace strainwave::test {

/// Writes one line for each field of a result: path, kind, unit.
class FieldLines : public TypeVisitor {
 public:
  [[nodiscard]] const std::string& lines() const { return lines_; }

  void begin_record() override { open(""); }
  void end_record() override { path_.pop_back(); }
  void field(const Field& field, Presence presence) override {
    name_ = "." + std::string(field.name) + (presence == Presence::sometimes ? "?" : "");
  }
  void begin_list() override { open("[]"); }
  void end_list() override { path_.pop_back(); }
  void begin_map() override { open(".NAME"); }
  void end_map() override { path_.pop_back(); }
  void begin_alternatives() override { open(""); }
  void end_alternatives() override { path_.pop_back(); }
  void kind(std::string_view kind) override { path_.back() += "<" + std::string(kind) + ">"; }
  void column(const Field& field) override { leaf("column", field.unit); }
  void number(const Field& field) override { leaf("number", field.unit); }
  void quantity(const Field& field) override { leaf("quantity", field.unit); }
  void whole(const Field&) override { leaf("whole number", ""); }
  void flag() override { leaf("flag", ""); }
  void text() override { leaf("text", ""); }
  void choice(std::span<const std::string_view> names) override {
    std::string all;
    for (const std::string_view name : names) all += (all.empty() ? "" : "|") + std::string(name);
    leaf(all, "");
  }

 private:
  [[nodiscard]] std::string here() const { return (path_.empty() ? "" : path_.back()) + name_; }
  void open(std::string_view step) {
    path_.push_back(here() + std::string(step));
    name_.clear();
  }
  void leaf(std::string_view what, std::string_view unit) {
    lines_ += "  result " + here().substr(1) + ": " + std::string(what);
    if (!unit.empty()) lines_ += " [" + std::string(unit) + "]";
    lines_ += '\n';
  }

  std::vector<std::string> path_;
  std::string name_;  // name of the field that comes next
  std::string lines_;
};

inline std::string option_line(const Option& option) {
  constexpr std::array<std::string_view, 5> kKinds = {"flag", "whole number", "number", "text", ""};
  std::string line = "  option " + std::string(option.field.name) + ": " +
                     std::string(kKinds.at(static_cast<std::size_t>(option.kind)));
  for (std::size_t i = 0; i < option.choices.size(); ++i)
    line += (i == 0 ? "" : "|") + std::string(option.choices[i]);
  if (!option.field.unit.empty()) line += " [" + std::string(option.field.unit) + "]";
  if (option.required) line += ", required";
  if (option.repeatable) line += ", repeatable";
  if (!option.field.fallback.empty()) line += ", default " + std::string(option.field.fallback);
  return line + '\n';
}

/// The names that a user of a table can use: commands, options, result fields, documents.
inline std::string surface(std::span<const Command> table) {
  std::string all;
  for (const Command& command : table) {
    all += std::string(command.name) + (command.takes == Takes::drive ? " of a drive\n"
                                        : command.takes == Takes::drive_or_nothing
                                            ? " of a drive or nothing\n"
                                            : "\n");
    for (const Option& option : command.options.options) all += option_line(option);
    if (!command.journal.empty()) all += "  journal: " + std::string(command.journal) + '\n';
    if (!command.record.empty()) all += "  record: " + std::string(command.record) + '\n';
    if (!command.kept.empty())
      all += "  " + std::string(command.kept_option) + ": " + std::string(command.kept) + '\n';
    for (const Document& document : command.documents)
      all += "  document " + std::string(document.name) + ": " +
             std::string(enum_name(document.format)) + (document.folder ? " files\n" : "\n");
    FieldLines fields;
    command.walk({}, fields);
    all += fields.lines();
  }
  return all;
}

/// A change of the surface without a change of its listing fails.
inline void expect_listed(std::span<const Command> table, const std::string& name) {
  const std::string listing = STRAINWAVE_TEST_DATA "/" + name;
  if (std::getenv("STRAINWAVE_RENEW") != nullptr) std::ofstream(listing) << surface(table);
  std::ifstream stream(listing);
  std::ostringstream listed;
  listed << stream.rdbuf();
  EXPECT_EQ(surface(table), listed.str())
      << "The commands, options, documents or result fields are not those that tests/data/" << name
      << " lists.  If this is meant, run this test with STRAINWAVE_RENEW=1 in the environment, and "
         "name the change in CHANGELOG.md.";
}

}  // namespace strainwave::test
