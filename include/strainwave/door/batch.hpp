// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/method.hpp"

/// @file
/// Many evaluations of one drive whose numbers differ.

namespace strainwave {

/// What came of one row.
enum class RowCode {
  ok,             ///< its numbers may be used
  refused,        ///< its values break a rule of the input
  no_answer,      ///< the method does not deliver
  not_usable,     ///< it has numbers, which may not be used
  output_absent,  ///< its result has not all of the outputs
};
template <>
struct EnumNames<RowCode> {
  static constexpr std::array<std::string_view, 5> names = {"ok", "refused", "no-answer",
                                                            "not-usable", "output-absent"};
};

inline constexpr int kMaxBatchThreads = 256;

/// What a batch computes.
struct BatchTask {
  std::span<const std::string> paths;    ///< of p numbers: "output_shaft.crack[0].depth"
  std::span<const double> values;        ///< shape (n, p), row after row [unit of the field]
  std::span<const std::string> outputs;  ///< q names: "cracked.positive.stiffness"
  Method method = Method::corrected;
  int threads = 1;  ///< 0: as many as the machine has
};

/// The first row of a code, and why it has that code.
struct BatchFault {
  RowCode code = RowCode::refused;
  std::size_t row = 0;
  std::string message;
};

struct BatchResult {
  /// Shape (n, q), row after row [SI unit of the output]; 0 where the code of the row says that
  /// there are none.
  std::vector<double> numbers;
  std::vector<RowCode> codes;      ///< shape (n)
  std::vector<BatchFault> faults;  ///< one for each code that occurs, except ok; in their order
};

/// Evaluates a drive for each row of values: the numbers of `evaluate`, bit for bit, whatever the
/// number of threads.
///
/// @throws InputError  before any work: no number of the drive has the path, or no output of the
///                     drive as it is has the name (the message names near ones); a name is given
///                     twice; there is not a value for each path in each row; `threads` is out of
///                     0 to kMaxBatchThreads
/// @throws Error       `evaluate` throws it for the drive as it is
/// @throws Stopped     `progress` asked to stop; it is told before each row that the calling
///                     thread takes, and at the end
[[nodiscard]] BatchResult batch(const GearSet& gear, const BatchTask& task,
                                const Progress& progress = {});

}  // namespace strainwave
