// SPDX-License-Identifier: Apache-2.0
#include "strainwave/uncertainty/failure_centre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/parallel.hpp"

namespace strainwave {
namespace {

constexpr double kElite = 0.1;  // of the draws of a round
constexpr int kMostRounds = 20;

double product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// The draws of one round about a place.
class Round {
 public:
  Round(const std::vector<double>& centre, std::uint64_t seed) : centre_(centre), seed_(seed) {}

  [[nodiscard]] std::vector<double> at(std::size_t n) const {
    std::vector<double> u = centre_;
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += counter_normal(seed_, n, i);
    return u;
  }
  [[nodiscard]] double weight(std::span<const double> u) const {
    return std::exp(product(centre_, centre_) / 2 - product(u, centre_));
  }
  /// Weighted mean of some of the draws (UQ-10).
  [[nodiscard]] std::vector<double> mean(std::span<const std::size_t> draws) const {
    std::vector<double> sum(centre_.size(), 0.0);
    double total = 0.0;
    for (const std::size_t n : draws) {
      const std::vector<double> u = at(n);
      const double w = weight(u);
      total += w;
      for (std::size_t i = 0; i < u.size(); ++i) sum[i] += w * u[i];
    }
    for (double& value : sum) value /= total;
    return sum;
  }

 private:
  const std::vector<double>& centre_;
  std::uint64_t seed_;
};

}  // namespace

FailureCentre find_failure_centre(const std::function<LimitState()>& make, std::size_t inputs,
                                  const SamplingOptions& options, const Progress& progress) {
  FailureCentre found;
  std::vector<double> centre(inputs, 0.0);
  const auto give_up = [&](std::string reason) {
    found.reason = std::move(reason);
    return found;
  };
  bool among_failures = false;
  while (found.rounds < kMostRounds) {
    const Round round(centre, splitmix64(options.seed, static_cast<std::uint64_t>(found.rounds)));
    ++found.rounds;
    std::vector<std::optional<double>> margins(options.draws);
    for_each_index(margins.size(), {.block = 4, .threads = options.threads}, progress, [&] {
      return
          [&margins, &round, margin = make()](std::size_t n) { margins[n] = margin(round.at(n)); };
    });
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < margins.size(); ++n)
      if (margins[n] && *margins[n] < std::numeric_limits<double>::infinity()) order.push_back(n);
    const auto elite =
        static_cast<std::size_t>(std::ceil(kElite * static_cast<double>(margins.size())));
    if (order.size() < elite) return give_up("fewer than a tenth of the drawn drives have an end");
    std::ranges::stable_sort(order, {}, [&](std::size_t n) { return *margins[n]; });
    const auto failures = static_cast<std::size_t>(
        std::ranges::count_if(order, [&](std::size_t n) { return *margins[n] < 0; }));
    const bool enough = failures >= elite;
    centre = round.mean(std::span(order).first(enough ? failures : elite));
    if (product(centre, centre) > kFarthestFailure * kFarthestFailure)
      return give_up("no failure is nearer than 8 standard deviations of the inputs");
    if (enough && std::exchange(among_failures, true)) {  // the second round among failures
      found.found = true;
      found.place = std::move(centre);
      return found;
    }
  }
  return give_up("20 rounds of draws do not reach the failures");
}

double mixture_weight(std::span<const double> u, std::span<const double> centre) {
  return 2 / (1 + std::exp(product(u, centre) - product(centre, centre) / 2));  // (UQ-11)
}

}  // namespace strainwave
