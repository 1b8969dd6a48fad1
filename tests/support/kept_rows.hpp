// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/row_sink.hpp"

namespace strainwave::test {

/// Rows of a study in memory.
class KeptRows : public RowSink {
 public:
  void come_from(std::vector<std::pair<std::string, std::string>>) override { ++origins; }
  void begin(const RowHead& of) override { head = of; }
  void add(std::span<const double> row, RowStatus state, std::string_view rule) override {
    numbers.emplace_back(row.begin(), row.end());
    status.push_back(state);
    rules.emplace_back(rule);
  }

  /// Place of a column.
  [[nodiscard]] std::size_t column(std::string_view name) const {
    const auto found = std::ranges::find(head.columns, name, &RowColumn::name);
    if (found == head.columns.end()) throw std::out_of_range(std::string(name));
    return static_cast<std::size_t>(found - head.columns.begin());
  }
  /// Number of a row in a column.
  [[nodiscard]] double at(std::size_t row, std::string_view name) const {
    return numbers.at(row).at(column(name));
  }
  /// Names and units of the columns.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> columns() const {
    std::vector<std::pair<std::string, std::string>> named;
    for (const RowColumn& of : head.columns) named.emplace_back(of.name, of.unit);
    return named;
  }
  /// Bits of all numbers.
  [[nodiscard]] std::vector<std::uint64_t> bits() const {
    std::vector<std::uint64_t> all;
    for (const std::vector<double>& row : numbers)
      for (const double number : row) all.push_back(std::bit_cast<std::uint64_t>(number));
    return all;
  }

  int origins = 0;  ///< calls of `come_from`
  RowHead head;
  std::vector<std::vector<double>> numbers;
  std::vector<RowStatus> status;
  std::vector<std::string> rules;
};

/// Whether two studies have the same rows, bit for bit.
inline bool same_rows(const KeptRows& a, const KeptRows& b) {
  return a.head.of == b.head.of && a.head.rows == b.head.rows && a.head.seed == b.head.seed &&
         a.columns() == b.columns() && a.bits() == b.bits() && a.status == b.status &&
         a.rules == b.rules;
}

}  // namespace strainwave::test
