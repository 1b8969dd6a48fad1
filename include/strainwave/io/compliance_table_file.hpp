// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/io/attachments.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/variation.hpp"

/// @file
/// The file of a compliance table.  Comments describe the table; one line gives the column names
/// with units; each further line is one point, in SI units.  `strainwave fe tabulate` writes it
/// point by point.

namespace strainwave {

/// The format that this version reads and writes.
inline constexpr std::string_view kTableFormat = "strainwave-compliance-table/1";

/// A parameter over which a table runs.
struct TableRange {
  TableParameter parameter;  ///< name and unit of the parameter; its value is not used
  Variation variation;       ///< the number of the drive that varies, and its range
};

/// A column of a table, which the file names as `name [unit]`.
struct TableColumn {
  std::string name;  ///< "added_compliance_positive"
  std::string unit;  ///< SI: "rad/(N*m)"
};

/// The head of a table: everything before its first point.
struct TableHead {
  std::string kind;       ///< kind of the crack
  std::string crack;      ///< path of the crack in the input
  std::string program;    ///< name, version and revision of the program
  std::string input;      ///< name of the input file
  std::string digest;     ///< SHA-256 of the drive with the varied numbers at their first values
  int order = 0;          ///< p of the elements
  std::string equations;  ///< equation tags
  std::string held;       ///< supports and loads of the member
  std::vector<TableRange> ranges;     ///< parameters that vary, one for each axis
  std::vector<TableParameter> fixed;  ///< parameters with one value in the whole table
  std::vector<TableColumn> columns;   ///< columns between the varied numbers and `relative_error`
};

/// One point of a table.
struct TablePoint {
  std::vector<double> at;                     ///< values of the varied numbers
  std::vector<std::optional<double>> values;  ///< values of TableHead::columns
  std::optional<double> relative_error;       ///< error of the added compliances [-]
  bool usable = false;                        ///< whether the values may be used
  std::size_t unknowns = 0;                   ///< number of unknowns of the finite-element solution
  double seconds = 0.0;                       ///< time that the point took [s]
  std::string reason;                         ///< why the point is not usable
};

/// The text before the first point: comments and the names of the columns.
[[nodiscard]] std::string table_head_text(const TableHead& head);
/// The line of one point, with its end of line.
[[nodiscard]] std::string table_row_text(const TablePoint& row);

/// A table file, possibly unfinished.
struct TableFile {
  std::string head;              ///< head, as table_head_text writes it
  std::vector<TablePoint> rows;  ///< points of the complete lines
  std::size_t whole = 0;         ///< bytes up to the end of the last complete line
  bool torn = false;             ///< whether an incomplete line follows
};

/// Splits a table file into head and points.
/// @param text  content of the file
/// @param name  name of the file in messages
/// @throws InputError  if the text is not a table; the message names the line
[[nodiscard]] TableFile parse_table_file(std::string_view text, std::string_view name);

/// Reads a table for the stiffness model, with its error estimates filled in.
///
/// An unfinished table over one axis is read as a table with a shorter range.  Over several axes,
/// the grid must be complete.
///
/// @param text  content of the file
/// @param name  name of the table as the drive gives it
/// @throws InputError  if the text is not a table of this format; if a point is missing, occurs
///                     twice or is not usable; if an axis has fewer than kMinTableNodes nodes
[[nodiscard]] ComplianceTable parse_compliance_table(std::string_view text, std::string_view name);

/// Reads the tables that the cracks of a drive name.
///
/// @throws InputError  for the reasons of Attachments::text and parse_compliance_table; the message
///                     names the crack
void read_compliance_tables(GearSet& gear, const Attachments& attachments);

}  // namespace strainwave
