// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "flank_shares.hpp"
#include "strainwave/core/dual.hpp"
#include "strainwave/model/input/material.hpp"
#include "strainwave/torsion/tooth_flanks.hpp"

// Teeth of a thick circular spline that move when a neighbour carries a force.

namespace strainwave {

/// A flank of a tooth of the flexspline.
struct FlankPlace {
  int tooth = 0;  ///< number of the tooth
  int side = 1;   ///< +1 for the drive flank, -1 for the coast flank
};

/// Displacements of one tooth of the circular spline under forces on another one [m/N].
template <class Real>
struct BasicNeighbourMotion {
  Real outward{};  ///< outward under an outward force
  Real along{};    ///< along the pitch circle under a force along it
  Real mixed{};    ///< outward under a force along the pitch circle

  /// Distance by which one flank opens under a unit force on the other [m/N] (TC-31).
  template <class Shares>
  [[nodiscard]] Real opening(const Shares& of, const Shares& by) const {
    return of.outward * by.outward * outward + of.along * by.along * along +
           (of.outward * by.along - of.along * by.outward) * mixed;
  }
};

/// Displacements of teeth of the circular spline under forces on other teeth.
///
/// Implements theory manual eq. (TC-31): plane elastic layer on a smooth rigid base, without its
/// motion as a bar.  Accuracy: 1e-12 of the largest value for the layer; the layer agrees with
/// plane finite elements within 0.013/(E b) (t/m 20 to 40).
template <class Real>
class BasicToothNeighbours {
 public:
  /// @param tooth       of the circular spline; its roots do not overlap, B <= pitch
  /// @param steel       of the circular spline
  /// @param face_width  b [m]; > 0
  /// @param pitches     pitches of the whole turn
  BasicToothNeighbours(const BasicToothOnWall<Real>& tooth,
                       const BasicElasticConstants<Real>& steel, const Real& face_width,
                       int pitches);

  /// Motion of the tooth that one flank presses under a force on another flank; 0 if both flanks
  /// press the same tooth of the circular spline, or if they are far from each other.
  [[nodiscard]] BasicNeighbourMotion<Real> between(FlankPlace of, FlankPlace by) const;

 private:
  int pitches_ = 1;
  // by the number of pitches between two teeth; 0 at 0
  std::vector<Real> tangential_;  // along both tangents
  std::vector<Real> radial_;      // along both radii
  std::vector<Real> mixed_;       // radial under a tangential force
};
using ToothNeighbours = BasicToothNeighbours<double>;

extern template class BasicToothNeighbours<double>;
extern template class BasicToothNeighbours<DualReal>;

}  // namespace strainwave
