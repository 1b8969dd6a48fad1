// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/tube/shell_factors.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

#include "shell_tables.hpp"
#include "strainwave/core/lagrange.hpp"

namespace strainwave::sif {
namespace {

using std::numbers::pi;

/// Columns of the table: mean and linear part of K_I (N, B) or K_II (T, C) by normal (N) or shear
/// (T).
enum Column : std::size_t { kNN, kTN, kBN, kCN, kNT, kTT, kBT, kCT };
constexpr std::size_t kShellColumns = 8;
constexpr std::size_t kShellLambdas = std::tuple_size_v<BasicShellFactorsAtAngle<double>::Table>;
constexpr std::size_t kShellAngles = 7;

/// The variable that the tables use instead of lambda.
double mapped(double lambda) { return lambda / (lambda + 3); }

using ShellColumns = std::array<double, kShellColumns>;

/// The sum of one column is finished before the next begins, which the compiler turns into sums of
/// neighbouring columns.  Sums of all columns by rows it turns into twice as many instructions.
template <std::size_t N>
ShellColumns weighted_rows(const std::array<ShellColumns, N>& rows,
                           const std::array<double, N>& weights) {
  ShellColumns sum{};
  for (std::size_t c = 0; c < kShellColumns; ++c)
    for (std::size_t n = 0; n < N; ++n) sum[c] += weights[n] * rows[n][c];
  return sum;
}

/// The table at one node of lambda: all nodes of the angle, all columns.
using TableOfLambda = std::array<ShellColumns, kShellAngles>;

/// The table in the order in which it is summed, with the columns as neighbours.
const std::array<TableOfLambda, kShellLambdas>& tables_of_lambdas() {
  static const std::array<TableOfLambda, kShellLambdas> tables = [] {
    std::array<TableOfLambda, kShellLambdas> made{};
    for (std::size_t i = 0; i < kShellLambdas; ++i)
      for (std::size_t j = 0; j < kShellAngles; ++j)
        for (std::size_t c = 0; c < kShellColumns; ++c) made[i][j][c] = kShellTable[c][j][i];
    return made;
  }();
  return tables;
}

BasicShellFactorsAtAngle<double>::Table over_angle(
    const std::array<double, kShellAngles>& weights) {
  BasicShellFactorsAtAngle<double>::Table table{};
  for (std::size_t i = 0; i < kShellLambdas; ++i)
    table[i] = weighted_rows(tables_of_lambdas()[i], weights);
  return table;
}

}  // namespace

template <class Real>
BasicShellFactorsAtAngle<Real>::BasicShellFactorsAtAngle(const Real& angle) : angle_(angle) {
  using std::sin;
  static const LagrangeBasis<kShellAngles> basis(lobatto_nodes<kShellAngles>(1.0, -1.0));
  const double twice = 2 * value_of(angle);
  value_ = over_angle(basis.values(std::cos(twice)));
  if constexpr (is_dual<Real>) {
    by_angle_ = over_angle(basis.at(std::cos(twice)).slope);
    const double cosine_slope = -2 * std::sin(twice);
    for (auto& row : by_angle_)
      for (double& entry : row) entry *= cosine_slope;
  }
  // 90 degrees cannot be represented exactly in radians, so treat a rounding error as zero.
  sin_2beta_ = sin(2 * angle);
  if (std::abs(value_of(sin_2beta_)) < 1e-15) sin_2beta_ -= value_of(sin_2beta_);
}

template <class Real>
BasicShellFactors<Real> BasicShellFactorsAtAngle<Real>::at(const Real& lambda) const {
  static const LagrangeBasis<kShellLambdas> basis(
      lobatto_nodes<kShellLambdas>(0.0, mapped(kShellTableEnd)));
  const double l = value_of(lambda);
  std::array<Real, kShellColumns> value{};
  if constexpr (is_dual<Real>) {
    const auto over_lambda = basis.at(mapped(l));
    const ShellColumns values = weighted_rows(value_, over_lambda.value);
    const ShellColumns by_mapped = weighted_rows(value_, over_lambda.slope);
    const ShellColumns by_angle = weighted_rows(by_angle_, over_lambda.value);
    const double slope = 3 / ((l + 3) * (l + 3));  // of the mapped lambda
    for (std::size_t c = 0; c < kShellColumns; ++c) {
      value[c].value = values[c];
      for (std::size_t k = 0; k < Real::kPartials; ++k)
        value[c].partial[k] =
            by_mapped[c] * slope * lambda.partial[k] + by_angle[c] * angle_.partial[k];
    }
  } else {
    value = weighted_rows(value_, basis.values(mapped(l)));
  }
  const Real l2 = lambda * lambda;
  // The bending in the table is positive if the inner face opens more.
  return {.opening_by_normal = {.mean = 1 + l2 * value[kNN], .linear = -value[kBN]},  // (SU-2)
          .sliding_by_normal = {.mean = sin_2beta_ * l2 * value[kTN],
                                .linear = sin_2beta_ * l2 * value[kCN]},
          .opening_by_shear = {.mean = sin_2beta_ * l2 * value[kNT],
                               .linear = -sin_2beta_ * value[kBT]},
          .sliding_by_shear = {.mean = 1 + l2 * value[kTT], .linear = l2 * value[kCT]}};
}

template class BasicShellFactorsAtAngle<double>;
template class BasicShellFactorsAtAngle<CrackReal>;

ShellFactors shell_factors(double lambda, double angle) {
  return BasicShellFactorsAtAngle<double>(angle).at(lambda);
}

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
