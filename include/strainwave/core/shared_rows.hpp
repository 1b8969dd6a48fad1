// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/core/parallel.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/core/records.hpp"

/// @file
/// A long study is a loop over rows that do not depend on each other, and a summary of all rows.
/// Several processes may share the loop: each computes a part of the rows and keeps their bytes,
/// and one reads all of them and makes the summary.

namespace strainwave {

/// Part `part` of `parts` equal parts of a study, counted from 1.
struct Share {
  int part = 1;   ///< from 1 to `parts`
  int parts = 1;  ///< number of equal parts; >= 1

  friend bool operator==(const Share&, const Share&) = default;
};

/// The rows [first, last) of a study.
struct RowRange {
  std::size_t first = 0;  ///< index of the first row, from 0
  std::size_t last = 0;   ///< index behind the last row

  friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// The rows of a share.  The shares of a study have the same length, or differ by one row.
[[nodiscard]] constexpr RowRange rows_of(const Share& share, std::size_t rows) {
  const auto part = static_cast<std::size_t>(share.part);
  const auto parts = static_cast<std::size_t>(share.parts);
  // rows*part/parts without overflow
  const auto up_to = [&](std::size_t k) { return rows / parts * k + rows % parts * k / parts; };
  return {up_to(part - 1), up_to(part)};
}

/// The rows of a share were computed, so this process has no summary to make.  It does not derive
/// from Error, because code that treats an Error as one refused case among many must not catch it.
class ShareDone : public std::runtime_error {
 public:
  ShareDone() : std::runtime_error("the rows of this share are computed") {}
};

/// What the loop of a shared study does: compute one share and keep it, or read all shares.
class SharedRows {
 public:
  /// Computes a share.
  explicit SharedRows(Share share) : share_(share) {}
  /// Reads shares.
  /// @param rows   number of rows of the whole study
  /// @param bytes  of all rows, in the order of the rows
  SharedRows(std::size_t rows, std::string bytes)
      : rows_(rows), load_([bytes = std::move(bytes)](int) { return bytes; }) {}
  /// Reads shares one after the other, so that the memory of one is enough.
  /// @param rows   number of rows of the whole study
  /// @param parts  number of shares
  /// @param load   returns the bytes of a share, from 1 to `parts`; is called again for each
  /// reading
  SharedRows(std::size_t rows, int parts, std::function<std::string(int part)> load)
      : rows_(rows), parts_(parts), load_(std::move(load)) {}

  /// Whether the rows are read.
  [[nodiscard]] bool reads() const { return load_ != nullptr; }
  /// The share that is computed; without meaning if shares are read.
  [[nodiscard]] const Share& share() const { return share_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }  ///< of the whole study
  /// Of the computed rows.
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

  /// Calls a function with each row that is read, in their order.  The function may change the row.
  /// @param n    number of rows of the whole study
  /// @param use  the function, of a row
  /// @throws BrokenRecord  if the bytes are not those of n rows
  template <class Row, class Use>
  void read(std::size_t n, const Use& use) const {
    if (rows_ != n) throw BrokenRecord();
    for (int part = 1; part <= parts_; ++part) {
      const std::string bytes = load_(part);
      RecordReader from(bytes);
      const RowRange range = rows_of({.part = part, .parts = parts_}, n);
      for (std::size_t i = range.first; i < range.last; ++i) {
        Row row{};
        from(row);
        use(row);
      }
      if (!from.at_end()) throw BrokenRecord();
    }
  }

  /// Keeps the rows of the share.
  void keep(std::size_t rows, std::string bytes) {
    rows_ = rows;
    bytes_ = std::move(bytes);
  }

 private:
  Share share_;
  std::size_t rows_ = 0;
  std::string bytes_;
  int parts_ = 1;
  std::function<std::string(int part)> load_ = {};  ///< null: rows are computed
};

/// Leaves new elements as they are if their type has no initial value, so that the thread that
/// fills an element is the first to touch its memory.  Zeros for a million rows take as long as a
/// tenth of the study.
template <class T>
struct LeftUninitialised : std::allocator<T> {
  /// As std::allocator.
  template <class U>
  struct rebind {
    using other = LeftUninitialised<U>;  ///< for elements of another type
  };
  /// Makes an element.
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0)
      ::new (static_cast<void*>(at)) U;
    else
      ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
};

/// The rows of a study, by a loop that processes may share.
///
/// The row of an index must depend on the index only.  `Row` is a number, or has an `archive`
/// function (core/records.hpp).
/// @tparam Rows     std::vector<Row>; with the allocator LeftUninitialised the evaluator must fill
///                  every byte of a row that has no initial value
/// @param n         number of rows of the whole study
/// @param parallel  block size and threads, as for_each_index; no effect where rows are read
/// @param progress  reports the rows that this process computes; no report where rows are read
/// @param shared    null: this process computes all rows
/// @param make      () -> evaluator of one thread, a function (index, row) that fills the row
/// @throws ShareDone  after the rows of a share were computed and kept
/// @throws BrokenRecord  if the bytes that are read are not those of n rows
/// @throws  as for_each_index
template <class Row, class Rows = std::vector<Row>, class Make>
[[nodiscard]] Rows shared_rows(std::size_t n, const Parallel& parallel, const Progress& progress,
                               SharedRows* shared, const Make& make) {
  if (shared != nullptr && shared->reads()) {
    Rows rows;
    rows.reserve(shared->rows() == n ? n : 0);
    shared->read<Row>(n, [&](Row& row) { rows.push_back(std::move(row)); });
    return rows;
  }
  const RowRange mine = shared != nullptr ? rows_of(shared->share(), n) : RowRange{0, n};
  Rows rows(mine.last - mine.first);
  for_each_index(rows.size(), parallel, progress, [&] {
    return [&, evaluate = make()](std::size_t i) mutable { evaluate(mine.first + i, rows[i]); };
  });
  if (shared != nullptr) {
    RecordWriter to;
    for (Row& row : rows) to(row);
    shared->keep(n, std::move(to).bytes());
    throw ShareDone();
  }
  return rows;
}

}  // namespace strainwave
