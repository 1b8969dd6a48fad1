// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "strainwave/crack_group/straight_cracks.hpp"

/// @file
/// Linear response of a group of cracks whose open and closed faces are given.

namespace strainwave {

/// A straight crack whose faces are given.
struct FacedCrack {
  StraightCrack crack;  ///< place, half length and angle
  /// Whether the faces slide on each other without parting.  False: they are apart, and they pass
  /// through each other where they overlap.
  bool closed = false;
};

/// How one crack of a group responds to one stress of the sheet.
struct CrackResponse {
  TipFactors behind = {};  ///< of the tip at centre - a exp(i angle), modes 1 and 2
  TipFactors ahead = {};   ///< of the tip at centre + a exp(i angle), modes 1 and 2
  double opening = 0.0;    ///< E' times the integral of the opening along the crack [Pa*m^2]
  double sliding = 0.0;    ///< E' times the integral of the sliding along the crack [Pa*m^2]
  /// Along an open crack, E' times the opening [Pa*m]; along a closed one, the normal stress on its
  /// faces [Pa], which must not pull.
  std::vector<double> faces;
  /// Along the crack, E' times the sliding [Pa*m].
  std::vector<double> slid;
};

/// Number of points on each crack with which `group_response` has its accuracy.
/// @param cracks  each longer than 0
/// @param period  of the row along x [m]; > 0; absent: no row
[[nodiscard]] std::vector<int> response_points(std::span<const StraightCrack> cracks,
                                               const std::optional<double>& period = {});

/// Choices of group_response.
struct ResponseOptions {
  std::optional<double> period{};  ///< of a row along x [m]; absent: no row
  /// Number of points on each crack, at least 4; empty: `response_points` of the cracks.  Equal
  /// numbers make differences of responses smooth.
  std::vector<int> points{};
};

/// Responses of all cracks of a group, in the order of the cracks, to each of some stresses.
///
/// Implements theory manual eqs. (CG-1) to (CG-3), (CG-5), (CG-6) in the plane of the sheet.  The
/// responses to several stresses may be added, because the faces are given.
///
/// Accuracy: 1e-9 of the largest response for gaps of at least kLeastGroupGap.
///
/// @param cracks    at most kMostGroupedCracks, which neither cross nor touch each other
/// @param stresses  of the sheet without cracks; `xz` and `yz` are ignored
/// @param options   period and points; {}: no row, and points that follow from the gaps
/// @return          [stress][crack]
/// @throws InputError  if a crack has no length, two cracks touch, or they are too many
[[nodiscard]] std::vector<std::vector<CrackResponse>> group_response(
    std::span<const FacedCrack> cracks, std::span<const SheetStress> stresses,
    const ResponseOptions& options = {});

/// Smallest gap between a crack and the others, with their neighbours of the row and its own, over
/// the larger of the two half lengths.
struct NearestCrack {
  double gap = 0.0;       ///< over the larger half length [-]; infinite: there is none
  std::size_t index = 0;  ///< of the other crack; that of the crack itself for its own neighbours
};
/// @param cracks  each longer than 0
/// @param of      index of the crack
/// @param period  of the row along x [m]; > 0; absent: no row
[[nodiscard]] NearestCrack nearest_crack(std::span<const StraightCrack> cracks, std::size_t of,
                                         const std::optional<double>& period = {});

/// Smallest gap of a group over the larger half length of two cracks at which `group_response` has
/// its accuracy [-].
inline constexpr double kLeastGroupGap = 0.2;
/// Most cracks that are solved together, because the time grows with the third power of their
/// number.
inline constexpr std::size_t kMostGroupedCracks = 10;

}  // namespace strainwave
