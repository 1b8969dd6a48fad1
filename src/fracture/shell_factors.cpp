// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fracture/shell_factors.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "shell_table.hpp"
#include "strainwave/core/lagrange.hpp"

namespace strainwave {
namespace {

enum Column : std::size_t { kNN, kTN, kBN, kCN, kNT, kTT, kBT, kCT };

template <class Real>
BasicShellFactors<Real> interpolated(const Real& lambda, const Real& angle) {
  using std::cos, std::sin;
  const auto mapped = [](const auto& x) { return x / (x + 3); };  // the variable of the table
  const auto over_lambda =
      lagrange(lobatto_nodes<12>(0.0, mapped(kShellTableEnd)), Real(mapped(lambda)));
  const auto over_angle = lagrange(lobatto_nodes<7>(1.0, -1.0), Real(cos(2 * angle)));
  const auto value = [&](Column column) {
    Real sum = 0.0;
    for (std::size_t i = 0; i < over_lambda.size(); ++i) {
      Real at_angle = 0.0;
      for (std::size_t j = 0; j < over_angle.size(); ++j)
        at_angle += over_angle[j] * kShellTable[column][j][i];
      sum += over_lambda[i] * at_angle;
    }
    return sum;
  };
  const Real l2 = lambda * lambda;
  // 90 degrees have no exact value in radians; what rounding leaves of the zero is a zero.
  Real sin_2beta = sin(2 * angle);
  if (std::abs(value_of(sin_2beta)) < 1e-15) sin_2beta -= value_of(sin_2beta);
  // The table's bending is positive where the inner face opens more.
  return {
      .opening_by_normal = {.mean = 1 + l2 * value(kNN), .linear = -value(kBN)},  // (SU-2)
      .sliding_by_normal = {.mean = sin_2beta * l2 * value(kTN),
                            .linear = sin_2beta * l2 * value(kCN)},
      .opening_by_shear = {.mean = sin_2beta * l2 * value(kNT), .linear = -sin_2beta * value(kBT)},
      .sliding_by_shear = {.mean = 1 + l2 * value(kTT), .linear = l2 * value(kCT)}};
}

}  // namespace

ShellFactors shell_factors(double lambda, double angle) { return interpolated(lambda, angle); }

BasicShellFactors<DualReal> shell_factors(const DualReal& lambda, const DualReal& angle) {
  return interpolated(lambda, angle);
}

}  // namespace strainwave
