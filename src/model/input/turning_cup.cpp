// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/turning_cup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {

CamCurve::CamCurve(const CamFit& fit, double bore, double middle, bool exact)
    : bore_(bore),
      two_(fit.radial_displacement),
      four_(fit.flattening * fit.radial_displacement * fit.radial_displacement / (2 * middle)),
      mean_(fit.perimeter_excess / (2 * std::numbers::pi)) {
  const double wanted = 2 * std::numbers::pi * bore + fit.perimeter_excess;
  // A uniform offset changes the length of a curve by 2 pi times the offset, up to terms of higher
  // order, which two more steps remove.
  if (exact)
    for (int step = 0; step < 3; ++step) mean_ += (wanted - length()) / (2 * std::numbers::pi);
  mean_ -= fit.clearance;
}

double CamCurve::at(double angle) const {
  return mean_ + two_ * std::cos(2 * angle) + four_ * std::cos(4 * angle);
}

double CamCurve::slope(double angle) const {
  return -2 * two_ * std::sin(2 * angle) - 4 * four_ * std::sin(4 * angle);
}

double CamCurve::farthest() const {
  double most = at(0);
  for (int i = 1; i <= 90; ++i) most = std::max(most, at(std::numbers::pi / 2 * i / 90));
  return most;
}

double CamCurve::length() const {
  constexpr int kPoints = 256;  // exact for a smooth periodic curve
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPoints;
    sum += std::hypot(bore_ + at(angle), slope(angle)) * 2 * std::numbers::pi / kPoints;
  }
  return sum;
}

CamGap::CamGap(const CamCurve& cam, double angle, double u_r, double u_theta) {
  const double x = cam.bore() + u_r;
  const double distance = std::hypot(x, u_theta);
  const double now = angle + std::atan2(u_theta, x);
  const double slope = cam.slope(now);
  value = distance - cam.bore() - cam.at(now);
  by_r = x / distance + slope * u_theta / (distance * distance);
  by_theta = u_theta / distance - slope * x / (distance * distance);
}

void check(const CamFit& fit, const TubeSection& rim) {
  const auto length = [](double value, const char* name, bool zero) {
    require((zero ? value >= 0 : value > 0) && std::isfinite(value), name, value, "m",
            zero ? ">= 0" : "> 0");
  };
  length(fit.radial_displacement, "radial_displacement", false);
  length(fit.clearance, "clearance", true);
  length(fit.band_width, "band_width", true);
  require(fit.flattening >= 0 && std::isfinite(fit.flattening), "cam_flattening", fit.flattening,
          "1", ">= 0");
  require(std::abs(fit.perimeter_excess) < 0.01 * std::numbers::pi * rim.outer_diameter,
          "perimeter_excess", fit.perimeter_excess, "m", "less than 1 % of the perimeter");
}

CamFit cam_fit(const GearSet& gear) {
  CamFit fit{.radial_displacement = gear.drive.radial_displacement};
  if (!gear.wave_generator) return fit;
  fit.flattening = gear.wave_generator->cam_flattening;
  fit.perimeter_excess = gear.wave_generator->cam_perimeter_excess.value_or(0.0);
  if (const auto& bearing = gear.wave_generator->bearing) {
    fit.clearance = bearing->clearance;
    if (bearing->outer_ring) fit.band_width = bearing->outer_ring->width;
  }
  return fit;
}

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
  const Material& steel = material_of(gear, flexspline.material, "flexspline.material");
  const CamFit fit = cam_fit(gear);
  const double stretch =
      fit.perimeter_excess /
      (std::numbers::pi * (flexspline.rim->outer_diameter - flexspline.rim->wall_thickness));
  const double stress = elastic_constants(steel).E * stretch;
  if (steel.yield_strength && stress > *steel.yield_strength)
    throw InputError("wave_generator.cam_perimeter_excess",
                     fmt::format("stretches the rim to {:.4g} MPa, beyond its yield strength of "
                                 "{:.4g} MPa; give a smaller one",
                                 stress / units::MPa, *steel.yield_strength / units::MPa));
}

}  // namespace strainwave
