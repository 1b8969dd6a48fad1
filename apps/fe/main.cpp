// SPDX-License-Identifier: Apache-2.0 strainwave-fe: finite elements of the members of a drive.  It
// is a separate program, because Debian's deal.II is subject to the GPL (docs/adr/0011).
#include "command_line.hpp"
#include "own_commands.hpp"
#include "strainwave/fe_study/commands.hpp"
#include "strainwave/fem/mpi_session.hpp"

namespace strainwave::cli {
namespace {

const Program& fe_program() {
  static const std::vector<Command> table = [] {
    const auto rows = fe_study::fe_commands();
    std::vector<Command> all(rows.begin(), rows.end());
    all.push_back(man_command(fe_program, "strainwave-fe man run | man -l -"));
    all.push_back(completion_command(fe_program, "eval \"$(strainwave-fe completion bash)\""));
    for (Command& row : all) row.program = rows.front().program;
    return all;
  }();
  static const Program program{.name = "strainwave-fe",
                               .summary = "Finite elements of the members of a strain wave gear",
                               .table = table,
                               .groups = {},
                               .unnamed = "run"};
  return program;
}

}  // namespace
}  // namespace strainwave::cli

int main(int argc, char** argv) {
  const strainwave::fem::MpiSession session(argc, argv);
  strainwave::cli::Program program = strainwave::cli::fe_program();
  program.ranks = &session;
  return strainwave::cli::run_command_line(program,
                                           std::vector<std::string>(argv + 1, argv + argc));
}
