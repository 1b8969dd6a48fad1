// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <fmt/format.h>

#include <iostream>
#include <iterator>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/input_format.hpp"
#include "strainwave/io/result_writer.hpp"
#include "strainwave/study/audit.hpp"
#include "strainwave/study/evaluate.hpp"
#include "strainwave/study/plot.hpp"
#include "strainwave/study/solve.hpp"
#include "strainwave/study/sweep.hpp"

namespace strainwave::cli {
namespace {

GearSet read_input(const std::string& file) {
  if (file != "-") return read_gear_set_file(file);
  const std::string text((std::istreambuf_iterator<char>(std::cin)),
                         std::istreambuf_iterator<char>());
  return read_gear_set(text, "standard input");
}

/// The command line has checked the name.
Method method_named(const std::string& name) { return enum_value<Method>(name).value(); }

Provenance provenance_of(const std::string& file) {
  return {.version = std::string(version()),
          .revision = std::string(git_revision()),
          .input_file = file == "-" ? "standard input" : file,
          .quadrature_tolerance = QuadratureOptions{}.relative_tolerance};
}

void warn(std::string_view message) { std::cerr << "strainwave: " << message << '\n'; }

/// A range or a target that cannot be read is a fault of the command line, not of the input.
template <class Parse>
auto from_command_line(const Parse& parse) {
  try {
    return parse();
  } catch (const InputError& error) {
    throw UsageError{error.what()};
  }
}

}  // namespace

void deliver(const std::string& text, const std::string& path) {
  if (!path.empty()) {
    write_file(path, text);
    return;
  }
  std::cout << text << std::flush;
  if (!std::cout) throw Error("standard output cannot be written");
}

ExitCode run(const StiffnessCommand& command) {
  const GearSet gear = read_input(command.file);
  const StiffnessResult result = evaluate(gear, method_named(command.method));
  const Provenance provenance = provenance_of(command.file);
  deliver(command.output.format == "json"  ? result_json(result, gear, provenance)
          : command.output.format == "csv" ? result_csv(result)
                                           : result_text(result, gear, provenance),
          command.output.path);
  if (result.usable()) return kOk;
  warn(result.unusable_because);
  return kNotUsable;
}

ExitCode run(const AuditCommand& command) {
  const std::vector<AuditRow> rows = audit();
  deliver(command.output.format == "json"       ? audit_json(rows)
          : command.output.format == "markdown" ? audit_markdown(rows)
                                                : audit_text(rows),
          command.output.path);
  return kOk;
}

ExitCode run(const SweepCommand& command) {
  const GearSet gear = read_input(command.file);
  const auto variations = from_command_line([&] {
    std::vector<Variation> parsed;
    for (const std::string& text : command.vary) parsed.push_back(parse_variation(gear, text));
    return parsed;
  });
  const SweepResult result = sweep(gear, method_named(command.method), variations);
  // Both texts are made before either file is written: a failure leaves nothing behind.
  const std::string table =
      command.output.format == "json"
          ? with_provenance(sweep_json(result), gear, provenance_of(command.file))
          : sweep_csv(result);
  const std::string plot = command.plot.empty() ? std::string() : sweep_plot(result, gear);
  if (!plot.empty()) write_file(command.plot, plot);
  deliver(table, command.output.path);

  std::size_t n_unusable = 0;
  for (const SweepRow& row : result.rows) n_unusable += row.usable() ? 0 : 1;
  if (n_unusable > 0)
    warn(fmt::format("{} of {} points are not usable; the column `reason` says why", n_unusable,
                     result.rows.size()));
  return n_unusable == result.rows.size() ? kNotUsable : kOk;
}

ExitCode run(const SolveCommand& command) {
  const GearSet gear = read_input(command.file);
  const Method method = method_named(command.method);
  const Unknown unknown = from_command_line([&] { return parse_unknown(gear, command.vary); });
  const Target target =
      from_command_line([&] { return parse_target(gear, method, command.target); });
  const SolveResult result = solve(gear, method, unknown, target);
  deliver(command.output.format == "json"
              ? with_provenance(solve_json(result), gear, provenance_of(command.file))
              : solve_text(result),
          command.output.path);
  if (!result.reason.empty()) warn(result.reason);
  return result.usable() ? kOk : kNotUsable;
}

ExitCode run(const NewCommand& command) {
  deliver(input_template(), command.path);
  return kOk;
}

ExitCode run(const SchemaCommand& command) {
  deliver(command.output.format == "markdown" ? input_reference() : input_schema(),
          command.output.path);
  return kOk;
}

}  // namespace strainwave::cli
