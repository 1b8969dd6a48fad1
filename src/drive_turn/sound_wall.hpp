// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "strainwave/oval_shell/oval_shell.hpp"

namespace strainwave {

/// Stress of the sound wall on the plane of a crack [Pa].
struct PlaneStress {
  double normal = 0;  ///< tension > 0
  double along = 0;   ///< shear along the crack, toward the upper tip
};

/// The sound wall, seen from places along a crack.
class SoundWall {
 public:
  /// @param shell    must outlive this object
  /// @param part     in which the crack lies
  /// @param place    z of the middle of the crack [m]
  /// @param angle    of the crack from +z toward -theta [rad]
  /// @param offsets  of the places from the middle, toward the upper tip [m]
  SoundWall(const OvalShell& shell, WallPart part, double place, double angle,
            std::vector<double> offsets);

  /// @param offset     number of the place
  /// @param zeta       from -1 at the inner face to 1 at the outer face
  /// @param from_lobe  angle from a lobe to the middle of the crack [rad]
  /// @param torque     T [N*m]
  [[nodiscard]] PlaneStress at(std::size_t offset, double zeta, double from_lobe,
                               double torque) const;

 private:
  const OvalShell& shell_;
  double radius_;
  double sine_;
  double cosine_;
  std::vector<double> offsets_;
  std::vector<ShellPlace> places_;
};

}  // namespace strainwave
