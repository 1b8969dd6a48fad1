// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Edge crack normal to the surface beside or below a Hertz line contact, loads [pressure,
/// traction].
///
/// Implements theory manual eqs. (SW-7), (SW-8) with the half-plane's weight function (SW-1), which
/// is the same for K_I and K_II.  The stress along the surface is compressive nearly everywhere
/// below the contact.  K_I < 0 means that the faces are pressed together: the true K_I is 0, and
/// friction of the faces makes |K_II| smaller than stated.  Behind a sliding contact K_I > 0.  The
/// model assumes that the crack does not change the contact and does not contain lubricant.  K_II >
/// 0 if tau_xz > 0, with x along the surface and z into the body.
struct ContactEdgeCrack {
  static constexpr SolutionInfo kInfo{
      .name = "contact-edge",
      .family = "gradient",
      .title = "Edge crack below or beside a line contact",
      .modes = "I, II",
      .equation = "SW-7",
      .source = "johnson1985",
      .basis = Basis::computed,
      .relative_uncertainty = 0.005,
      .accuracy = "stresses exact; K within 3e-4 of its own integral equation, a and |x| <= 10 b",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"pressure", "Pa", "p_0, largest pressure of the contact"},
      LoadInfo{"traction", "Pa", "q_0 = mu p_0, largest traction on this body, toward +x"}};
  static constexpr std::array<FrontPoint, 1> kPoints{FrontPoint{"tip", 0.0}};

  double depth = 0.0;               ///< a [m]; > 0, <= 1000 contact_half_width
  double contact_half_width = 0.0;  ///< b [m]
  double position = 0.0;            ///< x of the crack, from the middle of the contact [m]
  double width = 0.0;               ///< B, length of the front [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &ContactEdgeCrack::depth);
    field(Field{.name = "contact_half_width",
                .unit = "m",
                .doc = "b, half width of the line contact",
                .range = kPositive,
                .example = "0.3 mm"},
          &ContactEdgeCrack::contact_half_width);
    field(Field{.name = "position",
                .unit = "m",
                .doc = "x of the crack, from the middle of the contact",
                .range = kFinite,
                .example = "0.4 mm"},
          &ContactEdgeCrack::position);
    field(kGradientWidth, &ContactEdgeCrack::width);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 1000 * contact_half_width, "depth", depth, "m",
         "depth <= 1000 contact_half_width");
    rule(std::abs(position) <= 1000 * contact_half_width, "position", position, "m",
         "|position| <= 1000 contact_half_width");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 10 * contact_half_width, "a <= 10 b");
    limit(std::abs(position) <= 10 * contact_half_width, "|x| <= 10 b");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] double swept_area(double, double) const { return width; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const EdgeWeight weight(0.0);
    const std::array<double, 2> changes{contact_half_width, std::abs(position)};
    const auto pressure = [&](double z) {
      return hertz_pressure_stress(position, z, contact_half_width);
    };
    const auto traction = [&](double z) {
      return hertz_traction_stress(position, z, contact_half_width);
    };
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, stress, changes));
    };
    return {.I = {K([&](double z) { return pressure(z).along; }),
                  K([&](double z) { return traction(z).along; })},
            .II = {K([&](double z) { return pressure(z).shear; }),
                   K([&](double z) { return traction(z).shear; })},
            .III = {}};  // (SW-7), (SW-8)
  }
};

}  // namespace strainwave::sif
