// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Semi-elliptical surface crack in a wide plate under a stress that is a cubic of the depth.
///
/// Implements theory manual eqs. (SW-3) to (SW-5), both branches of Newman and Raju's fit, a/c <= 1
/// and > 1.  The crack grows at constant a/c.
struct GradientSurfaceCrack {
  static constexpr SolutionInfo kInfo{
      .name = "gradient-surface",
      .family = "gradient",
      .title = "Semi-elliptical surface crack, cubic stress over the depth",
      .modes = "I",
      .equation = "SW-3",
      .source = "shenglinka1991",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.07,
      .accuracy =
          "uniform and linear stress are Newman and Raju's to rounding (5 %); x^2 and x^3 of exact "
          "penny cracks within 2.2 %",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 4;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"constant", "Pa", "stress at the cracked surface, uniform"},
      LoadInfo{"linear", "Pa", "coefficient of x/t, x from the cracked surface"},
      LoadInfo{"quadratic", "Pa", "coefficient of (x/t)^2"},
      LoadInfo{"cubic", "Pa", "coefficient of (x/t)^3"}};
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"surface", 0.0},
                                                     FrontPoint{"deepest", std::numbers::pi / 2}};

  double depth = 0.0;        ///< a [m]; > 0, <= 0.99 thickness
  double half_length = 0.0;  ///< half length c at the surface [m]; > 0
  double thickness = 0.0;    ///< t [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &GradientSurfaceCrack::depth);
    field(kGradientHalfLength, &GradientSurfaceCrack::half_length);
    field(kGradientThickness, &GradientSurfaceCrack::thickness);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(depth >= 0.01 * half_length && depth <= 100 * half_length, "half_length", half_length, "m",
         "0.01 <= depth/half_length <= 100");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.8 * thickness, "a/t <= 0.8");
    limit(depth >= 0.2 * half_length && depth <= 2 * half_length, "0.2 <= a/c <= 2");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, phi from the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of both halves, dA = 2 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a * half_length / depth; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const SurfaceWeight weight(depth / half_length, a / thickness);
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, phi, stress));
    };
    return {.I = {K([](double) { return 1.0; }), K([&](double x) { return x / thickness; }),
                  K([&](double x) { return std::pow(x / thickness, 2); }),
                  K([&](double x) { return std::pow(x / thickness, 3); })},
            .II = {},
            .III = {}};  // (SW-5)
  }
};

}  // namespace strainwave::sif
