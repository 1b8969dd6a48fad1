// SPDX-License-Identifier: Apache-2.0
#include "strainwave/uncertainty/sampled_probability.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "draws_about.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/uncertainty/failure_centre.hpp"

namespace strainwave {
namespace {

enum class Draw : unsigned char { met, failed, without_value };

constexpr double kNormal95 = 1.959963984540054;

/// @param about  of a draw: what the draw scatters about
template <class About>
std::vector<Draw> draws_at(const std::function<LimitState()>& make, std::size_t inputs,
                           const About& about, const SamplingOptions& options,
                           const Progress& progress) {
  std::vector<Draw> draws(options.draws);
  for_each_index(draws.size(), {.block = 256, .threads = options.threads}, progress, [&] {
    return
        [&draws, &about, margin = make(), z = std::vector<double>(inputs)](std::size_t n) mutable {
          about(n).fill(n, z);
          const std::optional<double> g = margin(z);
          draws[n] = !g ? Draw::without_value : *g < 0 ? Draw::failed : Draw::met;
        };
  });
  return draws;
}

std::vector<Draw> draws_of(const std::function<LimitState()>& make,
                           const std::vector<double>& centre, const SamplingOptions& options,
                           const Progress& progress) {
  const DrawsAbout about(centre, options.seed);
  return draws_at(
      make, centre.size(), [&](std::size_t) -> const DrawsAbout& { return about; }, options,
      progress);
}

}  // namespace

SampledProbability plain_sampling(const std::function<LimitState()>& make, std::size_t inputs,
                                  const SamplingOptions& options, const Progress& progress) {
  const std::vector<double> origin(inputs, 0.0);
  const std::vector<Draw> draws = draws_of(make, origin, options, progress);
  SampledProbability result{.draws = draws.size()};
  const DrawsAbout about(origin, options.seed);
  std::vector<double> z(inputs);
  double nearest = HUGE_VAL;
  for (std::size_t n = 0; n < draws.size(); ++n) {
    if (draws[n] == Draw::without_value) ++result.without_value;
    if (draws[n] != Draw::failed) continue;
    ++result.failures;
    about.fill(n, z);
    if (product(z, z) < nearest) {
      nearest = product(z, z);
      result.nearest_failure = z;
    }
  }
  const auto count = static_cast<double>(draws.size());
  const auto failures = static_cast<double>(result.failures);
  result.probability = failures / count;
  result.standard_error = std::sqrt(result.probability * (1 - result.probability) / count);
  using Binomial = boost::math::binomial;
  constexpr double kOneSide = 0.025;
  result.low = Binomial::find_lower_bound_on_p(count, failures, kOneSide);  // (UQ-6)
  const double most = failures + static_cast<double>(result.without_value);
  result.high = most < count ? Binomial::find_upper_bound_on_p(count, most, kOneSide) : 1.0;
  return result;
}

SampledProbability importance_sampling(const std::function<LimitState()>& make,
                                       const std::vector<double>& centre,
                                       const SamplingOptions& options, const Progress& progress) {
  const std::vector<Draw> draws = draws_of(make, centre, options, progress);
  // If the origin fails, the draws about the centre are those of the requirement being met:
  // failures toward the origin have weights that hardly any draw carries.
  const std::optional<double> at_origin = make()(std::vector<double>(centre.size(), 0.0));
  const Draw rare = at_origin && *at_origin < 0 ? Draw::met : Draw::failed;
  SampledProbability result{.draws = draws.size()};
  const DrawsAbout about(centre, options.seed);
  std::vector<double> z(centre.size());
  double sum = 0.0;
  double squares = 0.0;
  double left_out = 0.0;
  for (std::size_t n = 0; n < draws.size(); ++n) {
    if (draws[n] == Draw::failed) ++result.failures;
    if (draws[n] != rare && draws[n] != Draw::without_value) continue;
    about.fill(n, z);
    const double weight = about.weight(z);  // (UQ-7)
    if (draws[n] == Draw::without_value) {
      ++result.without_value;
      left_out += weight;
      continue;
    }
    sum += weight;
    squares += weight * weight;
  }
  const auto count = static_cast<double>(draws.size());
  const double share = sum / count;
  result.standard_error = std::sqrt(std::max(0.0, squares / count - share * share) / count);
  const double half = kNormal95 * result.standard_error;
  if (rare == Draw::failed) {
    result.probability = share;
    result.low = std::max(0.0, share - half);
    result.high = std::min(1.0, share + half + left_out / count);
  } else {
    result.probability = std::max(0.0, 1 - share - left_out / count);
    result.low = std::max(0.0, result.probability - half);
    result.high = std::min(1.0, 1 - share + half);
  }
  return result;
}

SampledProbability mixture_sampling(const std::function<LimitState()>& make,
                                    const std::vector<std::vector<double>>& centres,
                                    const SamplingOptions& options, const Progress& progress) {
  const std::size_t inputs = centres.front().size();
  // Draw n scatters about the origin or about a centre, in turns.
  const std::vector<double> origin(inputs, 0.0);
  std::vector<DrawsAbout> parts = {DrawsAbout(origin, options.seed)};
  for (const std::vector<double>& centre : centres) parts.emplace_back(centre, options.seed);
  const auto about = [&](std::size_t n) -> const DrawsAbout& { return parts[n % parts.size()]; };
  const std::vector<Draw> draws = draws_at(make, inputs, about, options, progress);
  SampledProbability result{.draws = draws.size()};
  std::vector<double> u(inputs);
  double sum = 0.0;
  double squares = 0.0;
  double left_out = 0.0;
  for (std::size_t n = 0; n < draws.size(); ++n) {
    if (draws[n] == Draw::met) continue;
    about(n).fill(n, u);
    const double weight = mixture_weight(u, centres);  // (UQ-11)
    if (draws[n] == Draw::without_value) {
      ++result.without_value;
      left_out += weight;
      continue;
    }
    ++result.failures;
    sum += weight;
    squares += weight * weight;
  }
  const auto count = static_cast<double>(draws.size());
  result.probability = sum / count;
  // The parts of the draws have less variance than draws from the whole mixture.
  result.standard_error =
      std::sqrt(std::max(0.0, squares / count - result.probability * result.probability) / count);
  const double half = kNormal95 * result.standard_error;
  result.low = std::max(0.0, result.probability - half);
  result.high = std::min(1.0, result.probability + half + left_out / count);
  return result;
}

}  // namespace strainwave
