// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// The output of a result that a path names, such as "cracked.positive.stiffness"; absent if the
/// result has none of that name.
[[nodiscard]] std::optional<Quantity> output_named(const StiffnessResult& result,
                                                   std::string_view path);

/// Throws InputError: there is no such output; the message names near ones.
/// @param option  that names the output, for the message
[[noreturn]] void refuse_output(const StiffnessResult& result, std::string_view path,
                                std::string_view option);

}  // namespace strainwave
