// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/member/ring_edge.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "strainwave/core/polynomial.hpp"

namespace strainwave::sif {

namespace {

using std::numbers::pi;

// Fitted to plane finite elements, tools/reference/cracked_strip.py.  The first coefficient belongs
// to the half plane, the sum of all coefficients to the deep ligament.
constexpr std::array kTension = {1.1215,   -1.6693, 8.0801,  -24.962, 56.3305,
                                 -86.0594, 82.2275, -43.877, 9.9295};
constexpr std::array kBending = {1.1215,   -3.0255, 9.8273,   -28.6524, 61.7662,
                                 -89.4007, 81.0079, -41.2108, 8.9402};

template <class Real>
Real factor(StripLoading loading, const Real& alpha) {
  using std::sqrt;
  const Real ligament = 1 - alpha;
  return polynomial(loading == StripLoading::tension ? kTension : kBending, alpha) /
         (ligament * sqrt(ligament));  // (FR-11)
}

}  // namespace

double edge_crack_factor(StripLoading loading, double depth_ratio) {
  return factor(loading, depth_ratio);
}

template <class Real>
UnitStressIntensity<1, Real> BasicEdgeCrack<Real>::stress_intensity(const Real& a, double) const {
  using std::sqrt;
  UnitStressIntensity<1, Real> k;
  if (open) k.I[0] = factor<Real>(loading, a / thickness) * unit_stress * sqrt(pi * a);
  return k;
}

template struct BasicEdgeCrack<double>;
template struct BasicEdgeCrack<CrackReal>;

}  // namespace strainwave::sif
