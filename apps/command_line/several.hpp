// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exit_code.hpp"
#include "strainwave/command/command.hpp"

namespace strainwave::cli {

/// The answer of a command for one of several files.
struct FileAnswer {
  std::string file;
  std::optional<Answer> answer;
  std::string fault;  ///< the reason why there is no usable answer; empty if the answer may be used
  ExitCode code = kOk;
};

/// Whether the answers of a command can stand in one table: its result has a headline.
[[nodiscard]] bool answers_several(const Command& command);

/// The exit status of a run over several files, which is that of the worst file.
[[nodiscard]] ExitCode worst_of(std::span<const FileAnswer> answers);

/// One document of several answers, a row for each file.
/// @param format  "text": headlines; "csv": all outputs; "json": the answers in their envelopes
[[nodiscard]] std::string several_document(std::string_view format,
                                           std::span<const FileAnswer> answers,
                                           const AskedUnits& units,
                                           const std::vector<std::string>& columns);

}  // namespace strainwave::cli
