// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/stress_intensity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

/// The accuracy in words: "K to 5 %", "K exact", or "K_I to 3 %, K_II and K_III to 5 %".
std::string accuracy_of(const std::vector<sif::ModeAccuracy>& accuracies) {
  std::vector<std::string> texts;
  for (const sif::ModeAccuracy& accuracy : accuracies)
    texts.push_back(
        accuracy.relative_uncertainty > 0
            ? fmt::format("{} to {}", accuracy.of, percent(accuracy.relative_uncertainty, 3))
            : fmt::format("{} exact", accuracy.of));
  return fmt::format("{}", fmt::join(texts, ", "));
}
std::string accuracy_of(const sif::SolutionInfo& info) {
  return accuracy_of(sif::mode_accuracies(info));
}

std::string load_names(const sif::Row& row) {
  std::vector<std::string_view> names;
  for (const sif::LoadInfo& load : row.loads) names.push_back(load.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Limits of the range, then rules between fields.
std::vector<std::string_view> range_and_rules(const DescribedSolution& solution) {
  std::vector<std::string_view> texts = solution.validity();
  for (const std::string_view rule : solution.rules()) texts.push_back(rule);
  return texts;
}

}  // namespace

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
  return text + fmt::format("\n{} solutions; `strainwave sif show NAME` describes one\n",
                            list.solutions.size());
}

std::string sif_list_markdown(const SolutionList& list) {
  std::string text =
      "# Stress intensity library\n\n`strainwave sif list --format markdown` writes this page. "
      "Accuracy is one standard relative\nuncertainty of K inside the range. The equations are "
      "those of the [theory manual](../theory/SP.md).\n\n";
  Table table{.head = {"name", "solution", "modes", "loads", "range", "accuracy", "evidence",
                       "basis", "equation"}};
  for (const DescribedSolution& solution : list.solutions) {
    const sif::SolutionInfo& info = solution.row->info;
    table.rows.push_back(
        {fmt::format("`{}`", info.name), cell(info.title), cell(info.modes),
         load_names(*solution.row), fmt::format("{}", fmt::join(range_and_rules(solution), "; ")),
         accuracy_of(info), cell(info.accuracy),
         fmt::format("{}: {}", enum_name(info.basis), info.source), cell(info.equation)});
  }
  return text + markdown_table(table);
}

std::string sif_solution_text(const DescribedSolution& solution) {
  const sif::Row& row = *solution.row;
  const sif::SolutionInfo& info = row.info;
  std::string text = fmt::format("{}: {}\n", info.name, info.title);
  text += fmt::format("  modes      {}\n  constraint {}\n  equation   ({}) of the theory manual\n",
                      info.modes, enum_name(info.constraint), info.equation);
  text += fmt::format("  accuracy   {}; {}\n", accuracy_of(info), info.accuracy);
  text += fmt::format("  source     {} ({})\n", info.source, enum_name(info.basis));
  text += fmt::format("  Y          K/(sigma sqrt(pi a)); sigma: {}\n", info.reference_stress);
  const auto names = [&](const char* heading, const auto& list, const auto& row_of) {
    Table table{.head = {"", "", ""}, .align = "lrl"};
    for (const auto& one : list) table.rows.push_back(row_of(one));
    text += heading + text_table(table);
  };
  names("\nFields, with the values used if left out\n", row.fields, [](const Field& field) {
    std::string example(field.example);
    std::erase(example, '"');
    return cells(field.name, example,
                 fmt::format("{}; {}", field.doc, rule_text(field.range, field.unit)));
  });
  names("Loads\n", row.loads,
        [](const sif::LoadInfo& load) { return cells(load.name, load.unit, load.doc); });
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
  Table inputs{.head = {"", "", ""}, .align = "lrl"};
  const auto add = [&](const std::vector<sif::Input>& list, const char* missing) {
    for (const sif::Input& input : list)
      inputs.rows.push_back({std::string(input.name),
                             shown_quantity(input.value, input.unit, 5, input.name),
                             input.given ? "" : missing});
  };
  add(e.fields, "default, not given");
  add(e.loads, "not given");
  text += text_table(inputs);
  const auto number = [](double value) { return fmt::format("{:.5g}", value); };
  text += fmt::format("\nGeometry factors Y = K/(sigma sqrt(pi a)), a = {}\nsigma: {}\n",
                      shown_quantity(e.crack_size, "m"), e.info.reference_stress);
  Table factors{.head = {"load", "point", "I", "II", "III"}, .align = "llrrr"};
  for (const sif::GeometryFactors& factor : e.factors)
    factors.rows.push_back({std::string(factor.load), std::string(factor.point), number(factor.Y_I),
                            number(factor.Y_II), number(factor.Y_III)});
  text += text_table(factors);
  if (e.largest) {
    const DisplayUnit unit = display_unit({}, "Pa*m^0.5");
    text += fmt::format("\nStress intensity factors under these loads [{}]\n", unit.text);
    Table table{.head = {"", "I", "II", "III"}};
    const auto shown = [&](double K) { return number(K / unit.in_si); };
    const auto line = [&](std::string_view name, const sif::PointIntensity& K) {
      table.rows.push_back({std::string(name), shown(K.K_I), shown(K.K_II), shown(K.K_III)});
    };
    for (const sif::PointIntensity& point : e.points) line(point.name, point);
    line("largest along the front", *e.largest);
    table.rows.push_back({"sqrt(G E') at the worst point", shown(*e.equivalent)});
    if (e.utilisation)
      table.rows.push_back({"over the fracture toughness", number(*e.utilisation)});
    text += text_table(table);
    if (e.pressed)
      text += "  K_I < 0: the faces press on each other, so mode I counts as 0 (FR-17)\n";
  }
  text +=
      fmt::format("\nAdded compliance ({}, E = {}, nu = {:.3g})\n", enum_name(e.info.constraint),
                  shown_quantity(e.material.youngs_modulus, "Pa", 4), e.material.poissons_ratio);
  Table added{.head = {"", "", "", ""}, .align = "llrl"};
  for (const sif::ComplianceEntry& entry : e.compliance) {
    const DisplayUnit unit = display_unit({}, entry.unit, {entry.unit, 1.0});
    added.rows.push_back({std::string(entry.load_i), std::string(entry.load_j),
                          fmt::format("{:.6g}", entry.value / unit.in_si), std::string(unit.text)});
  }
  text += text_table(added);
  if (!e.converged)
    text +=
        fmt::format("  the integral did not converge: relative error {:.2g}\n", e.quadrature_error);
  text += fmt::format("\nAccuracy: {}; {}\nSource {} ({}); equation ({})\n",
                      accuracy_of(sif::mode_accuracies(e)), e.info.accuracy, e.info.source,
                      enum_name(e.info.basis), e.info.equation);
  return text + notes_text(evidence_of(e).notes);
}

}  // namespace strainwave
