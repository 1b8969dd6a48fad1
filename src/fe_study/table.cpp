// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/commands.hpp"

namespace strainwave::fe_study {

// Each row has a function in the file of the same name in commands/.
Command run_command();
Command render_command();
Command influence_command();
Command oval_command();
Command tabulate_command();
Command turn_command();

std::span<const Command> fe_commands() {
  static const std::vector<Command> table = [] {
    std::vector<Command> rows = {run_command(),
                                 oval_command(),
                                 turn_command(),
                                 tabulate_command(),
                                 influence_command(),
                                 render_command(),
                                 schema_command(fe_commands)};
    for (Command& row : rows) row.program = "strainwave-fe";
    return rows;
  }();
  return table;
}

}  // namespace strainwave::fe_study
