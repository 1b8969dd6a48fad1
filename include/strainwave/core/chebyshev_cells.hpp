// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

namespace strainwave {

/// A slow, smooth function of up to three variables, replaced by polynomials that it fills itself.
///
/// Implements theory manual eq. (ST-22).  Space is divided into boxes of fixed places and widths.
/// The first question in a box fills it: the function is evaluated at Chebyshev nodes, and the box
/// is halved along a variable in which the polynomial has not converged.  The finished polynomial
/// is compared with the function at places between the nodes.  A box that misses the tolerance
/// after all halvings, or in which the function has no value, says so.
///
/// The answer at a place depends on the function and the widths alone, not on the order of the
/// questions or on the thread.  All members may be called from several threads at once.
class ChebyshevCells {
 public:
  static constexpr std::size_t kMaxVariables = 3;  ///< most variables of the function
  static constexpr std::size_t kMaxValues = 3;     ///< most values of the function at a place
  static constexpr std::size_t kNodes = 8;         ///< of the polynomials, along each variable

  /// A value of each variable.  Elements beyond the number of variables have no effect.
  using Place = std::array<double, kMaxVariables>;
  /// The values of the function at a place, of which the first Options::values count.
  using Values = std::array<double, kMaxValues>;
  /// Fills the values at a place; false: the function has no value there.
  using Function = std::function<bool(const Place&, Values&)>;

  /// The boxes, and the accuracy of their polynomials.
  struct Options {
    std::vector<double> widths;  ///< of the boxes along each variable; > 0; 1 to 3 variables
    std::size_t values = 1;      ///< number of values of the function; 1 to kMaxValues
    double tolerance = 1e-11;    ///< of each value, relative to its largest in the box
    int halvings = 12;           ///< most halvings of one box
  };

  /// Evaluates nothing yet: a box is filled on the first question in it.
  /// @param function  may be called from several threads at once
  /// @param options   boxes and accuracy; `widths` has one width for each variable, 1 to 3
  ChebyshevCells(Function function, Options options);
  ~ChebyshevCells();
  ChebyshevCells(const ChebyshevCells&) = delete;
  ChebyshevCells& operator=(const ChebyshevCells&) = delete;

  /// Remembers the boxes that one thread has used, which saves a search under a lock.
  class Reader;

  /// Index of the box that contains a place; equal places in one box have the same index.
  [[nodiscard]] std::array<std::int64_t, kMaxVariables> box_of(const Place& place) const;

  /// Largest difference between polynomial and function in the finished boxes, relative to the
  /// largest value in the box [-].
  [[nodiscard]] double largest_error() const { return largest_error_; }
  /// Number of evaluations of the function so far.
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

 private:
  struct Cell;
  using Box = std::array<std::int64_t, kMaxVariables>;
  struct HashOfBox {
    std::size_t operator()(const Box& box) const;
  };
  using Boxes = std::unordered_map<Box, Cell*, HashOfBox>;

  Cell& root(const Box& box);
  void fill(Cell& cell);
  [[nodiscard]] bool keep(Cell& cell, std::vector<double> coefficients, const Values& largest);
  [[nodiscard]] bool evaluate(const Place& place, Values& values) const;
  [[nodiscard]] bool read(Cell& cell, const Place& place, Values& values);

  Function function_;
  Options options_;
  std::size_t variables_;
  std::size_t nodes_;  ///< of one box
  std::mutex mutex_;   ///< of `roots_` and `owned_`
  Boxes roots_;
  std::vector<std::unique_ptr<Cell>> owned_;
  std::atomic<double> largest_error_{0.0};
  mutable std::atomic<std::size_t> evaluations_{0};
};

/// Answers the questions of one thread.  It remembers the boxes that the thread has used, which
/// saves a search under a lock.
class ChebyshevCells::Reader {
 public:
  /// @param cells  must outlive the reader
  explicit Reader(ChebyshevCells& cells) : cells_(&cells) {}

  /// Fills the values at a place.
  /// @return  false: the box has no polynomial of the tolerance, so ask the function
  [[nodiscard]] bool operator()(const Place& place, Values& values);

 private:
  ChebyshevCells* cells_;
  Boxes known_;
  Box last_box_{};
  Cell* last_ = nullptr;
};

}  // namespace strainwave
