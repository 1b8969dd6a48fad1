// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "strainwave/core/quantity.hpp"

/// @file
/// The answers of the coupled drive if it is solved: the maker's stiffnesses and the wind-up.

namespace strainwave {

/// The maker's torques with their defaults filled in.
struct MakersTorques {
  double T1 = 0.0;           ///< [N*m]
  double T2 = 0.0;           ///< [N*m]
  double T3 = 0.0;           ///< [N*m]
  double rated = 0.0;        ///< T_N [N*m]
  double lost_motion = 0.0;  ///< torque at which lost motion is measured [N*m]
  bool by_convention =
      false;  ///< true if T1 and T2 were not given and are 0.0517 d^3 and 0.187 d^3 N/mm^2

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"T1", "N*m", "torque up to which K1 holds"}, &MakersTorques::T1);
    field({"T2", "N*m", "torque up to which K2 holds"}, &MakersTorques::T2);
    field({"T3", "N*m", "torque up to which K3 is taken"}, &MakersTorques::T3);
    field({"rated", "N*m", "T_N"}, &MakersTorques::rated);
    field({"lost_motion", "N*m", "torque at which lost motion is measured"},
          &MakersTorques::lost_motion);
    field({"by_convention", "", "whether T1 and T2 were not given"}, &MakersTorques::by_convention);
  }
};

/// The maker's stiffnesses and the wind-up of the coupled drive with the cracks at the positions of
/// the file; eq. (TC-14).
struct CurveStiffness {
  Quantity K1;  ///< [N*m/rad]
  Quantity K2;  ///< [N*m/rad]
  Quantity K3;  ///< [N*m/rad]
  std::optional<Quantity>
      wind_up;  ///< twist at the given torque [rad]; absent if the drive does not reach this torque
  Quantity wind_up_at_T1;  ///< [rad]
  Quantity wind_up_at_T2;  ///< [rad]
  Quantity wind_up_at_T3;  ///< [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"K1", "N*m/rad", "stiffness up to T1"}, &CurveStiffness::K1);
    field({"K2", "N*m/rad", "stiffness from T1 to T2"}, &CurveStiffness::K2);
    field({"K3", "N*m/rad", "stiffness from T2"}, &CurveStiffness::K3);
    field({"wind_up", "rad", "twist at the given torque"}, &CurveStiffness::wind_up);
    field({"wind_up_at_T1", "rad", "twist at T1"}, &CurveStiffness::wind_up_at_T1);
    field({"wind_up_at_T2", "rad", "twist at T2"}, &CurveStiffness::wind_up_at_T2);
    field({"wind_up_at_T3", "rad", "twist at T3"}, &CurveStiffness::wind_up_at_T3);
  }
};

/// Relative changes of the coupled drive by the cracks, cracked/sound - 1 [-].
struct CurveChange {
  Quantity K1;
  Quantity K2;
  Quantity K3;
  std::optional<Quantity> wind_up;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(
        {"K1", "1", "K1 of the cracked over K1 of the sound drive, minus 1; negative means softer"},
        &CurveChange::K1);
    field({"K2", "1", "cracked/sound - 1 of K2"}, &CurveChange::K2);
    field({"K3", "1", "cracked/sound - 1 of K3"}, &CurveChange::K3);
    field({"wind_up", "1",
           "wind-up of the cracked over that of the sound drive at the given torque, minus 1"},
          &CurveChange::wind_up);
  }
};

/// The maker's stiffnesses [N*m/rad].
struct LineStiffness {
  Quantity K1;
  Quantity K2;
  Quantity K3;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"K1", "N*m/rad", "stiffness up to T1"}, &LineStiffness::K1);
    field({"K2", "N*m/rad", "stiffness from T1 to T2"}, &LineStiffness::K2);
    field({"K3", "N*m/rad", "stiffness from T2"}, &LineStiffness::K3);
  }
};

/// The maker's stiffnesses over a turn of the wave generator, in which the cracks of teeth, rim,
/// outer ring and circular spline pass the lobes; eq. (TC-26).
struct CurveOverTurn {
  LineStiffness mean;
  LineStiffness softest;  ///< each stiffness at the angle where it is lowest

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"mean", "", "mean values over the angles"}, &CurveOverTurn::mean);
    field({"softest", "", "each stiffness at the angle where it is lowest"},
          &CurveOverTurn::softest);
  }
};

/// The coupled drive with its cracks under one sense of torque.
struct CrackedCurve : CurveStiffness {
  CurveChange change;
  /// absent if no crack turns relative to the lobes, or if the caller did not ask for a turn
  std::optional<CurveOverTurn> over_turn;

  template <class Visitor>
  static void describe(Visitor&& field) {
    CurveStiffness::describe([&](Field of_both, auto member) {
      of_both.headline = of_both.unit == "N*m/rad";
      field(of_both, member);
    });
    field({"change", "", "changes by the cracks"}, &CrackedCurve::change);
    field({"over_turn", "", "stiffnesses over a turn, if cracks turn relative to the lobes"},
          &CrackedCurve::over_turn);
  }
};

/// The results of the coupled drive, which solves balls, teeth and elastic rings as one system.  If
/// the file gives enough for this model, its results come before the sum of the members.
struct CurveResult {
  MakersTorques torques;
  CurveStiffness intact;
  CrackedCurve positive;  ///< torque about +z
  CrackedCurve negative;  ///< torque about -z

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torques", "", "the maker's torques"}, &CurveResult::torques);
    field({"intact", "", "without the cracks"}, &CurveResult::intact);
    field({"positive", "", "cracked, torque about +z"}, &CurveResult::positive);
    field({"negative", "", "cracked, torque about -z"}, &CurveResult::negative);
  }
};

}  // namespace strainwave
