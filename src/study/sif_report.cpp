// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/sif_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "display_unit.hpp"
#include "report_cells.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/model/input/vary_option.hpp"
#include "strainwave/study/plot.hpp"

namespace strainwave {

namespace {

using std::numbers::pi;

struct Mode {
  std::string_view name;
  double sif::GeometryFactors::*Y;
  double sif::PointIntensity::*K;
};
constexpr std::array<Mode, 3> kModes = {
    {{"I", &sif::GeometryFactors::Y_I, &sif::PointIntensity::K_I},
     {"II", &sif::GeometryFactors::Y_II, &sif::PointIntensity::K_II},
     {"III", &sif::GeometryFactors::Y_III, &sif::PointIntensity::K_III}}};

/// "K to 5 %", or "K exact".
std::string accuracy_of(const sif::SolutionInfo& info) {
  return info.relative_uncertainty > 0 ? "K to " + percent(info.relative_uncertainty) : "K exact";
}

/// "2 mm", in the unit that engineers read.
std::string shown_quantity(double value, std::string_view name, std::string_view unit) {
  const DisplayUnit display = display_unit(name, unit);
  return display.text == "1" ? fmt::format("{:.5g}", value)
                             : fmt::format("{:.5g} {}", value / display.in_si, display.text);
}

std::string load_names(const sif::Row& row) {
  std::vector<std::string_view> names;
  for (const sif::LoadInfo& load : row.loads) names.push_back(load.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Limits, then rules.
std::vector<std::string_view> range_and_rules(const DescribedSolution& solution) {
  std::vector<std::string_view> texts = solution.validity();
  for (const std::string_view rule : solution.rules()) texts.push_back(rule);
  return texts;
}

std::string table_cell(std::string_view text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
  return cell;
}

}  // namespace

std::vector<SolutionField> DescribedSolution::fields() const {
  std::vector<SolutionField> fields;
  for (const Field& field : row->fields)
    fields.push_back(
        {field.name, field.unit, field.doc, rule_text(field.range, field.unit), field.example});
  return fields;
}

std::vector<std::string_view> DescribedSolution::validity() const {
  std::vector<std::string_view> texts;
  for (const sif::ValidityLimit& limit : row->make({})->validity()) texts.push_back(limit.text);
  return texts;
}

std::vector<std::string_view> DescribedSolution::rules() const { return row->make({})->rules(); }

SolutionList sif_list(std::string_view family) {
  SolutionList list;
  std::vector<std::string> families;
  for (const sif::Row& row : sif::library()) {
    if (family.empty() || row.info.family == family) list.solutions.push_back({&row});
    families.emplace_back(row.info.family);
  }
  if (list.solutions.empty()) {
    families.erase(std::unique(families.begin(), families.end()), families.end());
    throw InputError("family",
                     fmt::format("{} is none of {}", shown(family), fmt::join(families, ", ")));
  }
  return list;
}

std::string sif_list_text(const SolutionList& list) {
  std::size_t width = 0;
  for (const auto& [row] : list.solutions) width = std::max(width, row->info.name.size());
  std::string text;
  std::string_view heading;
  for (const auto& [row] : list.solutions) {
    const sif::SolutionInfo& info = row->info;
    if (info.family != heading) {
      heading = info.family;
      text += fmt::format("{}{}\n", text.empty() ? "" : "\n", heading);
    }
    text += fmt::format("  {:{}}  {}\n  {:{}}  modes {}; loads {}; {}\n", info.name, width,
                        info.title, "", width, info.modes, load_names(*row), accuracy_of(info));
  }
  return text + fmt::format("\n{} solutions; `strainwave sif show NAME` says more\n",
                            list.solutions.size());
}

std::string sif_list_markdown(const SolutionList& list) {
  std::string text =
      "# Stress intensity library\n\nMade by `strainwave sif list --format markdown`. Accuracy is "
      "one standard relative uncertainty of K inside\nthe range; equations are those of the "
      "[theory manual](../theory/SP.md).\n\n"
      "| name | solution | modes | loads | range | accuracy | evidence | basis | equation |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  for (const DescribedSolution& solution : list.solutions) {
    const sif::Row* const row = solution.row;
    const sif::SolutionInfo& info = row->info;
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {}: {} | {} |\n", info.name,
                        table_cell(info.title), info.modes, load_names(*row),
                        table_cell(fmt::format("{}", fmt::join(range_and_rules(solution), "; "))),
                        accuracy_of(info), table_cell(info.accuracy), enum_name(info.basis),
                        info.source, info.equation);
  }
  return text;
}

std::string sif_solution_text(const DescribedSolution& solution) {
  const sif::Row& row = *solution.row;
  const sif::SolutionInfo& info = row.info;
  std::string text = fmt::format("{}: {}\n", info.name, info.title);
  text += fmt::format("  modes      {}\n  constraint {}\n  equation   ({}) of the theory manual\n",
                      info.modes, enum_name(info.constraint), info.equation);
  text += fmt::format("  accuracy   {}; {}\n", accuracy_of(info), info.accuracy);
  text += fmt::format("  source     {} ({})\n", info.source, enum_name(info.basis));
  text += "\nFields, with the values taken when left out\n";
  for (const Field& field : row.fields) {
    std::string example(field.example);
    std::erase(example, '"');
    text += fmt::format("  {:24}{:>12}  {}; {}\n", field.name, example, field.doc,
                        rule_text(field.range, field.unit));
  }
  text += "Loads\n";
  for (const sif::LoadInfo& load : row.loads)
    text += fmt::format("  {:24}{:>12}  {}\n", load.name, load.unit, load.doc);
  text += "Points of the front\n ";
  for (const sif::FrontPoint& point : row.points) text += fmt::format(" {}", point.name);
  text += "\nValidity\n";
  for (const std::string_view limit : solution.validity()) text += fmt::format("  {}\n", limit);
  for (const std::string_view rule : solution.rules())
    text += fmt::format("  {}; refused otherwise\n", rule);
  if (range_and_rules(solution).empty()) text += "  everywhere\n";
  return text;
}

std::string sif_evaluation_text(const sif::Evaluation& e) {
  std::string text = fmt::format("{}: {}\n", e.info.name, e.info.title);
  const auto inputs = [&](const std::vector<sif::Input>& list, std::string_view missing) {
    for (const sif::Input& input : list)
      text += fmt::format("  {:24}{:>16}{}\n", input.name,
                          shown_quantity(input.value, input.name, input.unit),
                          input.given ? std::string() : fmt::format("   {}", missing));
  };
  inputs(e.fields, "taken, not given");
  inputs(e.loads, "not given");
  text += fmt::format(
      "\nGeometry factors Y = K/(sigma sqrt(pi a)), a = {}, sigma of the gross section\n",
      shown_quantity(e.crack_size, "", "m"));
  text += fmt::format("  {:20}{:16}{:>12}{:>12}{:>12}\n", "load", "point", "I", "II", "III");
  for (const sif::GeometryFactors& factor : e.factors)
    text += fmt::format("  {:20}{:16}{:>12.5g}{:>12.5g}{:>12.5g}\n", factor.load, factor.point,
                        factor.Y_I, factor.Y_II, factor.Y_III);
  if (e.largest) {
    text += "\nStress intensity factors under these loads [MPa*m^0.5]\n";
    const auto line = [&](std::string_view name, const sif::PointIntensity& K) {
      text += fmt::format("  {:36}{:>12.5g}{:>12.5g}{:>12.5g}\n", name, K.K_I / 1e6, K.K_II / 1e6,
                          K.K_III / 1e6);
    };
    for (const sif::PointIntensity& point : e.points) line(point.name, point);
    line("largest along the front", *e.largest);
    text += fmt::format("  {:36}{:>12.5g}\n", "sqrt(G E') at the worst point", *e.equivalent / 1e6);
    if (e.utilisation)
      text += fmt::format("  {:36}{:>12.5g}{}\n", "over the fracture toughness", *e.utilisation,
                          *e.utilisation >= 1 ? "   fractures at this load" : "");
    if (e.pressed)
      text += "  K_I < 0: the faces press on each other there, and mode I counts as 0 (FR-17)\n";
  }
  text += fmt::format("\nAdded compliance ({}, E = {:.4g} GPa, nu = {:.3g})\n",
                      enum_name(e.info.constraint), e.material.youngs_modulus / 1e9,
                      e.material.poissons_ratio);
  for (const sif::ComplianceEntry& entry : e.compliance)
    text += fmt::format("  {:20}{:20}{:>14.6g} {}\n", entry.load_i, entry.load_j, entry.value,
                        entry.unit);
  if (!e.converged)
    text += fmt::format("  not converged: relative error {:.2g}\n", e.quadrature_error);
  text += fmt::format("\nAccuracy: {}; {}\nSource {} ({}); equation ({})\n", accuracy_of(e.info),
                      e.info.accuracy, e.info.source, enum_name(e.info.basis), e.info.equation);
  for (const sif::ValidityLimit& limit : e.validity)
    if (!limit.inside)
      text += fmt::format("outside {}: extrapolated, accuracy unknown\n", limit.text);
  return text;
}

sif::Assignments sif_assignments(const sif::Row& row, std::span<const std::string> texts) {
  sif::Assignments values;
  std::vector<std::string> known;
  for (const Field& field : row.fields) known.emplace_back(field.name);
  for (const sif::LoadInfo& load : row.loads) known.emplace_back(load.name);
  for (const std::string& text : texts) {
    const Assignment parsed = assignment(text);
    const std::string name(parsed.key);
    if (!parsed.has_value)
      throw InputError("--set", fmt::format("{} is not NAME=VALUE", shown(text)));
    const auto field = std::ranges::find(row.fields, name, &Field::name);
    const auto load = std::ranges::find(row.loads, name, &sif::LoadInfo::name);
    if (field == row.fields.end() && load == row.loads.end()) {
      const std::string near = nearest_word(name, known);
      throw InputError(fmt::format("--set {}", shown(name)),
                       fmt::format("is no field or load of {}; {}", row.info.name,
                                   near.empty() ? fmt::format("it has {}", fmt::join(known, ", "))
                                                : fmt::format("do you mean {}?", near)));
    }
    const std::string_view unit = field != row.fields.end() ? field->unit : load->unit;
    if (!values.emplace(name, parse_quantity(name, parsed.value, unit)).second)
      throw InputError(fmt::format("--set {}", name), "is given twice");
  }
  return values;
}

std::string sif_plot(const sif::Row& row, const sif::Assignments& values) {
  // Through `evaluate`, so that the plot refuses what the numbers refuse.
  const sif::Evaluation evaluation = sif::evaluate(row, values);
  sif::Assignments fields;
  for (const sif::Input& field : evaluation.fields) fields.emplace(field.name, field.value);
  const auto crack = row.make(fields);
  const FrontRange front = crack->front();
  const double size = crack->size();
  const auto factor = [&](std::size_t load, double a, double s, const Mode& mode) {
    return crack->unit_intensity(load, a, s).*mode.K /
           (crack->gross_stress(load) * std::sqrt(pi * a));
  };

  constexpr int kSteps = 120;
  std::vector<PlotPanel> panels;
  for (const Mode& mode : kModes) {
    PlotPanel over_size{.title = fmt::format("Mode {}, over the crack size", mode.name),
                        .x_label = "a [mm]",
                        .y_label = fmt::format("K_{}/(σ √(πa))", mode.name)};
    PlotPanel along_front{.title = fmt::format("Mode {}, along the front at a = {}", mode.name,
                                               shown_quantity(size, "", "m")),
                          .x_label = "front parameter s",
                          .y_label = over_size.y_label};
    if (panels.empty()) over_size.subtitle = std::string(row.info.title);
    for (std::size_t load = 0; load < row.loads.size(); ++load) {
      for (const sif::FrontPoint& point : row.points) {
        PlotSeries line{.label = row.points.size() > 1
                                     ? fmt::format("{}, {}", row.loads[load].name, point.name)
                                     : std::string(row.loads[load].name)};
        for (int i = 1; i <= kSteps; ++i) {
          const double a = size * i / kSteps;
          line.x.push_back(a * 1e3);
          line.y.push_back(factor(load, a, point.s, mode));
        }
        if (std::ranges::any_of(line.y, [](double y) { return y != 0; }))
          over_size.series.push_back(std::move(line));
      }
      if (front.begin == front.end) continue;
      PlotSeries line{.label = std::string(row.loads[load].name)};
      for (int i = 0; i <= kSteps; ++i) {
        line.x.push_back(front.begin + (front.end - front.begin) * i / kSteps);
        line.y.push_back(factor(load, size, line.x.back(), mode));
      }
      if (std::ranges::any_of(line.y, [](double y) { return y != 0; }))
        along_front.series.push_back(std::move(line));
    }
    if (!over_size.series.empty()) panels.push_back(std::move(over_size));
    if (!along_front.series.empty()) panels.push_back(std::move(along_front));
  }
  return svg_plot(panels);
}

}  // namespace strainwave
