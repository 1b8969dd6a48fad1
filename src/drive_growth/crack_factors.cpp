// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/crack_factors.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace strainwave {

CrackFactors::CrackFactors(const DriveCrack& crack, const CracksAtTorques& at_torque,
                           const CrackSize& size, bool bent)
    : at_torque_(at_torque), reverses_(crack.reverses) {
  if (crack.turn_table) {
    turn_.emplace(*crack.turn_table, size.size, size.aspect_ratio);
    return;
  }
  const auto add = [&](const DriveCrack& of) {
    Front& front = fronts_.emplace_back();
    front.load = of.front(size, Faces::open);
    if (bent && of.bending) front.bending = of.bending(size);
  };
  if (at_torque.empty()) add(crack);
  for (const auto& [torque, of] : at_torque) add(of);
}

Modes CrackFactors::at(std::size_t point, const LoadState& state, double factor) const {
  const double torque = reverses_ ? state.torque : std::abs(state.torque);
  std::size_t which = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < at_torque_.size(); ++i) {
    const double distance = std::abs(at_torque_[i].first - torque);
    if (distance >= nearest) continue;
    nearest = distance;
    which = i;
  }
  const Front& front = fronts_[which];
  const FrontIntensity& at = front.load[point];
  const std::array<const std::array<double, 2>*, 3> load = {&at.load.I, &at.load.II, &at.load.III};
  Modes K{};
  for (std::size_t mode = 0; mode < K.size(); ++mode) {
    K[mode] = (*load[mode])[kAxial] * state.axial_force * factor +
              (*load[mode])[kTorsion] * torque * factor + at.assembly[mode] * state.assembly +
              at.constant[mode];
    if (!front.bending.empty())
      K[mode] += front.bending[point][mode] * state.bending_moment * factor;
  }
  return K;
}

}  // namespace strainwave
