// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <variant>

#include "strainwave/core/units.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave::test {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should

/// Random numbers that are the same on every platform, unlike those of the distributions in
/// <random>.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double uniform(double lower, double upper) { return lower + (upper - lower) * unit(); }
  double log_uniform(double lower, double upper) { return lower * std::pow(upper / lower, unit()); }
  int integer(int lower, int upper) {  // both included
    return lower + static_cast<int>(engine_() % static_cast<std::uint64_t>(upper - lower + 1));
  }
  bool chance(double probability) { return unit() < probability; }

 private:
  std::mt19937_64 engine_;
};

template <class Crack>
void drive_race_crack(Dice& dice, Crack& crack) {
  crack.stress_driver = static_cast<StressDriver>(dice.integer(0, 3));
  if (crack.stress_driver == StressDriver::given)
    crack.stress = dice.uniform(-50, 200) * MPa;  // sometimes pressed together
  if (crack.stress_driver == StressDriver::orthogonal_shear && dice.chance(0.5))
    crack.contact_factor = dice.uniform(0.3, 1);
}

inline WaveGenerator random_wave_generator(Dice& dice, const Transmission& drive) {
  WaveGenerator wg;
  wg.material = "steel";
  wg.force_transmission_coefficient = dice.uniform(0.2, 0.6);
  wg.load_factor = dice.uniform(1, 1.3);
  wg.conversion = dice.chance(0.2) ? Conversion::cam : Conversion::reciprocity;
  const double d = drive.pitch_diameter;
  const double t = dice.uniform(0.02, 0.08) * d;
  wg.inner_ring_thickness = t;
  wg.inner_ring_width = dice.uniform(0.06, 0.2) * d;
  wg.inner_ring_mean_radius = dice.uniform(0.3, 0.4) * d;
  const double a = dice.uniform(0.005, 0.03) * d;
  wg.contact_semi_axes = {a, a * dice.uniform(0.05, 1)};
  switch (dice.integer(0, 2)) {
    case 0:
      wg.radial_stiffness = dice.log_uniform(1e6, 1e9);
      break;
    case 1:
      wg.displacements = LobeDisplacements{.bearing = dice.log_uniform(1e-7, 1e-4),
                                           .cam = dice.uniform(0, 1e-6),
                                           .shaft = dice.chance(0.5) ? 1e-6 : 0.0};
      break;
    default: {
      Bearing bearing;
      bearing.ball_diameter = dice.uniform(0.05, 0.1) * d;
      bearing.inner_raceway_diameter = 0.7 * d;
      bearing.outer_raceway_diameter = bearing.inner_raceway_diameter + 2 * bearing.ball_diameter;
      bearing.inner_conformity = dice.uniform(0.505, 0.6);
      bearing.outer_conformity = dice.uniform(0.505, 0.6);
      bearing.loaded_balls = dice.uniform(1, 6);
      if (dice.chance(0.5))
        bearing.outer_ring = BearingRing{
            .mean_radius = 0.45 * d, .thickness = dice.uniform(0.01, 0.04) * d, .width = 0.1 * d};
      wg.bearing = bearing;
      wg.contact_semi_axes.reset();  // it follows from the bearing
    }
  }
  const int n_cracks = dice.integer(0, 2);
  for (int i = 0; i < n_cracks; ++i) {
    if (dice.chance(0.5)) {
      RaceSurfaceCrack crack;
      // It fits into the width of the ring.
      crack.depth = std::min(dice.log_uniform(1e-5, 0.95) * t, 0.49 * *wg.inner_ring_width);
      crack.aspect_ratio = dice.uniform(std::max(0.1, 2 * crack.depth / *wg.inner_ring_width), 1);
      drive_race_crack(dice, crack);
      wg.crack.emplace_back(crack);
    } else {
      RaceEdgeCrack crack;
      crack.depth = dice.log_uniform(1e-5, 0.95) * t;
      drive_race_crack(dice, crack);
      wg.crack.emplace_back(crack);
    }
  }
  return wg;
}

inline Flexspline random_flexspline(Dice& dice, const Transmission& drive) {
  Flexspline fs;
  fs.material = "steel";
  const double d = drive.pitch_diameter;
  fs.wall_thickness = dice.log_uniform(0.004, 0.06) * d;
  fs.length = dice.uniform(0.5, 1.2) * d;
  fs.shape = dice.chance(0.5) ? FlexsplineShape::cup : FlexsplineShape::cylinder;
  fs.stress_nonuniformity = dice.uniform(0.9, 1.5);
  TubeSection wall{.outer_diameter = d, .wall_thickness = *fs.wall_thickness, .length = *fs.length};
  if (dice.chance(0.4)) {
    fs.crack_free = CrackFree::sections;
    wall.wall_thickness *= dice.uniform(0.5, 1);
    fs.barrel = wall;
    if (dice.chance(0.5))
      fs.rim = TubeSection{
          .outer_diameter = d, .wall_thickness = 0.02 * d, .length = dice.uniform(0.1, 0.2) * d};
    if (dice.chance(0.5))
      fs.boss = Boss{{.outer_diameter = 0.4 * d, .wall_thickness = 0.1 * d, .length = 0.1 * d}};
    fs.length = fs.barrel->length + (fs.rim ? fs.rim->length : 0.0);
    fs.diaphragm = Diaphragm{.outer_diameter = 0.95 * d,
                             .inner_diameter = dice.uniform(0.3, 0.6) * d,
                             .thickness = *fs.wall_thickness,
                             .profile = {}};
  } else if (dice.chance(0.5)) {
    fs.shape_factor = dice.uniform(0.5, 3);
  }
  const double r = (wall.outer_diameter - wall.wall_thickness) / 2;
  const double t = wall.wall_thickness;
  const int n_cracks = dice.integer(0, 3);
  for (int i = 0; i < n_cracks; ++i) {
    const double angle =
        dice.chance(0.3) ? dice.integer(-1, 2) * 45 * deg : dice.uniform(-89, 90) * deg;
    if (dice.chance(0.5)) {
      WallThroughCrack crack;
      crack.half_length = dice.log_uniform(1e-4, 1.5) * std::sqrt(r * t);
      crack.half_length = std::min(crack.half_length, 0.45 * wall.length);
      crack.angle = angle;
      crack.shell_correction = dice.chance(0.7);
      fs.crack.emplace_back(crack);
    } else {
      WallSurfaceCrack crack;
      crack.depth = dice.log_uniform(1e-4, 0.95) * t;
      crack.half_length = crack.depth / dice.uniform(0.1, 1);
      crack.angle = angle;
      fs.crack.emplace_back(crack);
    }
  }
  return fs;
}

inline OutputShaft random_output_shaft(Dice& dice) {
  OutputShaft shaft;
  shaft.material = "steel";
  shaft.outer_diameter = dice.log_uniform(5 * mm, 300 * mm);
  shaft.inner_diameter = dice.chance(0.3) ? 0.0 : dice.uniform(0.01, 0.97) * shaft.outer_diameter;
  shaft.length = dice.uniform(0.5, 8) * shaft.outer_diameter;
  const double wall = (shaft.outer_diameter - shaft.inner_diameter) / 2;
  const int n_cracks = dice.integer(0, 2);
  for (int i = 0; i < n_cracks; ++i) {
    if (dice.chance(0.3)) {
      ShaftSurfaceCrack crack;
      crack.depth = dice.log_uniform(1e-5, 0.9) * wall;
      crack.half_length = crack.depth * dice.uniform(1, 2.5);
      shaft.crack.emplace_back(crack);
      continue;
    }
    AnnularCrack crack;
    crack.depth = dice.log_uniform(1e-7, shaft.solid() ? 0.98 : 0.95) * wall;
    if (shaft.solid() && dice.chance(0.5)) crack.solution = AnnularSolution::tada;
    shaft.crack.emplace_back(crack);
  }
  return shaft;
}

/// A drive that `check` accepts.
inline GearSet random_drive(std::uint64_t seed) {
  Dice dice(seed);
  GearSet gear;
  Material steel;
  steel.youngs_modulus = dice.log_uniform(3e9, 400e9);
  steel.poissons_ratio = dice.uniform(0.1, 0.45);
  if (dice.chance(0.3))
    steel.shear_modulus =
        *steel.youngs_modulus / (2 * (1 + *steel.poissons_ratio)) * dice.uniform(0.95, 1.05);
  if (dice.chance(0.5)) steel.yield_strength = dice.log_uniform(50 * MPa, 2 * GPa);
  if (dice.chance(0.5)) steel.fracture_toughness = dice.log_uniform(1e6, 2e8);
  gear.material["steel"] = steel;
  gear.drive.ratio = dice.integer(30, 320);
  gear.drive.wave_number = dice.integer(2, 4);
  gear.drive.pitch_diameter = dice.log_uniform(20 * mm, 400 * mm);
  gear.drive.radial_displacement =
      dice.uniform(0.4, 1.9) * gear.drive.pitch_diameter / (2 * gear.drive.ratio);
  gear.load.torque = (dice.chance(0.5) ? 1 : -1) * dice.log_uniform(0.1, 1e4);
  gear.load.axial_force = dice.chance(0.4) ? 0.0 : dice.uniform(-1, 1) * 1e4;
  const int members = dice.integer(1, 7);
  if ((members & 1) != 0) gear.wave_generator = random_wave_generator(dice, gear.drive);
  if ((members & 2) != 0) gear.flexspline = random_flexspline(dice, gear.drive);
  if ((members & 4) != 0) gear.output_shaft = random_output_shaft(dice);
  return gear;
}

}  // namespace strainwave::test
