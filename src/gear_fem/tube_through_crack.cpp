// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/tube_through_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "gear_fem/crack_plan.hpp"
#include "gear_fem/tube_body.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// Lines of one direction of the grid: through the tips' squares, then graded to both ends.
std::vector<double> grid_lines(const std::vector<double>& inner, double from, double to, double gap,
                               double growth, double longest) {
  std::vector<double> lines = graded_lines(inner.front(), from, gap, growth, longest);
  std::reverse(lines.begin(), lines.end());
  lines.insert(lines.end(), inner.begin(), inner.end());
  const std::vector<double> after = graded_lines(inner.back(), to, gap, growth, longest);
  lines.insert(lines.end(), after.begin(), after.end());
  return lines;
}

/// Lines through the wall, more than two layers grow from both faces to the middle.
std::vector<double> wall_lines(double t, int layers) {
  std::vector<double> lines;
  for (int i = 0; i <= layers; ++i)  // points of a half circle
    lines.push_back(layers <= 2 ? t * (static_cast<double>(i) / layers - 0.5)
                                : -0.5 * t * std::cos(pi * i / layers));
  return lines;
}

/// K_I that the integrals may leave on a closed front, of K0 = tau sqrt(pi a).
constexpr double kClosedShare = 0.02;

struct Solved {
  fem::SolidResult solid;
  double area;  ///< of the crack
};

struct MeshedTube {
  TubeBody body;
  fem::HexMesh mesh;
};

MeshedTube mesh_size(const TubeWithThroughCrack& tube, double a) {
  // Bending of the wall decays within sqrt(r t), which a long crack's cells must not exceed.
  const double decay = std::sqrt(tube.mean_radius * tube.wall_thickness);
  const double b = std::min(a / 2, 0.6 * decay);
  const double t = tube.wall_thickness;
  TubeBody body = tube_body({.mean_radius = tube.mean_radius,
                             .wall_thickness = t,
                             .length = tube.length,
                             .place = tube.place,
                             .angle = tube.angle,
                             .rigid_radius = 1.02 * std::hypot(a + b, b)});
  CrackPlan plan;
  std::vector<double> inner = {-a - b, -a, -a + b};
  const int between = std::max(1, static_cast<int>(std::ceil((a - b) / (0.6 * decay) - 1e-9)));
  for (int i = 1; i <= between; ++i) inner.push_back((a - b) * (2.0 * i / between - 1));
  inner.insert(inner.end(), {a, a + b});
  plan.x = grid_lines(inner, body.along[0], body.along[1], b, tube.growth, body.longest_along);
  plan.y =
      grid_lines({-b, 0, b}, body.across[0], body.across[1], b, tube.growth, body.longest_across);
  const auto at = [](const std::vector<double>& lines, double x) {
    return static_cast<std::size_t>(std::find(lines.begin(), lines.end(), x) - lines.begin());
  };
  plan.tips = {{.i = at(plan.x, a), .j = at(plan.y, 0), .growth = 1},
               {.i = at(plan.x, -a), .j = at(plan.y, 0), .growth = -1}};
  plan.rings =
      tube.rings > 0
          ? tube.rings
          : std::clamp(
                static_cast<int>(std::ceil(std::log2(plan.circle * b / (0.04 * std::min(t, a))))),
                4, 16);
  const double tiny = 1e-9 * a;
  const double half_wall = t / 2;
  const fem::TemplateBody shape{
      .map = body.map,
      .on_crack =
          [=](const fem::Point3& p) { return std::abs(p[1]) < tiny && std::abs(p[0]) < a - tiny; },
      .face_tag = [=](const fem::Point3& p) -> int {
        if (std::abs(std::abs(p[2]) - half_wall) < 1e-9 * half_wall) return kTubeFree;
        if (std::abs(p[1]) < tiny && std::abs(p[0]) < a) return kTubeCrack;
        return body.end_tag(p);
      },
      .length = tube.mean_radius};
  return {body,
          fem::make_hex_mesh(extruded(crack_plan(plan), plan, wall_lines(t, tube.layers)), shape)};
}

Solved solve_size(const TubeWithThroughCrack& tube, double a) {
  const auto start = std::chrono::steady_clock::now();
  const MeshedTube meshed = mesh_size(tube, a);
  const double torque = tube.sense == TorqueSense::positive ? tube.torque : -tube.torque;
  fem::SolidProblem problem = tube_torsion(meshed.body, tube.material, torque);
  problem.order = tube.order;
  problem.crack_faces = tube.crack_faces;
  if (a == tube.half_length) problem.fields = tube.fields;
  Solved done{fem::solve_solid(meshed.mesh, problem), 2 * a * tube.wall_thickness};
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (tube.solved) tube.solved(done.solid, taken.count());
  return done;
}

/// Checks the values and fills in those that were left to be chosen.
TubeWithThroughCrack completed(TubeWithThroughCrack tube) {
  check_tube(tube.mean_radius, tube.wall_thickness, tube.length, tube.angle, tube.place);
  if (tube.place == 0) tube.place = tube.length / 2;
  // The wall bends about a long crack, within sqrt(r t); a short one has only its own stress.
  if (tube.growth == 0) tube.growth = tube.half_length >= tube.wall_thickness ? 1.4 : 2.5;
  // Chosen once: the neighbouring sizes of the growth check must have the same layers.
  if (tube.layers == 0) tube.layers = tube.half_length >= tube.wall_thickness ? 1 : 2;
  const double a = tube.half_length;
  require(a > 0 && std::isfinite(a), "half_length", a, "m", "half_length > 0");
  require(tube.torque > 0 && std::isfinite(tube.torque), "torque", tube.torque, "N*m",
          "torque > 0; its sense is given apart");
  require(tube.order >= 2 && tube.order <= 4, "order", tube.order, "1", "2 <= order <= 4");
  require(tube.rings == 0 || (tube.rings >= 3 && tube.rings <= 16), "rings", tube.rings, "1",
          "3 <= rings <= 16, or 0");
  require(tube.growth == 0 || (tube.growth >= 1.2 && tube.growth <= 3), "growth", tube.growth, "1",
          "1.2 <= growth <= 3, or 0");
  require(tube.layers >= 0 && tube.layers <= 8, "layers", tube.layers, "1", "0 <= layers <= 8");
  return tube;
}

}  // namespace

fem::HexMesh mesh_tube_with_through_crack(const TubeWithThroughCrack& tube) {
  return mesh_size(completed(tube), tube.half_length).mesh;
}

TubeCrackResult solve_tube_with_through_crack(const TubeWithThroughCrack& tube_given) {
  const TubeWithThroughCrack tube = completed(tube_given);
  const double a = tube.half_length;
  const double torque = tube.torque;
  Solved now = solve_size(tube, a);
  TubeCrackResult result;
  result.solid = std::move(now.solid);
  fem::SolidResult& solid = result.solid;
  const double mu = tube.material.youngs_modulus / (2 * (1 + tube.material.poissons_ratio));
  const double J = tube_polar_moment(tube.mean_radius, tube.wall_thickness);
  result.nominal_shear = torque * tube.mean_radius / J;
  result.compliance_without = tube.length / (mu * J);
  result.added_compliance = solid.added_work / (torque * torque);
  result.compliance = result.compliance_without + result.added_compliance;
  double length = 0;
  double release = 0;
  double largest_K = 0;
  double least_K_I = 0;
  double closed_K_I = 0;
  result.closed = true;
  for (const fem::CrackFront& front : solid.fronts) {
    release += front.release;
    length += front.length;
    closed_K_I = std::max(closed_K_I, front.closed_K_I);
    for (const fem::FrontStation& s : front.stations) {
      result.closed = result.closed && s.closed;
      largest_K = std::max(largest_K, std::hypot(s.K_I, s.K_II, s.K_III));
      least_K_I = std::min(least_K_I, s.K_I);
    }
  }
  result.energy_release_rate = release / length;
  if (tube.check_growth) {
    constexpr double kStep = 0.01;
    const Solved less = solve_size(tube, a * (1 - kStep));
    const Solved more = solve_size(tube, a * (1 + kStep));
    result.derivative_release_rate =
        (more.solid.added_work - less.solid.added_work) / 2 / (more.area - less.area);  // (FE-28)
    result.growth_check = result.derivative_release_rate / result.energy_release_rate - 1;
  }
  result.closed_release_rate = 1e-3 * std::pow(result.nominal_shear, 2) * std::numbers::pi * a /
                               tube.material.youngs_modulus;
  const double share = closed_K_I / (result.nominal_shear * std::sqrt(pi * a));
  if (share > kClosedShare)
    result.reason = fmt::format("where the faces touch {:.2g} of K0 is left as K_I", share);
  judge(result, tube.check_growth, least_K_I < -0.01 * largest_K);
  return result;
}

}  // namespace strainwave::gear_fem
