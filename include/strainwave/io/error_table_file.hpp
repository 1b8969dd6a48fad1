// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "strainwave/io/attachments.hpp"
#include "strainwave/io/history_file.hpp"
#include "strainwave/model/input/gear_set.hpp"

/// @file
/// The file of a kinematic error over the angle of the input: CSV with the columns input_angle and
/// error (MO-56).

namespace strainwave {

inline constexpr std::size_t kMinErrorRows = 4;  ///< smallest number of rows of a kinematic error
inline constexpr std::size_t kMaxErrorRows = 8192;  ///< largest number of rows of a kinematic error

/// Reads a kinematic error at even angles of the input; the last row is the first one again, a
/// period later.
///
/// @throws InputError  if a column or its unit is missing; if the angles are not even, or the last
///                     error is not the first one to 1 % of the range; if there are fewer than
///                     kMinErrorRows or more than kMaxErrorRows rows; the message names the line
[[nodiscard]] ErrorTable read_error_table(HistoryFile& file);

/// Reads the kinematic error that a drive names, if it names one.
void read_error_table(GearSet& gear, const Attachments& attachments);

}  // namespace strainwave
