// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace strainwave {

/// One accepted step of a path.
struct PathStep {
  int pass = 0;  ///< 0: the path; 1: the one with half steps
  int leg = 0;   ///< number of cracks that have gone through their wall
  /// After the step: ln of the size of each tip, then the repetitions of the duty.
  std::vector<double> state;
  double next_length = 0.0;       ///< of the step that follows, along the path [-]
  int tried = 0;                  ///< steps so far, with those that were refused
  double since_assessment = 0.0;  ///< path since the last failure assessment [-]
  double since_jump = 0.0;        ///< path since the last jump of a rate [-]
  double jump = 0.0;              ///< path by which that jump was passed [-]
};

/// The accepted steps of a computation, so that a stopped one goes on to the same last digit.
class GrowthCheckpoint {
 public:
  GrowthCheckpoint() = default;
  /// @param lines   those of a run before
  /// @param append  stores a further line permanently
  /// @throws InputError  if a line cannot be read; a last line without its end is left out
  GrowthCheckpoint(std::string_view lines, std::function<void(const std::string&)> append);

  /// The next step that the stopped run stored for this leg of a pass; absent if all its steps are
  /// taken.
  [[nodiscard]] std::optional<PathStep> next(int pass, int leg);
  /// Stores a step that was computed now.
  void add(const PathStep& step) const;

 private:
  std::deque<PathStep> stored_;
  std::function<void(const std::string&)> append_;
};

}  // namespace strainwave
