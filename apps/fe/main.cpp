// SPDX-License-Identifier: Apache-2.0
// strainwave-fe: finite elements of the members of a drive.  A program of its own, because Debian's
// deal.II brings the GPL with it (docs/adr/0011).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "command_line.hpp"
#include "exit_code.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/fe_study/member_run.hpp"
#include "strainwave/fe_study/memory.hpp"
#include "strainwave/fe_study/output_files.hpp"
#include "strainwave/fe_study/run_report.hpp"
#include "strainwave/fem/mpi_session.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/write_file.hpp"
#include "tabulate.hpp"

namespace strainwave {
namespace {

using cli::ExitCode;
using fe_study::Member;

struct Arguments {
  std::string file;
  std::string member;
  std::optional<int> order;
  std::string format = "text";
  std::string output;
  std::optional<std::string> crack;
  bool dry_run = false;
  bool progress = false;
};

GearSet read_input(const std::string& file) {
  if (file != "-") return read_gear_set_file(file);
  constexpr std::string_view kName = "standard input";
  return read_gear_set(read_text(std::cin, kName), kName, attachments_beside(file));
}

void deliver(const std::string& text, const std::string& path) {
  if (!path.empty()) {
    write_file(path, text);
    return;
  }
  std::cout << text << std::flush;
  if (!std::cout) throw std::runtime_error("standard output cannot be written");
}

/// Checks what was asked for, and reads the file.
GearSet input_of(const Arguments& arguments, const fem::MpiSession& session) {
  if (arguments.file == "-" && session.size() > 1)
    throw InputError("FILE", "standard input reaches the first rank only: name a file");
  GearSet gear;
  session.together([&] { gear = read_input(arguments.file); });
  return gear;
}

fe_study::RunOptions options_of(const Arguments& arguments, const fem::MpiSession& session) {
  fe_study::RunOptions options{.member = {}, .order = arguments.order, .crack = arguments.crack};
  if (tells_progress(arguments.progress, session))
    options.progress = [](const std::string& line) {
      std::cerr << "strainwave-fe: " << line << std::endl;
    };
  for (const Member member : {Member::output_shaft, Member::flexspline})
    if (arguments.member == member_name(member)) options.member = member;
  return options;
}

std::string json_of(const fe_study::RunResult& result, const GearSet& gear,
                    const Arguments& arguments) {
  const Provenance provenance{
      .version = std::string(version()),
      .revision = std::string(git_revision()),
      .input_file = arguments.file == "-" ? "standard input" : arguments.file};
  return run_json(result, gear, provenance);
}

ExitCode verdict(const fe_study::RunResult& result) {
  if (result.usable()) return cli::kOk;
  std::cerr << "strainwave-fe: not usable: " << result.reason() << '\n';
  return cli::kNotUsable;
}

enum class Folder { vtu, pictures };

/// Answers that are a folder of files.
ExitCode run_into_folder(const Arguments& arguments, Folder kind, const fem::MpiSession& session) {
  const GearSet gear = input_of(arguments, session);
  // Before the calculation, which may take long; write_files sees the rest.
  session.together([&] {
    std::error_code unseen;
    if (std::filesystem::exists(arguments.output, unseen) &&
        !std::filesystem::is_directory(arguments.output, unseen))
      throw Error(arguments.output + ": is a file, and the results need a folder");
  });
  fe_study::RunOptions options = options_of(arguments, session);
  options.fields =
      kind == Folder::vtu ? fe_study::RunFields::of_rank : fe_study::RunFields::everywhere;
  const bool first = session.rank() == 0;
  // The first rank alone can fail here; the others must not wait for it to write.
  fe_study::RunResult result;
  std::vector<fe_study::OutputFile> files;
  session.together([&] {
    result = fe_study::run(gear, options, session);
    if (kind == Folder::vtu)
      files = vtu_files(result, gear, session);
    else if (first)
      files = pictures(result, gear);
    if (first && kind == Folder::vtu)
      files.push_back({"result.json", json_of(result, gear, arguments)});
  });
  write_files(arguments.output, files, session);
  return first ? verdict(result) : cli::kOk;
}

ExitCode run(const Arguments& arguments, const fem::MpiSession& session) {
  if (arguments.format == "vtu" && !arguments.dry_run)
    return run_into_folder(arguments, Folder::vtu, session);
  const fe_study::RunOptions options = options_of(arguments, session);
  const bool first = session.rank() == 0;
  const GearSet gear = input_of(arguments, session);
  const bool json = arguments.format == "json";
  if (arguments.dry_run) {
    const auto sizes = fe_study::plan(gear, options);
    session.together([&] {
      if (first) deliver(json ? plan_json(sizes) : plan_text(sizes), arguments.output);
    });
    fe_study::require_memory(sizes, session);
    return cli::kOk;
  }
  const fe_study::RunResult result = fe_study::run(gear, options, session);
  if (!first) return cli::kOk;
  deliver(json ? json_of(result, gear, arguments) : run_text(result, gear), arguments.output);
  return verdict(result);
}

/// What both commands have in common.
void add_input(CLI::App& app, Arguments& arguments) {
  app.add_option("FILE", arguments.file, "input file, or - for standard input")->required();
  app.add_option("--member", arguments.member,
                 "output-shaft or flexspline; every one that the file gives if left out")
      ->check(CLI::IsMember({"output-shaft", "flexspline"}));
  app.add_option("--order", arguments.order,
                 "order p of the elements: 6 if left out, 3 (at most 4) of cracks of the wall")
      ->check(CLI::Range(2, 8));
  app.add_option("--crack", arguments.crack, "only this crack: flexspline.crack[0], ...")
      ->type_name("PATH");
  app.add_flag("--progress", arguments.progress,
               "a line for each solution on standard error, even if that is no terminal");
}

ExitCode run_render(int argc, char** argv, const fem::MpiSession& session) {
  Arguments arguments;
  CLI::App app{
      "Pictures of the members of a strain wave gear by finite elements, as SVG: strain energy "
      "density, what the cracks change in it, the crack opened, and stress intensity"};
  app.name("strainwave-fe render");
  add_input(app, arguments);
  app.add_option("-o,--output", arguments.output, "folder for the pictures, made if need be")
      ->type_name("FOLDER")
      ->required();
  app.footer("Example:\n  strainwave-fe render examples/through_crack.toml -o pictures");
  if (const auto code = parsed(app, argc, argv, session)) return *code;
  return run_into_folder(arguments, Folder::pictures, session);
}

ExitCode run(int argc, char** argv, const fem::MpiSession& session) {
  if (argc > 1 && std::string_view(argv[1]) == "render")
    return run_render(argc - 1, argv + 1, session);
  if (argc > 1 && std::string_view(argv[1]) == "tabulate")
    return run_tabulate(argc - 1, argv + 1, session);
  Arguments arguments;
  CLI::App app{
      "Finite elements of the members of a strain wave gear: shafts and cups as "
      "bodies of revolution, cracks of the wall as solids"};
  app.name("strainwave-fe");
  app.set_version_flag("--version", fmt::format("strainwave-fe {} ({})", version(), git_revision()),
                       "print version and revision, and exit");
  add_input(app, arguments);
  app.add_option("--format", arguments.format, "text, json, or vtu: files for ParaView")
      ->check(CLI::IsMember({"text", "json", "vtu"}))
      ->capture_default_str();
  app.add_option("-o,--output", arguments.output,
                 "write to this file instead of standard output; of --format vtu a folder")
      ->type_name("PATH");
  app.add_flag("--dry-run", arguments.dry_run, "say size, memory and time, and calculate nothing");
  app.footer(
      "Examples:\n  strainwave-fe examples/solid_shaft.toml --member output-shaft\n"
      "  mpirun -n 2 strainwave-fe examples/through_crack.toml --member flexspline\n"
      "  strainwave-fe examples/through_crack.toml --format vtu -o fields\n"
      "Pictures: strainwave-fe render --help; a table of many runs: strainwave-fe tabulate --help");
  if (const auto code = parsed(app, argc, argv, session)) return *code;
  if (arguments.format == "vtu" && arguments.output.empty() && !arguments.dry_run) {
    if (session.rank() == 0)
      std::cerr << "strainwave-fe: --format vtu writes several files: name a folder with -o\n";
    return cli::kUsage;
  }
  return run(arguments, session);
}

}  // namespace
}  // namespace strainwave

int main(int argc, char** argv) {
  using namespace strainwave;  // NOLINT(google-build-using-namespace)
  const fem::MpiSession session(argc, argv);
  // All ranks end with one word, of the first that has something to complain about.
  const auto complain = [&session](std::string_view message, cli::ExitCode code) {
    return session.last_code(code, [&] {
      const std::string rank = session.rank() == 0 ? "" : fmt::format("rank {}: ", session.rank());
      std::cerr << fmt::format("strainwave-fe: {}{}\n", rank, message) << std::flush;
    });
  };
  try {
    return session.last_code(run(argc, argv, session), nullptr);
  } catch (const fem::OtherRankError&) {
    return session.last_code(cli::kInternal, nullptr);
  } catch (const InputError& error) {
    return complain(error.what(), cli::kInput);
  } catch (const SolverError& error) {
    return complain(error.what(), cli::kNotUsable);
  } catch (const std::exception& error) {
    return complain(error.what(), cli::kInternal);
  }
}
