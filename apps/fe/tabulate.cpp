// SPDX-License-Identifier: Apache-2.0
#include "tabulate.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fe_study/memory.hpp"
#include "strainwave/fe_study/tabulate.hpp"
#include "strainwave/io/gear_reader.hpp"

namespace strainwave {
namespace {

struct Arguments {
  std::string file;
  std::vector<std::string> over;
  std::string output;
  std::optional<std::string> crack;
  std::optional<int> order;
  bool dry_run = false;
  bool progress = false;
};

cli::ExitCode run(const Arguments& arguments, const fem::MpiSession& session) {
  GearSet gear;
  session.together([&] { gear = read_gear_set_file(arguments.file); });
  const bool first = session.rank() == 0;
  const auto say = [&](const std::string& line) {
    if (first) std::cerr << "strainwave-fe: " << line << std::endl;
  };
  std::vector<Variation> over;
  try {
    for (const std::string& text : arguments.over)
      over.push_back(parse_variation(gear, text, "--over"));
  } catch (const InputError& error) {  // a fault of the command line, not of the input
    say(error.what());
    return cli::kUsage;
  }
  fe_study::RunOptions options{.member = {}, .order = arguments.order, .crack = arguments.crack};
  const bool tells = tells_progress(arguments.progress, session);
  if (tells) options.progress = say;
  const std::string input = std::filesystem::path(arguments.file).filename().string();
  const fe_study::TableStudy study = fe_study::table_study(gear, input, options, over);
  if (arguments.dry_run) {
    const fe_study::TableSize size = fe_study::table_size(study);
    if (first) std::cout << fe_study::table_size_text(size) << std::flush;
    fe_study::require_memory({size.largest}, session);
    return cli::kOk;
  }
  const fe_study::TableOutcome outcome = fe_study::run_table(study, arguments.output, session, say);
  if (!first) return cli::kOk;
  std::cout << fmt::format("{}: {} points, {} of them not usable\n", arguments.output,
                           study.points.size(), outcome.unusable);
  if (outcome.unusable == 0) return cli::kOk;
  say("not usable: " + outcome.first_reason);
  return cli::kNotUsable;
}

}  // namespace

cli::ExitCode run_tabulate(int argc, char** argv, const fem::MpiSession& session) {
  Arguments arguments;
  CLI::App app{
      "A family of finite element runs of one crack, as a table that a crack's compliance_table "
      "names. Finished points are kept: a run that was stopped goes on where it was."};
  app.name("strainwave-fe tabulate");
  app.add_option("FILE", arguments.file, "input file")->required();
  app.add_option("--over", arguments.over,
                 "PATH=FROM..TO:N[:log], a field and its range with units; once or more")
      ->required()
      ->type_name("RANGE")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("-o,--output", arguments.output, "the table, CSV; added to if it is there")
      ->required()
      ->type_name("PATH");
  app.add_option("--crack", arguments.crack,
                 "flexspline.crack[0], ...; may be left out where the file has one")
      ->type_name("PATH");
  app.add_option("--order", arguments.order,
                 "order p of the elements: 6 if left out, 3 (at most 4) of through cracks")
      ->check(CLI::Range(2, 8));
  app.add_flag("--dry-run", arguments.dry_run,
               "say size, memory and time of all points, and calculate nothing");
  app.add_flag("--progress", arguments.progress,
               "a line for each solution on standard error, even if that is no terminal");
  app.footer(
      "Example:\n  strainwave-fe tabulate examples/through_crack.toml -o through_45.csv \\\n"
      "    --over 'flexspline.crack[0].half_length=0.5 mm..40 mm:13:log'");
  if (const auto code = parsed(app, argc, argv, session)) return *code;
  return run(arguments, session);
}

}  // namespace strainwave
