// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/stiffness_result.hpp"

#include <algorithm>

namespace strainwave {

std::vector<CrackOutputs> StiffnessResult::crack_outputs() const {
  std::vector<CrackOutputs> outputs;
  for (const CrackReport& report : cracks) {
    const auto found = std::ranges::find(strength, report.path, &CrackStrength::path);
    outputs.push_back({&report, found == strength.end() ? nullptr : &*found});
  }
  for (const CrackStrength& crack : strength)
    if (std::ranges::find(cracks, crack.path, &CrackReport::path) == cracks.end())
      outputs.push_back({nullptr, &crack});
  return outputs;
}

}  // namespace strainwave
