// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"
#include "strainwave/sif/plate/surface_crack.hpp"
#include "strainwave/sif/plate/through_crack.hpp"

namespace strainwave::sif {

std::vector<Row> plate_rows() {
  return {
      row<PlateThroughCrack>(),
      row<PlateSurfaceCrack>(),
  };
}

}  // namespace strainwave::sif
