// SPDX-License-Identifier: Apache-2.0
// Uses one stress intensity solution directly by its type: geometry factors of a cracked strip.

#include <cmath>
#include <iostream>
#include <numbers>

#include "strainwave/sif/plate/strip_edge.hpp"

int main() {
  // snippet: factors
  const strainwave::sif::StripEdgeCrack crack{.depth = 2e-3, .width = 10e-3, .thickness = 20e-3};
  std::cout << crack.kInfo.title << ", K to " << 100 * crack.kInfo.relative_uncertainty << " %\n";
  for (const double depth : {1e-3, 2e-3, 5e-3}) {  // a [m]
    const auto K = crack.stress_intensity(depth, 0.0);
    const double root = std::sqrt(std::numbers::pi * depth);
    std::cout << "a/w = " << depth / crack.width << ": Y of tension " << K.I[0] / root
              << ", of bending " << K.I[1] / root << '\n';
  }
  // end
}
