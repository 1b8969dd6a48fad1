// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/plate/strip_factors.hpp"

namespace strainwave::sif {

/// Infinite stack of equal parallel cracks in a plate, loads [tension, shear, antiplane shear].
///
/// Implements theory manual eqs. (SP-14), (SP-15), (SP-13).  Neighbours shield each other in modes
/// I and III: for a dense stack, K -> sigma sqrt(h/2) and tau sqrt(h).  In mode II the layers
/// between the cracks bend, and K is larger than for a single crack.  The added compliance is that
/// of one crack.
struct PlateStackedPeriodic {
  static constexpr SolutionInfo kInfo{
      .name = "plate-stacked-periodic",
      .family = "plate",
      .title = "Stack of equal parallel cracks in a plate",
      .modes = "I, II, III",
      .equation = "SP-14",
      .source = "tada2000",
      .basis = Basis::computed,
      .relative_uncertainty = 1e-4,
      .accuracy = "mode III exact; I and II fitted to finite elements of 5 digits, within 0.002 %",
      .constraint = Constraint::plane_stress};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{kTension, kInPlaneShear, kAntiplaneShear};
  static constexpr std::array<FrontPoint, 1> kPoints = kTip;

  double half_length = 0.0;  ///< half length a of each crack [m]
  double spacing = 0.0;      ///< spacing h between neighbours [m]
  double thickness = 0.0;    ///< t [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("half_length", "a, half length of each crack", "5 mm"),
          &PlateStackedPeriodic::half_length);
    field(length_field("spacing", "h, distance between neighbours", "10 mm"),
          &PlateStackedPeriodic::spacing);
    field(length_field("thickness", "t", "2 mm"), &PlateStackedPeriodic::thickness);
  }
  template <class Rule>
  void check(Rule&&) const {}
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(half_length >= 2 * thickness, "a >= 2 t, plane stress");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {}; }
  /// Swept area of the two tips of one crack.
  [[nodiscard]] double swept_area(double, double) const { return 2 * thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const double x = a / spacing;
    const double root = std::sqrt(spacing);
    return {.I = {root * stack_tension(x), 0.0, 0.0},                               // (SP-14)
            .II = {0.0, root * stack_shear(x), 0.0},                                // (SP-15)
            .III = {0.0, 0.0, root * std::sqrt(std::tanh(std::numbers::pi * x))}};  // (SP-13)
  }
};

}  // namespace strainwave::sif
