// SPDX-License-Identifier: Apache-2.0
#include "strainwave_program.hpp"

#include <algorithm>
#include <array>

#include "own_commands.hpp"
#include "strainwave/command/shards.hpp"
#include "strainwave/door/door.hpp"
#include "strainwave/row_files/row_file.hpp"

namespace strainwave::cli {

const Program& strainwave_program() {
  static constexpr std::array<Group, 2> kGroups = {
      {{"sif", "Stress intensity library: list, show, eval, plot"},
       {"material", "The material library: steels with sources"}}};
  static const std::vector<Command> table = [] {
    std::vector<Command> rows(commands().begin(), commands().end());
    rows.push_back(merge_command(commands));
    rows.push_back(fe_command());
    rows.push_back(man_command(strainwave_program, "strainwave man stiffness | man -l -"));
    rows.push_back(
        completion_command(strainwave_program, "eval \"$(strainwave completion bash)\""));
    *std::ranges::find(rows, "explain", &Command::name) = explain_command(
        [] { return strainwave_program().table; }, [] { return own_words(strainwave_program()); });
    return rows;
  }();
  static const Program program{.name = "strainwave",
                               .summary = "Torsional stiffness of strain wave gears with cracks",
                               .table = table,
                               .groups = kGroups,
                               .names = names_of,
                               .rows = row_file};
  return program;
}

}  // namespace strainwave::cli
