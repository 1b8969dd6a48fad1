// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/section_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

double cross(const SectionPoint& a, const SectionPoint& b, const SectionPoint& c) {
  return (b.r - a.r) * (c.z - b.z) - (b.z - a.z) * (c.r - b.r);
}

double distance(const SectionPoint& a, const SectionPoint& b) {
  return std::hypot(a.r - b.r, a.z - b.z);
}

using Edge = std::pair<std::size_t, std::size_t>;
Edge edge(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

std::map<Edge, int> edges_of(const SectionMesh& mesh) {
  std::map<Edge, int> count;
  for (const auto& cell : mesh.cells)
    for (std::size_t k = 0; k < 4; ++k) ++count[edge(cell[k], cell[(k + 1) % 4])];
  return count;
}

/// Tolerance of comparisons of lengths, as a share of the section's extent.
constexpr double kSame = 1e-10;

}  // namespace

MeshQuality mesh_quality(const SectionMesh& mesh) {
  MeshQuality result{.worst_corner_sine = 1.0, .worst_cell = 0};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& cell = mesh.cells[c];
    for (const std::size_t p : cell)
      if (p >= mesh.points.size())
        throw InputError(fmt::format("cells[{}]", c), fmt::format("point {} does not exist", p));
    for (std::size_t k = 0; k < 4; ++k) {
      const SectionPoint& a = mesh.points[cell[k]];
      const SectionPoint& b = mesh.points[cell[(k + 1) % 4]];
      const SectionPoint& d = mesh.points[cell[(k + 2) % 4]];
      const double product = distance(a, b) * distance(b, d);
      const double sine = product > 0 ? cross(a, b, d) / product : 0.0;
      if (sine < result.worst_corner_sine) result = {sine, c};
    }
  }
  return result;
}

void check_mesh(const SectionMesh& mesh) {
  if (mesh.cells.empty()) throw InputError("mesh", "has no cells");
  if (mesh.part.size() != mesh.cells.size())
    throw InputError("mesh.part", "must have one entry for each cell");
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    const SectionPoint& point = mesh.points[p];
    require(point.r >= 0 && std::isfinite(point.z), fmt::format("points[{}].r", p), point.r, "m",
            ">= 0, and z finite");
  }
  const MeshQuality quality = mesh_quality(mesh);
  if (!(quality.worst_corner_sine > 0))
    throw InputError(fmt::format("cells[{}]", quality.worst_cell),
                     fmt::format("is inside out, flat or clockwise: the sine of its worst corner "
                                 "is {:.3g}, but must be > 0",
                                 quality.worst_corner_sine));
  const auto edges = edges_of(mesh);
  for (const auto& [ends, count] : edges)
    if (count > 2)
      throw InputError("mesh", fmt::format("the edge of points {} and {} belongs to {} cells",
                                           ends.first, ends.second, count));
  for (const RoleEdge& role : mesh.roles) {
    const auto found = edges.find(edge(role.first, role.second));
    if (found == edges.end() || found->second != 1)
      throw InputError("mesh.roles", fmt::format("points {} and {} are not an edge of the boundary",
                                                 role.first, role.second));
  }
  for (const ArcEdge& arc : mesh.arcs) {
    if (!edges.contains(edge(arc.first, arc.second)))
      throw InputError("mesh.arcs", fmt::format("points {} and {} are not an edge of a cell",
                                                arc.first, arc.second));
    const double one = distance(mesh.points[arc.first], arc.centre);
    const double other = distance(mesh.points[arc.second], arc.centre);
    if (!(std::abs(one - other) <= 1e-9 * one))
      throw InputError("mesh.arcs", fmt::format("points {} and {} are not equally far from the "
                                                "centre",
                                                arc.first, arc.second));
  }
}

std::vector<double> grid_lines(const LineSpacing& spacing) {
  require(spacing.coarse > 0, "spacing.coarse", spacing.coarse, "m", "> 0");
  for (const LineFocus& focus : spacing.focus)
    require(focus.fine > 0, "spacing.focus.fine", focus.fine, "m", "> 0");
  require(spacing.growth > 0, "spacing.growth", spacing.growth, "1", "> 0");
  std::vector<double> breaks = spacing.breaks;
  std::ranges::sort(breaks);
  const double extent = breaks.empty() ? 0.0 : breaks.back() - breaks.front();
  const auto same = [&](double a, double b) { return std::abs(a - b) <= kSame * extent; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
  const auto size = [&](double x) {
    double smallest = spacing.coarse;
    for (const LineFocus& focus : spacing.focus)
      smallest = std::min(smallest, focus.fine + spacing.growth * std::abs(x - focus.at));
    return smallest;
  };
  std::vector<double> lines;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    lines.push_back(breaks[k]);
    // The number of cells is int dx/size; lines lie at equal shares of this integral.
    constexpr int kSteps = 2000;
    const double step = (breaks[k + 1] - breaks[k]) / kSteps;
    std::vector<double> sum(kSteps + 1, 0.0);
    for (int n = 0; n < kSteps; ++n)
      sum[static_cast<std::size_t>(n) + 1] =
          sum[static_cast<std::size_t>(n)] + step / size(breaks[k] + (n + 0.5) * step);
    const bool whole = std::ranges::any_of(spacing.whole, [&](const std::array<double, 2>& w) {
      return breaks[k] >= w[0] - kSame * extent && breaks[k + 1] <= w[1] + kSame * extent;
    });
    const int count = whole ? 1 : std::max(1, static_cast<int>(std::ceil(sum.back() - 0.25)));
    std::size_t at = 0;
    for (int c = 1; c < count; ++c) {
      const double share = sum.back() * c / count;
      while (sum[at + 1] < share) ++at;
      const double within = (share - sum[at]) / (sum[at + 1] - sum[at]);
      lines.push_back(breaks[k] + (static_cast<double>(at) + within) * step);
    }
  }
  if (!breaks.empty()) lines.push_back(breaks.back());
  return lines;
}

namespace {

/// Lines of the grid and the filled cells between them.
class Grid {
 public:
  Grid(const SectionShape& shape, const SectionSpacing& spacing) : shape_(shape) {
    require(spacing.coarse_r > 0, "spacing.coarse_r", spacing.coarse_r, "m", "> 0");
    require(spacing.coarse_z > 0, "spacing.coarse_z", spacing.coarse_z, "m", "> 0");
    if (shape.rectangles.empty()) throw InputError("rectangles", "must have at least one element");
    LineSpacing r{.breaks = {}, .focus = {}, .coarse = spacing.coarse_r, .growth = spacing.growth};
    LineSpacing z = r;
    z.coarse = spacing.coarse_z;
    for (const SectionRectangle& box : shape.rectangles) {
      require(box.r_from >= 0, "rectangles.r_from", box.r_from, "m", ">= 0");
      require(box.r_to > box.r_from, "rectangles.r_to", box.r_to, "m", "> r_from");
      require(box.z_to > box.z_from, "rectangles.z_to", box.z_to, "m", "> z_from");
      r.breaks.insert(r.breaks.end(), {box.r_from, box.r_to});
      z.breaks.insert(z.breaks.end(), {box.z_from, box.z_to});
    }
    extent_ = std::max(std::ranges::max(r.breaks),
                       std::ranges::max(z.breaks) - std::ranges::min(z.breaks));
    for (const SectionFillet& fillet : shape.fillets) {
      require(fillet.radius > 0, "fillets.radius", fillet.radius, "m", "> 0");
      // Leave room towards the void for the lines that bend onto the arc.
      const double room = kFilletRoom * fillet.radius;
      r.breaks.push_back(fillet.corner.r + fillet.void_r * room);
      z.breaks.push_back(fillet.corner.z + fillet.void_z * room);
      const auto keep = [&](double at, double side) {
        return std::array<double, 2>{std::min(at, at + side * room),
                                     std::max(at, at + side * room)};
      };
      r.whole.push_back(keep(fillet.corner.r, fillet.void_r));
      z.whole.push_back(keep(fillet.corner.z, fillet.void_z));
      r.focus.push_back({fillet.corner.r, room});
      z.focus.push_back({fillet.corner.z, room});
    }
    for (const SectionSide& side : shape.sides) {
      auto& along = side.at_z ? r.breaks : z.breaks;
      along.insert(along.end(), {side.from, side.to});
      (side.at_z ? z.breaks : r.breaks).push_back(side.level);
    }
    if (shape.crack) {
      const SectionCrack& crack = *shape.crack;
      const SectionRectangle* const home = rectangle_of(crack);
      if (home == nullptr)
        throw InputError("crack",
                         "does not lie inside one rectangle of the section, with its "
                         "mouth on that rectangle's surface");
      const double depth = std::abs(crack.tip - crack.mouth);
      const double ligament = home->r_to - home->r_from - depth;
      const double ends = std::min(crack.z - home->z_from, home->z_to - crack.z);
      tip_cell_ = 0.5 * std::min({depth, ligament, ends});
      for (const double side : {-1.0, 0.0, 1.0}) {
        r.breaks.push_back(crack.tip + side * tip_cell_);
        z.breaks.push_back(crack.z + side * tip_cell_);
      }
      r.focus.push_back({crack.tip, tip_cell_});
      z.focus.push_back({crack.z, tip_cell_});
    }
    r_ = grid_lines(r);
    z_ = grid_lines(z);
  }

  SectionMesh mesh() {
    fill();
    if (shape_.crack) {
      const SectionCrack& crack = *shape_.crack;
      mesh_.crack = CrackTip{.tip = {crack.tip, crack.z},
                             .direction = crack.tip > crack.mouth ? 1.0 : -1.0,
                             .cell = tip_cell_};
    }
    for (std::size_t j = 0; j + 1 < z_.size(); ++j)
      for (std::size_t i = 0; i + 1 < r_.size(); ++i)
        if (filled(i, j)) add_cell(i, j);
    if (mesh_.arcs.size() != 2 * shape_.fillets.size())
      throw InputError("fillets", "must each lie in a re-entrant corner of the rectangles");
    find_corners();
    add_roles();
    check_mesh(mesh_);
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] bool same(double a, double b) const { return std::abs(a - b) <= kSame * extent_; }

  [[nodiscard]] const SectionRectangle* rectangle_of(const SectionCrack& crack) const {
    for (const SectionRectangle& box : shape_.rectangles) {
      const bool mouth = same(crack.mouth, box.r_from) || same(crack.mouth, box.r_to);
      if (mouth && crack.tip > box.r_from && crack.tip < box.r_to && crack.z > box.z_from &&
          crack.z < box.z_to)
        return &box;
    }
    return nullptr;
  }

  void fill() {
    part_.assign((r_.size() - 1) * (z_.size() - 1), kVoid);
    for (const SectionRectangle& box : shape_.rectangles)
      for (std::size_t j = 0; j + 1 < z_.size(); ++j)
        for (std::size_t i = 0; i + 1 < r_.size(); ++i) {
          const double r = (r_[i] + r_[i + 1]) / 2;
          const double z = (z_[j] + z_[j + 1]) / 2;
          if (r < box.r_from || r > box.r_to || z < box.z_from || z > box.z_to) continue;
          std::size_t& part = part_[j * (r_.size() - 1) + i];
          if (part != kVoid) throw InputError("rectangles", "overlap");
          part = box.part;
        }
  }

  [[nodiscard]] bool filled(std::size_t i, std::size_t j) const {
    return i < r_.size() - 1 && j < z_.size() - 1 && part_[j * (r_.size() - 1) + i] != kVoid;
  }

  /// Node (i, j) as seen from a cell with this centre.
  std::size_t node(std::size_t i, std::size_t j, const SectionPoint& centre) {
    SectionPoint point{r_[i], z_[j]};
    for (const SectionFillet& fillet : shape_.fillets) {
      const bool on_r = same(r_[i], fillet.corner.r);
      const bool on_z = same(z_[j], fillet.corner.z);
      if (!on_r && !on_z) continue;
      // The line through the corner along r bends to the end of the arc on the side of the
      // material, and so does the line along z.  The corner itself becomes two points, one for each
      // leg.
      const double r_seen = on_r ? centre.r : r_[i];
      const double z_seen = on_z ? centre.z : z_[j];
      const bool behind_r = (fillet.corner.r - r_seen) * fillet.void_r > 0;
      const bool behind_z = (fillet.corner.z - z_seen) * fillet.void_z > 0;
      if (on_z && behind_r && !(on_r && behind_z)) point.z += fillet.void_z * fillet.radius;
      if (on_r && behind_z && !(on_z && behind_r)) point.r += fillet.void_r * fillet.radius;
    }
    return index_of(point, centre);
  }

  /// Merges points by place, and on the crack's faces by place and side.
  std::size_t index_of(const SectionPoint& point, const SectionPoint& centre) {
    int side = 0;
    if (shape_.crack && same(point.z, shape_.crack->z)) {
      const CrackTip& crack = *mesh_.crack;
      if ((crack.tip.r - point.r) * crack.direction > kSame * extent_)
        side = centre.z < crack.tip.z ? -1 : 1;
    }
    const double unit = kSame * extent_ * 10;
    const auto key = std::tuple(std::llround(point.r / unit), std::llround(point.z / unit), side);
    const auto [at, added] = index_.try_emplace(key, mesh_.points.size());
    if (added) mesh_.points.push_back(point);
    return at->second;
  }

  void add_cell(std::size_t i, std::size_t j) {
    const std::size_t part = part_[j * (r_.size() - 1) + i];
    for (const SectionFillet& fillet : shape_.fillets) {
      const std::size_t ci = fillet.void_r > 0 ? i + 1 : i;
      const std::size_t cj = fillet.void_z > 0 ? j + 1 : j;
      if (same(r_[ci], fillet.corner.r) && same(z_[cj], fillet.corner.z)) {
        const std::size_t beside = fillet.void_r > 0 ? i + 1 : i - 1;  // wraps to "not filled"
        const std::size_t above = fillet.void_z > 0 ? j + 1 : j - 1;
        if (!filled(beside, j) || !filled(i, above) || filled(beside, above)) break;
        add_fillet(fillet, i, j, part);
        return;
      }
    }
    const SectionPoint centre{(r_[i] + r_[i + 1]) / 2, (z_[j] + z_[j + 1]) / 2};
    push({node(i, j, centre), node(i + 1, j, centre), node(i + 1, j + 1, centre),
          node(i, j + 1, centre)},
         part);
  }

  void push(const std::array<std::size_t, 4>& cell, std::size_t part) {
    mesh_.cells.push_back(cell);
    mesh_.part.push_back(part);
  }

  /// Splits the cell behind a corner into two cells that meet in the middle of the arc.
  void add_fillet(const SectionFillet& fillet, std::size_t i, std::size_t j, std::size_t part) {
    const double rho = fillet.radius;
    const SectionPoint& c = fillet.corner;
    const SectionPoint cell{(r_[i] + r_[i + 1]) / 2, (z_[j] + z_[j + 1]) / 2};
    const SectionPoint centre{c.r + fillet.void_r * rho, c.z + fillet.void_z * rho};
    const double middle = rho * (1 - std::numbers::sqrt2 / 2);
    const std::size_t leg_z = index_of({c.r, centre.z}, cell);
    const std::size_t leg_r = index_of({centre.r, c.z}, cell);
    const std::size_t top =
        index_of({c.r + fillet.void_r * middle, c.z + fillet.void_z * middle}, cell);
    const std::size_t near_i = fillet.void_r > 0 ? i + 1 : i;
    const std::size_t near_j = fillet.void_z > 0 ? j + 1 : j;
    const std::size_t far_i = fillet.void_r > 0 ? i : i + 1;
    const std::size_t far_j = fillet.void_z > 0 ? j : j + 1;
    const std::size_t behind = node(far_i, far_j, cell);
    const std::size_t behind_r = node(near_i, far_j, cell);
    const std::size_t behind_z = node(far_i, near_j, cell);
    // Counter-clockwise for a void at larger r and larger z; a mirrored void reverses the order.
    if (fillet.void_r * fillet.void_z > 0) {
      push({behind, top, leg_z, behind_z}, part);
      push({behind, behind_r, leg_r, top}, part);
    } else {
      push({behind, behind_z, leg_z, top}, part);
      push({behind, top, leg_r, behind_r}, part);
    }
    mesh_.arcs.push_back({leg_z, top, centre});
    mesh_.arcs.push_back({top, leg_r, centre});
  }

  void find_corners() {
    for (std::size_t j = 1; j + 1 < z_.size(); ++j)
      for (std::size_t i = 1; i + 1 < r_.size(); ++i) {
        const int around =
            filled(i, j) + filled(i - 1, j) + filled(i, j - 1) + filled(i - 1, j - 1);
        const bool rounded = std::ranges::any_of(shape_.fillets, [&](const SectionFillet& f) {
          return same(f.corner.r, r_[i]) && same(f.corner.z, z_[j]);
        });
        if (around == 3 && !rounded) mesh_.corners.push_back({r_[i], z_[j]});
      }
  }

  void add_roles() {
    for (const auto& [ends, count] : edges_of(mesh_)) {
      if (count != 1) continue;
      const SectionPoint& a = mesh_.points[ends.first];
      const SectionPoint& b = mesh_.points[ends.second];
      for (const SectionSide& side : shape_.sides) {
        const auto [level_a, level_b, along_a, along_b] =
            side.at_z ? std::tuple(a.z, b.z, a.r, b.r) : std::tuple(a.r, b.r, a.z, b.z);
        const double middle = (along_a + along_b) / 2;
        if (same(level_a, side.level) && same(level_b, side.level) && middle > side.from &&
            middle < side.to)
          mesh_.roles.push_back({ends.first, ends.second, side.role});
      }
    }
  }

  /// clear distance from other lines, over the radius [-]
  static constexpr double kFilletRoom = 2.5;
  static constexpr std::size_t kVoid = std::numeric_limits<std::size_t>::max();

  const SectionShape& shape_;
  double extent_ = 0.0;
  double tip_cell_ = 0.0;
  std::vector<double> r_;
  std::vector<double> z_;
  std::vector<std::size_t> part_;
  std::map<std::tuple<long long, long long, int>, std::size_t> index_;
  SectionMesh mesh_;
};

}  // namespace

SectionMesh mesh_section(const SectionShape& shape, const SectionSpacing& spacing) {
  return Grid(shape, spacing).mesh();
}

SectionMesh with_longer_crack(SectionMesh mesh, double growth) {
  if (!mesh.crack) throw InputError("mesh.crack", "must be given to be lengthened");
  CrackTip& crack = *mesh.crack;
  require(std::abs(growth) <= 0.4 * crack.cell, "growth", growth, "m",
          fmt::format("at most 0.4 of a tip cell, {:.3g} m", crack.cell));
  const auto hat = [&](double x) { return std::clamp(2 - std::abs(x) / crack.cell, 0.0, 1.0); };
  for (SectionPoint& point : mesh.points)
    point.r += crack.direction * growth * hat(point.r - crack.tip.r) * hat(point.z - crack.tip.z);
  crack.tip.r += crack.direction * growth;
  return mesh;
}

}  // namespace strainwave::fem
