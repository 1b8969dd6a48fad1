// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/reliability.hpp"

#include <fmt/format.h>

#include "strainwave/core/shown_text.hpp"
#include "strainwave/layouts/words.hpp"
#include "strainwave/present/evidence_text.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

std::string probability_text(double probability) { return fmt::format("{:.3g}", probability); }

std::string interval_text(double low, double high) {
  return fmt::format("{} to {}", probability_text(low), probability_text(high));
}

std::vector<std::string> draws_row(std::string road, const DrawnReliability& drawn) {
  return {std::move(road), probability_text(drawn.probability),
          interval_text(drawn.low, drawn.high),
          fmt::format("{} of {} draws fail", drawn.failures, drawn.draws)};
}

Table roads_of(const RequirementReliability& answer) {
  Table table{.head = {"road", "probability", "95 % interval", "evidence"}, .align = "lrrl"};
  const FirstOrderReliability& first = answer.first_order;
  table.rows.push_back(first.converged
                           ? cells("first order (UQ-4)", probability_text(first.probability), "",
                                   fmt::format("beta = {:.4g}", first.reliability_index))
                           : cells("first order (UQ-4)", "none", "", first.reason));
  if (const auto& second = answer.second_order)
    table.rows.push_back(second->probability
                             ? cells("second order (UQ-5)", probability_text(*second->probability))
                             : cells("second order (UQ-5)", "none", "", second->reason));
  if (answer.importance_sampling)
    table.rows.push_back(draws_row("importance sampling (UQ-7)", *answer.importance_sampling));
  table.rows.push_back(draws_row("plain Monte Carlo (UQ-6)", answer.monte_carlo));
  return table;
}

Table design_point_of(const FirstOrderReliability& first) {
  Table table{.head = {"input", "in the file", "at the design point", "deviations", "importance"}};
  for (const DesignPointInput& input : first.inputs)
    table.rows.push_back(cells(input.path, shown_quantity(input.value, input.unit, 5, input.path),
                               shown_quantity(input.at_design, input.unit, 5, input.path),
                               fmt::format("{:+.3f}", input.deviations),
                               fmt::format("{:.1f} %", 100 * input.importance)));
  return table;
}

std::string answer_sentence(const RequirementReliability& answer) {
  switch (answer.trusted) {
    case ReliabilityRoad::none:
      break;
    case ReliabilityRoad::monte_carlo:
    case ReliabilityRoad::importance_sampling:
      return fmt::format(
          "The probability that a drive does not meet it is {}, between {} and {} with 95 % "
          "confidence, by {}.",
          probability_text(*answer.probability), probability_text(answer.low),
          probability_text(answer.high),
          answer.trusted == ReliabilityRoad::monte_carlo ? "plain Monte Carlo"
                                                         : "importance sampling");
  }
  return fmt::format(
      "The probability that a drive does not meet it cannot be told; it is between {} and {} with "
      "95 % confidence.",
      probability_text(answer.low), probability_text(answer.high));
}

}  // namespace

std::string reliability_text(const ReliabilityReport& report, const GearSet& gear) {
  std::string text = name_of(gear) + "\nProbability that scatter breaks a requirement\n";
  for (const RequirementReliability& answer : report.answers) {
    const Requirement& asked = answer.requirement;
    text += fmt::format("\n{} {} {}\n", asked.output, enum_name(asked.comparison),
                        shown_quantity(asked.bound, asked.unit, 9, asked.output));
    text += paragraph(fmt::format("The drive of the file has {}. {}",
                                  shown_quantity(answer.value.value, asked.unit, 6, asked.output),
                                  answer_sentence(answer)));
    std::vector<TitledTable> tables = {{"Roads to the probability", roads_of(answer)}};
    if (answer.first_order.converged)
      tables.push_back({fmt::format("Design point: the most likely inputs at which the requirement "
                                    "{}",
                                    answer.first_order.reliability_index < 0 ? "is met" : "fails"),
                        design_point_of(answer.first_order)});
    text += text_tables(tables);
  }
  return text + fmt::format("\nSeed {}\n\nNotes\n", report.seed) +
         notes_text(evidence_of(report).notes);
}

}  // namespace strainwave
