// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Edge crack in a strip under a stress that is a cubic of the depth.
///
/// Implements theory manual eqs. (SW-1), (SW-2): sigma = A_0 + A_1 x/t + A_2 (x/t)^2 + A_3 (x/t)^3,
/// x from the cracked surface.  The ends of the strip are free to move and to rotate, which gives
/// an upper bound for a section held by its neighbours.
struct GradientEdgeCrack {
  static constexpr SolutionInfo kInfo{
      .name = "gradient-edge",
      .family = "gradient",
      .title = "Edge crack, cubic stress over the depth",
      .modes = "I",
      .equation = "SW-1",
      .source = "-",
      .basis = Basis::computed,
      .relative_uncertainty = 0.001,
      .accuracy =
          "within 2e-5 of its own integral equation, which Gross and Srawley meet within 0.7 %",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 4;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"constant", "Pa", "stress at the cracked surface, uniform"},
      LoadInfo{"linear", "Pa", "coefficient of x/t, x from the cracked surface"},
      LoadInfo{"quadratic", "Pa", "coefficient of (x/t)^2"},
      LoadInfo{"cubic", "Pa", "coefficient of (x/t)^3"}};
  static constexpr std::array<FrontPoint, 1> kPoints{FrontPoint{"tip", 0.0}};

  double depth = 0.0;      ///< a [m]; > 0, <= 0.99 thickness
  double thickness = 0.0;  ///< t [m]
  double width = 0.0;      ///< B, length of the front [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &GradientEdgeCrack::depth);
    field(kGradientThickness, &GradientEdgeCrack::thickness);
    field(kGradientWidth, &GradientEdgeCrack::width);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.9 * thickness, "a/t <= 0.9");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] double swept_area(double, double) const { return width; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const EdgeWeight weight(a / thickness);
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, stress));
    };
    return {.I = {K([](double) { return 1.0; }), K([&](double x) { return x / thickness; }),
                  K([&](double x) { return std::pow(x / thickness, 2); }),
                  K([&](double x) { return std::pow(x / thickness, 3); })},
            .II = {},
            .III = {}};  // (SW-1)
  }
};

}  // namespace strainwave::sif
