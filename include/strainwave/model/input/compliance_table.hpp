// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/dual.hpp"
#include "strainwave/core/hermite.hpp"

/// @file
/// What a crack adds, from a table of finite elements (`strainwave fe tabulate`) in place of a
/// closed form.

namespace strainwave {

struct GearSet;

/// A number that the answer for one crack depends on: of the crack, its member, its material.
template <class Real>
struct BasicCrackParameter {
  std::string_view name;  ///< "half_length"
  std::string_view unit;  ///< SI
  Real value{};
};

/// One that a table was made with.
struct TableParameter {
  std::string name;
  std::string unit;
  double value = 0.0;
};

/// A number of the crack that the table runs over.
struct TableAxis {
  std::string name;           ///< as BasicCrackParameter::name
  std::string unit;           ///< SI
  bool logarithmic = false;   ///< interpolated over its logarithm
  std::vector<double> nodes;  ///< rising; 4 or more

  /// A value as the coordinate that is interpolated over.
  template <class Real>
  [[nodiscard]] Real coordinate(const Real& value) const {
    using std::log;
    return logarithmic ? Real(log(value)) : value;
  }
};

/// Values over the grid of a table.
struct TableValues {
  enum class Scale {
    logarithmic,  ///< all are positive: their logarithms are interpolated
    linear,       ///< the values themselves are
    nothing,      ///< rounding beside the other sense of torque: 0
  };
  std::vector<double> values;  ///< the last axis runs fastest
  Scale scale = Scale::linear;
  /// (FE-43) of what is interpolated: of the logarithm, or as a share of the largest value [-].
  double interpolation_error = 0.0;
};

/// A table of added compliances, as read from its file.
struct ComplianceTable {
  std::string file;                   ///< as the drive names it
  std::string kind;                   ///< of the crack: "through", "annular"
  std::vector<TableAxis> axes;        ///< one or more
  TableValues positive;               ///< added under torque > 0 [rad/(N*m)]
  TableValues negative;               ///< added under torque < 0 [rad/(N*m)]
  TableValues axial;                  ///< added under axial force [m/N]; empty where there is none
  std::vector<TableParameter> fixed;  ///< everything else that the numbers depend on
  double point_error = 0.0;  ///< largest relative error of a point, as the table states it [-]
  std::string made_by;       ///< program, version, revision, order
};

/// Fewest nodes of an axis: without every second one, two or more must be left.
inline constexpr std::size_t kMinTableNodes = 4;
/// A sense of torque that adds less than this share of the other, at all points, adds nothing.
inline constexpr double kNothingAdded = 1e-4;
/// How far a fixed number of a table may be from the drive's, relative.
inline constexpr double kFixedTolerance = 1e-6;

/// A table with scales and interpolation errors filled in from its values.
///
/// Implements theory manual eq. (FE-43): each axis once without every second node, and the largest
/// difference at the nodes left out; root of the sum of squares over the axes.
[[nodiscard]] ComplianceTable completed(ComplianceTable table);

/// An interpolated value with its error.
template <class Real>
struct TabulatedValue {
  Real value{};
  double relative_error = 0.0;  ///< of the interpolation alone [-]
};

/// Interpolates one column of a table (FE-41).
///
/// @param at  coordinate of each axis (TableAxis::coordinate)
template <class Real>
[[nodiscard]] TabulatedValue<Real> interpolated(const std::vector<TableAxis>& axes,
                                                const TableValues& column,
                                                std::span<const Real> at) {
  if (column.scale == TableValues::Scale::nothing || column.values.empty()) return {};
  std::vector<std::vector<double>> nodes;
  for (const TableAxis& axis : axes) {
    std::vector<double>& x = nodes.emplace_back();
    for (const double node : axis.nodes) x.push_back(axis.coordinate(node));
  }
  if (column.scale == TableValues::Scale::linear) {
    const Real value = tensor_interpolation<Real>(nodes, column.values, at);
    double largest = 0.0;
    for (const double v : column.values) largest = std::max(largest, std::abs(v));
    using std::abs;
    const double size = abs(value) > 0.0 ? largest / std::abs(value_of(value)) : 0.0;
    return {value, column.interpolation_error * size};
  }
  std::vector<double> logarithms;
  for (const double v : column.values) logarithms.push_back(std::log(v));
  using std::exp;
  return {exp(tensor_interpolation<Real>(nodes, logarithms, at)), column.interpolation_error};
}

/// What a crack adds according to its table.
template <class Real>
struct TabulatedCompliance {
  TabulatedValue<Real> positive;  ///< [rad/(N*m)]
  TabulatedValue<Real> negative;  ///< [rad/(N*m)]
  TabulatedValue<Real> axial;     ///< [m/N]; 0 where the table has none
};

/// Reads a table at the numbers of a crack.
///
/// @param table  completed
/// @param crack  all its numbers; they have passed `check_compliance_tables`
template <class Real>
[[nodiscard]] TabulatedCompliance<Real> tabulated_compliance(
    const ComplianceTable& table, const std::vector<BasicCrackParameter<Real>>& crack) {
  std::vector<Real> at;
  for (const TableAxis& axis : table.axes)
    for (const BasicCrackParameter<Real>& number : crack)
      if (number.name == axis.name) at.push_back(axis.coordinate(number.value));
  return {interpolated<Real>(table.axes, table.positive, at),
          interpolated<Real>(table.axes, table.negative, at),
          interpolated<Real>(table.axes, table.axial, at)};
}

/// Holds the cracks of a drive that name a table to it; `check` calls it.
///
/// @throws InputError  naming crack and table: a table that was not read, is of another kind of
///                     crack, or holds another value fixed; a crack outside its range; an axial
///                     force on a crack of the wall, which is not in the table
void check_compliance_tables(const GearSet& gear);

}  // namespace strainwave
