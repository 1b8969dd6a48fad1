// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/polynomial.hpp"
#include "strainwave/core/quadrature.hpp"
#include "strainwave/sif/newman_raju.hpp"

/// @file
/// Stress intensity from any stress on the plane of a crack, by weight functions.  A stress is a
/// callable sigma(x) [Pa], with x the depth below the cracked surface [m].  It gives the stress of
/// the body without the crack.

namespace strainwave::sif {

/// Tolerance of the integrals.  It is relative to K or to the K of a uniform stress as large as the
/// largest stress, whichever is larger, so the quadrature also ends for stresses that cancel.
inline constexpr QuadratureOptions kWeightQuadrature{.relative_tolerance = 1e-11,
                                                     .max_pieces = 200};

/// K, with the K of a uniform stress as large as the largest stress; the latter scales the error.
struct WeightedSum {
  double K = 0.0;        ///< under the stress [Pa*m^0.5]
  double uniform = 0.0;  ///< under the uniform stress [Pa*m^0.5]

  /// Sums, differences and multiples of both numbers.
  /// @{
  WeightedSum& operator+=(const WeightedSum& other) {
    K += other.K;
    uniform += other.uniform;
    return *this;
  }
  friend WeightedSum operator+(WeightedSum a, const WeightedSum& b) { return a += b; }
  friend WeightedSum operator-(const WeightedSum& a, const WeightedSum& b) {
    return {.K = a.K - b.K, .uniform = a.uniform - b.uniform};
  }
  friend WeightedSum operator*(const WeightedSum& a, double factor) {
    return {.K = a.K * factor, .uniform = a.uniform * factor};
  }
  /// @}

  /// The larger magnitude of the two; the adaptive quadrature uses it as the norm [Pa*m^0.5].
  friend double abs(const WeightedSum& a) { return std::max(std::abs(a.K), std::abs(a.uniform)); }
};

/// Integral of f(v) over [0, 1], in pieces that end at `ends`; ends outside (0, 1) are ignored.
template <class Function>
[[nodiscard]] Integral<double> integrate_in_pieces(const Function& f, std::vector<double> ends) {
  std::erase_if(ends, [](double v) { return !(v > 0 && v < 1); });
  ends.push_back(1.0);
  std::ranges::sort(ends);
  Integral<double> sum{.value = 0.0, .error = 0.0, .converged = true};
  double from = 0.0;
  for (const double to : ends) {
    if (to == from) continue;
    const Integral<WeightedSum> piece = integrate<31>(f, from, to, kWeightQuadrature);
    sum.value += piece.value.K;
    sum.error += piece.error;
    sum.converged = sum.converged && piece.converged;
    from = to;
  }
  return sum;
}

/// Properties of a stress that the quadrature needs in advance.
struct StressSurvey {
  double largest = 0.0;      ///< largest |sigma| seen [Pa]
  std::vector<double> ends;  ///< depths at which a new piece begins, in (0, a) [m]
};

/// Samples a stress at 33 evenly spaced depths, at `changes`, and in steps of a factor of 16 from
/// a/32 toward the mouth, down to 1e-9 a.  The last samples are needed because the quadrature would
/// miss a layer of residual or contact stress that is much thinner than the depth of the crack.  If
/// the stress falls over a step by more than a slope of 5 largest/a gives, the quadrature begins a
/// new piece at every step out to a/32.  A thin layer inside the body is found only if `changes`
/// names it.  Depths are [m].
template <class Stress>
[[nodiscard]] StressSurvey survey(const Stress& stress, double a, std::span<const double> changes) {
  StressSurvey seen;
  const auto look = [&](double x) {
    const double sigma = stress(x);
    seen.largest = std::max(seen.largest, std::abs(sigma));
    return sigma;
  };
  for (int i = 0; i <= 32; ++i) look(a * i / 32);
  for (const double x : changes) {
    if (!(x > 0 && x < a)) continue;
    look(x);
    seen.ends.push_back(x);
  }
  double outer = look(a / 32);
  double layer = a;
  for (double x = a / 512; x > 1e-9 * a; x /= 16) {
    const double inner = look(x);
    if (std::abs(inner - outer) > 5 * seen.largest * (15 * x) / a) layer = x;
    outer = inner;
  }
  for (double x = a / 32; x >= layer; x /= 16) seen.ends.push_back(x);
  return seen;
}

/// The value of an integral that converged [unit of the integral].
/// @throws SolverError  if it did not converge
[[nodiscard]] inline double converged_value(const Integral<double>& integral) {
  if (!integral.converged)
    throw SolverError(
        "the integral of weight function and stress did not converge: the stress varies too "
        "sharply over the depth of the crack");
  return integral.value;
}

/// Weight function of an edge crack in a strip whose ends are free to move and to rotate.
///
/// Implements theory manual eqs. (SW-1), (SW-2): K_I = int_0^a sigma(x) m(x) dx,
///
///     m = sqrt(2/(pi a)) M(v)/v,  v = sqrt(1 - x/a),  M a polynomial in v^2, M(0) = 1,
///
/// from strainwave's own solution of the singular integral equation, 0 <= a/t < 1.  The deviation
/// from this solution is at most 2e-5 for polynomials of x up to the fifth power and 0 <= a/t <=
/// 0.98, and 1e-4 for a stress that decays as exp(-10 x/a), a/t <= 0.9.  For a/t = 0 the crack is
/// in a half-plane, and m also applies to K_II with the shear stress.
class EdgeWeight {
 public:
  /// @param depth_ratio  alpha = a/t [-]; in [0, 1)
  explicit EdgeWeight(double depth_ratio);

  /// Polynomial M [-].  @param v  sqrt(1 - x/a): 0 at the tip, 1 at the mouth [-]
  [[nodiscard]] double value(double v) const { return polynomial(M_, v * v); }

 private:
  std::array<double, 7> M_{};
};

/// K_I of an edge crack under any stress [Pa*m^0.5].
///
/// Implements theory manual eq. (SW-1); v removes the singularity at the tip.
///
/// @param weight  weight function of the crack
/// @param a       depth [m]; > 0
/// @param stress   sigma(x) [Pa] for x in [0, a] [m]
/// @param changes  depths at which the stress changes sharply, where the quadrature begins a new
///                 piece [m]
/// @return         K_I, with the estimated error of the quadrature
template <class Stress>
[[nodiscard]] Integral<double> weighted_intensity(const EdgeWeight& weight, double a,
                                                  const Stress& stress,
                                                  std::span<const double> changes = {}) {
  const double scale = 2 * std::sqrt(2 * a / std::numbers::pi);
  StressSurvey seen = survey(stress, a, changes);
  for (double& x : seen.ends) x = std::sqrt(1 - x / a);
  return integrate_in_pieces(
      [&](double v) {
        const double m = scale * weight.value(v);
        return WeightedSum{.K = m * stress(a * (1 - v) * (1 + v)), .uniform = m * seen.largest};
      },  // (SW-1)
      std::move(seen.ends));
}

/// Weight functions of a semi-elliptical surface crack in a wide plate, for a stress that varies
/// with the depth only.
///
/// Implements theory manual eqs. (SW-3) to (SW-5).  The deepest point and the point at the surface
/// have universal weight functions of three coefficients each, from Newman and Raju's uniform and
/// linear stress (SP-1 to SP-3) and one condition on the far end.  They therefore reproduce these
/// two stresses.  Between the two points, (SW-5) reproduces Newman and Raju's bending and, for a
/// half circle, the exact front of the penny crack under |x|^n.  Source: shenglinka1991
/// (secondary), coefficients derived here.
class SurfaceWeight {
 public:
  /// @param aspect_ratio  rho = a/c [-]; > 0
  /// @param depth_ratio   alpha = a/t [-]; in [0, 1)
  SurfaceWeight(double aspect_ratio, double depth_ratio);

  /// K_I from the uniform stress 1 [m^0.5].
  [[nodiscard]] double uniform(double a, double phi) const {
    return fit_.tension(alpha_, phi) * std::sqrt(std::numbers::pi * a);
  }
  /// Exponent p of (SP-3) [-].
  [[nodiscard]] double front_exponent() const { return fit_.front_exponent(alpha_); }

  /// Coefficients 1, M_1, M_2, M_3 for the deepest point or the surface point [-].
  using Coefficients = std::array<double, 4>;
  /// Coefficients of the deepest point; (SW-3).
  [[nodiscard]] const Coefficients& deepest() const { return deepest_; }
  /// Coefficients of the point at the surface; (SW-4).
  [[nodiscard]] const Coefficients& surface() const { return surface_; }

 private:
  NewmanRajuPlate fit_;
  double alpha_;
  Coefficients deepest_{};
  Coefficients surface_{};
};

/// The sum 1 + M_1 v + M_2 v^2 + M_3 v^3 of (SW-3), (SW-4) [-].
[[nodiscard]] inline double power_sum(const SurfaceWeight::Coefficients& M, double v) {
  return M[0] + v * (M[1] + v * (M[2] + v * M[3]));
}

/// K_I at a point of the front of a surface crack under any stress of the depth [Pa*m^0.5].
///
/// Implements theory manual eq. (SW-5): with s = sin phi, q = 0.82 and
///
///     T sigma(x) = sigma(0) + s^(p - q) (sigma(x s^q) - sigma(0)),
///
/// which takes x^n to s^(p + (n-1) q) x^n, the ratio to the uniform stress is that of the deepest
/// point under T sigma and that of the surface under sigma - T sigma.
///
/// @param weight  weight function of the crack
/// @param a       depth [m]; > 0
/// @param phi     parametric angle from the surface; pi/2 is the deepest point [rad]
/// @param stress   sigma(x) [Pa] for x in [0, a] [m]
/// @param changes  depths at which the stress changes sharply, where the quadrature begins a new
///                 piece [m]
/// @return         K_I, with the estimated error of the quadrature
template <class Stress>
[[nodiscard]] Integral<double> weighted_intensity(const SurfaceWeight& weight, double a, double phi,
                                                  const Stress& stress,
                                                  std::span<const double> changes = {}) {
  constexpr double kDepthExponent = 0.82;
  const double s = std::sin(phi);
  const double mouth = stress(0.0);
  const double depth = std::pow(s, kDepthExponent);
  const double part = s > 0 ? std::pow(s, weight.front_exponent() - kDepthExponent) : 0.0;
  const auto shrunk = [&](double x) { return mouth + part * (stress(x * depth) - mouth); };
  const double K = std::sqrt(a / std::numbers::pi) * weight.uniform(a, phi);
  const double to_deepest = 2 * std::numbers::sqrt2 * K / weight.uniform(a, std::numbers::pi / 2);
  const double to_surface = 4 * K / weight.uniform(a, 0.0);
  const StressSurvey seen = survey(stress, a, changes);
  const double uniform = K * std::sqrt(std::numbers::pi / a) * seen.largest;
  std::vector<double> ends;
  for (const double x : seen.ends) {
    ends.push_back(std::sqrt(x / a));
    if (x >= a * depth) continue;
    ends.push_back(std::sqrt(x / (a * depth)));
    ends.push_back(std::sqrt(1 - x / (a * depth)));
  }
  return integrate_in_pieces(
      [&](double v) {
        const double x = a * v * v;
        return WeightedSum{
            .K = to_deepest * shrunk(a * (1 - v) * (1 + v)) * power_sum(weight.deepest(), v) +
                 to_surface * (stress(x) - shrunk(x)) * power_sum(weight.surface(), v),
            .uniform = uniform};
      },  // (SW-5)
      std::move(ends));
}

}  // namespace strainwave::sif
