// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "strainwave/core/units.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave::test {

/// The article's worked example, the same drive as examples/article.toml.
///
/// @param crack_size  depth a of the cracks in race and shaft, and half length of the crack in the
///                    flexspline [m]; the article uses 0.1 mm for all three
inline GearSet article_gear(double crack_size = 0.1 * units::mm) {
  using units::GPa;
  using units::mm;
  using units::N;

  GearSet gear;
  gear.name = "Article example: double wave, ratio 100, pitch diameter 160 mm";
  gear.material["steel"] = {.youngs_modulus = 210 * GPa,
                            .shear_modulus = 80 * GPa,  // printed; E/2(1+nu) would be 80.77 GPa
                            .poissons_ratio = 0.3,
                            .yield_strength = {},
                            .fracture_toughness = {}};
  gear.drive = {
      .ratio = 100, .wave_number = 2, .pitch_diameter = 160 * mm, .radial_displacement = 0.8 * mm};
  gear.load = {.torque = 100, .axial_force = 0};

  WaveGenerator wave_generator;
  wave_generator.material = "steel";
  wave_generator.force_transmission_coefficient = 0.35;
  wave_generator.load_factor = 1.15;
  wave_generator.radial_stiffness = 1.2e5 * N / mm;
  wave_generator.inner_ring_thickness = 10 * mm;
  wave_generator.contact_semi_axes = {5 * mm, 2 * mm};
  RaceSurfaceCrack race;
  race.depth = crack_size;
  race.aspect_ratio = 0.52147039;  // gives Q = 1.5
  race.stress_driver = StressDriver::orthogonal_shear;
  race.contact_factor = 0.45;
  wave_generator.crack = {race};
  gear.wave_generator = wave_generator;

  Flexspline flexspline;
  flexspline.material = "steel";
  flexspline.shape = FlexsplineShape::cup;
  flexspline.wall_thickness = 2.24 * mm;
  flexspline.length = 160 * mm;
  flexspline.crack_free = CrackFree::factor;
  flexspline.stress_nonuniformity = 1.1;
  flexspline.dynamic_load = 1.2;
  WallThroughCrack wall;
  wall.half_length = crack_size;
  wall.angle = std::numbers::pi / 4;
  flexspline.crack = {wall};
  gear.flexspline = flexspline;

  OutputShaft shaft;
  shaft.material = "steel";
  shaft.outer_diameter = 70 * mm;
  shaft.inner_diameter = 45 * mm;
  shaft.length = 200 * mm;
  AnnularCrack annular;
  annular.depth = crack_size;
  shaft.crack = {annular};
  gear.output_shaft = shaft;

  gear.article = ArticleOverrides{.radial_load = 500 * N,
                                  .flaw_parameter = 1.5,
                                  .mean_radius = 79.88 * mm,
                                  .equivalent_shaft_diameter = 60 * mm,
                                  .M_p = 0.85,
                                  .M_M = 0.42};
  return gear;
}

}  // namespace strainwave::test
