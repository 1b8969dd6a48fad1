// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "strainwave/sif/plate/common.hpp"

namespace strainwave::sif {

/// Elliptical crack in the middle of a plate's thickness, load [tension].
///
/// Implements theory manual eq. (SP-18), both branches of Newman and Raju's fit.  phi is the
/// parametric angle from the middle plane: x = c cos(phi) along the width, y = a sin(phi) towards
/// the faces.  The crack grows at constant a/c.
struct PlateEllipse {
  static constexpr SolutionInfo kInfo{
      .name = "plate-ellipse",
      .family = "plate",
      .title = "Elliptical crack in the middle of a plate",
      .modes = "I",
      .equation = "SP-18",
      .source = "newmanraju1984",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.05,
      .accuracy = "within 3.5 % of finite elements; up to 9 % above for a/c = 0.25",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 1;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{kTension};
  static constexpr std::array<FrontPoint, 2> kPoints{
      FrontPoint{"middle_plane", 0.0}, FrontPoint{"nearest_face", std::numbers::pi / 2}};

  double half_depth = 0.0;   ///< a, towards the faces [m]; > 0, < thickness/2
  double half_length = 0.0;  ///< half length c along the width [m]; > 0, < half_width
  double thickness = 0.0;    ///< 2 t, the whole [m]
  double half_width = 0.0;   ///< b [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("half_depth", "a, half of the crack's extent through the thickness", "2 mm"),
          &PlateEllipse::half_depth);
    field(length_field("half_length", "c, half of the extent along the width", "4 mm"),
          &PlateEllipse::half_length);
    field(length_field("thickness", "2t, the whole thickness", "10 mm"), &PlateEllipse::thickness);
    field(length_field("half_width", "b, half of the plate's width", "100 mm"),
          &PlateEllipse::half_width);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(2 * half_depth <= 0.99 * thickness, "half_depth", half_depth, "m",
         "2 half_depth <= 0.99 thickness");
    rule(half_depth >= 0.01 * half_length && half_depth <= 100 * half_length, "half_length",
         half_length, "m", "0.01 <= half_depth/half_length <= 100");
    rule(half_length < half_width, "half_length", half_length, "m", "half_length < half_width");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(2 * half_depth <= 0.8 * thickness, "a/t <= 0.8, 2t the thickness");
    limit(half_depth >= 0.2 * half_length && half_depth <= 2 * half_length, "0.2 <= a/c <= 2");
    limit(half_length <= 0.5 * half_width, "c/b <= 0.5");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return half_depth; }
  /// A quarter of the front, phi from the middle plane.
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area of all four quarters, dA = 4 c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const {
    return 4 * a * half_length / half_depth;
  }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const double rho = half_depth / half_length;
    const double alpha = 2 * a / thickness;
    const double c_b = a / rho / half_width;
    const double width =
        1 / std::sqrt(std::cos(std::numbers::pi / 2 * c_b * std::sqrt(alpha)));  // (SP-18)
    const double K = factor(rho, alpha, phi) * width * std::sqrt(std::numbers::pi * a);
    return {.I = {K}, .II = {}, .III = {}};
  }

  /// K_I/(sigma sqrt(pi a)) for a wide plate [-].
  /// @param rho    a/c [-]; > 0
  /// @param alpha  a/t, 2t the thickness [-]; in [0, 1)
  /// @param phi    parametric angle [rad]; in [0, pi/2]
  [[nodiscard]] static double factor(double rho, double alpha, double phi) {
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    const double q = std::min(rho, 1 / rho);
    const double rho15 = rho * std::sqrt(rho);
    const double a2 = alpha * alpha;
    const double root_Q = std::sqrt(1 + 1.464 * std::pow(q, 1.65));  // (SP-18)
    const double M = (rho <= 1 ? 1.0 : std::sqrt(q)) + a2 * 0.05 / (0.11 + rho15) +
                     a2 * a2 * 0.29 / (0.23 + rho15);
    const double g = 1 - a2 * a2 * std::sqrt(2.6 - 2 * alpha) / (1 + 4 * rho) * std::abs(c);
    const double f2 = rho <= 1 ? q * q * c * c + s * s : q * q * s * s + c * c;
    return M * g * std::sqrt(std::sqrt(f2)) / root_Q;  // (SP-18)
  }
};

}  // namespace strainwave::sif
