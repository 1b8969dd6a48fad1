// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "exit_code.hpp"

// What the commands do, once the command line has been understood.  They translate and print;
// everything else is in the library.

namespace strainwave::cli {

/// Where output goes; empty: standard output.
struct Output {
  std::string format;
  std::string path;
};

struct StiffnessCommand {
  std::string file;
  std::string method = "corrected";
  Output output{.format = "text", .path = {}};
};
ExitCode run(const StiffnessCommand& command);

struct AuditCommand {
  Output output{.format = "text", .path = {}};
};
ExitCode run(const AuditCommand& command);

struct SweepCommand {
  std::string file;
  std::string method = "corrected";
  std::vector<std::string> vary;
  std::string plot;
  Output output{.format = "csv", .path = {}};
};
ExitCode run(const SweepCommand& command);

struct SolveCommand {
  std::string file;
  std::string method = "corrected";
  std::string vary;
  std::string target;
  Output output{.format = "text", .path = {}};
};
ExitCode run(const SolveCommand& command);

struct NewCommand {
  std::string path;
};
ExitCode run(const NewCommand& command);

struct SchemaCommand {
  Output output{.format = "json", .path = {}};
};
ExitCode run(const SchemaCommand& command);

/// Writes to a file, whole or not at all, or to standard output.
void deliver(const std::string& text, const std::string& path);

/// The command line itself cannot be understood.
struct UsageError {
  std::string message;
};

}  // namespace strainwave::cli
