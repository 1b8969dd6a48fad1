// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/polynomial.hpp"
#include "strainwave/sif/bar/section.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"

namespace strainwave::sif {

/// Annular crack in the surface of a solid bar, loads [force, moment, torque].
///
/// Implements theory manual eqs. (FR-12), (FR-13) in torsion and tension, and (SB-3) in bending.
/// K_I of the moment varies as cos(theta) along the front and is negative on the compressed side.
/// The negative part is valid only while a force keeps the crack open.
struct BarAnnularCrack {
  static constexpr SolutionInfo kInfo{
      .name = "bar-annular",
      .family = "bar",
      .title = "Annular crack in the surface of a solid bar",
      .modes = "I, III",
      .equation = "SB-3",
      .source = "tada2000",
      .basis = Basis::computed,
      .relative_uncertainty = 0.002,
      .accuracy =
          "fits within 0.1 % of axisymmetric finite elements (first harmonic in bending); exact "
          "for shallow and for deep cracks",
      .constraint = Constraint::plane_strain,
      .reference_stress = "P/A, M r/I, T r/(2I) of the uncracked bar at the surface, r = d/2"};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo = kAnnularLoads;
  static constexpr auto kPoints = kAnnularPoints;

  double depth = 0.0;     ///< a [m]; > 0, < diameter/2
  double diameter = 0.0;  ///< d [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kCrackDepth, &BarAnnularCrack::depth);
    field(kBarDiameter, &BarAnnularCrack::diameter);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth < diameter / 2, "depth", depth, "m", "depth < diameter/2");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.48 * diameter, "a/d <= 0.48");
  }
  [[nodiscard]] double gross_stress(std::size_t load) const {
    return section().stress(load, diameter / 2);
  }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, theta from the fibre with the largest tension.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi}; }
  /// Swept area of both halves, dA = 2 r_e da dtheta.
  [[nodiscard]] double swept_area(double a, double) const { return diameter - 2 * a; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double theta) const {
    const AnnularCrackSolid solid{.depth = depth, .diameter = diameter};
    const auto k2 = solid.stress_intensity(a, 0.0);
    const double x = 1 - 2 * a / diameter;
    UnitStressIntensity<kLoads> k =
        annular_intensity(section(), diameter / 2, a, theta, {0.0, bending_factor(x), 0.0});
    k.I[kForce] = k2.I[0];
    k.III[kTorque] = k2.III[1];
    return k;
  }

  /// Bending factor F_b of eq. (SB-3) [-].  @param x  net/gross diameter [-]; in (0, 1]
  [[nodiscard]] static double bending_factor(double x) {
    return 3.0 / 8 * polynomial(kP2, x) / (x * x * std::sqrt(x));  // (SB-3)
  }

 private:
  /// Polynomial p_2: three terms from the neck between two half-spaces, then a fit that ends at the
  /// edge crack.
  static constexpr std::array kP2 = {1.0,         0.5,        0.375,       0.58424627,
                                     -1.86002070, 6.24772954, -7.75789181, 3.90166257};
  [[nodiscard]] RoundSection section() const { return {.outer_radius = diameter / 2}; }
};

}  // namespace strainwave::sif
