// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "strainwave/core/progress.hpp"
#include "strainwave/motion/joint.hpp"
#include "strainwave/motion/simulate.hpp"

/// @file
/// A second road for motions, which also takes stiff joints: CVODE of SUNDIALS, an optional part of
/// the build (docs/adr/0018).

namespace strainwave {

/// Throws InputError, which says how to get it, unless the program was built with SUNDIALS.
/// @param path  of the fault in the message
void require_stiff_motion(std::string_view path = "engine");

/// A motion that is computed sample by sample, by the method of `simulate_stiff`.
class StiffRun {
 public:
  /// @throws InputError  as `simulate_stiff`
  StiffRun(Joint joint, const JointState& start, const SimulationOptions& options);
  ~StiffRun();
  /// A run that was moved from has no steps; it may only be destroyed or assigned to.
  /// @{
  StiffRun(StiffRun&&) noexcept;
  StiffRun& operator=(StiffRun&&) noexcept;
  /// @}
  StiffRun(const StiffRun&) = delete;
  StiffRun& operator=(const StiffRun&) = delete;

  /// The next sample; the first is the start.  Absent at the end of the motion.
  /// @throws Stopped  if the caller requests a stop; the run may then be called again
  [[nodiscard]] std::optional<MotionSample> next(const Progress& progress = {});
  /// What the motion did until now.
  [[nodiscard]] Motion motion() const;

 private:
  class Steps;
  std::unique_ptr<Steps> steps_;
};

/// Motion of a joint over time as `simulate` returns it, by backward differences (MO-13).
///
/// Steps of variable order, up to the fifth, solve implicit equations by Newton's method, so their
/// length follows the motion and not the fastest decay.  Events are found in the dense output, and
/// the method starts anew behind each.  A change of sign within ten times the tolerance is none:
/// what stands still passes zero without end.  Both roads share the equations of the joint and no
/// step.
/// @throws InputError  as `simulate`; if the joint has slip elements; or if the program was built
///                     without SUNDIALS
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] Motion simulate_stiff(const Joint& joint, const JointState& start,
                                    const SimulationOptions& options, const SampleSink& sink = {},
                                    const Progress& progress = {});

}  // namespace strainwave
