// SPDX-License-Identifier: Apache-2.0
#include "flexspline_fatigue.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kUsualAddendum = 0.65;  // working height over the module, as in ToothShape

const Material& steel_of(const GearSet& gear) { return only_material(gear, *gear.flexspline); }

}  // namespace

FlankForce::FlankForce(const std::vector<ContactForce>& flanks, double pitch)
    : pitch_(pitch), flanks_(flanks) {}

double FlankForce::at(double angle) const {
  double force = 0.0;
  for (const ContactForce& flank : flanks_) {
    const double away = std::abs(std::remainder(angle - flank.position, 2 * pi)) / pitch_;
    if (away < 1) force += (1 - away) * flank.force;
  }
  return force;
}

WorkingHeights working_heights(const GearSet& gear) {
  const double module = gear.drive.pitch_diameter / (gear.drive.wave_number * gear.drive.ratio);
  const ToothShape tooth = gear.mesh->tooth.value_or(ToothShape{});
  return {.addendum = tooth.addendum.value_or(kUsualAddendum * module),
          .spline_addendum = tooth.spline_addendum.value_or(kUsualAddendum * module),
          .thickness = tooth.thickness.value_or(pi * module / 2)};
}

std::string_view place_words(FatiguePlace place) {
  switch (place) {
    case FatiguePlace::wall:
      return "wall at the rim";
    case FatiguePlace::rim:
      return "bore of the rim";
    case FatiguePlace::tooth_root:
      return "tooth root";
  }
  return {};
}

PlaceStrength::PlaceStrength(const GearSet& gear, FatiguePlace place) {
  const Material& steel = steel_of(gear);
  if (!steel.fatigue || !steel.ultimate_strength) {
    unknown_because_ = "Give fatigue.limit and ultimate_strength of the flexspline's material.";
    return;
  }
  fatigue_ = *steel.fatigue;
  surface_ =
      fatigue_.roughness ? surface_factor(*fatigue_.roughness, *steel.ultimate_strength) : 1.0;
  size_ = fatigue_.size_factor.value_or(1.0);
  const double sensitivity = mean_stress_sensitivity(*steel.ultimate_strength);
  if (place == FatiguePlace::tooth_root && gear.flexspline->tooth_root)
    support_ = notch_support(gear.flexspline->tooth_root->root_radius, *steel.ultimate_strength);
  const double limit = fatigue_.limit * surface_ * size_ * support_;
  specimen_shear_ = kShearOverNormal * fatigue_.limit;
  plane_ = {.normal = limit,
            .shear = kShearOverNormal * limit,
            .sensitivity = sensitivity,
            .shear_sensitivity = kShearOverNormal * sensitivity};
  if (!(limit > 0)) unknown_because_ = "Give a smaller roughness; its factor leaves no endurance.";
}

PlaceStresses::PlaceStresses(const GearSet& gear, FatiguePlace place)
    : place_(place), wall_shear_factor_(gear.flexspline->stress_nonuniformity) {
  const Flexspline& fs = *gear.flexspline;
  const double t = fs.rim->wall_thickness;
  const double R = (fs.rim->outer_diameter - t) / 2;
  rim_shear_per_torque_ = 1 / (2 * pi * R * R * t);
  if (place != FatiguePlace::tooth_root) return;
  if (!fs.tooth_root) {
    unknown_because_ = "Give [flexspline.tooth_root] with height and root_radius.";
    return;
  }
  const ToothRoot& given = *fs.tooth_root;
  const double teeth = gear.drive.wave_number * gear.drive.ratio;
  const ToothMesh& mesh = *gear.mesh;
  heights_ = working_heights(gear);
  lift_ = gear.drive.radial_displacement;
  root_ = RootSection{.thickness = given.thickness.value_or(
                          heights_.thickness + 2 * given.height * std::tan(mesh.flank_angle)),
                      .lever = given.height,
                      .root_radius = given.root_radius,
                      .face_width = fs.rim->length};
  across_ = std::cos(mesh.flank_angle);
  pitch_ = 2 * pi / teeth;
  groove_ = groove_concentration(pi * fs.rim->outer_diameter / teeth, given.root_radius);
  sides_ = {+1, -1};
}

WaveStates PlaceStresses::over_turn(const std::vector<RimState>& rim, const CurvePoint& point,
                                    int side) const {
  WaveStates states;
  states.reserve(rim.size());
  const double rim_shear = rim_shear_per_torque_ * point.torque;
  if (place_ == FatiguePlace::wall) {
    for (const RimState& state : rim)
      states.push_back({.hoop = state.barrel_bending_stress.value(),
                        .shear = wall_shear_factor_ * state.barrel_shear_stress});
  } else if (place_ == FatiguePlace::rim) {
    for (const RimState& state : rim)
      states.push_back({.hoop = state.rim_inside_stress, .shear = rim_shear});
  } else {
    const FlankForce drive(point.drive_flanks, pitch_);
    const FlankForce coast(point.coast_flanks, pitch_);
    for (const RimState& state : rim) {
      const double force = across_ * (drive.at(state.position) - coast.at(state.position));
      RootSection root = *root_;
      // The middle of the height that is engaged, from the tip of the circular spline's tooth to
      // that of the flexspline's.
      const double middle =
          (heights_.addendum - heights_.spline_addendum + lift_ - state.radial) / 2;
      root.lever += std::clamp(middle, -root.lever / 2, heights_.addendum);  // (LI-41)
      const double bending = force == 0 ? 0.0 : root_bending_stress(root, force);
      states.push_back({.hoop = groove_.hoop * state.rim_outside_stress + side * bending,
                        .shear = groove_.shear * rim_shear});
    }
  }
  return states;
}

}  // namespace strainwave
