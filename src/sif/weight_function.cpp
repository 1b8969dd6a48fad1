// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/weight_function.hpp"

namespace strainwave::sif {
namespace {

using std::numbers::pi;

// Theory manual table of (SW-2), by tools/reference/weight_function.py --fit: Chebyshev
// coefficients over 2 alpha - 1 of (1 - alpha)^1.5 K/sqrt(pi a), for the stresses P_2j(v).
constexpr std::size_t kMoments = 6;
constexpr std::size_t kDegree = 10;
// clang-format off
constexpr std::array<std::array<double, kDegree + 1>, kMoments> kMomentTable = {{
    {1.048800947e+00, 3.258536639e-02, 5.994592568e-02, -2.792174397e-02, 1.107368910e-02, -3.987826192e-03, 1.474781020e-03, -5.710117192e-04, 2.120704588e-04, -7.348095104e-05, 3.078618023e-05},
    {3.076705939e-01, 2.457991130e-01, 1.659170665e-02, -1.233491240e-02, 4.086649278e-03, -1.445522688e-03, 5.598960537e-04, -2.153659095e-04, 7.873991761e-05, -2.664675139e-05, 1.140895089e-05},
    {2.709124996e-02, 3.147484231e-02, 1.112650765e-02, 2.945593900e-04, -6.044871443e-05, 1.540431412e-04, 3.828894108e-06, 1.246573200e-05, -3.047864067e-06, 1.606351729e-06, -6.139379903e-07},
    {-2.081274122e-03, -2.838602478e-03, -1.545777989e-03, -3.683064621e-04, -1.045277492e-04, -4.804155525e-05, -6.142600327e-06, -8.237245688e-06, -2.650791872e-06, -1.826476638e-06, -4.254248180e-07},
    {2.946231307e-04, 8.061569713e-04, 3.456848887e-04, 1.870446031e-04, 7.084544892e-05, 1.918597968e-05, 1.042774360e-05, 5.371305820e-06, 2.990030929e-06, 1.430456123e-06, 6.668687784e-07},
    {-1.396276878e-04, -1.699998073e-04, -1.570121223e-04, -8.233202873e-05, -3.641190726e-05, -1.637027524e-05, -7.274490202e-06, -3.431979060e-06, -1.814075616e-06, -9.988634564e-07, -5.191535799e-07}}};
// clang-format on

double chebyshev(const std::array<double, kDegree + 1>& c, double x) {
  double b1 = 0.0;
  double b2 = 0.0;
  for (std::size_t k = kDegree; k > 0; --k) {
    const double b = 2 * x * b1 - b2 + c[k];
    b2 = b1;
    b1 = b;
  }
  return x * b1 - b2 + c[0];
}

/// Coefficients of P_2j in powers of v^2, j = 0 ... 6.
std::array<std::array<double, kMoments + 1>, kMoments + 1> even_legendre() {
  std::array<std::array<double, kMoments + 1>, kMoments + 1> P{};
  for (int j = 0; j <= static_cast<int>(kMoments); ++j) {
    // P_2j = sum_i (-1)^(j-i) (2j+2i)! / (4^j (j-i)! (j+i)! (2i)!) v^(2i)
    double c = 1.0;
    for (int k = 1; k <= j; ++k) c *= -(2.0 * k - 1) / (2.0 * k);
    for (int i = 0; i <= j; ++i) {
      P[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = c;
      c *= -2.0 * (2 * j + 2 * i + 1) * (j - i) / ((2.0 * i + 1) * (2.0 * i + 2));
    }
  }
  return P;
}

}  // namespace

EdgeWeight::EdgeWeight(double depth_ratio) {
  static const auto kP = even_legendre();
  const double deep = std::pow(1 - depth_ratio, -1.5);
  // The moments determine the parts of M along P_0 ... P_10; the part along P_12 makes M(0) = 1.
  double tip = 1.0;
  const auto add = [&](std::size_t j, double part) {
    for (std::size_t i = 0; i <= j; ++i) M_[i] += part * kP[j][i];
    tip -= part * kP[j][0];
  };
  for (std::size_t j = 0; j < kMoments; ++j)
    add(j, (4 * static_cast<double>(j) + 1) * pi / (2 * std::numbers::sqrt2) * deep *
               chebyshev(kMomentTable[j], 2 * depth_ratio - 1));  // (SW-2)
  add(kMoments, tip / kP[kMoments][0]);
}

SurfaceWeight::SurfaceWeight(double aspect_ratio, double depth_ratio)
    : fit_(aspect_ratio), alpha_(depth_ratio) {
  // Values for the stresses 1 and x/a, in the units of the integrals of 1 + M_1 v + M_2 v^2 + M_3
  // v^3.
  const double A0 = pi / (2 * std::numbers::sqrt2) * fit_.tension(alpha_, pi / 2);
  const double A1 = A0 * fit_.linear_ratio(alpha_, pi / 2);
  const double M1 = 12 * A1 - 4 * A0 - 4.8;
  deepest_ = {1.0, M1, 3.0, 4 * A0 - 8 - 2 * M1};  // (SW-3)

  const double B0 = pi / 4 * fit_.tension(alpha_, 0.0);
  const double B1 = B0 * fit_.linear_ratio(alpha_, 0.0);
  surface_ = {1.0, 24 * B0 - 60 * B1 - 8, -60 * B0 + 180 * B1 + 15,
              36 * B0 - 120 * B1 - 8};  // (SW-4)
}

}  // namespace strainwave::sif
