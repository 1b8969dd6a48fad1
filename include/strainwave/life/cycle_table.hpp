// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Cycles of one range and mean, or of one class of them.
struct CycleCount {
  static constexpr bool kTableRow = true;

  double range = 0.0;
  double mean = 0.0;
  double count = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"range", kUnitBeside, "range; the middle of its class"}, &CycleCount::range);
    field({"mean", kUnitBeside, "mean; the middle of its class"}, &CycleCount::mean);
    field({"count", "1", "number of cycles"}, &CycleCount::count);
  }
};

/// Sums up cycles by range and mean in bounded memory (LI-23).
///
/// Without classes, cycles of equal range and mean are one row.  There are at most `most` rows:
/// those of the largest ranges; smaller cycles are only counted.  With classes, ranges and means
/// fall into classes of one width, at most so many of each.  The width is the smallest power of
/// two, in the unit of the cycles, for which they suffice.  No result depends on the order of the
/// cycles.
class CycleTable {
 public:
  /// @param classes  of ranges and of means; absent: none; > 0
  /// @param most     number of rows without classes; > 0
  explicit CycleTable(std::optional<int> classes = {}, std::size_t most = 10000)
      : classes_(classes), most_(most) {}

  /// Adds cycles of one range and mean; nothing if the range or the count is not > 0.
  /// @param range        in the unit of the cycles
  /// @param mean         in the unit of the cycles
  /// @param count        number of cycles [-]
  /// @throws InputError  if the range is not finite
  void add(double range, double mean, double count);

  /// The rows by falling range, then by rising mean.
  [[nodiscard]] std::vector<CycleCount> rows() const;
  /// Width of the classes; absent without classes or cycles.
  [[nodiscard]] std::optional<double> class_width() const;
  /// Number of all cycles, with those that are in no row [-].
  [[nodiscard]] double cycles() const { return cycles_; }
  /// Largest range of all cycles, in the unit of the cycles; 0 without cycles.
  [[nodiscard]] double largest_range() const { return largest_range_; }
  /// Cycles that are in no row, because there are too many ranges.
  [[nodiscard]] double left_out() const { return left_out_; }
  /// Largest range of a cycle that is in no row; 0 if all are.
  [[nodiscard]] double largest_left_out() const { return largest_left_out_; }

 private:
  using Key = std::pair<double, double>;

  void add_exact(double range, double mean, double count);
  void add_to_class(double range, double mean, double count);
  void widen();

  std::optional<int> classes_;
  std::size_t most_;
  /// By range and mean; with classes, by their numbers.
  std::map<Key, double> counts_;
  double width_ = 0.0;
  double first_mean_ = 0.0;  ///< numbers of the lowest and highest classes of means
  double last_mean_ = 0.0;
  double last_range_ = 0.0;
  double cycles_ = 0.0;
  double largest_range_ = 0.0;
  double left_out_ = 0.0;
  double largest_left_out_ = 0.0;
};

}  // namespace strainwave
