// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_growth/crack_factors.hpp"

#include <array>
#include <cmath>

namespace strainwave {

CrackFactors::CrackFactors(const DriveCrack& crack, const CracksAtTorques& at_torque,
                           const CrackSize& size, bool bent, FrontPoints points)
    : at_torque_(at_torque), reverses_(crack.reverses) {
  if (crack.turn_table) {
    turn_.emplace(*crack.turn_table, size.size, size.aspect_ratio);
    return;
  }
  const auto add = [&](const DriveCrack& of) {
    Front& front = fronts_.emplace_back();
    const bool ends = points == FrontPoints::ends && of.front_ends;
    front.load = (ends ? of.front_ends : of.front)(size, Faces::open);
    if (bent && of.bending) front.bending = (ends ? of.bending_ends : of.bending)(size);
  };
  if (at_torque.empty()) add(crack);
  for (const auto& [torque, of] : at_torque) add(of);
}

Modes CrackFactors::at(std::size_t point, const LoadState& state, double factor) const {
  const double torque = reverses_ ? state.torque : std::abs(state.torque);
  const auto of = [&](const Front& front) {
    const FrontIntensity& at = front.load[point];
    const std::array<const std::array<double, 2>*, 3> load = {&at.load.I, &at.load.II,
                                                              &at.load.III};
    Modes K{};
    for (std::size_t mode = 0; mode < K.size(); ++mode) {
      K[mode] = (*load[mode])[kAxial] * state.axial_force * factor +
                (*load[mode])[kTorsion] * torque * factor + at.assembly[mode] * state.assembly +
                at.constant[mode];
      if (!front.bending.empty())
        K[mode] += front.bending[point][mode] * state.bending_moment * factor;
    }
    return K;
  };
  std::size_t above = 0;  // the first torque that is not smaller, or the last one
  while (above + 1 < at_torque_.size() && at_torque_[above].first < torque) ++above;
  const Modes K = of(fronts_[above]);
  if (above == 0 || at_torque_[above].first <= torque) return K;
  // Linear between two torques (GR-29).
  const double from = at_torque_[above - 1].first;
  const double share = (torque - from) / (at_torque_[above].first - from);
  const Modes below = of(fronts_[above - 1]);
  Modes between{};
  for (std::size_t mode = 0; mode < K.size(); ++mode)
    between[mode] = (1 - share) * below[mode] + share * K[mode];
  return between;
}

}  // namespace strainwave
