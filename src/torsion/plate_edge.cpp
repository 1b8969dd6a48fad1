// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/plate_edge.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {

namespace {

/// Radius of the edge that the tube stands on.
template <class Real>
const Real& edge_radius(const BasicClampedPlate<Real>& plate) {
  return plate.clamped == ClampedEdge::inner ? plate.outer_radius : plate.inner_radius;
}

/// Amplitudes of the four powers of the radius that satisfy the conditions at the edges.
std::array<double, 4> amplitudes_of(const std::array<std::array<double, 4>, 4>& conditions,
                                    const std::array<double, 4>& wanted) {
  Eigen::Matrix4d matrix;
  Eigen::Vector4d right;
  for (int i = 0; i < 4; ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (int j = 0; j < 4; ++j) matrix(i, j) = conditions[row][static_cast<std::size_t>(j)];
    right(i) = wanted[row];
  }
  const Eigen::Vector4d x = matrix.fullPivLu().solve(right);
  return {x(0), x(1), x(2), x(3)};
}
std::array<DualReal, 4> amplitudes_of(const std::array<std::array<DualReal, 4>, 4>& conditions,
                                      const std::array<double, 4>& wanted) {
  Eigen::Matrix4d matrix;
  Eigen::Vector4d right;
  for (int i = 0; i < 4; ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (int j = 0; j < 4; ++j) matrix(i, j) = conditions[row][static_cast<std::size_t>(j)].value;
    right(i) = wanted[row];
  }
  const auto factor = matrix.fullPivLu();
  const Eigen::Vector4d x = factor.solve(right);
  std::array<DualReal, 4> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = DualReal(x(static_cast<Eigen::Index>(i)));
  for (std::size_t k = 0; k < kDualWidth; ++k) {
    Eigen::Vector4d moved;  // M dx = -dM x: (SN-3) of a linear system
    for (std::size_t i = 0; i < 4; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < 4; ++j)
        sum -= conditions[i][j].partial[k] * result[j].value;  // (SN-3)
      moved(static_cast<Eigen::Index>(i)) = sum;
    }
    const Eigen::Vector4d dx = factor.solve(moved);
    for (std::size_t i = 0; i < 4; ++i) result[i].partial[k] = dx(static_cast<Eigen::Index>(i));
  }
  return result;
}

/// The plate with the deflection f = 1 at the edge that the tube stands on (TC-3).
template <class Real>
struct BentPlate {
  Real edge_force{};         // per length of the edge
  Real clamped_curvature{};  // f'' at the clamped edge
};

template <class Real>
BentPlate<Real> bent_plate(const BasicClampedPlate<Real>& plate, int harmonic) {
  using std::pow;
  const double n = harmonic;
  const Real nu = plate.poissons_ratio;
  const Real rho = plate.inner_radius / plate.outer_radius;
  require(harmonic >= 2, "harmonic", n, "1", "harmonic >= 2");
  require(plate.inner_radius > 0 && rho < 1, "inner_radius", value_of(plate.inner_radius), "m",
          "0 < inner_radius < outer_radius");
  require(plate.thickness > 0, "thickness", value_of(plate.thickness), "m", "thickness > 0");
  const Real D = plate.youngs_modulus * pow(plate.thickness, 3.0) / (12 * (1 - nu * nu));  // (TC-3)
  const bool inside = plate.clamped == ClampedEdge::inner;
  const Real& edge = edge_radius(plate);
  const Real& clamp = inside ? plate.inner_radius : plate.outer_radius;
  // Moments over this scale, because a stiff corner would otherwise hide the other conditions.
  const Real scale = D / edge + plate.corner;
  const Real bends = (inside ? 1.0 : -1.0) * D / edge / scale;
  const Real corner = plate.corner / scale;
  // Deflection r^p cos(n theta).  The positive powers are scaled to 1 at the outer edge and the
  // negative powers at the inner edge, because a high n would otherwise overflow.
  const std::array<double, 4> powers = {n, -n, n + 2, 2 - n};
  std::array<std::array<Real, 4>, 4> conditions;
  std::array<Real, 4> edge_force;
  std::array<Real, 4> curvature;
  for (std::size_t i = 0; i < 4; ++i) {
    const double p = powers[i];
    const Real far = Real(pow(rho, std::abs(p)));
    const Real at_clamp = (p < 0) == inside ? Real(1.0) : far;
    const Real at_edge = (p < 0) == inside ? far : Real(1.0);
    const Real slip = (p - n * n) * corner;  // moment of the corner, over at_edge/edge
    conditions[0][i] = at_clamp;
    conditions[1][i] = p * at_clamp;  // slope, times the radius
    conditions[2][i] = at_edge;       // deflection
    conditions[3][i] = (bends * (p * (p - 1) + nu * (p - n * n)) + slip) * at_edge;
    const double shear = (p * p - n * n) * (p - 2);
    edge_force[i] = -(bends * (shear - (1 - nu) * n * n * (p - 1)) + n * n * slip) * at_edge;
    curvature[i] = p * (p - 1) / (clamp * clamp) * at_clamp;
  }
  const std::array<Real, 4> amplitudes = amplitudes_of(conditions, {0.0, 0.0, 1.0, 0.0});
  BentPlate<Real> bent{.edge_force = Real(0.0), .clamped_curvature = Real(0.0)};
  for (std::size_t i = 0; i < 4; ++i) {
    bent.edge_force += scale * edge_force[i] * amplitudes[i];
    bent.clamped_curvature += curvature[i] * amplitudes[i];
  }
  return bent;
}

template <class Real>
Real edge_stiffness(const BasicClampedPlate<Real>& plate, int harmonic) {
  return std::numbers::pi / edge_radius(plate) * bent_plate(plate, harmonic).edge_force;  // (TC-3)
}

}  // namespace

double plate_edge_stiffness(const ClampedPlate& plate, int harmonic) {
  return edge_stiffness(plate, harmonic);
}
DualReal plate_edge_stiffness(const BasicClampedPlate<DualReal>& plate, int harmonic) {
  return edge_stiffness(plate, harmonic);
}

double clamped_edge_curvature(const ClampedPlate& plate, int harmonic) {
  return bent_plate(plate, harmonic).clamped_curvature;
}

}  // namespace strainwave
