// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/plate/strip_factors.hpp"

namespace strainwave::sif {

/// Two equal edge cracks opposite each other across a long strip, loads [tension, shear, antiplane
/// shear].
///
/// Implements theory manual eqs. (SP-9), (SP-10), (SP-6).  The shear stress results from a
/// transverse force and is parabolic over the width of the uncracked strip.
struct StripDoubleEdgeCrack {
  static constexpr SolutionInfo kInfo{.name = "strip-double-edge",
                                      .family = "plate",
                                      .title = "Two opposite edge cracks across a strip",
                                      .modes = "I, II, III",
                                      .equation = "SP-9",
                                      .source = "tada2000",
                                      .basis = Basis::computed,
                                      .relative_uncertainty = 2e-4,
                                      .accuracy =
                                          "mode III exact; I and II fitted to finite elements of 5 "
                                          "digits, within 0.02 %; plane stress: "
                                          "cracks of at least twice the thickness",
                                      .constraint = Constraint::plane_stress};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{kTension, kTransverseShear,
                                                          kAntiplaneShear};
  static constexpr std::array<FrontPoint, 1> kPoints = kTip;

  double depth = 0.0;       ///< a, depth of each crack [m]; > 0, < half_width
  double half_width = 0.0;  ///< b [m]
  double thickness = 0.0;   ///< t [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("depth", "a, depth of each crack", "2 mm"), &StripDoubleEdgeCrack::depth);
    field(length_field("half_width", "b, half of the strip's width", "10 mm"),
          &StripDoubleEdgeCrack::half_width);
    field(length_field("thickness", "t", "2 mm"), &StripDoubleEdgeCrack::thickness);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth < half_width, "depth", depth, "m", "depth < half_width");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.95 * half_width, "a/b <= 0.95");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  /// Swept area of both cracks, dA = 2 t da.
  [[nodiscard]] double swept_area(double, double) const { return 2 * thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const double root = std::sqrt(std::numbers::pi * a);
    const double x = a / half_width;
    return {.I = {strip_double_edge_tension(x) * root, 0.0, 0.0},  // (SP-9)
            .II = {0.0, strip_double_edge_shear(x) * root, 0.0},   // (SP-10)
            .III = {0.0, 0.0, strip_antiplane(x) * root}};         // (SP-6)
  }
};

}  // namespace strainwave::sif
