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
/// Added compliance of a crack from a table of finite elements (`strainwave fe tabulate`), which
/// replaces the closed form.

namespace strainwave {

struct GearSet;

/// A number of the crack, its member or its material on which the result for the crack depends.
template <class Real>
struct BasicCrackParameter {
  std::string_view name;  ///< "half_length"
  std::string_view unit;  ///< SI
  Real value{};           ///< in that unit
};

/// A parameter with its value when the table was made.
struct TableParameter {
  std::string name;    ///< as BasicCrackParameter::name
  std::string unit;    ///< SI
  double value = 0.0;  ///< in that unit
};

/// A parameter over which a table runs.
struct TableAxis {
  std::string name;           ///< name as in BasicCrackParameter::name
  std::string unit;           ///< SI
  bool logarithmic = false;   ///< whether interpolation uses the logarithm
  std::vector<double> nodes;  ///< nodes in ascending order; 4 or more

  /// Converts a value to the coordinate of the interpolation.
  template <class Real>
  [[nodiscard]] Real coordinate(const Real& value) const {
    using std::log;
    return logarithmic ? Real(log(value)) : value;
  }
};

/// Values over the grid of a table.
struct TableValues {
  /// How the values are interpolated.
  enum class Scale {
    logarithmic,  ///< all values are positive, so their logarithms are interpolated
    linear,       ///< the values themselves are interpolated
    /// the values are rounding compared with the other sense of torque and count as 0
    nothing,
  };
  std::vector<double> values;   ///< the last axis runs fastest
  Scale scale = Scale::linear;  ///< chosen by `completed`
  /// Interpolation error by (FE-43) [-]: of the logarithm, or as a share of the largest value.
  double interpolation_error = 0.0;
};

/// A table of added compliances, as read from its file.
struct ComplianceTable {
  std::string file;             ///< file name as the drive gives it
  std::string kind;             ///< kind of the crack: "through", "annular"
  std::vector<TableAxis> axes;  ///< one or more
  TableValues positive;         ///< added under torque > 0 [rad/(N*m)]
  TableValues negative;         ///< added under torque < 0 [rad/(N*m)]
  /// added under axial force [m/N]; empty if the table has no such column
  TableValues axial;
  std::vector<TableParameter> fixed;  ///< all other parameters on which the numbers depend
  double point_error = 0.0;  ///< largest relative error of a point, as the table states it [-]
  std::string made_by;       ///< program, version, revision, order
};

/// Fewest nodes of an axis.  The error estimate removes every second node, and two nodes or more
/// must remain.
inline constexpr std::size_t kMinTableNodes = 4;
/// A sense of torque counts as adding nothing if it adds less than this share of the other sense at
/// all points.
inline constexpr double kNothingAdded = 1e-4;
/// Largest relative deviation of a fixed number of a table from the drive's number.
inline constexpr double kFixedTolerance = 1e-6;

/// The table with scales and interpolation errors computed from its values.
///
/// Implements theory manual eq. (FE-43).  For each axis, every second node is removed, and the
/// largest difference at the removed nodes is the error of the axis.  The total is the root of the
/// sum of squares over the axes.
[[nodiscard]] ComplianceTable completed(ComplianceTable table);

/// An interpolated value with its error.
template <class Real>
struct TabulatedValue {
  Real value{};                 ///< in the unit of the column
  double relative_error = 0.0;  ///< error of the interpolation alone [-]
};

/// Interpolates one column of a table (FE-41).
///
/// @param axes    axes of the table; one or more
/// @param column  values over the grid of the axes; none, or Scale::nothing, give 0
/// @param at      coordinate of each axis (TableAxis::coordinate)
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

/// Compliance that a crack adds according to its table.
template <class Real>
struct TabulatedCompliance {
  TabulatedValue<Real> positive;  ///< added under torque > 0 [rad/(N*m)]
  TabulatedValue<Real> negative;  ///< added under torque < 0 [rad/(N*m)]
  TabulatedValue<Real> axial;  ///< added under axial force [m/N]; 0 if the table has no such column
};

/// Reads a table at the numbers of a crack.
///
/// @param table  completed
/// @param crack  all numbers of the crack; they have passed `check_compliance_tables`
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

/// Checks the cracks of a drive against the tables that they name; `check` calls it.
///
/// @throws InputError  if a table was not read, is for another kind of crack, or has another fixed
///                     value; if the crack is outside the range of its table; if an axial force
///                     acts on a crack of the wall, which tables do not cover.  The message names
///                     crack and table
void check_compliance_tables(const GearSet& gear);

}  // namespace strainwave
