// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

namespace strainwave {

/// Values in ascending order, each once; -0 becomes 0.
[[nodiscard]] inline std::vector<double> ascending(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  for (double& value : values)
    if (value == 0) value = 0.0;
  return values;
}

}  // namespace strainwave
