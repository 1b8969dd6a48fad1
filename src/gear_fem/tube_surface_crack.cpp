// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/tube_surface_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "ellipse_template.hpp"
#include "strainwave/core/error.hpp"
#include "surface_crack_mesh.hpp"
#include "tube_body.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

fem::Point3 difference(const fem::Point3& a, const fem::Point3& b, double step) {
  return {(a[0] - b[0]) / step, (a[1] - b[1]) / step, (a[2] - b[2]) / step};
}

double cross_norm(const fem::Point3& a, const fem::Point3& b) {
  return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0]);
}

}  // namespace

MeshedSurfaceCrack mesh_surface_crack(const TubeWithSurfaceCrack& tube, double size) {
  const double a = size * tube.depth;
  const double c = size * tube.half_length;
  const double t = tube.wall_thickness;
  const bool outer = tube.surface == TubeWithSurfaceCrack::Surface::outer;
  EllipseTemplate slab{.depth = a,
                       .half_length = c,
                       .thickness = t,
                       .rings = tube.rings,
                       .segments = tube.segments,
                       .growth = tube.growth};
  // The size of the rings does not depend on the ends if the ends are clear of the rings.
  slab.x = {-1e3 * c, 1e3 * c};
  slab.y = {-1e3 * c, 1e3 * c};
  slab.longest_x = slab.longest_y = 1e3 * c;
  MeshedSurfaceCrack meshed;
  meshed.body = tube_body({.mean_radius = tube.mean_radius,
                           .length = tube.length,
                           .place = tube.place,
                           .angle = tube.angle,
                           .rigid_radius = 1.1 * rings_half_length(slab),
                           .surface = outer ? t / 2 : -t / 2,
                           .turn_reach = 12});
  const TubeBody& body = meshed.body;
  // From an inner mouth, the template's depth runs outward.  For an outer mouth, the template is
  // rotated about the crack's line, so that it stays right-handed.
  const auto to_plan = [outer, t](const fem::Point3& p) {
    return outer ? fem::Point3{p[0], -p[1], t / 2 - p[2]} : fem::Point3{p[0], p[1], p[2] - t / 2};
  };
  meshed.map = [to_plan, map = body.map](const fem::Point3& p) { return map(to_plan(p)); };
  slab.x = body.along;
  slab.y = outer ? std::array{-body.across[1], -body.across[0]} : body.across;
  slab.longest_x = body.longest_along;
  slab.longest_y = body.longest_across;
  const double tiny = 1e-9 * t;
  const fem::TemplateBody shape{
      .map = meshed.map,
      .on_crack = [slab](const fem::Point3& p) { return inside_ellipse(slab, p); },
      .face_tag = [slab, to_plan, t, tiny, end = body.end_tag](const fem::Point3& p) -> int {
        if (p[2] < tiny || p[2] > t - tiny) return kTubeFree;
        if (inside_ellipse(slab, p)) return kTubeCrack;
        return end(to_plan(p));
      },
      .length = tube.mean_radius};
  meshed.mesh = fem::make_hex_mesh(ellipse_template(slab), shape);
  return meshed;
}

namespace {

/// Area that a crack of `size` sweeps per unit of size between phi and phi + dphi, over dphi [m^2].
double swept(const TubeWithSurfaceCrack& tube, const fem::PointMap& map, double size, double phi) {
  constexpr double kStep = 1e-4;
  const auto place = [&](double s, double angle) {
    return map({s * tube.half_length * std::cos(angle), 0, s * tube.depth * std::sin(angle)});
  };
  const fem::Point3 growth =
      difference(place(size * (1 + kStep), phi), place(size * (1 - kStep), phi), 2 * kStep * size);
  const fem::Point3 along =
      difference(place(size, phi + kStep), place(size, phi - kStep), 2 * kStep);
  return cross_norm(growth, along);
}

}  // namespace

SweptRelease swept_release(const TubeWithSurfaceCrack& tube, const fem::PointMap& map, double size,
                           const fem::CrackFront& front) {
  // G is quadratic over each segment, so Simpson's rule is used with dA of the analytic map.
  SweptRelease result;
  const double step = pi / static_cast<double>(front.stations.size() - 1);
  for (std::size_t i = 0; i < front.stations.size(); ++i) {
    const bool end = i == 0 || i + 1 == front.stations.size();
    const double weight = step / 3 * (end ? 1 : i % 2 == 1 ? 4 : 2);
    const double sweep = weight * swept(tube, map, size, step * static_cast<double>(i));
    result.sweep += sweep;
    result.release += sweep * front.stations[i].energy_release_rate;  // (FE-34)
  }
  return result;
}

namespace {

/// Results for one size of the crack under one sense of the torque.
struct SolvedSurfaceCrack {
  fem::SolidResult solid;
  double sweep{};    ///< dA/ds [m^2]
  double release{};  ///< int G v_n dl per unit of size [J]
};

/// @return a result for each sense
std::vector<SolvedSurfaceCrack> solve_surface_crack(const TubeWithSurfaceCrack& tube, double size,
                                                    std::span<const TorqueSense> senses) {
  const auto start = std::chrono::steady_clock::now();
  const MeshedSurfaceCrack meshed = mesh_surface_crack(tube, size);
  fem::SolidProblem problem = clamped_tube(tube.material);
  std::vector<fem::SolidLoad> loads;
  for (const TorqueSense sense : senses)
    loads.push_back(
        tube_torsion(tube.mean_radius, tube.wall_thickness, sign_of(sense) * tube.torque));
  problem.order = tube.order;
  problem.crack_faces = tube.crack_faces;
  if (size == 1) problem.fields = tube.fields;
  std::vector<SolvedSurfaceCrack> results;
  for (fem::SolidResult& solid : fem::solve_solid(meshed.mesh, problem, loads))
    results.push_back({.solid = std::move(solid)});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (tube.solved) tube.solved(results.front().solid, taken.count());
  for (SolvedSurfaceCrack& result : results) {
    const SweptRelease over = swept_release(tube, meshed.map, size, result.solid.fronts.at(0));
    result.sweep = over.sweep;
    result.release = over.release;
  }
  return results;
}

}  // namespace

TubeWithSurfaceCrack completed(TubeWithSurfaceCrack tube) {
  check_tube(tube.mean_radius, tube.wall_thickness, tube.length, tube.angle, tube.place);
  if (tube.place == 0) tube.place = tube.length / 2;
  require(tube.depth > 0 && tube.depth <= 0.9 * tube.wall_thickness, "depth", tube.depth, "m",
          "0 < depth <= 0.9 wall_thickness");
  require(tube.depth >= 0.2 * tube.half_length && tube.depth <= 5 * tube.half_length, "half_length",
          tube.half_length, "m", "0.2 <= depth/half_length <= 5");
  require(tube.torque > 0 && std::isfinite(tube.torque), "torque", tube.torque, "N*m",
          "torque > 0, with its sense in `sense`");
  require(tube.order >= 2 && tube.order <= 4, "order", tube.order, "1", "2 <= order <= 4");
  require(tube.rings >= 3 && tube.rings <= 12, "rings", tube.rings, "1", "3 <= rings <= 12");
  require(tube.segments >= 4 && tube.segments <= 32 && tube.segments % 4 == 0, "segments",
          tube.segments, "1", "4 <= segments <= 32, a multiple of 4");
  require(tube.growth == 0 || (tube.growth >= 1.5 && tube.growth <= 4), "growth", tube.growth, "1",
          "1.5 <= growth <= 4, or 0");
  // Far from a shallow crack only the stress of the torque remains, so cells may grow faster.
  if (tube.growth == 0) tube.growth = tube.depth >= 0.25 * tube.wall_thickness ? 2.5 : 3.5;
  return tube;
}

namespace {

/// State of the faces along the front without its two ends.
struct FrontFaces {
  bool closed = true;    ///< the faces touch at every station
  bool overlap = false;  ///< the faces pass through each other at a station
};

FrontFaces faces_along(const fem::CrackFront& front) {
  FrontFaces faces;
  double largest = 0;
  double least = 0;
  for (std::size_t i = 1; i + 1 < front.stations.size(); ++i) {
    const fem::FrontStation& s = front.stations[i];
    faces.closed = faces.closed && s.closed;
    largest = std::max(largest, std::hypot(s.K_I, s.K_II, s.K_III));
    least = std::min(least, s.K_I);
  }
  faces.overlap = least < -0.01 * largest;
  return faces;
}

}  // namespace

fem::HexMesh mesh_tube_with_surface_crack(const TubeWithSurfaceCrack& tube) {
  return mesh_surface_crack(completed(tube), 1).mesh;
}

namespace {

/// Solves each size of the crack once for all senses.
std::vector<TubeSurfaceCrackResult> solve_senses(const TubeWithSurfaceCrack& tube,
                                                 std::span<const TorqueSense> senses) {
  const double a = tube.depth;
  const double E = tube.material.youngs_modulus;
  const double J = tube_polar_moment(tube.mean_radius, tube.wall_thickness);
  const double T2 = tube.torque * tube.torque;
  std::vector<TubeSurfaceCrackResult> results;
  std::vector<double> sweeps;
  std::vector<FrontFaces> faces;
  std::vector<std::size_t> compared;  // numbers of those that are compared with other sizes
  for (SolvedSurfaceCrack& now : solve_surface_crack(tube, 1, senses)) {
    TubeSurfaceCrackResult& result = results.emplace_back();
    result.nominal_shear = tube.torque * tube.mean_radius / J;
    result.compliance_without = tube.length / (tube.material.shear_modulus() * J);
    result.closed_release_rate = 1e-3 * result.nominal_shear * result.nominal_shear * pi * a / E;
    result.area = pi / 2 * a * tube.half_length;
    result.solid = std::move(now.solid);
    result.added_compliance = result.solid.added_work / T2;
    result.compliance = result.compliance_without + result.added_compliance;
    result.energy_release_rate = now.release / now.sweep;
    sweeps.push_back(now.sweep);
    const fem::CrackFront& front = result.solid.fronts.at(0);
    faces.push_back(faces_along(front));
    result.closed = faces.back().closed;
    result.deepest = front.stations[front.stations.size() / 2];
    // Faces that touch everywhere and release no energy do not allow a comparison.
    const bool nothing =
        std::abs(result.energy_release_rate) < result.closed_release_rate &&
        std::abs(result.solid.added_work) < 2 * result.closed_release_rate * result.area;
    if (!nothing) compared.push_back(results.size() - 1);
  }
  std::vector<TorqueSense> again;
  for (const std::size_t n : compared) again.push_back(senses[n]);
  if (tube.check_growth && !again.empty()) {
    const std::vector<SolvedSurfaceCrack> smaller = solve_surface_crack(tube, 1 - kSizeStep, again);
    for (std::size_t k = 0; k < again.size(); ++k) {
      TubeSurfaceCrackResult& result = results[compared[k]];
      const double sweep = sweeps[compared[k]];
      result.derivative_release_rate =
          release_by_work({result.solid.added_work, result.energy_release_rate * sweep},
                          {smaller[k].solid.added_work, smaller[k].release}) /
          sweep;  // (FE-34)
      result.growth_check = result.derivative_release_rate / result.energy_release_rate - 1;
    }
  }
  if (tube.check_sizes && !again.empty()) {
    // Gauss points for the weight s^2, because the energy release starts like s^2.
    constexpr std::array<double, 3> kSize{0.2949977901115016, 0.6529962339616481,
                                          0.9270059759268503};
    constexpr std::array<double, 3> kWeight{0.0299507030085807, 0.1462462692598660,
                                            0.1571363610648866};
    for (std::size_t i = 0; i < kSize.size(); ++i) {
      const std::vector<SolvedSurfaceCrack> smaller = solve_surface_crack(tube, kSize[i], again);
      for (std::size_t k = 0; k < again.size(); ++k)
        results[compared[k]].compliance_by_sizes +=
            2 / T2 * kWeight[i] / (kSize[i] * kSize[i]) * smaller[k].release;  // (FE-35)
    }
    for (const std::size_t n : compared)
      results[n].sizes_check = results[n].compliance_by_sizes / results[n].added_compliance - 1;
  }
  for (std::size_t n = 0; n < senses.size(); ++n) {
    TubeSurfaceCrackResult& result = results[n];
    const double share =
        result.solid.fronts.at(0).closed_K_I / (result.nominal_shear * std::sqrt(pi * a));
    if (share > kClosedShare)
      result.reason =
          fmt::format("at touching faces the integrals leave {:.2g} of K0 as K_I", share);
    judge(result, tube.check_growth, faces[n].overlap);
  }
  return results;
}

}  // namespace

TubeSurfaceCrackResult solve_tube_with_surface_crack(const TubeWithSurfaceCrack& tube) {
  return std::move(solve_senses(completed(tube), std::span(&tube.sense, 1)).front());
}

BothSenses<TubeSurfaceCrackResult> solve_both_senses(const TubeWithSurfaceCrack& tube) {
  std::vector<TubeSurfaceCrackResult> results = solve_senses(completed(tube), kBothSenses);
  return {.positive = std::move(results[0]), .negative = std::move(results[1])};
}

std::vector<EllipsePoint> TubeSurfaceCrackResult::front() const {
  const auto& stations = solid.fronts.at(0).stations;
  std::vector<EllipsePoint> points;
  for (std::size_t i = 1; i + 1 < stations.size(); ++i)
    points.push_back({at(stations[i]), stations[i].position * std::numbers::pi});
  return points;
}

}  // namespace strainwave::gear_fem
