// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "strainwave/gear_fem/tube_through_crack.hpp"

namespace strainwave::gear_fem {

/// A tube with a part-through crack in its wall, clamped at z = 0, twisted at z = length.
///
/// The crack starts at the outer or the inner surface, where it is straight.  Its plane is radial,
/// and its front is a semi-ellipse on the unrolled wall.  The angle counts on the surface of the
/// mouth from the generator (+z) toward -theta, so that positive torque opens it for 0 < angle < 90
/// degrees.
struct TubeWithSurfaceCrack {
  enum class Surface { outer, inner };
  fem::Elasticity material;
  double mean_radius{};              ///< r [m]; > 0
  double wall_thickness{};           ///< t [m]; 0 < t <= 0.5 r
  double length{};                   ///< L [m]; > 0
  double depth{};                    ///< a, radial [m]; > 0, <= 0.9 t
  double half_length{};              ///< c, along the mouth [m]; 0.2 <= a/c <= 5
  Surface surface = Surface::outer;  ///< surface of the mouth
  double angle{};                    ///< beta [rad]; -pi/2 < angle <= pi/2
  double place{};                    ///< z of the crack's middle [m]; 0: half the length
  double torque = 1;                 ///< magnitude of the torque [N*m]; > 0
  /// sense of the torque about +z on the end z = length
  TorqueSense sense = TorqueSense::positive;
  fem::CrackFaces crack_faces =
      /// treatment of the faces; `free` lets them pass through each other
      fem::CrackFaces::contact;
  int order = 3;      ///< order of the displacements [-]; 2 to 4
  int rings = 3;      ///< circular rings about the front [-]; 3 to 12
  int segments = 4;   ///< segments along the front [-]; a multiple of 4, 4 to 32
  double growth = 0;  ///< growth from cell to cell away from the crack [-]; 1.5 to 4, 0: by a/t
  /// Also solve a crack 1 % smaller, and compare G with dC/dA (FE-28).
  bool check_growth = true;
  /// Also solve three smaller cracks of the same shape, and integrate G over their growth.
  bool check_sizes = false;
  fem::FieldRequest fields = {};  ///< fields at the given size; no fields if left out
  /// Called after the solution of each mesh with one of its loads, and the time of all loads
  /// including the mesh [s]; may be empty.
  std::function<void(const fem::SolidResult&, double)> solved = {};
};

/// A place of the front of a surface crack.
struct EllipsePoint : FrontPoint {
  double front_angle{};  ///< angle of the ellipse, from the end toward +z [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"front_angle", "rad", "angle of the ellipse, from the end toward +z"},
          &EllipsePoint::front_angle);
    FrontPoint::describe(field);
  }
};

/// Results for a tube with a surface crack, with their checks.
///
/// There is one front.  It runs from the mouth's end toward +z (at 90 degrees: toward -theta) to
/// its other end, with FrontStation::position = phi/pi and (c cos(phi), a sin(phi)) the point of
/// the front.  At the two ends K is not defined, because the field at a corner is different.  The
/// values there are a projection of G and must not be used as results. `energy_release_rate` and
/// `derivative_release_rate` are per area that the crack sweeps when it grows in proportion
/// (FE-34).
struct TubeSurfaceCrackResult : TubeCrackResult {
  double area{};                 ///< area of the crack [m^2]
  double compliance_by_sizes{};  ///< int 2G/T^2 dA [rad/(N*m)], (FE-35); 0: not computed
  double sizes_check{};          ///< compliance_by_sizes/added_compliance - 1 [-]
  fem::FrontStation deepest;     ///< the station at phi = 90 degrees

  /// The front without its two ends, where K is not defined.
  [[nodiscard]] std::vector<EllipsePoint> front() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    describe_common(field);
    field({"from_upper_to_lower_end", "",
           "points along the front without its ends, where K is not defined"},
          &TubeSurfaceCrackResult::front);
  }
};

/// The mesh for the given crack size.
/// @throws InputError  if a value is out of range, or the crack crosses an end of the tube or
///                     itself
[[nodiscard]] fem::HexMesh mesh_tube_with_surface_crack(const TubeWithSurfaceCrack& tube);

/// Solves the tube once, and again as often as the checks and the contact of the faces require.
///
/// Range: the crack with its rings stays clear of both ends and of itself round the tube. Accuracy
/// at order 3, a/t from 0.1 to 0.5: 0.3 % of the mean G, 0.5 % of K at the deepest point, 0.7 % of
/// K along the front, and 0.3 % of the added compliance; at order 2, 1.5 % of the mean G.  For
/// deeper cracks, only 1 % of G is confirmed.  For faces that touch and slide, at 20 degrees and
/// order 2, dC/dA and G agree within 0.5 %.
///
/// @throws InputError   if a value is out of range, or the crack crosses an end of the tube
/// @throws SolverError  on the same conditions as solve_solid
[[nodiscard]] TubeSurfaceCrackResult solve_tube_with_surface_crack(
    const TubeWithSurfaceCrack& tube);

/// The same for both senses of the torque, with one factorisation for each size of the crack.
/// `sense` is not read.
[[nodiscard]] BothSenses<TubeSurfaceCrackResult> solve_both_senses(
    const TubeWithSurfaceCrack& tube);

}  // namespace strainwave::gear_fem
