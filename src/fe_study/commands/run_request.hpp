// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/command/command.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fe_study/memory.hpp"

namespace strainwave::fe_study {

/// Options of every command: the order of the elements and the crack.
struct CrackOptions {
  std::optional<std::string> crack;
  std::optional<int> order;
  bool progress = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"crack", "", "compute only this crack: flexspline.crack[0], ..."}, &CrackOptions::crack);
    field({.name = "order",
           .unit = "",
           .doc = "order p of the elements; if left out 6, for wall cracks 3 (at most 4)",
           .range = {.lower = 2, .lower_open = false, .upper = 8, .upper_open = false}},
          &CrackOptions::order);
    field({.name = "progress",
           .unit = "",
           .doc = "print a line for each solution, as on a terminal",
           .names = "watched"},
          &CrackOptions::progress);
  }
};

/// Options of commands that run members.
struct MemberOptions : CrackOptions {
  std::optional<Member> member;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"member", "", "member to compute; every member of the file if left out"},
          &MemberOptions::member);
    CrackOptions::describe(field);
  }
};

/// The request for a run.
inline RunOptions run_options(const Request& request, const CrackOptions& options) {
  RunOptions run{.order = options.order, .crack = options.crack};
  if (options.progress)
    run.progress = [&progress = request.progress](const std::string& line) { progress.say(line); };
  return run;
}

/// Reason why the memory of a rank does not suffice; empty if all have enough.
inline std::string memory_refusal(const std::vector<RunSize>& sizes, const Ranks& ranks) {
  try {
    require_memory(sizes, ranks);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace strainwave::fe_study
