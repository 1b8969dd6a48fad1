// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/critical_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"

namespace strainwave {
namespace {

constexpr int kPlanes = 180;  // 1 degree apart; the utilisation is flat at its largest value

/// Least and largest value of a stress.
struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void take(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  void take(const Extremes& other) {
    least = std::min(least, other.least);
    most = std::max(most, other.most);
  }
  [[nodiscard]] double amplitude() const { return (most - least) / 2; }
  [[nodiscard]] double mean() const { return (most + least) / 2; }
};

struct PlaneExtremes {
  Extremes normal;
  Extremes shear;
};

PlaneExtremes on_plane(const WaveStates& states, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  PlaneExtremes extremes;
  for (const SurfaceStress& stress : states) {
    extremes.normal.take(stress.hoop * c * c + 2 * stress.shear * s * c);        // (LI-35)
    extremes.shear.take(-stress.hoop * s * c + stress.shear * (c * c - s * s));  // (LI-35)
  }
  return extremes;
}

double utilisation(const PlaneExtremes& of, const PlaneStrength& strength) {
  const double normal =
      amplitude_without_mean(of.normal.amplitude(), of.normal.mean(), strength.sensitivity);
  const double shear = amplitude_without_mean(of.shear.amplitude(), std::abs(of.shear.mean()),
                                              strength.shear_sensitivity);
  return std::hypot(normal / strength.normal, shear / strength.shear);  // (LI-36)
}

void require_strength(const PlaneStrength& strength) {
  require(strength.normal > 0 && std::isfinite(strength.normal), "normal", strength.normal, "Pa",
          "> 0");
  require(strength.shear > 0 && std::isfinite(strength.shear), "shear", strength.shear, "Pa",
          "> 0");
}

void require_waves(std::span<const WaveStates> waves) {
  require(!waves.empty(), "waves", 0, "1", "at least one wave");
  for (const WaveStates& states : waves) {
    require(!states.empty(), "states", 0, "1", "at least one state");
    for (const SurfaceStress& stress : states)
      require(std::isfinite(stress.hoop) && std::isfinite(stress.shear), "stress", stress.hoop,
              "Pa", "finite numbers");
  }
}

PlaneExtremes both(const PlaneExtremes& a, const PlaneExtremes& b) {
  PlaneExtremes all = a;
  all.normal.take(b.normal);
  all.shear.take(b.shear);
  return all;
}

double angle_of(int plane) { return plane * std::numbers::pi / kPlanes; }

}  // namespace

double surface_factor(double roughness, double tensile_strength) {
  require(roughness >= 0 && std::isfinite(roughness), "roughness", roughness, "m", ">= 0");
  require(tensile_strength > 0 && std::isfinite(tensile_strength), "ultimate_strength",
          tensile_strength, "Pa", "> 0");
  constexpr double kPolished = 1e-6;
  constexpr double kWeakest = 400e6;
  if (roughness <= kPolished) return 1.0;
  const double factor = 1 - 0.22 * std::log10(roughness / kPolished) *
                                std::log10(2 * tensile_strength / kWeakest);  // (LI-34)
  return std::clamp(factor, 0.0, 1.0);
}

CriticalPlane critical_plane(std::span<const WaveStates> waves, const PlaneStrength& strength) {
  require_waves(waves);
  require_strength(strength);
  CriticalPlane worst;
  for (int plane = 0; plane < kPlanes; ++plane) {
    PlaneExtremes all;
    for (const WaveStates& states : waves) all = both(all, on_plane(states, angle_of(plane)));
    const double used = utilisation(all, strength);
    if (plane == 0 || used > worst.utilisation)
      worst = {.angle = angle_of(plane),
               .normal_amplitude = all.normal.amplitude(),
               .normal_mean = all.normal.mean(),
               .shear_amplitude = all.shear.amplitude(),
               .shear_mean = all.shear.mean(),
               .utilisation = used};
  }
  return worst;
}

double plane_damage(std::span<const WaveStates> waves, std::span<const WaveCycles> cycles,
                    const PlaneStrength& strength, double knee_cycles, double slope,
                    MinerRule rule) {
  require_waves(waves);
  require_strength(strength);
  for (const WaveCycles& cycle : cycles) {
    require(cycle.count >= 0 && std::isfinite(cycle.count), "count", cycle.count, "1", ">= 0");
    require(cycle.first < waves.size() && cycle.second < waves.size(), "first",
            static_cast<double>(std::max(cycle.first, cycle.second)), "1", "the number of a wave");
  }
  const WoehlerLine line{
      .knee_amplitude = strength.normal, .knee_cycles = knee_cycles, .slope = slope};
  double worst = 0.0;
  std::vector<PlaneExtremes> of(waves.size());
  for (int plane = 0; plane < kPlanes; ++plane) {
    for (std::size_t i = 0; i < waves.size(); ++i) of[i] = on_plane(waves[i], angle_of(plane));
    double sum = 0.0;
    for (const WaveCycles& cycle : cycles)
      sum += cycle.count *
             damage_per_cycle(
                 line,
                 utilisation(both(of[cycle.first], of[cycle.second]), strength) * strength.normal,
                 rule);  // (LI-37)
    worst = std::max(worst, sum);
  }
  return worst;
}

std::optional<double> handbook_reserve(const HandbookStress& stress, const PlaneStrength& strength,
                                       double specimen_shear) {
  require_strength(strength);
  require(specimen_shear > 0, "specimen_shear", specimen_shear, "Pa", "> 0");
  constexpr double kMeanShear = 0.2;                                  // psi_tau of steel
  const double bending = stress.bending_amplitude / strength.normal;  // 1/S_sigma
  const double shear = stress.shear_amplitude / strength.shear +
                       kMeanShear * stress.shear_mean / specimen_shear;  // 1/S_tau
  const double used = std::hypot(bending, shear);
  if (!(used > 0)) return std::nullopt;
  return 1 / used;  // (LI-38)
}

}  // namespace strainwave
