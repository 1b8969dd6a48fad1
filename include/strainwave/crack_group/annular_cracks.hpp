// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// @file
/// Annular cracks in the outer surface of a shaft in torsion, one behind the other.

namespace strainwave {

/// An annular crack of a shaft.
struct PlacedAnnularCrack {
  double place = 0.0;  ///< along the axis [m]
  double depth = 0.0;  ///< a, radial, from the outer surface [m]; > 0
};

/// Outer and inner radius of a shaft [m].
struct ShaftRadii {
  double outer = 0.0;  ///< > 0
  double inner = 0.0;  ///< >= 0, < outer; 0: a solid shaft
};

/// An annular crack among others, under a torque.
struct GroupedAnnularCrack {
  /// Rotation that the crack adds between the ends of the shaft per unit of the torque, times the
  /// shear modulus [m^-3].
  double rotation = 0.0;
  double factor = 1.0;      ///< K_III over that of the crack alone [-]
  double compliance = 1.0;  ///< its rotation over that of the crack alone [-]
};

/// Annular cracks of a shaft under a torque.
struct AnnularGroup {
  std::vector<GroupedAnnularCrack> cracks;  ///< in the order in which the cracks were given
  /// Largest change of a factor or a compliance over those of the crack alone, from fewer functions
  /// for the jump of each crack [-].
  double error = 0.0;
};

/// Smallest distance between two cracks, over the depth of the deeper one, at which annular_group
/// answers [-].
inline constexpr double kLeastAnnularDistance = 0.05;

/// Smallest and largest depth of a crack over the wall R - r_i at which annular_group answers [-].
/// @{
inline constexpr double kLeastAnnularDepth = 0.001;
inline constexpr double kLargestAnnularDepth = 0.85;
/// @}

/// Number of modes of the shaft for each crack with which annular_group has its accuracy.
/// @param cracks  each of a depth > 0
/// @param radii   of the shaft
[[nodiscard]] std::vector<std::size_t> annular_modes(std::span<const PlacedAnnularCrack> cracks,
                                                     const ShaftRadii& radii);

/// Annular cracks of a shaft in torsion that influence each other.
///
/// Implements theory manual eqs. (CG-10) to (CG-13): the jump of each crack is a sum of functions,
/// and its stress at the other cracks a sum over the modes of the shaft.  Cracks beside each other
/// always shield each other.  The shaft continues far beyond the cracks.  Each thread keeps what it
/// computed of the last depths.
///
/// Accuracy: 0.5 % of factor and compliance for distances of at least a tenth of the depth, 0.1 %
/// from a third of the depth on; `error` is the estimate for these cracks.
///
/// @param cracks  at least one, in any order
/// @param radii   of the shaft
/// @param modes   for each crack, of cracks whose range the caller has checked; empty:
/// annular_modes
///                of the cracks.  Equal numbers make differences of groups smooth.  A number counts
///                as the next one that annular_modes gives.
/// @throws InputError  naming the crack by its index, if a depth is out of range or two cracks are
///                     nearer than kLeastAnnularDistance
[[nodiscard]] AnnularGroup annular_group(std::span<const PlacedAnnularCrack> cracks,
                                         const ShaftRadii& radii,
                                         const std::vector<std::size_t>& modes = {});

/// Two annular cracks that are too near each other for annular_group, by their indices, the smaller
/// first.  Absent if all are apart.
/// @param cracks  each of a depth > 0
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> touching_annular_cracks(
    std::span<const PlacedAnnularCrack> cracks);

}  // namespace strainwave
