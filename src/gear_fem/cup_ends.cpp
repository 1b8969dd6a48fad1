// SPDX-License-Identifier: Apache-2.0
#include "cup_ends.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cup_shape.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fem/swept_section.hpp"
#include "strainwave/model/input/turning_cup.hpp"

namespace strainwave::gear_fem {
namespace {

/// Largest step of the logarithm of the radius from cell to cell of the diaphragm: the twist there
/// varies with the inverse square of the radius.
constexpr double kDiaphragmStep = 0.3;

}  // namespace

MeshedEnds mesh_cup_ends(const CupSection& cup, const std::vector<double>& radii) {
  if (cup.barrel_fillet != 0 || cup.boss_fillet != 0)
    throw InputError("fillet", "must be 0 in a cup that is meshed as a solid");
  CupShape drawn = cup_shape(cup);
  const double outer = cup.barrel.outer_diameter / 2;
  const double wall = cup.barrel.wall_thickness;
  const double inner = outer - wall;
  if (cup.rim && !rim_covers(*cup.rim, cup.barrel))
    throw InputError("rim",
                     "must have a wall that covers the barrel's, inside and outside, where "
                     "the cup is meshed as a solid");
  const double start = cup.diaphragm ? cup.diaphragm->thickness : 0.0;
  const double end = start + cup.barrel.length;
  const double collar = std::min(wall, cup.barrel.length / 4);
  MeshedEnds ends{.section = {},
                  .barrel_from = cup.diaphragm ? collar : 0.0,
                  .barrel_to = cup.barrel.length - (cup.rim ? collar : 0.0)};
  // Rectangles without the barrel, except its collars.
  std::vector<fem::SectionRectangle> boxes;
  for (const fem::SectionRectangle& box : drawn.shape.rectangles)
    if (box.part != kBarrel) boxes.push_back(box);
  // The length of cells at a corner equals the thickness of the thinner part.
  std::vector<double> columns = radii;
  columns.front() = inner;
  columns.back() = outer;
  std::vector<double> rows;
  if (cup.rim) {
    boxes.push_back({inner, outer, end - collar, end, kBarrel});
    if (cup.rim->length > 2 * wall) rows.push_back(end + wall);
  }
  if (cup.diaphragm) {
    const double h = cup.diaphragm->thickness;
    const double bore = cup.diaphragm->inner_diameter / 2;
    boxes.push_back({inner, outer, start, start + collar, kBarrel});
    const bool roomy = inner - bore > 3 * h;
    const double from = roomy && cup.boss ? bore + h : bore;
    const double to = roomy ? inner - h : inner;
    const int steps =
        std::max(2, static_cast<int>(std::ceil(std::log(to / from) / kDiaphragmStep)));
    for (int i = 0; i <= steps; ++i)
      columns.push_back(from * std::pow(to / from, static_cast<double>(i) / steps));
    if (cup.boss) {
      if (cup.boss->wall_thickness > 2 * h) columns.push_back(bore - h);
      if (cup.boss->length > 2 * h) rows.push_back(-h);
    }
    drawn.spacing.coarse_r = std::max(wall, to - from);
  }
  std::ranges::sort(columns);
  std::ranges::sort(rows);
  drawn.shape.rectangles = cut_along_z(cut_along_r(boxes, columns), rows);
  ends.section = fem::mesh_section(drawn.shape, drawn.spacing);
  draw_profile(ends.section, cup);
  for (fem::SectionPoint& point : ends.section.points) point.z -= start;
  return ends;
}

std::vector<fem::TemplateCell> wall_cells(const fem::SectionMesh& section, double mean_radius,
                                          double place, const std::vector<double>& around) {
  std::vector<double> angles = around;
  for (double& angle : angles) angle /= mean_radius;
  std::vector<fem::TemplateCell> cells = fem::swept_section(section, angles);
  for (fem::TemplateCell& cell : cells)
    cell.map = [map = std::move(cell.map), mean_radius, place](const fem::Point3& unit) {
      const auto [theta, z, r] = map(unit);
      return fem::Point3{mean_radius * theta, z - place, r - mean_radius};
    };
  return cells;
}

}  // namespace strainwave::gear_fem
