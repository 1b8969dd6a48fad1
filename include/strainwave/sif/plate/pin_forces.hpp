// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/plate/common.hpp"

namespace strainwave::sif {

/// Through crack opened by two pins, on its perpendicular bisector on both sides; load [force].
///
/// Implements theory manual eq. (SP-23), exact for point forces P in an infinite plate.  The forces
/// act at the distance y from the crack and point away from it; R^2 = a^2 + y^2:
///
///     K_I = (P/t) sqrt(a/pi)/R (1 + (1 + nu)/2 (y/R)^2).
///
/// A pin or a rivet acts as a point force if its hole is small compared with y.
struct PlatePinForces {
  static constexpr SolutionInfo kInfo{
      .name = "plate-pin",
      .family = "plate",
      .title = "Through crack between two pins that pull it open",
      .modes = "I",
      .equation = "SP-23",
      .source = "tada2000",
      .basis = Basis::exact,
      .relative_uncertainty = 0.0,
      .accuracy = "exact for point forces in an infinite plate; derived",
      .constraint = Constraint::plane_stress,
      .reference_stress = "stress of the uncracked plate midway between the pins"};
  static constexpr std::size_t kLoads = 1;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"force", "N", "force of each pin, away from the crack and normal to it"}};
  static constexpr std::array<FrontPoint, 1> kPoints = kTip;

  double half_length = 0.0;     ///< a [m]
  double distance = 0.0;        ///< distance y of each pin from the crack's middle [m]
  double thickness = 0.0;       ///< t [m]
  double poissons_ratio = 0.3;  ///< nu [-]; in (-1, 0.5)

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("half_length", "a", "5 mm"), &PlatePinForces::half_length);
    field(length_field("distance", "y, distance of each pin from the middle of the crack", "10 mm"),
          &PlatePinForces::distance);
    field(length_field("thickness", "t", "2 mm"), &PlatePinForces::thickness);
    field(kPoissonsRatioField, &PlatePinForces::poissons_ratio);
  }
  template <class Rule>
  void check(Rule&&) const {}
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(half_length >= 2 * thickness, "a >= 2 t, plane stress");
  }
  /// Stress of the uncracked plate midway between the pins, per unit of force [1/m^2].
  [[nodiscard]] double gross_stress(std::size_t) const {
    return (3 + poissons_ratio) / (2 * std::numbers::pi * distance * thickness);
  }

  [[nodiscard]] double size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {}; }
  /// Swept area of two tips, dA = 2 t da.
  [[nodiscard]] double swept_area(double, double) const { return 2 * thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const double R2 = a * a + distance * distance;
    const double K = std::sqrt(a / (std::numbers::pi * R2)) / thickness *
                     (1 + (1 + poissons_ratio) / 2 * distance * distance / R2);  // (SP-23)
    return {.I = {K}, .II = {}, .III = {}};
  }
};

}  // namespace strainwave::sif
