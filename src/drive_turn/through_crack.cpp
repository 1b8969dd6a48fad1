// SPDX-License-Identifier: Apache-2.0
#include "strainwave/crack_influence/through_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sound_wall.hpp"
#include "strainwave/core/error.hpp"
#include "turning_crack.hpp"

namespace strainwave {
namespace {

/// The table holds for nu = 0.3.
constexpr double kLeastRatio = 0.25;
constexpr double kLargestRatio = 0.35;

/// Places along the crack at which the stress is taken, over its half length.  A parabola through
/// the Gauss points is the best fit in the mean up to the third power.
constexpr double kGauss = 0.7745966692414834;
constexpr std::size_t kPlaces = 3;

using OverFaces = std::array<std::array<double, kPlaces>, 2>;

/// Coefficients of 1, zeta, s, s zeta, s^2, s^2 zeta.
std::array<double, FaceTractions::kShapes> fitted(const OverFaces& values) {
  std::array<double, FaceTractions::kShapes> of{};
  for (std::size_t side = 0; side < 2; ++side) {
    std::array<double, kPlaces> f{};
    for (std::size_t i = 0; i < kPlaces; ++i)
      f[i] = (values[1][i] + (side == 0 ? 1.0 : -1.0) * values[0][i]) / 2;
    of[side] = f[1];
    of[2 + side] = (f[2] - f[0]) / (2 * kGauss);
    of[4 + side] = (f[2] + f[0] - 2 * f[1]) / (2 * kGauss * kGauss);
  }
  return of;
}

class TurningThroughCrack : public TurningCrack {
 public:
  TurningThroughCrack(ThroughCrackResponse response, SoundWall wall)
      : response_(std::move(response)), wall_(std::move(wall)) {}

  [[nodiscard]] std::vector<double> stations() const override {
    return {response_.stations().begin(), response_.stations().end()};
  }
  [[nodiscard]] std::vector<StationFactors> at(double from_lobe, double torque) override {
    ThroughCrackState state = response_.state(tractions(from_lobe, torque), pressure_);
    pressure_ = std::move(state.pressure);
    std::vector<StationFactors> K = std::move(state.upper);
    K.insert(K.end(), state.lower.begin(), state.lower.end());
    return K;
  }
  [[nodiscard]] double largest_stress(double from_lobe, double torque) const override {
    const auto normal = tractions(from_lobe, torque).normal;
    return std::abs(normal[0]) + std::abs(normal[1]);
  }

 private:
  [[nodiscard]] FaceTractions tractions(double from_lobe, double torque) const {
    OverFaces normal{};
    OverFaces along{};
    for (std::size_t face = 0; face < 2; ++face)
      for (std::size_t i = 0; i < kPlaces; ++i) {
        const PlaneStress stress = wall_.at(i, face == 0 ? -1.0 : 1.0, from_lobe, torque);
        normal[face][i] = stress.normal;
        along[face][i] = stress.along;
      }
    return {.normal = fitted(normal), .along = fitted(along), .outward = {}};
  }

  ThroughCrackResponse response_;
  SoundWall wall_;
  std::vector<double> pressure_;  ///< of the last state
};

}  // namespace

std::unique_ptr<TurningCrack> turning_crack(const WallThroughCrack& crack, const OvalShell& shell,
                                            double place, const TurnSize& size) {
  const double half_length = size.half_length;
  const double nu = shell.cup.poissons_ratio;
  require(nu >= kLeastRatio && nu <= kLargestRatio, "poissons_ratio", nu, "1",
          fmt::format("from {:g} to {:g}, because K over a turn is tabulated for 0.3", kLeastRatio,
                      kLargestRatio));
  const double wall = shell.cup.barrel.wall_thickness;
  const double radius = (shell.cup.barrel.outer_diameter - wall) / 2;
  require(half_length <= kJudgedLength * radius, "half_length", half_length, "m",
          "at most a sixth of the barrel's radius, beyond which K was not judged; compute K by "
          "strainwave fe turn");
  return std::make_unique<TurningThroughCrack>(
      through_crack_table().at(half_length, wall, radius, crack.angle),
      SoundWall(shell, WallPart::barrel, place, crack.angle,
                {-kGauss * half_length, 0, kGauss * half_length}));
}

}  // namespace strainwave
