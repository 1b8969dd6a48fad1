// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <unistd.h>

#include <iostream>
#include <ostream>

namespace strainwave {

std::optional<cli::ExitCode> parsed(CLI::App& app, int argc, char** argv,
                                    const fem::MpiSession& session) {
  try {
    app.parse(argc, argv);
    return {};
  } catch (const CLI::ParseError& error) {
    std::ostream nowhere(nullptr);
    const bool first = session.rank() == 0;
    return app.exit(error, first ? std::cout : nowhere, first ? std::cerr : nowhere) == 0
               ? cli::kOk
               : cli::kUsage;
  }
}

bool tells_progress(bool asked, const fem::MpiSession& session) {
  return session.rank() == 0 && (asked || ::isatty(STDERR_FILENO) == 1);
}

}  // namespace strainwave
