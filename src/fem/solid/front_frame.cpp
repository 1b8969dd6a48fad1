// SPDX-License-Identifier: Apache-2.0
#include "front_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strainwave::fem::solid {
namespace {

/// Gauss points on a face; `toward` is the coordinate (0 or 1) that starts at a crack front.
/// Points are denser near the front, so the inverse root is integrated accurately too.
dealii::Quadrature<2> face_points(unsigned n, std::optional<unsigned> toward) {
  dealii::Quadrature<2> rule = dealii::QGauss<2>(n);
  if (!toward) return rule;
  std::vector<Point<2>> points = rule.get_points();
  std::vector<double> weights = rule.get_weights();
  for (std::size_t q = 0; q < points.size(); ++q) {
    const double s = points[q][*toward];
    points[q][*toward] = s * s;
    weights[q] *= 2 * s;
  }
  return {points, weights};
}

}  // namespace

Tensor2 crack_tip_gradient(std::size_t mode, double x1, double x2, int side, double nu, double mu) {
  using std::numbers::pi;
  const double r = std::hypot(x1, x2);
  double angle = std::atan2(x2, x1);
  if (std::abs(angle) > pi / 2 && angle * side < 0) angle += 2 * pi * side;
  const double s = std::sin(angle / 2);
  const double c = std::cos(angle / 2);
  const double S = std::sin(angle);
  const double C = std::cos(angle);
  const double kappa = 3 - 4 * nu;
  Tensor<1, 3> f;   // u = sqrt(r) f(angle)
  Tensor<1, 3> df;  // df/dangle
  if (mode == 0) {
    f = Tensor<1, 3>({c * (kappa - C), s * (kappa - C), 0});
    df = Tensor<1, 3>({-0.5 * s * (kappa - C) + c * S, 0.5 * c * (kappa - C) + s * S, 0});
  } else if (mode == 1) {
    f = Tensor<1, 3>({s * (kappa + 2 + C), -c * (kappa - 2 + C), 0});
    df = Tensor<1, 3>({0.5 * c * (kappa + 2 + C) - s * S, 0.5 * s * (kappa - 2 + C) + c * S, 0});
  } else {
    f = Tensor<1, 3>({0, 0, 4 * s});
    df = Tensor<1, 3>({0, 0, 2 * c});
  }
  const double scale = 1 / (2 * mu * std::sqrt(2 * pi * r));
  Tensor2 gradient;
  for (unsigned i = 0; i < 3; ++i) {
    gradient[i][0] = scale * (C * f[i] / 2 - S * df[i]);
    gradient[i][1] = scale * (S * f[i] / 2 + C * df[i]);
  }
  return gradient;
}

FrontFrame front_frame(const HexCell& tip, double w) {
  constexpr double kStep = 1e-4;
  FrontFrame frame;
  frame.place = to_point(tip.map({0, 0, w}));
  const Tensor<1, 3> along =
      (to_point(tip.map({0, 0, w + kStep})) - to_point(tip.map({0, 0, w - kStep}))) / (2 * kStep);
  frame.stretch = along.norm();
  const Tensor<1, 3> x3 = along / frame.stretch;
  const Tensor<1, 3> d = to_tensor(tip.front->advance({0, 0, w}));
  Tensor<1, 3> x1 = d - (d * x3) * x3;
  frame.rate = x1.norm();
  x1 /= frame.rate;
  frame.axes[0] = x1;
  frame.axes[1] = cross_product_3d(x3, x1);
  frame.axes[2] = x3;
  return frame;
}

Tensor2 auxiliary_gradient(const Space& space, std::size_t mode, const FrontFrame& frame,
                           const Point<3>& place, const HexCell& cell) {
  const Tensor<1, 3> from = place - frame.place;
  const Tensor2 local =
      crack_tip_gradient(mode, from * frame.axes[0], from * frame.axes[1], cell.front->side,
                         space.problem.material.poissons_ratio, space.lame.mu);
  return transpose(frame.axes) * local * frame.axes;
}

std::array<double, 3> quadratic(double w) {
  return {(1 - w) * (1 - 2 * w), 4 * w * (1 - w), w * (2 * w - 1)};
}

FaceRules::FaceRules(const Space& space, const dealii::FE_Q<3>& advance) : space_(space) {
  const auto make = [&](std::optional<unsigned> toward) {
    return std::make_unique<FaceRule>(
        space.body.mapping, space.scalar, advance,
        face_points(static_cast<unsigned>(space.problem.order) + 3, toward));
  };
  rules_ = {make({}), make(0U), make(1U)};
}

FaceRule& FaceRules::at(const Cell& cell, unsigned f, const HexCell& origin) {
  const bool at_front = space_.is_crack_face(cell, f) && origin.front->ring < 0;
  FaceRule& rule = *rules_[at_front ? (f < 2 ? 1 : 2) : 0];
  Space::reinit(rule.values, cell, f);
  Space::reinit(rule.velocity, cell, f);
  return rule;
}

double FaceRules::along(const FaceRule& rule, unsigned f, unsigned q) {
  if (f == 4) return 0.0;
  if (f == 5) return 1.0;
  const Point<2>& point = rule.points.point(q);
  return f < 2 ? point[1] : point[0];
}

std::array<double, 3> interaction_moduli(const Space& space) {
  const Elasticity& m = space.problem.material;
  const double plane_strain = m.youngs_modulus / (1 - m.poissons_ratio * m.poissons_ratio);
  return {plane_strain / 2, plane_strain / 2, space.lame.mu};
}

}  // namespace strainwave::fem::solid
