// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/command/exit_status.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::cli {

using ExitCode = ExitStatus;
using enum ExitStatus;

/// The command line itself cannot be understood.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// The output cannot be written.
class UnwritableError : public Error {
 public:
  using Error::Error;
};

}  // namespace strainwave::cli
