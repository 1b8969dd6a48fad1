// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/fields.hpp"

/// @file
/// The rows of a study, handed over one by one.  For a command line they go to a file, so a study
/// of any length writes them in constant memory.

namespace strainwave {

/// Whether the numbers of a row may be used.
enum class RowStatus : std::uint8_t {
  usable,
  refused,   ///< the row breaks a rule of the input, so it has no outputs
  unusable,  ///< the row is outside the validity of the model, or has no solution
};
template <>
struct EnumNames<RowStatus> {
  static constexpr std::array<std::string_view, 3> names = {"usable", "refused", "unusable"};
};

/// A column of numbers.
struct RowColumn {
  std::string name;  ///< path of the field or of the output
  std::string unit;  ///< SI unit of its numbers
};

/// What stands before the rows.
struct RowHead {
  std::string of;                          ///< the rows in plain words, such as "draws"
  std::size_t rows = 0;                    ///< how many follow
  std::vector<RowColumn> columns;          ///< numbers of each row
  std::optional<std::uint64_t> seed = {};  ///< of the draws; absent if nothing was drawn
};

/// Takes the rows of a study.
class RowSink {
 public:
  RowSink() = default;
  virtual ~RowSink() = default;
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;
  RowSink(RowSink&&) = delete;
  RowSink& operator=(RowSink&&) = delete;

  /// Where the rows come from, as names and texts; called before `begin`.
  virtual void come_from(std::vector<std::pair<std::string, std::string>> origin) = 0;
  /// Begins the rows.
  virtual void begin(const RowHead& head) = 0;
  /// Adds the next row.
  /// @param numbers  one for each column; NaN where the row has none
  /// @param status   whether the outputs may be used
  /// @param rule     rule that the row breaks, or reason why it is unusable; empty if usable
  virtual void add(std::span<const double> numbers, RowStatus status, std::string_view rule) = 0;
};

/// The rule that a fault breaks, without the value that breaks it, so that many rows have few
/// rules.
[[nodiscard]] inline std::string rule_of(const Error& fault) {
  const auto* const input = dynamic_cast<const InputError*>(&fault);
  if (input == nullptr || input->rule().empty()) return fault.what();
  return input->field() + " must be " + input->rule();
}

}  // namespace strainwave
