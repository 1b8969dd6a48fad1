// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/error.hpp"

namespace strainwave {

/// A column that a table of a user may have.
struct CsvColumn {
  std::string_view name;
  std::string_view si = {};     ///< SI unit of its numbers; "1" if pure
  std::string_view usual = {};  ///< unit in messages; empty: the head gives no unit
  bool required = true;
  std::string unit = "1";  ///< unit in the head
  std::optional<std::size_t> index = {};
};

struct CsvCell {
  std::string text;
  std::size_t column = 0;  ///< column of its first byte in the line, from 1
};

/// Reads the tables that spreadsheets write: with or without a byte order mark, with any line end,
/// cells between commas, semicolons or tabs, with or without quotes, and numbers with a point or a
/// comma.  The head names the columns in any order; other columns are not read.
class CsvReader {
 public:
  /// @param head_rule  what is said of a head that lacks a required column
  CsvReader(std::string_view file_name, std::vector<CsvColumn> columns, std::string_view head_rule);

  /// Calls take_row at each row; the members below then give its cells.
  /// @throws InputError  if the text is not such a table
  void read(std::string_view text, const std::function<void()>& take_row);

  /// A cell of the row as text; empty if the head lacks the column.
  [[nodiscard]] std::string_view text(std::string_view column) const;
  /// A cell of the row as number in SI; the head must name the column.
  [[nodiscard]] double number(std::string_view column);
  /// Line of the row, from 1; 0 after the last.
  [[nodiscard]] std::size_t line() const { return place_.line; }
  /// Refuses a cell of the row.
  [[noreturn]] void refuse(std::string_view column, std::string_view problem) const;
  /// Refuses the row at a column of the line; 0: unknown.
  [[noreturn]] void refuse_at(std::size_t column, std::string_view problem) const;

 private:
  bool take(std::string_view line);
  void read_names(const std::vector<CsvCell>& cells);
  [[noreturn]] void refuse_count(std::size_t n_cells) const;
  [[nodiscard]] const CsvColumn* column_named(std::string_view name) const;

  TextPlace place_;
  std::vector<CsvColumn> columns_;
  std::string head_rule_;
  std::optional<char> told_separator_;  // by a line "sep=;"
  std::optional<char> separator_;
  std::size_t n_columns_ = 0;
  std::vector<CsvCell> cells_;
  std::array<std::size_t, 2> decimal_line_ = {};  // lines in which a point and a comma were seen
};

}  // namespace strainwave
