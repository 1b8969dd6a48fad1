// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Semi-elliptical surface crack in a wide plate under applied and residual stress.
///
/// Implements theory manual eq. (SW-6) with (SW-5).  While the faces are open, superposition is
/// valid: the applied loads and the residual stress give K_max, K_min and R = K_min/K_max.  A
/// negative K means that the faces touch.  The true K and its added compliance are then 0, but this
/// solution cannot give the distribution of the contact along the faces.  The residual stress is in
/// equilibrium over the uncracked section; K describes its release by the crack.
struct ResidualSurfaceCrack {
  static constexpr SolutionInfo kInfo{
      .name = "residual-surface",
      .family = "gradient",
      .title = "Semi-elliptical surface crack in a residual stress field",
      .modes = "I",
      .equation = "SW-6",
      .source = "shenglinka1991",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.1,
      .accuracy =
          "as gradient-surface; of an exact penny crack under exp(-x/delta) 8 % low at the deepest "
          "point for a = 4 delta, 2 % for 2 delta",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      kTension, LoadInfo{"bending", "Pa", "bending stress at the cracked surface, far away"},
      LoadInfo{"residual", "Pa", "residual stress at the surface; negative after peening"}};
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"surface", 0.0},
                                                     FrontPoint{"deepest", std::numbers::pi / 2}};

  double depth = 0.0;        ///< a [m]; > 0, <= 0.99 thickness
  double half_length = 0.0;  ///< half length c at the surface [m]; > 0
  double thickness = 0.0;    ///< t [m]
  double decay = 0.0;        ///< delta, depth in which the residual stress decays [m]
  double hump = 0.0;         ///< h; above 1 the largest value is below the surface [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &ResidualSurfaceCrack::depth);
    field(kGradientHalfLength, &ResidualSurfaceCrack::half_length);
    field(kGradientThickness, &ResidualSurfaceCrack::thickness);
    field(Field{.name = "decay",
                .unit = "m",
                .doc = "delta, depth in which the residual stress decays",
                .range = kPositive,
                .example = "0.3 mm"},
          &ResidualSurfaceCrack::decay);
    field(Field{.name = "hump",
                .unit = "1",
                .doc = "h; above 1 the largest residual stress is below the surface",
                .range = {.lower = 0.0, .lower_open = false, .upper = 5.0, .upper_open = false},
                .example = "1.5"},
          &ResidualSurfaceCrack::hump);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(depth >= 0.01 * half_length && depth <= 100 * half_length, "half_length", half_length, "m",
         "0.01 <= depth/half_length <= 100");
    rule(decay * (1 + hump) <= thickness / 5, "decay", decay, "m",
         "decay (1 + hump) <= thickness/5");
    rule(depth <= 20 * decay, "depth", depth, "m", "depth <= 20 decay");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.8 * thickness, "a/t <= 0.8");
    limit(depth >= 0.2 * half_length && depth <= 2 * half_length, "0.2 <= a/c <= 2");
    limit(depth <= 4 * decay, "a <= 4 delta");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, phi from the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of both halves, dA = 2 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a * half_length / depth; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const SurfaceWeight weight(depth / half_length, a / thickness);
    const ResidualProfile residual(decay, hump, thickness);
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, phi, stress));
    };
    return {.I = {K([](double) { return 1.0; }),
                  K([&](double x) { return bending_profile(x, thickness); }), K(residual)},
            .II = {},
            .III = {}};  // (SW-6)
  }
};

}  // namespace strainwave::sif
