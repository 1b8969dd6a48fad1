// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// @file
/// Straight cracks of any place, length and angle in an elastic sheet.

namespace strainwave {

/// A crack through a sheet.
struct StraightCrack {
  std::complex<double> centre;  ///< x + i y [m]
  double half_length = 0.0;     ///< a [m]; > 0
  double angle = 0.0;           ///< from the x axis [rad]
};

/// Stress of the sheet without cracks [Pa].
struct SheetStress {
  double xx = 0.0;  ///< normal stress along x
  double yy = 0.0;  ///< normal stress along y
  double xy = 0.0;  ///< shear stress in the plane
  double xz = 0.0;  ///< out of plane
  double yz = 0.0;  ///< out of plane
};

/// Stress intensity factors of a tip [Pa*sqrt(m)].  Shear is positive if it has the sense of the
/// shear stress in the axes of the crack.
struct TipFactors {
  double mode_1 = 0.0;  ///< K_I; 0 if the crack is closed
  double mode_2 = 0.0;  ///< K_II
  double mode_3 = 0.0;  ///< K_III
};

/// One crack of a group under a stress.
struct GroupedCrack {
  TipFactors behind = {};  ///< of the tip at centre - a exp(i angle)
  TipFactors ahead = {};   ///< of the tip at centre + a exp(i angle)
  /// Whether the stress presses the faces together over the whole crack, so that they touch.
  bool closed = false;
};

/// Choices of crack_group.
struct GroupOptions {
  int order = 40;                  ///< points on each crack; 4 to 400
  std::optional<double> period{};  ///< of a row along x [m]; absent: no row
  /// Stress whose compliance is asked for; the faces that touch stay those under the stress of the
  /// group.  Absent: that stress itself.
  std::optional<SheetStress> compliance_of{};
};

/// A group of cracks under one stress of the sheet.
struct CrackGroup {
  std::vector<GroupedCrack> cracks;  ///< in the order in which the cracks were given
  /// Whether each crack is either open or closed at its middle.  False: no such state was found,
  /// because faces touch over a part of their length; the answer must not be used.
  bool settled = false;
  /// Largest change of a stress intensity factor from two thirds of the points, over the largest
  /// factor of the group [-].
  double error = 0.0;
  /// Work of the stress of the sheet on the opening and sliding of all faces, modes 1 and 2, times
  /// the plane modulus E' [Pa^2*m^2]; twice the energy that the cracks add, times E'.
  double work = 0.0;
  /// The same work out of the plane, mode 3, times twice the shear modulus [Pa^2*m^2].
  double work_out_of_plane = 0.0;
  /// Compliance that the group adds in its plane, over the sum of the compliances that its cracks
  /// add alone [-]; 1 if no crack opens or slides alone.
  double compliance_ratio = 1.0;
  /// The same out of the plane [-].
  double compliance_ratio_out_of_plane = 1.0;
};

/// Stress intensity factors and compliance of cracks that influence each other.
///
/// Implements theory manual eqs. (CG-1) to (CG-6): densities of dislocations on the cracks, by
/// Gauss-Chebyshev quadrature.  A crack whose faces would overlap at its middle is closed, and one
/// whose closed faces would pull at each other there is open; closed faces slide without friction.
/// With a period, each crack is one of an infinite row along x.
///
/// Accuracy: six digits for gaps of at least 0.2 a with 60 points; `error` tells.  The sheet is
/// infinite and flat.
///
/// @param cracks   must not cross or touch each other, nor their neighbours of the row
/// @param stress   of the sheet without cracks [Pa], in the axes x and y of the centres
/// @param options  points on each crack, period, and stress of the compliance; {}: 40 points, no
///                 row, and the compliance of `stress`
/// @throws InputError  if a crack has no length, the order or the period is out of range, or two
///                     cracks touch
[[nodiscard]] CrackGroup crack_group(std::span<const StraightCrack> cracks,
                                     const SheetStress& stress, const GroupOptions& options = {});

/// Two cracks that cross or touch, by their indices, the smaller first; the same index twice if a
/// crack touches the next one of its row.  Absent if all cracks are apart.
/// @param cracks  all cracks, or those of one period of the row; each longer than 0
/// @param period  of the row along x [m]; > 0; absent: no row
/// @throws InputError  if a crack has no length or the period is not > 0
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> touching_cracks(
    std::span<const StraightCrack> cracks, const std::optional<double>& period = {});

/// Smallest distance between two cracks [m]; 0 if they cross.
[[nodiscard]] double distance(const StraightCrack& one, const StraightCrack& other);

}  // namespace strainwave
