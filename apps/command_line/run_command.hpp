// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exit_code.hpp"
#include "given.hpp"

namespace strainwave::cli {

/// Reads the files that a command line names, runs its command, and writes the documents.  With
/// several files
/// it answers for each of them, in one document.
/// @return  how the program ends
/// @throws UsageError, UnwritableError, InputError, SolverError, Stopped
[[nodiscard]] ExitCode run_command(Given given);

}  // namespace strainwave::cli
