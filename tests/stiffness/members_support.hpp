// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/units.hpp"
#include "strainwave/model/result/stiffness_result.hpp"
#include "support/reference.hpp"

// Shared parts of the tests of the members.

namespace strainwave::test {

inline constexpr double kComplianceNmm = 1 / (units::N * units::mm);  // [rad/(N*mm)]

/// The codes of notes.
using Codes = std::vector<std::string>;

/// A number of the corrected method for the article's drive, in N and mm.
inline Reference corrected_reference(double value, std::string_view unit, double tolerance,
                                     std::string_view tolerance_is) {
  return {.value = value,
          .unit = unit,
          .relative_tolerance = tolerance,
          .source = "corrected theory evaluated with 30 digits for the article's inputs",
          .tolerance_is = tolerance_is};
}

/// Added compliance under axial force and torque: axial, mixed, torsional.
inline std::array<double, 3> entries(const AddedCompliance& added) {
  const auto& m = added.axial_torsion.value();
  return {m[0].value, m[1].value, m[2].value};
}

}  // namespace strainwave::test
