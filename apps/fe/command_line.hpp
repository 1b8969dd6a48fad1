// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "exit_code.hpp"
#include "strainwave/fem/mpi_session.hpp"

namespace strainwave {

/// Parses on every rank, and the first one speaks; an exit code if there is nothing left to do.
[[nodiscard]] std::optional<cli::ExitCode> parsed(CLI::App& app, int argc, char** argv,
                                                  const fem::MpiSession& session);

/// Whether progress is told: it is asked for, or someone sits there.
[[nodiscard]] bool tells_progress(bool asked, const fem::MpiSession& session);

}  // namespace strainwave
