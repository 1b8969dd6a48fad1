// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include "files.hpp"
#include "strainwave/catalogue/calibration.hpp"
#include "strainwave/catalogue/catalogue.hpp"
#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/catalogue/validation.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "strainwave/io/input_format.hpp"
#include "strainwave/io/result_writer.hpp"
#include "strainwave/materials/material_library.hpp"
#include "strainwave/report/report.hpp"
#include "strainwave/study/audit_report.hpp"
#include "strainwave/study/material_report.hpp"
#include "strainwave/study/plot.hpp"
#include "strainwave/study/scatter.hpp"
#include "strainwave/study/sensitivity.hpp"
#include "strainwave/study/sensitivity_report.hpp"
#include "strainwave/study/sif_report.hpp"
#include "strainwave/study/solve.hpp"
#include "strainwave/study/sweep.hpp"
#include "strainwave/study/torsion_report.hpp"
#include "strainwave/study/validation_plot.hpp"

namespace strainwave::cli {
namespace {

GearSet read_input(const std::string& file) {
  if (file != "-") return read_gear_set_file(file);
  constexpr std::string_view kName = "standard input";
  return read_gear_set(read_text(std::cin, kName), kName, attachments_beside(file));
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

/// The day of SOURCE_DATE_EPOCH, which makes builds repeatable; empty if it is not set.
std::string build_date() {
  const char* const variable = std::getenv("SOURCE_DATE_EPOCH");
  if (variable == nullptr || *variable == '\0') return {};
  const std::string_view text = variable;
  constexpr std::int64_t kMost = 253402300799;  // the end of the year 9999
  std::int64_t seconds = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (fault != std::errc() || end != text.data() + text.size() || seconds < 0 || seconds > kMost)
    throw UsageError{fmt::format("SOURCE_DATE_EPOCH is not seconds since 1970: {}", shown(text))};
  const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(
      std::chrono::sys_seconds(std::chrono::seconds(seconds)))};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
}

/// The calibrated drive as a file that says how it came about.
std::string calibrated_file(const Calibration& calibration) {
  std::string head = "# Calibrated with " + calibration.source + ".\n";
  for (const CalibratedFactor& factor : calibration.factors)
    head += fmt::format("# {}: {:.4g}, was {:.4g}; standard uncertainty {:.2g}, {}\n",
                        enum_name(factor.factor), factor.value, factor.before, factor.uncertainty,
                        factor.identified ? "identified" : "not identified") +
            (factor.at_limit    ? "#   at the limit of what a fit may take\n"
             : factor.plausible ? ""
                                : "#   outside what is plausible\n");
  return head + gear_text(calibration.gear);
}

/// A range or a target that cannot be read is a fault of the command line, not of the input.
template <class Parse>
auto from_command_line(const Parse& parse) {
  try {
    return parse();
  } catch (const InputError& error) {
    throw UsageError{error.what()};
  }
}

/// Elastic constants and toughness of a steel of the material library.
sif::CrackMaterial crack_material(const std::string& name) {
  if (name.empty()) return {};
  const Material steel = as_material(require_material(name));
  const ElasticConstants elastic = elastic_constants(steel);
  return {.youngs_modulus = elastic.E,
          .poissons_ratio = elastic.nu,
          .fracture_toughness = steel.fracture_toughness};
}

}  // namespace

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

ExitCode run(const SensitivityCommand& command) {
  const GearSet gear = read_input(command.file);
  SensitivityReport report{.sensitivity = sensitivity_of(gear), .scatter = {}};
  if (command.scatter)
    report.scatter =
        scatter_of(gear, report.sensitivity,
                   {.samples = command.samples, .seed = command.seed, .threads = command.threads});
  // Both texts are made before either file is written: a failure leaves nothing behind.
  const std::string text =
      command.output.format == "json"
          ? with_provenance(sensitivity_json(report), gear, provenance_of(command.file))
      : command.output.format == "csv" ? sensitivity_csv(report)
                                       : sensitivity_text(report, gear);
  const std::string plot = command.plot.empty() ? std::string() : tornado_plot(report, gear);
  if (!plot.empty()) write_file(command.plot, plot);
  deliver(text, command.output.path);
  if (report.sensitivity.usable()) return kOk;
  warn(report.sensitivity.unusable_because);
  return kNotUsable;
}

ExitCode run(const TorsionCommand& command) {
  const GearSet gear = read_input(command.file);
  const TorsionReport report = torsion_report(
      gear, {.compare = command.compare, .angles = command.angles, .draws = command.draws});
  // Both texts are made before either file is written: a failure leaves nothing behind.
  const std::string text =
      command.output.format == "json"
          ? with_provenance(torsion_json(report), gear, provenance_of(command.file))
      : command.output.format == "csv" ? torsion_csv(report)
                                       : torsion_text(report, gear);
  const std::string plot = command.plot.empty() ? std::string() : torsion_plot(report, gear);
  if (!plot.empty()) write_file(command.plot, plot);
  deliver(text, command.output.path);
  return kOk;
}

ExitCode run(const MaterialListCommand& command) {
  const std::optional<MaterialUse> use = enum_value<MaterialUse>(command.use);
  deliver(command.output.format == "json"       ? material_list_json(use)
          : command.output.format == "markdown" ? material_list_markdown(use)
                                                : material_list_text(use),
          command.output.path);
  return kOk;
}

ExitCode run(const MaterialShowCommand& command) {
  const MaterialRecord& record = require_material(command.name);
  deliver(command.output.format == "json" ? material_json(record) : material_text(record),
          command.output.path);
  return kOk;
}

ExitCode run(const CatalogueCommand& command) {
  const CatalogueFilter filter{.size = command.size, .ratio = command.ratio};
  deliver(from_command_line([&] {
            return command.output.format == "json"  ? catalogue_json(filter)
                   : command.output.format == "csv" ? catalogue_csv(filter)
                                                    : catalogue_text(filter);
          }),
          command.output.path);
  return kOk;
}

ExitCode run(const ValidateCommand& command) {
  const Validation validation = from_command_line([&] {
    return validate({.mode = enum_value<ValidationMode>(command.mode).value(),
                     .factors = command.factors.empty() ? std::vector<Factor>()
                                                        : parse_factors(command.factors),
                     .all_sets = command.all_sets,
                     .draws = command.draws,
                     .sizes = {},
                     .coupled = {}});
  });
  // Both texts are made before either file is written: a failure leaves nothing behind.
  const std::string text = command.output.format == "json"       ? validation_json(validation)
                           : command.output.format == "csv"      ? validation_csv(validation)
                           : command.output.format == "markdown" ? validation_markdown(validation)
                                                                 : validation_text(validation);
  const std::string plot = command.plot.empty() ? std::string() : validation_plot(validation);
  if (!plot.empty()) write_file(command.plot, plot);
  deliver(text, command.output.path);
  return kOk;
}

ExitCode run(const CalibrateCommand& command) {
  if (command.catalogue != command.measured.empty())
    throw UsageError{"calibrate needs one of --catalogue and --measured"};
  const auto factors = from_command_line([&] { return parse_factors(command.factors); });
  const GearSet gear = read_input(command.file);
  const Calibration calibration = calibrate(
      gear,
      command.catalogue
          ? catalogue_target(gear)
          : measured_target(parse_measured_curve(text_of(command.measured), command.measured),
                            command.measured),
      factors);
  const std::string text =
      command.format == "json"
          ? with_provenance(calibration_json(calibration), gear, provenance_of(command.file))
          : calibration_text(calibration);
  if (!command.path.empty()) write_file(command.path, calibrated_file(calibration));
  deliver(text, {});
  if (calibration.converged) return kOk;
  warn("the calibration has not converged");
  return kNotUsable;
}

ExitCode run(const ReportCommand& command) {
  const std::string text = text_of(command.file);
  const Provenance provenance = provenance_of(command.file);
  const GearSet gear = read_gear_set(text, provenance.input_file, attachments_beside(command.file));
  const Report report = make_report(gear, provenance,
                                    {.method = method_named(command.method),
                                     .input_text = text,
                                     .date = command.date.empty() ? build_date() : command.date});
  deliver(report_html(report), command.path);
  if (report.result.usable()) return kOk;
  warn(report.result.unusable_because);
  return kNotUsable;
}

ExitCode run(const NewCommand& command) {
  if (command.size.has_value() != command.ratio.has_value())
    throw UsageError{"new needs --size and --ratio together, or neither"};
  if (!command.size) {
    deliver(input_template(), command.path);
    return kOk;
  }
  const CommentedDrive drive = from_command_line([&] {
    return starting_drive(*command.size, *command.ratio, enum_value<Cup>(command.cup).value());
  });
  deliver(
      "# A typical drive of this size and ratio: no maker publishes the geometry of one.\n"
      "# Behind each number: how it is known, its limits, and where they come from.\n" +
          gear_text(drive.gear, drive.comments),
      command.path);
  return kOk;
}

ExitCode run(const SchemaCommand& command) {
  deliver(command.output.format == "markdown" ? input_reference() : input_schema(),
          command.output.path);
  return kOk;
}

ExitCode run(const SifListCommand& command) {
  deliver(from_command_line([&] {
            return command.output.format == "json"       ? sif_list_json(command.family)
                   : command.output.format == "markdown" ? sif_list_markdown(command.family)
                                                         : sif_list_text(command.family);
          }),
          command.output.path);
  return kOk;
}

ExitCode run(const SifShowCommand& command) {
  const sif::Row& row = sif::solution(command.name);
  deliver(command.output.format == "json" ? sif_solution_json(row) : sif_solution_text(row),
          command.output.path);
  return kOk;
}

ExitCode run(const SifEvalCommand& command) {
  const sif::Row& row = sif::solution(command.name);
  const sif::Evaluation evaluation =
      sif::evaluate(row, sif_assignments(row, command.set), crack_material(command.material));
  deliver(command.output.format == "json" ? sif_evaluation_json(evaluation)
                                          : sif_evaluation_text(evaluation),
          command.output.path);
  if (evaluation.converged) return kOk;
  warn("the integral of the added compliance has not converged");
  return kNotUsable;
}

ExitCode run(const SifPlotCommand& command) {
  const sif::Row& row = sif::solution(command.name);
  deliver(sif_plot(row, sif_assignments(row, command.set)), command.path);
  return kOk;
}

}  // namespace strainwave::cli
