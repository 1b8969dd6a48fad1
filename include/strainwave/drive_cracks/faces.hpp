// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace strainwave {

/// Whether the faces of a crack are pulled apart by a normal stress.
///
/// A touching crack is neither opened nor closed: its faces meet without pressure.
enum class Faces { pressed, touching, open };

/// Decides whether a normal stress presses the faces of a crack together; eq. (FR-17).  All code
/// uses this one rule.
///
/// @param normal_stress  stress on the plane of the crack [Pa]
/// @param scale  sum of the magnitudes of the terms that make up the stress [Pa]; >= 0.  A stress
///               below 1e-12 of this scale is rounding and counts as zero.
[[nodiscard]] constexpr Faces faces(double normal_stress, double scale) {
  const double negligible = 1e-12 * scale;
  if (normal_stress > negligible) return Faces::open;
  return normal_stress < -negligible ? Faces::pressed : Faces::touching;
}

/// State of a crack's faces under both senses of torque, with the given axial force.
struct BothSenses {
  Faces positive = Faces::touching;  ///< under torque about +z
  Faces negative = Faces::touching;  ///< under torque about -z

  /// Whether the crack is pressed under one sense only.  It then adds more compliance under the
  /// other.
  [[nodiscard]] bool differ() const {
    return (positive == Faces::pressed) != (negative == Faces::pressed);
  }
};

}  // namespace strainwave
