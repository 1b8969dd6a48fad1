// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// Form of a curve of detection over the size of a crack.
enum class DetectionForm {
  log_logistic,
  log_normal,
};
template <>
struct EnumNames<DetectionForm> {
  static constexpr std::array<std::string_view, 2> names = {"log_logistic", "log_normal"};
};

}  // namespace strainwave
