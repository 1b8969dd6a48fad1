// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace strainwave::fem {

/// A point or a vector in space, in Cartesian components.
using Point3 = std::array<double, 3>;
/// A map of points, such as from the unit cube into space or from a template into a body.
using PointMap = std::function<Point3(const Point3&)>;

/// Where a cell lies in the rings of cells about a crack front.
///
/// The cell's third unit coordinate runs along the front.  In a ring, the first coordinate points
/// away from the front.  The second coordinate turns from the direction of growth through the
/// normal of the crack (right-handed about the third); the four cells at the front have ring = -1.
struct FrontPlace {
  std::size_t front{};    ///< index of the front
  std::size_t segment{};  ///< counted along the front from its start
  int ring{};             ///< -1: at the front; 0: innermost ring; ...
  /// +1: turned by 0 to 180 degrees from the direction of growth; -1: by 180 to 360
  int side{};
  PointMap advance;  ///< unit cube -> unit vector of growth, tangent to crack and free faces
  /// The map grows with the square of the distance from the front, where its determinant is 0.  The
  /// root of the distance, which the displacements contain, is then a polynomial in the cell
  /// (FE-46).
  bool square_root = false;
};

/// A hexahedron with an analytic map of the unit cube [0,1]^3; corner i has the unit coordinates
/// (bit 0, bit 1, bit 2 of i).
struct HexCell {
  std::array<std::size_t, 8> vertices{};  ///< indices into HexMesh::vertices
  PointMap map;                           ///< unit cube -> space [m]
  std::array<int, 6> face_tag{};          ///< faces u=0, u=1, v=0, v=1, w=0, w=1; 0: no tag
  /// side of the crack surface on which the cell lies, +1 or -1
  int side = 0;
  std::optional<FrontPlace> front;  ///< only for cells of a ring template
};

struct HexMesh {
  std::vector<Point3> vertices;  ///< [m]
  std::vector<HexCell> cells;
  std::size_t fronts = 0;  ///< number of crack fronts
};

/// A cell of a template, in the template's own coordinates.
struct TemplateCell {
  PointMap map;                     ///< unit cube -> template
  int side = 0;                     ///< side of the crack surface: +1, -1
  std::optional<FrontPlace> front;  ///< its `advance` is a direction in the template
};

/// Rules that turn a template into a mesh of the body.
struct TemplateBody {
  PointMap map;  ///< template -> space [m], smooth
  /// True on the crack except on its front; vertices there exist once per side.
  std::function<bool(const Point3&)> on_crack;
  /// Tag of the face with this centre (template coordinates), 0 for none.
  std::function<int(const Point3&)> face_tag;
  double length{};  ///< a length of the body [m]; points closer than 1e-9 of this length are merged
};

/// Makes the mesh of a body.  Vertices at the same place are merged, except those on the two sides
/// of a crack.
///
/// @throws InputError  if there are no cells
[[nodiscard]] HexMesh make_hex_mesh(const std::vector<TemplateCell>& cells,
                                    const TemplateBody& body);

/// Sets this tag on the faces of the boundary that have no tag, and removes tags from faces between
/// two cells.
[[nodiscard]] HexMesh with_boundary_tags(HexMesh mesh, int tag);

}  // namespace strainwave::fem
