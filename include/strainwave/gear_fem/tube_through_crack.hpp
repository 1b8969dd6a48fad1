// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/fem/solid.hpp"
#include "strainwave/gear_fem/checks.hpp"
#include "strainwave/model/input/flexspline.hpp"
#include "strainwave/model/result/crack_strength.hpp"

namespace strainwave::gear_fem {

/// What makes a cup of a tube, with sharp corners.
struct BarrelEnds {
  std::optional<TubeSection> rim = {};      ///< at z = length; its wall covers the tube's
  std::optional<Diaphragm> diaphragm = {};  ///< below z = 0
  std::optional<TubeSection> boss = {};     ///< below the diaphragm, as wide as its bore

  [[nodiscard]] bool any() const { return rim || diaphragm || boss; }
};

/// A tube with a straight through crack in its wall, clamped at z = 0, twisted at z = length; or
/// the barrel of a cup, held and loaded as CupSection says.
///
/// The crack is straight on the unrolled middle surface and radial through the wall; its angle
/// counts from the generator (+z) toward -theta, so that positive torque opens it for
/// 0 < angle < 90 degrees.
struct TubeWithThroughCrack {
  fem::Elasticity material;
  double mean_radius{};                       ///< r [m]; > 0
  double wall_thickness{};                    ///< t [m]; 0 < t <= 0.5 r
  double length{};                            ///< L [m]; > 0
  double half_length{};                       ///< a, on the middle surface [m]; > 0
  double angle{};                             ///< beta [rad]; -pi/2 < angle <= pi/2
  double place{};                             ///< z of the crack's middle [m]; 0: half the length
  BarrelEnds ends = {};                       ///< nothing: a tube
  double torque = 1;                          ///< > 0 [N*m]; its sense is `sense`
  TorqueSense sense = TorqueSense::positive;  ///< about +z, on the end z = length
  fem::CrackFaces crack_faces =
      fem::CrackFaces::contact;  ///< `free` lets them pass through each other
  int order = 3;                 ///< of the displacements [-]; 2 to 4
  int sectors =
      0;           ///< of cells round the crack [-]; a multiple of 8 from 8 to 64, 0: by its length
  int rings = 0;   ///< about each tip [-]; 2 to 16, 0: down to 4 % of wall or crack
  int layers = 0;  ///< of cells through the wall [-]; 1 to 8, 0: by a/t
  /// Also solves sizes 1 % smaller and larger, and compares G with dC/dA.
  bool check_growth = true;
  /// Called after each solution with it and its time [s], mesh included; may be empty.
  std::function<void(const fem::SolidResult&, double)> solved = {};
  fem::FieldRequest fields = {};  ///< of the given size; nothing if left out
};

/// A place of a front and what is there at the given torque.
struct FrontPoint {
  static constexpr bool kTableRow = true;
  double x{};                    ///< [m]
  double y{};                    ///< [m]
  double z{};                    ///< [m]
  double K_I{};                  ///< [Pa*m^0.5]; 0 where the crack is closed
  double K_II{};                 ///< [Pa*m^0.5]
  double K_III{};                ///< [Pa*m^0.5]
  double energy_release_rate{};  ///< [J/m^2]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"x", "m", "across the axis, through the middle of the crack"}, &FrontPoint::x);
    field({"y", "m", "across the axis"}, &FrontPoint::y);
    field({"z", "m", "along the axis"}, &FrontPoint::z);
    field({"K_I", "Pa*m^0.5", "opening; 0 where the crack is closed"}, &FrontPoint::K_I);
    field({"K_II", "Pa*m^0.5", "sliding ahead"}, &FrontPoint::K_II);
    field({"K_III", "Pa*m^0.5", "tearing"}, &FrontPoint::K_III);
    field({"energy_release_rate", "J/m^2", "G"}, &FrontPoint::energy_release_rate);
  }
};

/// The front of one tip of a through crack.
struct TipFront {
  std::string_view tip;
  std::vector<FrontPoint> from_inner_to_outer_face;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"tip", "", "upper: toward +z, at 90 degrees toward -theta; lower: the other"},
          &TipFront::tip);
    field({"from_inner_to_outer_face", "", "through the wall"},
          &TipFront::from_inner_to_outer_face);
  }
};

/// The tube's answer with its evidence; front 0 is the tip toward +z (at 90 degrees: toward
/// -theta), front 1 the other, stations from the inner face to the outer one.
struct TubeCrackResult {
  fem::SolidResult solid;  ///< at the given torque; K signed as FrontStation says
  /// Of the tube without the crack, exact, L/(mu J); of the cup that of solve_cup [rad/(N*m)]
  double compliance_without{};
  /// What the solids have without the crack, work/T^2 less the added compliance, over
  /// compliance_without, - 1 [-]; 0: a tube
  double sound_check{};
  double compliance{};               ///< with the crack [rad/(N*m)]
  double added_compliance{};         ///< by reciprocity [rad/(N*m)], (FE-26)
  double nominal_shear{};            ///< tau of the middle surface, T r/J [Pa]
  double energy_release_rate{};      ///< G over both fronts [J/m^2], (FE-23)
  double derivative_release_rate{};  ///< T^2/2 dC/dA of neighbouring sizes [J/m^2]; 0: not done
  double growth_check{};             ///< derivative_release_rate/energy_release_rate - 1 [-]
  double closed_release_rate{};      ///< 1e-3 K0^2/E: a smaller G counts as none [J/m^2]
  bool closed = false;  ///< the faces touch along both fronts: K_I = 0 all through the wall
  bool usable = false;  ///< the checks agree
  std::string reason;   ///< why not; empty when usable

  /// Whether there is an energy release rate to compare with its derivative.
  [[nodiscard]] bool releases() const;
  /// "open", "partly closed" or "closed"
  [[nodiscard]] std::string_view faces() const;
  /// K_I is 0 of a closed crack: what is left there is rounding.
  [[nodiscard]] FrontPoint at(const fem::FrontStation& station) const;
  [[nodiscard]] std::vector<TipFront> tips() const;
  [[nodiscard]] Checks checks() const;

  /// All but the fronts.
  template <class Visitor>
  static void describe_common(Visitor& field) {
    using R = TubeCrackResult;
    field({"faces", "", "open, partly closed or closed"}, &R::faces);
    field({"contact_share", "1", "share of the crack over which the faces touch"},
          [](const R& r) { return r.solid.contact_share; });
    field({"added_compliance", "rad/(N*m)", "by the crack"}, &R::added_compliance);
    field({"energy_release_rate", "J/m^2", "of the whole crack, grown in proportion"},
          &R::energy_release_rate);
    field({"evidence", "", "how well the solution agrees with itself"}, &R::checks);
    field({"usable", "", "whether the checks agree"}, &R::usable);
    field({"reason", "", "why not; empty if they do"}, &R::reason);
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    describe_common(field);
    field({"fronts", "", "the crack front at each of the two tips"}, &TubeCrackResult::tips);
  }
};

/// How far the crack of a barrel stays away from rim and diaphragm, over the wall's thickness [-]:
/// there their disturbance of the shear stress T r/J is exp(-2.5 pi) of what it is at the joint.
inline constexpr double kClearOfJoint = 2.5;

/// The mesh that is solved for the given crack size.
/// @throws InputError  a value out of range; a crack that crosses an end of the tube, the
/// diaphragm,
///                     or itself; one too close to rim or diaphragm; sections that do not meet
[[nodiscard]] fem::HexMesh mesh_tube_with_through_crack(const TubeWithThroughCrack& tube);

/// Solves the tube.
///
/// Range: the crack, with a fiftieth (long) to a third (short) of its half length beyond its tips
/// and a tenth of all that, whatever its angle, stays clear of both ends and of itself round the
/// tube.
/// Accuracy at order 3, a/t from 0.05 to 13: G 0.2 %, added compliance 0.2 %; open, and closed and
/// sliding, at angles from 0 to 90 degrees (G against dC/dA: 0.1 %; a 0.3 to 30 mm in a tube of
/// mean radius 78.88 mm and wall 2.24 mm; at order 2 G 3 %, added compliance 2 %).  K_II and K_III
/// vary steeply toward the faces of the wall when the crack slides: in the middle of the wall
/// orders 3 and 4 differ by 0.5 %, at the faces of the wall and where two segments of the front
/// meet a station may be 8 % off.  What the integrals find as K_I of a closed front, before it is
/// set to 0, is less than 0.1 % of tau sqrt(pi a).
///
/// In a cup the added compliance is that of the stress T r/J (FE-26): with a crack as close to a
/// joint as kClearOfJoint allows, dC/dA and G agree within 0.15 %.
///
/// @throws InputError   as mesh_tube_with_through_crack
/// @throws SolverError  see solve_solid
[[nodiscard]] TubeCrackResult solve_tube_with_through_crack(const TubeWithThroughCrack& tube);

}  // namespace strainwave::gear_fem
