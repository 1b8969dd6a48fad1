// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// The rules of `check` between fields, without the ranges of single fields: for a drive of which
/// only some numbers have changed since `check`, where the ranges of these are checked apart.
/// @throws InputError  as `check`
void check_rules(const GearSet& gear);

/// The rules of `check_rules` in which the size of a crack appears: for a drive of which only the
/// sizes of cracks have changed since `check`, as in growth.
/// @throws InputError  as `check`, if the drive breaks no other rule
void check_crack_rules(const GearSet& gear);

/// Whether a number of a drive has a value that its field allows, as `check` demands.
[[nodiscard]] bool in_range(const Field& field, double value);

}  // namespace strainwave
