// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exit_code.hpp"
#include "strainwave/fem/mpi_session.hpp"

namespace strainwave {

/// `strainwave-fe tabulate ...`; the words behind "tabulate" are read.
[[nodiscard]] cli::ExitCode run_tabulate(int argc, char** argv, const fem::MpiSession& session);

}  // namespace strainwave
