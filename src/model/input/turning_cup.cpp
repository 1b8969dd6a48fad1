// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/turning_cup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {

CamFit cam_fit(const GearSet& gear) {
  CamFit fit{.radial_displacement = gear.drive.radial_displacement};
  if (!gear.wave_generator) return fit;
  fit.shape = cam_shape(*gear.wave_generator);
  fit.perimeter_excess = gear.wave_generator->cam_perimeter_excess.value_or(0.0);
  if (const auto& bearing = gear.wave_generator->bearing) {
    fit.clearance = bearing->clearance;
    if (bearing->outer_ring) fit.band_width = bearing->outer_ring->width;
  }
  return fit;
}

bool perimeter_is_assumed(const GearSet& gear) {
  return !gear.wave_generator || (!gear.wave_generator->cam_perimeter_excess &&
                                  follows_perimeter(cam_shape(*gear.wave_generator)));
}

namespace {

/// Refuses a cam that cannot be in the bore of the rim, or stretches the rim until it yields.
void check_fit(const GearSet& gear, const TubeSection& rim, const Material& steel) {
  const CamFit fit = cam_fit(gear);
  const double bore = rim.outer_diameter / 2 - rim.wall_thickness;
  const double middle = bore + rim.wall_thickness / 2;
  check(fit.shape, fit.radial_displacement, bore, FieldPath("wave_generator.cam"));
  const double excess = follows_perimeter(fit.shape)
                            ? fit.perimeter_excess - 2 * std::numbers::pi * fit.clearance
                            : CamCurve(fit, bore, middle, true).band_excess();
  const double stress = elastic_constants(steel).E * excess / (2 * std::numbers::pi * middle);
  if (!steel.yield_strength || stress <= *steel.yield_strength) return;
  const std::string stretched =
      fmt::format("stretches the rim to {:.4g} MPa, beyond its yield strength of {:.4g} MPa; give ",
                  stress / units::MPa, *steel.yield_strength / units::MPa);
  if (std::holds_alternative<TwoDiscs>(fit.shape))
    throw InputError("wave_generator.cam.disc_offset", stretched + "a larger one");
  if (std::holds_alternative<CamPoints>(fit.shape))
    throw InputError("wave_generator.cam.point", stretched + "smaller heights");
  throw InputError("wave_generator.cam_perimeter_excess", stretched + "a smaller one");
}

}  // namespace

bool rim_covers(const TubeSection& rim, const TubeSection& barrel) {
  const auto outside = [](const TubeSection& tube) { return tube.outer_diameter / 2; };
  const auto inside = [&](const TubeSection& tube) { return outside(tube) - tube.wall_thickness; };
  const double tiny = 1e-9 * outside(barrel);
  return outside(rim) >= outside(barrel) - tiny && inside(rim) <= inside(barrel) + tiny;
}

void require_turning_cup(const GearSet& gear) {
  if (!gear.flexspline) throw InputError("flexspline", "must be given to be computed");
  const Flexspline& flexspline = *gear.flexspline;
  if (flexspline.crack_free != CrackFree::sections)
    throw InputError("flexspline.crack_free",
                     "must be \"sections\" for a turn, which needs barrel, rim and bottom");
  if (gear.drive.wave_number != 2)
    throw InputError("drive.wave_number",
                     fmt::format("is {}, but a turn is computed for the two lobes of an oval only",
                                 gear.drive.wave_number));
  if (flexspline.shape == FlexsplineShape::hat)
    throw InputError("flexspline.shape", "must be \"cup\" or \"cylinder\" for a turn");
  if (!flexspline.rim)
    throw InputError("flexspline.rim",
                     "must be given, because the wave generator presses on the bore of the rim");
  if (!rim_covers(*flexspline.rim, *flexspline.barrel))
    throw InputError("flexspline.rim",
                     "must have a wall that covers the barrel's, inside and outside");
  check_fit(gear, *flexspline.rim, only_material(gear, flexspline));
}

}  // namespace strainwave
