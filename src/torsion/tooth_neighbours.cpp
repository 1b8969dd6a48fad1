// SPDX-License-Identifier: Apache-2.0
#include "tooth_neighbours.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <type_traits>

namespace strainwave {
namespace {

using std::numbers::pi;

// Lengths in this file are divided by the thickness of the layer, and K is the wave number.

/// Distance from which the layer rests: its slowest part decreases like exp(-2.1 x).
constexpr double kReach = 16;
/// Wave number from which the layer is a half-plane, within K exp(-2K).
constexpr double kShortest = 16;

/// What the layer is more than a half-plane, at one point of the integral over the wave number.
struct LayerPoint {
  double wave = 0.0;    // K
  double weight = 0.0;  // of the integral over K
  double shear = 0.0;   // (cosh 2K + 1)/(sinh 2K + 2K) - 1
  double press = 0.0;   // (cosh 2K - 1)/(sinh 2K + 2K) - 1
  double mixed = 0.0;   // (sinh 2K - 2K)/(sinh 2K + 2K) - 1
  double fading = 0.0;  // exp(-2K)
};

/// The sum of f(x, weight) over the points of Gauss's rule in [0, 1].
template <int Points, class Function>
void for_each_point(const Function& f) {
  using Rule = boost::math::quadrature::gauss<double, Points>;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    const double x = Rule::abscissa()[i];
    const double weight = Rule::weights()[i] / 2;
    f((1 + x) / 2, weight);
    if (x > 0) f((1 - x) / 2, weight);
  }
}

std::vector<LayerPoint> make_layer_points() {
  constexpr int kPanels = 6;
  std::vector<LayerPoint> points;
  for (int panel = 0; panel < kPanels; ++panel)
    for_each_point<30>([&](double x, double weight) {
      constexpr double kLength = kShortest / kPanels;
      const double K = (panel + x) * kLength;
      const double e = std::exp(-2 * K);
      const double below = 1 - e * e + 4 * K * e;  // 2 exp(-2K) (sinh 2K + 2K)
      points.push_back({.wave = K,
                        .weight = weight * kLength,
                        .shear = 2 * e * (e + 1 - 2 * K) / below,
                        .press = 2 * e * (e - 1 - 2 * K) / below,
                        .mixed = -8 * K * e / below,
                        .fading = e});
    });
  return points;
}

const std::vector<LayerPoint>& layer_points() {
  static const std::vector<LayerPoint> points = make_layer_points();
  return points;
}

/// Transform of a load that is constant over the root, with x = K B/2.
template <class Real>
Real of_even_load(const Real& x) {
  using std::sin;
  return sin(x) / x;
}

/// Transform of the pressure of a moment, which is linear over the root, divided by x/3.
template <class Real>
Real of_linear_load(const Real& x) {
  using std::cos, std::sin;
  const Real square = x * x;
  constexpr double kSmall = 0.3;
  return x < kSmall
             ? Real(1 - square / 10 * (1 - square / 28 * (1 - square / 54 * (1 - square / 88))))
             : Real(3 * (sin(x) - x * cos(x)) / (square * x));
}

/// Means of -ln over the distances between the points of two roots.
template <class Real>
struct HalfPlane {
  Real even{};    // of constant loads
  Real mixed{};   // of a constant and a linear load
  Real linear{};  // of linear loads
};

template <int Points, class Real>
HalfPlane<Real> half_plane(const Real& distance, const Real& root) {
  using std::log;
  HalfPlane<Real> sum{};
  for_each_point<Points>([&](double u, double weight) {
    const Real ahead = log(distance + root * u);
    const Real behind = log(distance - root * u);
    const Real both = weight * (ahead + behind);
    sum.even -= (1 - u) * both;
    sum.mixed -= (6 * weight * u * (1 - u)) * (ahead - behind);
    sum.linear -= (12 - 36 * u + 24 * u * u * u) * both;
  });
  return sum;
}

/// Weights of the points of an integral, with their derivatives: a value of type Real for each
/// point.
template <class Real>
class Weights {
 public:
  explicit Weights(std::size_t points) : columns_(static_cast<Eigen::Index>(points), kColumns) {}

  void set(std::size_t point, const Real& weight) {
    const auto row = static_cast<Eigen::Index>(point);
    columns_(row, 0) = value_of(weight);
    if constexpr (kColumns > 1)
      for (std::size_t k = 0; k < weight.partial.size(); ++k)
        columns_(row, static_cast<Eigen::Index>(k) + 1) = weight.partial[k];
  }
  /// The sum of weights times values that change by `slopes` per unit of `shift`.
  [[nodiscard]] Real sum(const Eigen::VectorXd& values, const Eigen::VectorXd& slopes,
                         const Real& shift) const {
    if constexpr (kColumns == 1) {
      return columns_.col(0).dot(values);
    } else {
      Real sum = columns_.col(0).dot(values);
      for (std::size_t k = 0; k < sum.partial.size(); ++k)
        sum.partial[k] = columns_.col(static_cast<Eigen::Index>(k) + 1).dot(values);
      return sum + columns_.col(0).dot(slopes) * shift;
    }
  }

 private:
  static constexpr int kColumns =
      std::is_same_v<Real, double> ? 1 : 1 + static_cast<int>(kDualWidth);
  Eigen::Matrix<double, Eigen::Dynamic, kColumns> columns_;
};

}  // namespace

template <class Real>
BasicToothNeighbours<Real>::BasicToothNeighbours(const BasicToothOnWall<Real>& tooth,
                                                 const BasicElasticConstants<Real>& steel,
                                                 const Real& face_width, int pitches)
    : pitches_(pitches) {
  using std::tan;
  const Real root = tooth.root_width() / tooth.wall;
  const Real lever = (tooth.dedendum - tooth.thickness * tan(tooth.flank_angle) / 2) / tooth.wall;
  const Real pitch = pi * tooth.module / tooth.wall;
  const Real slant = lever / root;
  // The half-plane is integrated over the roots, the rest over the wave numbers.
  const std::vector<LayerPoint>& points = layer_points();
  Weights<Real> of_tangential(points.size());
  Weights<Real> of_radial(points.size());
  Weights<Real> of_mixed(points.size());
  Eigen::VectorXd waves(static_cast<Eigen::Index>(points.size()));
  double tangential_constant = std::numbers::ln2 - 1;
  double radial_constant = std::numbers::ln2;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LayerPoint& at = points[i];
    const double K = at.wave;
    const Real x = K * root / 2;
    const Real even = of_even_load(x);
    const Real linear = lever * of_linear_load(x);
    of_tangential.set(i, at.weight * (at.shear / K * even * even + at.mixed * even * linear +
                                      K * at.press * linear * linear));
    of_radial.set(i, at.weight * at.press / K * even * even);
    of_mixed.set(i, at.weight * (at.mixed / (2 * K) * even * even + at.press * even * linear));
    waves[static_cast<Eigen::Index>(i)] = K;
    tangential_constant -= at.weight * at.fading / (2 * K * K);
    radial_constant += at.weight * at.fading / K;
  }
  const Real layer = 2 * (1 - steel.nu * steel.nu) / (pi * steel.E * face_width);
  const Real shift = pitch - value_of(pitch);  // zero; it carries the derivatives
  const int count =
      std::min(pitches / 2, static_cast<int>(std::floor(kReach / value_of(pitch)))) + 1;
  for (std::vector<Real>* const table : {&tangential_, &radial_, &mixed_})
    table->assign(static_cast<std::size_t>(count), Real(0.0));
  const Eigen::ArrayXd first_cosine = (waves.array() * value_of(pitch)).cos();
  const Eigen::ArrayXd first_sine = (waves.array() * value_of(pitch)).sin();
  Eigen::VectorXd cosine = Eigen::VectorXd::Ones(waves.size());
  Eigen::VectorXd sine = Eigen::VectorXd::Zero(waves.size());
  Eigen::VectorXd cosine_slope;
  Eigen::VectorXd sine_slope;
  for (int n = 1; n < count; ++n) {  // advanced by one pitch
    const Eigen::ArrayXd before = cosine;
    cosine = first_cosine * before - first_sine * sine.array();
    sine = first_sine * before + first_cosine * sine.array();
    if constexpr (!std::is_same_v<Real, double>) {
      cosine_slope = -n * waves.cwiseProduct(sine);
      sine_slope = n * waves.cwiseProduct(cosine);
    }
    const Real distance = n * pitch;
    constexpr int kNear = 8;
    const HalfPlane<Real> plane =
        n < kNear ? half_plane<15>(distance, root) : half_plane<7>(distance, root);
    const Real tangential = plane.even + slant * slant * plane.linear + pi / 4 * distance +
                            tangential_constant + of_tangential.sum(cosine, cosine_slope, shift);
    const Real radial = plane.even + radial_constant + of_radial.sum(cosine, cosine_slope, shift);
    const Real mixed = pi / 4 - slant * plane.mixed + of_mixed.sum(sine, sine_slope, shift);
    const auto k = static_cast<std::size_t>(n);
    tangential_[k] = layer * tangential;  // (TC-31)
    radial_[k] = layer * radial;
    mixed_[k] = layer * mixed;
  }
}

template <class Real>
BasicNeighbourMotion<Real> BasicToothNeighbours<Real>::between(FlankPlace of, FlankPlace by) const {
  // The flanks of a tooth press the teeth half a pitch beside it.
  int steps = of.tooth - by.tooth + (of.side - by.side) / 2;
  if (2 * steps > pitches_) steps -= pitches_;
  if (2 * steps < -pitches_) steps += pitches_;
  const auto apart = static_cast<std::size_t>(std::abs(steps));
  if (apart >= radial_.size()) return {};
  return {.outward = radial_[apart],
          .along = tangential_[apart],
          .mixed = steps > 0 ? mixed_[apart] : Real(-mixed_[apart])};
}

template class BasicToothNeighbours<double>;
template class BasicToothNeighbours<DualReal>;

}  // namespace strainwave
