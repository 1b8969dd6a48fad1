// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/torsion_curve.hpp"
#include "support/reference_csv.hpp"

namespace strainwave::test {

/// Inputs of one drive of tests/data/coupled_drive_members.csv, by name [SI].
using DriveInputs = std::map<std::string, double>;

inline const DriveInputs& drive_inputs(int size, double ratio) {
  static const std::map<std::pair<int, double>, DriveInputs> all = [] {
    std::map<std::pair<int, double>, DriveInputs> drives;
    for (const CsvRow& row : read_reference_csv("coupled_drive_members"))
      if (row.quantity.starts_with("input."))
        drives[{static_cast<int>(row("size")), row("ratio")}][row.quantity.substr(6)] = row.value;
    return drives;
  }();
  const auto found = all.find({size, ratio});
  if (found == all.end()) throw std::runtime_error("no such drive in coupled_drive_members.csv");
  return found->second;
}

/// A cup drive of two lobes with the proportions that tools/reference/coupled_drive.py calls
/// typical; sound, circular spline rigid, torque of the file 1 N*m.
inline GearSet typical_drive(int size = 25, double ratio = 50) {
  const DriveInputs& inputs = drive_inputs(size, ratio);
  const auto in = [&](const char* name) { return inputs.at(name); };
  const double R = in("rim_radius");
  const double t_r = in("rim_thickness");
  const double t_b = in("barrel_thickness");
  const double b = in("face_width");

  GearSet gear;
  gear.name = "typical cup drive";
  gear.material["steel"] = {.youngs_modulus = in("youngs_modulus"),
                            .shear_modulus = {},
                            .poissons_ratio = in("poissons_ratio"),
                            .yield_strength = {},
                            .fracture_toughness = {}};
  gear.drive = {.ratio = in("ratio"),
                .wave_number = 2,
                .pitch_diameter = in("pitch_diameter"),
                .radial_displacement = in("radial_displacement")};
  gear.load = {.torque = 1, .axial_force = 0};

  WaveGenerator wave_generator;
  wave_generator.material = "steel";
  wave_generator.force_transmission_coefficient = 0.35;  // not used by the coupled drive
  wave_generator.cam_flattening = in("cam_factor");
  const double t_o = in("outer_race_thickness");
  wave_generator.bearing = Bearing{.ball_diameter = in("ball_diameter"),
                                   .inner_raceway_diameter = in("inner_race_diameter"),
                                   .outer_raceway_diameter = in("outer_race_diameter"),
                                   .inner_conformity = in("inner_conformity"),
                                   .outer_conformity = in("outer_conformity"),
                                   .loaded_balls = 1,
                                   .ball_count = static_cast<int>(in("ball_count")),
                                   .clearance = in("clearance"),
                                   .outer_ring = BearingRing{.mean_radius = R - t_r / 2 - t_o / 2,
                                                             .thickness = t_o,
                                                             .width = in("race_width"),
                                                             .groove_factor = in("groove_factor")}};
  gear.wave_generator = wave_generator;

  Flexspline flexspline;
  flexspline.material = "steel";
  flexspline.shape = FlexsplineShape::cup;
  flexspline.crack_free = CrackFree::sections;
  flexspline.wall_thickness = t_b;
  flexspline.length = in("barrel_length") + b;
  flexspline.rim = TubeSection{.outer_diameter = 2 * R + t_r, .wall_thickness = t_r, .length = b};
  flexspline.barrel = TubeSection{
      .outer_diameter = 2 * R + t_b, .wall_thickness = t_b, .length = in("barrel_length")};
  flexspline.diaphragm = Diaphragm{.outer_diameter = 2 * in("diaphragm_outer_radius"),
                                   .inner_diameter = 2 * in("diaphragm_inner_radius"),
                                   .thickness = in("diaphragm_thickness"),
                                   .profile = {}};
  gear.flexspline = flexspline;

  ToothMesh mesh;
  mesh.flank_angle = in("flank_angle");
  mesh.gap_factor = in("gap_factor");
  mesh.coning = in("coning");
  mesh.lobe_gap = in("lobe_gap");
  mesh.rim_stiffening = in("rim_stiffening");
  gear.mesh = mesh;

  CircularSpline spline;
  spline.material = "steel";
  spline.outer_diameter = in("spline_outer_diameter");
  spline.inner_diameter = in("spline_inner_diameter");
  spline.width = in("spline_width");
  spline.support = in("spline_support");
  gear.circular_spline = spline;
  return gear;
}

/// Makes a short silk hat of the cup of size 25.
inline void make_hat(GearSet& gear) {
  Flexspline& hat = *gear.flexspline;
  hat.shape = FlexsplineShape::hat;
  hat.length.reset();
  hat.barrel->length = 9.525e-3;
  hat.diaphragm->inner_diameter = 62.04e-3;
  hat.diaphragm->outer_diameter = 86e-3;
}

/// The maker's torques by convention [N*m]: where the lines of the curve of a drive meet.
inline std::array<double, 3> conventional_torques(const GearSet& gear) {
  const double d3 =
      gear.drive.pitch_diameter * gear.drive.pitch_diameter * gear.drive.pitch_diameter;
  return {51.7e3 * d3, 187e3 * d3, 1.6 * 187e3 * d3};
}

// Cracks, as in tools/reference/coupled_drive.py: depth over thickness, tooth by its number.

inline void crack_tooth(GearSet& gear, int index, double loss) {
  const double z = 2 * gear.drive.ratio;
  gear.mesh->crack.emplace_back(
      ToothCrack{.stiffness_loss = loss, .position = (index + 0.5) * 2 * std::numbers::pi / z});
}

template <class Crack>
Crack ring_crack(double depth, double position) {
  Crack crack;
  crack.depth = depth;
  crack.position = position;
  return crack;
}

inline void crack_rim(GearSet& gear, double depth_ratio = 0.5, double position = 0.3) {
  gear.flexspline->crack.emplace_back(
      ring_crack<RimAxialCrack>(depth_ratio * gear.flexspline->rim->wall_thickness, position));
}

inline void crack_outer_race(GearSet& gear, double depth_ratio = 0.5,
                             double position = std::numbers::pi / 2) {
  gear.wave_generator->crack.emplace_back(ring_crack<OuterRaceCrack>(
      depth_ratio * gear.wave_generator->bearing->outer_ring->thickness, position));
}

inline void crack_spline(GearSet& gear, double depth_ratio = 0.4, double position = 0.2) {
  const CircularSpline& spline = *gear.circular_spline;
  gear.circular_spline->crack.emplace_back(ring_crack<CircularSplineRingCrack>(
      depth_ratio * (spline.outer_diameter - spline.inner_diameter) / 2, position));
}

/// Adds a crack of the inner race that gives ball 1 a compliance [m/N]: the compliance is
/// proportional to the square of the stress.
inline void crack_race(GearSet& gear, double compliance, const CoupledOptions& options = {}) {
  WaveGenerator& wg = *gear.wave_generator;
  wg.inner_ring_thickness = 1.5e-3;
  wg.inner_ring_mean_radius = 23e-3;
  wg.inner_ring_width = 9e-3;
  wg.conversion = Conversion::reciprocity;
  RaceSurfaceCrack crack;
  crack.depth = 1.2e-3;
  crack.aspect_ratio = 0.3;
  crack.position = 2 * std::numbers::pi / 23 + 0.05;  // ball 1 is the nearest
  crack.contact_factor = 0.1;
  // The crack is evaluated at the force of its ball at T2 in the sound drive.
  const double T2 = makers_torques(gear).T2;
  double force = 0.0;
  for (const double torque : {T2, -T2})
    force = std::max(force, torsion_curve(without_cracks(gear), std::array{torque}, options)
                                .points.at(0)
                                .balls.at(1)
                                .force);
  GearSet alone = gear;
  alone.wave_generator->crack = {crack};
  alone.wave_generator->bearing->loaded_balls = 1;
  alone.load.torque = force / lobe_force_per_torque(gear.drive, wg);
  const double f = lobe_force_per_torque(gear.drive, wg);
  const double at_ball =
      wave_generator_compliance(alone).cracks.at(0).positive.at_output.value / (f * f);
  *crack.contact_factor *= std::sqrt(compliance / at_ball);
  wg.crack.emplace_back(crack);
}

/// Puts the circular spline into a housing that leaves half of its compliance.
inline void half_free(GearSet& gear) { gear.circular_spline->support = 0.5; }

/// Teeth as drawn in a half free circular spline, whose roots the tips of the flexspline do not
/// meet.
inline void draw_teeth(GearSet& gear, ToothProfile profile, ToothTips tips = ToothTips::full) {
  half_free(gear);
  gear.mesh->tooth = ToothShape{
      .profile = profile, .addendum = {}, .spline_addendum = {}, .thickness = {}, .tips = tips};
  const double module = gear.drive.pitch_diameter / (2 * gear.drive.ratio);
  gear.circular_spline->inner_diameter = gear.drive.pitch_diameter + 4.2 * module;
}

}  // namespace strainwave::test
