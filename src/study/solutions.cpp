// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/solutions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strainwave/core/error.hpp"
#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/model/input/vary_option.hpp"

namespace strainwave {

namespace sif {

ResultEvidence evidence_of(const Evaluation& evaluation) {
  ResultEvidence evidence;
  if (!evaluation.converged)
    evidence.unusable_because = "the integral of the added compliance has not converged";
  for (const ValidityLimit& limit : evaluation.validity)
    if (!limit.inside)
      evidence.notes.push_back(
          {.code = "sif.extrapolated",
           .text = "outside " + std::string(limit.text) + ": extrapolated, accuracy unknown",
           .path = {},
           .equation = std::string(evaluation.info.equation),
           .severity = Severity::care,
           .next_step = "Use a solution whose range contains this crack."});
  if (evaluation.utilisation && *evaluation.utilisation >= 1)
    evidence.notes.push_back({.code = "sif.fractures",
                              .text = "the stress intensity reaches the fracture toughness",
                              .path = {},
                              .equation = "FR-20",
                              .severity = Severity::critical,
                              .next_step = "Lower the load or choose a tougher material."});
  evidence.equations.emplace_back(evaluation.info.equation);
  for (const ModeAccuracy& accuracy : mode_accuracies(evaluation))
    evidence.accuracies.push_back(
        {.path = accuracy.of == "K" ? std::string(evaluation.info.name)
                                    : fmt::format("{} {}", evaluation.info.name, accuracy.of),
         .relative_uncertainty = accuracy.relative_uncertainty,
         .source = std::string(evaluation.info.accuracy)});
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

}  // namespace sif

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
                     fmt::format("{} must be one of {}", shown(family), fmt::join(families, ", ")));
  }
  return list;
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
                       fmt::format("is not a field or load of {}; {}", row.info.name,
                                   near.empty() ? fmt::format("it has {}", fmt::join(known, ", "))
                                                : fmt::format("do you mean {}?", near)));
    }
    const std::string_view unit = field != row.fields.end() ? field->unit : load->unit;
    if (!values.emplace(name, parse_quantity(name, parsed.value, unit)).second)
      throw InputError(fmt::format("--set {}", name), "is given twice");
  }
  return values;
}

}  // namespace strainwave
