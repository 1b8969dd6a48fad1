// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

/// @file
/// K of a crack over a turn of the wave generator, as every model of a turn states it.

namespace strainwave {

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

/// Size of a crack of the barrel.
struct TurnSize {
  std::optional<double> depth;  ///< of a surface crack [m]
  double half_length{};         ///< [m]

  /// "half length 2 mm", or "depth 0.2 mm".
  [[nodiscard]] std::string name() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"depth", "m", "depth of a surface crack"}, &TurnSize::depth);
    field({"half_length", "m", "half length of the crack"}, &TurnSize::half_length);
  }
};

/// A turn under one torque.
struct LoadedTurn {
  double torque{};                    ///< T [N*m]
  std::vector<StationTurn> stations;  ///< of the upper tip, then of the lower tip

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque at the output"}, &LoadedTurn::torque);
    field({"stations", "", "places of the fronts"}, &LoadedTurn::stations);
  }
};

/// A turn at one size of the crack.
struct SizedTurn : TurnSize {
  std::vector<LoadedTurn> torques;

  template <class Visitor>
  static void describe(Visitor&& field) {
    TurnSize::describe(field);
    field({"torques", "", "the turn under each torque"}, &SizedTurn::torques);
  }
};

/// The range of K_I over a turn.
/// @param factors  over one wave, two or more; the last angle is the first one again
[[nodiscard]] TurnRange turn_range(std::span<const TurnFactor> factors);

/// The station with the largest range of K_I, the first if several tie; null: there is none.
[[nodiscard]] const StationTurn* governing_station(std::span<const StationTurn> stations);
/// The same over all sizes and torques.
[[nodiscard]] const StationTurn* governing_station(std::span<const SizedTurn> sizes);

}  // namespace strainwave
