// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/error.hpp"

namespace strainwave::cli {

/// Exit codes of the programs; see docs/adr/0002.
enum ExitCode : int {
  kOk = 0,
  kUsage = 2,          ///< the command line is wrong
  kInput = 3,          ///< the input breaks a rule
  kNotUsable = 4,      ///< there is no usable answer
  kNotMet = 5,         ///< a requirement is not met
  kCannotTell = 6,     ///< the uncertainty of the answer leaves a requirement undecided
  kUnwritable = 7,     ///< the output cannot be written
  kInternal = 70,      ///< internal error
  kNoMemory = 71,      ///< the memory does not suffice
  kInterrupted = 130,  ///< stopped by SIGINT, as a shell reports it
};

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
