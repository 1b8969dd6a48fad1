// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
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

struct SensitivityCommand {
  std::string file;
  bool scatter = false;
  int samples = 100'000;
  std::uint64_t seed = 1;
  int threads = 0;
  std::string plot;
  Output output{.format = "text", .path = {}};
};
ExitCode run(const SensitivityCommand& command);

struct TorsionCommand {
  std::string file;
  bool compare = false;
  int angles = 0;
  int draws = 200;
  std::string plot;
  Output output{.format = "text", .path = {}};
};
ExitCode run(const TorsionCommand& command);

struct MaterialListCommand {
  std::string use;  ///< empty: all
  Output output{.format = "text", .path = {}};
};
ExitCode run(const MaterialListCommand& command);

struct MaterialShowCommand {
  std::string name;
  Output output{.format = "text", .path = {}};
};
ExitCode run(const MaterialShowCommand& command);

struct CatalogueCommand {
  std::optional<int> size;
  std::optional<double> ratio;
  Output output{.format = "text", .path = {}};
};
ExitCode run(const CatalogueCommand& command);

struct ValidateCommand {
  std::string mode = "geometry";
  std::string factors;
  bool all_sets = false;
  int draws = 0;
  std::string plot;
  Output output{.format = "text", .path = {}};
};
ExitCode run(const ValidateCommand& command);

struct CalibrateCommand {
  std::string file;
  bool catalogue = false;
  std::string measured;
  std::string factors = "support,coning";
  std::string format = "text";
  std::string path;  ///< of the calibrated drive; empty: none is written
};
ExitCode run(const CalibrateCommand& command);

struct ReportCommand {
  std::string file;
  std::string method = "corrected";
  std::string date;  ///< to be printed; empty: of SOURCE_DATE_EPOCH, or none
  std::string path;
};
ExitCode run(const ReportCommand& command);

/// Becomes strainwave-fe, which lies beside this program or on PATH.
struct FeCommand {
  std::vector<std::string> arguments;
};
ExitCode run(const FeCommand& command);

/// With a size and a ratio, a typical drive; else the template of all fields.
struct NewCommand {
  std::optional<int> size;
  std::optional<double> ratio;
  std::string cup = "short";
  std::string path;
};
ExitCode run(const NewCommand& command);

struct SchemaCommand {
  Output output{.format = "json", .path = {}};
};
ExitCode run(const SchemaCommand& command);

struct SifListCommand {
  std::string family;
  Output output{.format = "text", .path = {}};
};
ExitCode run(const SifListCommand& command);

struct SifShowCommand {
  std::string name;
  Output output{.format = "text", .path = {}};
};
ExitCode run(const SifShowCommand& command);

struct SifEvalCommand {
  std::string name;
  std::vector<std::string> set;
  std::string material;  ///< of the library; empty: E = 210 GPa, nu = 0.3
  Output output{.format = "text", .path = {}};
};
ExitCode run(const SifEvalCommand& command);

struct SifPlotCommand {
  std::string name;
  std::vector<std::string> set;
  std::string path;
};
ExitCode run(const SifPlotCommand& command);

}  // namespace strainwave::cli
