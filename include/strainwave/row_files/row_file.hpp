// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "strainwave/core/row_sink.hpp"

/// @file
/// Rows of a study in a file: HDF5 or CSV, by the end of its name.  A file is written completely or
/// not at all, and the memory does not depend on the number of rows.

namespace strainwave {

/// Version of the layout of the HDF5 files, their attribute `format`.
inline constexpr std::string_view kRowsFormat = "strainwave-rows/1";

/// Number of rows that an HDF5 file compresses together, its chunk.
inline constexpr std::size_t kRowsOfChunk = 16384;

/// Largest number of different rules in an HDF5 file.  The last one stands for all further rules,
/// so that the memory stays constant.
inline constexpr std::size_t kMostRules = 65536;

/// Rows that are written to a temporary file beside the file that they will replace.  The
/// destructor removes the temporary file.
class RowFile : public RowSink {
 public:
  /// Writes what is left and closes the temporary file.
  /// @throws Error  if the file cannot be written, or if rows are missing
  virtual void finish() = 0;
  /// Replaces the file by the finished temporary file.
  /// @throws Error  if the file cannot be replaced
  virtual void replace() = 0;
};

/// The file of this name.
/// @param path  ends in .h5 or .hdf5, or in .csv
/// @throws InputError  if the name ends otherwise, or if HDF5 is not part of this program
/// @throws Error       if the file cannot be written; so do all members of the file
[[nodiscard]] std::unique_ptr<RowFile> row_file(const std::string& path);

}  // namespace strainwave
