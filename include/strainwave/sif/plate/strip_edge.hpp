// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/plate/strip_factors.hpp"

namespace strainwave::sif {

/// Edge crack across a long strip, loads [tension, bending, shear, antiplane shear].
///
/// Implements theory manual eqs. (SP-22), (FR-11), (SP-8), (SP-6).  The ends of the strip are free
/// to rotate.  The shear stress results from a transverse force without a moment in the plane of
/// the crack, and is parabolic over the width of the uncracked strip.
struct StripEdgeCrack {
  static constexpr SolutionInfo kInfo{.name = "strip-edge",
                                      .family = "plate",
                                      .title = "Edge crack across a strip",
                                      .modes = "I, II, III",
                                      .equation = "SP-22",
                                      .source = "tada2000",
                                      .basis = Basis::computed,
                                      .relative_uncertainty = 8e-4,
                                      .accuracy =
                                          "mode III exact; I and II fitted to finite elements, "
                                          "within 0.02 %, I 0.07 % at a/w = 0.95",
                                      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 4;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      kTension, LoadInfo{"bending", "Pa", "bending stress at the cracked edge, far away"},
      kTransverseShear, kAntiplaneShear};
  static constexpr std::array<FrontPoint, 1> kPoints = kTip;

  double depth = 0.0;      ///< a [m]; > 0, < width
  double width = 0.0;      ///< width w of the strip, in the direction of the crack [m]
  double thickness = 0.0;  ///< t, length of the front [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("depth", "a", "2 mm"), &StripEdgeCrack::depth);
    field(length_field("width", "w, width of the strip in the direction of the crack", "10 mm"),
          &StripEdgeCrack::width);
    field(length_field("thickness", "t, length of the front", "20 mm"), &StripEdgeCrack::thickness);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth < width, "depth", depth, "m", "depth < width");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.95 * width, "a/w <= 0.95");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {}; }
  [[nodiscard]] double swept_area(double, double) const { return thickness; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double) const {
    const double root = std::sqrt(std::numbers::pi * a);
    const double x = a / width;
    UnitStressIntensity<kLoads> k;
    k.I[0] = edge_crack_factor(StripLoading::tension, x) * root;  // (SP-22)
    k.I[1] = edge_crack_factor(StripLoading::bending, x) * root;  // (SP-22)
    k.II[2] = strip_edge_shear(x) * root;                         // (SP-8)
    k.III[3] = strip_antiplane(x) * root;                         // (SP-6)
    return k;
  }
};

}  // namespace strainwave::sif
