// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/core/units.hpp"

// Steel of the article's drive (support/article_gear.hpp); G is the printed value, not E/2(1+nu).

namespace strainwave::test {

inline constexpr double kE = 210 * units::GPa;
inline constexpr double kG = 80 * units::GPa;
inline constexpr double kNu = 0.3;
inline constexpr double kPlaneStrain = kE / (1 - kNu * kNu);

}  // namespace strainwave::test
