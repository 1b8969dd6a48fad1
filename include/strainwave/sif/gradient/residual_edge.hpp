// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Edge crack in a strip under applied and residual stress.
///
/// Implements theory manual eq. (SW-6) with (SW-1).  While the faces are open, superposition is
/// valid: the applied loads and the residual stress give K_max, K_min and R = K_min/K_max.  A
/// negative K means that the faces touch.  The true K and its added compliance are then 0, but this
/// solution cannot give the distribution of the contact along the faces.  The residual stress is in
/// equilibrium over the uncracked section; K describes its release by the crack.
struct ResidualEdgeCrack {
  static constexpr SolutionInfo kInfo{
      .name = "residual-edge",
      .family = "gradient",
      .title = "Edge crack in a residual stress field",
      .modes = "I",
      .equation = "SW-6",
      .source = "-",
      .basis = Basis::computed,
      .relative_uncertainty = 0.005,
      .accuracy = "within 1e-4 of its own integral equation for a stress as exp(-10 x/a)",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      kTension, LoadInfo{"bending", "Pa", "bending stress at the cracked surface, far away"},
      LoadInfo{"residual", "Pa", "residual stress at the surface; negative after peening"}};
  static constexpr std::array<FrontPoint, 1> kPoints{FrontPoint{"tip", 0.0}};

  double depth = 0.0;      ///< a [m]; > 0, <= 0.99 thickness
  double thickness = 0.0;  ///< t [m]
  double width = 0.0;      ///< B, length of the front [m]
  double decay = 0.0;      ///< delta, depth in which the residual stress decays [m]
  double hump = 0.0;       ///< h; above 1 the largest value is below the surface [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &ResidualEdgeCrack::depth);
    field(kGradientThickness, &ResidualEdgeCrack::thickness);
    field(kGradientWidth, &ResidualEdgeCrack::width);
    field(Field{.name = "decay",
                .unit = "m",
                .doc = "delta, depth in which the residual stress decays",
                .range = kPositive,
                .example = "0.3 mm"},
          &ResidualEdgeCrack::decay);
    field(Field{.name = "hump",
                .unit = "1",
                .doc = "h; above 1 the largest residual stress is below the surface",
                .range = {.lower = 0.0, .lower_open = false, .upper = 5.0, .upper_open = false},
                .example = "1.5"},
          &ResidualEdgeCrack::hump);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(decay * (1 + hump) <= thickness / 5, "decay", decay, "m",
         "decay (1 + hump) <= thickness/5");
    rule(depth <= 1000 * decay, "depth", depth, "m", "depth <= 1000 decay");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.9 * thickness, "a/t <= 0.9");
    limit(depth <= 10 * decay, "a <= 10 delta");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] double swept_area(double, double) const { return width; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const EdgeWeight weight(a / thickness);
    const ResidualProfile residual(decay, hump, thickness);
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, stress));
    };
    return {.I = {K([](double) { return 1.0; }),
                  K([&](double x) { return bending_profile(x, thickness); }), K(residual)},
            .II = {},
            .III = {}};  // (SW-6)
  }
};

}  // namespace strainwave::sif
