// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "strainwave/catalogue/proportions.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// The drive to which a catalogue stiffness applies: without cracks, output shaft and flange.
[[nodiscard]] GearSet component_set(const GearSet& gear);

/// Form, and the length class with the nearest typical length by the logarithm; empty for a drive
/// without flexspline or with a cylinder.
[[nodiscard]] std::optional<DriveType> type_of(const GearSet& gear);

/// Whether a pitch diameter is that of a size.
/// @param pitch_diameter  [m]
[[nodiscard]] bool has_size(double pitch_diameter, double size);

/// Whether most rows of the catalogue are of this form and length.
[[nodiscard]] bool is_short_cup(const DriveType& type);

/// "short cup", "flat hat".
[[nodiscard]] std::string words_of(const DriveType& type);

}  // namespace strainwave
