// SPDX-License-Identifier: Apache-2.0
#include "sound_wall.hpp"

#include <cmath>
#include <utility>

namespace strainwave {

SoundWall::SoundWall(const OvalShell& shell, WallPart part, double place, double angle,
                     std::vector<double> offsets)
    : shell_(shell),
      radius_(shell.at(part, place).radius),
      sine_(std::sin(angle)),
      cosine_(std::cos(angle)),
      offsets_(std::move(offsets)) {
  for (const double offset : offsets_) places_.push_back(shell.at(part, place + offset * cosine_));
}

PlaneStress SoundWall::at(std::size_t offset, double zeta, double from_lobe, double torque) const {
  const double here = from_lobe - offsets_[offset] * sine_ / radius_;
  const WallStress s = shell_.stress(places_[offset], zeta, here, torque);
  // (IN-2)
  return {.normal =
              s.hoop * cosine_ * cosine_ + s.axial * sine_ * sine_ + 2 * s.shear * sine_ * cosine_,
          .along =
              (s.hoop - s.axial) * sine_ * cosine_ - s.shear * (cosine_ * cosine_ - sine_ * sine_)};
}

}  // namespace strainwave
