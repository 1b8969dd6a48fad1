// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/compliance_table.hpp"

#include <fmt/format.h>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/input/crack_parameters.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {
namespace {

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  return largest;
}

/// Largest difference at the nodes that are removed when every second node of one axis is left out
/// (FE-43).
double error_along(const std::vector<std::vector<double>>& nodes,
                   const std::vector<double>& ordinates, std::size_t axis) {
  std::size_t stride = 1;
  for (std::size_t a = axis + 1; a < nodes.size(); ++a) stride *= nodes[a].size();
  const std::vector<double>& x = nodes[axis];
  const std::size_t n = x.size();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < n; i += 2) kept.push_back(i);
  if (kept.back() != n - 1) kept.push_back(n - 1);
  std::vector<double> coarse;
  for (const std::size_t i : kept) coarse.push_back(x[i]);
  double largest = 0.0;
  // A line of the grid along the axis starts where the index of this axis is 0.
  for (std::size_t start = 0; start < ordinates.size(); ++start) {
    if (start / stride % n != 0) continue;
    std::vector<double> y;
    for (const std::size_t i : kept) y.push_back(ordinates[start + i * stride]);
    for (std::size_t i = 1; i + 1 < n; i += 2)
      largest = std::max(largest, std::abs(hermite_interpolation<double, double>(coarse, y, x[i]) -
                                           ordinates[start + i * stride]));
  }
  return largest;
}

void fill_error(const std::vector<TableAxis>& axes, TableValues& column) {
  if (column.values.empty() || column.scale == TableValues::Scale::nothing) return;
  const bool positive = std::ranges::all_of(column.values, [](double v) { return v > 0; });
  column.scale = positive ? TableValues::Scale::logarithmic : TableValues::Scale::linear;
  const double largest = largest_of(column.values);
  std::vector<double> ordinates;
  for (const double v : column.values) ordinates.push_back(positive ? std::log(v) : v / largest);
  std::vector<std::vector<double>> nodes;
  for (const TableAxis& axis : axes) {
    std::vector<double>& x = nodes.emplace_back();
    for (const double node : axis.nodes) x.push_back(axis.coordinate(node));
  }
  double squares = 0.0;
  for (std::size_t a = 0; a < axes.size(); ++a)
    squares += std::pow(error_along(nodes, ordinates, a), 2);
  column.interpolation_error = std::sqrt(squares);  // (FE-43)
}

bool adds_nothing(const std::vector<double>& values, const std::vector<double>& other) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(std::abs(values[i]) <= kNothingAdded * std::abs(other[i]))) return false;
  return true;
}

bool agree(double a, double b) {
  return std::abs(a - b) <= kFixedTolerance * std::max(std::abs(a), std::abs(b));
}

/// Checks a crack against its table.
template <class Crack>
void check_one(const GearSet& gear, const std::string& path, const Crack& crack) {
  const std::string at = path + ".compliance_table";
  const std::string& file = *crack.compliance_table;
  const auto found = gear.compliance_tables.find(file);
  if (found == gear.compliance_tables.end())
    throw InputError(at, fmt::format("\"{}\" has not been read", shown(file)));
  const ComplianceTable& table = found->second;
  const auto refuse = [&](const std::string& problem) {
    throw InputError(at, fmt::format("\"{}\" {}", shown(file), problem));
  };
  if (table.kind != Crack::kKind)
    refuse(fmt::format("is a table of cracks of kind \"{}\", not \"{}\"", shown(table.kind),
                       Crack::kKind));
  const auto numbers = crack_parameters(Lift<double>(), gear, crack);
  const auto same_unit = [&](const auto& given, const auto& number) {
    if (given.unit != number.unit)
      refuse(fmt::format("has {} in \"{}\", not in \"{}\"", number.name, shown(given.unit),
                         number.unit));
  };
  for (const auto& number : numbers) {
    const auto axis = std::ranges::find(table.axes, number.name, &TableAxis::name);
    if (axis != table.axes.end()) {
      same_unit(*axis, number);
      if (!(number.value >= axis->nodes.front() && number.value <= axis->nodes.back()))
        refuse(fmt::format("covers {} to {} of {}, but the drive has {}",
                           shown_quantity(axis->nodes.front(), number.unit, 9, number.name),
                           shown_quantity(axis->nodes.back(), number.unit, 9, number.name),
                           number.name, shown_quantity(number.value, number.unit, 9, number.name)));
      continue;
    }
    const auto fixed = std::ranges::find(table.fixed, number.name, &TableParameter::name);
    if (fixed == table.fixed.end())
      refuse(fmt::format("does not state the {} of its computation", number.name));
    same_unit(*fixed, number);
    if (!agree(fixed->value, number.value))
      refuse(fmt::format("was made with {} = {}, but the drive has {}", number.name,
                         shown_quantity(fixed->value, number.unit, 9, number.name),
                         shown_quantity(number.value, number.unit, 9, number.name)));
  }
  if constexpr (requires { crack.angle; })
    if (gear.load.axial_force != 0)
      refuse("is a table for torque alone, so load.axial_force must be 0");
}

}  // namespace

ComplianceTable completed(ComplianceTable table) {
  using Scale = TableValues::Scale;
  if (adds_nothing(table.negative.values, table.positive.values))
    table.negative.scale = Scale::nothing;
  else if (adds_nothing(table.positive.values, table.negative.values))
    table.positive.scale = Scale::nothing;
  for (TableValues* const column : {&table.positive, &table.negative, &table.axial})
    fill_error(table.axes, *column);
  return table;
}

void check_compliance_tables(const GearSet& gear) {
  for_each_tabulated_kind(gear, [&](const CrackPath& path, const auto& crack) {
    if (crack.compliance_table) check_one(gear, path, crack);
  });
}

}  // namespace strainwave
