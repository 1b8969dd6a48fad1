// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/annular_crack.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace strainwave {
namespace {

using std::numbers::pi;

/// Coefficients c_0 + c_1 x + c_2 x^2 + ...
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x) {
  double value = 0.0;
  for (std::size_t i = N; i-- > 0;) value = value * x + c[i];
  return value;
}

// The first terms are the same: they give the deep crack, where the ligament is a neck between two
// half-spaces.  The tails meet the shallow crack.
constexpr std::array kTada1 = {1.0, 0.5, 0.375, -0.363, 0.731};
constexpr std::array kTada3 = {1.0, 0.5, 0.375, 0.3125, 0.2734375, 0.208};
constexpr std::array kImproved1 = {1.0,        0.5,          0.375,       -0.47216221,
                                   4.34028458, -10.67981481, 11.90594661, -4.72621417};
constexpr std::array kImproved3 = {1.0,        0.5,         0.375,       0.3125,       0.2734375,
                                   0.97947457, -5.99287797, 13.64034961, -13.31097501, 4.88975796};

// Table of C_T and C_P, theory manual tables FR-1 and FR-2, from finite elements.
// Columns are depth ratios alpha = a/t, rows radius ratios rho = r_i/r_o.
constexpr std::array kDepthRatios = {0.0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
constexpr std::array kTorsionRadiusRatios = {0.0, 0.2, 0.4, 0.5, 0.6, 9.0 / 14, 0.7, 0.8, 0.9};
// clang-format off
constexpr double kTorsionTable[9][10] = {  // without the column alpha = 0, which is exact
    {4.00789, 4.04223, 4.14726, 4.52852, 5.18960, 6.29163, 8.21287, 11.92712, 20.53631, 48.44633},
    {3.20909, 3.22657, 3.27931, 3.46303, 3.75689, 4.19142, 4.82890, 5.78692, 7.29749, 9.86515},
    {2.46467, 2.47203, 2.49388, 2.56711, 2.67649, 2.82387, 3.01542, 3.26184, 3.58011, 3.99849},
    {2.13426, 2.13859, 2.15138, 2.19347, 2.25455, 2.33392, 2.43265, 2.55323, 2.69984, 2.87963},
    {1.83870, 1.84104, 1.84788, 1.87002, 1.90136, 1.94087, 1.98834, 2.04406, 2.10889, 2.18465},
    {1.72313, 1.72486, 1.72990, 1.74611, 1.76883, 1.79715, 1.83076, 1.86966, 1.91425, 1.96553},
    {1.57934, 1.58044, 1.58364, 1.59384, 1.60797, 1.62535, 1.64566, 1.66881, 1.69488, 1.72433},
    {1.35504, 1.35545, 1.35663, 1.36034, 1.36539, 1.37147, 1.37843, 1.38618, 1.39471, 1.40412},
    {1.16309, 1.16317, 1.16342, 1.16418, 1.16520, 1.16641, 1.16777, 1.16926, 1.17087, 1.17262}};
constexpr std::array kTensionRadiusRatios = {0.0, 0.4, 9.0 / 14, 0.8, 0.9};
constexpr double kTensionTable[5][9] = {  // C_P(0) = 1
    {1.00159, 1.00184, 0.99998, 1.00227, 1.02506, 1.07845, 1.17618, 1.34563, 1.65204},
    {1.00156, 1.00477, 1.01162, 1.03293, 1.06643, 1.11564, 1.18668, 1.29050, 1.44902},
    {1.00162, 1.00747, 1.02355, 1.07478, 1.14673, 1.23849, 1.35354, 1.50074, 1.69936},
    {1.00170, 1.00961, 1.03341, 1.11331, 1.22962, 1.38045, 1.56827, 1.80009, 2.09158},
    {1.00182, 1.01147, 1.04187, 1.14857, 1.31223, 1.53612, 1.82859, 2.20078, 2.66685}};
// clang-format on

constexpr double kEdgeCrackFactor = 1.1215;  // of K_I, shallow crack; the base of C_P

/// C_T(0) = 4 (1 - rho)/(1 - rho^4): the shallow crack, exact; 4/((1+rho)(1+rho^2)) loses no
/// digits.
double shallow_torsion_factor(double rho) { return 4 / ((1 + rho) * (1 + rho * rho)); }

boost::math::barycentric_rational<double> curve(std::vector<double> x, std::vector<double> y) {
  return {std::move(x), std::move(y), 3};
}

/// ln(C_T/C_T(0)) over alpha at one radius ratio.
///
/// C_T itself varies by a factor of 40 with rho.  (C_T(0)/C_T)^(1/3) is the radius, relative to
/// r_o, at which the crack works: it runs smoothly from its value for a solid shaft to 1 for a thin
/// tube, where C_T = 1 exactly.  So that is what is interpolated in rho.
boost::math::barycentric_rational<double> log_torsion_curve(double rho) {
  std::vector<double> y = {0.0};
  for (std::size_t column = 0; column + 1 < kDepthRatios.size(); ++column) {
    std::vector<double> radius;
    for (std::size_t row = 0; row < kTorsionRadiusRatios.size(); ++row)
      radius.push_back(std::cbrt(shallow_torsion_factor(kTorsionRadiusRatios[row]) /
                                 kTorsionTable[row][column]));
    radius.push_back(1.0);
    std::vector<double> ratios(kTorsionRadiusRatios.begin(), kTorsionRadiusRatios.end());
    ratios.push_back(1.0);
    y.push_back(-3 * std::log(curve(std::move(ratios), std::move(radius))(rho)));
  }
  return curve({kDepthRatios.begin(), kDepthRatios.end()}, std::move(y));
}

boost::math::barycentric_rational<double> tension_curve(double rho) {
  std::vector<double> x = {0.0};
  std::vector<double> y = {1.0};
  for (std::size_t column = 0; column < 9; ++column) {
    std::vector<double> factor;
    for (const auto& row : kTensionTable) factor.push_back(row[column]);
    x.push_back(kDepthRatios[column + 1]);
    y.push_back(
        curve({kTensionRadiusRatios.begin(), kTensionRadiusRatios.end()}, std::move(factor))(rho));
  }
  return curve(std::move(x), std::move(y));
}

}  // namespace

double annular_p1(AnnularPolynomials which, double x) {
  return which == AnnularPolynomials::tada ? polynomial(kTada1, x) : polynomial(kImproved1, x);
}

double annular_p3(AnnularPolynomials which, double x) {
  return which == AnnularPolynomials::tada ? polynomial(kTada3, x) : polynomial(kImproved3, x);
}

UnitStressIntensity<2> AnnularCrackSolid::stress_intensity(double a, double) const {
  const double net = diameter - 2 * a;
  const double x = net / diameter;
  const double root = std::sqrt(pi * a) * std::sqrt(x);
  UnitStressIntensity<2> k;
  k.III[1] = 3.0 / 8 * annular_p3(polynomials, x) * 16 / (pi * net * net * net) * root;  // (FR-12)
  if (open) k.I[0] = annular_p1(polynomials, x) / 2 * 4 / (pi * net * net) * root;       // (FR-13)
  return k;
}

double AnnularCrackSolid::swept_area(double a, double) const { return pi * (diameter - 2 * a); }

AnnularCrackHollow::AnnularCrackHollow(const Parameters& parameters)
    : p_(parameters),
      shallow_torsion_factor_(shallow_torsion_factor(p_.inner_radius / p_.outer_radius)),
      log_torsion_(log_torsion_curve(p_.inner_radius / p_.outer_radius)),
      tension_(tension_curve(p_.inner_radius / p_.outer_radius)) {}

double AnnularCrackHollow::torsion_factor(double depth_ratio) const {
  return shallow_torsion_factor_ * std::exp(log_torsion_(depth_ratio));
}

double AnnularCrackHollow::tension_factor(double depth_ratio) const {
  return tension_(depth_ratio);
}

double AnnularCrackHollow::swept_area(double a, double) const {
  return 2 * pi * (p_.outer_radius - a);
}

UnitStressIntensity<2> AnnularCrackHollow::stress_intensity(double a, double) const {
  const double ro = p_.outer_radius;
  const double ri = p_.inner_radius;
  const double t = ro - ri;
  const double alpha = a / t;
  const double front = swept_area(a, 0.0);
  UnitStressIntensity<2> k;

  // lambda_TT = 4t/(pi mu I_p) ln sec(pi alpha/2) C_T (FR-14); K_III = T sqrt(mu lambda_TT'/front),
  // where mu drops out (FR-16).
  const double I_p = pi / 2 * (ro * ro + ri * ri) * (ro + ri) * t;
  const double C_T = torsion_factor(alpha);
  const double half_angle = pi * alpha / 2;
  const double log_sec = -std::log1p(-2 * std::pow(std::sin(half_angle / 2), 2));
  const double torsion_slope =
      4 / (pi * I_p) * C_T * (pi / 2 * std::tan(half_angle) + log_sec * log_torsion_.prime(alpha));
  k.III[1] = std::sqrt(std::max(0.0, torsion_slope) / front);

  // lambda_PP = 2(1-nu^2) 1.1215^2 pi^2 r_o a^2/(E A^2) C_P (FR-15);
  // K_I = P sqrt(E lambda_PP'/(2(1-nu^2) front)), where E and nu drop out (FR-16).
  if (p_.open) {
    const double A = pi * (ro + ri) * t;
    const double tension_slope = std::pow(kEdgeCrackFactor * pi / A, 2) * ro * a *
                                 (2 * tension_(alpha) + alpha * tension_.prime(alpha));
    k.I[0] = std::sqrt(std::max(0.0, tension_slope) / front);
  }
  return k;
}

}  // namespace strainwave
