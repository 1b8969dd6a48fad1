// SPDX-License-Identifier: Apache-2.0
#include "strainwave/uncertainty/failure_centre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "draws_about.hpp"
#include "strainwave/core/parallel.hpp"

namespace strainwave {
namespace {

using Place = std::vector<double>;

constexpr double kElite = 0.1;  // of the draws of a round
constexpr int kMostRounds = 20;
constexpr std::size_t kMostCentres = 4;
/// Failures so much further away than those of the first centre hardly add to the probability.
constexpr double kFurtherAway = 1.5;
/// A search among more covered draws only approaches the region of a centre that is known.
constexpr double kMostCovered = 1.0 / 3;

/// Whether a draw is nearer to a centre than to the origin.
bool covered(std::span<const double> u, const Place& centre) {
  return product(u, centre) > product(centre, centre) / 2;
}

/// Weighted mean of some draws (UQ-10).
Place mean_of(const DrawsAbout& round, std::span<const std::size_t> draws, std::size_t inputs) {
  Place sum(inputs, 0.0);
  double total = 0.0;
  for (const std::size_t n : draws) {
    const Place u = round.at(n);
    const double w = round.weight(u);
    total += w;
    for (std::size_t i = 0; i < u.size(); ++i) sum[i] += w * u[i];
  }
  for (double& value : sum) value /= total;
  return sum;
}

/// The searches for one centre after another.
class Search {
 public:
  Search(const std::function<LimitState()>& make, std::size_t inputs,
         const SamplingOptions& options, const Progress& progress)
      : make_(make), inputs_(inputs), options_(options), progress_(progress) {}

  FailureCentres centres() {
    double farthest = kFarthestFailure;
    while (found_.places.size() < kMostCentres) {
      std::optional<Place> place = next(farthest);
      if (!place) break;
      if (found_.places.empty())
        farthest = std::min(farthest, std::sqrt(product(*place, *place)) + kFurtherAway);
      found_.places.push_back(std::move(*place));
    }
    for (const Place& u : failures_)
      found_.heaviest = std::max(found_.heaviest, mixture_weight(u, found_.places));
    return std::move(found_);
  }

 private:
  /// The centre of the failures that no other centre covers; nothing, with the reason for the first
  /// one, if there are none.
  std::optional<Place> next(double farthest) {
    const auto give_up = [&](const char* reason) {
      if (found_.places.empty()) found_.reason = reason;
      return std::nullopt;
    };
    Place centre(inputs_, 0.0);
    bool among_failures = false;
    double level = std::numeric_limits<double>::infinity();
    for (int n = 0; n < kMostRounds; ++n) {
      const DrawsAbout round(centre,
                             splitmix64(options_.seed, static_cast<std::uint64_t>(found_.rounds)));
      const std::vector<double> margins = margins_of(round);
      std::vector<std::size_t> order;
      for (std::size_t i = 0; i < margins.size(); ++i)
        if (margins[i] < std::numeric_limits<double>::infinity()) order.push_back(i);
      if (order.empty()) return give_up("no drawn drive has an end of its life");
      std::ranges::stable_sort(order, {}, [&](std::size_t i) { return margins[i]; });
      const auto failures = static_cast<std::size_t>(
          std::ranges::count_if(order, [&](std::size_t i) { return margins[i] < 0; }));
      const std::size_t elite = std::min(order.size(), elite_of(margins.size()));
      const bool enough = failures >= elite_of(margins.size());
      if (among_failures || enough)
        for (std::size_t i = 0; i < failures; ++i) failures_.push_back(round.at(order[i]));
      centre = mean_of(round, std::span(order).first(enough ? failures : elite), inputs_);
      if (product(centre, centre) > farthest * farthest)
        return give_up("no failure is nearer than 8 standard deviations of the inputs");
      if (enough && std::exchange(among_failures, true)) return centre;
      const double reached = margins[order[elite - 1]];
      const bool aside =
          static_cast<double>(covered_) > kMostCovered * static_cast<double>(margins.size());
      if (!found_.places.empty() && !enough && (aside || reached >= level)) return std::nullopt;
      level = std::min(level, reached);
    }
    return give_up("20 rounds of draws do not reach the failures");
  }

  [[nodiscard]] static std::size_t elite_of(std::size_t draws) {
    return static_cast<std::size_t>(std::ceil(kElite * static_cast<double>(draws)));
  }
  /// Margins of the draws of a round; infinite for draws without a value and for covered ones.
  std::vector<double> margins_of(const DrawsAbout& round) {
    constexpr double kRounds = static_cast<double>(kMostCentres) * kMostRounds;
    std::vector<double> margins(options_.draws, std::numeric_limits<double>::infinity());
    std::vector<unsigned char> is_covered(options_.draws, 0);
    const Progress part = progress_.part(found_.rounds / kRounds, (found_.rounds + 1) / kRounds);
    ++found_.rounds;
    for_each_index(margins.size(), {.block = 4, .threads = options_.threads}, part, [&] {
      return [&, margin = make_()](std::size_t n) {
        const Place u = round.at(n);
        is_covered[n] =
            std::ranges::any_of(found_.places, [&](const Place& c) { return covered(u, c); });
        if (is_covered[n] != 0) return;
        if (const std::optional<double> value = margin(u)) margins[n] = *value;
      };
    });
    covered_ = std::ranges::count(is_covered, 1);
    return margins;
  }

  const std::function<LimitState()>& make_;
  std::size_t inputs_;
  const SamplingOptions& options_;
  const Progress& progress_;
  FailureCentres found_;
  std::ptrdiff_t covered_ = 0;   ///< draws of the last round that a known centre covers
  std::vector<Place> failures_;  ///< draws that fail, of the last rounds of each search
};

}  // namespace

FailureCentres find_failure_centres(const std::function<LimitState()>& make, std::size_t inputs,
                                    const SamplingOptions& options, const Progress& progress) {
  return Search(make, inputs, options, progress).centres();
}

double mixture_weight(std::span<const double> u, std::span<const std::vector<double>> centres) {
  double sum = 1.0;
  for (const Place& centre : centres)
    sum += std::exp(product(u, centre) - product(centre, centre) / 2);
  return (static_cast<double>(centres.size()) + 1) / sum;  // (UQ-11)
}

}  // namespace strainwave
