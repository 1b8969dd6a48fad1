// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/growth_fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>

#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/quantile.hpp"
#include "strainwave/core/shown_text.hpp"
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

/// Cycles to several sizes, without or with the beginning of the own record.
struct Question {
  std::optional<double> known;
  std::vector<double> sizes;
};

/// The answer for one specimen and size.
struct AnsweredBand {
  SpecimenBand band;
  std::optional<double> unknown_width;  ///< of the same cycles without the record
};
/// Answers of one specimen by question and size; absent where its record does not contain the
/// sizes.
using SpecimenAnswers = std::vector<std::vector<std::optional<AnsweredBand>>>;

double width_of(std::vector<double> draws, double confidence) {
  const double low = quantile(draws, (1 - confidence) / 2);
  return quantile(draws, (1 + confidence) / 2) - low;
}

AnsweredBand band_of(const std::string& specimen, const Question& asked, double size, double cycles,
                     std::vector<double> drawn, double confidence) {
  AnsweredBand answer;
  SpecimenBand& band = answer.band;
  band = {.specimen = specimen, .known = asked.known, .size = size, .cycles = cycles};
  const auto fewer = std::ranges::count_if(drawn, [&](double n) { return n < cycles; });
  band.transform = (static_cast<double>(fewer) + 0.5) / (static_cast<double>(drawn.size()) + 1);
  band.low = quantile(drawn, (1 - confidence) / 2);
  band.median = quantile(drawn, 0.5);
  band.high = quantile(drawn, (1 + confidence) / 2);
  return answer;
}

SpecimenAnswers bands_of(const GrowthFit& fit, const GrowthSpecimen& specimen,
                         const std::vector<Question>& questions, double confidence,
                         const GrowthDraws& draws) {
  SpecimenAnswers answers;
  for (const Question& asked : questions) {
    auto& of_question = answers.emplace_back(asked.sizes.size());
    const double from = asked.known.value_or(specimen.sizes.front());
    const auto begun = cycles_at(specimen, from);
    if (!begun || !(from < specimen.sizes.back())) continue;
    const auto drawn = draw_growth(fit, specimen, asked.known, from, asked.sizes, draws);
    const auto unknown =
        asked.known ? draw_growth(fit, specimen, std::nullopt, from, asked.sizes, draws) : drawn;
    for (std::size_t s = 0; s < asked.sizes.size(); ++s) {
      if (drawn[s].empty() || !(asked.sizes[s] > from)) continue;
      of_question[s] = band_of(specimen.name, asked, asked.sizes[s],
                               *cycles_at(specimen, asked.sizes[s]) - *begun, drawn[s], confidence);
      if (asked.known) of_question[s]->unknown_width = width_of(unknown[s], confidence);
    }
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

BandCheck check_of(const std::optional<double>& known, double size,
                   const std::vector<AnsweredBand>& answers, double confidence) {
  BandCheck check{.known = known, .size = size};
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
  if (known) {
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

/// The fit to all specimens but one.  Nothing of the one enters but the start of the search.
GrowthFit fit_without(const std::vector<GrowthSpecimen>& specimens, std::size_t one,
                      GrowthFitSettings settings, const GrowthFit& to_all) {
  std::vector<GrowthSpecimen> rest = specimens;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(one));
  settings.start = to_all.parameters;
  try {
    return fit_growth(rest, settings);
  } catch (const InputError& fault) {
    throw InputError(fault.field(), fmt::format("has no fit without {}, which the others have to "
                                                "predict ({}); give more records, or --judge",
                                                specimens[one].name, fault.what()));
  }
}

/// What the records are, and what they do not say.
GrowthFitBasis basis_of(const std::vector<GrowthSpecimen>& specimens, const GrowthFit& fit,
                        const GrowthFitRequest& request) {
  GrowthFitBasis basis{.stress_ratio = request.stress_ratio,
                       .from = std::numeric_limits<double>::infinity(),
                       .pivot = 1e6 * std::exp(fit.mean.pivot)};
  if (!request.test)
    basis.test = "ranges of K as the records give them";
  else if (request.test->width)
    basis.test = fmt::format("plate of {} width with a crack in its middle, range of the stress {}",
                             shown_quantity(*request.test->width, "m", 6),
                             shown_quantity(request.test->stress_range, "Pa", 6));
  else
    basis.test = fmt::format("wide plate with a crack in its middle, range of the stress {}",
                             shown_quantity(request.test->stress_range, "Pa", 6));
  double logarithms = 0.0;
  double steps = 0.0;
  for (const GrowthSpecimen& specimen : specimens)
    for (std::size_t i = 0; i < specimen.steps(); ++i) {
      basis.from = std::min(basis.from, specimen.ranges[i]);
      basis.to = std::max(basis.to, specimen.ranges[i]);
      logarithms += std::log(specimen.sizes[i + 1] - specimen.sizes[i]);
      steps += 1;
    }
  basis.step = std::exp(logarithms / steps);  // (GS-14)
  return basis;
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
  const GrowthFit fit = fit_growth(specimens, request.fit, progress.part(0.0, 0.1));
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
  report.parts = fit.parts;
  report.parameters = fit.parameters;
  report.basis = basis_of(specimens, fit, request);
  for (const KnotTrial& t : fit.trials)
    report.tried.push_back({t.knots, t.log_likelihood, t.criterion});
  report.log_likelihood = fit.log_likelihood;
  report.converged = fit.converged;
  report.reason = fit.reason;
  if (!fit.converged) report.unusable_because = "the fit did not converge: " + fit.reason;
  report.judged_by = others ? JudgedBy::other_specimens : JudgedBy::leave_one_out;
  report.confidence = request.confidence;
  report.equations = {"GS-1", "GS-2", "GS-3", "GS-4",  "GS-5",  "GS-6",
                      "GS-7", "GS-8", "GS-9", "GS-10", "GS-11", "GS-14"};

  const std::vector<double> sizes = request.sizes.empty() ? usual_sizes(judged) : request.sizes;
  std::vector<Question> questions = {{std::nullopt, sizes}};
  for (const double known : request.known) {
    Question& question = questions.emplace_back(Question{known, {}});
    for (const double size : sizes)
      if (size > known) question.sizes.push_back(size);
    if (question.sizes.empty())
      throw InputError("known",
                       fmt::format("has {:.6g} mm, and no predicted size is larger; give a "
                                   "smaller one, or a larger --size",
                                   1e3 * known));
  }

  std::size_t steps = 0;
  for (const GrowthSpecimen& s : judged) steps = std::max(steps, s.steps());
  const GrowthDraws draws(static_cast<std::size_t>(request.draws), steps, request.seed);
  std::vector<SpecimenAnswers> answers(judged.size());
  std::vector<std::string> not_converged(judged.size());
  for_each_index(judged.size(), {.block = 1, .threads = request.threads}, progress.part(0.1, 1.0),
                 [&] {
                   return [&](std::size_t i) {
                     if (others) {
                       answers[i] = bands_of(fit, judged[i], questions, request.confidence, draws);
                       return;
                     }
                     const GrowthFit rest = fit_without(specimens, i, request.fit, fit);
                     if (!rest.converged) not_converged[i] = judged[i].name;
                     answers[i] = bands_of(rest, judged[i], questions, request.confidence, draws);
                   };
                 });
  for (const std::string& name : not_converged)
    if (!name.empty() && report.unusable_because.empty())
      report.unusable_because = fmt::format("the fit without {} did not converge", name);

  double covered = 0.0;
  int without_record = 0;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    const Question& asked = questions[q];
    for (std::size_t k = 0; k < asked.sizes.size(); ++k) {
      std::vector<AnsweredBand> there;
      for (const SpecimenAnswers& of_specimen : answers)
        if (of_specimen[q][k]) there.push_back(*of_specimen[q][k]);
      if (there.empty())
        throw InputError(
            "size",
            fmt::format("has {:.6g} mm, which no record contains{}; give a size inside of "
                        "the records",
                        1e3 * asked.sizes[k], asked.known ? " together with the known size" : ""));
      report.checks.push_back(check_of(asked.known, asked.sizes[k], there, request.confidence));
      const BandCheck& check = report.checks.back();
      if (!check.known) {
        covered += static_cast<double>(check.inside) / check.specimens;
        ++without_record;
      }
      for (const AnsweredBand& answer : there) report.bands.push_back(answer.band);
    }
  }
  if (without_record > 0) report.coverage = covered / without_record;
  add_notes(report, fit);
  return report;
}

}  // namespace strainwave
