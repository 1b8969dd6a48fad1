// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "strainwave/fem/solid.hpp"

namespace strainwave::fe_study {

/// Mean, least and largest value along a front.
struct AlongFront {
  double mean = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
};

template <class Value>
AlongFront along(const fem::CrackFront& front, const Value& value) {
  AlongFront result;
  const auto& stations = front.stations;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double v = value(stations[i]);
    result.least = std::min(result.least, v);
    result.largest = std::max(result.largest, v);
  }
  // K is a parabola along each segment of the front (FE-23), which has a place in its middle.
  for (std::size_t i = 0; i + 2 < stations.size(); i += 2) {
    const double step = stations[i + 2].position - stations[i].position;
    result.mean +=
        step * (value(stations[i]) + 4 * value(stations[i + 1]) + value(stations[i + 2])) / 6;
  }
  if (stations.size() > 1) result.mean /= stations.back().position - stations.front().position;
  return result;
}

}  // namespace strainwave::fe_study
