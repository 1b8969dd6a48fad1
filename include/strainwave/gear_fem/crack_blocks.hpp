// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/fem/solid.hpp"

namespace strainwave::gear_fem {

/// Stress far away from the crack of a block, applied to its two faces along the crack's plane.
enum class BlockLoad {
  tension,  ///< normal to the crack
  shear,    ///< along the block's width (the direction in which a straight crack grows)
  bending,  ///< normal to the crack, in proportion to x: the given stress at x = width (half_width)
};

/// A crack through the whole thickness of a block in plane strain.
///
/// Coordinates: x along the width, y normal to the crack, z through the thickness; the faces
/// z = const do not move in z.
struct StraightCrackBlock {
  fem::Elasticity material;
  double crack_length{};  ///< a of an edge crack, half length of a centre crack [m]; > 0
  double width{};         ///< W of an edge crack's block, half width of a centre crack's [m]; > a
  double half_height{};   ///< of the block [m]; > 0
  double thickness{};     ///< [m]; > 0
  double stress = 1;      ///< on the faces y = +-half_height [Pa]
  bool centre = true;     ///< false: the crack starts at the edge x = 0
  BlockLoad load = BlockLoad::tension;
  fem::CrackFaces crack_faces = fem::CrackFaces::free;
  int order = 3;  ///< of the displacements [-]; 2 to 4
  int rings = 6;  ///< about each tip [-]; 3 to 12
};

/// Displacements and fracture quantities of the block; front 0 is the tip at +a, a centre crack
/// has front 1 at -a.  Accuracy of K_I at order 3: 0.1 % (centre and edge crack, a/W = 0.5),
/// 0.3 % of a centre crack that bending closes by a third.
///
/// @throws InputError  a value out of range
[[nodiscard]] fem::SolidResult straight_crack_block(const StraightCrackBlock& block);

/// A flat semi-elliptical crack in a block, its plane y = 0, its mouth on z = 0.
///
/// The front is (c cos phi, a sin phi) in (x, z), from phi = 0 to pi; position = phi/pi.
struct EllipticalCrackBlock {
  fem::Elasticity material;
  double depth{};         ///< a, along z [m]; > 0
  double half_length{};   ///< c, along x [m]; 0.2 <= a/c <= 5
  double thickness{};     ///< of the block along z [m]; > a
  double half_width{};    ///< along x [m]; > c
  double half_height{};   ///< along y [m]; > 0
  double stress = 1;      ///< on the faces y = +-half_height [Pa]
  bool embedded = false;  ///< true: z = 0 is a plane of symmetry, the crack a whole ellipse
  BlockLoad load = BlockLoad::tension;
  int order = 3;     ///< of the displacements [-]; 2 to 4
  int rings = 3;     ///< circular ones about the front [-]; 3 to 12
  int segments = 8;  ///< along the front [-]; a multiple of 4, 4 to 32
};

/// Displacements and fracture quantities of the block; one front.  Accuracy: a penny at order 2 in
/// tension 0.3 %, in shear 1.5 % of the largest K; a surface crack at order 3 0.3 % at the deepest
/// point, 0.7 % along the front.  Where the front meets the free surface K is not defined: the
/// first and the last station are the values of a projection, and no result.
///
/// @throws InputError  a value out of range
[[nodiscard]] fem::SolidResult elliptical_crack_block(const EllipticalCrackBlock& block);

}  // namespace strainwave::gear_fem
