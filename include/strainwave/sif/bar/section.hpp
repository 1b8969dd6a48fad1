// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "strainwave/sif/bar/tables.hpp"
#include "strainwave/sif/solution.hpp"

namespace strainwave::sif {

/// Indices of the loads of a bar.
enum BarLoad : std::size_t { kForce = 0, kMoment = 1, kTorque = 2 };

/// The loads of a crack all round a bar.
inline constexpr std::array<LoadInfo, 3> kAnnularLoads{
    LoadInfo{"force", "N", "axial force, tension positive"},
    LoadInfo{"moment", "N*m", "bending moment that pulls at the point theta = 0"},
    LoadInfo{"torque", "N*m", "torque about the axis"}};

/// The loads of a crack on one side.
inline constexpr std::array<LoadInfo, 3> kOneSidedLoads{
    LoadInfo{"force", "N", "axial force, tension positive"},
    LoadInfo{"moment", "N*m", "bending moment that pulls at the middle of the crack"},
    LoadInfo{"torque", "N*m", "torque about the axis"}};

/// Points of one half of a front on one side.
inline constexpr std::array<FrontPoint, 2> kOneSidedPoints{FrontPoint{"middle", 0.0},
                                                           FrontPoint{"surface", 1.0}};

/// Points of a front all round, at the angle theta.
inline constexpr std::array<FrontPoint, 3> kAnnularPoints{
    FrontPoint{"pulled", 0.0}, FrontPoint{"neutral", std::numbers::pi / 2},
    FrontPoint{"pressed", std::numbers::pi}};

/// The fields of most cracks in bars.
inline constexpr Field kCrackDepth{
    .name = "depth", .unit = "m", .doc = "a, the deepest", .range = kPositive, .example = "2 mm"};
inline constexpr Field kBarDiameter{
    .name = "diameter", .unit = "m", .doc = "d", .range = kPositive, .example = "20 mm"};
inline constexpr Field kOuterDiameter{
    .name = "outer_diameter", .unit = "m", .doc = "2 r_o", .range = kPositive, .example = "40 mm"};
inline constexpr Field kInnerDiameter{
    .name = "inner_diameter", .unit = "m", .doc = "2 r_i", .range = kPositive, .example = "24 mm"};
inline constexpr Field kAspectRatio{.name = "aspect_ratio",
                                    .unit = "1",
                                    .doc = "a/c of the ellipse; 1 for a circle",
                                    .range = kPositive,
                                    .example = "0.8"};

inline constexpr Field kPoissonsRatioOfBar{.name = "poissons_ratio",
                                           .unit = "1",
                                           .doc = "nu",
                                           .range = {.lower = -1.0, .upper = 0.5},
                                           .example = "0.3"};

/// Round section, solid or hollow.
///
/// Implements theory manual eq. (SB-1), the nominal stress.
struct RoundSection {
  double outer_radius = 0.0;  ///< r_o [m]; > 0
  double inner_radius = 0.0;  ///< r_i [m]; >= 0, < outer_radius

  /// Thickness of the wall, r_o - r_i [m].
  [[nodiscard]] double wall() const { return outer_radius - inner_radius; }
  /// Area A of the section [m^2].
  [[nodiscard]] double area() const {
    return std::numbers::pi * (outer_radius + inner_radius) * wall();
  }
  /// Second moment I of bending [m^4]; the polar moment I_p is 2 I.
  [[nodiscard]] double second_moment() const {
    return area() * (outer_radius * outer_radius + inner_radius * inner_radius) / 4;
  }
  /// Nominal stress at radius r per unit of a load: 1/A, r/I or r/I_p [1/m^2, 1/m^3].
  [[nodiscard]] double stress(std::size_t load, double r) const {
    if (load == kForce) return 1 / area();            // (SB-1)
    if (load == kMoment) return r / second_moment();  // (SB-1)
    return r / (2 * second_moment());                 // (SB-1)
  }
};

/// K of a crack all round of depth a [m], from its factors [-] on the nominal stress at one radius
/// [m], at the angle theta from the moment's tension [rad].
///
/// Implements theory manual eq. (SB-2): K_I = (F_t sigma + F_b sigma_b cos(theta)) sqrt(pi a),
/// K_III = F_s tau sqrt(pi a).
[[nodiscard]] inline UnitStressIntensity<3> annular_intensity(const RoundSection& section,
                                                              double radius, double a, double theta,
                                                              const std::array<double, 3>& factor) {
  const double root = std::sqrt(std::numbers::pi * a);
  UnitStressIntensity<3> k;
  k.I[kForce] = factor[kForce] * section.stress(kForce, radius) * root;  // (SB-2)
  k.I[kMoment] =
      factor[kMoment] * section.stress(kMoment, radius) * root * std::cos(theta);  // (SB-2)
  k.III[kTorque] = factor[kTorque] * section.stress(kTorque, radius) * root;       // (SB-2)
  return k;
}

/// K of a crack of depth a on one side of a solid bar [m], from its factors on the largest nominal
/// stress.
///
/// Implements theory manual eq. (SB-7).
[[nodiscard]] inline UnitStressIntensity<3> one_sided_intensity(double diameter, double a,
                                                                const OneSidedFactors& factor) {
  const RoundSection section{.outer_radius = diameter / 2};
  const double root = std::sqrt(std::numbers::pi * a);
  UnitStressIntensity<3> k;
  k.I[kForce] = factor.tension * section.stress(kForce, diameter / 2) * root;      // (SB-7)
  k.I[kMoment] = factor.bending * section.stress(kMoment, diameter / 2) * root;    // (SB-7)
  k.II[kTorque] = factor.sliding * section.stress(kTorque, diameter / 2) * root;   // (SB-7)
  k.III[kTorque] = factor.tearing * section.stress(kTorque, diameter / 2) * root;  // (SB-7)
  return k;
}

}  // namespace strainwave::sif
