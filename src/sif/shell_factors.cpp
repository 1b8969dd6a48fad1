// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/tube/shell_factors.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

#include "shell_tables.hpp"
#include "strainwave/core/lagrange.hpp"

namespace strainwave::sif {
namespace {

using std::numbers::pi;

enum Column : std::size_t { kNN, kTN, kBN, kCN, kNT, kTT, kBT, kCT };

/// The variable that the tables use instead of lambda.
double mapped(double lambda) { return lambda / (lambda + 3); }

/// All columns of the table, and their derivatives with respect to lambda and the angle.
struct TableColumns {
  std::array<double, 8> value{};
  std::array<double, 8> by_lambda{};
  std::array<double, 8> by_angle{};

  [[nodiscard]] double at(Column c, double, double) const { return value[c]; }
  [[nodiscard]] DualReal at(Column c, const DualReal& lambda, const DualReal& angle) const {
    return chain(lambda, value[c], by_lambda[c]) + chain(angle, 0.0, by_angle[c]);
  }
};

/// @tparam slopes  false: without derivatives
template <bool slopes>
TableColumns table_columns(double lambda, double angle) {
  static const LagrangeBasis<12> lambda_basis(lobatto_nodes<12>(0.0, mapped(kShellTableEnd)));
  static const LagrangeBasis<7> angle_basis(lobatto_nodes<7>(1.0, -1.0));
  const auto over_lambda = lambda_basis.at(mapped(lambda));
  const auto over_angle = angle_basis.at(std::cos(2 * angle));
  const double mapped_slope = 3 / ((lambda + 3) * (lambda + 3));
  const double cosine_slope = -2 * std::sin(2 * angle);
  TableColumns result;
  for (std::size_t c = 0; c < 8; ++c)
    for (std::size_t j = 0; j < 7; ++j) {
      double value = 0.0;
      double slope = 0.0;
      for (std::size_t i = 0; i < 12; ++i) {
        value += over_lambda.value[i] * kShellTable[c][j][i];
        if constexpr (slopes) slope += over_lambda.slope[i] * kShellTable[c][j][i];
      }
      result.value[c] += over_angle.value[j] * value;
      if constexpr (!slopes) continue;
      result.by_lambda[c] += over_angle.value[j] * slope * mapped_slope;
      result.by_angle[c] += over_angle.slope[j] * value * cosine_slope;
    }
  return result;
}

template <class Real>
BasicShellFactors<Real> interpolated(const Real& lambda, const Real& angle) {
  using std::sin;
  const TableColumns table =
      table_columns<!std::is_same_v<Real, double>>(value_of(lambda), value_of(angle));
  const auto value = [&](Column column) { return table.at(column, lambda, angle); };
  const Real l2 = lambda * lambda;
  // 90 degrees cannot be represented exactly in radians, so treat a rounding error as zero.
  Real sin_2beta = sin(2 * angle);
  if (std::abs(value_of(sin_2beta)) < 1e-15) sin_2beta -= value_of(sin_2beta);
  // The bending in the table is positive if the inner face opens more.
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
