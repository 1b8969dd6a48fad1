// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/rainflow.hpp"

#include <fmt/format.h>

namespace strainwave {

void RainflowCounter::refuse(double value) const {
  throw InputError("history",
                   fmt::format("value {} is {}; give finite numbers only", places_ + 1, value));
}

}  // namespace strainwave
