// SPDX-License-Identifier: Apache-2.0
#include "inspection_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "strainwave/core/shown_text.hpp"

namespace strainwave {
namespace {

/// Number of cracks of a part that grow.
std::ptrdiff_t growing_cracks(const DrawnPart& part) {
  return std::ranges::count_if(
      part.sizes, [](const std::vector<double>& size) { return size.back() > size.front(); });
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

/// What a measurement can find, in words; it ends with a full stop.
std::string measurement_words(const MethodOfInspection& method) {
  const std::string_view what = method.method == InspectionMeans::stiffness
                                    ? "the stiffness of the drive"
                                : method.method == InspectionMeans::resonance
                                    ? "the natural frequency of the drive"
                                    : "the difference of the stiffness between the senses";
  std::string words = fmt::format(
      "{} changes {} by {} at its last size before the failure, {}; nine of ten measurements find "
      "a change of {}",
      method.crack, what, percent(*method.change_at_end),
      shown_quantity(*method.size_at_end, "m", 4), percent(*method.change_ninety));
  if (method.a90)
    return words +
           fmt::format(", which the crack reaches at {}.", shown_quantity(*method.a90, "m", 4));
  return words + fmt::format(
                     ". The crack does not reach this change before the failure, so it {} in time: "
                     "one measurement just before the failure finds it in {} of the cases.",
                     *method.found_at_end < 0.5 ? "cannot be found so" : "is not surely found so",
                     percent(*method.found_at_end));
}

std::string risk_words(double probability, double low, double high) {
  return fmt::format("{:.3g} (95 % limits {:.2g} to {:.2g})", probability, low, high);
}

}  // namespace

std::string hours_text(double seconds) { return fmt::format("{:.4g} h", seconds / 3600); }

void add_inspection_notes(InspectionReport& report, const InspectionCase& of) {
  const int total = static_cast<int>(of.parts.size());
  report.sentence = fmt::format(
      "Up to {} the probability of failure is {}", hours_text(report.until),
      risk_words(report.at_end.without, report.at_end.without_low, report.at_end.without_high));
  if (report.at_end.inspected)
    report.sentence +=
        fmt::format(" without inspections, and {} with {}",
                    risk_words(*report.at_end.inspected, *report.at_end.inspected_low,
                               *report.at_end.inspected_high),
                    of.inspections == 1 ? std::string("one inspection")
                                        : fmt::format("{} inspections", of.inspections));
  report.sentence += ".";
  if (report.method && report.method->change_at_end) {
    report.sentence += " The crack " + measurement_words(*report.method);
    if (report.method->method != InspectionMeans::resonance)
      report.notes.push_back(
          {.code = "inspection.series",
           .text = "the change of the stiffness is that of the members in series; the contacts of "
                   "the teeth and other parts make the change of the whole drive smaller",
           .path = "inspection.method",
           .equation = "IR-10",
           .severity = Severity::care,
           .next_step = "Compare with the coupled drive, strainwave torsion --compare."});
    const bool several =
        of.inspections > 1 ||
        std::ranges::any_of(report.plans, [](const auto& plan) { return plan.inspections > 1; });
    if (several && report.method->method != InspectionMeans::one_sided_stiffness)
      report.notes.push_back(
          {.code = "inspection.record",
           .text = "the error of the first record of a drive is the same in all of its "
                   "inspections, and it is left out; the risk is then too low",
           .path = "inspection.noise",
           .equation = "IR-11",
           .severity = Severity::care,
           .next_step = "Take the mean of many measurements as the first record."});
    if (!report.method->a90)
      report.notes.push_back(
          {.code = "inspection.not_found",
           .text = measurement_words(*report.method),
           .path = report.method->crack,
           .equation = "IR-11",
           .severity = Severity::care,
           .next_step = "Look for the crack itself, or measure with less noise."});
  }
  if (report.bound_risk)
    report.sentence += fmt::format(
        " With the lower 95 % bound of detection at each size, it is {:.3g}.", *report.bound_risk);
  if (report.method && report.method->trials && !report.method->a90_bound)
    report.notes.push_back(
        {.code = "inspection.trials",
         .text = fmt::format("{} trials do not bound the size a90 with 95 % confidence",
                             *report.method->trials),
         .path = "detection-data",
         .equation = report.method->bound_equation,
         .severity = Severity::care,
         .next_step = "Try more cracks, over a wider range of sizes."});
  if (of.search != nullptr && of.search->repaired_to) {
    const auto several = std::ranges::count_if(
        of.parts, [](const DrawnPart& part) { return growing_cracks(part) > 1; });
    if (several > 0)
      report.notes.push_back(
          {.code = "inspection.other_cracks",
           .text = fmt::format(
               "in {} of {} draws several cracks grow, and the path of each is known up to the "
               "first failure only; after a repair a drive counts as failed when another crack "
               "reaches this age, so the risk may be too high",
               several, of.parts.size()),
           .path = "inspection.repaired_to",
           .equation = "IR-9",
           .severity = Severity::information});
    const auto larger = std::ranges::count_if(of.parts, [&](const DrawnPart& part) {
      for (std::size_t k = 0; k < part.sizes.size(); ++k)
        if (of.search->seen[k] && part.sizes[k].front() > *of.search->repaired_to) return true;
      return false;
    });
    if (larger > 0)
      report.notes.push_back(
          {.code = "inspection.first_size",
           .text = fmt::format("in {} of {} draws a crack is larger than {} at first, and its path "
                               "from there on is not known; a repair reduces it to its first size",
                               larger, of.parts.size(),
                               shown_quantity(*of.search->repaired_to, "m", 4)),
           .path = "inspection.repaired_to",
           .equation = "IR-9",
           .severity = Severity::information});
  }
  if (report.outcomes.arrested > 0)
    report.notes.push_back(
        {.code = "inspection.arrested",
         .text = fmt::format("in {} of {} draws no crack grows any more; their life has no end and "
                             "is in no mean",
                             report.outcomes.arrested, total),
         .path = "duty",
         .equation = "IR-7",
         .severity = Severity::information});
  if (report.outcomes.out_of_range > 0)
    report.notes.push_back(
        {.code = "inspection.range",
         .text =
             fmt::format("in {} of {} draws a crack leaves the range of its solution, where the "
                         "rest is not known; this counts as a failure at that time",
                         report.outcomes.out_of_range, total),
         .path = of.governing,
         .equation = "IR-3",
         .severity = Severity::care});
  if (report.outcomes.refused > 0)
    report.notes.push_back(
        {.code = "inspection.refused",
         .text = fmt::format(
             "{} of {} draws break a rule of the input, or have no answer, and are left out",
             report.outcomes.refused, of.options.draws),
         .path = "scatter",
         .equation = "IR-3",
         .severity = Severity::care,
         .next_step = "Narrow the scatter, or use a distribution without such values."});
  const bool weighted = report.importance_sampling.has_value();
  const double wanted = of.options.times.risk.value_or(0.0);
  const bool resolved = of.options.times.risk
                            ? std::ranges::all_of(report.plans,
                                                  [&](const PlannedInspections& plan) {
                                                    return plan.reached && plan.risk_high <= wanted;
                                                  })
                            : report.at_end.without_low > 0;
  if (!resolved)
    report.notes.push_back(
        {.code = "inspection.draws",
         .text =
             of.options.times.risk
                 ? "the upper limit of the risk of a plan is above the wanted risk, or the plan "
                   "does not reach it, so the plan is not proven"
                 : "no drawn drive fails, so only the upper limit of the risk is known",
         .path = "",
         .equation = weighted ? "IR-16" : "IR-4",
         .severity = Severity::cannot_tell,
         .next_step =
             !of.options.times.risk
                 ? std::string(weighted ? "Ask for more --draws."
                                        : "Give --importance-sampling, or ask for more --draws.")
             : weighted
                 ? std::string("Plan for a smaller --risk, whose upper limit is below the wanted "
                               "one, or ask for more --draws.")
                 : fmt::format("Plan for a smaller --risk, whose upper limit is below the wanted "
                               "one, with --importance-sampling or more than {} draws; the plan at "
                               "times of least risk needs twice as many.",
                               std::max(static_cast<std::int64_t>(std::ceil(3.69 / wanted)),
                                        static_cast<std::int64_t>(of.options.draws)))});
  if (weighted)
    report.notes.push_back(
        {.code = "inspection.importance",
         .text = fmt::format(
             "{} of the draws scatter about failures that a search found.  Failures far from these "
             "may be missing: with 97.5 % confidence, the {} other draws exclude only that such "
             "failures have a probability above {:.2g}",
             of.parts.size() - static_cast<std::size_t>(report.importance_sampling->plain_draws),
             report.importance_sampling->plain_draws, report.importance_sampling->elsewhere),
         .path = "scatter",
         .equation = "IR-16",
         .severity = Severity::care,
         .next_step = "Ask for more --draws if failures may have several causes."});
}

}  // namespace strainwave
