// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/growth_laws/rate_law.hpp"
#include "strainwave/materials/material_record.hpp"
#include "strainwave/model/input/material_life.hpp"

namespace strainwave {

/// The law of growth that a record of the material library states.
///
/// One power law gives Paris and two successive ones TwoLines, which meet where the first one ends.
/// NASGRO constants give Nasgro with the toughness of a part-through crack, and that of a through
/// crack over the thickness.  The unverified sign of a constant stays as the record has it.
///
/// @throws InputError  if the record has no law, or several that are not branches of one
[[nodiscard]] RateLaw rate_law(const MaterialRecord& record);

/// As rate_law, without a check of the constants; absent if the record has no law, or several that
/// are not branches of one.
[[nodiscard]] std::optional<RateLaw> single_rate_law(const MaterialRecord& record);

/// Threshold of the record, and the ranges for which its law is stated.
[[nodiscard]] GrowthBounds growth_bounds(const MaterialRecord& record);

}  // namespace strainwave
