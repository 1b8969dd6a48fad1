// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace strainwave {

/// A number with its unit and its accuracy.
struct Quantity {
  double value = 0.0;           ///< in `unit`
  std::string_view unit = "1";  ///< "1" for a pure number; the text must outlive the quantity
  /// One standard relative uncertainty of the model's form; absent if it cannot be stated.
  std::optional<double> relative_uncertainty = std::nullopt;

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

}  // namespace strainwave
