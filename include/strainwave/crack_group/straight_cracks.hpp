// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
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
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  double xz = 0.0;  ///< out of plane
  double yz = 0.0;  ///< out of plane
};

/// Stress intensity factors of a tip [Pa*sqrt(m)].  Shear is positive if it has the sense of the
/// shear stress in the axes of the crack.
struct TipFactors {
  double mode_1 = 0.0;
  double mode_2 = 0.0;
  double mode_3 = 0.0;
};

/// One crack of a group under a stress.
struct GroupedCrack {
  TipFactors behind = {};  ///< of the tip at centre - a exp(i angle)
  TipFactors ahead = {};   ///< of the tip at centre + a exp(i angle)
  /// Whether the stress presses the faces together over the whole crack, so that they touch.
  bool closed = false;
  /// Work of the stress of the sheet on the opening and sliding of the faces, times the plane
  /// modulus E' [Pa^2*m^2]; of mode 3 times E'/(2(1 + nu)) G^-1, that is, with 1/G = 2/E'.
  double work = 0.0;
};

struct GroupOptions {
  int order = 40;                  ///< points on each crack; 4 to 400
  std::optional<double> period{};  ///< of a row along x [m]; absent: no row
};

/// A group of cracks under one stress of the sheet.
struct CrackGroup {
  std::vector<GroupedCrack> cracks;
  /// Largest change of a stress intensity factor from two thirds of the points, over the largest
  /// factor of the group [-].
  double error = 0.0;
  /// Sum of `work` over that of the same cracks alone [-]; 1 if no crack opens or slides.  The
  /// compliance that the group adds is this number times the sum of the compliances that the cracks
  /// add alone.
  double compliance_ratio = 1.0;
};

/// Stress intensity factors and compliance of cracks that influence each other.
///
/// Implements theory manual eqs. (CG-1) to (CG-6): densities of dislocations on the cracks, by
/// Gauss-Chebyshev quadrature.  A crack that the stress of the group would press together at its
/// middle is closed; closed faces slide without friction.  With a period, each crack is one of an
/// infinite row along x.
///
/// Accuracy: six digits for gaps of at least 0.2 a with 60 points; `error` tells.  The sheet is
/// infinite and flat.
///
/// @param cracks  must not cross or touch each other, nor their neighbours of the row
/// @throws InputError  if a crack has no length, the order is out of range, or two cracks cross
[[nodiscard]] CrackGroup crack_group(std::span<const StraightCrack> cracks,
                                     const SheetStress& stress, const GroupOptions& options = {});

/// Smallest distance between two cracks, or between a crack and the next ones of its row [m]; 0 if
/// they cross.
[[nodiscard]] double distance(const StraightCrack& one, const StraightCrack& other);

}  // namespace strainwave
