// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/newman_raju.hpp"
#include "strainwave/sif/solution.hpp"

namespace strainwave::sif {

/// Semi-elliptical surface crack in a plate, loads [tension, bending].
///
/// Implements theory manual eqs. (SP-1), (SP-2), (SP-3), both branches of Newman and Raju's fit:
/// shallow (a/c <= 1) and deep (a/c > 1).  The crack grows at constant a/c.
struct PlateSurfaceCrack {
  static constexpr SolutionInfo kInfo{
      .name = "plate-surface",
      .family = "plate",
      .title = "Semi-elliptical surface crack in a plate",
      .modes = "I",
      .equation = "SP-1",
      .source = "newmanraju1984",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.05,
      .accuracy =
          "within 6 % of finite elements from a/c = 0.25, 10 % at the deepest point for a/t = 0.8",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      kTension, LoadInfo{"bending", "Pa", "bending stress at the cracked surface, far away"}};
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"surface", 0.0},
                                                     FrontPoint{"deepest", std::numbers::pi / 2}};

  double depth = 0.0;        ///< a [m]; > 0, <= 0.99 thickness
  double half_length = 0.0;  ///< half length c at the surface [m]; > 0, < half_width
  double thickness = 0.0;    ///< t [m]
  double half_width = 0.0;   ///< b [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "depth", .unit = "m", .doc = "a", .range = kPositive, .example = "2 mm"},
          &PlateSurfaceCrack::depth);
    field(Field{.name = "half_length",
                .unit = "m",
                .doc = "c, half of the length at the surface",
                .range = kPositive,
                .example = "4 mm"},
          &PlateSurfaceCrack::half_length);
    field(
        Field{.name = "thickness", .unit = "m", .doc = "t", .range = kPositive, .example = "10 mm"},
        &PlateSurfaceCrack::thickness);
    field(Field{.name = "half_width",
                .unit = "m",
                .doc = "b, half of the plate's width",
                .range = kPositive,
                .example = "100 mm"},
          &PlateSurfaceCrack::half_width);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(depth >= 0.01 * half_length && depth <= 100 * half_length, "half_length", half_length, "m",
         "0.01 <= depth/half_length <= 100");
    rule(half_length < half_width, "half_length", half_length, "m", "half_length < half_width");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.8 * thickness, "a/t <= 0.8");
    limit(depth >= 0.25 * half_length && depth <= 2 * half_length, "0.25 <= a/c <= 2");
    limit(half_length <= 0.5 * half_width, "c/b <= 0.5");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  /// Half of the front, phi from the surface.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of both halves, dA = 2 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return 2 * a * half_length / depth; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const NewmanRajuPlate fit(depth / half_length);
    const double alpha = a / thickness;
    const double c = a * half_length / depth;
    const double K = fit.tension(alpha, phi) * NewmanRaju::width_factor(c / half_width, alpha) *
                     std::sqrt(std::numbers::pi * a);  // (SP-1)
    return {.I = {K, K * fit.bending_ratio(alpha, phi)}, .II = {}, .III = {}};
  }
};

}  // namespace strainwave::sif
