// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "strainwave/crack_group/group_response.hpp"

/// @file
/// Responses of two cracks at many half lengths.

namespace strainwave {

/// The responses of two cracks of given places, angles and faces over their half lengths.
///
/// Implements theory manual eq. (CG-15): polynomials over the logarithms of both half lengths, in
/// cells that are made when they are first asked for.  A cell is a function of its place alone, so
/// answers do not depend on the order of the questions.
///
/// Accuracy: within kTolerance of the largest entry of its kind; a cell that misses this at a place
/// between its nodes answers by `group_response` itself.
class ResponseTable {
 public:
  /// Largest difference from `group_response` at the places where a cell is checked, over the
  /// largest entry of the same kind [-].
  static constexpr double kTolerance = 1e-7;

  /// @param cracks    two; their half lengths do not matter
  /// @param stresses  of the sheet without cracks
  /// @param period    of the row along x [m]
  ResponseTable(std::vector<FacedCrack> cracks, std::vector<SheetStress> stresses, double period);

  /// The responses at two half lengths, as of `group_response`.
  /// @param half_lengths  of both cracks [m]; > 0
  /// @throws InputError   as `group_response`
  [[nodiscard]] std::vector<std::vector<CrackResponse>> at(
      const std::array<double, 2>& half_lengths);

  /// The cracks of which the table was made.
  [[nodiscard]] const std::vector<FacedCrack>& cracks() const { return cracks_; }
  /// The stresses of the sheet [Pa].
  [[nodiscard]] const std::vector<SheetStress>& stresses() const { return stresses_; }
  /// Length after which the cracks repeat [m].
  [[nodiscard]] double period() const { return period_; }
  /// Systems that were solved so far.
  [[nodiscard]] std::size_t solved() const { return solved_; }
  /// Cells that the table keeps.
  [[nodiscard]] std::size_t cells() const { return cells_.size(); }

 private:
  static constexpr std::size_t kNodes = 7;  ///< along each half length
  /// Points on each crack that all nodes of a cell have, and the entries of its nodes one after
  /// another; no entries: the cell answers by `group_response`.
  struct Cell {
    std::vector<int> points;
    std::vector<double> entries;
  };
  /// Halvings of the widest cell, and the place of the cell among those of its width.
  using Place = std::array<int, 3>;

  [[nodiscard]] std::vector<std::vector<CrackResponse>> direct(
      const std::array<double, 2>& half_lengths, const std::vector<int>& points);
  [[nodiscard]] std::optional<Place> place_of(const std::array<double, 2>& logarithms) const;
  [[nodiscard]] Cell made(const Place& place);
  [[nodiscard]] std::vector<double> interpolated(const Cell& cell, const Place& place,
                                                 const std::array<double, 2>& logarithms) const;
  [[nodiscard]] std::vector<StraightCrack> at_sizes(
      const std::array<double, 2>& half_lengths) const;

  std::vector<FacedCrack> cracks_;
  std::vector<SheetStress> stresses_;
  double period_;
  std::map<Place, Cell> cells_;
  std::size_t solved_ = 0;
};

}  // namespace strainwave
