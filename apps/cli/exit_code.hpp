// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave::cli {

/// What the program tells its caller; docs/adr/0002.
enum ExitCode : int {
  kOk = 0,
  kUsage = 2,      ///< the command line is wrong
  kInput = 3,      ///< the input breaks a rule
  kNotUsable = 4,  ///< there is no answer, or none that may be used
  kInternal = 70,  ///< our own mistake, or the output cannot be written
};

}  // namespace strainwave::cli
