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

}  // namespace

Requirement parse_requirement(const StiffnessResult& result, std::string_view text,
                              std::string_view option) {
  const std::size_t at = text.find_first_of("<>");
  if (at == std::string_view::npos)
    throw InputError(
        option, fmt::format("{} is {}; write OUTPUT OP VALUE with OP one of >=, >, <=, <, such as "
                            "curve.positive.K2 >= 4e4 N*m/rad",
                            shown(text),
                            option == kOption ? "neither a requirement nor an existing file"
                                              : "not a requirement"));
  const std::size_t length = text.substr(at + 1).starts_with('=') ? 2 : 1;
  const std::string_view output = without_blanks(text.substr(0, at));
  const std::optional<Quantity> present = output_named(result, output);
  if (!present) refuse_output(result, output, option);
  return {.output = std::string(output),
          .comparison = enum_value<Comparison>(text.substr(at, length)).value(),
          .bound = parse_quantity(output, without_blanks(text.substr(at + length)), present->unit),
          .unit = present->unit};
}

namespace {

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

/// One standard uncertainty of an output below and above its value [unit of the output].
struct Uncertainty {
  double below = 0.0;
  double above = 0.0;
};

/// Whether the drive is known to be softer than the sum, apart from the errors of the members
/// (ST-18). The stiffnesses of the coupled drive decide.  If it is not solved, catalogues show that
/// the drive is softer.
bool is_softer(const Quantity& stiffness, const CurveStiffness* coupled) {
  return coupled == nullptr ||
         (std::max({coupled->K1.value, coupled->K2.value, coupled->K3.value}) <= stiffness.value);
}

/// The side of an output of the sum on which the same output of the drive lies.
enum class Side { below, above, either };

struct SumOutput {
  Side softer = Side::either;
  double of_members = 0.0;    ///< relative uncertainty by the members alone [-]
  std::string of_drive = {};  ///< an output of the coupled drive to require instead of a change
};

std::optional<SumOutput> sum_output(const StiffnessResult& result, std::string_view output) {
  if (!result.members_alone) return std::nullopt;
  const auto of = [&](std::string_view drive, const auto& sum, double members_alone,
                      const CurveStiffness* coupled) -> std::optional<SumOutput> {
    if (!output.starts_with(drive)) return std::nullopt;
    const std::string_view name = output.substr(drive.size());
    if (name == "stiffness_change")
      return SumOutput{.of_drive = fmt::format("curve{}change.K1", drive.substr(drive.find('.')))};
    if (name != "stiffness" && name != "wind_up" && name != "compliance.total") return std::nullopt;
    if (!is_softer(sum.stiffness, coupled)) return SumOutput{};
    return SumOutput{.softer = name == "stiffness" ? Side::below : Side::above,
                     .of_members = members_alone};
  };
  const auto& curve = result.curve;
  const MemberUncertainty& alone = *result.members_alone;
  if (auto found = of("intact.", result.intact, alone.intact, curve ? &curve->intact : nullptr))
    return found;
  if (auto found = of("cracked.positive.", result.positive, alone.positive,
                      curve ? &curve->positive : nullptr))
    return found;
  return of("cracked.negative.", result.negative, alone.negative,
            curve ? &curve->negative : nullptr);
}

Uncertainty uncertainty_of(const Quantity& value, const std::optional<SumOutput>& sum) {
  const double size = std::abs(value.value);
  const double both = *value.relative_uncertainty * size;
  if (!sum || sum->softer == Side::either) return {.below = both, .above = both};
  const double members = sum->of_members * size;
  return sum->softer == Side::below ? Uncertainty{both, members}   // (ST-18)
                                    : Uncertainty{members, both};  // (ST-18)
}

RequirementAnswer answer_of(Requirement requirement, const Quantity& value,
                            const std::optional<SumOutput>& sum, double coverage) {
  RequirementAnswer answer{
      .requirement = std::move(requirement), .value = value, .low = {}, .high = {}};
  if (!std::isfinite(value.value)) return answer;
  const auto& [output, comparison, bound, unit] = answer.requirement;
  if (!value.relative_uncertainty) {
    if (sum) return answer;  // the drive changes, but the sum does not (ST-18)
    answer.outcome = keeps(comparison, value.value, bound) ? RequirementOutcome::met
                                                           : RequirementOutcome::not_met;
    return answer;
  }
  const Uncertainty u = uncertainty_of(value, sum);
  answer.low = value.value - coverage * u.below;
  answer.high = value.value + coverage * u.above;
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
  const bool decided = answer.outcome != RequirementOutcome::cannot_be_told;
  const std::string between =
      answer.low ? fmt::format(", between {} and {}", number(*answer.low), number(*answer.high))
      : decided  ? "; no uncertainty of this output is stated, so its value alone decides"
      : std::isfinite(answer.value.value)
          ? "; no uncertainty of this output can contain the change of the coupled drive"
          : "";
  return fmt::format("{}: {}; the value is {}{}", asked, enum_name(answer.outcome),
                     number(answer.value.value), between);
}

/// What the interval of a sum contains, in words; empty for any other output.
std::string interval_words(const std::optional<SumOutput>& sum) {
  if (!sum) return "";
  return sum->softer == Side::either
             ? "; the uncertainty contains the effects that the sum of the members leaves out, on "
               "both sides"
             : "; the sum of the members leaves out contacts and rings, which only make the drive "
               "softer, so the uncertainty contains their effect on the softer side only";
}

/// What to do about a requirement whose bound lies within the uncertainty, or whose output has no
/// interval.  The accuracy of the coupled drive is that of its model, which no other value of the
/// file improves.
std::string next_step_of(const RequirementAnswer& answer, const std::optional<SumOutput>& sum) {
  if (!answer.low && sum) return fmt::format("Require {} instead.", sum->of_drive);
  return answer.requirement.output.starts_with("curve.")
             ? "Calibrate the drive with a measured curve (strainwave calibrate), or measure the "
               "output."
             : "Give the value that the accuracies name as the largest uncertainty, or measure the "
               "output.";
}

/// The note on an answer.  There is none if the requirement is met beyond the uncertainty.
std::optional<Note> note_of(const RequirementAnswer& answer, const std::optional<SumOutput>& sum) {
  const bool stated = answer.low.has_value();
  const std::string text = sentence(answer) + (stated ? interval_words(sum) : "");
  const std::string equation = sum ? "ST-18" : stated ? "ST-16" : "";
  switch (answer.outcome) {
    case RequirementOutcome::not_met:
      return Note{.code = "require.not_met",
                  .text = text,
                  .path = {},
                  .equation = equation,
                  .severity = Severity::critical,
                  .next_step = "Change the drive or the requirement."};
    case RequirementOutcome::cannot_be_told:
      return Note{.code = "require.cannot_be_told",
                  .text = text,
                  .path = {},
                  .equation = equation,
                  .severity = Severity::cannot_tell,
                  .next_step = next_step_of(answer, sum)};
    case RequirementOutcome::met:
      break;
  }
  if (stated) return std::nullopt;
  return Note{.code = "require.by_value",
              .text = text,
              .path = {},
              .equation = "",
              .severity = Severity::care,
              .next_step = "Keep a margin to the bound."};
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
    Requirement requirement = parse_requirement(result, text, kOption);
    const Quantity value = *output_named(result, requirement.output);
    const std::optional<SumOutput> sum = sum_output(result, requirement.output);
    report.answers.push_back(answer_of(std::move(requirement), value, sum, coverage));
    const RequirementAnswer& answer = report.answers.back();
    report.outcome = std::max(report.outcome, answer.outcome);
    if (auto note = note_of(answer, sum)) report.notes.push_back(std::move(*note));
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
