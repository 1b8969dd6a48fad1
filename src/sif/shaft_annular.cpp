// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/member/shaft_annular.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "strainwave/core/polynomial.hpp"

namespace strainwave::sif {
namespace {

using std::numbers::pi;

// The first terms agree: they describe the deep crack, whose ligament is a neck between two
// half-spaces.  The last terms match the shallow crack.
constexpr std::array kTada1 = {1.0, 0.5, 0.375, -0.363, 0.731};
constexpr std::array kTada3 = {1.0, 0.5, 0.375, 0.3125, 0.2734375, 0.208};
constexpr std::array kImproved1 = {1.0,        0.5,          0.375,       -0.47216221,
                                   4.34028458, -10.67981481, 11.90594661, -4.72621417};
constexpr std::array kImproved3 = {1.0,        0.5,         0.375,       0.3125,       0.2734375,
                                   0.97947457, -5.99287797, 13.64034961, -13.31097501, 4.88975796};

// Tables of C_T and C_P, theory manual tables FR-1 and FR-2, by tools/reference/annular_hollow.py
// (dual series in torsion, axisymmetric finite elements in tension); an independent finite-element
// computation agrees within 6e-5 and 4e-4.  Columns are depth ratios alpha = a/t, rows radius
// ratios rho = r_i/r_o; alpha = 0 and rho = 1 in torsion are exact and not in the table.
constexpr std::array kDepthRatios = {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
using TableRow = std::array<double, kDepthRatios.size()>;
// clang-format off
constexpr std::array kTorsionRadiusRatios = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 9.0 / 14, 0.7, 0.8, 0.9};
constexpr std::array<TableRow, kTorsionRadiusRatios.size()> kTorsionTable = {{
    {4.008096, 4.042437, 4.147457, 4.528716, 5.189789, 6.291813, 8.213049, 11.927287, 20.536461, 48.446432},
    {3.606262, 3.631259, 3.707228, 3.977336, 4.426583, 5.129673, 6.246562, 8.123588, 11.601417, 19.147442},
    {3.209263, 3.226734, 3.279472, 3.463187, 3.757044, 4.191563, 4.829041, 5.787058, 7.297614, 9.865246},
    {2.825630, 2.837278, 2.872182, 2.991383, 3.175308, 3.434010, 3.789109, 4.277961, 4.964374, 5.963668},
    {2.464804, 2.472153, 2.494005, 2.567232, 2.676610, 2.823978, 3.015525, 3.261938, 3.580209, 3.998564},
    {2.134369, 2.138703, 2.151487, 2.193572, 2.254653, 2.334018, 2.432745, 2.553323, 2.699919, 2.879692},
    {1.838795, 1.841133, 1.847969, 1.870106, 1.901442, 1.940953, 1.988417, 2.044137, 2.108960, 2.184707},
    {1.723220, 1.724949, 1.729986, 1.746190, 1.768908, 1.797233, 1.830834, 1.869737, 1.914318, 1.965584},
    {1.579418, 1.580522, 1.583718, 1.593915, 1.608042, 1.625420, 1.645733, 1.668874, 1.694942, 1.724381},
    {1.355109, 1.355522, 1.356700, 1.360407, 1.365450, 1.371531, 1.378489, 1.386239, 1.394765, 1.404163},
    {1.163145, 1.163235, 1.163479, 1.164238, 1.165255, 1.166462, 1.167820, 1.169307, 1.170915, 1.172657}}};
constexpr std::array kTensionRadiusRatios = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 9.0 / 14, 0.7, 0.8, 0.85, 0.9, 0.95};
constexpr std::array<TableRow, kTensionRadiusRatios.size()> kTensionTable = {{
    {1.00191, 1.00204, 1.00012, 1.00236, 1.02513, 1.07852, 1.17625, 1.34571, 1.65217, 2.29355},
    {1.00185, 1.00241, 1.00144, 1.00365, 1.02156, 1.06308, 1.13765, 1.26215, 1.47275, 1.86340},
    {1.00185, 1.00311, 1.00413, 1.01015, 1.02915, 1.06763, 1.13337, 1.23968, 1.41389, 1.72420},
    {1.00187, 1.00400, 1.00767, 1.02022, 1.04462, 1.08598, 1.15119, 1.25203, 1.41220, 1.68954},
    {1.00189, 1.00498, 1.01178, 1.03305, 1.06653, 1.11574, 1.18678, 1.29061, 1.44917, 1.71515},
    {1.00192, 1.00605, 1.01636, 1.04836, 1.09458, 1.15671, 1.23992, 1.35450, 1.52126, 1.78999},
    {1.00196, 1.00719, 1.02140, 1.06630, 1.12943, 1.21061, 1.31385, 1.44854, 1.63447, 1.91930},
    {1.00197, 1.00770, 1.02373, 1.07492, 1.14686, 1.23862, 1.35366, 1.50089, 1.69955, 1.99635},
    {1.00200, 1.00843, 1.02703, 1.08748, 1.17300, 1.28184, 1.41678, 1.58601, 1.80777, 2.12723},
    {1.00206, 1.00987, 1.03360, 1.11347, 1.22976, 1.38056, 1.56836, 1.80021, 2.09176, 2.48326},
    {1.00212, 1.01072, 1.03748, 1.12938, 1.26626, 1.44756, 1.67712, 1.96241, 2.31756, 2.77800},
    {1.00220, 1.01174, 1.04208, 1.14872, 1.31235, 1.53619, 1.82860, 2.20078, 2.66690, 3.25449},
    {1.00233, 1.01311, 1.04813, 1.17481, 1.37755, 1.66960, 2.07422, 2.62095, 3.33853, 4.24669}}};
// clang-format on

constexpr double kEdgeCrackFactor = 1.1215;  // of K_I, shallow crack; the base of C_P

/// C_T(0) = 4 (1 - rho)/(1 - rho^4): the shallow crack, exact; 4/((1+rho)(1+rho^2)) is accurate for
/// thin walls.
template <class Real>
Real shallow_torsion_factor(const Real& rho) {
  return 4 / ((1 + rho) * (1 + rho * rho));
}

constexpr std::size_t kColumns = kDepthRatios.size();

/// Nodes over alpha: 0, where the value is exact, then the columns of a table.
constexpr std::array<double, kColumns + 1> kDepthNodes = [] {
  std::array<double, kColumns + 1> x{};
  for (std::size_t column = 0; column < kColumns; ++column) x[column + 1] = kDepthRatios[column];
  return x;
}();

/// Ordinates at these nodes.
template <class Real>
using Ordinates = std::array<Real, kColumns + 1>;

template <class Real, class MakeOrdinate>
Ordinates<Real> ordinates(double at_zero, const MakeOrdinate& make) {
  Ordinates<Real> y{};
  y[0] = at_zero;
  for (std::size_t column = 0; column < kColumns; ++column) y[column + 1] = make(column);
  return y;
}

/// Curves over rho, one for each column of a table; computed only once.
template <std::size_t Nodes>
using Columns = std::array<FloaterHormann<double, Nodes>, kColumns>;

template <std::size_t Nodes, class MakeColumn>
Columns<Nodes> columns(const MakeColumn& make) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return Columns<Nodes>{make(I)...}; }
  (std::make_index_sequence<kColumns>{});
}

/// ln(C_T/C_T(0)) over alpha at one radius ratio.
///
/// C_T itself varies by a factor of 40 with rho.  (C_T(0)/C_T)^(1/3) is the radius, relative to
/// r_o, at which the crack works: it runs smoothly from its value for a solid shaft to 1 for a thin
/// tube, where C_T = 1 exactly.  This radius is therefore interpolated in rho.
template <class Real>
Ordinates<Real> log_torsion_ordinates(const Real& rho) {
  using std::log;
  constexpr std::size_t kRows = kTorsionRadiusRatios.size();
  static const auto kCurves = columns<kRows + 1>([](std::size_t column) {
    std::array<double, kRows + 1> nodes{};
    std::array<double, kRows + 1> radius{};
    for (std::size_t row = 0; row < kRows; ++row) {
      nodes[row] = kTorsionRadiusRatios[row];
      radius[row] = std::cbrt(shallow_torsion_factor(nodes[row]) / kTorsionTable[row][column]);
    }
    nodes[kRows] = 1.0;
    radius[kRows] = 1.0;
    return FloaterHormann<double, kRows + 1>(nodes, radius);
  });
  return ordinates<Real>(
      0.0, [&](std::size_t column) -> Real { return -3 * log(kCurves[column](rho)); });
}

/// C_P over alpha at one radius ratio.  The logarithm is interpolated, because it is smoother in
/// rho toward thin tubes.
template <class Real>
Ordinates<Real> tension_ordinates(const Real& rho) {
  using std::exp;
  constexpr std::size_t kRows = kTensionRadiusRatios.size();
  static const auto kCurves = columns<kRows>([](std::size_t column) {
    std::array<double, kRows> log_factor{};
    for (std::size_t row = 0; row < kRows; ++row)
      log_factor[row] = std::log(kTensionTable[row][column]);
    return FloaterHormann<double, kRows>(kTensionRadiusRatios, log_factor);
  });
  return ordinates<Real>(1.0,
                         [&](std::size_t column) -> Real { return exp(kCurves[column](rho)); });
}

/// ln sec(pi alpha/2), accurate for shallow cracks too.
template <class Real>
Real log_sec(const Real& alpha) {
  using std::log1p, std::sin;
  const Real sine = sin(pi * alpha / 4);
  return -log1p(-2 * sine * sine);
}

template <class Real>
Real p1(AnnularPolynomials which, const Real& x) {
  return which == AnnularPolynomials::tada ? polynomial(kTada1, x) : polynomial(kImproved1, x);
}

template <class Real>
Real p3(AnnularPolynomials which, const Real& x) {
  return which == AnnularPolynomials::tada ? polynomial(kTada3, x) : polynomial(kImproved3, x);
}

}  // namespace

double annular_p1(AnnularPolynomials which, double x) { return p1(which, x); }

double annular_p3(AnnularPolynomials which, double x) { return p3(which, x); }

template <class Real>
UnitStressIntensity<2, Real> BasicAnnularCrackSolid<Real>::stress_intensity(const Real& a,
                                                                            double) const {
  using std::sqrt;
  const Real net = diameter - 2 * a;
  const Real x = net / diameter;
  const Real root = sqrt(pi * a) * sqrt(x);
  UnitStressIntensity<2, Real> k;
  k.III[1] = 3.0 / 8 * p3(polynomials, x) * 16 / (pi * net * net * net) * root;  // (FR-12)
  if (open) k.I[0] = p1(polynomials, x) / 2 * 4 / (pi * net * net) * root;       // (FR-13)
  return k;
}

template <class Real>
Real BasicAnnularCrackSolid<Real>::swept_area(const Real& a, double) const {
  return pi * (diameter - 2 * a);
}

template <class Real>
BasicAnnularCrackHollow<Real>::BasicAnnularCrackHollow(const Parameters& parameters)
    : p_(parameters),
      shallow_torsion_factor_(shallow_torsion_factor<Real>(p_.inner_radius / p_.outer_radius)),
      log_torsion_(kDepthNodes, log_torsion_ordinates<Real>(p_.inner_radius / p_.outer_radius)) {
  static_assert(kNodes == kColumns + 1);
  if (p_.open)
    tension_.emplace(kDepthNodes, tension_ordinates<Real>(p_.inner_radius / p_.outer_radius));
}

template <class Real>
Real BasicAnnularCrackHollow<Real>::torsion_factor(const Real& depth_ratio) const {
  using std::exp;
  return shallow_torsion_factor_ * exp(log_torsion_(depth_ratio));
}

template <class Real>
Real BasicAnnularCrackHollow<Real>::tension_factor(const Real& depth_ratio) const {
  if (tension_) return (*tension_)(depth_ratio);
  return Curve(kDepthNodes,
               tension_ordinates<Real>(p_.inner_radius / p_.outer_radius))(depth_ratio);
}

template <class Real>
Real BasicAnnularCrackHollow<Real>::swept_area(const Real& a, double) const {
  return 2 * pi * (p_.outer_radius - a);
}

template <class Real>
UnitStressIntensity<2, Real> BasicAnnularCrackHollow<Real>::stress_intensity(const Real& a,
                                                                             double) const {
  using std::exp, std::sqrt, std::tan;
  const Real alpha = a / wall();
  const Real front = swept_area(a, 0.0);
  UnitStressIntensity<2, Real> k;

  // K_III = T sqrt(mu lambda_TT'/front), where mu drops out (FR-16).
  const auto log_torsion = log_torsion_.value_and_slope(alpha);
  const Real C_T = shallow_torsion_factor_ * exp(log_torsion.value);
  const Real torsion_slope = torsion_scale() / wall() * C_T *
                             (pi / 2 * tan(pi * alpha / 2) + log_sec(alpha) * log_torsion.slope);
  k.III[1] = sqrt(torsion_slope / front);

  // K_I = P sqrt(E lambda_PP'/(2(1-nu^2) front)), where E and nu drop out (FR-16).
  if (p_.open) {
    const auto tension = tension_->value_and_slope(alpha);
    const Real tension_slope =
        tension_scale() / 2 * p_.outer_radius * a * (2 * tension.value + alpha * tension.slope);
    k.I[0] = sqrt(tension_slope / front);
  }
  return k;
}

template <class Real>
Real BasicAnnularCrackHollow<Real>::torsion_scale() const {
  const Real& ro = p_.outer_radius;
  const Real& ri = p_.inner_radius;
  const Real I_p = pi / 2 * (ro * ro + ri * ri) * (ro + ri) * wall();
  return 4 * wall() / (pi * I_p);
}

template <class Real>
Real BasicAnnularCrackHollow<Real>::tension_scale() const {
  const Real A = pi * (p_.outer_radius + p_.inner_radius) * wall();
  const Real stress = kEdgeCrackFactor * pi / A;
  return 2 * stress * stress;
}

template <class Real>
SymmetricMatrix<2, Real> BasicAnnularCrackHollow<Real>::compliance(
    const BasicCrackModuli<Real>& moduli) const {
  const Real& a = p_.depth;
  const Real alpha = a / wall();
  SymmetricMatrix<2, Real> matrix;
  matrix(1, 1) =
      torsion_scale() * log_sec(alpha) * torsion_factor(alpha) / moduli.shear;  // (FR-14)
  if (p_.open)
    matrix(0, 0) =
        tension_scale() * p_.outer_radius * a * a * (*tension_)(alpha) / moduli.opening;  // (FR-15)
  return matrix;
}

template struct BasicAnnularCrackSolid<double>;
template struct BasicAnnularCrackSolid<CrackReal>;
template class BasicAnnularCrackHollow<double>;
template class BasicAnnularCrackHollow<CrackReal>;

}  // namespace strainwave::sif
