// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/study/simulation_report.hpp"

/// @file
/// The record of a motion, row by row, as CSV or in a compact binary form.  Both have the columns
/// SimulationRow; those that no row has are left out.

namespace strainwave {

enum class RecordForm { csv, binary };
template <>
struct EnumNames<RecordForm> {
  static constexpr std::array<std::string_view, 2> names = {"csv", "bin"};
};

/// Which columns a record has beside those of each motion.
struct RecordColumns {
  bool cracked = false;       ///< those of the cracked drive
  bool output_given = false;  ///< the torque that the given motion of the output needs
};

/// Where a record comes from; its binary form states it.
struct RecordOrigin {
  std::string version;
  std::string revision;
  std::string input_file;                                         ///< name of the drive's file
  std::string input_sha256;                                       ///< of its text
  std::vector<std::pair<std::string, std::string>> options = {};  ///< name and text
};

/// Begin of a record, before its first row.
///
/// The binary form begins with the eight letters "swmotion", then two little-endian integers of
/// four bytes: the version 1 of the form, and the number of bytes of the text that follows.  The
/// text is JSON: the origin, the columns with name and unit, and the bytes of a row.  Blanks end
/// it, so that the rows begin at a multiple of 8 bytes.
[[nodiscard]] std::string record_head(RecordForm form, const RecordOrigin& origin,
                                      const RecordColumns& columns);

/// Adds a row to the end of a text.  In the binary form it has little-endian numbers of double
/// precision by IEEE 754, and NaN in place of a value that is absent.
void add_record_row(std::string& to, RecordForm form, const SimulationRow& row,
                    const RecordColumns& columns);

}  // namespace strainwave
