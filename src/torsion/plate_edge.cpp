// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/plate_edge.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {

double plate_edge_stiffness(const ClampedPlate& plate, int harmonic) {
  const double n = harmonic;
  const double nu = plate.poissons_ratio;
  const double rho = plate.inner_radius / plate.outer_radius;
  require(harmonic >= 2, "harmonic", n, "1", "harmonic >= 2");
  require(plate.inner_radius > 0 && rho < 1, "inner_radius", plate.inner_radius, "m",
          "0 < inner_radius < outer_radius");
  require(plate.thickness > 0, "thickness", plate.thickness, "m", "thickness > 0");
  const double D =
      plate.youngs_modulus * std::pow(plate.thickness, 3) / (12 * (1 - nu * nu));  // (TC-3)
  // Deflection r^p cos(n theta), r over the outer radius.  The negative powers are scaled to 1 at
  // the inner edge, where they matter, because a high n would otherwise overflow.
  const std::array<double, 4> powers = {n, -n, n + 2, 2 - n};
  Eigen::Matrix4d conditions;
  Eigen::Vector4d edge_shear;
  for (int i = 0; i < 4; ++i) {
    const double p = powers[static_cast<std::size_t>(i)];
    const double at_inner = p < 0 ? 1.0 : std::pow(rho, p);
    const double at_outer = p < 0 ? std::pow(rho, -p) : 1.0;
    conditions(0, i) = at_inner;
    conditions(1, i) = p * at_inner;                                 // slope, times r_i
    conditions(2, i) = at_outer;                                     // deflection
    conditions(3, i) = (p * (p - 1) + nu * (p - n * n)) * at_outer;  // moment M_r
    edge_shear(i) =
        -((p * p - n * n) * (p - 2) - (1 - nu) * n * n * (p - 1)) * at_outer;  // Kirchhoff's V_r
  }
  const Eigen::Vector4d amplitudes =
      conditions.fullPivLu().solve(Eigen::Vector4d(0.0, 0.0, 1.0, 0.0));
  const double R = plate.outer_radius;
  return std::numbers::pi * D / (R * R) * edge_shear.dot(amplitudes);  // (TC-3)
}

}  // namespace strainwave
