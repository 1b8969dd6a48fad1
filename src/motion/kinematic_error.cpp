// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/kinematic_error.hpp"

#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"

namespace strainwave {

KinematicError::At KinematicError::at(double input_angle) const {
  At result;
  for (const auto& [order, amplitude, phase] : orders) {
    const double argument = order * input_angle + phase;
    result.value += amplitude * std::sin(argument);          // (MO-4)
    result.slope += amplitude * order * std::cos(argument);  // (MO-4)
  }
  return result;
}

void require_constants(const KinematicError& error) {
  const FieldPath at("kinematic_error");
  for (std::size_t i = 0; i < error.orders.size(); ++i) {
    const auto& [order, amplitude, phase] = error.orders[i];
    require(order > 0 && order <= kLargestOrder, (at[i] / "order").text(), order, "1",
            "> 0 and <= 1000");
    require(amplitude >= 0 && amplitude < kLargestError, (at[i] / "amplitude").text(), amplitude,
            "rad", "from 0 to below 0.5 deg");
    require(std::isfinite(phase), (at[i] / "phase").text(), phase, "rad", "a finite number");
  }
}

}  // namespace strainwave
