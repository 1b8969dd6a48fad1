// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave::cli {

/// Parses the command line, runs the command, and turns every outcome into an exit code with one
/// sentence on standard error.
int run_command_line(int argc, const char* const* argv);

}  // namespace strainwave::cli
