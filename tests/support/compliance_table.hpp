// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "strainwave/core/units.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "support/article_gear.hpp"

namespace strainwave::test {

/// Added compliance of an invented through crack with half length a [rad/(N*m)]: a power law with a
/// bend.
inline double made_up_compliance(double a) {
  const double x = a / (5 * units::mm);
  return 2e-10 * x * x * (1 + 0.3 * x);
}

/// An invented table over the half length, 0.1 to 40 mm by equal ratios, of the article's drive.
inline ComplianceTable made_up_table(int nodes = 12) {
  ComplianceTable table;
  table.file = "made_up.csv";
  table.kind = "through";
  TableAxis axis{.name = "half_length", .unit = "m", .logarithmic = true, .nodes = {}};
  for (int i = 0; i < nodes; ++i) {
    const double a = 0.1 * units::mm * std::pow(400.0, static_cast<double>(i) / (nodes - 1));
    axis.nodes.push_back(a);
    table.positive.values.push_back(made_up_compliance(a));
    table.negative.values.push_back(1e-6 * made_up_compliance(a));
  }
  table.axes = {axis};
  table.fixed = {
      {"angle", "rad", std::numbers::pi / 4},     {"outer_diameter", "m", 160 * units::mm},
      {"wall_thickness", "m", 2.24 * units::mm},  {"length", "m", 160 * units::mm},
      {"youngs_modulus", "Pa", 210 * units::GPa}, {"poissons_ratio", "1", 0.3}};
  table.point_error = 0.002;
  table.made_by = "a test";
  return completed(table);
}

/// The article's drive with a crack of this half length in the flexspline and the invented table.
inline GearSet tabulated_gear(double half_length = 7 * units::mm) {
  GearSet gear = article_gear();
  auto& crack = std::get<WallThroughCrack>(gear.flexspline->crack.at(0));
  crack.half_length = half_length;
  crack.compliance_table = "made_up.csv";
  gear.compliance_tables["made_up.csv"] = made_up_table();
  return gear;
}

}  // namespace strainwave::test
