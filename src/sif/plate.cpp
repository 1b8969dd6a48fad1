// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"
#include "strainwave/sif/plate/body_ellipse.hpp"
#include "strainwave/sif/plate/body_penny.hpp"
#include "strainwave/sif/plate/collinear_periodic.hpp"
#include "strainwave/sif/plate/collinear_two.hpp"
#include "strainwave/sif/plate/corner_crack.hpp"
#include "strainwave/sif/plate/embedded_ellipse.hpp"
#include "strainwave/sif/plate/inclined_edge.hpp"
#include "strainwave/sif/plate/pin_forces.hpp"
#include "strainwave/sif/plate/plate_surface.hpp"
#include "strainwave/sif/plate/plate_through.hpp"
#include "strainwave/sif/plate/stacked_periodic.hpp"
#include "strainwave/sif/plate/strip_centre.hpp"
#include "strainwave/sif/plate/strip_double_edge.hpp"
#include "strainwave/sif/plate/strip_edge.hpp"

namespace strainwave::sif {

std::vector<Row> plate_rows() {
  return {
      row<PlateThroughCrack>(),
      row<StripCentreCrack>(),
      row<StripEdgeCrack>(),
      row<StripDoubleEdgeCrack>(),
      row<HalfPlaneEdgeCrack>(),
      row<PlateCollinearTwo>(),
      row<PlateCollinearPeriodic>(),
      row<PlateStackedPeriodic>(),
      row<PlatePinForces>(),
      row<PlateSurfaceCrack>(),
      row<PlateCornerCrack>(),
      row<PlateEllipse>(),
      row<BodyEllipse>(),
      row<BodyPenny>(),
  };
}

}  // namespace strainwave::sif
