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
/// The file of a compliance table: comments that say what it is, one line of column names with
/// units, one line for each point, in SI.  `strainwave fe tabulate` writes it point by point.

namespace strainwave {

/// The format that this version reads and writes.
inline constexpr std::string_view kTableFormat = "strainwave-compliance-table/1";

/// A number that a table runs over.
struct TableRange {
  TableParameter parameter;  ///< its name and unit; its value is not used
  Variation variation;       ///< of which number of the drive, from where to where
};

struct TableColumn {
  std::string name;
  std::string unit;
};

/// Everything that a table says before its first point.
struct TableHead {
  std::string kind;       ///< of the crack
  std::string crack;      ///< its path in the input
  std::string program;    ///< name, version, revision
  std::string input;      ///< name of the input file
  std::string digest;     ///< SHA-256 of the drive, the varied numbers at their first values
  int order = 0;          ///< p of the elements
  std::string equations;  ///< tags
  std::string held;       ///< how the member is held and loaded
  std::vector<TableRange> ranges;
  std::vector<TableParameter> fixed;
  std::vector<TableColumn> columns;  ///< between the varied numbers and `relative_error`
};

/// One point of a table.
struct TablePoint {
  std::vector<double> at;                     ///< the varied numbers
  std::vector<std::optional<double>> values;  ///< of TableHead::columns
  std::optional<double> relative_error;       ///< of the added compliances [-]
  bool usable = false;
  std::size_t unknowns = 0;
  double seconds = 0.0;
  std::string reason;  ///< why not usable
};

/// The text before the first point: comments and the names of the columns.
[[nodiscard]] std::string table_head_text(const TableHead& head);
/// The line of one point, with its end of line.
[[nodiscard]] std::string table_row_text(const TablePoint& row);

/// A table file, as far as it got.
struct TableFile {
  std::string head;              ///< as table_head_text
  std::vector<TablePoint> rows;  ///< the whole ones
  std::size_t whole = 0;         ///< bytes up to the end of the last whole line
  bool torn = false;             ///< there is a piece of a line behind it
};

/// Takes a table file apart.
/// @param text  of the file
/// @param name  for messages
/// @throws InputError  with the line, where it is no table
[[nodiscard]] TableFile parse_table_file(std::string_view text, std::string_view name);

/// A table for the stiffness model, with its errors filled in.
///
/// Over one axis a family that is not finished is a table of a shorter range; over several, its
/// grid must be full.
///
/// @param name  as the drive has it
/// @throws InputError  not a table of this format; a point missing, twice, or not usable; fewer
///                     than kMinTableNodes nodes along an axis
[[nodiscard]] ComplianceTable parse_compliance_table(std::string_view text, std::string_view name);

/// Reads the tables that the cracks of a drive name.
///
/// @throws InputError  naming the crack; as Attachments::text, and as parse_compliance_table
void read_compliance_tables(GearSet& gear, const Attachments& attachments);

}  // namespace strainwave
