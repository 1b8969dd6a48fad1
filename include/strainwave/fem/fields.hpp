// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "strainwave/fem/hex_mesh.hpp"

/// @file
/// A solution sampled on a grid of points in each cell: for pictures and for files of other
/// programs.  Fields jump from cell to cell by what the discretisation leaves, as they are.

namespace strainwave::fem {

/// Which points a solution is sampled at.
struct FieldRequest {
  int divisions = 0;  ///< n of each direction of a cell [-]; 1 to 8; 0: no fields
  /// On several ranks each has all cells, and not only its own: for pictures.
  bool every_cell = false;
};

/// The solution at one point, Cartesian.  Of a body of revolution in the half plane y = 0:
/// x is the radius, y the direction round the axis, z the axis.
struct FieldPoint {
  Point3 place{};                         ///< of the undeformed body [m]
  Point3 displacement{};                  ///< [m]
  std::array<double, 6> stress{};         ///< xx, yy, zz, yz, xz, xy [Pa]
  double energy_density{};                ///< w = sigma:epsilon/2 [J/m^3], (FE-38)
  double energy_density_without_crack{};  ///< [J/m^3]; 0 unless SampledFields::without_crack
};

/// Points of a cell, i/n of each unit coordinate, the first coordinate fastest: (n+1)^3 of a solid,
/// (n+1)^2 of a section.
struct FieldCell {
  std::vector<FieldPoint> points;
  /// Of a solid: tags of the faces u=0, u=1, v=0, v=1, w=0, w=1 as in HexCell.
  std::array<int, 6> face_tag{};
  std::size_t cell{};  ///< of a solid: index into HexMesh::cells
};

/// Both faces of a crack at one place.
struct CrackFacePoint {
  Point3 place{};  ///< of the undeformed body [m]
  Point3 upper{};  ///< displacement of the face whose cells have side = +1 [m]
  Point3 lower{};  ///< of the other one [m]
  double
      opening{};  ///< (upper - lower) . normal from lower to upper [m]; < 0: they overlap (FE-39)
};

/// (n+1)^2 points of a crack's face in one cell, the first coordinate fastest.
struct CrackFacePatch {
  std::vector<CrackFacePoint> points;
};

struct SampledFields {
  int dimension = 3;           ///< of the cells: 2 of a section, 3 of a solid
  int divisions = 0;           ///< n; 0: nothing was asked for
  bool without_crack = false;  ///< energy_density_without_crack is known
  std::vector<FieldCell> cells;
  std::vector<CrackFacePatch> crack_faces;  ///< of solids
};

}  // namespace strainwave::fem
