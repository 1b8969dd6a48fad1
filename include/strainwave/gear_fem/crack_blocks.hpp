// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/fem/solid.hpp"

namespace strainwave::gear_fem {

/// Remote stress of a cracked block, applied to the two faces parallel to the plane of the crack.
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
  double half_height{};   ///< half height of the block [m]; > 0
  double thickness{};     ///< [m]; > 0
  double stress = 1;      ///< stress on the faces y = +-half_height [Pa]
  bool centre = true;     ///< false: the crack starts at the edge x = 0
  BlockLoad load = BlockLoad::tension;
  fem::CrackFaces crack_faces = fem::CrackFaces::free;
  int order = 3;  ///< order of the displacements [-]; 2 to 4
  int rings = 6;  ///< rings about each tip [-]; 3 to 12
};

/// Displacements and fracture quantities of the block.  Front 0 is the tip at +a; a centre crack
/// also has front 1 at -a.  Accuracy of K_I at order 3: 0.1 % (centre and edge crack, a/W = 0.5),
/// and 0.3 % for a centre crack that bending closes by a third.
///
/// @throws InputError  if a value is out of range
[[nodiscard]] fem::SolidResult straight_crack_block(const StraightCrackBlock& block);

/// A flat semi-elliptical crack in a block, in the plane y = 0 and with its mouth on z = 0.
///
/// The front is (c cos phi, a sin phi) in (x, z), from phi = 0 to pi; position = phi/pi.
struct EllipticalCrackBlock {
  fem::Elasticity material;
  double depth{};         ///< a, along z [m]; > 0
  double half_length{};   ///< c, along x [m]; 0.2 <= a/c <= 5
  double thickness{};     ///< size of the block along z [m]; > a
  double half_width{};    ///< along x [m]; > c
  double half_height{};   ///< along y [m]; > 0
  double stress = 1;      ///< stress on the faces y = +-half_height [Pa]
  bool embedded = false;  ///< true: z = 0 is a plane of symmetry, so the crack is a whole ellipse
  BlockLoad load = BlockLoad::tension;
  int order = 3;     ///< order of the displacements [-]; 2 to 4
  int rings = 3;     ///< circular rings about the front [-]; 3 to 12
  int segments = 8;  ///< segments along the front [-]; a multiple of 4, 4 to 32
};

/// Displacements and fracture quantities of the block, with one front.  Accuracy of a penny crack
/// at order 2: 0.3 % in tension, 1.5 % of the largest K in shear.  Accuracy of a surface crack at
/// order 3: 0.3 % at the deepest point, 0.7 % along the front.  Where the front meets the free
/// surface, K is not defined.  The first and the last station therefore hold values of a projection
/// that must not be used as results.
///
/// @throws InputError  if a value is out of range
[[nodiscard]] fem::SolidResult elliptical_crack_block(const EllipticalCrackBlock& block);

}  // namespace strainwave::gear_fem
