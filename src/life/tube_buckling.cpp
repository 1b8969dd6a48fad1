// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/tube_buckling.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Least k for waves of one length around the tube.
/// @param beta  n L/(pi r) [-]; > 0
double coefficient_at(double Z, double beta, int terms) {
  Eigen::VectorXd root(terms);  // of the stiffness of each half wave
  for (int i = 0; i < terms; ++i) {
    const double m = i + 1;
    const double sum = (m * m + beta * beta) * (m * m + beta * beta);
    root(i) = std::sqrt(sum + 12 * Z * Z / std::pow(pi, 4) * std::pow(m, 4) / sum);  // (LI-39)
  }
  Eigen::MatrixXd coupling = Eigen::MatrixXd::Zero(terms, terms);
  for (int i = 0; i < terms; ++i)
    for (int j = i + 1; j < terms; j += 2) {
      const double m = i + 1;
      const double p = j + 1;
      const double value = 8 * beta / pi * m * p / (p * p - m * m) / (root(i) * root(j));
      // The signs alternate with the order of sine and cosine; they do not change the size of the
      // eigenvalues, because even and odd half waves alternate too.
      const double sign = i % 2 == 0 ? 1.0 : -1.0;
      coupling(i, j) = sign * value;  // (LI-39)
      coupling(j, i) = sign * value;
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(coupling, Eigen::EigenvaluesOnly);
  return 1 / solver.eigenvalues()(terms - 1);
}

/// Golden section over the logarithm of beta.
double least_coefficient(double Z, int terms) {
  const auto k = [&](double log_beta) { return coefficient_at(Z, std::exp(log_beta), terms); };
  constexpr int kScan = 60;
  const double from = std::log(0.2);
  const double to = std::log(60.0);
  const double step = (to - from) / kScan;
  int best = 0;
  double least = k(from);
  for (int i = 1; i <= kScan; ++i)
    if (const double here = k(from + i * step); here < least) {
      least = here;
      best = i;
    }
  double a = from + (best - 1) * step;
  double b = from + (best + 1) * step;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double c = b - golden * (b - a);
  double d = a + golden * (b - a);
  double at_c = k(c);
  double at_d = k(d);
  while (b - a > 1e-7) {
    if (at_c < at_d) {
      b = d;
      d = c;
      at_d = at_c;
      c = b - golden * (b - a);
      at_c = k(c);
    } else {
      a = c;
      c = d;
      at_c = at_d;
      d = a + golden * (b - a);
      at_d = k(d);
    }
  }
  return std::min(at_c, at_d);
}

void require_terms(int terms) {
  require(terms >= 4 && terms <= 64, "terms", terms, "1", ">= 4 and <= 64");
}

}  // namespace

double torsional_buckling_coefficient(double Z, int terms) {
  require(Z >= 0 && Z <= 1e5, "Z", Z, "1", ">= 0 and <= 1e5");
  require_terms(terms);
  return least_coefficient(Z, terms);
}

TubeBuckling tube_buckling(const TwistedTube& tube, int terms) {
  require(tube.radius > 0 && std::isfinite(tube.radius), "radius", tube.radius, "m", "> 0");
  require(tube.thickness > 0 && tube.thickness < tube.radius, "thickness", tube.thickness, "m",
          "> 0 and below the radius");
  require(tube.length > 0 && std::isfinite(tube.length), "length", tube.length, "m", "> 0");
  require(tube.youngs_modulus > 0, "youngs_modulus", tube.youngs_modulus, "Pa", "> 0");
  require(tube.poissons_ratio > -1 && tube.poissons_ratio < 0.5, "poissons_ratio",
          tube.poissons_ratio, "1", "> -1 and < 0.5");
  require_terms(terms);
  const double nu2 = 1 - tube.poissons_ratio * tube.poissons_ratio;
  TubeBuckling buckling;
  buckling.Z = tube.length * tube.length / (tube.radius * tube.thickness) * std::sqrt(nu2);
  require(buckling.Z <= 1e5, "length", tube.length, "m", "Batdorf's Z at most 1e5");
  // Whole waves on both sides of the least value: k falls, then rises, over the waves.
  const double per_wave = tube.length / (pi * tube.radius);
  int rising = 0;
  for (int n = 2; rising < 3; ++n) {
    const double k = coefficient_at(buckling.Z, n * per_wave, terms);
    if (buckling.waves == 0 || k < buckling.coefficient) {
      buckling.coefficient = k;
      buckling.waves = n;
      rising = 0;
    } else {
      ++rising;
    }
  }
  const double slenderness = tube.thickness / tube.length;
  buckling.elastic_stress = buckling.coefficient * pi * pi * tube.youngs_modulus / (12 * nu2) *
                            slenderness * slenderness;  // (LI-39)
  buckling.elastic_torque = tube_torque(tube, buckling.elastic_stress);
  return buckling;
}

double plastic_buckling_stress(double elastic_stress, double yield_strength) {
  require(elastic_stress > 0, "elastic_stress", elastic_stress, "Pa", "> 0");
  require(yield_strength > 0, "yield_strength", yield_strength, "Pa", "> 0");
  const double yield = yield_strength / std::sqrt(3.0);
  return 1 / std::hypot(1 / elastic_stress, 1 / yield);  // (LI-40)
}

double tube_torque(const TwistedTube& tube, double stress) {
  return 2 * pi * tube.radius * tube.radius * tube.thickness * stress;
}

}  // namespace strainwave
