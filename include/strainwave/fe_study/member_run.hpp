// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/gear_fem/cup_section.hpp"
#include "strainwave/gear_fem/shaft_section.hpp"
#include "strainwave/model/gear_set.hpp"

/// @file
/// Finite elements of the members of a drive, from its input file: what strainwave-fe does.

namespace strainwave::fe_study {

/// The members that finite elements know.
enum class Member { output_shaft, flexspline };
/// "output-shaft", "flexspline"
[[nodiscard]] std::string_view member_name(Member member);

struct RunOptions {
  std::optional<Member> member = {};  ///< nothing: every member that the file gives
  int order = 6;                      ///< p; in 2..8
};

/// Size of one calculation, before it is done.
struct RunSize {
  std::string path;           ///< "output_shaft.crack[0]" or "flexspline"
  std::size_t dofs = 0;       ///< of its largest solution, within 10 %
  double memory = 0.0;        ///< estimate [byte]
  double seconds = 0.0;       ///< estimate for one core [s]
  std::size_t solutions = 0;  ///< how many are solved
};

/// One crack of the output shaft.
struct ShaftCrackRun {
  std::string path;
  gear_fem::ShaftSection section;
  gear_fem::ShaftCrackResult result;
};

/// Everything that was run.
struct RunResult {
  int order = 0;
  std::vector<ShaftCrackRun> shaft_cracks;
  std::optional<gear_fem::CupResult> cup;
  std::vector<std::string> notes;  ///< what finite elements leave out, or see otherwise
  /// True if every part may be used.
  [[nodiscard]] bool usable() const;
  /// The first reason why not; empty if it may.
  [[nodiscard]] std::string reason() const;
};

/// Plans a run.
/// @throws InputError  for what finite elements cannot do, by name: a member that the file does not
///                     give, cracks of the flexspline, a flexspline without sections, an order out
///                     of range, a shaft without cracks
[[nodiscard]] std::vector<RunSize> plan(const GearSet& gear, const RunOptions& options);

/// Runs.  Torque and force are 1 N*m and 1 N; the given load is applied in the report.
/// @throws InputError, SolverError  as plan and fem::solve_section
[[nodiscard]] RunResult run(const GearSet& gear, const RunOptions& options);

}  // namespace strainwave::fe_study
