// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "strainwave/core/asked_units.hpp"
#include "strainwave/core/fields.hpp"

namespace strainwave {

/// A table for people.  A layout fills it, and any kind of document can show it.
struct Table {
  std::vector<std::string> head = {};  ///< heads of the columns; all empty: no head is shown
  /// "lrr"; columns left out: the first is aligned left, others right
  std::string_view align = {};
  /// Rows; a row may end early.  In text, a row with a single cell spans the columns.
  std::vector<std::vector<std::string>> rows = {};
};

/// A table of a result with its title and its remark.
struct TitledTable {
  std::string title;
  Table table;
  std::string remark = {};
};

[[nodiscard]] std::string exact_text(double value);
[[nodiscard]] std::string exact_text(int value);
[[nodiscard]] std::string exact_text(bool value);

/// A cell of a file for programs: all digits of a number, empty if the value is absent.
template <class Value>
[[nodiscard]] std::string cell(const Value& value) {
  if constexpr (is_optional<Value>)
    return value ? cell(*value) : std::string();
  else if constexpr (std::is_enum_v<Value>)
    return std::string(enum_name(value));
  else if constexpr (std::is_convertible_v<const Value&, std::string_view>)
    return std::string(std::string_view(value));  // otherwise a literal would convert to bool
  else
    return exact_text(value);
}
/// A row of cells for programs.
template <class... Values>
[[nodiscard]] std::vector<std::string> cells(const Values&... values) {
  return {cell(values)...};
}

/// A table as text.  Columns are as wide as their content, with two blanks between them; every line
/// is indented by two blanks.
[[nodiscard]] std::string text_table(const Table& table);
/// Tables as text, each after an empty line and its title, with its remark.
[[nodiscard]] std::string text_tables(const std::vector<TitledTable>& tables);
[[nodiscard]] std::string markdown_table(const Table& table);
/// A row as a line of CSV by RFC 4180, ended by a line feed.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& row);
[[nodiscard]] std::string csv_table(const Table& table);

/// A CSV table with its numbers in other units: those of a column "name [unit]", and those in a
/// column "value" with a unit in a column "unit", "x" with "x_unit", of the output or field that
/// the first column names.
/// @param csv  table as csv_table writes it; remarks above its head, which begin with #, stay
[[nodiscard]] std::string csv_in_units(const std::string& csv, const AskedUnits& units);
/// Some columns of a CSV table, in the order asked.
/// @param names  names of columns, without their units
/// @throws InputError  if a column does not exist; the message names the nearest column
[[nodiscard]] std::string csv_columns(const std::string& csv,
                                      const std::vector<std::string>& names);

}  // namespace strainwave
