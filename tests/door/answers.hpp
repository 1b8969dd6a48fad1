// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "strainwave/door/door.hpp"
#include "strainwave/io/attachments.hpp"
#include "support/program.hpp"

namespace strainwave::test {

/// The drives of the examples, by their names without ".toml".
inline const std::map<std::string, std::shared_ptr<const Drive>>& example_drives() {
  static const auto drives = [] {
    std::map<std::string, std::shared_ptr<const Drive>> read;
    for (const auto& entry : std::filesystem::directory_iterator(STRAINWAVE_EXAMPLES))
      if (entry.path().extension() == ".toml")
        read[entry.path().stem().string()] =
            read_drive(contents(entry.path()), entry.path().filename().string(),
                       attachments_beside(entry.path()));
    return read;
  }();
  return drives;
}

inline Answer run_command(std::string_view command, std::shared_ptr<const Drive> drive,
                          std::string_view options = "{}", const OptionTexts& texts = {},
                          const Progress& progress = {}) {
  const Command& row = command_named(commands(), command);
  OptionValues values(row.options);
  values.set_from_json(options);
  return run(row, std::move(drive), values, texts, progress);
}

inline Answer run_on_example(std::string_view command, const std::string& example,
                             std::string_view options = "{}") {
  return run_command(command, example_drives().at(example), options);
}

/// Options, as JSON, that show each part of a command's result at little cost.
inline const std::multimap<std::string, std::string, std::less<>>& trial_options() {
  static const auto options = [] {
    std::multimap<std::string, std::string, std::less<>> read;
    std::istringstream lines(contents(STRAINWAVE_TEST_DATA "/command_trials.txt"));
    for (std::string line; std::getline(lines, line);)
      if (const auto json = line.find('{'); !line.starts_with('#') && json != std::string::npos)
        read.emplace(line.substr(0, json - 1), line.substr(json));
    return read;
  }();
  return options;
}

/// The texts that they name.
inline OptionTexts trial_texts() {
  OptionTexts texts;
  for (const char* const name : {"article.toml", "through_crack.toml", "joint_history.csv",
                                 "spline_teeth.csv", "growth_specimens.csv", "detection_hits.csv"})
    texts[name] = contents(std::filesystem::path(STRAINWAVE_EXAMPLES) / name);
  return texts;
}

}  // namespace strainwave::test
