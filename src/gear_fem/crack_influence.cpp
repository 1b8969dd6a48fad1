// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/crack_influence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "strainwave/fem/crack_response.hpp"
#include "strainwave/gear_fem/crack_turn.hpp"
#include "through_crack_mesh.hpp"
#include "tube_body.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// Values of the hats over ascending places; with `ends` the first and last hats fall to 0 at -1
/// and 1, else they stay 1 beyond their place.
std::vector<double> hats(const std::vector<double>& places, double at, bool ends) {
  std::vector<double> knots = places;
  if (ends) {
    knots.insert(knots.begin(), -1.0);
    knots.push_back(1.0);
  }
  std::vector<double> value(knots.size(), 0.0);
  const double inside = std::clamp(at, knots.front(), knots.back());
  std::size_t i = 1;
  while (i + 1 < knots.size() && inside > knots[i]) ++i;
  const double share = (inside - knots[i - 1]) / (knots[i] - knots[i - 1]);
  value[i - 1] = 1 - share;
  value[i] = share;
  if (ends) value = std::vector<double>(value.begin() + 1, value.end() - 1);
  return value;
}

/// A node of the faces in the coordinates of the crack.
struct FaceNode {
  double s;
  double zeta;
  std::array<fem::Point3, kTractionDirections> axes;
};

FaceNode face_node(const TubeWithThroughCrack& tube, const fem::CrackNode& node) {
  const auto [x, y, z] = node.place;
  const double r = std::hypot(x, y);
  const double arc = tube.mean_radius * std::atan2(y, x);
  const fem::Point3 radial{x / r, y / r, 0};
  const fem::Point3& n = node.normal;
  // The tangent completes the frame, toward the upper tip.
  fem::Point3 along{n[1] * radial[2] - n[2] * radial[1], n[2] * radial[0] - n[0] * radial[2],
                    n[0] * radial[1] - n[1] * radial[0]};
  const fem::Point3 up{std::sin(tube.angle) * radial[1], -std::sin(tube.angle) * radial[0],
                       std::cos(tube.angle)};
  const double sense = along[0] * up[0] + along[1] * up[1] + along[2] * up[2] > 0 ? 1.0 : -1.0;
  for (double& c : along) c *= sense;
  return {.s = ((z - tube.place) * std::cos(tube.angle) - arc * std::sin(tube.angle)) /
               tube.half_length,
          .zeta = 2 * (r - tube.mean_radius) / tube.wall_thickness,
          .axes = {n, along, radial}};
}

}  // namespace

std::vector<double> ContactGrid::values(double s, double zeta) const {
  const std::vector<double> by_s = hats(along, s, true);
  const std::vector<double> by_zeta = hats(across, zeta, false);
  std::vector<double> product;
  product.reserve(size());
  for (const double a : by_s)
    for (const double b : by_zeta) product.push_back(a * b);
  return product;
}

ContactGrid contact_grid() {
  ContactGrid grid;
  constexpr int kHalf = 5;  // intervals of a half; sines, so that the middle is exactly 0
  for (int i = 1 - kHalf; i < kHalf; ++i) grid.along.push_back(std::sin(pi * i / (2 * kHalf)));
  grid.across = {-1, -0.7236, -0.2764, 0.2764, 0.7236, 1};
  return grid;
}

TubeWithThroughCrack influence_tube(double half_length, double radius, double angle) {
  TubeWithThroughCrack tube;
  tube.material = {.youngs_modulus = 1, .poissons_ratio = 0.3};
  tube.mean_radius = radius;
  tube.wall_thickness = 1;
  tube.half_length = half_length;
  tube.length = std::max(2 * radius, 8 * half_length);
  tube.angle = angle;
  tube.layers = kTurnLayers;
  return tube;
}

CrackInfluence crack_influence(const TubeWithThroughCrack& given) {
  const TubeWithThroughCrack tube = completed(given);
  fem::SolidProblem problem = clamped_tube(tube.material);
  problem.order = tube.order;
  problem.crack_faces = fem::CrackFaces::contact;
  fem::Support far_end = problem.supports.front();
  far_end.tag = kTubeLoad;
  problem.supports.push_back(std::move(far_end));
  const fem::CrackResponse crack(mesh_at_size(tube, tube.half_length), problem);
  const std::span<const fem::CrackNode> nodes = crack.nodes();
  const ContactGrid grid = contact_grid();
  const double a = tube.half_length;
  const double E = tube.material.youngs_modulus;

  std::vector<FaceNode> places;
  std::vector<std::vector<double>> hats;
  for (const fem::CrackNode& node : nodes) {
    places.push_back(face_node(tube, node));
    hats.push_back(grid.values(places.back().s, places.back().zeta));
    if (node.on_front) hats.back().assign(grid.size(), 0.0);
  }
  const std::size_t columns = kUnitTractions + grid.size();
  CrackInfluence result;
  result.unknowns = crack.unknowns();
  std::vector<std::size_t> upper;
  for (std::size_t n = 0; n < crack.stations().size(); ++n)
    if (crack.stations()[n].front == 0) {
      upper.push_back(n);
      result.stations.push_back(2 * crack.stations()[n].position - 1);
    }
  result.K.assign(3 * upper.size(), std::vector<double>(columns));
  result.gap.assign(grid.size(), std::vector<double>(columns));
  std::vector<fem::Point3> traction(nodes.size());
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const FaceNode& at = places[n];
      double size = 0;
      std::size_t direction = 0;
      if (c < kUnitTractions) {
        direction = c / kTractionShapes;
        const std::size_t shape = c % kTractionShapes;
        const std::size_t power = shape / 2;
        size = std::pow(at.s, static_cast<double>(power)) * (shape % 2 == 1 ? at.zeta : 1.0);
      } else {
        size = hats[n][c - kUnitTractions];
      }
      for (std::size_t k = 0; k < 3; ++k) traction[n][k] = size * at.axes[direction][k];
    }
    const fem::CrackState state = crack.state(traction, fem::CrackFaces::free);
    for (std::size_t i = 0; i < upper.size(); ++i) {
      const fem::StationFactors& K = state.stations[upper[i]];
      const double unit = std::sqrt(pi * a);
      result.K[3 * i][c] = K.K_I / unit;
      result.K[3 * i + 1][c] = K.K_II / unit;
      result.K[3 * i + 2][c] = K.K_III / unit;
    }
    for (std::size_t n = 0; n < nodes.size(); ++n)
      for (std::size_t i = 0; i < grid.size(); ++i)
        result.gap[i][c] +=
            hats[n][i] * nodes[n].area * state.gap[n] / (a / E * a * tube.wall_thickness);
  }
  double largest = 0;
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double& one = result.gap[i][kUnitTractions + j];
      double& other = result.gap[j][kUnitTractions + i];
      largest = std::max({largest, std::abs(one), std::abs(other)});
      result.asymmetry = std::max(result.asymmetry, std::abs(one - other));
      one = other = (one + other) / 2;
    }
  result.asymmetry /= largest;
  return result;
}

}  // namespace strainwave::gear_fem
