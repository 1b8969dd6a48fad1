// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "strainwave/sif/plate/common.hpp"

namespace strainwave::sif {

/// Quarter-elliptical crack at the corner of a plate, loads [tension, bending].
///
/// Implements theory manual eqs. (SP-16), (SP-17), both branches of Newman and Raju's fit.  phi is
/// the parametric angle from the face of the plate: x = c cos(phi) along the width, y = a sin(phi)
/// into the thickness.  The crack grows at constant a/c.
struct PlateCornerCrack {
  static constexpr SolutionInfo kInfo{
      .name = "plate-corner",
      .family = "plate",
      .title = "Quarter-elliptical corner crack in a plate",
      .modes = "I",
      .equation = "SP-16",
      .source = "newmanraju1984",
      .basis = Basis::secondary,
      .relative_uncertainty = 0.1,
      .accuracy =
          "above finite elements by up to 10 %, 15 % in the faces; for deeper "
          "or longer cracks 25 %",
      .constraint = Constraint::plane_strain};
  static constexpr std::size_t kLoads = 2;
  static constexpr std::array<LoadInfo, kLoads> kLoadInfo{
      kTension,
      LoadInfo{"bending", "Pa", "bending stress at the face that carries the length, far away"}};
  static constexpr std::array<FrontPoint, 2> kPoints{FrontPoint{"at_length", 0.0},
                                                     FrontPoint{"at_depth", std::numbers::pi / 2}};

  double depth = 0.0;      ///< a, into the thickness [m]; > 0, < thickness
  double length = 0.0;     ///< length c along the width [m]; > 0, < width
  double thickness = 0.0;  ///< t [m]
  double width = 0.0;      ///< b [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(length_field("depth", "a, into the thickness", "2 mm"), &PlateCornerCrack::depth);
    field(length_field("length", "c, along the width", "3 mm"), &PlateCornerCrack::length);
    field(length_field("thickness", "t", "10 mm"), &PlateCornerCrack::thickness);
    field(length_field("width", "b, of the plate", "50 mm"), &PlateCornerCrack::width);
  }
  template <class Rule>
  void check(Rule&& rule) const {
    rule(depth <= 0.99 * thickness, "depth", depth, "m", "depth <= 0.99 thickness");
    rule(depth >= 0.01 * length && depth <= 100 * length, "length", length, "m",
         "0.01 <= depth/length <= 100");
    rule(length < width, "length", length, "m", "length < width");
  }
  template <class Limit>
  void validity(Limit&& limit) const {
    limit(depth <= 0.5 * thickness, "a/t <= 0.5");
    limit(depth >= 0.5 * length && depth <= 2 * length, "0.5 <= a/c <= 2");
    limit(length <= 0.2 * width, "c/b <= 0.2");
  }
  [[nodiscard]] double gross_stress(std::size_t) const { return 1.0; }

  [[nodiscard]] double size() const { return depth; }
  [[nodiscard]] FrontRange front() const { return {0.0, std::numbers::pi / 2}; }
  /// Swept area dA = c da dphi; (FR-3).
  [[nodiscard]] double swept_area(double a, double) const { return a * length / depth; }
  [[nodiscard]] UnitStressIntensity<kLoads> stress_intensity(double a, double phi) const {
    const double rho = depth / length;
    const double alpha = a / thickness;
    const double K = tension(rho, alpha, phi) * width_factor(a / rho / width, alpha) *
                     std::sqrt(std::numbers::pi * a);
    return {.I = {K, K * bending_ratio(rho, alpha, phi)}, .II = {}, .III = {}};
  }

  /// K_I/(sigma sqrt(pi a)) for tension of a wide plate [-].
  /// @param rho    a/c [-]; > 0
  /// @param alpha  a/t [-]; in [0, 1)
  /// @param phi    parametric angle [rad]; in [0, pi/2]
  [[nodiscard]] static double tension(double rho, double alpha, double phi) {
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    const double q = std::min(rho, 1 / rho);
    const double a2 = alpha * alpha;
    const double root_Q = std::sqrt(1 + 1.464 * std::pow(q, 1.65));  // (SP-16)
    if (rho <= 1) {
      const double M = 1.08 - 0.03 * q + a2 * (1.06 / (0.3 + q) - 0.44) +
                       a2 * a2 * (-0.5 + 0.25 * q + 14.8 * std::pow(1 - q, 15));  // (SP-16)
      const double f = std::sqrt(std::sqrt(q * q * c * c + s * s));
      return M * free_faces(a2, s, c) * f / root_Q;  // (SP-16)
    }
    const double M = std::sqrt(q) * (1.08 - 0.03 * q) + q * q * a2 * (0.375 - 0.25 * a2);
    const double f = std::sqrt(std::sqrt(q * q * s * s + c * c));
    return M * free_faces(a2 * q * q, s, c) * f / root_Q;  // (SP-16)
  }

  /// Ratio H of K in bending to K in tension for the same stress at the face [-].
  [[nodiscard]] static double bending_ratio(double rho, double alpha, double phi) {
    const double q = std::min(rho, 1 / rho);
    const double q3 = std::pow(q, 0.75);
    const double H1 =
        rho <= 1 ? 1 - alpha * (0.34 + 0.11 * q)
                 : 1 - alpha * (0.04 + 0.41 * q - alpha * (0.55 - 1.93 * q3 + 1.38 * q3 * q3));
    const double H2 =
        rho <= 1 ? 1 - alpha * (1.22 + 0.12 * q - alpha * (0.64 - 1.05 * q3 + 0.47 * q3 * q3))
                 : 1 - alpha * (2.11 - 0.77 * q - alpha * (0.64 - 0.72 * q3 + 0.14 * q3 * q3));
    return H1 + (H2 - H1) * std::pow(std::sin(phi), 0.2 + q + 0.6 * alpha);  // (SP-17)
  }

  /// Factor f_w for the plate's width [-].
  /// @param c_b    c/b [-]; in [0, 1); the stated accuracy holds up to 0.2
  /// @param alpha  a/t [-]; in [0, 1)
  [[nodiscard]] static double width_factor(double c_b, double alpha) {
    const double x = c_b * std::sqrt(alpha);
    return 1 + x * (-0.2 + x * (9.4 + x * (-19.4 + x * 27.1)));  // (SP-16)
  }

 private:
  /// Factors g_1 g_2 [-].
  /// @param ratio2  square of the shorter semi-axis over the thickness [-]
  /// @param s       sin(phi) [-]
  /// @param c       cos(phi) [-]
  [[nodiscard]] static double free_faces(double ratio2, double s, double c) {
    return (1 + (0.08 + 0.4 * ratio2) * (1 - s) * (1 - s) * (1 - s)) *
           (1 + (0.08 + 0.15 * ratio2) * (1 - c) * (1 - c) * (1 - c));  // (SP-16)
  }
};

}  // namespace strainwave::sif
