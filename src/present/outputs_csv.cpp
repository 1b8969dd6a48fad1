// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/outputs_csv.hpp"

#include <fmt/format.h>

namespace strainwave {

std::string outputs_csv_line(const std::string& path, const Quantity& q) {
  return fmt::format("{},{},{},{}\n", path, q.value, q.unit,
                     q.relative_uncertainty ? fmt::format("{}", *q.relative_uncertainty) : "");
}

}  // namespace strainwave
