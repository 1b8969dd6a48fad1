// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"

/// @file
/// The drive and its cracks, drawn to scale from the numbers of an input file.
///
/// Each drawing is an SVG document whose user unit is one millimetre of paper; `data-scale` is
/// paper length per real length.  A cut part is a path with `data-part`.  A crack is a path with
/// `data-crack`, which holds its field path.  Dimensions that the file does not give are dashed and
/// labelled as sketched; they do not represent the drive.  Colours are CSS variables (`--ink`,
/// `--paper`, `--crack`, ...) with fallbacks for white paper.

namespace strainwave {

/// A crack with its number in all drawings and tables of a report.
struct NumberedCrack {
  int number = 0;    ///< from 1
  std::string path;  ///< "flexspline.crack[0]"
  std::string kind;  ///< "through"
  CrackPlace place;  ///< part, shape, size and position of the crack
  std::string size;  ///< "2a = 4 mm, β = 45°", written for people
};

/// All cracks of a drive, in the order of `for_each_crack`.
[[nodiscard]] std::vector<NumberedCrack> numbered_cracks(const GearSet& gear);

/// Half section through the axis, at the major axis of the wave generator, output to the right.
///
/// All parts are round, as before assembly.  A crack is drawn at its place and in true size.  A
/// crack shorter than 0.7 mm on paper is shown again, enlarged by a stated scale.  If the file does
/// not give the position of a crack along a wall or shaft, the crack is drawn in the middle.
/// @return  empty if the file lacks wave generator, flexspline, circular spline and shaft
[[nodiscard]] std::string section_drawing(const GearSet& gear);

/// View along the axis, from the output: cracks that have an angle from the major axis.
/// Radii are true at the lobes; elsewhere the deflection w_0 is drawn enlarged by a stated factor.
/// Angle +theta is counter-clockwise.
/// @return  empty if no crack has an angular position
[[nodiscard]] std::string front_drawing(const GearSet& gear);

/// The developed wall of the flexspline, seen from outside: cracks with an angle beta.
///
/// z runs to the right, -theta upward, so beta is counter-clockwise; torque T > 0 opens a crack at
/// +45°.
/// @return  empty if no crack has an angle beta
[[nodiscard]] std::string wall_drawing(const GearSet& gear);

}  // namespace strainwave
