// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/plate/common.hpp"

namespace strainwave::sif {

/// Circular crack inside a body, loads [tension, shear, torsion].
///
/// Implements theory manual eq. (SP-21), exact for an infinite body:
///
///     K_I   = (2/pi) sigma sqrt(pi a),
///     K_II  = 4 tau cos(phi) sqrt(pi a)/(pi (2 - nu)),  K_III = -(1 - nu) tan(phi) K_II,
///     K_III = 4 tau_t sqrt(pi a)/(3 pi) of torsion, tau_t the shear stress at the radius a.
///
/// phi counts from the direction of the shear.  While the crack grows, the stress of the torsion
/// stays proportional to the distance from its axis.
struct BodyPenny {
  static constexpr SolutionInfo kInfo{.name = "body-penny",
                                      .family = "plate",
                                      .title = "Circular crack inside a body",
                                      .modes = "I, II, III",
                                      .equation = "SP-21",
                                      .source = "sneddon1946, kassirsih1966",
                                      .basis = Basis::exact,
                                      .relative_uncertainty = 0.0,
                                      .accuracy = "exact for an infinite body; derived by energy",
                                      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      kTension, LoadInfo{"shear", "Pa", "shear stress on the plane of the crack, far away"},
      LoadInfo{"torsion", "Pa", "shear stress of a twist about the crack's axis, at its radius"}};
  static constexpr std::array<FrontPoint, 2> kPoints{
      FrontPoint{"along_shear", 0.0}, FrontPoint{"across_shear", std::numbers::pi / 2}};

  double radius = 0.0;          ///< a [m]
  double poissons_ratio = 0.3;  ///< nu [-]; in (-1, 0.5)

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("radius", "a", "5 mm"), &BodyPenny::radius);
    field(kPoissonsRatioField, &BodyPenny::poissons_ratio);
  }
  template <class Rule>
  void check(Rule&&) const {}
  template <class Limit>
  void validity(Limit&&) const {}
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return radius; }
  /// The whole front, because the shear slides opposite quarters in opposite senses.
  [[nodiscard]] FrontRange front() const { return {0.0, 2 * std::numbers::pi}; }
  [[nodiscard]] double swept_area(double a, double) const { return a; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const double nu = poissons_ratio;
    const double root = std::sqrt(std::numbers::pi * a);
    const double shear = 4 / (std::numbers::pi * (2 - nu)) * root;
    UnitStressIntensity<kLoads> k;
    k.I[0] = 2 / std::numbers::pi * root;                         // (SP-21)
    k.II[1] = shear * std::cos(phi);                              // (SP-21)
    k.III[1] = -(1 - nu) * shear * std::sin(phi);                 // (SP-21)
    k.III[2] = 4 / (3 * std::numbers::pi) * (a / radius) * root;  // (SP-21)
    return k;
  }
};

}  // namespace strainwave::sif
