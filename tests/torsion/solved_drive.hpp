// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "strainwave/torsion/torsion_curve.hpp"
#include "torsion/typical_drive.hpp"

// Quantities of a solved coupled drive for the tests.

namespace strainwave::test {

inline constexpr double kMicron = 1e-6;

/// The state at one torque.
inline CurvePoint point_at(const GearSet& gear, double torque, const CoupledOptions& options = {}) {
  const TorsionCurve curve = torsion_curve(gear, {{torque}}, options);
  EXPECT_TRUE(curve.usable()) << curve.unusable_because;
  return curve.points.at(0);
}

inline double twist(const GearSet& gear, double torque, const CoupledOptions& options = {}) {
  return point_at(gear, torque, options).twist;
}

/// The typical drive with a half free circular spline, which has all members of the coupled drive.
inline GearSet supported_drive() {
  GearSet gear = typical_drive();
  half_free(gear);
  return gear;
}

/// The maker's torques of the typical drive [N*m].
inline std::array<double, 3> Ts() { return conventional_torques(typical_drive()); }

inline double share(const CurvePoint& point, CurveMember member) {
  return point.share[static_cast<std::size_t>(member)];
}

/// The largest of the forces [N].
inline double largest(const std::vector<ContactForce>& contacts) {
  double force = 0.0;
  for (const ContactForce& contact : contacts) force = std::max(force, contact.force);
  return force;
}

}  // namespace strainwave::test
