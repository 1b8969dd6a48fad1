// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// The output of a result that a path such as "cracked.positive.stiffness" names; absent if the
/// result lacks it.
[[nodiscard]] std::optional<Quantity> output_named(const StiffnessResult& result,
                                                   std::string_view path);

/// Throws an InputError that an output does not exist; the message names near outputs.
/// @param result  its outputs are the known ones
/// @param path    the name that none of them has
/// @param option  option that names the output, for the message
[[noreturn]] void refuse_output(const StiffnessResult& result, std::string_view path,
                                std::string_view option);

}  // namespace strainwave
