// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "strainwave/fem/hex_mesh.hpp"

/// @file
/// A solution sampled on a grid of points in each cell, for pictures and for files of other
/// programs.  The fields keep the jumps between cells that the discretisation leaves.

namespace strainwave::fem {

/// Points at which a solution is sampled.
struct FieldRequest {
  int divisions = 0;  ///< n in each direction of a cell [-]; 1 to 8; 0: no fields
  /// With several ranks: every rank samples all cells, not only its own.  Pictures need this.
  bool every_cell = false;
};

/// The solution at one point in Cartesian components.  For a body of revolution, the point lies in
/// the half plane y = 0: x is the radius, y the direction round the axis, z the axis.
struct FieldPoint {
  Point3 place{};                         ///< place in the undeformed body [m]
  Point3 displacement{};                  ///< [m]
  std::array<double, 6> stress{};         ///< xx, yy, zz, yz, xz, xy [Pa]
  double energy_density{};                ///< w = sigma:epsilon/2 [J/m^3], (FE-38)
  double energy_density_without_crack{};  ///< [J/m^3]; 0 unless SampledFields::without_crack
};

/// Points of a cell at i/n of each unit coordinate; the first coordinate runs fastest.  A solid has
/// (n+1)^3 points, a section (n+1)^2.
struct FieldCell {
  std::vector<FieldPoint> points;
  /// For a solid: tags of the faces u=0, u=1, v=0, v=1, w=0, w=1 as in HexCell.
  std::array<int, 6> face_tag{};
  std::size_t cell{};  ///< for a solid: index into HexMesh::cells
};

/// Both faces of a crack at one place.
struct CrackFacePoint {
  Point3 place{};    ///< place in the undeformed body [m]
  Point3 upper{};    ///< displacement of the face whose cells have side = +1 [m]
  Point3 lower{};    ///< displacement of the other face [m]
  double opening{};  ///< opening: (upper - lower) . normal from lower to upper [m]; < 0 means
                     ///< overlap (FE-39)
};

/// Grid of (n+1)^2 points of a crack's face in one cell; the first coordinate runs fastest.
struct CrackFacePatch {
  std::vector<CrackFacePoint> points;
};

struct SampledFields {
  int dimension = 3;           ///< dimension of the cells: 2 for a section, 3 for a solid
  int divisions = 0;           ///< n; 0: no fields were requested
  bool without_crack = false;  ///< whether energy_density_without_crack is known
  std::vector<FieldCell> cells;
  std::vector<CrackFacePatch> crack_faces;  ///< faces of cracks in solids
};

}  // namespace strainwave::fem
