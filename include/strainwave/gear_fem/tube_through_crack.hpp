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

/// The parts that make a cup of a tube, with sharp corners.
struct BarrelEnds {
  /// rim at z = length; its wall covers the wall of the tube
  std::optional<TubeSection> rim = {};
  std::optional<Diaphragm> diaphragm = {};  ///< diaphragm below z = 0
  std::optional<TubeSection> boss = {};     ///< boss below the diaphragm, as wide as its bore

  [[nodiscard]] bool any() const { return rim || diaphragm || boss; }
};

/// A tube with a straight through crack in its wall, clamped at z = 0, twisted at z = length; or
/// the barrel of a cup, held and loaded as in CupSection.
///
/// The crack is straight on the unrolled middle surface and radial through the wall; its angle
/// counts from the generator (+z) toward -theta, so that positive torque opens it for
/// 0 < angle < 90 degrees.
struct TubeWithThroughCrack {
  fem::Elasticity material;
  double mean_radius{};     ///< r [m]; > 0
  double wall_thickness{};  ///< t [m]; 0 < t <= 0.5 r
  double length{};          ///< L [m]; > 0
  double half_length{};     ///< half length a on the middle surface [m]; > 0
  double angle{};           ///< beta [rad]; -pi/2 < angle <= pi/2
  double place{};           ///< z of the crack's middle [m]; 0: half the length
  BarrelEnds ends = {};     ///< parts of a cup; empty: a tube
  double torque = 1;        ///< magnitude of the torque [N*m]; > 0
  /// sense of the torque about +z on the end z = length
  TorqueSense sense = TorqueSense::positive;
  fem::CrackFaces crack_faces =
      /// treatment of the faces; `free` lets them pass through each other
      fem::CrackFaces::contact;
  int order = 3;  ///< order of the displacements [-]; 2 to 4
  int sectors =
      /// number of cells round the crack [-]; a multiple of 8 from 8 to 64, 0: by its length
      0;
  int rings = 0;   ///< rings about each tip [-]; 2 to 16, 0: down to 4 % of wall or crack
  int layers = 0;  ///< layers of cells through the wall [-]; 1 to 8, 0: by a/t
  /// Also solve a crack 1 % smaller, and compare G with dC/dA (FE-28).
  bool check_growth = true;
  /// Called after the solution of each mesh with one of its loads, and the time of all loads
  /// including the mesh [s]; may be empty.
  std::function<void(const fem::SolidResult&, double)> solved = {};
  fem::FieldRequest fields = {};  ///< fields at the given size; no fields if left out
};

/// A place of a front with its stress intensity at the given torque.
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
    field({"K_I", "Pa*m^0.5", "opening mode; 0 if the crack is closed"}, &FrontPoint::K_I);
    field({"K_II", "Pa*m^0.5", "sliding mode"}, &FrontPoint::K_II);
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
    field({"tip", "", "upper: toward +z, at 90 degrees toward -theta; lower: the other tip"},
          &TipFront::tip);
    field({"from_inner_to_outer_face", "", "points through the wall"},
          &TipFront::from_inner_to_outer_face);
  }
};

/// Results for a tube with a through crack, with their checks.  Front 0 is the tip toward +z (at 90
/// degrees: toward -theta), front 1 the other tip.  Stations run from the inner to the outer face.
struct TubeCrackResult {
  fem::SolidResult solid;  ///< solution at the given torque; signs of K as in FrontStation
  /// Compliance without the crack [rad/(N*m)]: for a tube the exact L/(mu J), for a cup that of
  /// solve_cup.
  double compliance_without{};
  /// Compliance of the solid without the crack (work/T^2 minus the added compliance) over
  /// compliance_without, - 1 [-]; 0 for a tube.
  double sound_check{};
  double compliance{};               ///< compliance with the crack [rad/(N*m)]
  double added_compliance{};         ///< added compliance by reciprocity [rad/(N*m)], (FE-26)
  double nominal_shear{};            ///< tau of the middle surface, T r/J [Pa]
  double energy_release_rate{};      ///< G over both fronts [J/m^2], (FE-23)
  double derivative_release_rate{};  ///< T^2/2 dC/dA by two sizes [J/m^2], (FE-28); 0: not computed
  double growth_check{};             ///< derivative_release_rate/energy_release_rate - 1 [-]
  double closed_release_rate{};      ///< 1e-3 K0^2/E; a smaller G counts as zero [J/m^2]
  bool closed = false;  ///< the faces touch along both fronts, so K_I = 0 through the wall
  bool usable = false;  ///< the checks agree
  std::string reason;   ///< failed check; empty if usable

  /// Whether there is an energy release rate to compare with its derivative.
  [[nodiscard]] bool releases() const;
  /// State of the faces: "open", "partly closed" or "closed".
  [[nodiscard]] std::string_view faces() const;
  /// Values at a station.  For a closed crack K_I is set to 0, because the computed rest is
  /// rounding.
  [[nodiscard]] FrontPoint at(const fem::FrontStation& station) const;
  [[nodiscard]] std::vector<TipFront> tips() const;
  [[nodiscard]] Checks checks() const;

  /// Describes all fields except the fronts.
  template <class Visitor>
  static void describe_common(Visitor& field) {
    using R = TubeCrackResult;
    field({"faces", "", "open, partly closed or closed"}, &R::faces);
    field({"contact_share", "1", "share of the crack over which the faces touch"},
          [](const R& r) { return r.solid.contact_share; });
    field({"added_compliance", "rad/(N*m)", "compliance added by the crack"}, &R::added_compliance);
    field({"energy_release_rate", "J/m^2",
           "energy release rate of the whole crack, growing in proportion"},
          &R::energy_release_rate);
    field({"evidence", "", "internal checks of the solution"}, &R::checks);
    field({"usable", "", "whether the checks agree"}, &R::usable);
    field({"reason", "", "failed check; empty if all agree"}, &R::reason);
  }
  template <class Visitor>
  static void describe(Visitor&& field) {
    describe_common(field);
    field({"fronts", "", "the crack front at each of the two tips"}, &TubeCrackResult::tips);
  }
};

/// Least distance of a barrel's crack from rim and diaphragm, over the wall's thickness [-].  At
/// this distance the disturbance of the shear stress T r/J has fallen to exp(-2.5 pi) of its value
/// at the joint.
inline constexpr double kClearOfJoint = 2.5;

/// The mesh for the given crack size.
/// @throws InputError  if a value is out of range; if the crack crosses an end of the tube, the
///                     diaphragm or itself, or is too close to rim or diaphragm; if sections do not
///                     meet
[[nodiscard]] fem::HexMesh mesh_tube_with_through_crack(const TubeWithThroughCrack& tube);

/// Solves the tube.
///
/// Range: the crack stays clear of both ends and of itself round the tube.  The space beyond its
/// tips is a fiftieth (long crack) to a third (short crack) of its half length, plus a tenth of the
/// total, at any angle.
/// Accuracy at order 3, a/t from 0.05 to 13: 0.2 % of G and 0.2 % of the added compliance.  This
/// holds for open faces and for closed, sliding faces at angles from 0 to 90 degrees (G against
/// dC/dA: 0.1 %; a from 0.3 to 30 mm in a tube of mean radius 78.88 mm and wall 2.24 mm; at order
/// 2, 3 % of G and 2 % of the added compliance).  If the crack slides, K_II and K_III vary steeply
/// toward the faces of the wall.  In the middle of the wall, orders 3 and 4 differ by 0.5 %.  At
/// the faces of the wall and where two segments of the front meet, a station may be wrong by 8 %.
/// The K_I that the integrals find for a closed front, before it is set to 0, is less than 0.1 % of
/// tau sqrt(pi a).
///
/// In a cup, the added compliance follows from the stress T r/J (FE-26).  For a crack as close to a
/// joint as kClearOfJoint allows, dC/dA and G agree within 0.15 %.
///
/// @throws InputError   on the same conditions as mesh_tube_with_through_crack
/// @throws SolverError  on the same conditions as solve_solid
[[nodiscard]] TubeCrackResult solve_tube_with_through_crack(const TubeWithThroughCrack& tube);

/// Results under positive and under negative torque.
template <class Result>
struct BothSenses {
  Result positive;
  Result negative;
};

/// The same for both senses of the torque, with one factorisation for each size of the crack.
/// `sense` is not read.
[[nodiscard]] BothSenses<TubeCrackResult> solve_both_senses(const TubeWithThroughCrack& tube);

}  // namespace strainwave::gear_fem
