// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "strainwave/model/result/stiffness_result.hpp"

// What the JSON forms of the reports have in common.

namespace strainwave {

using Json = nlohmann::ordered_json;

/// A number and its unit.
[[nodiscard]] inline Json quantity_json(double value, std::string_view unit) {
  return {{"value", value}, {"unit", unit}};
}

/// The same with its accuracy, null where that is not stated.
[[nodiscard]] inline Json quantity_json(const Quantity& q) {
  return {
      {"value", q.value},
      {"unit", q.unit},
      {"relative_uncertainty", q.relative_uncertainty ? Json(*q.relative_uncertainty) : Json()}};
}

}  // namespace strainwave
