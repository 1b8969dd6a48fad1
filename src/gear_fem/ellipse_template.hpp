// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/fem/hex_mesh.hpp"

namespace strainwave::gear_fem {

/// A slab 0 <= z <= thickness with a semi-elliptical crack in y = 0, its mouth on z = 0.
///
/// About the front the rings are swept along confocal ellipses (FE-27); a box about the crack turns
/// them into straight lines, which continue to the ends of the slab.
struct EllipseTemplate {
  double depth{};             ///< a, along z [m]
  double half_length{};       ///< c, along x [m]
  double thickness{};         ///< [m]; > a
  std::array<double, 2> x{};  ///< ends of the slab [m]
  std::array<double, 2> y{};  ///< ends of the slab [m]
  double longest_x{};         ///< longest cell along x [m]
  double longest_y{};         ///< longest cell along y [m]
  int rings = 3;              ///< circular rings
  int segments = 8;           ///< segments along the front, a multiple of 4
  double growth = 2;          ///< growth from cell to cell away from the crack
};

/// Half axis along x of the ellipse that encloses all rings [m].
[[nodiscard]] double rings_half_length(const EllipseTemplate& slab);

/// The cells of the slab with one front, which starts at +c.
[[nodiscard]] std::vector<fem::TemplateCell> ellipse_template(const EllipseTemplate& slab);

/// True inside the crack and on its mouth, but not on its front.
[[nodiscard]] bool inside_ellipse(const EllipseTemplate& slab, const fem::Point3& p);

}  // namespace strainwave::gear_fem
