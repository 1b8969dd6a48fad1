// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"
#include "strainwave/sif/tube/edge_axial.hpp"
#include "strainwave/sif/tube/ovalised.hpp"
#include "strainwave/sif/tube/surface_axial.hpp"
#include "strainwave/sif/tube/surface_circumferential.hpp"
#include "strainwave/sif/tube/surface_inclined.hpp"
#include "strainwave/sif/tube/through_axial.hpp"
#include "strainwave/sif/tube/through_circumferential.hpp"
#include "strainwave/sif/tube/through_inclined.hpp"

namespace strainwave::sif {

std::vector<Row> tube_rows() {
  return {
      row<TubeThroughAxial>(),
      row<TubeThroughCircumferential>(),
      row<TubeThroughInclined>(),
      row<TubeSurfaceAxialInner>(),
      row<TubeSurfaceAxialOuter>(),
      row<TubeSurfaceCircumferentialInner>(),
      row<TubeSurfaceCircumferentialOuter>(),
      row<TubeSurfaceInclined>(),
      row<TubeEdgeAxialInner>(),
      row<TubeEdgeAxialOuter>(),
      row<TubeOvalisedSurface>(),
  };
}

}  // namespace strainwave::sif
