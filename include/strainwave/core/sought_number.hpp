// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

#include "strainwave/core/shape.hpp"

namespace strainwave {

/// Calls `f` for the number at one path, as `walk_numbers` does for all numbers.  The walk leaves
/// out what does not lead there.
/// @param shape  of the described value
/// @param value  the value, whose shape this is
/// @param path   as FieldPath::text, such as `output_shaft.crack[0].depth`; without such a number
///               `f` is not called
/// @param f      takes the field and the number
void walk_to_number(const Shape& shape, void* value, std::string_view path,
                    const std::function<void(const Field&, double&)>& f);

}  // namespace strainwave
