// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/method.hpp"
#include "strainwave/study/table_evidence.hpp"

/// @file
/// Many evaluations of one drive with different numbers.

namespace strainwave {

/// Outcome of one row.
enum class RowCode {
  ok,             ///< the numbers may be used
  refused,        ///< the values break a rule of the input
  no_answer,      ///< the method finds no answer
  not_usable,     ///< the row has numbers, but they must not be used
  output_absent,  ///< the result lacks one of the outputs
};
template <>
struct EnumNames<RowCode> {
  static constexpr std::array<std::string_view, 5> names = {"ok", "refused", "no-answer",
                                                            "not-usable", "output-absent"};
};

/// Largest number of threads of a batch.
inline constexpr int kMaxBatchThreads = 256;

/// The work of a batch.
struct BatchTask {
  std::span<const std::string> paths;    ///< paths of p numbers: "output_shaft.crack[0].depth"
  std::span<const double> values;        ///< shape (n, p), row after row [unit of the field]
  std::span<const std::string> outputs;  ///< q names: "cracked.positive.stiffness"
  Method method = Method::corrected;     ///< theory by which each row is evaluated
  int threads = 1;                       ///< 0: as many as the machine can run
};

/// The first row with a code, and the reason.
struct BatchFault {
  RowCode code = RowCode::refused;  ///< any but ok
  std::size_t row = 0;              ///< index of the row, from 0
  std::string message;              ///< the reason, one sentence
};

/// What a batch computed.
struct BatchResult {
  /// Shape (n, q), row after row [SI unit of the output]; 0 if the code of the row says that it has
  /// no numbers.
  std::vector<double> numbers;
  std::vector<RowCode> codes;  ///< shape (n)
  /// one for each code that occurs except ok, in the order of RowCode
  std::vector<BatchFault> faults;
  /// Error of the tables that the rows read (ST-22); absent if the engine computed all rows.
  std::optional<TableEvidence> tables = {};
};

/// Evaluates a drive for each row of values.  The numbers equal those of `evaluate`: within 1e-10
/// if all outputs are those of the sum of the members or strength margins, and tables of the cracks
/// save time for this number of rows (ST-22), otherwise bit for bit.  They have the same bits for
/// any number of threads.  Outputs of these two kinds take a plan of the drive; a row to which the
/// plan has no answer takes `evaluate`, which gives its code and the reason.
///
/// @throws InputError  before any work, if no number of the drive has the path; if no output of the
///                     unchanged drive has the name (the message names near outputs); if a name is
///                     given twice; if the values are not one for each path in each row; if
///                     `threads` is outside 0 to kMaxBatchThreads
/// @throws Error       if `evaluate` throws it for the unchanged drive
/// @throws Stopped     if `progress` requests a stop; it is asked before each row that the calling
///                     thread takes, and at the end
[[nodiscard]] BatchResult batch(const GearSet& gear, const BatchTask& task,
                                const Progress& progress = {});

}  // namespace strainwave
