// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"
#include "strainwave/sif/gradient/contact_edge.hpp"
#include "strainwave/sif/gradient/gradient_edge.hpp"
#include "strainwave/sif/gradient/gradient_surface.hpp"
#include "strainwave/sif/gradient/notch_edge.hpp"
#include "strainwave/sif/gradient/notch_surface.hpp"
#include "strainwave/sif/gradient/race_hoop_edge.hpp"
#include "strainwave/sif/gradient/race_hoop_surface.hpp"
#include "strainwave/sif/gradient/residual_edge.hpp"
#include "strainwave/sif/gradient/residual_surface.hpp"

namespace strainwave::sif {

std::vector<Row> gradient_rows() {
  return {
      row<GradientEdgeCrack>(), row<GradientSurfaceCrack>(), row<NotchEdgeCrack>(),
      row<NotchSurfaceCrack>(), row<ResidualEdgeCrack>(),    row<ResidualSurfaceCrack>(),
      row<ContactEdgeCrack>(),  row<RaceHoopEdgeCrack>(),    row<RaceHoopSurfaceCrack>(),
  };
}

}  // namespace strainwave::sif
