// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/elastic_members.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quadrature.hpp"

namespace strainwave {

using std::numbers::pi;

double torsional_compliance(const Tube& tube, double shear_modulus) {
  const auto& [D, d, L] = tube;
  require(D > 0, "outer_diameter", D, "m", "outer_diameter > 0");
  require(d >= 0 && d < D, "inner_diameter", d, "m", "0 <= inner_diameter < outer_diameter");
  require(L > 0, "length", L, "m", "length > 0");
  require(shear_modulus > 0, "shear_modulus", shear_modulus, "Pa", "shear_modulus > 0");
  // Factored: D^4 - d^4 = (D^2 + d^2)(D + d)(D - d) loses no digits for thin walls.
  const double J = pi / 32 * (D * D + d * d) * (D + d) * (D - d);
  return L / (shear_modulus * J);  // (ST-2)
}

double torsional_compliance(const AnnularPlate& plate, double shear_modulus) {
  const auto& [D, d, h] = plate;
  require(d > 0, "inner_diameter", d, "m", "inner_diameter > 0");
  require(D > d, "outer_diameter", D, "m", "outer_diameter > inner_diameter");
  require(h > 0, "thickness", h, "m", "thickness > 0");
  require(shear_modulus > 0, "shear_modulus", shear_modulus, "Pa", "shear_modulus > 0");
  const double curvature = 4 * (D - d) * (D + d) / (d * d * D * D);  // 1/r_i^2 - 1/r_o^2
  return curvature / (4 * pi * shear_modulus * h);                   // (ST-3)
}

namespace {

/// Integral of 1/(r^3 (h(r) - depth)) over a diaphragm between two radii.
double twist_integral(const Diaphragm& diaphragm, double depth, double inner, double outer) {
  std::vector<double> joints{inner};
  for (const DiaphragmStation& station : diaphragm.profile)
    if (station.radius > inner && station.radius < outer) joints.push_back(station.radius);
  joints.push_back(outer);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < joints.size(); ++i)
    sum +=
        integrate(
            [&](double r) { return 1 / (r * r * r * (diaphragm_thickness(diaphragm, r) - depth)); },
            joints[i], joints[i + 1], {.relative_tolerance = 1e-12})
            .value;
  return sum;
}

}  // namespace

double torsional_compliance(const Diaphragm& diaphragm, double shear_modulus) {
  if (diaphragm.profile.empty())
    return torsional_compliance(AnnularPlate{.outer_diameter = diaphragm.outer_diameter,
                                             .inner_diameter = diaphragm.inner_diameter,
                                             .thickness = diaphragm.thickness},
                                shear_modulus);
  require(shear_modulus > 0, "shear_modulus", shear_modulus, "Pa", "shear_modulus > 0");
  return twist_integral(diaphragm, 0.0, diaphragm.inner_diameter / 2,
                        diaphragm.outer_diameter / 2) /
         (2 * pi * shear_modulus);  // (TC-13)
}

double groove_compliance(const Diaphragm& diaphragm, const DiaphragmGroove& groove,
                         double shear_modulus) {
  const double inner = groove.radius - groove.width / 2;
  const double outer = groove.radius + groove.width / 2;
  return (twist_integral(diaphragm, groove.depth, inner, outer) -
          twist_integral(diaphragm, 0.0, inner, outer)) /
         (2 * pi * shear_modulus);  // (TC-20)
}

double ring_compliance(int wave_number, double mean_radius, double bending_stiffness) {
  const double R = mean_radius;
  require(wave_number >= 2, "wave_number", wave_number, "1", "wave_number >= 2");
  require(R > 0, "mean_radius", R, "m", "mean_radius > 0");
  require(bending_stiffness > 0, "bending_stiffness", bending_stiffness, "N*m^2",
          "bending_stiffness > 0");
  const double theta = pi / wave_number;
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  return R * R * R / (2 * bending_stiffness) *
         ((theta + s * c) / (2 * s * s) - 1 / theta);  // (ST-10)
}

double ring_moment_factor(int wave_number) {
  require(wave_number >= 2, "wave_number", wave_number, "1", "wave_number >= 2");
  const double theta = pi / wave_number;
  return (1 / theta - 1 / std::tan(theta)) / 2;  // (ST-13)
}

}  // namespace strainwave
