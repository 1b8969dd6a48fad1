// SPDX-License-Identifier: Apache-2.0
#include "strainwave/catalogue/factors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strainwave/core/enum_list.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

namespace strainwave {
namespace {

// Plausible ranges.  Support, coning and gap are as in proportions.cpp; a pair of teeth has half to
// twice the compliance of plane finite elements; structure follows from the limits of barrel and
// diaphragm; play is up to 3 um at size 25 and ratio 100; a cam lies between the cosine and an
// ellipse.  A fit to one drive may go further, because a factor then also absorbs errors of the
// drive's model.
constexpr std::array<FactorInfo, kFactors> kInfo = {{
    {"share of the circular spline's compliance that remains in its housing", 0.1, 1.0, 0.01, 1.0,
     true},
    {"tilt of the teeth by the cup; 1 for uncorrected teeth", 0.1, 1.0, 0.01, 3.0, true},
    {"gap between the flanks over the gap of straight flanks", 0.8, 1.2, 0.2, 4.0, true},
    {"compliance of a pair of teeth over the value in the file", 0.5, 2.0, 0.1, 10.0, true},
    {"thickness of barrel and diaphragm in the file over the fitted one", 0.6, 1.5, 0.2, 5.0, true},
    {"radial play at a ball over w_0", 0.0, 0.01, 0.0, 0.05, false},
    {"depth of the cam inside the cosine; 1.5 for an ellipse", 0.0, 1.5, 0.0, 6.0, false},
}};

void need(bool there, std::string_view field, Factor factor) {
  if (!there)
    throw InputError(field, fmt::format("must be given for the factor {}", enum_name(factor)));
}

void need_fields(const GearSet& gear, Factor factor) {
  switch (factor) {
    case Factor::support:
      need(gear.circular_spline.has_value(), "circular_spline", factor);
      return;
    case Factor::coning:
    case Factor::gap_factor:
      need(gear.mesh.has_value(), "mesh", factor);
      return;
    case Factor::pair_compliance:
      need(gear.mesh.has_value(), "mesh", factor);
      need(gear.flexspline && gear.flexspline->rim, "flexspline.rim", factor);
      return;
    case Factor::structure:
      need(gear.flexspline && gear.flexspline->barrel, "flexspline.barrel", factor);
      need(gear.flexspline->diaphragm.has_value(), "flexspline.diaphragm", factor);
      return;
    case Factor::clearance:
      need(gear.wave_generator && gear.wave_generator->bearing, "wave_generator.bearing", factor);
      return;
    case Factor::cam_flattening:
      need(gear.wave_generator.has_value(), "wave_generator", factor);
      if (gear.wave_generator->cam)
        throw InputError("wave_generator.cam", "must be left out to vary cam_flattening");
      return;
  }
}

}  // namespace

const FactorInfo& factor_info(Factor factor) { return kInfo[static_cast<std::size_t>(factor)]; }

double factor_value(const GearSet& gear, Factor factor) {
  need_fields(gear, factor);
  switch (factor) {
    case Factor::support:
      return gear.circular_spline->support;
    case Factor::coning:
      return gear.mesh->coning;
    case Factor::gap_factor:
      return gear.mesh->gap_factor;
    case Factor::clearance:
      return gear.wave_generator->bearing->clearance / gear.drive.radial_displacement;
    case Factor::cam_flattening:
      return gear.wave_generator->cam_flattening;
    case Factor::pair_compliance:
    case Factor::structure:
      break;
  }
  return 1.0;
}

GearSet with_factor(GearSet gear, Factor factor, double value) {
  need_fields(gear, factor);
  switch (factor) {
    case Factor::support:
      gear.circular_spline->support = value;
      break;
    case Factor::coning:
      gear.mesh->coning = value;
      break;
    case Factor::gap_factor:
      gear.mesh->gap_factor = value;
      break;
    case Factor::pair_compliance:
      gear.mesh->pair_stiffness = drive_pair_stiffness(gear) / value;
      break;
    case Factor::structure: {
      TubeSection& barrel = *gear.flexspline->barrel;
      const double mean = barrel.outer_diameter - barrel.wall_thickness;
      barrel.wall_thickness /= value;
      barrel.outer_diameter = mean + barrel.wall_thickness;
      gear.flexspline->diaphragm->thickness /= value;
      for (DiaphragmStation& station : gear.flexspline->diaphragm->profile)
        station.thickness /= value;
      break;
    }
    case Factor::clearance:
      gear.wave_generator->bearing->clearance = value * gear.drive.radial_displacement;
      break;
    case Factor::cam_flattening:
      gear.wave_generator->cam_flattening = value;
      break;
  }
  return gear;
}

std::vector<Factor> parse_factors(std::string_view text) {
  return parse_enum_list<Factor>("factors", text);
}

std::string factor_names(const std::vector<Factor>& factors) {
  std::string text;
  for (const Factor factor : factors) {
    if (!text.empty()) text += ", ";
    text += enum_name(factor);
  }
  return text;
}

}  // namespace strainwave
