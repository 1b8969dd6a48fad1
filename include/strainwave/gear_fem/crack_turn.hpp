// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "strainwave/fem/crack_response.hpp"
#include "strainwave/gear_fem/checks.hpp"
#include "strainwave/gear_fem/oval_cup.hpp"
#include "strainwave/gear_fem/tube_surface_crack.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"
#include "strainwave/model/result/crack_turn.hpp"

/// @file
/// A crack of the barrel while the wave generator turns: K over a turn, with faces that touch.

namespace strainwave::gear_fem {

/// Layers of cells through the wall.  Bending opens the crack on one face and shuts it on the
/// other, so one layer would not do.
inline constexpr int kTurnLayers = 2;

/// The body with its crack at one angle, as fields.
struct TurnFrame {
  std::size_t torque{};  ///< index into TurningCrack::torques
  std::size_t number{};  ///< of the angle, from 0
  double angle{};        ///< from a lobe to the crack [rad]
  /// Displacement and stress of the oval, of the torque and of the crack together.
  fem::SampledFields fields;
  std::vector<fem::CrackFront> fronts;  ///< K as in the results of the turn, not rescaled to G
};

/// A crack of the barrel of a cup at work.
struct TurningCrack {
  /// The barrel with its crack.  `torque`, `sense`, `check_growth`, `fields` and `ends` are not
  /// read; `layers` 0 of a through crack gives kTurnLayers.  A through crack opens in the cup, a
  /// surface crack in the barrel alone, clamped at its lower end.
  std::variant<TubeWithThroughCrack, TubeWithSurfaceCrack> tube;
  BarrelEnds ends;  ///< parts that make a cup of the barrel; there must be a rim
  CamFit fit;
  LargeRotations large_rotations = LargeRotations::automatic;
  std::vector<double> torques;  ///< T [N*m], in the sense of +theta on the rim; one or more
  int angles = 36;              ///< angles over one wave, half a turn [-]; 8 to 720
  /// Also solve a crack 1 % smaller, and compare G with dC/dA (FE-28).
  bool check_growth = true;
  /// Called after each step with its name and its time [s]; may be empty.
  std::function<void(const std::string&, double)> done = {};
  /// Fields of TurnFrame.  With divisions, each state of the turn is also solved in full.
  fem::FieldRequest fields = {};
  /// Takes the fields of each state; empty: there are none.
  std::function<void(const TurnFrame&)> frame = {};
};

/// The plane of a crack, unrolled.
struct CrackPlane {
  struct Node {
    double along{};    ///< from the middle of the crack toward its upper tip [m]
    double through{};  ///< from the middle surface of the wall outward [m]
  };
  std::vector<Node> nodes;
  std::vector<fem::CrackCell> cells;  ///< they tile the crack
  double half_wall{};                 ///< half of the wall thickness [m]
};

/// The faces of a crack at one angle.
struct FacesAtAngle {
  std::vector<double> opening;  ///< at each node of the plane [m]
  std::vector<bool> touching;   ///< whether the faces press on each other there
  double contact_share{};       ///< share of the crack that touches [-]
};

/// The sound wall round the axis, at the height of the crack's middle, over one wave.
struct SoundRing {
  std::vector<double> angles;   ///< from a lobe; the last one is the first one again [rad]
  std::vector<double> radii;    ///< from the inner to the outer face [m]
  std::vector<double> outward;  ///< radial displacement of the middle surface at each angle [m]
};

/// A turn under one torque.
struct TorqueTurn {
  double torque{};  ///< T [N*m]
  std::vector<StationTurn> stations;
  double least_contact_share{};     ///< least share of the crack that touches, over the turn [-]
  double largest_contact_share{};   ///< [-]
  double largest_opening{};         ///< largest distance of the faces over the turn [m]
  double at_opening{};              ///< angle of the largest opening [rad]
  double checked_angle{};           ///< angle of the largest energy release rate [rad]
  Checks checks;                    ///< of the full solution at this angle
  std::vector<FacesAtAngle> faces;  ///< at each angle of the turn; not a part of the answer
  /// Stress normal to the crack that the sound wall has round the axis [Pa], at each angle of the
  /// ring and each radius, which runs fastest; not a part of the answer.
  std::vector<double> ring_stress;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = TorqueTurn;
    field({"torque", "N*m", "torque on the rim"}, &R::torque);
    field({"least_contact_share", "1", "least share of the crack that touches over the turn"},
          &R::least_contact_share);
    field({"largest_contact_share", "1", "largest share of the crack that touches over the turn"},
          &R::largest_contact_share);
    field({"largest_opening", "m", "largest distance of the crack's faces over the turn"},
          &R::largest_opening);
    field({"at_opening", "rad", "angle from a lobe to the crack at the largest opening"},
          &R::at_opening);
    field(
        {"checked_angle", "rad", "angle of the largest energy release rate, where the checks are"},
        &R::checked_angle);
    field({"evidence", "", "internal checks of the solution at this angle"}, &R::checks);
    field({"stations", "", "places of the fronts"}, &R::stations);
  }
};

/// Results of a turn, with their checks.
struct CrackTurn {
  OvalContact contact;              ///< of the wave generator
  double second_order_stress{};     ///< E (w_0/r)^2, the order of what large rotations add [Pa]
  double rotation_stress{};         ///< largest change by large rotations of the stress below [Pa]
  double largest_stress{};          ///< largest stress normal to the crack without it [Pa]
  std::vector<TorqueTurn> torques;  ///< as asked for
  std::string_view governing_tip;   ///< the tip with the larger range of K_I
  CrackPlane plane;                 ///< of TorqueTurn::faces
  SoundRing ring;                   ///< of TorqueTurn::ring_stress
  std::size_t unknowns{};
  std::size_t states{};  ///< angles times torques
  bool usable = false;
  std::string reason;  ///< failed check; empty if usable

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = CrackTurn;
    field({"wave_generator", "", "contact of the wave generator with the bore"}, &R::contact);
    field({"second_order_stress", "Pa", "E (w_0/r)^2, the order of what large rotations can add"},
          &R::second_order_stress);
    field({"rotation_stress", "Pa",
           "largest change of the stress normal to the crack by large rotations"},
          &R::rotation_stress);
    field({"largest_stress", "Pa", "largest stress normal to the crack, without the crack"},
          &R::largest_stress);
    field({"governing_tip", "", "the tip with the larger range of K_I"}, &R::governing_tip);
    field({"torques", "", "the turn under each torque"}, &R::torques);
    field({"usable", "", "whether the checks agree"}, &R::usable);
    field({"reason", "", "failed check; empty if all agree"}, &R::reason);
  }
};

/// Solves the turn (FE-52, FE-54).
///
/// The sound cup gives the stress at the crack at each angle; the crack releases this stress on its
/// faces.  The bore is held radially on the band of the wave generator while the crack opens.
///
/// Range: one crack of the barrel, linear, without friction between the faces.
/// Accuracy at order 3: that of solve_tube_with_through_crack or solve_tube_with_surface_crack, and
/// that of OvalCup.
///
/// @throws InputError   on the same conditions as the mesh of the crack and OvalCup; for values out
///                      of range
/// @throws SolverError  if a contact does not converge
[[nodiscard]] CrackTurn turn_crack(const TurningCrack& turning);

}  // namespace strainwave::gear_fem
