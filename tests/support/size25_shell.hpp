// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/units.hpp"
#include "strainwave/oval_shell/oval_shell.hpp"

namespace strainwave::test {

/// The cup of examples/breathing_crack.toml as a shell.
inline ShellCup size25_shell() {
  using units::mm;
  return {
      .barrel = {.outer_diameter = 62.499 * mm, .wall_thickness = 0.453 * mm, .length = 17.2 * mm},
      .rim = {.outer_diameter = 62.801 * mm, .wall_thickness = 0.755 * mm, .length = 9.5 * mm},
      .diaphragm = Diaphragm{.outer_diameter = 62.046 * mm,
                             .inner_diameter = 36.8 * mm,
                             .thickness = 0.762 * mm,
                             .profile = {}},
      .youngs_modulus = 206 * units::GPa,
      .poissons_ratio = 0.3};
}

/// Its cam.
inline CamFit size25_cam() {
  return {.radial_displacement = 0.3175 * units::mm, .band_width = 9.2 * units::mm};
}

}  // namespace strainwave::test
