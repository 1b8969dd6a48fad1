// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"

// What the assessment asks of a crack, whatever its kind: crack_strength.cpp makes it from the
// drive, assessment.cpp answers.

namespace strainwave {

/// K_I, K_II, K_III of an open crack at one point of the front [Pa*m^0.5]; K_I < 0 presses.
struct FrontModes {
  std::array<double, 3> load{};      ///< of the given load
  std::array<double, 3> assembly{};  ///< of the assembly, where its hoop stress is tension
};

struct AssessedCrack {
  CrackStrength report;  ///< path, kind, material, size_name, size, ligament, notes, equations
  CrackModuli moduli;
  bool plane_stress = false;  ///< of the plastic zone (FR-19)
  /// Along the front of the crack grown or shrunk to a size, under T or -T.
  std::function<std::vector<FrontModes>(double size, double sense)> front;
  std::function<double(double size, double sense)> reference_stress;  ///< [Pa]
  double range_end = 0.0;      ///< largest size that the solutions reach [m]
  std::string range_text;      ///< what that size is
  bool assembly = false;       ///< the assembly stresses it
  double assembly_peak = 0.0;  ///< largest elastic stress of the assembly in the wall [Pa]
  std::optional<double> relative_uncertainty;  ///< of K under the load [-]
  /// Why a point inside the line does not show that the crack holds; empty: it does.
  std::string undecided;
};

/// Assesses a crack of a material under the given sense of torque, and under the other one where
/// that makes a difference; eqs. (FA-3) to (FA-5), (FA-13).
[[nodiscard]] CrackStrength assess(const AssessedCrack& crack, const Material& material,
                                   TorqueSense given);

}  // namespace strainwave
