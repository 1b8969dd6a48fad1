// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/quantity_text.hpp"

namespace strainwave::test {

/// One row of tests/data/<table>.csv, written by a script of tools/reference:
///
///     case,<input> [<unit>],...,value,unit,digits,source
///
/// All numbers are in strainwave units; an empty cell is an input that does not apply.
struct CsvRow {
  std::string quantity;                  ///< the column `case`
  std::map<std::string, double> inputs;  ///< values by the column's name, without its unit
  double value = 0.0;
  std::string unit;
  int digits = 0;      ///< digits of `value` that can be trusted
  std::string source;  ///< bibliography key, or what computed it
  std::string place;   ///< file:line, for messages

  [[nodiscard]] double operator()(const std::string& input) const {
    const auto found = inputs.find(input);
    if (found == inputs.end()) throw std::runtime_error(place + ": no input " + input);
    return found->second;
  }
  /// Half a unit of the last reliable digit, relative to the smallest number with the same count of
  /// digits.
  [[nodiscard]] double digits_tolerance() const { return 0.5 * std::pow(10.0, 1 - digits); }
};

namespace detail {

inline std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

inline double csv_number(const std::string& cell, const std::string& place) {
  char* end = nullptr;
  const double number = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0' || !std::isfinite(number))
    throw std::runtime_error(place + ": \"" + cell + "\" is not a number");
  return number;
}

}  // namespace detail

/// All rows of tests/data/<table>.csv.
/// @throws std::runtime_error  if the file is not such a table, or has no rows
inline std::vector<CsvRow> read_reference_csv(const std::string& table) {
  const std::string path = std::string(STRAINWAVE_TEST_DATA) + "/" + table + ".csv";
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error(path + ": cannot be read");
  const std::vector<std::string> header = detail::csv_cells(line);
  const std::size_t n = header.size();
  if (n < 5 || header[0] != "case" || header[n - 4] != "value" || header[n - 3] != "unit" ||
      header[n - 2] != "digits" || header[n - 1] != "source")
    throw std::runtime_error(path + ": is not a reference table");
  std::vector<std::string> names;
  for (std::size_t i = 1; i + 4 < n; ++i) {
    const std::string& column = header[i];
    const std::size_t bracket = column.find(" [");
    if (bracket == std::string::npos || column.back() != ']')
      throw std::runtime_error(path + ": column " + column + " has no unit");
    const Unit unit = parse_unit(column.substr(bracket + 2, column.size() - bracket - 3));
    if (unit.factor != 1.0) throw std::runtime_error(path + ": column " + column + " is not SI");
    names.push_back(column.substr(0, bracket));
  }

  std::vector<CsvRow> rows;
  for (int number = 2; std::getline(file, line); ++number) {
    CsvRow row;
    row.place = path + ":" + std::to_string(number);
    const std::vector<std::string> cells = detail::csv_cells(line);
    if (cells.size() != n) throw std::runtime_error(row.place + ": wrong number of cells");
    row.quantity = cells[0];
    for (std::size_t i = 0; i < names.size(); ++i)
      if (!cells[i + 1].empty()) row.inputs[names[i]] = detail::csv_number(cells[i + 1], row.place);
    row.value = detail::csv_number(cells[n - 4], row.place);
    row.unit = cells[n - 3];
    row.digits = static_cast<int>(detail::csv_number(cells[n - 2], row.place));
    row.source = cells[n - 1];
    if (row.unit.empty() || row.digits < 1 || row.source.empty())
      throw std::runtime_error(row.place + ": unit, digits and source are mandatory");
    rows.push_back(std::move(row));
  }
  if (rows.empty()) throw std::runtime_error(path + ": has no rows");
  return rows;
}

/// Compares with a row: to the reliable digits of the row, and to `rounding`, the error of the
/// computation itself, both relative.
inline void expect_row(double actual, const CsvRow& row, double rounding) {
  const double tolerance = std::max(row.digits_tolerance(), rounding);
  EXPECT_NEAR(actual, row.value, std::abs(row.value) * tolerance)
      << row.quantity << " in " << row.unit << ", " << row.place << " (" << row.source << ")";
}

}  // namespace strainwave::test
