// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/oval_stress.hpp"

#include <cmath>

namespace strainwave {

double von_mises(const std::array<double, 6>& stress) {
  const auto& [rr, tt, zz, tz, rz, rt] = stress;
  const auto square = [](double value) { return value * value; };
  return std::sqrt((square(rr - tt) + square(tt - zz) + square(zz - rr)) / 2 +
                   3 * (square(tz) + square(rz) + square(rt)));
}

const OvalStation& governing_station(std::span<const LoadedOval> torques) {
  const OvalStation* worst = &torques.front().stations.front();
  for (const LoadedOval& torque : torques)
    for (const OvalStation& station : torque.stations)
      if (station.equivalent.largest > worst->equivalent.largest) worst = &station;
  return *worst;
}

}  // namespace strainwave
