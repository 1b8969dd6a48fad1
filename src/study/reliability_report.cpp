// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/reliability_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>

#include "drawn_outputs.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/study/outputs.hpp"
#include "strainwave/uncertainty/design_point.hpp"
#include "strainwave/uncertainty/failure_centre.hpp"
#include "strainwave/uncertainty/sampled_probability.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kRequireOption = "require";
constexpr int kDraws = 200'000;
constexpr int kMarginDraws = 20'000;  // of strength margins, tens of microseconds each
constexpr int kSlowDraws = 2'000;     // of the coupled drive, some milliseconds each
/// Failures among the plain draws for a relative standard error of 10 %.
constexpr int kEnough = 100;
/// Draws of a round of the search for further causes: at least these, and so many for each input.
constexpr std::size_t kCauseDraws = 200;
constexpr std::size_t kCauseDrawsPerInput = 50;

/// The margin of a requirement over independent standard normal variables, for one thread.
class Margin {
 public:
  Margin(const DrawnOutputs& outputs, const Requirement& requirement)
      : evaluate_(std::make_shared<DrawnOutputs::Evaluator>(outputs)),
        sign_(requirement.comparison == Comparison::at_least ||
                      requirement.comparison == Comparison::more_than
                  ? 1.0
                  : -1.0),
        strict_(requirement.comparison == Comparison::more_than ||
                requirement.comparison == Comparison::less_than),
        bound_(requirement.bound),
        scale_(std::max({std::abs(requirement.bound), std::abs(outputs.at_file()[0].value),
                         std::numeric_limits<double>::min()})) {}

  std::optional<double> operator()(std::span<const double> u) const {
    double output = 0.0;
    if ((*evaluate_)(u, {&output, 1}) != Fate::evaluated || !std::isfinite(output))
      return std::nullopt;
    // A strict requirement is broken on its bound, such as a change of 0 against "< 0".
    if (strict_ && output == bound_) return -std::numeric_limits<double>::min();
    return sign_ * (output - bound_) / scale_;
  }

 private:
  std::shared_ptr<DrawnOutputs::Evaluator> evaluate_;
  double sign_;
  bool strict_;
  double bound_;
  double scale_;
};

DrawnReliability drawn(const SampledProbability& sampled) {
  return {.draws = static_cast<int>(sampled.draws),
          .failures = static_cast<int>(sampled.failures),
          .without_value = static_cast<int>(sampled.without_value),
          .probability = sampled.probability,
          .standard_error = sampled.standard_error,
          .low = sampled.low,
          .high = sampled.high};
}

FirstOrderReliability first_order(const GearSet& gear, const DrawnOutputs& outputs,
                                  const DesignPoint& point) {
  FirstOrderReliability result{.converged = point.converged,
                               .reliability_index = point.reliability_index,
                               .probability = point.converged ? point.probability() : 0.0,
                               .iterations = point.iterations,
                               .reason = point.reason,
                               .inputs = {}};
  if (!point.converged) return result;
  std::vector<double> values(point.place.size());
  outputs.to_values(point.place, values);
  std::vector<double> z = point.place;
  outputs.normals().correlate(z);
  const std::vector<double> importance =
      outputs.normals().shares(outputs.normals().slope_in_z(point.normal));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const NumberAt number = number_at(gear, gear.scatter[i].path);
    result.inputs.push_back({.path = number.path,
                             .unit = number.field.unit,
                             .value = number.value,
                             .at_design = values[i],
                             .deviations = z[i],
                             .importance = importance[i]});
  }
  std::ranges::stable_sort(result.inputs, std::ranges::greater{}, &DesignPointInput::importance);
  return result;
}

/// The centres of the failures: the design point, and those that draws find elsewhere (UQ-10).
/// @param found  by the search
std::vector<std::vector<double>> all_centres(const DesignPoint& point, FailureCentres found) {
  std::vector<std::vector<double>> centres;
  if (point.converged) centres.push_back(point.place);
  for (std::vector<double>& place : found.places) {
    // The search finds the cause of the design point too, as a place nearer to the design point
    // than to the origin.
    const double along =
        point.converged ? std::inner_product(place.begin(), place.end(), point.place.begin(), 0.0)
                        : 0.0;
    const double square = point.reliability_index * point.reliability_index;
    if (!point.converged || !(along > square / 2)) centres.push_back(std::move(place));
  }
  return centres;
}

/// Whether the output has the same value at the file and in draws that move all inputs.
bool is_constant(const std::function<LimitState()>& make, std::size_t inputs,
                 const ReliabilitySettings& settings) {
  constexpr std::size_t kProbes = 200;
  const LimitState margin = make();
  std::vector<double> u(inputs, 0.0);
  const std::optional<double> at_file = margin(u);
  for (std::size_t n = 0; n < kProbes && at_file; ++n) {
    counter_normals(settings.seed, n, u);
    if (margin(u) != at_file) return false;
  }
  return at_file.has_value();
}

/// Chooses the road to trust, (UQ-6), (UQ-7).
void judge(RequirementReliability& answer) {
  constexpr double kPrecise = 0.2;  // largest relative standard error of importance sampling
  const DrawnReliability& plain = answer.monte_carlo;
  answer.low = plain.low;
  answer.high = plain.high;
  const auto& about = answer.importance_sampling;
  const bool precise =
      about && about->probability > 0 && about->standard_error <= kPrecise * about->probability;
  if (plain.failures >= kEnough) {
    answer.trusted = ReliabilityRoad::monte_carlo;
    answer.probability = plain.probability;
    return;
  }
  if (!precise || plain.low > about->high || plain.high < about->low) return;  // (UQ-7)
  answer.trusted = ReliabilityRoad::importance_sampling;
  answer.probability = about->probability;
  answer.low = about->low;
  answer.high = about->high;
}

std::string asked(const Requirement& requirement) {
  return fmt::format("{} {} {}", requirement.output, enum_name(requirement.comparison),
                     shown_quantity(requirement.bound, requirement.unit, 9, requirement.output));
}

/// What the notes need beside the answer.
struct CausesFound {
  std::size_t centres = 0;  ///< of the failures about which draws scatter
  bool constant = false;    ///< whether the output does not depend on the inputs
};

void add_notes(std::vector<Note>& notes, const RequirementReliability& answer,
               const CausesFound& findings) {
  const std::string name = asked(answer.requirement);
  const DrawnReliability& plain = answer.monte_carlo;
  const auto& about = answer.importance_sampling;
  if (findings.constant)
    notes.push_back({.code = "reliability.constant",
                     .text = fmt::format("{}: the output is the same in all draws, because it does "
                                         "not depend on the inputs that scatter",
                                         name),
                     .path = "scatter",
                     .equation = "UQ-6",
                     .severity = answer.trusted == ReliabilityRoad::none ? Severity::cannot_tell
                                                                         : Severity::care,
                     .next_step = "Let an input scatter on which the output depends, or ask for "
                                  "another output."});
  else if (answer.trusted == ReliabilityRoad::none) {
    const bool other = about && plain.low > about->high;
    notes.push_back(
        {.code = "reliability.cannot_tell",
         .text = fmt::format(
             "{}: the probability is between {:.3g} and {:.3g}; {}", name, answer.low, answer.high,
             other ? "there are failures away from the centres, which draws about these miss"
             : answer.first_order.converged ? "draws about the design point are not precise enough"
                                            : answer.first_order.reason),
         .path = "scatter",
         .equation = "UQ-6",
         .severity = Severity::cannot_tell,
         .next_step = "Take more draws with --draws."});
  } else if (answer.first_order.converged && answer.probability) {
    const double difference = answer.first_order.probability / *answer.probability - 1;
    const double error = (answer.high - answer.low) / *answer.probability;
    if (std::abs(difference) > std::max(0.2, error))
      notes.push_back(
          {.code = "reliability.curved",
           .text = fmt::format("{}: the first-order probability {:.3g} differs by {:+.0f} % from "
                               "that of the draws, because the limit is curved or failures lie "
                               "elsewhere too; use the probability of the draws",
                               name, answer.first_order.probability, 100 * difference),
           .path = "scatter",
           .equation = "UQ-4",
           .severity = Severity::information});
  }
  if (answer.trusted == ReliabilityRoad::importance_sampling)
    notes.push_back(
        {.code = "reliability.elsewhere",
         .text = fmt::format("{}: the interval is that of failures about {}. Failures by another "
                             "cause may be missing: a search by draws found none, but the {} plain "
                             "draws, of which {} fail, exclude with 97.5 % confidence only a "
                             "probability above {:.2g}",
                             name,
                             findings.centres > 1
                                 ? fmt::format("{} centres, each of a cause", findings.centres)
                                 : "the design point",
                             plain.draws, plain.failures, plain.high),
         .path = "scatter",
         .equation = "UQ-7",
         .severity = Severity::care,
         .next_step = "Take more draws with --draws if failures may have several causes."});
  if (plain.without_value > 0)
    notes.push_back(
        {.code = "reliability.no_value",
         .text = fmt::format("{}: {} of {} draws break a rule of the input, such as a crack deeper "
                             "than its wall, or are outside the validity of the model; the upper "
                             "end of the interval counts them as failures",
                             name, plain.without_value, plain.draws),
         .path = "scatter",
         .equation = "UQ-6",
         .severity = Severity::care,
         .next_step = "Use the upper end, or let the inputs scatter less."});
}

RequirementReliability reliability_of_one(const GearSet& gear, const Requirement& requirement,
                                          const ReliabilitySettings& settings,
                                          CausesFound& findings, const Progress& progress) {
  RequirementReliability answer{.requirement = requirement};
  DrawnOutputs outputs(gear, {requirement.output}, kRequireOption);
  answer.value = outputs.at_file()[0];
  const std::size_t inputs = outputs.inputs();
  const auto make = [&]() -> LimitState { return Margin(outputs, requirement); };
  // A search evaluates few drives, but each may take milliseconds, so it can be stopped.
  const auto stoppable = [&](const Progress& part) -> LimitState {
    return [&part, margin = make()](std::span<const double> z) {
      part.at(0.0);
      return margin(z);
    };
  };
  const Progress at_start = progress.part(0.0, 0.6);
  const DesignPoint from_file =
      find_design_point(stoppable(at_start), std::vector<double>(inputs, 0.0));
  // Tables answer the many draws below; the search above needs the engine's derivatives.
  const auto draws =
      static_cast<std::size_t>(settings.draws.value_or(outputs.of_sum()    ? kDraws
                                                       : outputs.planned() ? kMarginDraws
                                                                           : kSlowDraws));
  const auto fill = [&](std::size_t row, std::span<double> u) {
    counter_normals(settings.seed, row, u);
  };
  outputs.prepare(draws, fill, settings.threads, at_start);
  const SamplingOptions sampling{
      .draws = draws, .seed = settings.seed, .threads = settings.threads};
  const SampledProbability plain = plain_sampling(make, inputs, sampling, at_start);
  const Progress after_draws = progress.part(0.6, 1.0);
  DesignPoint point = from_file;
  if (!plain.nearest_failure.empty() && plain.probability < 0.5) {
    // A failure among the draws may lead to a nearer or the only design point.
    DesignPoint from_draw = find_design_point(stoppable(after_draws), plain.nearest_failure);
    if (from_draw.converged && (!point.converged || std::abs(from_draw.reliability_index) <
                                                        std::abs(point.reliability_index) - 1e-6))
      point = std::move(from_draw);
  }
  answer.first_order = first_order(gear, outputs, point);
  answer.monte_carlo = drawn(plain);
  if (point.converged) {
    CurvedLimit curved = curved_limit(stoppable(after_draws), point);
    answer.second_order = {.probability = curved.probability,
                           .curvatures = std::move(curved.curvatures),
                           .reason = std::move(curved.reason)};
  }
  std::vector<std::vector<double>> centres = all_centres(point, {});
  findings.constant = is_constant(make, inputs, settings);
  const bool rare = plain.failures < kEnough && (!point.converged || point.reliability_index > 0);
  if (rare && !findings.constant)
    centres = all_centres(
        point, find_failure_centres(make, inputs,
                                    {.draws = std::max(kCauseDraws, kCauseDrawsPerInput * inputs),
                                     .seed = splitmix64(settings.seed, 2),
                                     .threads = settings.threads},
                                    after_draws));
  findings.centres = centres.size();
  SamplingOptions about = sampling;
  about.draws = std::max<std::size_t>(draws / 4, 2);
  about.seed = splitmix64(settings.seed, 1);
  if (point.converged && centres.size() == 1)
    answer.importance_sampling = drawn(importance_sampling(make, point.place, about, after_draws));
  else if (!centres.empty())
    answer.importance_sampling = drawn(mixture_sampling(make, centres, about, after_draws));
  answer.tables = outputs.table_evidence(draws, fill);
  judge(answer);
  return answer;
}

}  // namespace

ResultEvidence evidence_of(const ReliabilityReport& report) {
  ResultEvidence evidence;
  evidence.notes = report.notes;
  for (const char* const tag : {"UQ-4", "UQ-5", "UQ-6", "UQ-7", "UQ-10", "UQ-11"})
    evidence.equations.emplace_back(tag);
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

std::vector<Requirement> requirements_on(const GearSet& gear,
                                         const std::vector<std::string>& texts) {
  if (texts.empty())
    throw InputError(kRequireOption,
                     "must be given, such as 'cracked.positive.stiffness >= 4e5 N*m/rad'");
  const bool over_turn = std::ranges::any_of(texts, [](const std::string& text) {
    return is_over_turn(text.substr(0, text.find_first_of("<> ")));
  });
  const StiffnessResult at_file = evaluate(gear, Method::corrected, {.over_turn = over_turn});
  std::vector<Requirement> requirements;
  for (const std::string& text : texts)
    requirements.push_back(parse_requirement(at_file, text, kRequireOption));
  return requirements;
}

ReliabilityReport reliability_of(const GearSet& gear, const std::vector<Requirement>& requirements,
                                 const ReliabilitySettings& settings, const Progress& progress) {
  check(gear);
  require_scatter(gear);
  if (settings.draws)
    require(*settings.draws >= 2 && *settings.draws <= kMaxReliabilityDraws, "--draws",
            *settings.draws, "1", fmt::format(">= 2 and <= {}", kMaxReliabilityDraws));
  require(settings.threads >= 0, "--threads", settings.threads, "1", ">= 0");
  ReliabilityReport report{.answers = {}, .seed = settings.seed, .notes = {}};
  const auto count = static_cast<double>(requirements.size());
  for (std::size_t n = 0; n < requirements.size(); ++n) {
    const auto before = static_cast<double>(n);
    CausesFound findings;
    report.answers.push_back(
        reliability_of_one(gear, requirements[n], settings, findings,
                           progress.part(before / count, (before + 1) / count)));
    add_notes(report.notes, report.answers.back(), findings);
    if (const auto& tables = report.answers.back().tables) {
      Note note = note_of(*tables);
      note.path = requirements[n].output;
      report.notes.push_back(std::move(note));
    }
  }
  std::vector<std::string> outputs;
  for (const Requirement& requirement : requirements) outputs.push_back(requirement.output);
  note_growth_left_out(report.notes, gear, outputs);
  report.notes.push_back(
      {.code = "reliability.scatter_alone",
       .text = fmt::format("the inputs are drawn {}, and the probabilities do not contain the "
                           "uncertainty of the model's form, which strainwave require takes into "
                           "account",
                           gear.correlation.empty() ? "independently of each other"
                                                    : "with the rank correlations of the file"),
       .path = "scatter",
       .equation = "UQ-4",
       .severity = Severity::information});
  return report;
}

}  // namespace strainwave
