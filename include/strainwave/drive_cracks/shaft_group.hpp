// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "strainwave/core/dual.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/crack_group/annular_cracks.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// Annular cracks of the output shaft that have places, and their influence on each other.

namespace strainwave {

/// The annular cracks of an output shaft that have a `distance`: at least two, or none.
///
/// Implements theory manual eq. (CG-12) for a drive.  Cracks one behind the other shield each other
/// in torsion, so an answer without their influence is too soft, and its K too large.  The object
/// keeps depths at which it answers, because cracks grow; it begins with those of the file.
struct ShaftGroup {
  std::vector<std::size_t> index;          ///< of each crack in `output_shaft.crack`
  std::vector<PlacedAnnularCrack> cracks;  ///< in the same order
  ShaftRadii radii;                        ///< of the shaft

  /// Why the influence is not known, in a sentence that begins with the path of a crack; empty if
  /// it is known.
  [[nodiscard]] std::string fault() const;
  /// Factor on all places that leaves each two cracks as far apart as annular_group asks; 1 if they
  /// are [-].  Cracks farther apart shield each other less, so the rotation is then an upper bound.
  /// K of a deep crack is not: beside a shallower one K falls and rises again with the distance.
  [[nodiscard]] double stretch() const;
  /// Whether the places are stretched, so that K is that of each crack alone.
  [[nodiscard]] bool stretched() const;
  /// The influence.  The group must have no fault.
  [[nodiscard]] AnnularGroup solved() const;
  /// The same with given numbers of modes, which make differences of groups smooth.
  [[nodiscard]] AnnularGroup solved_with(const std::vector<std::size_t>& modes) const;
  /// K_III of one crack at a depth [m] beside the others, over that of the crack alone; 1 if the
  /// group has a fault or is stretched [-].
  [[nodiscard]] double intensity(std::size_t member, double depth) const;
};

/// The group of a drive.
/// @param gear  has passed `check`
[[nodiscard]] ShaftGroup shaft_group(const GearSet& gear);

/// Compliance in torsion of each crack of the output shaft over that of the crack alone [-]; empty
/// if the drive has no group or the group has a fault.
/// @param gear  has passed `check`
/// @param lift  reads its numbers; the derivatives are differences of the group along each input
/// @{
[[nodiscard]] std::vector<double> shaft_ratios(const GearSet& gear, const Lift<double>& lift);
[[nodiscard]] std::vector<DualReal> shaft_ratios(const GearSet& gear, const Lift<DualReal>& lift);
/// @}

}  // namespace strainwave
