// SPDX-License-Identifier: Apache-2.0
#include <malloc.h>

#include <string>
#include <vector>

#include "command_line.hpp"
#include "strainwave_program.hpp"

namespace {

/// Makes the allocator keep freed memory.  By default each matrix of a coupled drive goes back to
/// the system, which clears its pages again for the next one: that took three quarters of the time
/// of a comparison over a turn.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMiB = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMiB);  // the most that glibc allows
  mallopt(M_TRIM_THRESHOLD, 256 * kMiB);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  std::vector<std::string> words(argv + 1, argv + argc);
  // Every word after `fe` belongs to the other program, including --help.
  if (!words.empty() && words.front() == "fe") words.insert(words.begin() + 1, "--");
  return strainwave::cli::run_command_line(strainwave::cli::strainwave_program(), words);
}
