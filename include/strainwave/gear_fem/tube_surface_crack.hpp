// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "strainwave/gear_fem/tube_through_crack.hpp"

namespace strainwave::gear_fem {

/// A tube with a part-through crack in its wall, clamped at z = 0, twisted at z = length.
///
/// The crack starts at the outer or the inner surface, where it is straight; its plane is radial,
/// its front a semi-ellipse on the unrolled wall.  The angle counts on the surface of the mouth
/// from the generator (+z) toward -theta, so that positive torque opens it for 0 < angle < 90
/// degrees.
struct TubeWithSurfaceCrack {
  enum class Surface { outer, inner };
  fem::Elasticity material;
  double mean_radius{};                       ///< r [m]; > 0
  double wall_thickness{};                    ///< t [m]; 0 < t <= 0.5 r
  double length{};                            ///< L [m]; > 0
  double depth{};                             ///< a, radial [m]; > 0, <= 0.9 t
  double half_length{};                       ///< c, along the mouth [m]; 0.2 <= a/c <= 5
  Surface surface = Surface::outer;           ///< of the mouth
  double angle{};                             ///< beta [rad]; -pi/2 < angle <= pi/2
  double place{};                             ///< z of the crack's middle [m]; 0: half the length
  double torque = 1;                          ///< > 0 [N*m]; its sense is `sense`
  TorqueSense sense = TorqueSense::positive;  ///< about +z, on the end z = length
  fem::CrackFaces crack_faces =
      fem::CrackFaces::contact;  ///< `free` lets them pass through each other
  int order = 3;                 ///< of the displacements [-]; 2 to 4
  int rings = 3;                 ///< circular ones about the front [-]; 3 to 12
  int segments = 4;              ///< along the front [-]; a multiple of 4, 4 to 32
  double growth =
      0;  ///< of the cells away from the crack, each to the next [-]; 1.5 to 4, 0: by a/t
  /// Also solves sizes 1 % smaller and larger, and compares G with dC/dA.
  bool check_growth = true;
  /// Also solves three smaller cracks of the same shape, and integrates G over their growth.
  bool check_sizes = false;
  fem::FieldRequest fields = {};  ///< of the given size; nothing if left out
  /// Called after each solution with it and its time [s], mesh included; may be empty.
  std::function<void(const fem::SolidResult&, double)> solved = {};
};

/// A place of the front of a surface crack.
struct EllipsePoint : FrontPoint {
  double front_angle{};  ///< of the ellipse, from the end toward +z [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"front_angle", "rad", "of the ellipse, from the end toward +z"},
          &EllipsePoint::front_angle);
    FrontPoint::describe(field);
  }
};

/// The tube's answer with its evidence.
///
/// One front, from the mouth's end toward +z (at 90 degrees: toward -theta) to its other end, with
/// FrontStation::position = phi/pi and (c cos(phi), a sin(phi)) the point of the front.  At the two
/// ends K is not defined (the field at a corner is another one): the values there are those of the
/// projection of G, and no result.
/// `energy_release_rate` and `derivative_release_rate` are per area that the crack sweeps when it
/// grows in proportion (FE-34).
struct TubeSurfaceCrackResult : TubeCrackResult {
  double area{};                 ///< of the crack [m^2]
  double compliance_by_sizes{};  ///< int 2G/T^2 dA [rad/(N*m)], (FE-35); 0: not done
  double sizes_check{};          ///< compliance_by_sizes/added_compliance - 1 [-]
  fem::FrontStation deepest;     ///< the station at phi = 90 degrees

  /// The front without its two ends, where K is not defined.
  [[nodiscard]] std::vector<EllipsePoint> front() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    describe_common(field);
    field({"from_upper_to_lower_end", "", "along the front, without its ends, where no K is"},
          &TubeSurfaceCrackResult::front);
  }
};

/// The mesh that is solved for the given crack size.
/// @throws InputError  a value out of range; a crack that crosses an end of the tube, or itself
[[nodiscard]] fem::HexMesh mesh_tube_with_surface_crack(const TubeWithSurfaceCrack& tube);

/// Solves the tube: once, and as often again as checks and the contact of the faces need.
///
/// Range: the crack with its rings stays clear of both ends and of itself round the tube.
/// Accuracy at order 3, a/t from 0.1 to 0.5: mean G 0.3 %, K 0.5 % at the deepest point and 0.7 %
/// along the front, added compliance 0.3 %; at order 2 mean G 1.5 %.  Deeper ones are not
/// confirmed better than 1 % in G.  Faces that touch and slide: at 20 degrees and order 2, dC/dA
/// and G agree within 0.5 %.
///
/// @throws InputError   a value out of range; a crack that crosses an end of the tube
/// @throws SolverError  see solve_solid
[[nodiscard]] TubeSurfaceCrackResult solve_tube_with_surface_crack(
    const TubeWithSurfaceCrack& tube);

}  // namespace strainwave::gear_fem
