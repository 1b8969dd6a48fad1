// SPDX-License-Identifier: Apache-2.0
#include "strainwave/laminate/ply_failure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace strainwave {
namespace {

using std::numbers::pi;

/// Coefficients of the criterion of Tsai and Wu.
struct Criterion {
  double f1, f2, f11, f22, f12, f66;

  explicit Criterion(const LaminaStrength& s)
      : f1(1 / s.fibre_tension - 1 / s.fibre_compression),
        f2(1 / s.transverse_tension - 1 / s.transverse_compression),
        f11(1 / (s.fibre_tension * s.fibre_compression)),
        f22(1 / (s.transverse_tension * s.transverse_compression)),
        f12(-std::sqrt(f11 * f22) / 2),
        f66(1 / (s.shear * s.shear)) {}

  [[nodiscard]] double quadratic(const LaminaStress& a, const LaminaStress& b) const {
    return f11 * a.along * b.along + f22 * a.across * b.across + f66 * a.shear * b.shear +
           f12 * (a.along * b.across + a.across * b.along);
  }
  [[nodiscard]] double linear(const LaminaStress& a) const { return f1 * a.along + f2 * a.across; }
};

/// Stress in the axes of the fibres from the strain in the axes of the wall.
LaminaStress stress_of(const LaminatePly<double>& ply, const std::array<double, 3>& strain) {
  const double c = std::cos(ply.angle);
  const double s = std::sin(ply.angle);
  const auto& [x, y, xy] = strain;
  const std::array<double, 3> own = {c * c * x + s * s * y + c * s * xy,
                                     s * s * x + c * c * y - c * s * xy,
                                     2 * c * s * (y - x) + (c * c - s * s) * xy};
  const std::array<double, 3> stress = reduced_stiffness(ply.lamina).times(own);
  return {.along = stress[0], .across = stress[1], .shear = stress[2]};
}

}  // namespace

double tsai_wu(const LaminaStress& stress, const LaminaStrength& strength) {
  const Criterion criterion(strength);
  return criterion.quadratic(stress, stress) + criterion.linear(stress);  // (LA-12)
}

std::optional<double> tsai_wu_factor(const LaminaStress& fixed, const LaminaStress& scaled,
                                     const LaminaStrength& strength) {
  const Criterion criterion(strength);
  const double a = criterion.quadratic(scaled, scaled);
  const double b = 2 * criterion.quadratic(fixed, scaled) + criterion.linear(scaled);
  const double c = tsai_wu(fixed, strength) - 1;
  if (c >= 0) return 0.0;
  if (a == 0) return std::nullopt;  // without the loads; else a > 0, because the form is definite
  // The stable form of the positive root of a f^2 + b f + c = 0.
  const double root = std::sqrt(b * b - 4 * a * c);
  return b > 0 ? -2 * c / (b + root) : (root - b) / (2 * a);  // (LA-14)
}

std::optional<double> strain_factor(const LaminaStress& fixed, const LaminaStress& scaled,
                                    const Lamina<>& lamina, const LaminaStrength& strength) {
  // Strains times the modulus of their direction, so that the limits are the strengths.
  const double nu21 = lamina.nu12 * lamina.E2 / lamina.E1;
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](double of_fixed, double of_scaled, double tension, double compression) {
    if (of_fixed >= tension || of_fixed <= -compression)
      least = 0;
    else if (of_scaled > 0)
      least = std::min(least, (tension - of_fixed) / of_scaled);  // (LA-13)
    else if (of_scaled < 0)
      least = std::min(least, (-compression - of_fixed) / of_scaled);
  };
  const auto along = [&](const LaminaStress& s) { return s.along - lamina.nu12 * s.across; };
  const auto across = [&](const LaminaStress& s) { return s.across - nu21 * s.along; };
  take(along(fixed), along(scaled), strength.fibre_tension, strength.fibre_compression);
  take(across(fixed), across(scaled), strength.transverse_tension, strength.transverse_compression);
  take(fixed.shear, scaled.shear, strength.shear, strength.shear);
  if (!std::isfinite(least)) return std::nullopt;
  return least;
}

namespace {

/// Shares of amplitude and mean in the Haigh lines along, across and in shear.
struct HaighShares {
  std::array<double, 3> amplitude{};
  std::array<double, 3> mean{};

  HaighShares(const LaminaStress& a, const LaminaStress& m, const LaminaStrength& strength,
              const LaminaEndurance& endurance)
      : amplitude{std::abs(a.along) / endurance.fibre, std::abs(a.across) / endurance.transverse,
                  std::abs(a.shear) / endurance.shear},
        mean{m.along > 0 ? m.along / strength.fibre_tension : -m.along / strength.fibre_compression,
             m.across > 0 ? m.across / strength.transverse_tension
                          : -m.across / strength.transverse_compression,
             std::abs(m.shear) / strength.shear} {}
};

}  // namespace

PlyEndurance ply_endurance(const LaminaStress& amplitude, const LaminaStress& mean,
                           const LaminaStrength& strength, const LaminaEndurance& endurance) {
  const HaighShares share(amplitude, mean, strength, endurance);
  return {.fibre = share.amplitude[0] + share.mean[0],
          .matrix = std::hypot(share.amplitude[1] + share.mean[1],
                               share.amplitude[2] + share.mean[2])};  // (LA-19)
}

std::optional<double> endurance_factor(const LaminaStress& amplitude, const LaminaStress& mean,
                                       const LaminaStrength& strength,
                                       const LaminaEndurance& endurance) {
  const HaighShares share(amplitude, mean, strength, endurance);
  const auto& [a1, a2, a6] = share.amplitude;
  const auto& [m1, m2, m6] = share.mean;
  const double left = 1 - a2 * a2 - a6 * a6;
  if (a1 >= 1 || left <= 0) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  if (m1 > 0) least = (1 - a1) / m1;
  const double square = m2 * m2 + m6 * m6;
  // The stable form of the positive root of |a + f m|^2 = 1.
  const double along = a2 * m2 + a6 * m6;
  if (square > 0)
    least = std::min(least, left / (along + std::sqrt(along * along + square * left)));
  if (!std::isfinite(least)) return std::nullopt;
  return least;
}

std::vector<PlyFace> ply_stresses(std::span<const LaminatePly<double>> plies, double thickness,
                                  const TubeLoads& loads) {
  const LaminateStiffness<double> wall = laminate_stiffness(plies, thickness);
  const double r = loads.radius;
  const std::array<double, 3> force = {loads.axial_force / (2 * pi * r), 0.0,
                                       -loads.torque / (2 * pi * r * r)};
  const std::array<double, 3> strain = inverse(wall.A).times(force);  // (LA-11)
  const double neutral = wall.B.m22 / wall.A.m22;
  double sum = 0.0;
  for (const LaminatePly<double>& ply : plies) sum += ply.thickness;
  std::vector<PlyFace> faces;
  double below = 0.0;
  for (std::size_t i = 0; i < plies.size(); ++i) {
    for (const bool outer : {false, true}) {
      const double z =
          (below + (outer ? plies[i].thickness : 0.0)) / sum * thickness - thickness / 2;
      faces.push_back(
          {.ply = i,
           .outer = outer,
           .load = stress_of(plies[i], strain),
           .assembly = stress_of(plies[i], {0.0, loads.curvature * (z - neutral), 0.0})});
    }
    below += plies[i].thickness;
  }
  return faces;
}

}  // namespace strainwave
