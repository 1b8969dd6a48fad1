// SPDX-License-Identifier: Apache-2.0
#include "strainwave/door/door.hpp"

namespace strainwave {

// One function for each row, in a file of its name in commands/.
Command stiffness_command();

std::span<const Command> commands() {
  static const std::vector<Command> table = {
      stiffness_command(),
  };
  return table;
}

}  // namespace strainwave
