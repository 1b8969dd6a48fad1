// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "strainwave/core/lift.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

// Default torques of the maker, from catalogues (TC-14): T1 and T2 over the cube
// of the pitch diameter [Pa], T3 and rated torque over T2.
inline constexpr double kConventionT1 = 0.0517e6;
inline constexpr double kConventionT2 = 0.187e6;
inline constexpr double kConventionT3 = 1.6;
inline constexpr double kConventionRated = 1.8;

/// The torques at the ends of the maker's three lines [N*m].
template <class Real>
struct LineTorques {
  Real T1{};
  Real T2{};
  Real T3{};
};

template <class Real>
[[nodiscard]] LineTorques<Real> line_torques(const GearSet& gear, const Lift<Real>& lift) {
  using std::pow;
  LineTorques<Real> at;
  if (gear.rating) {
    at.T1 = lift(gear.rating->T1);
    at.T2 = lift(gear.rating->T2);
  } else {
    const Real d3 = pow(lift(gear.drive.pitch_diameter), 3.0);
    at.T1 = kConventionT1 * d3;
    at.T2 = kConventionT2 * d3;
  }
  at.T3 =
      gear.rating && gear.rating->T3 ? Real(lift(*gear.rating->T3)) : Real(kConventionT3 * at.T2);
  return at;
}

}  // namespace strainwave
