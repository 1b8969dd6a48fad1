// SPDX-License-Identifier: Apache-2.0
#include "turn_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "surface_crack_mesh.hpp"
#include "through_crack_mesh.hpp"
#include "tube_body.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

fem::SolidProblem problem_of(const fem::Elasticity& material, int order) {
  fem::SolidProblem problem = clamped_tube(material);
  problem.order = order;
  problem.crack_faces = fem::CrackFaces::contact;
  return problem;
}

class ThroughCrackBody : public TurnBody {
 public:
  /// @param tube  completed
  ThroughCrackBody(TubeWithThroughCrack tube, const CamFit& fit)
      : tube_(std::move(tube)), problem_(problem_of(tube_.material, tube_.order)) {
    // The band of the wave generator holds the bore radially.
    const TubeSection& rim = *tube_.ends.rim;
    const double bore = rim.outer_diameter / 2 - rim.wall_thickness;
    const double width = fit.band_width > 0 ? std::min(fit.band_width, rim.length) : rim.length;
    const double middle = tube_.length + rim.length / 2;
    const double tiny = 1e-6 * bore;
    problem_.supports.push_back({.tag = kTubeFree, .directions = [=](const fem::Point3& p) {
                                   const double r = std::hypot(p[0], p[1]);
                                   std::vector<fem::Point3> held;
                                   if (std::abs(r - bore) < tiny &&
                                       std::abs(p[2] - middle) < width / 2 + tiny)
                                     held.push_back({p[0] / r, p[1] / r, 0});
                                   return held;
                                 }});
  }

  [[nodiscard]] const fem::SolidProblem& problem() const override { return problem_; }
  [[nodiscard]] fem::HexMesh mesh(double size) const override {
    return mesh_at_size(tube_, size * tube_.half_length);
  }
  [[nodiscard]] std::vector<LabelledStation> labels(
      std::span<const fem::StationPlace> stations) const override {
    std::vector<LabelledStation> labels;
    for (std::size_t s = 0; s < stations.size(); ++s)
      labels.push_back({s, kTips.at(stations[s].front), 2 * stations[s].position - 1});
    return labels;
  }
  [[nodiscard]] ProportionalRelease release(const fem::SolidResult& solid,
                                            double /*size*/) const override {
    ProportionalRelease sum;  // the fronts grow by the same length at any size
    for (const fem::CrackFront& front : solid.fronts) {
      sum.rate += tube_.half_length * front.release;
      sum.of_K += tube_.half_length * front.release * front.mode_energy_ratio;
      sum.sweep += tube_.half_length * front.length;
    }
    return sum;
  }

 private:
  TubeWithThroughCrack tube_;
  fem::SolidProblem problem_;
};

class SurfaceCrackBody : public TurnBody {
 public:
  /// @param tube  completed
  explicit SurfaceCrackBody(const TubeWithSurfaceCrack& tube)
      : tube_(tube),
        map_(mesh_surface_crack(tube, 1).map),
        problem_(problem_of(tube.material, tube.order)) {}

  [[nodiscard]] const fem::SolidProblem& problem() const override { return problem_; }
  [[nodiscard]] fem::HexMesh mesh(double size) const override {
    return mesh_surface_crack(tube_, size).mesh;
  }
  [[nodiscard]] std::vector<LabelledStation> labels(
      std::span<const fem::StationPlace> stations) const override {
    // From the surface down to the deepest point, on both sides.  K is not defined at the two ends.
    const std::size_t middle = stations.size() / 2;
    std::vector<LabelledStation> labels;
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t s = 1; s <= middle; ++s) {
        const std::size_t number = side == 0 ? s : stations.size() - 1 - s;
        const double sine = std::sin(pi * stations[number].position);
        labels.push_back({number, kTips.at(side), s == middle ? 1.0 : sine});
      }
    return labels;
  }
  [[nodiscard]] ProportionalRelease release(const fem::SolidResult& solid,
                                            double size) const override {
    const fem::CrackFront& front = solid.fronts.at(0);
    const SweptRelease over = swept_release(tube_, map_, size, front);
    return {
        .rate = over.release, .of_K = over.release * front.mode_energy_ratio, .sweep = over.sweep};
  }

 private:
  TubeWithSurfaceCrack tube_;
  fem::PointMap map_;  ///< of the template; sizes near the given one share it at the crack
  fem::SolidProblem problem_;
};

std::unique_ptr<TurnBody> body_of(TubeWithThroughCrack tube, const TurningCrack& turning) {
  tube.ends = turning.ends;
  if (tube.layers == 0) tube.layers = kTurnLayers;
  return std::make_unique<ThroughCrackBody>(completed(tube), turning.fit);
}

std::unique_ptr<TurnBody> body_of(const TubeWithSurfaceCrack& tube, const TurningCrack&) {
  return std::make_unique<SurfaceCrackBody>(completed(tube));
}

}  // namespace

std::unique_ptr<TurnBody> turn_body(const TurningCrack& turning) {
  return std::visit([&](const auto& tube) { return body_of(tube, turning); }, turning.tube);
}

CupSection sound_cup(const TurningCrack& turning) {
  const TubeSection barrel = std::visit(
      [](const auto& tube) {
        return TubeSection{.outer_diameter = 2 * tube.mean_radius + tube.wall_thickness,
                           .wall_thickness = tube.wall_thickness,
                           .length = tube.length};
      },
      turning.tube);
  return {.barrel = barrel,
          .rim = turning.ends.rim,
          .diaphragm = turning.ends.diaphragm,
          .boss = turning.ends.boss};
}

}  // namespace strainwave::gear_fem
