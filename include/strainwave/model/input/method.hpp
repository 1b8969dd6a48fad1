// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "strainwave/core/fields.hpp"

namespace strainwave {

/// The three methods; the theory manual compares them.
enum class Method {
  as_printed,  ///< every equation of the article, misprints included, in N and mm
  repaired,    ///< the article's models with their plain errors corrected
  corrected,   ///< the corrected theory
};
template <>
struct EnumNames<Method> {
  static constexpr std::array<std::string_view, 3> names = {"as-printed", "repaired", "corrected"};
};

}  // namespace strainwave
