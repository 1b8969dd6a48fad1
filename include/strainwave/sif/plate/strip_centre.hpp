// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/plate/strip_factors.hpp"

namespace strainwave::sif {

/// Centre crack across a long strip, loads [tension, shear, antiplane shear].
///
/// Implements theory manual eqs. (SP-5), (SP-7), (SP-6).  The shear stress results from a
/// transverse force and is parabolic over the width of the uncracked strip.
struct StripCentreCrack {
  static constexpr SolutionInfo kInfo{.name = "strip-centre",
                                      .family = "plate",
                                      .title = "Centre crack across a strip",
                                      .modes = "I, II, III",
                                      .equation = "SP-5",
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

  double half_length = 0.0;  ///< a [m]; > 0, < half_width
  double half_width = 0.0;   ///< b [m]
  double thickness = 0.0;    ///< t [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("half_length", "a", "5 mm"), &StripCentreCrack::half_length);
    field(length_field("half_width", "b, half of the strip's width", "20 mm"),
          &StripCentreCrack::half_width);
    field(length_field("thickness", "t", "2 mm"), &StripCentreCrack::thickness);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(half_length < half_width, "half_length", half_length, "m", "half_length < half_width");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(half_length <= 0.95 * half_width, "a/b <= 0.95");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {}; }
  /// Swept area of two tips, dA = 2 t da.
  [[nodiscard]] double swept_area(double, double) const { return 2 * thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const double root = std::sqrt(std::numbers::pi * a);
    const double x = a / half_width;
    return {.I = {strip_centre_tension(x) * root, 0.0, 0.0},  // (SP-5)
            .II = {0.0, strip_centre_shear(x) * root, 0.0},   // (SP-7)
            .III = {0.0, 0.0, strip_antiplane(x) * root}};    // (SP-6)
  }
};

}  // namespace strainwave::sif
