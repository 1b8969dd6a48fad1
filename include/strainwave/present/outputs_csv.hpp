// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "strainwave/model/result/result_fields.hpp"

namespace strainwave {

/// One line of the table of outputs: path, value, unit, relative_uncertainty.
[[nodiscard]] std::string outputs_csv_line(const std::string& path, const Quantity& quantity);

/// All outputs of a described result as CSV, one line each.
template <Described Result>
[[nodiscard]] std::string outputs_csv(const Result& result) {
  std::string csv = "path,value,unit,relative_uncertainty\n";
  for_each_quantity(result, [&](const std::string& path, const Quantity& quantity) {
    csv += outputs_csv_line(path, quantity);
  });
  return csv;
}

}  // namespace strainwave
