// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/result/oval_stress.hpp"

namespace strainwave {

const OvalStation& governing_station(std::span<const LoadedOval> torques) {
  const OvalStation* worst = &torques.front().stations.front();
  for (const LoadedOval& torque : torques)
    for (const OvalStation& station : torque.stations)
      if (station.equivalent.largest > worst->equivalent.largest) worst = &station;
  return *worst;
}

}  // namespace strainwave
