// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Edge crack at the root of a notch, fillet or tooth.
///
/// Implements theory manual eqs. (SW-10), (SW-11): the nominal stress of the section of thickness t
/// behind the root, times the stress of the equivalent elliptical notch of the same root radius and
/// concentration. For a << rho the result is that of a shallow crack under K_t sigma; for a >> rho
/// it is that of an edge crack with the combined depth of notch and crack.
struct NotchEdgeCrack {
  static constexpr SolutionInfo kInfo{.name = "notch-edge",
                                      .family = "gradient",
                                      .title = "Edge crack at a notch, fillet or tooth root",
                                      .modes = "I",
                                      .equation = "SW-10",
                                      .source = "inglis1913",
                                      .basis = Basis::computed,
                                      .relative_uncertainty = 0.05,
                                      .accuracy =
                                          "flanks within 0.5 % of own cracks at elliptical holes, "
                                          "1 <= D/rho <= 100; model of the section not compared",
                                      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"tension", "Pa", "nominal stress of the section behind the root, uniform"},
      LoadInfo{"bending", "Pa", "nominal bending stress of that section at the root"}};
  static constexpr std::array<FrontPoint, 1> kPoints{FrontPoint{"tip", 0.0}};

  double depth = 0.0;          ///< a [m]; > 0, <= 0.99 thickness
  double thickness = 0.0;      ///< t [m]
  double width = 0.0;          ///< B, length of the front [m]
  double root_radius = 0.0;    ///< rho, radius of the notch, fillet or tooth root [m]
  double concentration = 0.0;  ///< K_t, largest over nominal stress at the root [-]; > 1

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &NotchEdgeCrack::depth);
    field(kGradientThickness, &NotchEdgeCrack::thickness);
    field(kGradientWidth, &NotchEdgeCrack::width);
    field(Field{.name = "root_radius",
                .unit = "m",
                .doc = "rho, radius of the notch, fillet or tooth root",
                .range = kPositive,
                .example = "4 mm"},
          &NotchEdgeCrack::root_radius);
    field(Field{.name = "concentration",
                .unit = "1",
                .doc = "K_t, largest stress over nominal stress at the root",
                .range = {.lower = 1.0, .upper = 1000.0},
                .example = "2"},
          &NotchEdgeCrack::concentration);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.9 * thickness, "a/t <= 0.9");
    limit(concentration >= 1.5 && concentration <= 20, "1.5 <= K_t <= 20");
    limit(root_radius <= thickness / 2, "rho <= t/2");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] double swept_area(double, double) const { return width; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const EdgeWeight weight(a / thickness);
    const NotchProfile notch(root_radius, concentration);
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, stress));
    };
    return {.I = {notch.flank_factor(a) * K(notch), notch.flank_factor(a) * K([&](double x) {
                                                      return notch(x) *
                                                             bending_profile(x, thickness);
                                                    })},
            .II = {},
            .III = {}};  // (SW-11)
  }
};

}  // namespace strainwave::sif
