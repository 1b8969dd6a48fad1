// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/cup_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cup_shape.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::gear_fem {
namespace {

using fem::EdgeRole;

constexpr std::array<std::string_view, 4> kPartName = {"rim", "barrel", "diaphragm", "boss"};

void check(const TubeSection& tube, std::string_view name) {
  const auto field = [&](std::string_view what) { return fmt::format("{}.{}", name, what); };
  require(tube.outer_diameter > 0, field("outer_diameter"), tube.outer_diameter, "m", "> 0");
  require(tube.wall_thickness > 0 && tube.wall_thickness < tube.outer_diameter / 2,
          field("wall_thickness"), tube.wall_thickness, "m", "> 0 and < outer_diameter/2");
  require(tube.length > 0, field("length"), tube.length, "m", "> 0");
}

double outer_radius(const TubeSection& tube) { return tube.outer_diameter / 2; }
double inner_radius(const TubeSection& tube) { return outer_radius(tube) - tube.wall_thickness; }

void check(const CupSection& cup) {
  check(cup.barrel, "barrel");
  if (cup.rim) {
    check(*cup.rim, "rim");
    const double overlap = std::min(outer_radius(*cup.rim), outer_radius(cup.barrel)) -
                           std::max(inner_radius(*cup.rim), inner_radius(cup.barrel));
    require(overlap > 0, "rim.outer_diameter", cup.rim->outer_diameter, "m",
            "a wall that meets the barrel's");
  }
  const bool fillets = cup.barrel_fillet != 0 || cup.boss_fillet != 0;
  if (!cup.diaphragm && (cup.boss || fillets))
    throw InputError(cup.boss ? "boss" : "fillet", "needs a diaphragm");
  if (!cup.diaphragm) return;
  const Diaphragm& plate = *cup.diaphragm;
  const double room = inner_radius(cup.barrel) - plate.inner_diameter / 2;
  require(plate.outer_diameter / 2 >= inner_radius(cup.barrel) * (1 - 1e-9) &&
              plate.outer_diameter / 2 <= outer_radius(cup.barrel) * (1 + 1e-9),
          "diaphragm.outer_diameter", plate.outer_diameter, "m", "inside the wall of the barrel");
  require(plate.inner_diameter > 0 && room > 0, "diaphragm.inner_diameter", plate.inner_diameter,
          "m", "> 0 and less than the barrel's inside");
  require(plate.thickness > 0, "diaphragm.thickness", plate.thickness, "m", "> 0");
  require(cup.barrel_fillet >= 0 && cup.barrel_fillet < std::min(room / 3, cup.barrel.length / 3),
          "barrel_fillet", cup.barrel_fillet, "m",
          ">= 0, and less than a third of the diaphragm's width and of the barrel's length");
  if (cup.barrel_fillet > 0 && !plate.profile.empty())
    throw InputError("barrel_fillet", "is for a diaphragm of constant thickness");
  if (cup.rim && cup.barrel_fillet > 0) {
    const double beyond = inner_radius(cup.barrel) - inner_radius(*cup.rim);
    require(beyond <= 0 || beyond > cup.barrel_fillet, "barrel_fillet", cup.barrel_fillet, "m",
            "less than the step from the barrel in to the rim, if there is one");
  }
  if (cup.boss_fillet != 0 && !cup.boss) throw InputError("boss_fillet", "needs a boss");
  if (!cup.boss) return;
  check(*cup.boss, "boss");
  require(std::abs(cup.boss->outer_diameter / plate.inner_diameter - 1) < 1e-9,
          "boss.outer_diameter", cup.boss->outer_diameter, "m", "that of the diaphragm's bore");
  require(cup.boss_fillet >= 0 && cup.boss_fillet < std::min(room / 3, cup.boss->length / 3),
          "boss_fillet", cup.boss_fillet, "m",
          ">= 0, and less than a third of the diaphragm's width and of the boss's length");
}

/// Rectangles cut along lines of one direction.
template <double fem::SectionRectangle::*from, double fem::SectionRectangle::*to>
std::vector<fem::SectionRectangle> cut(const std::vector<fem::SectionRectangle>& boxes,
                                       const std::vector<double>& lines) {
  std::vector<fem::SectionRectangle> pieces;
  for (fem::SectionRectangle rest : boxes) {
    const double tiny = 1e-9 * (rest.*to - rest.*from);
    for (const double line : lines) {
      if (line < rest.*from + tiny || line > rest.*to - tiny) continue;
      fem::SectionRectangle piece = rest;
      piece.*to = rest.*from = line;
      pieces.push_back(piece);
    }
    pieces.push_back(rest);
  }
  return pieces;
}

}  // namespace

std::vector<fem::SectionRectangle> cut_along_r(const std::vector<fem::SectionRectangle>& rectangles,
                                               const std::vector<double>& lines) {
  return cut<&fem::SectionRectangle::r_from, &fem::SectionRectangle::r_to>(rectangles, lines);
}

std::vector<fem::SectionRectangle> cut_along_z(const std::vector<fem::SectionRectangle>& rectangles,
                                               const std::vector<double>& lines) {
  return cut<&fem::SectionRectangle::z_from, &fem::SectionRectangle::z_to>(rectangles, lines);
}

void draw_profile(fem::SectionMesh& mesh, const CupSection& cup) {
  if (!cup.diaphragm || cup.diaphragm->profile.empty()) return;
  const Diaphragm& plate = *cup.diaphragm;
  for (fem::SectionPoint& point : mesh.points)
    if (point.z > 0 && point.z <= plate.thickness * (1 + 1e-9) &&
        point.r < inner_radius(cup.barrel) * (1 - 1e-9))
      point.z *= diaphragm_thickness(plate, point.r) / plate.thickness;
  // A sharp corner at the boss or the barrel lies at the nominal thickness or at z = 0, and neither
  // moves.
  fem::check_mesh(mesh);
}

CupSection cup_section(const Flexspline& flexspline) {
  if (flexspline.crack_free != CrackFree::sections || !flexspline.barrel)
    throw InputError("flexspline.crack_free",
                     "finite elements need the geometry: crack_free = \"sections\" with a barrel");
  return {.barrel = *flexspline.barrel,
          .rim = flexspline.rim,
          .diaphragm = flexspline.diaphragm,
          .boss = flexspline.boss};
}

CupShape cup_shape(const CupSection& cup) {
  check(cup);
  const double barrel_in = inner_radius(cup.barrel);
  const double barrel_out = outer_radius(cup.barrel);
  fem::SectionShape shape;
  double z = 0.0;
  fem::SectionSide held{
      .at_z = true, .level = 0, .from = barrel_in, .to = barrel_out, .role = EdgeRole::held};
  double largest_diaphragm_cell = cup.barrel.length;
  if (cup.diaphragm) {
    const Diaphragm& plate = *cup.diaphragm;
    const double bore = plate.inner_diameter / 2;
    z = plate.thickness;
    std::vector<double> radii = {bore, barrel_in, barrel_out};
    for (const DiaphragmStation& station : plate.profile)
      if (station.radius > bore && station.radius < barrel_in) radii.push_back(station.radius);
    std::ranges::sort(radii);
    for (std::size_t k = 0; k + 1 < radii.size(); ++k)
      if (radii[k + 1] - radii[k] > 1e-9 * barrel_out)
        shape.rectangles.push_back({radii[k], radii[k + 1], 0, z, kDiaphragm});
    largest_diaphragm_cell = (barrel_in - bore) / 4;
    held = {.at_z = false, .level = bore, .from = 0, .to = z, .role = EdgeRole::held};
    if (cup.barrel_fillet > 0)
      shape.fillets.push_back(
          {.corner = {barrel_in, z}, .void_r = -1, .void_z = 1, .radius = cup.barrel_fillet});
    if (cup.boss) {
      const double inside = inner_radius(*cup.boss);
      shape.rectangles.push_back({inside, bore, -cup.boss->length, 0, kBoss});
      shape.rectangles.push_back({inside, bore, 0, z, kBoss});
      held = {.at_z = true,
              .level = -cup.boss->length,
              .from = inside,
              .to = bore,
              .role = EdgeRole::held};
      if (cup.boss_fillet > 0)
        shape.fillets.push_back(
            {.corner = {bore, 0}, .void_r = 1, .void_z = -1, .radius = cup.boss_fillet});
    }
  }
  shape.rectangles.push_back({barrel_in, barrel_out, z, z + cup.barrel.length, kBarrel});
  z += cup.barrel.length;
  fem::SectionSide loaded{
      .at_z = true, .level = z, .from = barrel_in, .to = barrel_out, .role = EdgeRole::loaded};
  if (cup.rim) {
    loaded.from = inner_radius(*cup.rim);
    loaded.to = outer_radius(*cup.rim);
    shape.rectangles.push_back({loaded.from, loaded.to, z, z + cup.rim->length, kRim});
    z += cup.rim->length;
    loaded.level = z;
  }
  shape.sides = {held, loaded};
  return {
      .shape = std::move(shape),
      .spacing = {.coarse_r = largest_diaphragm_cell, .coarse_z = barrel_out / 4, .growth = 1.0}};
}

fem::SectionMesh mesh_cup(const CupSection& cup) {
  const CupShape drawn = cup_shape(cup);
  fem::SectionMesh mesh = fem::mesh_section(drawn.shape, drawn.spacing);
  draw_profile(mesh, cup);
  return mesh;
}

CupResult solve_cup(const CupSection& cup, const fem::Elasticity& elasticity,
                    const fem::SectionOptions& options) {
  const fem::SectionMesh mesh = mesh_cup(cup);
  const auto solve = [&](int order) {
    fem::SectionOptions with = options;
    with.order = order;
    if (order != options.order) with.fields = {};
    return fem::solve_section(mesh, fem::SectionLoad::torsion, elasticity, with);
  };
  CupResult result{.parts = {}, .solution = solve(options.order), .reason = {}};
  result.compliance = result.solution.compliance;
  for (std::size_t part = 0; part < result.solution.part_energy.size(); ++part) {
    const double twice = 2 * result.solution.part_energy[part];  // (FE-10)
    if (twice > 0)
      result.parts.push_back({std::string(kPartName.at(part)), twice, twice / result.compliance});
  }
  result.lower_order = solve(options.order - 1).compliance / result.compliance - 1;
  if (!(std::abs(result.lower_order) <= kOrderTolerance))
    result.reason = fmt::format("the compliance changes by {:.2g} from order {} to {}",
                                result.lower_order, options.order - 1, options.order);
  result.usable = result.reason.empty();
  return result;
}

Checks CupResult::checks() const {
  return {.lower_order = lower_order,
          .energy_balance = solution.energy_balance,
          .equilibrium_residual = solution.equilibrium_residual,
          .worst_jacobian = solution.worst_jacobian,
          .unknowns = solution.dofs};
}

}  // namespace strainwave::gear_fem
