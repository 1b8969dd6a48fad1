// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

/// @file
/// The deviation of the rate of one crack along its path, drawn from numbers that depend on their
/// place alone.

namespace strainwave {

/// How the rate of one crack varies along its path.
struct PathScatter {
  double wander = 0.0;  ///< gamma, standard deviation of the correlated part in ln(da/dN) [-]
  double wander_length = 0.0;  ///< l, its correlation length in ln(size) [-]; 0: no such part
  double white = 0.0;          ///< standard deviation of the white part in one step [-]
  double white_step = 0.0;     ///< h, length of such a step [m]; 0: no such part

  /// Whether the rate varies at all.
  [[nodiscard]] bool any() const { return wander_length > 0 || white_step > 0; }
};

/// The deviation of the rate along one drawn path.
///
/// Implements theory manual eq. (GS-13).  The deviation is constant in cells: the correlated part
/// has kCells cells in one correlation length, the white part one in each step.  Number n of a cell
/// is a function of (seed, draw, n), so each path has the same bits on any machine and thread.
class GrowthPath {
 public:
  /// Cells of the correlated part in one correlation length.
  static constexpr int kCells = 8;

  /// @param scatter  deviations >= 0; lengths > 0 or without the part
  /// @param seed     of the crack
  /// @param draw     number of the draw
  /// @param size     at which the path begins [m]; > 0
  GrowthPath(const PathScatter& scatter, std::uint64_t seed, std::uint64_t draw, double size);

  /// Deviation of ln(da/dN) in the present cell [-].
  [[nodiscard]] double deviation() const { return wander_ + white_; }
  /// Size at which the present cell ends [m]; infinite if the rate does not vary.
  [[nodiscard]] double end() const;
  /// Goes on to the cell behind `end`.
  void next();
  /// Goes on with another measure of the size, such as the half length of a crack that has gone
  /// through the wall.  The present deviations begin new cells.
  /// @param size  of the crack in the new measure [m]; > 0
  void go_on(double size);

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  [[nodiscard]] double normal(std::uint64_t index) const;
  [[nodiscard]] double wander_end() const;
  [[nodiscard]] double white_end() const;

  PathScatter scatter_;
  std::uint64_t seed_;
  std::uint64_t draw_;
  double first_;                    // size at which the first cells begin
  std::uint64_t wander_cells_ = 0;  // behind the tip, from `first_` on
  std::uint64_t white_cells_ = 0;
  std::uint64_t drawn_wander_ = 0;  // numbers that were used
  std::uint64_t drawn_white_ = 0;
  double wander_ = 0.0;
  double white_ = 0.0;
};

}  // namespace strainwave
