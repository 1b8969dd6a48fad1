// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>

#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/plate/common.hpp"

namespace strainwave::sif {

/// Elliptical crack inside a body, loads [tension, shear along the major axis, shear along the
/// minor axis].
///
/// Implements theory manual eqs. (SP-19), (FR-10) and (SP-20), exact for an infinite body.  phi is
/// the parametric angle from the major axis: x = c cos(phi), y = a sin(phi).
struct BodyEllipse {
  static constexpr SolutionInfo kInfo{.name = "body-ellipse",
                                      .family = "plate",
                                      .title = "Elliptical crack inside a body",
                                      .modes = "I, II, III",
                                      .equation = "SP-19",
                                      .source = "kassirsih1966",
                                      .basis = Basis::exact,
                                      .relative_uncertainty = 0.0,
                                      .accuracy = "exact for an infinite body; derived by energy",
                                      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 3;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      kTension, LoadInfo{"shear_major", "Pa", "shear stress along the major axis, far away"},
      LoadInfo{"shear_minor", "Pa", "shear stress along the minor axis, far away"}};
  static constexpr std::array<FrontPoint, 2> kPoints{
      FrontPoint{"end_of_major_axis", 0.0}, FrontPoint{"end_of_minor_axis", std::numbers::pi / 2}};

  double semi_minor = 0.0;      ///< a [m]; > 0, <= semi_major
  double semi_major = 0.0;      ///< c [m]
  double poissons_ratio = 0.3;  ///< nu [-]; in (-1, 0.5)

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("semi_minor", "a, half of the minor axis", "2 mm"),
          &BodyEllipse::semi_minor);
    field(length_field("semi_major", "c, half of the major axis", "5 mm"),
          &BodyEllipse::semi_major);
    field(kPoissonsRatioField, &BodyEllipse::poissons_ratio);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(semi_minor <= semi_major, "semi_minor", semi_minor, "m", "semi_minor <= semi_major");
  }
  template <class Limit>
  void validity(Limit&&) const {}
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return semi_minor; }
  /// The whole front, because shear slides opposite quarters in opposite senses.
  [[nodiscard]] FrontRange front() const { return {0.0, 2 * std::numbers::pi}; }
  /// Swept area dA = c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return a * semi_major / semi_minor; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const double rho = semi_minor / semi_major;
    const double nu = poissons_ratio;
    const double k = std::sqrt(std::max(0.0, (1 - rho) * (1 + rho)));
    const double E = boost::math::ellint_2(k);
    const double D = boost::math::ellint_rd(0.0, rho * rho, 1.0) / 3;
    const double minor = E - nu * rho * rho * D;
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    const double root = std::sqrt(std::numbers::pi * a);
    const double f = std::sqrt(std::sqrt(s * s + rho * rho * c * c));
    const KassirSih major(rho, nu);
    UnitStressIntensity<kLoads> k_m;
    k_m.I[0] = root * f / E;                               // (SP-19)
    k_m.II[1] = root * major.factor_II(phi);               // (FR-10)
    k_m.III[1] = -root * major.factor_III(phi);            // (FR-10)
    k_m.II[2] = root * s / (minor * f);                    // (SP-20)
    k_m.III[2] = root * (1 - nu) * rho * c / (minor * f);  // (SP-20)
    return k_m;
  }
};

}  // namespace strainwave::sif
