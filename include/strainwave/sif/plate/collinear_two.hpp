// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include "strainwave/sif/plate/common.hpp"

namespace strainwave::sif {

/// Two equal cracks in line in an infinite plate, loads [tension, shear, antiplane shear].
///
/// Implements theory manual eq. (SP-11), exact: with the tips at d -+ a from the middle,
/// k^2 = 1 - ((d - a)/(d + a))^2 and complete elliptic integrals K and D of that modulus,
///
///     outer tip  K_m = stress sqrt(pi 4 a d/(d + a)) D/K,
///     inner tip  K_m = stress sqrt(pi 4 a d/(d - a)) (1 - D/K).
///
/// The front parameter counts the tips: inner below 1/2, outer above.  Both cracks grow about their
/// middles.
struct PlateCollinearTwo {
  static constexpr SolutionInfo kInfo{
      .name = "plate-collinear-two",
      .family = "plate",
      .title = "Two equal collinear cracks in a plate",
      .modes = "I, II, III",
      .equation = "SP-11",
      .source = "tada2000",
      .basis = Basis::exact,
      .relative_uncertainty = 0.0,
      .accuracy = "exact for an infinite plate; derived, and a singular integral equation agrees",
      .constraint = Constraint::plane_stress};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{kTension, kInPlaneShear, kAntiplaneShear};
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"inner", 0.25},
                                                     FrontPoint{"outer", 0.75}};

  double half_length = 0.0;    ///< a [m]; > 0, < half_distance
  double half_distance = 0.0;  ///< d, half of the distance between the cracks' middles [m]
  double thickness = 0.0;      ///< t [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("half_length", "a, half length of each crack", "5 mm"),
          &PlateCollinearTwo::half_length);
    field(length_field("half_distance", "d, half of the distance between the middles of the cracks",
                       "8 mm"),
          &PlateCollinearTwo::half_distance);
    field(length_field("thickness", "t", "2 mm"), &PlateCollinearTwo::thickness);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(half_length < half_distance, "half_length", half_length, "m",
         "half_length < half_distance");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(half_length >= 2 * thickness, "a >= 2 t, plane stress");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return half_length; }
  [[nodiscard]] FrontRange front() const { return {0.0, 1.0}; }
  /// Swept area of four tips over a parameter of length 1.
  [[nodiscard]] double swept_area(double, double) const { return 4 * thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double s) const {
    const double d = half_distance;
    const double inner = d - a;
    const double outer = d + a;
    // K and D by Carlson's integrals, which stay accurate as the inner tips approach each other.
    const double kc2 = (inner / outer) * (inner / outer);
    const double share =
        boost::math::ellint_rd(0.0, kc2, 1.0) / (3 * boost::math::ellint_rf(0.0, kc2, 1.0));
    const double K = s < 0.5
                         ? std::sqrt(std::numbers::pi * 4 * a * d / inner) * (1 - share)  // (SP-11)
                         : std::sqrt(std::numbers::pi * 4 * a * d / outer) * share;       // (SP-11)
    return {.I = {K, 0.0, 0.0}, .II = {0.0, K, 0.0}, .III = {0.0, 0.0, K}};
  }
};

}  // namespace strainwave::sif
