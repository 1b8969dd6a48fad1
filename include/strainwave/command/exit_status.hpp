// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace strainwave {

/// Exit statuses of the programs; see docs/adr/0002.
enum ExitStatus : int {
  kOk = 0,
  kUsage = 2,
  kInput = 3,
  kNotUsable = 4,
  kNotMet = 5,
  kCannotTell = 6,
  kUnwritable = 7,
  kInternal = 70,
  kNoMemory = 71,
  kInterrupted = 130,  // as a shell reports SIGINT
};

struct ExitStatusMeaning {
  ExitStatus status;
  std::string_view meaning;
};

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
