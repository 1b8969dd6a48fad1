// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/gradient/stress.hpp"
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {

/// Semi-elliptical surface crack at the root of a notch, fillet or tooth.
///
/// Implements theory manual eqs. (SW-10), (SW-5): the nominal stress of the section of thickness t
/// behind the root, times the stress of the equivalent elliptical notch of the same root radius and
/// concentration. The flanks are treated as flat, which gives an upper bound: by (SW-11), K is at
/// most 14 % too large at a = 0.3 rho, the end of the range.
struct NotchSurfaceCrack {
  static constexpr SolutionInfo kInfo{
      .name = "notch-surface",
      .family = "gradient",
      .title = "Semi-elliptical surface crack at a notch, fillet or tooth root",
      .modes = "I",
      .equation = "SW-10",
      .source = "inglis1913, shenglinka1991",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.1,
      .accuracy =
          "as gradient-surface; the flanks are assumed flat, which makes K up to 14 % too large",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      LoadInfo{"tension", "Pa", "nominal stress of the section behind the root, uniform"},
      LoadInfo{"bending", "Pa", "nominal bending stress of that section at the root"}};
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"surface", 0.0},
                                                     FrontPoint{"deepest", std::numbers::pi / 2}};

  double depth = 0.0;          ///< a [m]; > 0, <= 0.99 thickness
  double half_length = 0.0;    ///< half length c at the surface [m]; > 0
  double thickness = 0.0;      ///< t [m]
  double root_radius = 0.0;    ///< rho, radius of the notch, fillet or tooth root [m]
  double concentration = 0.0;  ///< K_t, largest over nominal stress at the root [-]; > 1

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(kGradientDepth, &NotchSurfaceCrack::depth);
    field(kGradientHalfLength, &NotchSurfaceCrack::half_length);
    field(kGradientThickness, &NotchSurfaceCrack::thickness);
    field(Field{.name = "root_radius",
                .unit = "m",
                .doc = "rho, radius of the notch, fillet or tooth root",
                .range = kPositive,
                .example = "4 mm"},
          &NotchSurfaceCrack::root_radius);
    field(Field{.name = "concentration",
                .unit = "1",
                .doc = "K_t, largest stress over nominal stress at the root",
                .range = {.lower = 1.0, .upper = 1000.0},
                .example = "2"},
          &NotchSurfaceCrack::concentration);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(depth >= 0.01 * half_length && depth <= 100 * half_length, "half_length", half_length, "m",
         "0.01 <= depth/half_length <= 100");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.8 * thickness, "a/t <= 0.8");
    limit(depth >= 0.2 * half_length && depth <= 2 * half_length, "0.2 <= a/c <= 2");
    limit(concentration >= 1.5 && concentration <= 20, "1.5 <= K_t <= 20");
    limit(depth <= 0.3 * root_radius, "a <= 0.3 rho");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, phi from the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of both halves, dA = 2 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a * half_length / depth; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const SurfaceWeight weight(depth / half_length, a / thickness);
    const NotchProfile notch(root_radius, concentration);
    const auto K = [&](const auto& stress) {
      return converged_value(weighted_intensity(weight, a, phi, stress));
    };
    return {.I = {K(notch), K([&](double x) { return notch(x) * bending_profile(x, thickness); })},
            .II = {},
            .III = {}};  // (SW-10)
  }
};

}  // namespace strainwave::sif
