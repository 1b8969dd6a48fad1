// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/plate/common.hpp"

namespace strainwave::sif {

/// Infinite row of equal collinear cracks in a plate, loads [tension, shear, antiplane shear].
///
/// Implements theory manual eq. (SP-12), exact: K_m = stress sqrt(p tan(pi a/p)), p the distance
/// between the middles of neighbours.  The added compliance is that of one crack.
struct PlateCollinearPeriodic {
  static constexpr SolutionInfo kInfo{
      .name = "plate-collinear-periodic",
      .family = "plate",
      .title = "Row of equal collinear cracks in a plate",
      .modes = "I, II, III",
      .equation = "SP-12",
      .source = "tada2000",
      .basis = Basis::exact,
      .relative_uncertainty = 0.0,
      .accuracy = "exact for an infinite plate; derived, and a singular integral equation agrees",
      .constraint = Constraint::plane_stress};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{kTension, kInPlaneShear, kAntiplaneShear};
  static constexpr std::array<FrontPoint, 1> kPoints = kTip;

  double half_length = 0.0;  ///< a [m]; > 0, < pitch/2
  double pitch = 0.0;        ///< p, distance between the cracks' middles [m]
  double thickness = 0.0;    ///< t [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("half_length", "a, half length of each crack", "5 mm"),
          &PlateCollinearPeriodic::half_length);
    field(length_field("pitch", "p, distance between the middles of neighbours", "15 mm"),
          &PlateCollinearPeriodic::pitch);
    field(length_field("thickness", "t", "2 mm"), &PlateCollinearPeriodic::thickness);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(2 * half_length < pitch, "half_length", half_length, "m", "2 half_length < pitch");
  }
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
    const double K = std::sqrt(pitch * std::tan(std::numbers::pi * a / pitch));  // (SP-12)
    return {.I = {K, 0.0, 0.0}, .II = {0.0, K, 0.0}, .III = {0.0, 0.0, K}};
  }
};

}  // namespace strainwave::sif
