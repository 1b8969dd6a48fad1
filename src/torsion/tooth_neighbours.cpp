// SPDX-License-Identifier: Apache-2.0
#include "tooth_neighbours.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
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
    for_each_point<20>([&](double x, double weight) {
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

/// Transforms of the loads over a root.
template <class Number>
struct RootLoads {
  Number even{};    // of a load that is constant over the root
  Number linear{};  // of the pressure of a moment, which is linear over it, divided by x/3
};

constexpr double kSmall = 0.3;  // where the transform of the linear load is a power series

/// The power series of the linear load in x^2.
template <class Number>
Number of_small_linear_load(const Number& square) {
  return 1.0 -
         square / 10.0 * (1.0 - square / 28.0 * (1.0 - square / 54.0 * (1.0 - square / 88.0)));
}

/// @param x  K B/2
template <class Real>
RootLoads<Real> root_loads(const Real& x) {
  using std::cos, std::sin;
  const Real s = sin(x);
  return {.even = s / x,
          .linear = x < kSmall ? of_small_linear_load<Real>(x * x)
                               : Real(3 * (s - x * cos(x)) / (x * x * x))};
}

/// A complex number whose parts may carry derivatives.
template <class Real>
struct Complex {
  Real re{};
  Real im{};

  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Complex operator*(const std::complex<double>& a, const Complex& b) {
    return {a.real() * b.re - a.imag() * b.im, a.real() * b.im + a.imag() * b.re};
  }
  friend Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend Complex operator-(double a, const Complex& b) { return {a - b.re, -b.im}; }
  friend Complex operator*(const Complex& a, const Real& b) { return {a.re * b, a.im * b}; }
  friend Complex operator/(const Complex& a, double b) { return {a.re / b, a.im / b}; }
  [[nodiscard]] Complex inverse() const {
    const Real square = re * re + im * im;
    return {re / square, -im / square};
  }
};

/// The transforms times exp(-Im x), because they grow like exp(Im x) and could overflow.
/// @param x  K B/2 of a complex wave number, Im x >= 0
template <class Real>
RootLoads<Complex<Real>> root_loads(const Complex<Real>& x) {
  using std::cos, std::exp, std::sin;
  const Real fades = exp(-2 * x.im);
  const Real even = (1 + fades) / 2;
  const Real odd = (1 - fades) / 2;
  const Real c = cos(x.re);
  const Real s = sin(x.re);
  const Complex<Real> sine = {s * even, c * odd};
  const Complex<Real> cosine = {c * even, -s * odd};
  const Complex<Real> square = x * x;
  const bool small = value_of(x.re * x.re + x.im * x.im) < kSmall * kSmall;
  const Complex<Real> over = x.inverse();
  return {.even = sine * over,
          .linear = small ? of_small_linear_load(square) * Real(exp(-x.im))
                          : (sine - x * cosine) * (over * over * over) * Real(3.0)};
}

/// A state of the layer without a load, which fades along it.
struct FadingWave {
  std::complex<double> wave;   // K, a root of sinh 2K + 2K
  std::complex<double> press;  // 2K/(cosh 2K + 1)
};

/// From this distance between two roots on, less the width of a root, the fading waves alone tell
/// the motion.
constexpr double kFar = 0.5;
/// A wave that has faded by exp(-40) is left out.
constexpr double kFaded = 40.0;

std::vector<FadingWave> make_fading_waves() {
  constexpr int kWaves = 26;  // the next one fades by more than kFaded over kFar
  std::vector<FadingWave> waves;
  for (int j = 1; j <= kWaves; ++j) {
    const double y = (2 * j - 0.5) * pi;
    std::complex<double> z(std::log(2 * y), y - std::log(2 * y) / y);  // 2K, for large j
    for (int step = 0; step < 20; ++step) z -= (std::sinh(z) + z) / (std::cosh(z) + 1.0);
    waves.push_back({.wave = z / 2.0, .press = z / (std::cosh(z) + 1.0)});
  }
  return waves;
}

const std::vector<FadingWave>& fading_waves() {
  static const std::vector<FadingWave> waves = make_fading_waves();
  return waves;
}

/// The amplitudes of a fading wave under the loads over two roots, times -pi exp(-Im K B): what the
/// wave has at the distance B, the width of a root.
template <class Real>
struct FadingMotion {
  std::complex<double> wave;
  Complex<Real> along;
  Complex<Real> outward;
  Complex<Real> mixed;

  FadingMotion(const FadingWave& of, const Real& root, const Real& lever) : wave(of.wave) {
    const auto loads =
        root_loads(Complex<Real>{of.wave.real() * root / 2, of.wave.imag() * root / 2});
    const Complex<Real> u = loads.even - of.press * of.wave * (loads.linear * lever);
    const Complex<Real> v = of.press * loads.even;
    // The width tells the rest by its derivatives.
    using std::exp;
    const std::complex<double> over = -pi / of.wave;
    const Real rest = exp(of.wave.imag() * (root - value_of(root)));  // 1
    along = over * (u * u) * rest;                                    // (TC-31)
    outward = over * (v * v) * rest;                                  // (TC-31)
    mixed = over * (u * v) * rest;                                    // (TC-31)
  }
};

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

/// Motions of teeth that are near each other: the half-plane is integrated over the roots, what the
/// layer is more over the wave numbers.
template <class Real>
class NearTeeth {
 public:
  /// @param shift  zero; it carries the derivatives of the pitch
  NearTeeth(const Real& root, const Real& lever, const Real& pitch, const Real& shift)
      : root_(root),
        pitch_(pitch),
        shift_(shift),
        slant_(lever / root),
        of_tangential_(layer_points().size()),
        of_radial_(layer_points().size()),
        of_mixed_(layer_points().size()),
        waves_(static_cast<Eigen::Index>(layer_points().size())) {
    const std::vector<LayerPoint>& points = layer_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const LayerPoint& at = points[i];
      const double K = at.wave;
      const RootLoads<Real> loads = root_loads<Real>(K * root / 2);
      const Real& even = loads.even;
      const Real linear = lever * loads.linear;
      of_tangential_.set(i, at.weight * (at.shear / K * even * even + at.mixed * even * linear +
                                         K * at.press * linear * linear));
      of_radial_.set(i, at.weight * at.press / K * even * even);
      of_mixed_.set(i, at.weight * (at.mixed / (2 * K) * even * even + at.press * even * linear));
      waves_[static_cast<Eigen::Index>(i)] = K;
      tangential_constant_ -= at.weight * at.fading / (2 * K * K);
      radial_constant_ += at.weight * at.fading / K;
    }
    const Eigen::ArrayXd phase = waves_.array() * value_of(pitch);
    first_cosine_ = phase.cos();
    first_sine_ = phase.sin();
    cosine_ = Eigen::ArrayXd::Ones(phase.size());
    sine_ = Eigen::ArrayXd::Zero(phase.size());
  }

  struct Motion {
    Real tangential{};
    Real radial{};
    Real mixed{};
  };
  /// The motion one pitch farther than the last one.
  [[nodiscard]] Motion next() {
    ++pitches_;
    const Eigen::ArrayXd before = cosine_;
    cosine_ = first_cosine_ * before - first_sine_ * sine_.array();
    sine_ = first_sine_ * before + first_cosine_ * sine_.array();
    Eigen::VectorXd cosine_slope;
    Eigen::VectorXd sine_slope;
    if constexpr (!std::is_same_v<Real, double>) {
      cosine_slope = -pitches_ * waves_.cwiseProduct(sine_);
      sine_slope = pitches_ * waves_.cwiseProduct(cosine_);
    }
    const Real distance = pitches_ * pitch_;
    const HalfPlane<Real> plane = half_plane<15>(distance, root_);
    return {.tangential = plane.even + slant_ * slant_ * plane.linear + pi / 4 * distance +
                          tangential_constant_ + of_tangential_.sum(cosine_, cosine_slope, shift_),
            .radial = plane.even + radial_constant_ + of_radial_.sum(cosine_, cosine_slope, shift_),
            .mixed = pi / 4 - slant_ * plane.mixed + of_mixed_.sum(sine_, sine_slope, shift_)};
  }

 private:
  Real root_;
  Real pitch_;
  Real shift_;
  Real slant_;
  Weights<Real> of_tangential_;
  Weights<Real> of_radial_;
  Weights<Real> of_mixed_;
  Eigen::VectorXd waves_;
  Eigen::ArrayXd first_cosine_;
  Eigen::ArrayXd first_sine_;
  Eigen::VectorXd cosine_;
  Eigen::VectorXd sine_;
  int pitches_ = 0;
  double tangential_constant_ = std::numbers::ln2 - 1;
  double radial_constant_ = std::numbers::ln2;
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
  const Real layer = 2 * (1 - steel.nu * steel.nu) / (pi * steel.E * face_width);
  const Real shift = pitch - value_of(pitch);  // zero; it carries the derivatives
  const int count =
      std::min(pitches / 2, static_cast<int>(std::floor(kReach / value_of(pitch)))) + 1;
  for (std::vector<Real>* const table : {&tangential_, &radial_, &mixed_})
    table->assign(static_cast<std::size_t>(count), Real(0.0));
  const auto set = [&](int n, const Real& tangential, const Real& radial, const Real& mixed) {
    const auto k = static_cast<std::size_t>(n);
    tangential_[k] = layer * tangential;  // (TC-31)
    radial_[k] = layer * radial;
    mixed_[k] = layer * mixed;
  };
  const auto gap = [&](int n) { return n * value_of(pitch) - value_of(root); };
  int n = 1;
  if (n < count && gap(n) < kFar) {
    NearTeeth<Real> near(root, lever, pitch, shift);
    for (; n < count && gap(n) < kFar; ++n) {
      const auto [tangential, radial, mixed] = near.next();
      set(n, tangential, radial, mixed);
    }
  }
  std::vector<FadingMotion<Real>> motions;
  std::vector<std::complex<double>> at;    // exp(iKx + Im K B) of each wave
  std::vector<std::complex<double>> step;  // of one pitch
  if (n < count)
    for (const FadingWave& wave : fading_waves()) {
      if (wave.wave.imag() * gap(n) > kFaded) break;
      motions.emplace_back(wave, root, lever);
      const std::complex<double> turns = std::complex<double>(0, 1) * wave.wave * value_of(pitch);
      step.push_back(std::exp(turns));
      at.push_back(std::exp(turns * static_cast<double>(n) + wave.wave.imag() * value_of(root)));
    }
  for (; n < count; ++n) {
    Real tangential(0.0);
    Real radial(0.0);
    Real mixed(0.0);
    for (std::size_t j = 0; j < motions.size(); ++j) {
      const FadingMotion<Real>& of = motions[j];
      if (j > 0 && of.wave.imag() * gap(n) > kFaded) break;  // and so do the others
      const double c = at[j].real();
      const double s = at[j].imag();
      tangential += of.along.re * s + of.along.im * c;
      radial += of.outward.re * s + of.outward.im * c;
      mixed += of.mixed.re * c - of.mixed.im * s;
      if constexpr (!std::is_same_v<Real, double>) {
        const std::complex<double> grows = std::complex<double>(0, n) * of.wave * at[j];
        const auto moved = [&](const Complex<Real>& by) {
          return grows * std::complex<double>(value_of(by.re), value_of(by.im));
        };
        tangential += moved(of.along).imag() * shift;
        radial += moved(of.outward).imag() * shift;
        mixed += moved(of.mixed).real() * shift;
      }
      at[j] *= step[j];
    }
    set(n, tangential, radial, mixed);
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
