// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/hex_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

/// Vertices by place.  The search grid is a thousand times coarser than the merging distance, so a
/// point and its twin are in the same box or in neighbouring boxes.
class VertexTable {
 public:
  VertexTable(double same, std::vector<Point3>& points) : same_(same), points_(points) {}

  std::size_t find_or_add(const Point3& p, int side) {
    const auto box = [&](int i) { return static_cast<std::int64_t>(std::floor(p[i] / size())); };
    const std::array<std::int64_t, 3> home{box(0), box(1), box(2)};
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j)
        for (std::int64_t k = -1; k <= 1; ++k) {
          const auto [first, last] =
              table_.equal_range({home[0] + i, home[1] + j, home[2] + k, side});
          for (auto it = first; it != last; ++it)
            if (distance(points_[it->second], p) < same_) return it->second;
        }
    points_.push_back(p);
    table_.emplace(Key{home[0], home[1], home[2], side}, points_.size() - 1);
    return points_.size() - 1;
  }

 private:
  using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t, int>;

  [[nodiscard]] double size() const { return 1000 * same_; }
  static double distance(const Point3& a, const Point3& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  double same_;
  std::vector<Point3>& points_;
  std::multimap<Key, std::size_t> table_;
};

/// The direction `advance` of the template as a unit vector of the body.
PointMap carried_over(const PointMap& cell, const PointMap& advance, const PointMap& body,
                      double step) {
  return [cell, advance, body, step](const Point3& unit) {
    const Point3 x = cell(unit);
    const Point3 d = advance(unit);
    const double scale = step / std::hypot(d[0], d[1], d[2]);
    const Point3 ahead = body({x[0] + scale * d[0], x[1] + scale * d[1], x[2] + scale * d[2]});
    const Point3 behind = body({x[0] - scale * d[0], x[1] - scale * d[1], x[2] - scale * d[2]});
    Point3 q{ahead[0] - behind[0], ahead[1] - behind[1], ahead[2] - behind[2]};
    const double norm = std::hypot(q[0], q[1], q[2]);
    for (double& component : q) component /= norm;
    return q;
  };
}

}  // namespace

HexMesh make_hex_mesh(const std::vector<TemplateCell>& cells, const TemplateBody& body) {
  if (cells.empty()) throw InputError("mesh", "has no cells");
  HexMesh mesh;
  VertexTable table(1e-9 * body.length, mesh.vertices);
  for (const TemplateCell& source : cells) {
    HexCell cell;
    cell.side = source.side;
    for (std::size_t i = 0; i < 8; ++i) {
      const Point3 x = source.map({static_cast<double>(i & 1U), static_cast<double>(i >> 1U & 1U),
                                   static_cast<double>(i >> 2U & 1U)});
      cell.vertices[i] =
          table.find_or_add(body.map(x), body.on_crack && body.on_crack(x) ? source.side : 0);
    }
    for (std::size_t f = 0; f < 6; ++f) {
      Point3 centre{0.5, 0.5, 0.5};
      centre[f / 2] = static_cast<double>(f % 2);
      cell.face_tag[f] = body.face_tag ? body.face_tag(source.map(centre)) : 0;
    }
    cell.map = [cell_map = source.map, body_map = body.map](const Point3& unit) {
      return body_map(cell_map(unit));
    };
    if (source.front) {
      cell.front = source.front;
      cell.front->advance =
          carried_over(source.map, source.front->advance, body.map, 1e-5 * body.length);
      mesh.fronts = std::max(mesh.fronts, source.front->front + 1);
    }
    mesh.cells.push_back(std::move(cell));
  }
  return mesh;
}

HexMesh with_boundary_tags(HexMesh mesh, int tag) {
  const auto corners = [](const HexCell& cell, std::size_t face) {
    std::array<std::size_t, 4> key{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < 8; ++i)
      if ((i >> (face / 2) & 1U) == face % 2) key[n++] = cell.vertices[i];
    std::sort(key.begin(), key.end());
    return key;
  };
  std::map<std::array<std::size_t, 4>, int> count;
  for (const HexCell& cell : mesh.cells)
    for (std::size_t f = 0; f < 6; ++f) ++count[corners(cell, f)];
  for (HexCell& cell : mesh.cells)
    for (std::size_t f = 0; f < 6; ++f) {
      if (count[corners(cell, f)] > 1)
        cell.face_tag[f] = 0;
      else if (cell.face_tag[f] == 0)
        cell.face_tag[f] = tag;
    }
  return mesh;
}

}  // namespace strainwave::fem
