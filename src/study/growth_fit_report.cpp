// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/growth_fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/quantile.hpp"
#include "strainwave/growth_scatter/predict.hpp"

namespace strainwave {
namespace {

/// Fewer specimens than this say little about how specimens differ.
constexpr std::size_t kFewSpecimens = 10;

std::vector<FittedParameter> parameters_of(const GrowthFit& fit) {
  const std::array<const char*, ScatterParameters::kCount> names = {
      "ln C of a specimen at the pivot",      "m of a specimen, with ln C",
      "m of a specimen, on its own",          "correlated part",
      "ln of its correlation length in ln a", "white part over 1 mm"};
  const auto acting = fit.parts.acting();
  const auto values = fit.parameters.values();
  std::vector<FittedParameter> parameters;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!acting[k]) continue;
    FittedParameter p{.name = names[k], .value = values[k], .error = fit.errors[k]};
    // The length is known if its logarithm is known to a factor of e; the others, if they are not
    // 0.
    p.identified = p.error && (k == 4 ? *p.error < 1 : std::abs(p.value) > 2 * *p.error);
    parameters.push_back(std::move(p));
  }
  return parameters;
}

/// Five sizes spread over the part of the records that all specimens have.
std::vector<double> usual_sizes(const std::vector<GrowthSpecimen>& specimens) {
  double low = 0.0;
  double high = specimens.front().sizes.back();
  for (const GrowthSpecimen& specimen : specimens) {
    low = std::max(low, specimen.sizes.front());
    high = std::min(high, specimen.sizes.back());
  }
  std::vector<double> sizes;
  if (low < high)
    for (int k = 1; k <= 5; ++k) sizes.push_back(k == 5 ? high : std::lerp(low, high, k / 5.0));
  return sizes;
}

/// One question: cycles to each size, without or with the beginning of the own record.
struct Question {
  std::optional<double> known;
  double size;
};

/// The answer for one specimen; absent if its record does not contain the sizes.
struct AnsweredBand {
  SpecimenBand band;
  std::optional<double> unknown_width;  ///< of the same cycles without the record
};

double width_of(std::vector<double> draws, double confidence) {
  const double low = quantile(draws, (1 - confidence) / 2);
  return quantile(draws, (1 + confidence) / 2) - low;
}

std::vector<std::optional<AnsweredBand>> bands_of(const GrowthFit& fit,
                                                  const GrowthSpecimen& specimen,
                                                  const std::vector<Question>& questions,
                                                  double confidence, const GrowthDraws& draws) {
  std::vector<std::optional<AnsweredBand>> answers(questions.size());
  for (std::size_t q = 0; q < questions.size(); ++q) {
    const Question& asked = questions[q];
    const double from = asked.known.value_or(specimen.sizes.front());
    const auto reached = cycles_at(specimen, asked.size);
    const auto begun = cycles_at(specimen, from);
    if (!reached || !begun || !(asked.size > from)) continue;
    std::vector<double> drawn = std::move(
        draw_growth(fit, specimen, asked.known, from, {asked.size}, draws).cycles.front());
    if (drawn.empty()) continue;
    AnsweredBand answer;
    SpecimenBand& band = answer.band;
    band = {.specimen = specimen.name,
            .known = asked.known,
            .size = asked.size,
            .cycles = *reached - *begun};
    const auto fewer = std::ranges::count_if(drawn, [&](double n) { return n < band.cycles; });
    band.transform = (static_cast<double>(fewer) + 0.5) / (static_cast<double>(drawn.size()) + 1);
    band.low = quantile(drawn, (1 - confidence) / 2);
    band.median = quantile(drawn, 0.5);
    band.high = quantile(drawn, (1 + confidence) / 2);
    if (asked.known)
      answer.unknown_width = width_of(
          draw_growth(fit, specimen, std::nullopt, from, {asked.size}, draws).cycles.front(),
          confidence);
    answers[q] = std::move(answer);
  }
  return answers;
}

/// Numbers inside that a right model has with a probability of at least 99 %, half of the rest on
/// each side; (GS-11).
void set_limits(BandCheck& check, double confidence) {
  const boost::math::binomial_distribution<double> inside(check.specimens, confidence);
  constexpr double kTail = 0.005;
  check.fewest = 0;
  while (check.fewest < check.specimens && cdf(inside, check.fewest) <= kTail) ++check.fewest;
  check.most = check.specimens;
  while (check.most > 0 && cdf(complement(inside, check.most - 1)) <= kTail) --check.most;
}

BandCheck check_of(const Question& asked, const std::vector<AnsweredBand>& answers,
                   double confidence) {
  BandCheck check{.known = asked.known, .size = asked.size};
  check.specimens = static_cast<int>(answers.size());
  const auto n = static_cast<double>(answers.size());
  double log_sum = 0.0;
  double log_squares = 0.0;
  double unknown = 0.0;
  std::vector<double> transforms;
  for (const auto& [band, unknown_width] : answers) {
    if (band.low <= band.cycles && band.cycles <= band.high) ++check.inside;
    check.mean_width += (band.high - band.low) / n;
    log_sum += std::log(band.cycles);
    if (unknown_width) unknown += (band.high - band.low) / *unknown_width / n;
    transforms.push_back(band.transform);
  }
  set_limits(check, confidence);
  std::ranges::sort(transforms);
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const auto rank = static_cast<double>(i);
    check.distance =
        std::max({check.distance, transforms[i] - rank / n, (rank + 1) / n - transforms[i]});
  }
  if (asked.known) {
    check.width_over_unknown = unknown;
  } else if (answers.size() > 2) {
    for (const auto& [band, width] : answers)
      log_squares += std::pow(std::log(band.cycles) - log_sum / n, 2);
    const double z = quantile(boost::math::normal(), (1 + confidence) / 2);
    const double spread = z * std::sqrt(log_squares / (n - 1));
    const double width = 2 * std::exp(log_sum / n) * std::sinh(spread);
    if (width > 0) check.width_over_lognormal = check.mean_width / width;
  }
  return check;
}

void add_notes(GrowthFitReport& report, const GrowthFit& fit) {
  const auto specimens = static_cast<std::size_t>(report.specimens);
  if (specimens < kFewSpecimens && fit.parts.level)
    report.notes.push_back(
        {"growth_fit.few_specimens",
         fmt::format("{} specimens hardly tell how specimens differ; maximum likelihood makes the "
                     "difference too small, and the bands too narrow",
                     specimens),
         "", "GS-8", Severity::care, "Test more specimens, at least ten."});
  for (const FittedParameter& p : report.scatter)
    if (!p.identified) {
      report.notes.push_back(
          {"growth_fit.not_identified",
           fmt::format("the records do not determine the parameter \"{}\"", p.name), "", "GS-8",
           Severity::information, "Fit without this part by --parts, and compare the bands."});
      break;
    }
  if (std::ranges::any_of(report.checks, [](const BandCheck& check) {
        return check.inside < check.fewest || check.inside > check.most;
      }))
    report.notes.push_back(
        {"growth_fit.not_calibrated",
         "at some size the number of specimens inside of their bands is one that a right model "
         "would have in less than 1 % of such tests",
         "", "GS-11", Severity::care,
         "Do not use the bands at this size; look at the plot of the transforms."});
}

}  // namespace

GrowthFitReport growth_fit_report(const std::vector<GrowthSpecimen>& specimens,
                                  const GrowthFitRequest& request, const Progress& progress) {
  require(request.confidence > 0 && request.confidence < 1, "confidence", request.confidence, "1",
          "> 0 and < 1");
  progress.at(0.0);
  const GrowthFit fit = fit_growth(specimens, request.fit);
  progress.at(0.2);
  const bool others = !request.judged.empty();
  const std::vector<GrowthSpecimen>& judged = others ? request.judged : specimens;
  if (!others && specimens.size() < 2)
    throw InputError("specimens",
                     "has one record, which no other can judge; give more, or --judge");

  GrowthFitReport report;
  report.specimens = static_cast<int>(specimens.size());
  for (const GrowthSpecimen& s : specimens) report.steps += static_cast<int>(s.steps());
  report.pooled = pooled_line(specimens);
  const std::size_t knots = fit.mean.knots.size();
  for (std::size_t k = 0; k < knots; ++k)
    report.knots.push_back({.delta_K = 1e6 * std::exp(fit.mean.knots[k]),
                            .rate = std::exp(fit.mean.rates[k]),
                            .relative_error = std::sqrt(fit.rate_covariance[k * knots + k])});
  report.scatter = parameters_of(fit);
  for (const KnotTrial& t : fit.trials)
    report.tried.push_back({t.knots, t.log_likelihood, t.criterion});
  report.log_likelihood = fit.log_likelihood;
  report.converged = fit.converged;
  report.reason = fit.reason;
  if (!fit.converged) report.unusable_because = "the fit did not converge: " + fit.reason;
  report.judged_by = others ? JudgedBy::other_specimens : JudgedBy::leave_one_out;
  report.confidence = request.confidence;
  report.equations = {"GS-1", "GS-2", "GS-3", "GS-4",  "GS-5", "GS-6",
                      "GS-7", "GS-8", "GS-9", "GS-10", "GS-11"};

  std::vector<double> sizes = request.sizes.empty() ? usual_sizes(judged) : request.sizes;
  std::vector<Question> questions;
  for (const double size : sizes) questions.push_back({std::nullopt, size});
  for (const double known : request.known)
    for (const double size : sizes)
      if (size > known) questions.push_back({known, size});

  std::size_t steps = 0;
  for (const GrowthSpecimen& s : judged) steps = std::max(steps, s.steps());
  const GrowthDraws draws(static_cast<std::size_t>(request.draws), steps, request.seed);
  std::vector<std::vector<std::optional<AnsweredBand>>> answers(judged.size());
  for_each_index(
      judged.size(), {.block = 1, .threads = request.threads}, progress.part(0.2, 1.0), [&] {
        return [&](std::size_t i) {
          if (others) {
            answers[i] = bands_of(fit, judged[i], questions, request.confidence, draws);
            return;
          }
          std::vector<GrowthSpecimen> rest = specimens;
          rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
          GrowthFitSettings settings = request.fit;
          settings.knots = static_cast<int>(knots);
          settings.start = fit.parameters;
          if (rest.size() < 2) settings.parts.level = settings.parts.slope = false;
          answers[i] =
              bands_of(fit_growth(rest, settings), judged[i], questions, request.confidence, draws);
        };
      });

  double covered = 0.0;
  int without_record = 0;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    std::vector<AnsweredBand> there;
    for (const auto& of_specimen : answers)
      if (of_specimen[q]) there.push_back(*of_specimen[q]);
    if (there.empty())
      throw InputError("sizes",
                       fmt::format("has {:.6g} mm, which no record contains{}; give a size "
                                   "inside of the records",
                                   1e3 * questions[q].size,
                                   questions[q].known ? " together with the known size" : ""));
    report.checks.push_back(check_of(questions[q], there, request.confidence));
    const BandCheck& check = report.checks.back();
    if (!check.known) {
      covered += static_cast<double>(check.inside) / check.specimens;
      ++without_record;
    }
    for (const AnsweredBand& answer : there) report.bands.push_back(answer.band);
  }
  if (without_record > 0) report.coverage = covered / without_record;
  add_notes(report, fit);
  return report;
}

}  // namespace strainwave
