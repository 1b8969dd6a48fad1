// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace strainwave {

/// Exit statuses of the programs; see docs/adr/0002.  kExitStatuses has their
/// meanings as the programs print them.
enum ExitStatus : int {
  kOk = 0,             ///< there is an answer, and all requirements are met
  kUsage = 2,          ///< the command line is wrong
  kInput = 3,          ///< the input breaks a rule
  kNotUsable = 4,      ///< the answer is missing, or must not be used
  kNotMet = 5,         ///< a requirement is not met
  kCannotTell = 6,     ///< the answer is too uncertain to judge a requirement
  kUnwritable = 7,     ///< the output cannot be written
  kInternal = 70,      ///< a fault of the program
  kNoMemory = 71,      ///< there is not enough memory
  kInterrupted = 130,  ///< stopped by a signal; 130 is what a shell reports for SIGINT
};

/// An exit status with its meaning in words.
struct ExitStatusMeaning {
  ExitStatus status;         ///< what the program exits with
  std::string_view meaning;  ///< as manual pages and the command `explain` show it
};

/// All exit statuses in ascending order.
inline constexpr std::array<ExitStatusMeaning, 10> kExitStatuses = {{
    {kOk, "an answer was printed, and all requirements are met"},
    {kUsage, "the command line is wrong"},
    {kInput, "the input breaks a rule; the message names file, line, field, value and rule"},
    {kNotUsable, "there is no answer, or none that may be used; the message says why"},
    {kNotMet, "a requirement is not met"},
    {kCannotTell, "a requirement cannot be told within the uncertainty of the answer"},
    {kUnwritable, "the output cannot be written"},
    {kInternal, "internal error: please report it"},
    {kNoMemory, "there is not enough memory"},
    {kInterrupted, "interrupted; nothing was written, apart from a record to go on with"},
}};

}  // namespace strainwave
