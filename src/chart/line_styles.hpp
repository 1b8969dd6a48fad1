// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// @file
/// Colours and dashes of the charts, after Okabe and Ito's palette, which colour-blind readers can
/// tell apart.  Each colour has a contrast of at least 3 against white and against the dark ground
/// of a report.

namespace strainwave {

/// Colour of the line with this number, "#0072B2"; after the seventh line the colours repeat.
[[nodiscard]] std::string_view line_colour(std::size_t n);

/// Lengths of dashes and gaps of the line with this number; empty: the line is not dashed.  Where
/// the colours repeat, the dashes have one more dot.
[[nodiscard]] std::string line_dashes(std::size_t n);

/// Colour of the bars of the series with this number.
[[nodiscard]] std::string_view bar_colour(std::size_t n);

/// A colour between blue and vermilion, both dark enough on white; `share` from 0 to 1.
[[nodiscard]] std::string level_colour(double share);

}  // namespace strainwave
