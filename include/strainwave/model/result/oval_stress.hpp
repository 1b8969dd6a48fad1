// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"

/// @file
/// Stress of a sound flexspline over a turn of the wave generator, as every model of the oval
/// states it.

namespace strainwave {

/// Part of the wall of a cup.
enum class WallPart { diaphragm, barrel, rim };
template <>
struct EnumNames<WallPart> {
  static constexpr std::array<std::string_view, 3> names = {"diaphragm", "barrel", "rim"};
};

/// Von Mises stress [Pa] of a stress: rr, theta theta, zz, theta z, rz, r theta [Pa].
[[nodiscard]] double von_mises(const std::array<double, 6>& stress);

/// Extremes of a stress at one place of the wall over a turn, with their angles from a lobe.
struct StressExtremes {
  double largest{};     ///< [Pa]
  double at_largest{};  ///< [rad]
  double least{};       ///< [Pa]
  double at_least{};    ///< [rad]

  /// Largest minus least stress [Pa].
  [[nodiscard]] double range() const { return largest - least; }
  /// Takes a value at an angle.
  void take(double value, double angle, bool first) {
    if (first || value > largest) {
      largest = value;
      at_largest = angle;
    }
    if (first || value < least) {
      least = value;
      at_least = angle;
    }
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = StressExtremes;
    field({"largest", "Pa", "largest value over a turn"}, &R::largest);
    field({"at_largest", "rad", "angle from a lobe to the place at the largest value"},
          &R::at_largest);
    field({"least", "Pa", "least value over a turn"}, &R::least);
    field({"at_least", "rad", "angle from a lobe to the place at the least value"}, &R::at_least);
  }
};

/// Stress at one place of the wall over a turn.
struct OvalStation {
  static constexpr bool kTableRow = true;
  WallPart part = WallPart::barrel;
  double at{};                ///< z from the barrel's end, or the radius in the diaphragm [m]
  std::string_view face;      ///< "inner" or "outer"
  StressExtremes hoop;        ///< round the axis
  StressExtremes meridional;  ///< along the axis, in the diaphragm along the radius
  StressExtremes shear;
  StressExtremes equivalent;  ///< von Mises

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = OvalStation;
    field({"part", "", "diaphragm, barrel or rim"}, &R::part);
    field({"at", "m",
           "barrel and rim: z from the barrel's end toward the diaphragm; diaphragm: radius"},
          &R::at);
    field({"face", "", "inner or outer face of the wall"}, &R::face);
    field({"hoop", "", "stress round the axis"}, &R::hoop);
    field({"meridional", "", "stress along the axis, in the diaphragm along the radius"},
          &R::meridional);
    field({"shear", "", "shear stress; T > 0 makes it positive"}, &R::shear);
    field({"equivalent", "", "von Mises stress"}, &R::equivalent);
  }
};

/// Angles over one wave at which the extremes are sought: a degree each.
inline constexpr int kOvalAngles = 180;
/// Even places of each part of the wall at which the stress is stated.
inline constexpr int kOvalPlaces = 9;

/// Stress under one torque.
struct LoadedOval {
  double torque{};                    ///< T at the output [N*m]
  std::vector<OvalStation> stations;  ///< along the wall from the diaphragm's bore

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "torque at the output"}, &LoadedOval::torque);
    field({"stations", "", "places along the wall from the bore of the diaphragm"},
          &LoadedOval::stations);
  }
};

/// The station with the largest von Mises stress.
/// @param torques  one or more, with stations
[[nodiscard]] const OvalStation& governing_station(std::span<const LoadedOval> torques);

/// Contact of the wave generator with the bore, in numbers.
struct WaveContact {
  double lobe_force{};        ///< resultant of the pressure of one lobe along its axis [N]
  double half_arc{};          ///< half of the arc on which a lobe presses [rad]; at most pi/2
  double largest_pressure{};  ///< on the bore, even over the width of the band [Pa]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = WaveContact;
    field({"lobe_force", "N", "force of one lobe of the wave generator on the bore"},
          &R::lobe_force);
    field({"half_arc", "rad", "half of the arc on which a lobe presses"}, &R::half_arc);
    field({"largest_pressure", "Pa", "largest pressure on the bore, even over the band"},
          &R::largest_pressure);
  }
};

/// The oval as every model states it.
struct OvalState {
  double coning_angle{};     ///< turn of the rim's meridian outward at a lobe [rad]
  bool large_rotations{};    ///< whether large rotations of the oval were computed
  double rotation_stress{};  ///< largest change of a stress by large rotations [Pa]
  std::vector<LoadedOval> torques;

  /// The station with the largest von Mises stress under any torque.
  [[nodiscard]] const OvalStation& governing() const { return governing_station(torques); }
  /// Von Mises stress there, the largest over a turn [Pa].
  [[nodiscard]] double largest() const { return governing().equivalent.largest; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = OvalState;
    field({.name = "largest",
           .unit = "Pa",
           .doc = "largest von Mises stress of the wall over a turn",
           .headline = true},
          &R::largest);
    field({"coning_angle", "rad", "turn of the rim's meridian outward at a lobe"},
          &R::coning_angle);
    field({"large_rotations", "", "whether large rotations of the oval were computed"},
          &R::large_rotations);
    field(
        {"rotation_stress", "Pa", "largest change of a stress by large rotations; 0 without them"},
        &R::rotation_stress);
    field({"torques", "", "the stress under each torque"}, &R::torques);
  }
};

}  // namespace strainwave
