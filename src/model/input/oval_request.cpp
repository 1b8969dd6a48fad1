// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/oval_request.hpp"

#include <cmath>

#include "strainwave/core/ascending.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {

std::vector<double> plan_oval(const GearSet& gear, const OvalRequest& request) {
  check(gear);
  require_turning_cup(gear);
  for (const double torque : request.torques)
    require(std::isfinite(torque), "torque", torque, "N*m", "a finite number");
  return request.torques.empty() ? std::vector{gear.load.torque} : ascending(request.torques);
}

}  // namespace strainwave
