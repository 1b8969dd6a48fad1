// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"
#include "strainwave/sif/bar/arc_crack.hpp"
#include "strainwave/sif/bar/bar_annular.hpp"
#include "strainwave/sif/bar/bar_surface.hpp"
#include "strainwave/sif/bar/hollow_annular_inner.hpp"
#include "strainwave/sif/bar/hollow_annular_outer.hpp"
#include "strainwave/sif/bar/hollow_surface_inner.hpp"
#include "strainwave/sif/bar/hollow_surface_outer.hpp"
#include "strainwave/sif/bar/penny_crack.hpp"
#include "strainwave/sif/bar/straight_crack.hpp"

namespace strainwave::sif {

std::vector<Row> bar_rows() {
  return {
      row<BarAnnularCrack>(),
      row<BarPennyCrack>(),
      row<BarStraightCrack>(),
      row<BarSurfaceCrack>(),
      row<BarArcCrack>(),
      row<HollowAnnularOuterCrack>(),
      row<HollowAnnularInnerCrack>(),
      row<HollowSurfaceOuterCrack>(),
      row<HollowSurfaceInnerCrack>(),
  };
}

}  // namespace strainwave::sif
