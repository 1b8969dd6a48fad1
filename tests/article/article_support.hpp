// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string_view>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/stiffness_result.hpp"
#include "support/article_gear.hpp"

// Shared parts of the tests of the printed and of the repaired method.

namespace strainwave::test {

inline constexpr double kCompliance = 1 / (units::N * units::mm);  // [rad/(N*mm)]
inline constexpr double kStiffness = units::N * units::mm;         // [N*mm/rad]
inline const double kStressIntensity = units::MPa * std::sqrt(units::mm);

/// Expects that the article's drive, changed this way, is refused at `path` by a sentence that
/// names the method.
inline void expect_refused(const std::function<StiffnessResult(const GearSet&)>& method,
                           std::string_view name, std::string_view path,
                           const std::function<void(GearSet&)>& change) {
  GearSet gear = article_gear();
  change(gear);
  try {
    (void)method(gear);
    ADD_FAILURE() << path << " was accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), path) << error.what();
    EXPECT_NE(std::string_view(error.what()).find(name), std::string_view::npos) << error.what();
  }
}

}  // namespace strainwave::test
