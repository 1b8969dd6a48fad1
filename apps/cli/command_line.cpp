// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>

#include "commands.hpp"
#include "manual.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/materials/material_record.hpp"
#include "strainwave/study/scatter.hpp"
#include "table_commands.hpp"

namespace strainwave::cli {
namespace {

constexpr const char* kFile = "input file, or - for standard input";

/// The command line: options fill plain structs; nothing runs before all of it is understood.
class CommandLine {
 public:
  CommandLine() {
    app_.name("strainwave");
    app_.set_version_flag("--version", fmt::format("strainwave {} ({})", version(), git_revision()),
                          "print version and revision, and exit");
    app_.require_subcommand(1);
    app_.get_formatter()->column_width(34);
    add_commands(app_, strainwave::commands(), {}, strainwave::read_drive,
                 [this](std::function<ExitCode()> work) { chosen_ = std::move(work); });
    add_audit();
    add_sweep();
    add_solve();
    add_sensitivity();
    add_torsion();
    add_material();
    add_catalogue();
    add_validate();
    add_calibrate();
    add_sif();
    add_report();
    add_fe();
    add_new();
    add_schema();
    add_man();
  }

  ExitCode run(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      // CLI11 prints help and version through an "error" of code 0.
      return app_.exit(error) == 0 ? kOk : kUsage;
    }
    return chosen_();
  }

 private:
  CLI::App* command(const std::string& name) {
    const CommandManual& page = manual_of(name);
    CLI::App* const sub = app_.add_subcommand(name, page.summary);
    sub->footer("Example:\n  " + page.example);
    return sub;
  }

  template <class Command>
  void runs(CLI::App* sub, Command& command) {
    sub->callback([this, &command] { chosen_ = [&command] { return cli::run(command); }; });
  }

  static void add_method(CLI::App* sub, std::string& method) {
    sub->add_option("--method", method, "as-printed, repaired or corrected")
        ->check(CLI::IsMember({"as-printed", "repaired", "corrected"}))
        ->capture_default_str();
  }

  static void add_output(CLI::App* sub, Output& output, const std::vector<std::string>& formats) {
    sub->add_option("--format", output.format, fmt::format("{}", fmt::join(formats, ", ")))
        ->check(CLI::IsMember(formats))
        ->capture_default_str();
    add_path(sub, output.path);
  }

  static void add_path(CLI::App* sub, std::string& path) {
    sub->add_option("-o,--output", path, "write to this file instead of standard output")
        ->type_name("PATH");
  }

  void add_audit() {
    CLI::App* const sub = command("audit");
    add_output(sub, audit_.output, {"text", "json", "markdown"});
    runs(sub, audit_);
  }

  void add_sweep() {
    CLI::App* const sub = command("sweep");
    sub->add_option("FILE", sweep_.file, kFile)->required();
    sub->add_option("--vary", sweep_.vary,
                    "PATH=FROM..TO:N[:log], a field and its range with units; once or twice")
        ->required()
        ->type_name("RANGE")
        ->allow_extra_args(false)  // or it would swallow FILE
        ->take_all();
    add_method(sub, sweep_.method);
    add_output(sub, sweep_.output, {"csv", "json"});
    sub->add_option("--plot", sweep_.plot, "draw the sweep as an SVG file")->type_name("PATH");
    runs(sub, sweep_);
  }

  void add_solve() {
    CLI::App* const sub = command("solve");
    sub->add_option("FILE", solve_.file, kFile)->required();
    sub->add_option("--vary", solve_.vary, "PATH[=FROM..TO], the field to find, and where")
        ->required()
        ->type_name("FIELD");
    sub->add_option("--target", solve_.target, "OUTPUT=VALUE, with a unit")
        ->required()
        ->type_name("TARGET");
    add_method(sub, solve_.method);
    add_output(sub, solve_.output, {"text", "json"});
    runs(sub, solve_);
  }

  void add_sensitivity() {
    CLI::App* const sub = command("sensitivity");
    sub->add_option("FILE", sensitivity_.file, kFile)->required();
    CLI::Option* const scatter =
        sub->add_flag("--scatter", sensitivity_.scatter,
                      "combined uncertainty by the scatter that the file gives");
    sub->add_option("--samples", sensitivity_.samples, "draws of the Monte Carlo study")
        ->check(CLI::Range(2, kMaxSamples))
        ->capture_default_str()
        ->needs(scatter);
    sub->add_option("--seed", sensitivity_.seed, "of the draws")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str()
        ->needs(scatter);
    sub->add_option("--threads", sensitivity_.threads,
                    "0 for all that there are; the answer is the same for any number")
        ->check(CLI::Range(0, 256))
        ->capture_default_str()
        ->needs(scatter);
    add_output(sub, sensitivity_.output, {"text", "json", "csv"});
    sub->add_option("--plot", sensitivity_.plot, "draw the elasticities as an SVG file")
        ->type_name("PATH");
    runs(sub, sensitivity_);
  }

  void add_torsion() {
    CLI::App* const sub = command("torsion");
    sub->add_option("FILE", torsion_.file, kFile)->required();
    sub->add_flag("--compare", torsion_.compare, "with the cracks of the file against without");
    sub->add_option("--angles", torsion_.angles,
                    "positions of the wave generator for --compare; 0 for every tooth")
        ->check(CLI::Range(0, 720))
        ->capture_default_str();
    sub->add_option("--draws", torsion_.draws, "drives drawn from the file's ranges; 0 for none")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    add_output(sub, torsion_.output, {"text", "json", "csv"});
    sub->add_option("--plot", torsion_.plot, "draw the curve as an SVG file")->type_name("PATH");
    runs(sub, torsion_);
  }

  void add_material() {
    CLI::App* const sub = command("material");
    sub->require_subcommand(1);
    CLI::App* const list = sub->add_subcommand("list", "Print all steels, one line each");
    const auto& uses = EnumNames<MaterialUse>::names;
    list->add_option("--use", material_list_.use, "flexspline, bearing, shaft or generic; else all")
        ->check(CLI::IsMember(std::vector<std::string>(uses.begin(), uses.end())));
    add_output(list, material_list_.output, {"text", "json", "markdown"});
    runs(list, material_list_);
    CLI::App* const show = sub->add_subcommand("show", "Print all that is known of one steel");
    show->add_option("NAME", material_show_.name, "name or alias; case and blanks do not matter")
        ->required();
    add_output(show, material_show_.output, {"text", "json"});
    runs(show, material_show_);
  }

  void add_catalogue() {
    CLI::App* const sub = command("catalogue");
    sub->add_option("--size", catalogue_.size, "only this size");
    sub->add_option("--ratio", catalogue_.ratio, "only this ratio, or its class");
    add_output(sub, catalogue_.output, {"text", "json", "csv"});
    runs(sub, catalogue_);
  }

  void add_validate() {
    CLI::App* const sub = command("validate");
    sub->add_option("--mode", validate_.mode, "geometry, leave-one-size-out or per-row")
        ->check(CLI::IsMember({"geometry", "leave-one-size-out", "per-row"}))
        ->capture_default_str();
    sub->add_option("--factors", validate_.factors, "other factors to fit, at most three")
        ->type_name("A,B,C");
    sub->add_flag("--all-sets", validate_.all_sets,
                  "with leave-one-size-out: also fit every set of one to three factors");
    sub->add_option("--draws", validate_.draws, "drives drawn for the bands; 0 for none")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    add_output(sub, validate_.output, {"text", "json", "csv", "markdown"});
    sub->add_option("--plot", validate_.plot, "draw predicted over catalogue as an SVG file")
        ->type_name("PATH");
    runs(sub, validate_);
  }

  void add_calibrate() {
    CLI::App* const sub = command("calibrate");
    sub->add_option("FILE", calibrate_.file, kFile)->required();
    sub->add_flag("--catalogue", calibrate_.catalogue,
                  "with K1, K2, K3 of the nearest size and ratio");
    sub->add_option("--measured", calibrate_.measured,
                    "with a curve: CSV with the columns torque [N*m] and twist [arcmin]")
        ->type_name("PATH");
    sub->add_option("--factors", calibrate_.factors, "factors to fit, separated by commas")
        ->type_name("A,B,C")
        ->capture_default_str();
    sub->add_option("--format", calibrate_.format, "text, json")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    sub->add_option("-o,--output", calibrate_.path, "write the calibrated drive to this file")
        ->type_name("PATH");
    runs(sub, calibrate_);
  }

  void add_sif() {
    CLI::App* const sif = command("sif");
    sif->require_subcommand(1);
    CLI::App* const list = sif->add_subcommand("list", "All solutions of the library");
    list->add_option("--family", sif_list_.family, "only plate, tube, bar or gradient");
    add_output(list, sif_list_.output, {"text", "json", "markdown"});
    runs(list, sif_list_);
    const auto add_named = [&](const char* name, const char* summary, auto& named) {
      CLI::App* const sub = sif->add_subcommand(name, summary);
      sub->add_option("NAME", named.name, "of a solution")->required();
      runs(sub, named);
      return sub;
    };
    const auto add_set = [](CLI::App* sub, std::vector<std::string>& set) {
      sub->add_option("--set", set, "NAME=VALUE, a field or a load, with its unit; repeatable")
          ->type_name("NAME=VALUE")
          ->allow_extra_args(false)
          ->take_all();
    };
    CLI::App* const show = add_named("show", "What a solution says about itself", sif_show_);
    add_output(show, sif_show_.output, {"text", "json"});
    CLI::App* const eval =
        add_named("eval", "Stress intensity, geometry factors, added compliance", sif_eval_);
    add_set(eval, sif_eval_.set);
    eval->add_option("--material", sif_eval_.material,
                     "of the material library; E = 210 GPa, nu = 0.3 if left out");
    add_output(eval, sif_eval_.output, {"text", "json"});
    CLI::App* const plot =
        add_named("plot", "Geometry factors over the crack size and along its front", sif_plot_);
    add_set(plot, sif_plot_.set);
    add_path(plot, sif_plot_.path);
  }

  void add_report() {
    CLI::App* const sub = command("report");
    sub->add_option("FILE", report_.file, kFile)->required();
    add_path(sub, report_.path);
    add_method(sub, report_.method);
    sub->add_option("--date", report_.date,
                    "date to print; of SOURCE_DATE_EPOCH if left out, else none");
    runs(sub, report_);
  }

  void add_fe() {
    CLI::App* const sub = command("fe");
    sub->set_help_flag();  // every word belongs to the other program, --help too
    sub->prefix_command();
    sub->callback([this, sub] {
      fe_.arguments = sub->remaining();
      chosen_ = [this] { return cli::run(fe_); };
    });
  }

  void add_new() {
    CLI::App* const sub = command("new");
    sub->add_option("--size", new_.size, "of the catalogue; prints its typical drive");
    sub->add_option("--ratio", new_.ratio, "of the typical drive, 30 to 320");
    sub->add_option("--cup", new_.cup, "of the typical drive, short or standard")
        ->check(CLI::IsMember({"short", "standard"}))
        ->capture_default_str();
    add_path(sub, new_.path);
    runs(sub, new_);
  }

  void add_schema() {
    CLI::App* const sub = command("schema");
    add_output(sub, schema_.output, {"json", "markdown"});
    runs(sub, schema_);
  }

  void add_man() {
    CLI::App* const sub = app_.add_subcommand("man", "Print a manual page (roff)");
    sub->add_option("COMMAND", man_page_, "a command; the program itself if left out");
    sub->callback([this] {
      chosen_ = [this] {
        if (man_page_.empty()) {
          deliver(program_page(app_), {});
          return kOk;
        }
        const auto commands = app_.get_subcommands([](const CLI::App*) { return true; });
        const auto page = std::ranges::find(commands, man_page_, &CLI::App::get_name);
        if (page == commands.end() || man_page_ == "man")
          throw UsageError{fmt::format("{} has no manual page", man_page_)};
        deliver(command_page(**page), {});
        return kOk;
      };
    });
  }

  CLI::App app_{"Torsional stiffness of strain wave gears with cracks"};
  std::function<ExitCode()> chosen_;
  AuditCommand audit_;
  SweepCommand sweep_;
  SolveCommand solve_;
  SensitivityCommand sensitivity_;
  TorsionCommand torsion_;
  MaterialListCommand material_list_;
  MaterialShowCommand material_show_;
  CatalogueCommand catalogue_;
  ValidateCommand validate_;
  CalibrateCommand calibrate_;
  SifListCommand sif_list_;
  SifShowCommand sif_show_;
  SifEvalCommand sif_eval_;
  SifPlotCommand sif_plot_;
  ReportCommand report_;
  FeCommand fe_;
  NewCommand new_;
  SchemaCommand schema_;
  std::string man_page_;
};

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  return guarded("strainwave", [&] { return CommandLine().run(argc, argv); });
}

}  // namespace strainwave::cli
