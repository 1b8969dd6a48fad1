// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/model/input/vary_option.hpp"
#include "strainwave/study/outputs.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kOption = "requirements";

Requirement parse_requirement(const StiffnessResult& result, std::string_view text) {
  const std::size_t at = text.find_first_of("<>");
  if (at == std::string_view::npos)
    throw InputError(kOption, fmt::format("{} must be OUTPUT OP VALUE with OP one of >=, >, <=, <, "
                                          "such as cracked.positive.stiffness >= 2e4 N*m/rad",
                                          shown(text)));
  const std::size_t length = text.substr(at + 1).starts_with('=') ? 2 : 1;
  const std::string_view output = without_blanks(text.substr(0, at));
  const std::optional<Quantity> present = output_named(result, output);
  if (!present) refuse_output(result, output, kOption);
  return {.output = std::string(output),
          .comparison = enum_value<Comparison>(text.substr(at, length)).value(),
          .bound = parse_quantity(output, without_blanks(text.substr(at + length)), present->unit),
          .unit = present->unit};
}

bool keeps(Comparison comparison, double value, double bound) {
  switch (comparison) {
    case Comparison::at_least:
      return value >= bound;
    case Comparison::more_than:
      return value > bound;
    case Comparison::at_most:
      return value <= bound;
    case Comparison::less_than:
      break;
  }
  return value < bound;
}

RequirementAnswer answer_of(Requirement requirement, const Quantity& value, double coverage) {
  RequirementAnswer answer{
      .requirement = std::move(requirement), .value = value, .low = {}, .high = {}};
  if (!value.relative_uncertainty || !std::isfinite(value.value)) return answer;
  const double u = coverage * *value.relative_uncertainty * std::abs(value.value);
  answer.low = value.value - u;
  answer.high = value.value + u;
  const auto& [output, comparison, bound, unit] = answer.requirement;
  const bool low = keeps(comparison, *answer.low, bound);
  const bool high = keeps(comparison, *answer.high, bound);
  if (low == high) answer.outcome = low ? RequirementOutcome::met : RequirementOutcome::not_met;
  return answer;
}

std::string sentence(const RequirementAnswer& answer) {
  const auto number = [&](double value, int digits = 6) {
    return shown_quantity(value, answer.requirement.unit, digits, answer.requirement.output);
  };
  const std::string asked =
      fmt::format("{} {} {}", answer.requirement.output, enum_name(answer.requirement.comparison),
                  number(answer.requirement.bound, 9));
  const std::string between =
      answer.low ? fmt::format(", between {} and {}", number(*answer.low), number(*answer.high))
                 : std::string(", of unknown uncertainty");
  return fmt::format("{}: {}; the value is {}{}", asked, enum_name(answer.outcome),
                     number(answer.value.value), between);
}

/// Whether the uncertainty of an output contains what the sum leaves out (ST-18).
bool contains_left_out(const StiffnessResult& result, std::string_view output) {
  const auto is = [&](std::string_view ending) { return output.ends_with(ending); };
  return std::ranges::find(result.notes, "sum.left_out", &Note::code) != result.notes.end() &&
         (output.starts_with("intact.") || output.starts_with("cracked.")) &&
         (is(".stiffness") || is(".stiffness_change") || is(".wind_up") || is(".total"));
}

Note note_of(const RequirementAnswer& answer, bool left_out) {
  const bool broken = answer.outcome == RequirementOutcome::not_met;
  const bool both_sides = left_out && !broken;
  return {
      .code = broken ? "require.not_met" : "require.cannot_be_told",
      .text = sentence(answer) +
              (both_sides
                   ? "; the uncertainty contains the effects that the sum of the members leaves "
                     "out, equally to both sides, although these effects only make the drive softer"
                   : ""),
      .path = {},
      .equation = both_sides ? "ST-18" : "ST-16",
      .severity = broken ? Severity::critical : Severity::cannot_tell,
      .next_step = broken ? "Change the drive or the requirement."
                          : "Give the value that the accuracies name as the largest "
                            "uncertainty, or measure the output."};
}

}  // namespace

RequirementReport require_outputs(const StiffnessResult& result,
                                  const std::vector<std::string>& texts, double coverage) {
  require(coverage > 0, "coverage", coverage, "1", "> 0");
  if (texts.empty()) throw InputError(kOption, "must contain at least one requirement");
  RequirementReport report{.method = result.method,
                           .coverage = coverage,
                           .answers = {},
                           .outcome = RequirementOutcome::met,
                           .notes = {},
                           .unusable_because = result.unusable_because};
  for (const std::string& text : texts) {
    Requirement requirement = parse_requirement(result, text);
    const Quantity value = *output_named(result, requirement.output);
    report.answers.push_back(answer_of(std::move(requirement), value, coverage));
    const RequirementAnswer& answer = report.answers.back();
    report.outcome = std::max(report.outcome, answer.outcome);
    if (answer.outcome != RequirementOutcome::met)
      report.notes.push_back(note_of(answer, contains_left_out(result, answer.requirement.output)));
  }
  return report;
}

ResultEvidence evidence_of(const RequirementReport& report) {
  ResultEvidence evidence;
  evidence.unusable_because = report.unusable_because;
  evidence.notes = report.notes;
  evidence.equations = {"ST-16"};
  evidence.requirement = report.outcome;
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

}  // namespace strainwave
