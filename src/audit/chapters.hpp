// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "strainwave/audit/audit.hpp"
#include "strainwave/core/roots.hpp"
#include "worked_example.hpp"

namespace strainwave {

using Rows = std::vector<AuditRow>;

// The chapters of the audit in their order.
[[nodiscard]] Rows fracture_mechanics_rows();
[[nodiscard]] Rows wave_generator_rows();
[[nodiscard]] Rows flexspline_rows();
[[nodiscard]] Rows output_shaft_rows();
[[nodiscard]] Rows table_and_text_rows();

inline constexpr const char* kCompliance = "rad/(N*mm)";

/// The rows of all parts in their order.
template <class... Parts>
[[nodiscard]] Rows joined(Parts&&... parts) {
  Rows rows;
  (rows.insert(rows.end(), std::make_move_iterator(parts.begin()),
               std::make_move_iterator(parts.end())),
   ...);
  return rows;
}

/// Exponents of force and length in the value of an equation.
struct Exponents {
  double force = 0.0;
  double length = 0.0;
};

/// Finds the exponents by evaluating the equation in units of force, then of length, that are ten
/// times smaller.
template <class Equation>
Exponents exponents_of(const Equation& equation) {
  const Printed p;
  const double plain = equation(p);
  return {std::log10(equation(p.in_smaller_units(10, 1)) / plain),
          std::log10(equation(p.in_smaller_units(1, 10)) / plain)};
}

inline std::string dimension_text(const Exponents& e) {
  return fmt::format("force^{:.0f} length^{:.0f}", std::round(e.force) + 0.0,
                     std::round(e.length) + 0.0);
}

/// The value of one input at which an equation gives `wanted`.
template <class Equation>
ReproducingInput reproducing(std::string name, std::string unit, double wanted, double lower,
                             double upper, const Equation& equation) {
  return {std::move(name),
          bracketed_root([&](double x) { return equation(x) - wanted; }, lower, upper),
          std::move(unit)};
}

}  // namespace strainwave
