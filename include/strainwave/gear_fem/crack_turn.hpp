// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "strainwave/gear_fem/checks.hpp"
#include "strainwave/gear_fem/oval_cup.hpp"
#include "strainwave/gear_fem/tube_surface_crack.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"

/// @file
/// A crack of the barrel while the wave generator turns: K over a turn, with faces that touch.

namespace strainwave::gear_fem {

/// Layers of cells through the wall.  Bending opens the crack on one face and shuts it on the
/// other, so one layer would not do.
inline constexpr int kTurnLayers = 2;

/// A crack of the barrel of a cup at work.
struct TurningCrack {
  /// The barrel with its crack.  `torque`, `sense`, `check_growth`, `fields` and `ends` are not
  /// read; `layers` 0 of a through crack gives kTurnLayers.  A through crack opens in the cup, a
  /// surface crack in the barrel alone, clamped at its lower end.
  std::variant<TubeWithThroughCrack, TubeWithSurfaceCrack> tube;
  BarrelEnds ends;  ///< parts that make a cup of the barrel; there must be a rim
  OvalFit fit;
  LargeRotations large_rotations = LargeRotations::automatic;
  std::vector<double> torques;  ///< T [N*m], in the sense of +theta on the rim; one or more
  int angles = 36;              ///< angles over one wave, half a turn [-]; 8 to 720
  /// Also solve sizes 1 % smaller and larger, and compare G with dC/dA.
  bool check_growth = true;
  /// Called after each step with its name and its time [s]; may be empty.
  std::function<void(const std::string&, double)> done = {};
};

/// K_I at one station over a turn, in numbers.
struct TurnRange {
  double largest{};     ///< K_max of mode I [Pa*m^0.5]
  double least{};       ///< K_min of mode I [Pa*m^0.5]; 0 if the crack closes there
  double range{};       ///< K_max - K_min [Pa*m^0.5]
  double ratio{};       ///< R = K_min/K_max [-]; 0 if the station never opens
  double open_share{};  ///< share of the turn during which the station is open [-]
  double at_largest{};  ///< angle from a lobe to the crack at K_max [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = TurnRange;
    field({"largest", "Pa*m^0.5", "largest K_I over a turn"}, &R::largest);
    field({"least", "Pa*m^0.5", "least K_I over a turn; 0 if the crack closes there"}, &R::least);
    field({"range", "Pa*m^0.5", "Delta K of mode I"}, &R::range);
    field({"ratio", "1", "R = least/largest; 0 if the station never opens"}, &R::ratio);
    field({"open_share", "1", "share of the turn during which the station is open"},
          &R::open_share);
    field({"at_largest", "rad", "angle from a lobe to the crack at the largest K_I"},
          &R::at_largest);
  }
};

/// K at one angle.
struct TurnFactor {
  static constexpr bool kTableRow = true;
  double angle{};  ///< from a lobe of the wave generator to the crack, toward +theta [rad]
  double K_I{};    ///< [Pa*m^0.5]; 0 where the faces touch
  double K_II{};   ///< [Pa*m^0.5]
  double K_III{};  ///< [Pa*m^0.5]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = TurnFactor;
    field({"angle", "rad", "from a lobe of the wave generator to the crack, toward +theta"},
          &R::angle);
    field({"K_I", "Pa*m^0.5", "opening mode; 0 if the faces touch"}, &R::K_I);
    field({"K_II", "Pa*m^0.5", "sliding mode"}, &R::K_II);
    field({"K_III", "Pa*m^0.5", "tearing"}, &R::K_III);
  }
};

/// One station of a front over a turn, under one torque.
struct StationTurn {
  std::string_view tip;  ///< "upper": toward +z, at 90 degrees toward -theta; "lower"
  /// Of a through crack from -1 at the inner face of the wall to 1 at the outer face; of a surface
  /// crack the sine of the ellipse's angle, 1 at the deepest point [-].  Where the front of a
  /// surface crack meets the surface, K is not defined, and this place is left out.
  double station{};
  TurnRange mode_I;
  std::vector<TurnFactor> factors;  ///< over one wave; the last angle is the first one again

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = StationTurn;
    field({"tip", "", "upper: toward +z, at 90 degrees toward -theta; lower: the other tip"},
          &R::tip);
    field({"station", "1",
           "through crack: from -1 at the inner face of the wall to 1 at the outer face; surface "
           "crack: from 0 at the surface to 1 at the deepest point"},
          &R::station);
    field({"mode_I", "", "K_I over a turn"}, &R::mode_I);
    field({"factors", "", "K over one wave; the last angle is the first one again"}, &R::factors);
  }
};

/// A turn under one torque.
struct TorqueTurn {
  double torque{};  ///< T [N*m]
  std::vector<StationTurn> stations;
  double least_contact_share{};    ///< least share of the crack that touches, over the turn [-]
  double largest_contact_share{};  ///< [-]
  double checked_angle{};          ///< angle of the largest energy release rate [rad]
  Checks checks;                   ///< of the full solution at this angle

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = TorqueTurn;
    field({"torque", "N*m", "torque on the rim"}, &R::torque);
    field({"least_contact_share", "1", "least share of the crack that touches over the turn"},
          &R::least_contact_share);
    field({"largest_contact_share", "1", "largest share of the crack that touches over the turn"},
          &R::largest_contact_share);
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
