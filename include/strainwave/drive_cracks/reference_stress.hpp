// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

/// @file
/// Reference stress of a cracked member [Pa]: the yield strength at which its net section is fully
/// plastic under the given load, by von Mises.  L_r is the reference stress over the actual yield
/// strength.  All reference stresses are proportional to the load.

namespace strainwave {

/// Von Mises equivalent of a normal and a shear stress, sqrt(sigma^2 + 3 tau^2) [Pa]; eq. (FA-6).
[[nodiscard]] double von_mises(double normal_stress, double shear_stress);

/// Net ring of a shaft with an annular crack.
struct NetRing {
  double outer_radius = 0.0;  ///< r_e = r_o - a [m]; > inner_radius
  double inner_radius = 0.0;  ///< r_i [m]; >= 0
};

/// Reference stress of a ring under axial force and torque [Pa].
///
/// Implements theory manual eq. (FA-7), with a uniform axial stress P/(pi (r_e^2 - r_i^2)) and a
/// uniform shear 3T/(2 pi (r_e^3 - r_i^3)).  This gives a lower bound of the limit load, which is
/// exact for torsion alone.
/// @throws InputError  if the radii are not in order
[[nodiscard]] double ring_reference_stress(const NetRing& ring, double axial_force, double torque);

/// Section of a shaft with a crack on one side.
struct OneSidedSection {
  double outer_radius = 0.0;  ///< r_o [m]; > inner_radius
  double inner_radius = 0.0;  ///< r_i [m]; >= 0
  double depth = 0.0;         ///< a, the largest depth of the crack [m]; >= 0, < r_o - r_i
  /// h, depth of the segment that a straight chord cuts off, and in which the crack lies [m]; >= a
  double chord_depth = 0.0;
};

/// Reference stress of a shaft with a crack on one side, under axial force and torque [Pa].
///
/// Implements theory manual eq. (FA-15): the normal stress is P/A_s, the shear stress T/W_s.  Both
/// fields are in equilibrium, so this gives a lower bound of the limit load.
/// @throws InputError  if the lengths are not in order
[[nodiscard]] double one_sided_reference_stress(const OneSidedSection& section, double axial_force,
                                                double torque);

/// A crack through a wall, which weakens the transverse and the axial section.
struct ThroughWall {
  double half_length = 0.0;  ///< a [m]; > 0
  double angle = 0.0;        ///< angle from the generator [rad]
  double mean_radius = 0.0;  ///< r [m]; > 0
  /// length of the tube [m]; > 0; infinity: the crack does not weaken the axial section
  double length = 0.0;
};

/// Share of the section that a crack through a wall leaves [-]; eq. (FA-8).
///
/// The smaller of 1 - 2 a |sin beta|/(pi r) and 1 - 2 a |cos beta|/L.  The first counts the whole
/// circumference with an equal gap opposite the crack.  Absent if nothing is left, that is, if the
/// crack cuts half of the circumference.
[[nodiscard]] std::optional<double> through_wall_share(const ThroughWall& crack);

/// A row of equal cracks through a wall, evenly spaced along one direction.
struct RowThroughWall {
  double half_length = 0.0;  ///< a [m]; > 0
  double angle = 0.0;        ///< from the normal of the row, as (FR-6) [rad]
  double pitch = 0.0;        ///< p, distance between the cracks' middles [m]; > 0
};

/// Reference stress of a row of cracks through a wall under the stresses of the sound wall [Pa].
///
/// Implements theory manual eq. (FA-16).  While the tips do not pass each other, the line from tip
/// to tip carries the force of one pitch.  Beyond, the strips between the cracks carry it, with the
/// moment that the shear causes at their ends.  The result is at least the equivalent stress of the
/// sound wall.  The forces are in equilibrium, but the field round the ends of the strips was not
/// worked out, so this is an estimate and not a bound.
///
/// @param row            the cracks of the row
/// @param normal_stress  along the normal of the row, as by an axial force [Pa]
/// @param shear_stress   as by a torque; its sign counts as in (FR-6) [Pa]
/// @return  empty if neighbours touch
[[nodiscard]] std::optional<double> row_reference_stress(const RowThroughWall& row,
                                                         double normal_stress, double shear_stress);

/// Distribution of the stress over the thickness of a part.
enum class SectionLoading {
  membrane,  ///< stress uniform over the thickness
  bending,   ///< linear and zero in the middle; the stress is given at the surface
};

/// Reference stress of a part with a surface crack [Pa].
///
/// Implements theory manual eqs. (FA-9) and (FA-10): sigma/(1-alpha) or (2/3) sigma/(1-alpha)^2.
/// The crack is taken to reduce the thickness by its depth over the whole width, which gives a
/// lower bound of the limit load.
///
/// @param loading      distribution of the stress over the thickness
/// @param stress       von Mises equivalent stress of the uncracked section [Pa]; >= 0
/// @param depth_ratio  alpha = a/t [-]; in [0, 1)
/// @throws InputError  if alpha is outside [0, 1)
[[nodiscard]] double ligament_reference_stress(SectionLoading loading, double stress,
                                               double depth_ratio);

/// Shear stress of an annular plate at a radius, T/(2 pi r^2 h) [Pa]; eq. (FA-11).
[[nodiscard]] double annulus_shear(double torque, double radius, double thickness);

/// K_III of a groove all round an annular plate, treated as a sharp crack [Pa*m^0.5].
///
/// Implements theory manual eq. (FA-11), tau sqrt(2 h tan(pi d/(2h))): the edge crack of a strip in
/// antiplane shear.  It is exact in the limit of a radius that is large compared with the
/// thickness.
///
/// @param shear      shear stress tau of the sound plate at the groove [Pa]
/// @param depth      d [m]; in [0, thickness)
/// @param thickness  h [m]; > 0
/// @throws InputError  if the thickness is not > 0 or the depth is outside [0, thickness)
[[nodiscard]] double groove_intensity(double shear, double depth, double thickness);

}  // namespace strainwave
