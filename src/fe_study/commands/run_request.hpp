// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/command/command.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fe_study/memory.hpp"

namespace strainwave::fe_study {

/// Options of every command: which elements of which crack.
struct CrackOptions {
  std::optional<std::string> crack;
  std::optional<int> order;
  bool progress = false;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"crack", "", "only this crack: flexspline.crack[0], ..."}, &CrackOptions::crack);
    field({.name = "order",
           .unit = "",
           .doc = "order p of the elements; 6 if left out, 3 (at most 4) of cracks of the wall",
           .range = {.lower = 2, .lower_open = false, .upper = 8, .upper_open = false}},
          &CrackOptions::order);
    field({.name = "progress",
           .unit = "",
           .doc = "a line for each solution, as on a terminal",
           .names = "watched"},
          &CrackOptions::progress);
  }
};

/// Options of commands that run members.
struct MemberOptions : CrackOptions {
  std::optional<Member> member;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"member", "", "every one that the file gives if left out"}, &MemberOptions::member);
    CrackOptions::describe(field);
  }
};

/// What a run is asked for.
inline RunOptions run_options(const Request& request, const CrackOptions& options) {
  RunOptions run{.order = options.order, .crack = options.crack};
  if (options.progress)
    run.progress = [&progress = request.progress](const std::string& line) { progress.say(line); };
  return run;
}

/// Why there is too little memory, on any rank; empty if there is enough.
inline std::string memory_refusal(const std::vector<RunSize>& sizes, const Ranks& ranks) {
  try {
    require_memory(sizes, ranks);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace strainwave::fe_study
