// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/swept_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {
namespace {

using std::numbers::pi;

/// Offset of an arc from its chord, as a function of the share of the chord from the first point.
std::function<SectionPoint(double)> bulge(const SectionPoint& from, const SectionPoint& to,
                                          const SectionPoint& centre) {
  const double radius = std::hypot(from.r - centre.r, from.z - centre.z);
  const double start = std::atan2(from.z - centre.z, from.r - centre.r);
  const double end = std::atan2(to.z - centre.z, to.r - centre.r);
  const double turn = std::remainder(end - start, 2 * pi);
  return [=](double t) {
    const double angle = start + t * turn;
    return SectionPoint{centre.r + radius * std::cos(angle) - std::lerp(from.r, to.r, t),
                        centre.z + radius * std::sin(angle) - std::lerp(from.z, to.z, t)};
  };
}

/// A cell of the section: unit square -> (r, z); edges 01, 12, 23, 30 straight or arcs.
class Quadrilateral {
 public:
  Quadrilateral(const SectionMesh& mesh, const std::array<std::size_t, 4>& cell) {
    for (std::size_t k = 0; k < 4; ++k) corner_[k] = mesh.points[cell[k]];
    for (const ArcEdge& arc : mesh.arcs)
      for (std::size_t k = 0; k < 4; ++k) {
        const std::pair ends{cell[k], cell[(k + 1) % 4]};
        if (ends == std::pair(arc.first, arc.second) || ends == std::pair(arc.second, arc.first))
          bulge_[k] = bulge(corner_[k], corner_[(k + 1) % 4], arc.centre);
      }
  }

  [[nodiscard]] SectionPoint at(double a, double b) const {
    const std::array<double, 4> shape{(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b};
    SectionPoint point;
    for (std::size_t k = 0; k < 4; ++k) add(point, shape[k], corner_[k]);
    // `along` runs along edge k from its first point; `near` is 1 on the edge and 0 on the opposite
    // edge.
    const std::array<double, 4> along{a, b, 1 - a, 1 - b};
    const std::array<double, 4> near{1 - b, a, b, 1 - a};
    for (std::size_t k = 0; k < 4; ++k)
      if (bulge_[k]) add(point, near[k], bulge_[k](along[k]));
    return point;
  }

 private:
  static void add(SectionPoint& sum, double factor, const SectionPoint& term) {
    sum.r += factor * term.r;
    sum.z += factor * term.z;
  }

  std::array<SectionPoint, 4> corner_;
  std::array<std::function<SectionPoint(double)>, 4> bulge_;
};

}  // namespace

std::vector<TemplateCell> swept_section(const SectionMesh& section,
                                        const std::vector<double>& around) {
  check_mesh(section);
  if (section.crack) throw InputError("section.crack", "must be left out of a swept section");
  for (std::size_t p = 0; p < section.points.size(); ++p)
    require(section.points[p].r > 0, fmt::format("points[{}].r", p), section.points[p].r, "m",
            "> 0 in a swept section");
  if (around.size() < 2) throw InputError("around", "must have at least two angles");
  for (std::size_t k = 0; k + 1 < around.size(); ++k)
    require(around[k + 1] > around[k] && around[k + 1] <= around[k] + pi / 2 * (1 + 1e-9),
            fmt::format("around[{}]", k + 1), around[k + 1], "rad",
            "more than the one before, by at most a quarter turn");
  std::vector<TemplateCell> cells;
  for (const auto& corners : section.cells) {
    const Quadrilateral quad(section, corners);
    for (std::size_t k = 0; k + 1 < around.size(); ++k) {
      TemplateCell cell;
      // Swapping (r, z) to (z, r) reverses the orientation, which makes the cell right-handed with
      // theta first.
      cell.map = [quad, from = around[k], to = around[k + 1]](const Point3& unit) {
        const SectionPoint place = quad.at(unit[2], unit[1]);
        return Point3{std::lerp(from, to, unit[0]), place.z, place.r};
      };
      cell.side = 1;
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

Point3 revolved(const Point3& theta_z_r) {
  const auto [theta, z, r] = theta_z_r;
  return {r * std::cos(theta), r * std::sin(theta), z};
}

std::optional<EdgeRole> role_at(const SectionMesh& section, const SectionPoint& middle) {
  for (const RoleEdge& role : section.roles) {
    const SectionPoint& a = section.points[role.first];
    const SectionPoint& b = section.points[role.second];
    const double off = std::hypot((a.r + b.r) / 2 - middle.r, (a.z + b.z) / 2 - middle.z);
    if (off < 1e-6 * std::hypot(a.r - b.r, a.z - b.z)) return role.role;
  }
  return std::nullopt;
}

}  // namespace strainwave::fem
