// SPDX-License-Identifier: Apache-2.0
// The stiff engine of a program that was built without SUNDIALS.
#include "strainwave/core/error.hpp"
#include "strainwave/stiff_motion/simulate_stiff.hpp"

namespace strainwave {

class StiffRun::Steps {};

void require_stiff_motion(std::string_view path) {
  throw InputError(path,
                   "stiff is not part of this program; install libsundials-dev, and build with "
                   "cmake -D STRAINWAVE_SUNDIALS=ON");
}

StiffRun::StiffRun(Joint, const JointState&, const SimulationOptions&) { require_stiff_motion(); }
StiffRun::~StiffRun() = default;
StiffRun::StiffRun(StiffRun&&) noexcept = default;
StiffRun& StiffRun::operator=(StiffRun&&) noexcept = default;
std::optional<MotionSample> StiffRun::next(const Progress&) { return std::nullopt; }
Motion StiffRun::motion() const { return {}; }

Motion simulate_stiff(const Joint& joint, const JointState& start, const SimulationOptions& options,
                      const SampleSink&, const Progress&) {
  return StiffRun(joint, start, options).motion();
}

}  // namespace strainwave
