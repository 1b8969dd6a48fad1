// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/tube_through_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "confocal_plan.hpp"
#include "crack_plan.hpp"
#include "cup_ends.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/fem/swept_section.hpp"
#include "strainwave/gear_fem/cup_section.hpp"
#include "through_crack_mesh.hpp"
#include "tube_body.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// Lines through the wall; with more than two layers, layers grow from both faces to the middle.
std::vector<double> wall_lines(double t, int layers) {
  std::vector<double> lines;
  for (int i = 0; i <= layers; ++i)  // points of a half circle
    lines.push_back(layers <= 2 ? t * (static_cast<double>(i) / layers - 0.5)
                                : -0.5 * t * std::cos(pi * i / layers));
  return lines;
}

/// Largest relative difference of the sound cup's compliance between solid and section [-].
constexpr double kSoundTolerance = 0.005;

/// One size of the crack under the torques of several senses.
struct Solved {
  std::vector<fem::SolidResult> solids;  ///< one for each sense
  double area;                           ///< of the crack [m^2]; also its growth per unit of size
};

}  // namespace

CupSection cup_of(const TubeWithThroughCrack& tube) {
  return {.barrel = {.outer_diameter = 2 * tube.mean_radius + tube.wall_thickness,
                     .wall_thickness = tube.wall_thickness,
                     .length = tube.length},
          .rim = tube.ends.rim,
          .diaphragm = tube.ends.diaphragm,
          .boss = tube.ends.boss};
}

fem::HexMesh mesh_at_size(const TubeWithThroughCrack& tube, double a, Wall wall) {
  const double R = tube.mean_radius;
  const double t = tube.wall_thickness;
  const std::vector<double> layers = wall_lines(t, tube.layers);
  MeshedEnds ends{.section = {}, .barrel_from = 0, .barrel_to = tube.length};
  if (tube.ends.any()) {
    std::vector<double> radii = layers;
    for (double& radius : radii) radius += R;
    ends = mesh_cup_ends(cup_of(tube), radii);
  }
  // The angle runs from the generator (+y) toward -theta (-s).
  const ConfocalPlan plan{
      .half_length = a,
      .sized_for = tube.half_length,
      .direction = pi / 2 + tube.angle,
      .half_round = pi * R,
      .below = tube.place - ends.barrel_from,
      .above = ends.barrel_to - tube.place,
      .longest_round = pi * R / 5,
      .longest_along = std::max(tube.length / 4, R / 4),
      .end = tube.ends.any() ? "end of the barrel between its collars" : "end of the tube",
      .sectors = tube.sectors,
      .rings = tube.rings,
      // Away from a crack that is shorter than the wall's thickness, a coarse mesh is enough.
      .stretch = tube.half_length < t ? 1.3 : 1};
  const double tiny = 1e-9 * a;
  const double half_wall = t / 2;
  const auto distances = [=](const fem::Point3& p) {
    const PlanPoint x = on_crack_axes(plan, {p[0], p[1]});
    return PlanPoint{std::abs(x[0]), std::abs(x[1])};
  };
  const auto end_tag = [&](const fem::Point3& p) -> int {
    const double z = tube.place + p[1];
    if (!tube.ends.diaphragm && std::abs(z) < tiny) return kTubeClamp;
    if (!tube.ends.rim && std::abs(z - tube.length) < tiny) return kTubeLoad;
    const auto role = fem::role_at(ends.section, {R + p[2], z});
    return !role ? 0 : *role == fem::EdgeRole::held ? kTubeClamp : kTubeLoad;
  };
  const fem::TemplateBody shape{.map =
                                    [=, place = tube.place](const fem::Point3& p) {
                                      return fem::revolved({p[0] / R, place + p[1], R + p[2]});
                                    },
                                .on_crack =
                                    [=](const fem::Point3& p) {
                                      const PlanPoint x = distances(p);
                                      return wall == Wall::cracked && x[1] < tiny &&
                                             x[0] < a - tiny;
                                    },
                                .face_tag = [&](const fem::Point3& p) -> int {
                                  if (const int tag = end_tag(p); tag != 0) return tag;
                                  if (std::abs(std::abs(p[2]) - half_wall) < 1e-9 * half_wall)
                                    return kTubeFree;
                                  const PlanPoint x = distances(p);
                                  return x[1] < tiny && x[0] < a ? kTubeCrack : 0;
                                },
                                .length = R};
  const ConfocalCells flat = confocal_plan(plan);
  std::vector<fem::TemplateCell> cells = extruded(flat.cells, layers);
  if (!tube.ends.any()) return fem::make_hex_mesh(cells, shape);
  const std::vector<fem::TemplateCell> more = wall_cells(ends.section, R, tube.place, flat.round);
  cells.insert(cells.end(), more.begin(), more.end());
  fem::HexMesh mesh = fem::with_boundary_tags(fem::make_hex_mesh(cells, shape), kTubeFree);
  if (wall == Wall::sound) mesh.fronts = 0;
  return mesh;
}

namespace {

/// Adds the energy density without the crack, computed with the same cells, to each point of a
/// cup's fields under each load.
void add_sound_energy(std::vector<fem::SolidResult>& solids, const TubeWithThroughCrack& tube,
                      fem::SolidProblem problem, std::span<const fem::SolidLoad> loads) {
  problem.crack_tag = 0;
  problem.crack_faces = fem::CrackFaces::free;
  problem.fields.every_cell = true;  // the ranks may own other cells in this mesh
  const auto start = std::chrono::steady_clock::now();
  const std::vector<fem::SolidResult> sound =
      fem::solve_solid(mesh_at_size(tube, tube.half_length, Wall::sound), problem, loads);
  for (std::size_t n = 0; n < loads.size(); ++n)
    for (fem::FieldCell& cell : solids[n].fields.cells)
      for (std::size_t i = 0; i < cell.points.size(); ++i)
        cell.points[i].energy_density_without_crack =
            sound[n].fields.cells.at(cell.cell).points.at(i).energy_density;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (tube.solved) tube.solved(sound.front(), taken.count());
}

fem::SolidLoad load_of(const TubeWithThroughCrack& tube, TorqueSense sense) {
  const double torque = sign_of(sense) * tube.torque;
  fem::SolidLoad load = tube_torsion(tube.mean_radius, tube.wall_thickness, torque);
  if (const auto& rim = tube.ends.rim)
    load.tractions = {
        end_torque((rim->outer_diameter - rim->wall_thickness) / 2, rim->wall_thickness, torque)};
  return load;
}

Solved solve_size(const TubeWithThroughCrack& tube, double a, std::span<const TorqueSense> senses) {
  const auto start = std::chrono::steady_clock::now();
  const fem::HexMesh mesh = mesh_at_size(tube, a);
  fem::SolidProblem problem = clamped_tube(tube.material);
  std::vector<fem::SolidLoad> loads;
  for (const TorqueSense sense : senses) loads.push_back(load_of(tube, sense));
  problem.order = tube.order;
  problem.crack_faces = tube.crack_faces;
  if (a == tube.half_length) problem.fields = tube.fields;
  Solved done{fem::solve_solid(mesh, problem, loads), 2 * a * tube.wall_thickness};
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (tube.solved) tube.solved(done.solids.front(), taken.count());
  if (tube.ends.any() && problem.fields.divisions > 0)
    add_sound_energy(done.solids, tube, problem, loads);
  return done;
}

/// Checks that the crack of a cup stays in the barrel and clear of its joints.
void check_joints(const TubeWithThroughCrack& tube) {
  const double reach = tube.half_length * std::abs(std::cos(tube.angle));
  const auto check = [&](bool there, const char* joint, double distance) {
    if (!there) return;
    const double clear = distance - reach;
    const double needed = kClearOfJoint * tube.wall_thickness;
    if (clear >= needed) return;
    throw InputError(
        "half_length",
        clear < 0 ? fmt::format("the crack crosses the {}: it reaches {:.4g} mm toward "
                                "it, but the distance from its middle is {:.4g} mm",
                                joint, reach / units::mm, distance / units::mm)
                  : fmt::format("the crack ends {:.4g} mm from the {}, but {} wall "
                                "thicknesses, {:.4g} mm, are needed",
                                clear / units::mm, joint, kClearOfJoint, needed / units::mm));
  };
  check(tube.ends.diaphragm.has_value(), "diaphragm", tube.place);
  check(tube.ends.rim.has_value(), "rim", tube.length - tube.place);
}

}  // namespace

TubeWithThroughCrack completed(TubeWithThroughCrack tube) {
  check_tube(tube.mean_radius, tube.wall_thickness, tube.length, tube.angle, tube.place);
  if (tube.place == 0) tube.place = tube.length / 2;
  const double a = tube.half_length;
  require(a > 0 && std::isfinite(a), "half_length", a, "m", "half_length > 0");
  require(tube.torque > 0 && std::isfinite(tube.torque), "torque", tube.torque, "N*m",
          "torque > 0, with its sense in `sense`");
  require(tube.order >= 2 && tube.order <= 4, "order", tube.order, "1", "2 <= order <= 4");
  require(tube.sectors == 0 || (tube.sectors >= 8 && tube.sectors <= 64 && tube.sectors % 8 == 0),
          "sectors", tube.sectors, "1", "a multiple of 8 from 8 to 64, or 0");
  require(tube.rings == 0 || (tube.rings >= 2 && tube.rings <= 16), "rings", tube.rings, "1",
          "2 <= rings <= 16, or 0");
  require(tube.layers >= 0 && tube.layers <= 8, "layers", tube.layers, "1", "0 <= layers <= 8");
  check_joints(tube);
  const double t = tube.wall_thickness;
  if (tube.layers == 0) tube.layers = a >= t ? 1 : 2;
  if (tube.sectors == 0) {
    // Bending of the wall reaches over sqrt(r t), so the cells beside a long crack must not be
    // longer.
    const double reach = std::sqrt(tube.mean_radius * t);
    tube.sectors = 8 * std::clamp(static_cast<int>(std::ceil(a / reach / 0.7)), 2, 8);
  }
  if (tube.rings == 0) {
    // The innermost cells reach to 4 % of wall or crack.
    const double halvings = std::log2(outermost_ring(a, tube.sectors) / (0.04 * std::min(t, a)));
    tube.rings = std::clamp(static_cast<int>(std::ceil(halvings)), 2, 16);
  }
  return tube;
}

fem::HexMesh mesh_tube_with_through_crack(const TubeWithThroughCrack& tube) {
  return mesh_at_size(completed(tube), tube.half_length);
}

namespace {

/// Fracture quantities over the fronts of a crack.
struct OverFronts {
  double energy_release_rate = 0.0;  ///< [J/m^2]
  double closed_K_I = 0.0;           ///< largest that touching faces leave [Pa*m^0.5]
  bool closed = true;
  bool overlap = false;  ///< the faces pass through each other at a station
};

OverFronts over_fronts(const fem::SolidResult& solid) {
  OverFronts over;
  double length = 0;
  double release = 0;
  double largest_K = 0;
  double least_K_I = 0;
  for (const fem::CrackFront& front : solid.fronts) {
    release += front.release;
    length += front.length;
    over.closed_K_I = std::max(over.closed_K_I, front.closed_K_I);
    for (const fem::FrontStation& s : front.stations) {
      over.closed = over.closed && s.closed;
      largest_K = std::max(largest_K, std::hypot(s.K_I, s.K_II, s.K_III));
      least_K_I = std::min(least_K_I, s.K_I);
    }
  }
  over.energy_release_rate = release / length;
  over.overlap = least_K_I < -0.01 * largest_K;
  return over;
}

/// Solves each size of the crack once for all senses.
std::vector<TubeCrackResult> solve_senses(const TubeWithThroughCrack& tube,
                                          std::span<const TorqueSense> senses) {
  const double a = tube.half_length;
  const double torque = tube.torque;
  const double mu = tube.material.shear_modulus();
  const double J = tube_polar_moment(tube.mean_radius, tube.wall_thickness);
  Solved now = solve_size(tube, a, senses);
  std::optional<CupResult> cup;
  if (tube.ends.any()) cup = solve_cup(cup_of(tube), tube.material);
  std::optional<Solved> smaller;
  if (tube.check_growth) smaller = solve_size(tube, a * (1 - kSizeStep), senses);
  std::vector<TubeCrackResult> results;
  for (std::size_t n = 0; n < senses.size(); ++n) {
    TubeCrackResult& result = results.emplace_back();
    result.solid = std::move(now.solids[n]);
    const fem::SolidResult& solid = result.solid;
    result.nominal_shear = torque * tube.mean_radius / J;
    result.compliance_without = tube.length / (mu * J);
    result.added_compliance = solid.added_work / (torque * torque);
    if (cup) {
      if (!cup->usable) result.reason = "the sound cup: " + cup->reason;
      result.compliance_without = cup->compliance;
      result.sound_check =
          (solid.work / (torque * torque) - result.added_compliance) / cup->compliance -
          1;  // (FE-50)
      if (result.reason.empty() && !(std::abs(result.sound_check) <= kSoundTolerance))
        result.reason = fmt::format(
            "without the crack, the compliance of the solid differs by {:.2g} from that of the "
            "body of revolution",
            result.sound_check);
    }
    result.compliance = result.compliance_without + result.added_compliance;
    const OverFronts over = over_fronts(solid);
    result.closed = over.closed;
    result.energy_release_rate = over.energy_release_rate;
    if (smaller) {
      const fem::SolidResult& other = smaller->solids[n];
      result.derivative_release_rate =
          release_by_work({solid.added_work, over.energy_release_rate * now.area},
                          {other.added_work, over_fronts(other).energy_release_rate * now.area}) /
          now.area;
      result.growth_check = result.derivative_release_rate / result.energy_release_rate - 1;
    }
    result.closed_release_rate =
        1e-3 * std::pow(result.nominal_shear, 2) * pi * a / tube.material.youngs_modulus;
    const double share = over.closed_K_I / (result.nominal_shear * std::sqrt(pi * a));
    if (result.reason.empty() && !(share <= kClosedShare))
      result.reason =
          fmt::format("at touching faces the integrals leave {:.2g} of K0 as K_I", share);
    judge(result, tube.check_growth, over.overlap);
  }
  return results;
}

}  // namespace

TubeCrackResult solve_tube_with_through_crack(const TubeWithThroughCrack& tube) {
  return std::move(solve_senses(completed(tube), std::span(&tube.sense, 1)).front());
}

BothSenses<TubeCrackResult> solve_both_senses(const TubeWithThroughCrack& tube) {
  std::vector<TubeCrackResult> results = solve_senses(completed(tube), kBothSenses);
  return {.positive = std::move(results[0]), .negative = std::move(results[1])};
}

bool TubeCrackResult::releases() const {
  return std::abs(energy_release_rate) > closed_release_rate;
}

std::string_view TubeCrackResult::faces() const {
  if (closed) return "closed";
  return solid.contact_share > 0 ? "partly closed" : "open";
}

FrontPoint TubeCrackResult::at(const fem::FrontStation& station) const {
  return {.x = station.place[0],
          .y = station.place[1],
          .z = station.place[2],
          .K_I = closed ? 0.0 : station.K_I,
          .K_II = station.K_II,
          .K_III = station.K_III,
          .energy_release_rate = station.energy_release_rate};
}

std::vector<TipFront> TubeCrackResult::tips() const {
  std::vector<TipFront> tips;
  for (const fem::CrackFront& front : solid.fronts) {
    tips.push_back({.tip = kTips.at(tips.size()), .from_inner_to_outer_face = {}});
    for (const fem::FrontStation& station : front.stations)
      tips.back().from_inner_to_outer_face.push_back(at(station));
  }
  return tips;
}

Checks TubeCrackResult::checks() const {
  Checks checks{.energy_balance = solid.energy_balance,
                .equilibrium_residual = solid.equilibrium_residual,
                .worst_jacobian = solid.worst_jacobian,
                .unknowns = solid.dofs};
  if (sound_check != 0) checks.sound_check = sound_check;
  if (!releases()) return checks;
  checks.ring_spread = 0.0;
  for (const fem::CrackFront& front : solid.fronts)
    checks.ring_spread = std::max(*checks.ring_spread, front.ring_spread);
  checks.growth_check = growth_check;
  return checks;
}

}  // namespace strainwave::gear_fem
