// SPDX-License-Identifier: Apache-2.0
#include "strainwave/audit/audit.hpp"

#include "chapters.hpp"

namespace strainwave {

std::optional<double> AuditRow::ratio() const {
  const auto quotient = [](const std::optional<double>& a,
                           const std::optional<double>& b) -> std::optional<double> {
    if (!a || !b || *b == 0) return std::nullopt;
    return *a / *b;
  };
  return printed ? quotient(printed, own) : quotient(own, corrected);
}

std::vector<AuditRow> audit() {
  return joined(fracture_mechanics_rows(), wave_generator_rows(), flexspline_rows(),
                output_shaft_rows(), table_and_text_rows());
}

}  // namespace strainwave
