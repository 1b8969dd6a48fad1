// SPDX-License-Identifier: Apache-2.0
#include "known_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "exit_code.hpp"
#include "files.hpp"
#include "recording.hpp"

namespace strainwave::cli {
namespace {

bool writes(const Argument& argument) {
  return argument.role == Role::output || argument.role == Role::journal ||
         argument.role == Role::record || argument.role == Role::kept ||
         argument.role == Role::rows || argument.role == Role::document;
}

[[noreturn]] void refuse(const std::string& one, const std::string& other,
                         const std::string& path) {
  throw UsageError(fmt::format("{} and {} name the same file, {}: write to another file", one,
                               other, shown(path)));
}

}  // namespace

KnownFiles::KnownFiles(const Given& given, const std::vector<std::string>& inputs) {
  for (const std::string& path : inputs) add_input("FILE", path);
  for (std::size_t i = 0; i < given.arguments.size(); ++i) {
    const Argument& argument = given.arguments[i];
    for (const std::string& path : given.texts[i])
      if (writes(argument)) {
        if ((argument.role == Role::record || argument.role == Role::kept ||
             argument.role == Role::rows) &&
            path.empty())
          throw UsageError(fmt::format("{} must name a file; give its name", argument.name));
        add_output(argument.name, path);
        if (argument.role == Role::record) add_output(argument.name, checkpoint_of(path));
      } else if (argument.names == "attachment" || argument.names == "history" ||
                 argument.names == "shard") {
        add_input(argument.name, path);
      }
  }
  if (!has(given, Role::output)) add_output("the main document", "/dev/stdout");
  for (const auto& [name, path] : outputs_) require_free(name, path);
}

void KnownFiles::add_tables_of(const Drive& drive, const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (const auto& [name, table] : drive.gear.compliance_tables)
    add_input("compliance_table", (folder / name).string());
  for (const auto& [name, table] : drive.gear.turn_tables)
    add_input("turn_table", (folder / name).string());
  if (drive.gear.duty && drive.gear.duty->history)
    add_input("duty.history", (folder / *drive.gear.duty->history).string());
  for (const auto& [name, path] : outputs_) require_not_read(name, path);
}

void KnownFiles::require_not_read(const std::string& name, const std::string& path) const {
  const auto input = inputs_.find(identity_of(path));
  if (input != inputs_.end()) refuse(input->second, name, path);
}

void KnownFiles::add_input(const std::string& name, const std::string& path) {
  if (path.empty())
    throw UsageError(
        fmt::format("{} must name a file; give its name, or - for standard input", name));
  if (std::string file = identity_of(path); !file.empty())
    inputs_.try_emplace(std::move(file), name);
}

void KnownFiles::add_output(const std::string& name, const std::string& path) {
  if (path.empty())
    throw UsageError(
        fmt::format("{} must name a file; leave it out for standard output, or give -", name));
  outputs_.emplace_back(name, path);
}

void KnownFiles::require_free(const std::string& name, const std::string& path) {
  if (is_standard_output(path)) {
    if (!to_standard_output_.empty())
      throw UsageError(fmt::format("{} and {} both go to standard output: name a file",
                                   to_standard_output_, name));
    to_standard_output_ = name;
    return;
  }
  require_not_read(name, path);
  const std::string file = identity_of(path);
  const auto [other, fresh] = written_.try_emplace(file, name);
  if (!file.empty() && !fresh) refuse(other->second, name, path);
}

}  // namespace strainwave::cli
