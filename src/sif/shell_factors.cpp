// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/tube/shell_factors.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "shell_tables.hpp"
#include "strainwave/core/lagrange.hpp"

namespace strainwave::sif {

namespace {

using std::numbers::pi;

/// The variable of the tables, lambda/(lambda + 3).
double mapped(double lambda) { return lambda / (lambda + 3); }

}  // namespace

double shell_parameter(double half_length, double mean_radius, double thickness,
                       double poissons_ratio) {
  const double nu = poissons_ratio;
  return std::sqrt(std::sqrt(12 * (1 - nu * nu))) * half_length /
         std::sqrt(mean_radius * thickness);  // (SU-1)
}

CircumferentialFactors circumferential_factors(double half_angle, double radius_ratio,
                                               double lambda) {
  const auto over_lambda =
      lagrange(lobatto_nodes<16>(0.0, mapped(kMaxCircumferentialShellParameter)), mapped(lambda));
  const auto shallow = [&](std::size_t column) {
    double sum = 0.0;
    for (std::size_t i = 0; i < over_lambda.size(); ++i)
      sum += over_lambda[i] * kCircumferentialTable[column][i];
    return sum;
  };
  const auto over_angle = lagrange(lobatto_nodes<6>(0.05 * pi, 0.5 * pi), half_angle);
  const auto over_ratio =
      lagrange(lobatto_nodes<4>(std::log(5.0), std::log(60.0)), std::log(radius_ratio));
  const auto excess = [&](std::size_t column) {
    double sum = 0.0;
    for (std::size_t i = 0; i < over_angle.size(); ++i)
      for (std::size_t j = 0; j < over_ratio.size(); ++j)
        sum += over_angle[i] * over_ratio[j] * kFiniteAngleTable[column][i][j];
    return sum;
  };
  const double l2 = lambda * lambda;
  const double a1 = half_angle;
  const double a2 = a1 * a1;
  const double opening = 1 + l2 * shallow(0);
  const double opening_linear = shallow(1);
  return {
      .axial = {.mean = opening + a2 * excess(0),  // (SU-4)
                .linear = -(opening_linear + a1 * excess(1))},
      .bending = {.mean = opening + a2 * excess(2), .linear = -(opening_linear + a1 * excess(3))},
      .torque = {.mean = 1 + l2 * shallow(2) + a2 * excess(4),
                 .linear = l2 * shallow(3) + a1 * excess(5)}};
}

}  // namespace strainwave::sif
