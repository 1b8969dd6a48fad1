// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exit_code.hpp"
#include "strainwave/fem/solid.hpp"

namespace strainwave {

/// `strainwave-fe tabulate ...`; the words behind "tabulate" are read.
[[nodiscard]] cli::ExitCode run_tabulate(int argc, char** argv, const fem::MpiSession& session);

/// Whether progress is told: it is asked for, or someone sits there.
[[nodiscard]] bool tells_progress(bool asked, const fem::MpiSession& session);

}  // namespace strainwave
