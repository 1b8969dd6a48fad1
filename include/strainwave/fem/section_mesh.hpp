// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// @file
/// Meshes of the meridian section of a body of revolution, as plain data, and a way to make them.
/// The section lies in the half plane r >= 0, z along the axis.

namespace strainwave::fem {

/// A point of the meridian half plane [m].
struct SectionPoint {
  double r = 0.0;  ///< distance from the axis [m]; >= 0
  double z = 0.0;  ///< along the axis [m]
};

/// Role of an edge of the section in the load case.
enum class EdgeRole {
  held,    ///< no rotation (torsion), no axial displacement (tension)
  loaded,  ///< carries the torque or the force, distributed as in a section of a long shaft
};

/// An edge of a cell on the boundary, by its two points.
struct RoleEdge {
  std::size_t first = 0;
  std::size_t second = 0;
  EdgeRole role = EdgeRole::held;
};

/// An edge of a cell that is a circular arc, by its two points.
struct ArcEdge {
  std::size_t first = 0;
  std::size_t second = 0;
  SectionPoint centre = {};
};

/// Tip of an annular crack in the plane z = tip.z.
struct CrackTip {
  SectionPoint tip = {};
  /// direction of growth: +1 outward from the bore; -1 inward from outside
  double direction = 0.0;
  double cell = 0.0;  ///< h: the four cells round the tip are squares of this side [m]; > 0
};

/// Quadrilaterals of a meridian section.
///
/// Points on the faces of a crack exist twice.
struct SectionMesh {
  std::vector<SectionPoint> points;
  std::vector<std::array<std::size_t, 4>> cells;  ///< counter-clockwise, r to the right, z up
  std::vector<std::size_t> part;                  ///< part of each cell: 0, 1, ...
  std::vector<RoleEdge> roles;
  std::vector<ArcEdge> arcs;
  std::optional<CrackTip> crack;
  /// Re-entrant corners.  Cells that touch a corner are halved towards it like cells at a crack
  /// tip.
  std::vector<SectionPoint> corners;
};

/// Quality of a straight-sided mesh.
struct MeshQuality {
  /// Smallest sine of a corner, negative for an inverted cell [-]; in [-1, 1]
  double worst_corner_sine = 0.0;
  std::size_t worst_cell = 0;
};
/// @throws InputError  if a cell refers to a point that does not exist
[[nodiscard]] MeshQuality mesh_quality(const SectionMesh& mesh);

/// Throws InputError for an invalid mesh: without cells, with an inverted or flat cell, with a
/// point at r < 0, or with a role or arc on an edge that no cell has.
void check_mesh(const SectionMesh& mesh);

/// A rectangle of material.
struct SectionRectangle {
  double r_from = 0.0;  ///< [m]; >= 0
  double r_to = 0.0;    ///< [m]
  double z_from = 0.0;  ///< [m]
  double z_to = 0.0;    ///< [m]
  std::size_t part = 0;
};

/// A rounding of a re-entrant corner of a union of rectangles.
struct SectionFillet {
  SectionPoint corner = {};
  double void_r = 0.0;  ///< +1: the void is at larger r than the corner, -1: at smaller
  double void_z = 0.0;  ///< +1: the void is at larger z than the corner, -1: at smaller
  double radius = 0.0;  ///< [m]; > 0
};

/// An annular crack normal to the axis: from `mouth` to `tip` at height z.
struct SectionCrack {
  double z = 0.0;      ///< [m]
  double mouth = 0.0;  ///< r of the free surface where the crack starts [m]
  double tip = 0.0;    ///< r [m]
};

/// A section edge lying on a straight line, with a role.
struct SectionSide {
  bool at_z = true;    ///< the line z = level; else r = level
  double level = 0.0;  ///< [m]
  double from = 0.0;   ///< range of the other coordinate: begin [m]
  double to = 0.0;     ///< range of the other coordinate: end [m]
  EdgeRole role = EdgeRole::held;
};

/// A section as a union of rectangles.
struct SectionShape {
  std::vector<SectionRectangle> rectangles;
  std::vector<SectionFillet> fillets;
  std::vector<SectionSide> sides;
  std::optional<SectionCrack> crack;
};

/// A place near which grid lines are dense.
struct LineFocus {
  double at = 0.0;    ///< [m]
  double fine = 0.0;  ///< spacing at the place [m]; > 0
};

/// Grid lines through `breaks`.  Between the breaks, the spacing grows from each focus by `growth`
/// per length, up to `coarse`.
struct LineSpacing {
  std::vector<double> breaks;  ///< required lines [m]
  std::vector<LineFocus> focus;
  double coarse = 0.0;  ///< [m]; > 0
  double growth = 1.0;  ///< [-]; > 0
  /// Intervals that are not divided: two breaks within one interval get no line between them.
  std::vector<std::array<double, 2>> whole = {};
};
/// The grid lines in ascending order.
[[nodiscard]] std::vector<double> grid_lines(const LineSpacing& spacing);

/// Fineness of a mesh.
struct SectionSpacing {
  double coarse_r = 0.0;  ///< largest cell across [m]; > 0
  double coarse_z = 0.0;  ///< largest cell along the axis [m]; > 0
  double growth = 1.0;    ///< growth of the cells away from crack and fillets, per length [-]; > 0
};

/// Meshes a section on grid lines.  Points along the faces of a crack are duplicated.  A fillet
/// splits the cell in its corner into two and bends the adjacent lines.
/// @throws InputError  for overlapping or empty rectangles; for a crack that does not lie in one
///                     rectangle; for a fillet that is not at a corner of the union or too large
///                     for it
[[nodiscard]] SectionMesh mesh_section(const SectionShape& shape, const SectionSpacing& spacing);

/// The same mesh with its crack longer by `growth` [m].  Only points within two tip cells move, so
/// that the difference of two solutions results from the crack alone.
/// @throws InputError  if the section has no crack, or |growth| is more than 0.4 of a tip cell
[[nodiscard]] SectionMesh with_longer_crack(SectionMesh mesh, double growth);

}  // namespace strainwave::fem
