// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/io/attachments.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Histories as CSV files of any length: columns by name, units in brackets behind the names.

namespace strainwave {

/// A column of a history.
struct HistoryColumn {
  std::string name;        ///< as written, without its unit; "1", "2", ... if no row names it
  std::string unit;        ///< as written; empty if none is
  std::size_t column = 0;  ///< where its name stands in its line, from 1
};

/// A history that is read in blocks of rows.  The memory does not grow with the file.
///
/// Cells are separated by commas, semicolons or tabs.  The first row names the columns, such as
/// "torque [N*m]".  If it holds numbers only, it is the first row of the history, and the columns
/// are called "1", "2", ...  Empty lines and lines that begin with # are skipped.
class HistoryFile {
 public:
  /// Reads the names of the columns.
  /// @param pieces  content of the file: CSV text in UTF-8
  /// @param name    name of the file in messages
  /// @throws InputError  if the file is empty, holds other bytes than text, or cannot be read
  HistoryFile(TextPieces pieces, std::string name);
  ~HistoryFile();
  /// Move a history.  The object that it is moved from must not be used any more.
  /// @{
  HistoryFile(HistoryFile&&) noexcept;
  HistoryFile& operator=(HistoryFile&&) noexcept;
  /// @}
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// Name of the file in messages.
  [[nodiscard]] const std::string& name() const;
  /// The columns in their order in the file.
  [[nodiscard]] const std::vector<HistoryColumn>& columns() const;
  /// The lines above the names of the columns that begin with #, without it; the first 1000.
  [[nodiscard]] const std::vector<std::string>& remarks() const;
  /// Whether a column has this name; case does not matter.
  [[nodiscard]] bool has(std::string_view column) const;
  /// The number of a column, from 0.
  /// @throws InputError  if no column or more than one has the name; the message names those
  ///                     there are
  [[nodiscard]] std::size_t number_of(std::string_view column) const;
  /// The factor from the unit of a column to an SI unit.
  /// @throws InputError  if the column has no unit, or one of another dimension
  [[nodiscard]] double factor_to(std::string_view si_unit, std::size_t column) const;

  /// Reads the next rows.
  /// @param wanted  numbers of columns
  /// @param most    number of rows
  /// @return        one list of values for each wanted column, in the units of the file; lists are
  ///                empty at the end of the file.  They are valid until the next call.
  /// @throws InputError  if a cell of a wanted column is no finite number, or a row has a wrong
  ///                     number of cells; the message names file, line, column and value
  [[nodiscard]] const std::vector<std::vector<double>>& read(std::span<const std::size_t> wanted,
                                                             std::size_t most = 4096);
  /// Refuses a value of the last block.
  /// @param row      number of the row in the block, from 0
  /// @param column   number of the column, from 0
  /// @param value    the value that is refused, in the unit of the file
  /// @param rule     rule that the value violates: "> 0"
  [[noreturn]] void refuse(std::size_t row, std::size_t column, double value,
                           std::string_view rule) const;
  /// Rows that were read so far.
  [[nodiscard]] std::uint64_t rows() const;
  /// Bytes that were read so far.
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

/// Largest number of rows with a new load in the history of a drive.  They stay in memory.
inline constexpr std::uint64_t kMaxDutyRows = 5'000'000;

/// Reads the history of a duty: the columns time, torque, and output_speed or input_speed with
/// their units.  Rows with the load of the row before are left out, but for the last row.
/// @throws InputError  if a column or its unit is missing, a time is not later than the one before,
///                     there are fewer than two rows, or more than kMaxDutyRows with a new load
[[nodiscard]] DutyRecord read_duty_record(HistoryFile& file);

/// Reads the history that a drive names, if it names one.
void read_duty_record(GearSet& gear, const Attachments& attachments);

}  // namespace strainwave
