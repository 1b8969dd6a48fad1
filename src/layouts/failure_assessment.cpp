// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/failure_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/table.hpp"
#include "strainwave/strength/failure_assessment.hpp"

namespace strainwave {
namespace {

/// Names of the materials whose cracks can be shown, each once, in the order of the cracks.
std::vector<std::string> materials_of(const StiffnessResult& result) {
  std::vector<std::string> names;
  for (const CrackStrength& crack : result.strength) {
    const bool has_point =
        std::ranges::any_of(crack.states, [](const StrengthState& s) { return s.K_r.has_value(); });
    if (has_point && std::ranges::find(names, crack.material) == names.end())
      names.push_back(crack.material);
  }
  if (names.empty())
    throw InputError(
        "material",
        "the failure assessment diagram cannot show any crack; give fracture_toughness and "
        "yield_strength of a cracked member's material, and use the method corrected");
  return names;
}

std::vector<AssessmentPoint> line_of(const GearSet& gear, const std::string& name) {
  const Material& material = material_of(gear, name, "material");
  return assessment_table({.youngs_modulus = material.youngs_modulus.value(),
                           .yield_strength = material.yield_strength.value(),
                           .ultimate_strength = material.ultimate_strength},
                          50);
}

}  // namespace

PlotPanel failure_assessment_panel(const StiffnessResult& result, const GearSet& gear) {
  const auto load = [](double value, std::string_view si) {
    const DisplayUnit unit = display_unit({}, si);
    return fmt::format("{:g} {}", value / unit.in_si, typeset_unit(unit.text));
  };
  PlotPanel panel{
      .title =
          gear.name.empty() ? "Failure assessment diagram" : "Failure assessment: " + gear.name,
      .subtitle = fmt::format("option 1 of BS 7910; load T = {}, P = {}; beyond a line: "
                              "fracture",
                              load(gear.load.torque, "N*m"), load(gear.load.axial_force, "N")),
      .x_label = "L_r, reference stress over yield strength",
      .y_label = "K_r, stress intensity over toughness"};
  for (const std::string& name : materials_of(result)) {
    PlotSeries series{.label = "line, " + name};
    for (const AssessmentPoint& point : line_of(gear, name)) {
      series.x.push_back(point.L_r);
      series.y.push_back(point.K_r);
    }
    panel.series.push_back(std::move(series));
  }
  for (const CrackStrength& crack : result.strength)
    for (const StrengthState& state : crack.states) {
      if (!state.K_r || !state.L_r) continue;
      // With the assembly, the path begins on the axis at the K of the assembly alone.  It is
      // straight except for the interaction V.
      const double start = state.with_assembly ? state.K_assembly / *crack.toughness : 0.0;
      const bool reversed = state.sense != crack.states.front().sense;
      panel.series.push_back(
          {.label = crack.path + (state.with_assembly ? " +" : "") + (reversed ? ", reversed" : ""),
           .x = {0.0, *state.L_r},
           .y = {start, *state.K_r},
           .discs = Discs::at_end});
    }
  panel.legend_title = "+ with the assembly";
  return panel;
}

std::string failure_assessment_plot(const StiffnessResult& result, const GearSet& gear) {
  return svg_plot(std::array{failure_assessment_panel(result, gear)});
}

std::string failure_assessment_csv(const StiffnessResult& result, const GearSet& gear) {
  Table table{.head = {"what", "name", "torque", "with_assembly", "L_r", "K_r", "limit", "reserve",
                       "verdict"}};
  for (const std::string& name : materials_of(result))
    for (const AssessmentPoint& point : line_of(gear, name))
      table.rows.push_back({"line", name, "", "", fmt::format("{:.6g}", point.L_r),
                            fmt::format("{:.6g}", point.K_r)});
  for (const CrackStrength& crack : result.strength)
    for (const StrengthState& state : crack.states)
      if (state.K_r)
        table.rows.push_back(cells("crack", crack.path, state.sense, state.with_assembly ? 1 : 0,
                                   state.L_r, state.K_r, state.line, state.reserve, state.verdict));
  return csv_table(table);
}

}  // namespace strainwave
