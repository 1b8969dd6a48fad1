// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "strainwave/growth/rate_law.hpp"
#include "strainwave/materials/material_record.hpp"

namespace strainwave {

/// The law of growth that a record of the material library states.
///
/// One power law gives Paris and two successive ones TwoLines, which meet where the first one ends.
/// NASGRO constants give Nasgro with the toughness of a through crack over the thickness (GR-11),
/// or of a part-through crack.  The unverified sign of a constant stays as the record has it.
///
/// @param through_thickness  t of the wall of a through crack [m]; > 0; absent: a part-through
/// crack
/// @throws InputError        if the record has no law, or NASGRO constants without a yield strength
[[nodiscard]] RateLaw rate_law(const MaterialRecord& record,
                               std::optional<double> through_thickness = {});

}  // namespace strainwave
